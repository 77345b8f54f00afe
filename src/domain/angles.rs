//! The angles between adjoining segments, and θ*, the smallest of them.

use super::Domain;
use super::adjoining::other_end;
use crate::columns::lexicographic;
use crate::constructions::Angle as Measured;
use crate::predicates::{Side, side};

/// The angle between two adjoining segments that are neighbours in the rotation about their
/// common point. At most π: of two segments that meet at 90°, the other 270° are no angle between
/// them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angle {
    /// The angle; accurate to a few units in the last place, however small.
    pub radians: f64,
    /// The common point.
    pub apex: u32,
    /// The segments, the second counter-clockwise of the first.
    pub segments: [u32; 2],
    /// Whether what lies between the segments is meshed.
    pub is_meshed: bool,
}

impl Domain {
    /// θ*: the smallest angle between two adjoining segments, not cut off at 60°; of equal ones
    /// the first. `None` where no two segments adjoin.
    #[must_use]
    pub fn smallest_angle(&self) -> Option<Angle> {
        self.angles().reduce(|least, next| if next.radians < least.radians { next } else { least })
    }

    /// The smallest angle that is meshed, as [`smallest_angle`](Domain::smallest_angle) is of all.
    #[must_use]
    pub fn smallest_meshed_angle(&self) -> Option<Angle> {
        let meshed = self.angles().filter(|angle| angle.is_meshed);
        meshed.reduce(|least, next| if next.radians < least.radians { next } else { least })
    }

    /// The angles below a bound in radians, from the smallest up.
    #[must_use]
    pub fn angles_below(&self, bound: f64) -> Vec<Angle> {
        let mut angles: Vec<Angle> = self.angles().filter(|angle| angle.radians < bound).collect();
        angles.sort_by(|a, b| a.radians.total_cmp(&b.radians));
        angles
    }

    /// The angles between neighbours in rotation, point by point.
    pub fn angles(&self) -> impl Iterator<Item = Angle> + '_ {
        (0..self.points.len() as u32).flat_map(|apex| self.angles_at(apex))
    }

    /// The angles between neighbours in the rotation about a point.
    pub fn angles_at(&self, apex: u32) -> impl Iterator<Item = Angle> + '_ {
        let adjoining = self.adjoining(apex);
        let next = |index: usize| adjoining[(index + 1) % adjoining.len()];
        let pairs = (0..adjoining.len()).map(move |index| [adjoining[index], next(index)]);
        pairs.filter(|[s, t]| s != t).filter_map(move |pair| self.angle(apex, pair))
    }

    /// The angle from one segment counter-clockwise to the next, if it is at most π.
    fn angle(&self, apex: u32, segments: [u32; 2]) -> Option<Angle> {
        let place = self.points[apex as usize];
        let [a, b] = segments
            .map(|segment| self.points[other_end(self.segments[segment as usize], apex) as usize]);
        let radians = match side(place, a, b) {
            Side::Right => return None,
            // Each of two segments on one line is the next of the other: once is enough.
            Side::On if lexicographic(a, b).is_gt() => return None,
            Side::On => std::f64::consts::PI,
            Side::Left => {
                let Measured { cross, dot } = Measured::at(place, a, b);
                libm::atan2(cross.max(f64::MIN_POSITIVE), dot)
            }
        };
        // The wedge lies to the left of the first segment as it leaves the apex.
        let [left, right] = self.faces.sides(segments[0]);
        let face = if self.segments[segments[0] as usize][0] == apex { left } else { right };
        Some(Angle { radians, apex, segments, is_meshed: self.faces.is_meshed(face) })
    }
}
