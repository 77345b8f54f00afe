//! The Adaptive Delaunay Refinement Algorithm (Miller, Pav & Walkington, *When and Why Delaunay
//! Refinement Algorithms Work*), statement by statement.
//!
//! | statement | where |
//! |---|---|
//! | (Conformality), §3 | [`conformality`] |
//! | (Quality′), §3 | [`quality`], [`excuse`] |
//! | splitting on concentric shells, §10 | [`shells`] |
//! | Algorithm 1 (§9) | `augment` |
//! | splitting on dyadic ladders (ours) | [`ladder`] |
//! | points, midpoints, circumcenters, §3 | [`provenance`] |
//! | Steiner points, §3 and ours | [`steiner`], `look_ahead` |
//! | any further trigger (ours) | [`sizing`], [`local_areas`], [`sizes`], `division`, [`soft`] |
//! | features one by one, §3 | [`incremental`] |
//! | the Terminator, for comparison (§1) | [`terminator`] |
//! | fewer points afterwards (ours) | [`thin`](mod@thin) |
//! | what is done, step by step | [`trace`] |
//!
//! [`refine`] is the loop; [`Refinement`] is everything that it changes.

mod augment;
mod bad;
pub mod conformality;
pub mod counters;
mod division;
pub mod excuse;
pub mod incremental;
pub mod interpolation;
pub mod ladder;
pub mod local_areas;
mod look_ahead;
pub mod piece;
mod places;
pub mod provenance;
pub mod quality;
pub mod queue;
pub mod segments;
pub mod shells;
pub mod sizes;
pub mod sizing;
pub mod soft;
mod stall;
pub mod steiner;
mod survey;
pub mod terminator;
pub mod thin;
mod tiles;
pub mod trace;

use std::collections::{BTreeSet, VecDeque};
use std::ops::ControlFlow;

use crate::domain::Domain;
use crate::parameters::{MinAngle, Parameters, Rule, Splitting, Steiner};
use crate::triangulation::{Cavity, Triangulation};
use counters::Counters;
use incremental::{Introduced, Introduction};
use provenance::Provenances;
use queue::{Entry, Order, Queue};
use segments::Segments;
use sizes::Sizes;
use sizing::Sizing;
use steiner::Placement;
use survey::Survey;
use thin::Tried;
use tiles::Tiles;
use trace::{Cause, Listener, Proposer, Refusal};

/// Progress is told after this many points.
const PROGRESS_STEP: usize = 1 << 13;

/// Everything that the refinement changes.
#[derive(Debug)]
pub struct Refinement<'a> {
    /// The triangulation.
    pub mesh: Triangulation,
    /// How its points came to be.
    pub provenances: Provenances,
    /// The segments of the domain.
    pub segments: Segments<'a>,
    /// What was refused where doubles end.
    pub refused: Refused,
    /// What was done, counted.
    pub counters: Counters,
    /// Who hears each step.
    pub listener: Listener<'a>,
    domain: &'a Domain,
    parameters: &'a Parameters,
    sizing: Sizing,
    sizes: Option<Sizes>,
    precision: Precision,
    placement: Placement,
    order: Order,
    /// The angle asked for: the soft target, or κ̂ where there is none.
    target: MinAngle,
    /// Whether every angle below κ̂ that is not excused is bad, and the shortest edge comes first.
    is_plain: bool,
    /// Whether any triangle may be bad for its size.
    is_sized: bool,
    queue: Queue,
    pending: VecDeque<([u32; 2], Cause)>,
    cavity: Cavity,
    survey: Survey,
    /// With [`Parameters::incremental`]: what the mesh may know of so far.
    introduced: Option<Introduced>,
    tiles: Tiles,
}

/// Where doubles end (ALGORITHM §§2, 9).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Precision {
    /// ulp(M), M the largest coordinate in magnitude.
    pub ulp: f64,
    /// φ = 2^12·ulp(M): no split makes a shorter piece, no Steiner point is nearer to a vertex.
    pub floor: f64,
    /// The step between subnormal numbers of the output, in the domain's scale: new coordinates
    /// are multiples of it, so that what is tested is what is written.
    pub quantum: f64,
    /// 2^52 steps: from here on every double is a multiple. (Kept, for the step itself is most often
    /// subnormal, and a product with such a number takes as long as fifty others.)
    fine: f64,
}

impl Precision {
    /// The precision of a domain.
    #[must_use]
    pub fn of(domain: &Domain) -> Self {
        let quantum = libm::scalbn(1.0, -1074 - domain.scale_exponent);
        let fine = libm::scalbn(quantum, 52);
        Self { ulp: domain.ulp, floor: domain.floor(), quantum, fine }
    }

    /// A new point as the output can hold it.
    fn round(self, point: [f64; 2]) -> [f64; 2] {
        let is_fine = |c: f64| c.abs() >= self.fine;
        let [x, y] = point;
        if is_fine(x) && is_fine(y) {
            return point;
        }
        let round = |c: f64| (c / self.quantum).round_ties_even() * self.quantum;
        point.map(|c| if is_fine(c) { c } else { round(c) })
    }
}

/// What was refused at the precision floor.
#[derive(Debug, Clone, Default)]
pub struct Refused {
    /// Subsegments that are not split (smaller vertex first): a refused one stays refused.
    pub subsegments: BTreeSet<[u32; 2]>,
    /// Bad triangles whose Steiner point was refused.
    pub triangles: Vec<Entry>,
}

/// How far a run has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Points so far.
    pub points: usize,
    /// Triangles so far.
    pub triangles: usize,
    /// Bad triangles that wait, some of them gone already.
    pub waiting: usize,
    /// While a finished mesh is thinned: how far that has come.
    pub thinning: Option<Tried>,
}

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// Nothing is left to do.
    Finished,
    /// It reached [`Parameters::max_points`].
    PointBudget,
    /// The progress callback asked for it.
    Cancelled,
}

/// Refines until no subsegment is encroached and every bad triangle is gone, excused or at the
/// precision floor; or until the budget or the caller stops it. The triangulation is a complete
/// one at any time.
pub fn refine(
    refinement: &mut Refinement,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> End {
    let ended = refinement.run(progress);
    (refinement.queue, refinement.tiles) = (Queue::default(), Tiles::default()); // for their memory
    match ended {
        ControlFlow::Continue(()) => End::Finished,
        ControlFlow::Break(end) => end,
    }
}

/// Goes on, or ends early.
type Flow = ControlFlow<End>;

/// Who listens to the progress, and when it is told next.
struct Watch<'a> {
    tell: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    next: usize,
}

impl<'a> Refinement<'a> {
    /// A refinement of `mesh` that has not begun.
    #[must_use]
    pub fn new(
        mesh: Triangulation,
        segments: Segments<'a>,
        sizing: Sizing,
        sizes: Option<Sizes>,
        domain: &'a Domain,
        parameters: &'a Parameters,
    ) -> Self {
        let worst_first =
            parameters.steiner == Steiner::Circumcenter || parameters.rule != Rule::Adaptive;
        let introduced = parameters.incremental.then(|| Introduced::none_of(domain, &mesh.points));
        Self {
            provenances: Provenances::of_inputs(domain.input_points.len(), mesh.points.len()),
            mesh,
            segments,
            is_sized: sizing.has_bounds() || sizes.is_some(),
            refused: Refused::default(),
            counters: Counters::default(),
            listener: Listener::default(),
            domain,
            parameters,
            sizing,
            sizes,
            precision: Precision::of(domain),
            placement: Placement::new(parameters),
            target: parameters.soft_angle.unwrap_or(parameters.min_angle),
            is_plain: !worst_first && parameters.soft_angle.is_none() && !parameters.incremental,
            order: if worst_first { Order::SmallestAngle } else { Order::ShortestEdge },
            queue: Queue::default(),
            pending: VecDeque::new(),
            cavity: Cavity::default(),
            survey: Survey::default(),
            introduced,
            tiles: Tiles::default(),
        }
    }

    /// The loop of §3: conformality first, always; then quality, tile by tile.
    fn run(&mut self, tell: &mut dyn FnMut(Progress) -> ControlFlow<()>) -> Flow {
        let mut watch = Watch { tell, next: 0 };
        self.tell_start();
        if self.parameters.incremental {
            return self.introduce_one_by_one(&mut watch);
        }
        if self.parameters.splitting == Splitting::Augment {
            self.augment()?;
        }
        self.divide_by_sizes(&mut watch)?;
        for tile in self.slots_by_tiles() {
            tile.for_each(|slot| self.queue_if_bad(slot));
            self.improve_all(&mut watch)?;
        }
        ControlFlow::Continue(())
    }

    /// The features in the order in which they were introduced; empty unless one by one.
    #[must_use]
    pub fn introductions(&self) -> &[Introduction] {
        self.introduced.as_ref().map_or(&[], |introduced| &introduced.order)
    }

    /// (Quality′): commits the Steiner point of a bad triangle, or splits what it would encroach.
    fn improve(&mut self, entry: Entry, watch: &mut Watch) -> Flow {
        self.counters.popped += 1;
        if !self.is_still_there(entry) {
            self.counters.stale += 1;
            return ControlFlow::Continue(());
        }
        let Some(trigger) = self.trigger_of(entry) else {
            return ControlFlow::Continue(());
        };
        self.leave_room()?;
        let corners = self.mesh.corners(entry.slot());
        let ahead = match self.parameters.steiner {
            Steiner::LookAhead => self.look_ahead(entry, trigger),
            _ => None,
        };
        let vertices = self.mesh.triangles[entry.slot() as usize].vertices;
        let usual = || {
            self.precision.round(match self.size_over_edge(vertices, trigger) {
                Some(size) => steiner::at_size(corners, trigger, size),
                None => self.placement.point(corners, trigger),
            })
        };
        let point = ahead.unwrap_or_else(usual);
        let proposer = Proposer { vertices, trigger, point };
        if ahead.is_none()
            && let Err(rejected) = self.cavity.of_steiner_point(&self.mesh, point, entry.slot())
        {
            self.refuse(entry, proposer, rejected.into());
            return ControlFlow::Continue(());
        }
        if self.introduced.is_some() && self.calls_segments(proposer, watch)? {
            if self.is_still_there(entry) {
                self.queue_if_bad(entry.slot());
            }
            return ControlFlow::Continue(());
        }
        if self.cavity.is_constrained() {
            let encroached: Vec<[u32; 2]> =
                self.cavity.encroached(&self.mesh).map(|side| side.ends).collect();
            if !encroached.is_empty() {
                self.tell_rejected(proposer, &encroached);
                return self.split_instead(entry, proposer, encroached, watch);
            }
        }
        match self.commit_steiner_point() {
            Ok(()) => self.tell_commit(proposer),
            Err(refusal) => self.refuse(entry, proposer, refusal),
        }
        ControlFlow::Continue(())
    }

    /// Splits all that a rejected Steiner point would encroach, restores conformality, and queues
    /// the bad triangle again if it is still there.
    fn split_instead(
        &mut self,
        entry: Entry,
        proposer: Proposer,
        mut encroached: Vec<[u32; 2]>,
        watch: &mut Watch,
    ) -> Flow {
        if self.parameters.rule == Rule::Terminator {
            let shortest = proposer.trigger.squared.sqrt();
            encroached.retain(|&ends| self.terminator_splits(ends, shortest));
            if encroached.is_empty() {
                return ControlFlow::Continue(());
            }
        }
        let mut split = false;
        for ends in encroached {
            self.leave_room()?;
            split |= self.split(ends, Cause::Rejected(proposer.vertices));
        }
        self.restore_conformality(watch)?;
        if !split {
            self.refuse(entry, proposer, Refusal::AllSplitsRefused);
        } else if self.is_still_there(entry) {
            self.queue_if_bad(entry.slot());
        }
        ControlFlow::Continue(())
    }

    /// Whether the triangle that was queued is still in its slot.
    fn is_still_there(&self, entry: Entry) -> bool {
        self.mesh.has(entry.slot(), entry.newest)
    }

    /// The distance of a vertex on a segment from the segment's first end, rounded.
    pub(crate) fn distance_along(&self, segment: u32, vertex: u32) -> f64 {
        let ends = self.segments.ends[segment as usize];
        match self.provenances.segment_point(vertex) {
            Some(point) if point.apex == 0 => point.distance,
            found => {
                let [a, b] = ends.map(|v| self.mesh.points[v as usize]);
                let (length, _) = crate::constructions::segment_length(a, b);
                match found {
                    Some(point) => length - point.distance,
                    None if vertex == ends[0] => 0.0,
                    None => length,
                }
            }
        }
    }

    /// Leaves a bad triangle as it is.
    fn refuse(&mut self, entry: Entry, proposer: Proposer, refusal: Refusal) {
        self.refused.triangles.push(entry);
        self.tell_refused_point(proposer, refusal);
    }

    fn commit_steiner_point(&mut self) -> Result<(), Refusal> {
        let floor = self.precision.floor;
        if self.cavity.nearest_squared() < floor * floor {
            return Err(Refusal::Floor);
        }
        self.cavity.expect_visible(&self.mesh)?;
        self.commit();
        self.provenances.push_steiner_point();
        self.size_new_vertex();
        self.queue_bad_of_star();
        Ok(())
    }

    /// Puts the point of the cavity in.
    fn commit(&mut self) {
        self.counters.committed += 1;
        self.counters.replaced += self.cavity.star.len();
        self.mesh.commit(&mut self.cavity);
    }

    /// Ends the run where the next point would be one too many.
    fn leave_room(&self) -> Flow {
        if self.mesh.points.len() < self.parameters.max_points {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(End::PointBudget)
        }
    }

    fn tell_progress(&self, watch: &mut Watch) -> Flow {
        if self.mesh.points.len() < watch.next {
            return ControlFlow::Continue(());
        }
        watch.next = self.mesh.points.len() + PROGRESS_STEP;
        let progress = Progress {
            points: self.mesh.points.len(),
            triangles: self.mesh.triangles.len(),
            waiting: self.queue.len() + self.tiles.waiting(),
            thinning: None,
        };
        match (watch.tell)(progress) {
            ControlFlow::Continue(()) => ControlFlow::Continue(()),
            ControlFlow::Break(()) => ControlFlow::Break(End::Cancelled),
        }
    }
}
