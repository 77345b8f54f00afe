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
        let mut smallest: Option<Angle> = None;
        let mut cosine = 1.0;
        for apex in 0..self.points.len() as u32 {
            for pair in self.pairs_at(apex) {
                if smallest.is_some() && self.is_surely_wider(apex, pair, cosine) {
                    continue;
                }
                let Some(angle) = self.angle(apex, pair) else { continue };
                if smallest.is_none_or(|smallest| angle.radians < smallest.radians) {
                    cosine = libm::cos(angle.radians);
                    smallest = Some(angle);
                }
            }
        }
        smallest
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
        self.pairs_at(apex).filter_map(move |pair| self.angle(apex, pair))
    }

    /// Whether all angles at a point are wider than one with this cosine, as plain doubles tell for sure.
    pub(super) fn are_surely_wider_at(&self, apex: u32, cosine: f64) -> bool {
        self.pairs_at(apex).all(|pair| self.is_surely_wider(apex, pair, cosine))
    }

    /// The neighbours in the rotation about a point, counter-clockwise.
    fn pairs_at(&self, apex: u32) -> impl Iterator<Item = [u32; 2]> + '_ {
        let adjoining = self.adjoining(apex);
        let next = adjoining.iter().skip(1).chain(adjoining.first());
        adjoining.iter().zip(next).map(|(&s, &t)| [s, t]).filter(|[s, t]| s != t)
    }

    /// See [`Measured::is_surely_wider`].
    fn is_surely_wider(&self, apex: u32, segments: [u32; 2], cosine: f64) -> bool {
        let [s, t] = segments;
        let ends = [self.far_end(s, apex), self.far_end(t, apex)];
        Measured::is_surely_wider(self.points[apex as usize], ends, cosine)
    }

    /// Where the other end of a segment at a point lies.
    #[inline]
    pub(super) fn far_end(&self, segment: u32, apex: u32) -> [f64; 2] {
        self.points[other_end(self.segments[segment as usize], apex) as usize]
    }

    /// The angle from one segment counter-clockwise to the next, if it is at most π.
    fn angle(&self, apex: u32, segments: [u32; 2]) -> Option<Angle> {
        let place = self.points[apex as usize];
        let [a, b] = segments.map(|segment| self.far_end(segment, apex));
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
