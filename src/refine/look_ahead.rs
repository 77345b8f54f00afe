//! Looking ahead: of several Steiner points the one after which the fewest triangles are bad
//! (ALGORITHM §5).
//!
//! Whatever is chosen keeps the general rule behind off-centers: strictly inside the circumcircle of
//! the bad triangle, in the domain and not behind a segment, encroaching nothing, and at least
//! √2·|ab| from every vertex, ab the trigger edge. So termination and every promise stay.

use std::sync::LazyLock;

use super::places::{Place, Spread};
use super::quality::Trigger;
use super::queue::Entry;
use super::survey::{Look, Prospect, Survey};
use super::{Refinement, soft};
use crate::constructions::beside_bisector;
use crate::corners::{next, previous};
use crate::parameters::MinAngle;
use crate::predicates::Relative;

/// How high the off-center stands over the trigger edge, in its lengths: there the new triangle's angle
/// is a little above κ̂.
const OFF_CENTER: f64 = 2.02;
/// How many places are tried beside the off-center and the circumcenter.
const EVENLY: u32 = 46;
/// Where these are.
///
/// Choice (points of Superior, boxed, `baltic_like`, 20 000 random segments, 100 000 random points): with
/// these 778, 1 093, 4 665, 208 639, 184 601; with 30 of them 800, 1 101, 4 729, 211 578, 186 991; with
/// four rows of nine, up to one edge to the side, 800, 1 112, 4 751, 211 835, 190 757. More than 46 take
/// more time than they are worth (60: 0.3 % fewer points in another tenth).
static PLACES: LazyLock<Vec<Place>> =
    LazyLock::new(|| Spread { sideways: 1.1, upwards: 0.7 }.evenly(EVENLY));
/// The same where there is a soft target.
///
/// Choice (points of Superior, boxed, `baltic_like` for 33°, and for 34°): with these 1 014, 1 614, 8 280,
/// and 1 063, 1 714, 9 425; with 60 as without a target 993, 1 635, 8 375, but 1 078, 1 771, 10 490.
static PLACES_WITH_TARGET: LazyLock<Vec<Place>> =
    LazyLock::new(|| Spread { sideways: 0.6, upwards: 0.3 }.evenly(EVENLY));
/// For an angle that only misses the soft target: rows, their heights in the circumcenter's. (Of the last
/// one only the middle is tried: more do not fit into a survey.)
static SOFT_PLACES: LazyLock<Vec<Place>> = LazyLock::new(|| {
    let heights = [1.0, 0.7, 0.85, 1.15, 1.3, 1.5, 1.7, 1.9].into_iter();
    let shifts = [0.0, -0.25, 0.25, -0.5, 0.5, -0.75, 0.75, -1.0, 1.0];
    heights.flat_map(|height| shifts.map(|shift| [height, shift])).collect()
});
/// How near to a vertex, in circumradii, a point for a soft target may be.
const SOFT_DISTANCE: f64 = 0.75;

/// What a trigger asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Aim {
    /// κ̂.
    Promise,
    /// κ̂, in a mesh that is to reach a soft target too.
    PromiseOnTheWay,
    /// The soft target.
    Target,
}

/// The places to try for a trigger whose circumcenter is at this height.
fn places(circumcenter: f64, aim: Aim) -> impl Iterator<Item = Place> {
    let (places, unit): (&[Place], f64) = match aim {
        Aim::Promise => (&PLACES, 1.0),
        Aim::PromiseOnTheWay => (&PLACES_WITH_TARGET, 1.0),
        Aim::Target => (&SOFT_PLACES, circumcenter),
    };
    let usual = (aim != Aim::Target).then_some([[OFF_CENTER, 0.0], [circumcenter, 0.0]]);
    let others = places.iter().map(move |&[height, shift]| [unit * height, shift]);
    usual.into_iter().flatten().chain(others)
}

/// What a candidate would do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Outlook {
    /// Whether any triangle of its star is bad.
    makes_bad: bool,
    /// Bad triangles made less those removed.
    balance: i64,
}

impl Outlook {
    fn of(Prospect { made, removed }: Prospect) -> Self {
        Self { makes_bad: made > 0, balance: i64::from(made) - i64::from(removed) }
    }
}

/// What a Steiner point for the sake of a bad triangle must keep.
#[derive(Debug, Clone, Copy)]
pub(super) struct Demand {
    /// The triangle.
    pub slot: u32,
    /// The ends of its trigger edge.
    ends: [[f64; 2]; 2],
    /// How high its circumcenter stands over that, in the edge's lengths.
    circumcenter: f64,
    radius: f64,
    aim: Aim,
    /// The least squared distance from every vertex.
    pub nearest: f64,
}

impl Demand {
    /// Where a place over the trigger edge is.
    pub fn at(&self, [height, shift]: Place) -> [f64; 2] {
        let [a, b] = self.ends;
        beside_bisector(a, b, height, shift)
    }

    /// The least distance from every vertex, squared, in lengths of the trigger edge.
    pub fn relative_nearest(&self) -> f64 {
        let [a, b] = self.ends;
        self.nearest / Relative::of(a, b).squared
    }

    /// Whether it is in a mesh that is to reach a soft target.
    pub fn has_target(&self) -> bool {
        self.aim != Aim::Promise
    }

    /// The places that look-ahead tries.
    fn places(&self) -> impl Iterator<Item = [f64; 2]> {
        places(self.circumcenter, self.aim).map(|place| self.at(place))
    }
}

impl Refinement<'_> {
    /// The best candidate for a bad triangle's Steiner point, if any keeps the rule; its cavity is
    /// found on the way.
    pub(super) fn look_ahead(&mut self, entry: Entry, trigger: Trigger) -> Option<[f64; 2]> {
        if trigger.only_size {
            return None;
        }
        let demand = self.demand(entry.slot(), trigger);
        let mut survey = std::mem::take(&mut self.survey);
        survey.begin(&self.mesh, (demand.slot, demand.nearest), demand.places());
        survey.look_around(&self.mesh, &Ahead(self));
        let cost = |prospect| Some(Outlook::of(prospect));
        let best = self.best_that_may_stand(&mut survey, &demand, cost);
        self.survey = survey;
        best
    }

    /// The place of a survey with the least cost that keeps the rule, exactly; its cavity is found on
    /// the way.
    pub(super) fn best_that_may_stand<C: Ord>(
        &mut self,
        survey: &mut Survey,
        demand: &Demand,
        cost: impl Fn(Prospect) -> Option<C>,
    ) -> Option<[f64; 2]> {
        while let Some(i) = survey.best(&cost) {
            let point = self.precision.round(survey.place(i));
            if self.may_stand(point, demand) {
                return Some(point);
            }
            survey.forbid(i);
        }
        None
    }

    /// What the Steiner point of a bad triangle must keep.
    pub(super) fn demand(&self, slot: u32, trigger: Trigger) -> Demand {
        let corners = self.mesh.corners(slot);
        let is_soft = !trigger.only_size && !trigger.angle.is_below(self.parameters.min_angle);
        let aim = match self.parameters.soft_angle {
            _ if is_soft => Aim::Target,
            Some(_) => Aim::PromiseOnTheWay,
            None => Aim::Promise,
        };
        let radius = 0.5 * trigger.squared.sqrt() / trigger.angle.sine();
        let nearest = if is_soft {
            SOFT_DISTANCE * SOFT_DISTANCE * radius * radius
        } else {
            2.0 * trigger.squared
        };
        Demand {
            slot,
            ends: [corners[next(trigger.edge)], corners[previous(trigger.edge)]],
            circumcenter: trigger.angle.dot / (2.0 * trigger.angle.cross),
            radius,
            aim,
            nearest: nearest.max(self.precision.floor * self.precision.floor),
        }
    }

    /// Whether a point keeps the rule; its cavity is found on the way.
    fn may_stand(&mut self, point: [f64; 2], demand: &Demand) -> bool {
        self.cavity.of_steiner_point(&self.mesh, point, demand.slot).is_ok()
            && self.cavity.nearest_squared() >= demand.nearest
            && self.cavity.encroached(&self.mesh).next().is_none()
            && self.cavity.expect_visible(&self.mesh).is_ok()
            && (demand.aim != Aim::Target || soft::may_stand(self.domain, point, demand.radius))
    }
}

/// What look-ahead looks at: angles.
struct Ahead<'r, 'a>(&'r Refinement<'a>);

impl Look for Ahead<'_, '_> {
    fn must_stay(&self, _: u32) -> bool {
        false
    }

    fn is_bad(&self, slot: u32) -> bool {
        self.0.small_angle(slot).is_some()
    }

    fn target(&self) -> MinAngle {
        self.0.target
    }

    fn may_be_too_large(&self) -> Option<impl Fn([Relative; 2]) -> bool> {
        None::<fn([Relative; 2]) -> bool>
    }

    fn most_made(&self) -> u32 {
        u32::MAX
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_points_are_among_the_candidates() {
        let hard: Vec<_> = places(3.5, Aim::Promise).collect();
        assert!(hard.contains(&[2.02, 0.0]) && hard.contains(&[3.5, 0.0]));
        assert_eq!(places(1.1, Aim::Target).next(), Some([1.1, 0.0]));
    }

    #[test]
    fn a_star_without_bad_triangles_is_best() {
        let clean = Outlook { makes_bad: false, balance: 0 };
        assert!(clean < Outlook { makes_bad: true, balance: -3 });
        assert!(Outlook { balance: -1, ..clean } < clean);
    }
}
