//! One try: points out, points in.

use super::super::Refinement;
use super::super::look_ahead::Demand;
use super::super::quality::Trigger;
use super::Thinner;
use crate::predicates::{self, Relative};
use crate::triangulation::{Edge, Triangle};

/// How many of a point's neighbours may go out with it.
const MOST_NEIGHBORS: u64 = 3;
/// How many random places in the circumdisc of a bad triangle are tried, besides look-ahead's.
const RANDOM_PLACES: usize = 30;
/// How many of all these are looked at closely.
const PLACES: usize = 10;
/// The same where there is a soft target: more of them make a bad triangle.
const PLACES_FOR_TARGET: usize = 24;

/// A triangle that was made.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    slot: u32,
    vertices: [u32; 3],
    trigger: Option<Trigger>,
}

/// A place for a point, and how many bad triangles there would be after its commit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    point: [f64; 2],
    bad: usize,
}

/// The circumdisc of a triangle, rounded.
#[derive(Debug, Clone, Copy)]
pub(super) struct Disc {
    center: [f64; 2],
    squared: f64,
}

impl Disc {
    fn around([p, a, b]: [[f64; 2]; 3]) -> Self {
        let (a, b) = (Relative::of(a, p), Relative::of(b, p));
        let twice = 2.0 * a.cross(b);
        let x = (a.squared * b.y - b.squared * a.y) / twice;
        let y = (b.squared * a.x - a.squared * b.x) / twice;
        Self { center: [p[0] + x, p[1] + y], squared: x * x + y * y }
    }

    fn holds(&self, point: [f64; 2]) -> bool {
        Relative::of(self.center, point).squared < self.squared
    }
}

impl Refinement<'_> {
    /// Takes `vertex`, of which `slot` is a triangle, and some of its neighbours out and puts as
    /// many points in at most. Answers how many there are less; `None` leaves the mesh half-done,
    /// to be taken back.
    pub(super) fn attempt(&mut self, vertex: u32, slot: u32, thinner: &mut Thinner) -> Option<u64> {
        thinner.out.clear();
        thinner.made.clear();
        thinner.bad.clear();
        thinner.missed.clear();
        self.take_out_with_neighbors(vertex, slot, thinner)?;
        self.judge_made(thinner)?;
        let mut left = thinner.out.len();
        while let Some(worst) = self.worst(thinner) {
            if left == 0 {
                return None;
            }
            self.put_in(worst, left == 1, thinner)?;
            left -= 1;
        }
        let stays = |found: &Found| self.is_there(found);
        (!thinner.missed.iter().any(stays)).then_some(left as u64)
    }

    /// Takes a point out, and a random number of the Steiner points around it.
    fn take_out_with_neighbors(
        &mut self,
        vertex: u32,
        slot: u32,
        thinner: &mut Thinner,
    ) -> Option<()> {
        let mut more = thinner.random.below(MOST_NEIGHBORS + 1);
        self.take_out(vertex, slot, thinner)?;
        let mut around: Vec<u32> = thinner.star.neighbors().collect();
        around.retain(|&v| self.provenances.is_steiner_point(v));
        while more > 0 && !around.is_empty() {
            let next = around.swap_remove(thinner.random.below(around.len() as u64) as usize);
            let has_next =
                |&&slot: &&u32| self.mesh.triangles[slot as usize].vertices.contains(&next);
            let slot = *thinner.made.iter().rev().find(has_next)?;
            self.take_out(next, slot, thinner)?;
            more -= 1;
        }
        Some(())
    }

    pub(super) fn take_out(&mut self, vertex: u32, slot: u32, thinner: &mut Thinner) -> Option<()> {
        thinner.star.of(&self.mesh, vertex, slot)?;
        if thinner.touches_frozen(thinner.star.slots()) {
            return None;
        }
        thinner.journal.note_removal(&self.mesh, &thinner.star);
        self.mesh.remove(&mut thinner.star);
        thinner.made.extend_from_slice(thinner.star.slots());
        thinner.out.push(vertex);
        Some(())
    }

    /// Finds the bad ones among the triangles that took the place of points. `None` where one
    /// encroaches a subsegment: that is left to the refinement.
    fn judge_made(&mut self, thinner: &mut Thinner) -> Option<()> {
        thinner.made.sort_unstable();
        thinner.made.dedup();
        for i in 0..thinner.made.len() {
            let slot = thinner.made[i];
            let triangle = self.mesh.triangles[slot as usize];
            if triangle == Triangle::VACANT {
                continue;
            }
            let encroaches = |i: usize| {
                triangle.neighbors[i].is_constrained()
                    && self.is_encroached_by_apex(Edge::new(slot, i))
            };
            if (0..3).any(encroaches) {
                return None;
            }
            self.judge(slot, thinner);
        }
        Some(())
    }

    fn is_encroached_by_apex(&self, edge: Edge) -> bool {
        let apex = self.mesh.points[self.mesh.apex(edge) as usize];
        let ends = self.mesh.ends(edge).map(|v| self.mesh.points[v as usize]);
        predicates::encroaches(ends.map(|end| Relative::of(end, apex)), ends, apex)
    }

    /// Notes a triangle that is bad, or misses the soft target.
    fn judge(&self, slot: u32, thinner: &mut Thinner) {
        let vertices = self.mesh.triangles[slot as usize].vertices;
        let trigger = self.trigger(slot);
        let found = Found { slot, vertices, trigger };
        if trigger.is_some() {
            thinner.bad.push(found);
        } else if self.parameters.soft_angle.is_some() && self.small_angle(slot).is_some() {
            thinner.missed.push(found);
        }
    }

    fn is_there(&self, found: &Found) -> bool {
        self.mesh.triangles[found.slot as usize].vertices == found.vertices
    }

    /// The bad triangle with the shortest trigger edge. Forgets those that are gone.
    fn worst(&self, thinner: &mut Thinner) -> Option<Found> {
        thinner.bad.retain(|found| self.is_there(found));
        let length =
            |found: &&Found| found.trigger.map_or(f64::INFINITY, |trigger| trigger.squared);
        thinner.bad.iter().min_by(|a, b| length(a).total_cmp(&length(b))).copied()
    }

    /// Commits the best Steiner point of a bad triangle: if it is the `last` one, one that leaves
    /// no bad triangle.
    fn put_in(&mut self, worst: Found, last: bool, thinner: &mut Thinner) -> Option<()> {
        let demand = self.demand(worst.slot, worst.trigger?);
        let best = self.best(&demand, last, thinner)?;
        if self.cavity.point != best.point {
            self.cavity.of_steiner_point(&self.mesh, best.point, worst.slot).ok()?;
        }
        thinner.journal.note_commit(&self.mesh, &self.cavity);
        self.mesh.commit(&mut self.cavity);
        self.provenances.push_steiner_point();
        self.size_new_vertex();
        for i in 0..self.cavity.boundary.len() {
            if self.may_be_bad(i) {
                self.judge(self.cavity.star[i], thinner);
            }
        }
        Some(())
    }

    /// The place that leaves the fewest bad triangles, if any keeps the rule.
    ///
    /// A point removes only triangles whose circumdiscs hold it: so places are looked at in the
    /// order of how many those are, and no more of them than can be better than the best so far.
    fn best(&mut self, demand: &Demand, last: bool, thinner: &mut Thinner) -> Option<Candidate> {
        self.find_places(demand, last, thinner);
        let places = std::mem::take(&mut thinner.places);
        let most = if self.parameters.soft_angle.is_some() { PLACES_FOR_TARGET } else { PLACES };
        let in_order = (0..=thinner.bad.len())
            .flat_map(|least| places.iter().filter(move |place| place.bad == least));
        let mut best: Option<Candidate> = None;
        for &Candidate { point, bad: least } in in_order.take(most) {
            if best.is_some_and(|best| best.bad <= least) {
                break;
            }
            if !self.may_stand(point, demand) || thinner.touches_frozen(&self.cavity.star) {
                continue;
            }
            let bad = self.bad_after(thinner);
            if (bad == 0 || !last) && best.is_none_or(|best| bad < best.bad) {
                best = Some(Candidate { point, bad });
            }
        }
        thinner.places = places;
        best
    }

    /// Places for a point, each with how many bad triangles it leaves at least.
    fn find_places(&self, demand: &Demand, last: bool, thinner: &mut Thinner) {
        let Thinner { bad, discs, corners, places, random, .. } = thinner;
        discs.clear();
        discs.extend(bad.iter().map(|found| Disc::around(self.mesh.corners(found.slot))));
        let mut vertices: Vec<u32> = bad.iter().flat_map(|found| found.vertices).collect();
        vertices.sort_unstable();
        vertices.dedup();
        corners.clear();
        corners.extend(vertices.into_iter().map(|v| self.mesh.points[v as usize]));
        places.clear();
        let drawn = (0..RANDOM_PLACES).map(|_| demand.in_circumdisc(random.in_disc()));
        for place in demand.places().chain(drawn) {
            let point = self.precision.round(place);
            let left = if last {
                usize::from(discs.iter().any(|disc| !disc.holds(point)))
            } else {
                discs.iter().map(|disc| usize::from(!disc.holds(point))).sum()
            };
            let is_near =
                |corner: &[f64; 2]| Relative::of(*corner, point).squared < demand.nearest();
            let does_enough = left == 0 || !last;
            if does_enough && !corners.iter().any(is_near) {
                places.push(Candidate { point, bad: left });
            }
        }
    }

    /// How many bad triangles there would be after the commit of the cavity's point. (Rounded: it
    /// only chooses.)
    fn bad_after(&self, thinner: &Thinner) -> usize {
        let made = (0..self.cavity.boundary.len()).filter(|&i| self.may_be_bad(i)).count();
        let stays = |found: &&Found| !self.cavity.star.contains(&found.slot);
        made + thinner.bad.iter().filter(stays).count()
    }
}
