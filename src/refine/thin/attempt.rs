//! One try: points out, points in.

use super::super::Refinement;
use super::super::look_ahead::Demand;
use super::super::places::Spread;
use super::super::quality::Trigger;
use super::super::survey::{Look, Prospect};
use super::Thinner;
use crate::parameters::MinAngle;
use crate::predicates::{self, Relative};
use crate::triangulation::{Edge, Triangle};

/// How many of a point's neighbours may go out with it.
const MOST_NEIGHBORS: u64 = 2;
/// How many places are drawn for a point.
///
/// Choice (points of Superior, boxed, 100 000 random ones after 20 000, 20 000 and 300 000 tries, and
/// tries per second in the last): with 24 places and up to 2 neighbours 729, 1 001, 178 728, 195 000; with
/// 32 and 3 729, 994, 176 779, 148 000; with 28 anywhere in the circumdisc, 36 in rows and 3 neighbours
/// 734, 1 009, 179 326, 124 000.
const DRAWN: usize = 24;
/// Where these are.
const SPREAD: Spread = Spread { sideways: 1.1, upwards: 0.9 };
/// The same where there is a soft target: fewer places are good for it.
const SPREAD_WITH_TARGET: Spread = Spread { sideways: 0.8, upwards: 0.6 };
/// How many places are surveyed at least, if they are not to remove all bad triangles.
const LEAST_PLACES: u32 = 12;

/// A triangle that was made.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    slot: u32,
    vertices: [u32; 3],
    trigger: Option<Trigger>,
}

/// What thinning looks at: the bad triangles that it knows of, and what it must not touch.
struct Thinning<'r, 'a> {
    refinement: &'r Refinement<'a>,
    thinner: &'r Thinner,
    region: u32,
    most_made: u32,
}

impl Look for Thinning<'_, '_> {
    fn must_stay(&self, slot: u32) -> bool {
        self.thinner.touches_frozen(&[slot])
    }

    fn is_bad(&self, slot: u32) -> bool {
        self.thinner.bad.iter().any(|found| found.slot == slot)
    }

    fn target(&self) -> MinAngle {
        self.refinement.target
    }

    fn may_be_too_large(&self) -> Option<impl Fn([Relative; 2]) -> bool> {
        // (What the sizes of points say shows after the commit: only then the new one's is known.)
        let sizing = &self.refinement.sizing;
        let may_be = |[a, b]: [Relative; 2]| sizing.may_be_too_large(a.cross(b), self.region);
        sizing.has_bounds().then_some(may_be)
    }

    fn most_made(&self) -> u32 {
        self.most_made
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

    /// Commits the Steiner point of a bad triangle that leaves the fewest bad ones: if it is the `last`
    /// one, one that leaves none.
    fn put_in(&mut self, worst: Found, last: bool, thinner: &mut Thinner) -> Option<()> {
        let demand = self.demand(worst.slot, worst.trigger?);
        self.survey(&demand, last, thinner);
        let bad = thinner.bad.len() as u32;
        let left = |would: Prospect| {
            let left = (bad + would.made).saturating_sub(would.removed);
            (left == 0 || !last).then_some(left)
        };
        self.best_that_may_stand(&mut thinner.survey, &demand, left)?;
        thinner.journal.note_commit(&self.mesh, &self.cavity);
        self.mesh.commit(&mut self.cavity);
        self.provenances.push_steiner_point();
        self.size_new_vertex();
        for (i, side) in self.cavity.sides().enumerate() {
            if self.may_be_bad(side.seen, self.cavity.region(i)) {
                self.judge(self.cavity.star[i], thinner);
            }
        }
        Some(())
    }

    /// Surveys random places for a point.
    ///
    /// A point removes only triangles whose circumdiscs hold it: so only places are surveyed that may
    /// remove the most bad ones.
    fn survey(&self, demand: &Demand, last: bool, thinner: &mut Thinner) {
        let mut survey = std::mem::take(&mut thinner.survey);
        let mut random = thinner.random.clone();
        let spread = if demand.has_target() { SPREAD_WITH_TARGET } else { SPREAD };
        let nearest = demand.relative_nearest();
        let drawn = (0..DRAWN).map(|_| demand.at(spread.place(random.in_square(), nearest)));
        let bad = thinner.bad.iter().map(|found| found.slot);
        survey.begin(&self.mesh, (demand.slot, demand.nearest), drawn);
        survey.keep_in_most_discs(&self.mesh, bad, (!last).then_some(LEAST_PLACES));
        let region = self.mesh.region(demand.slot);
        let most_made = if last { 0 } else { u32::MAX };
        survey.look_around(&self.mesh, &Thinning { refinement: self, thinner, region, most_made });
        thinner.survey = survey;
        thinner.random = random;
    }
}
