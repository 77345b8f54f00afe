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
pub mod trace;

use std::collections::{BTreeSet, VecDeque};
use std::ops::ControlFlow;

use crate::constructions::Angle;
use crate::corners::{next, previous};
use crate::domain::Domain;
use crate::parameters::{MinAngle, Parameters, Rule, Splitting, Steiner};
use crate::predicates::Relative;
use crate::triangulation::{Cavity, Triangulation};
use counters::Counters;
use incremental::{Introduced, Introduction};
use provenance::Provenances;
use quality::{Look, Trigger};
use queue::{Entry, Order, Queue};
use segments::Segments;
use sizes::Sizes;
use sizing::Sizing;
use steiner::Placement;
use survey::Survey;
use thin::Tried;
use trace::{Cause, Listener, Proposer, Refusal};

/// Bad triangles are taken tile by tile, this many triangles in the order of their slots: a tile
/// stays in the cache.
const TILE: usize = 10_000;
/// Up to this many bad triangles one tile holds all: the order is the global one.
const ONE_TILE: usize = 20_000;
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
}

impl Precision {
    /// The precision of a domain.
    #[must_use]
    pub fn of(domain: &Domain) -> Self {
        let quantum = libm::scalbn(1.0, -1074 - domain.scale_exponent);
        Self { ulp: domain.ulp, floor: domain.floor(), quantum }
    }

    /// A new point as the output can hold it.
    fn round(self, point: [f64; 2]) -> [f64; 2] {
        // From 2^52 steps on every double is a multiple.
        let fine = self.quantum * (1_u64 << 52) as f64;
        let [x, y] = point;
        if x.abs() >= fine && y.abs() >= fine {
            return point;
        }
        let coarse = |c: f64| c.abs() < fine;
        point.map(
            |c| if coarse(c) { (c / self.quantum).round_ties_even() * self.quantum } else { c },
        )
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
    refinement.queue = Queue::default(); // for its memory
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
            is_plain: !worst_first && parameters.soft_angle.is_none() && !parameters.incremental,
            order: if worst_first { Order::SmallestAngle } else { Order::ShortestEdge },
            queue: Queue::default(),
            pending: VecDeque::new(),
            cavity: Cavity::default(),
            survey: Survey::default(),
            introduced,
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
        for tile in self.tiles() {
            for slot in tile {
                let corners = self.mesh.corners(slot);
                let seen = [1, 2].map(|i| Relative::of(corners[i], corners[0]));
                self.queue_at_a_glance(slot, seen);
            }
            self.improve_all(&mut watch)?;
        }
        ControlFlow::Continue(())
    }

    /// (Quality′) until no bad triangle waits.
    fn improve_all(&mut self, watch: &mut Watch) -> Flow {
        while let Some(entry) = self.queue.pop() {
            self.improve(entry, watch)?;
        }
        ControlFlow::Continue(())
    }

    /// Ranges of slots whose bad triangles are taken together. The slots that are made on the way
    /// queue themselves.
    fn tiles(&self) -> Vec<std::ops::Range<u32>> {
        let all = self.mesh.triangles.len() as u32;
        let bad = (0..all).filter(|&slot| self.trigger(slot).is_some());
        if bad.take(ONE_TILE + 1).count() <= ONE_TILE {
            return std::iter::once(0..all).collect();
        }
        let starts = (0..all).step_by(TILE);
        starts.map(|start| start..all.min(start + TILE as u32)).collect()
    }

    fn queue_if_bad(&mut self, slot: u32) {
        if let Some(trigger) = self.trigger(slot) {
            let vertices = self.mesh.triangles[slot as usize].vertices;
            let entry = Entry { slot, newest: vertices[0] };
            if !self.introduced.as_mut().is_some_and(|those| those.lets_wait(entry, vertices)) {
                self.queue.push(self.order.bucket(trigger), entry);
            }
        }
    }

    /// Why a triangle is bad, if it is: an angle below κ̂, or below the soft target where that may
    /// be attacked, that is not excused; or its size.
    fn trigger(&self, slot: u32) -> Option<Trigger> {
        if self.mesh.is_outside_the_region(slot) {
            return None;
        }
        let corners = self.mesh.corners(slot);
        let allowed = |found: &Trigger| {
            self.parameters.soft_angle.is_none()
                || found.angle.is_below(self.parameters.min_angle)
                || soft::may_attack(self.domain, corners, *found)
                || self.may_be_improved_for_its_size(slot)
        };
        self.small_angle(slot).filter(allowed).or_else(|| {
            let region = self.mesh.regions.get(slot as usize).copied().unwrap_or(0);
            let too_large =
                self.sizing.is_too_large(corners, region) || self.is_larger_than_its_size(slot);
            too_large.then(|| quality::by_size(corners))
        })
    }

    /// The smallest angle of a triangle that is below what is asked for and not excused. A glance
    /// mostly tells which one that is.
    fn small_angle(&self, slot: u32) -> Option<Trigger> {
        let corners = self.mesh.corners(slot);
        let [a, b] = [1, 2].map(|i| Relative::of(corners[i], corners[0]));
        match quality::look(a, b, self.target()) {
            Look::Fine => None,
            Look::Small { edge, is_clear: true, .. } if !self.may_excuse(slot, edge) => {
                Some(Trigger::opposite(corners, edge))
            }
            _ => {
                let vertices = self.mesh.triangles[slot as usize].vertices;
                let excused = |edge: usize, angle| self.is_excused(vertices, edge, angle);
                quality::trigger(corners, self.target(), excused)
            }
        }
    }

    /// The features in the order in which they were introduced; empty unless one by one.
    #[must_use]
    pub fn introductions(&self) -> &[Introduction] {
        self.introduced.as_ref().map_or(&[], |introduced| &introduced.order)
    }

    /// The angle asked for: the soft target, or κ̂ where there is none.
    fn target(&self) -> MinAngle {
        self.parameters.soft_angle.unwrap_or(self.parameters.min_angle)
    }

    /// The triangles with an angle below the soft target that is not excused, by their slots, with
    /// the angle; none without a soft target.
    pub fn missed(&self) -> impl Iterator<Item = (u32, Angle)> + '_ {
        let soft = self.parameters.soft_angle.map(|_| 0..self.mesh.triangles.len() as u32);
        soft.into_iter()
            .flatten()
            .filter_map(|slot| self.small_angle(slot).map(|found| (slot, found.angle)))
    }

    /// Whether the `angle` opposite an edge is left alone, because the edge lies across a small
    /// input angle.
    fn is_excused(&self, vertices: [u32; 3], edge: usize, angle: Angle) -> bool {
        if self.parameters.rule != Rule::Adaptive {
            return false;
        }
        let segment_point = |i: usize| self.provenances.segment_point(vertices[i]).copied();
        let (Some(a), Some(b)) = (segment_point(next(edge)), segment_point(previous(edge))) else {
            return false;
        };
        if a.segment == b.segment {
            return false;
        }
        self.segments.shared_end(a.segment, b.segment).is_some_and(|shared| {
            let theta = self.segments.angle(a.segment, b.segment, shared, &self.mesh.points);
            let across = excuse::Across { points: [a, b], shared, theta };
            across.excuses(self.parameters.excuse, angle)
        })
    }

    /// (Quality′): commits the Steiner point of a bad triangle, or splits what it would encroach.
    fn improve(&mut self, entry: Entry, watch: &mut Watch) -> Flow {
        self.counters.popped += 1;
        if !self.is_still_there(entry) {
            self.counters.stale += 1;
            return ControlFlow::Continue(());
        }
        let Some(trigger) = self.trigger(entry.slot) else {
            return ControlFlow::Continue(());
        };
        self.leave_room()?;
        let corners = self.mesh.corners(entry.slot);
        let ahead = match self.parameters.steiner {
            Steiner::LookAhead => self.look_ahead(entry, trigger),
            _ => None,
        };
        let vertices = self.mesh.triangles[entry.slot as usize].vertices;
        let usual = || {
            self.precision.round(match self.size_over_edge(vertices, trigger) {
                Some(size) => steiner::at_size(corners, trigger, size),
                None => self.placement.point(corners, trigger),
            })
        };
        let point = ahead.unwrap_or_else(usual);
        let proposer = Proposer { vertices, trigger, point };
        if ahead.is_none()
            && let Err(rejected) = self.cavity.of_steiner_point(&self.mesh, point, entry.slot)
        {
            self.refuse(entry, proposer, rejected.into());
            return ControlFlow::Continue(());
        }
        if self.introduced.is_some() && self.calls_segments(proposer, watch)? {
            if self.is_still_there(entry) {
                self.queue_if_bad(entry.slot);
            }
            return ControlFlow::Continue(());
        }
        let encroached: Vec<[u32; 2]> =
            self.cavity.encroached(&self.mesh).map(|side| side.ends).collect();
        if !encroached.is_empty() {
            self.tell_rejected(proposer, &encroached);
            return self.split_instead(entry, proposer, encroached, watch);
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
            self.queue_if_bad(entry.slot);
        }
        ControlFlow::Continue(())
    }

    /// Whether the triangle that was queued is still in its slot.
    fn is_still_there(&self, entry: Entry) -> bool {
        self.mesh.triangles[entry.slot as usize].vertices[0] == entry.newest
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

    /// Queues the bad ones of the triangles that were just made.
    fn queue_bad_of_star(&mut self) {
        for i in 0..self.cavity.size() {
            self.queue_at_a_glance(self.cavity.star[i], self.cavity.seen(i));
        }
    }

    /// Queues a triangle if it is bad, its corners 1 and 2 as seen from corner 0: measured exactly only
    /// where a glance does not tell.
    #[inline]
    fn queue_at_a_glance(&mut self, slot: u32, [a, b]: [Relative; 2]) {
        let look = quality::look(a, b, self.target());
        if (look == Look::Fine && !self.is_sized) || self.mesh.is_outside_the_region(slot) {
            return;
        }
        let region = self.mesh.regions.get(slot as usize).copied().unwrap_or(0);
        let may_be_too_large =
            || self.sizing.may_be_too_large(a, b, region) || self.sizes.is_some();
        let squared = match look {
            Look::Fine if self.sizing.is_surely_too_large(a, b, region) => {
                quality::squared_edges(a, b).into_iter().reduce(f64::min)
            }
            Look::Fine if !may_be_too_large() => return,
            Look::Small { edge, squared, .. } => {
                Some(squared).filter(|_| !self.may_excuse(slot, edge))
            }
            _ => None,
        };
        match squared.filter(|_| self.is_plain) {
            Some(squared) => {
                let newest = self.mesh.triangles[slot as usize].vertices[0];
                self.queue.push(queue::by_length(squared), Entry { slot, newest });
            }
            None => self.queue_if_bad(slot),
        }
    }

    /// Whether an edge may lie across a small input angle: both its ends split segments.
    fn may_excuse(&self, slot: u32, edge: usize) -> bool {
        let vertices = self.mesh.triangles[slot as usize].vertices;
        let splits = |i: usize| self.provenances.splits_segment(vertices[i]);
        splits(next(edge)) && splits(previous(edge))
    }

    /// A quick look at the triangle that a point makes with an edge of its cavity's boundary: whether
    /// it may be bad.
    fn may_be_bad(&self, [a, b]: [Relative; 2], region: u32) -> bool {
        quality::may_be_small(a, b, self.target())
            || self.sizing.may_be_too_large(a, b, region)
            || self.sizes.is_some()
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
            waiting: self.queue.len(),
            thinning: None,
        };
        match (watch.tell)(progress) {
            ControlFlow::Continue(()) => ControlFlow::Continue(()),
            ControlFlow::Break(()) => ControlFlow::Break(End::Cancelled),
        }
    }
}
