//! Where doubles end (§9): how far from the apex of a small angle the promises do not hold.
//!
//! The argument that keeps the refinement's points apart survives rounding while θ²·d ≥ 4·ulp(M)
//! and θ·d ≥ φ = 2^12·ulp(M), where d is the distance from an apex with an angle θ ≤ π/3 and M the
//! largest coordinate in magnitude. Both bounds are widest for the smallest angle of an apex.

use std::f64::consts::FRAC_PI_3;

use super::{Angle, Domain};
use crate::Region;
use crate::predicates::Relative;

/// The floor φ in units of ulp(M).
const FLOOR: f64 = 4096.0;
/// Angles from here on (in radians) limit nothing but where segments are hardly longer than φ.
const WIDE: f64 = 0.1;

/// An apex near which doubles are too coarse for its smallest angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrecisionLimit {
    /// The smallest angle of the apex that is meshed.
    pub angle: Angle,
    /// Nearer to the apex than this (in the units of the outline) no angle is promised.
    pub reach: f64,
}

/// ulp(M) of the points that are meshed.
pub(super) fn ulp(points: &[[f64; 2]], is_meshed: &[bool]) -> f64 {
    let meshed = points.iter().zip(is_meshed).filter(|&(_, &is_meshed)| is_meshed);
    let largest = meshed.flat_map(|(point, _)| point).fold(0.0_f64, |m, c| m.max(c.abs()));
    libm::scalbn(f64::EPSILON, libm::ilogb(largest))
}

/// The floor φ where all points are meshed.
pub(super) fn floor(points: &[[f64; 2]]) -> f64 {
    FLOOR * ulp(points, &vec![true; points.len()])
}

impl Domain {
    /// The floor φ = 2^12·ulp(M), scaled: nothing shorter is made.
    #[must_use]
    pub fn floor(&self) -> f64 {
        FLOOR * self.ulp
    }

    /// The apexes that the floor of doubles is likely to show at: those for which the stretch
    /// without promises is longer than a quarter of the shortest segment that ends there, which is
    /// about the shortest piece that their angle alone asks for.
    #[must_use]
    pub fn precision_limits(&self) -> Vec<PrecisionLimit> {
        let cosine = libm::cos(WIDE);
        let limit = |apex| {
            if self.are_surely_wider_at(apex, cosine) && !self.may_limit(apex, WIDE) {
                return None;
            }
            let angle = self.smallest_refined_angle_at(apex)?;
            let reach = reach(angle.radians, self.ulp);
            (reach > 0.25 * self.shortest_at(apex))
                .then(|| PrecisionLimit { angle, reach: libm::scalbn(reach, self.scale_exponent) })
        };
        (0..self.points.len() as u32).filter_map(limit).collect()
    }

    /// The distance from a point (scaled) within which no angle is promised; 0 where the point has
    /// no refined angle of at most 60°.
    #[must_use]
    pub fn reach(&self, apex: u32) -> f64 {
        self.smallest_refined_angle_at(apex).map_or(0.0, |angle| reach(angle.radians, self.ulp))
    }

    /// The smallest angle of at most 60° at a point, of those that take part.
    fn smallest_refined_angle_at(&self, apex: u32) -> Option<Angle> {
        self.angles_at(apex)
            .filter(|angle| angle.is_meshed || self.region == Region::Global)
            .filter(|angle| angle.radians <= FRAC_PI_3)
            .reduce(|least, next| if next.radians < least.radians { next } else { least })
    }

    /// Whether an angle at a point may be such that the point limits the mesh: for sure not only.
    fn may_limit(&self, apex: u32, radians: f64) -> bool {
        let place = self.points[apex as usize];
        let squared = |&segment: &u32| Relative::of(self.far_end(segment, apex), place).squared;
        let shortest =
            self.adjoining(apex).iter().map(squared).fold(f64::INFINITY, f64::min).sqrt();
        reach(radians, self.ulp) > 0.2 * shortest
    }

    fn shortest_at(&self, apex: u32) -> f64 {
        let [x, y] = self.points[apex as usize];
        let length = |&segment: &u32| {
            let [a, b] = self.far_end(segment, apex);
            libm::hypot(a - x, b - y)
        };
        self.adjoining(apex).iter().map(length).fold(f64::INFINITY, f64::min)
    }
}

/// The least distance d with θ²·d ≥ 4·ulp(M) and θ·d ≥ φ.
fn reach(theta: f64, ulp: f64) -> f64 {
    (4.0 * ulp / (theta * theta)).max(FLOOR * ulp / theta)
}
