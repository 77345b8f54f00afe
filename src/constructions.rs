//! Rounded answers: where a new point goes, and how wide an angle is.
//!
//! A construction only proposes; [`predicates`](crate::predicates) decide.

use crate::double_double::{DoubleDouble, Expansion, two_sum};
use crate::parameters::MinAngle;
use crate::predicates::Relative;
use crate::vector::Vector;

/// An angle from 0 to π, by its sine and cosine up to a common positive factor. So it can be
/// compared without libm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angle {
    /// |·||·|·sin of the angle; not negative.
    pub cross: f64,
    /// |·||·|·cos of the angle.
    pub dot: f64,
}

impl Angle {
    /// The angle p x q, accurate however small it is.
    #[must_use]
    pub fn at(x: [f64; 2], p: [f64; 2], q: [f64; 2]) -> Self {
        let (u, v) = (Vector::between(x, p), Vector::between(x, q));
        Self { cross: u.cross(v).abs(), dot: u.dot(v) }
    }

    /// The angle p x q in plain doubles, which differ from [`Angle::at`] in their last bits and come
    /// several times sooner; where the angle is so small that more would differ, that one.
    #[inline]
    #[must_use]
    pub fn rounded(x: [f64; 2], p: [f64; 2], q: [f64; 2]) -> Self {
        const SMALL: f64 = 1.0 / 1024.0;
        let (u, v) = (Relative::of(p, x), Relative::of(q, x));
        let rounded = Self { cross: u.cross(v).abs(), dot: u.dot(v) };
        if rounded.cross > SMALL * rounded.dot.abs() { rounded } else { Self::at(x, p, q) }
    }

    /// Whether the angle p x q is wider than one with this cosine, as plain doubles tell for sure: most
    /// angles are told from a small one so.
    #[inline]
    #[must_use]
    pub fn is_surely_wider(x: [f64; 2], [p, q]: [[f64; 2]; 2], cosine: f64) -> bool {
        // Rounding changes the cosine by some 1e-15.
        const SLACK: f64 = 1e-12;
        let (p, q) = (Relative::of(p, x), Relative::of(q, x));
        p.dot(q) < (cosine - SLACK) * (p.squared * q.squared).sqrt()
    }

    /// Whether the angle is smaller than κ̂ < 90°.
    #[must_use]
    pub fn is_below(self, kappa: MinAngle) -> bool {
        self.dot > 0.0
            && kappa.denominator * (self.cross * self.cross)
                < kappa.numerator * (self.dot * self.dot)
    }

    /// Whether the angle is at most 60°.
    #[must_use]
    pub fn is_at_most_sixty_degrees(self) -> bool {
        self.dot > 0.0 && self.cross * self.cross <= 3.0 * (self.dot * self.dot)
    }

    /// Whether the angle is smaller than 90°.
    #[must_use]
    pub fn is_acute(self) -> bool {
        self.dot > 0.0
    }

    /// The product of the lengths of the angle's legs.
    #[must_use]
    pub fn size(self) -> f64 {
        (self.cross * self.cross + self.dot * self.dot).sqrt()
    }

    /// The sine.
    #[must_use]
    pub fn sine(self) -> f64 {
        self.cross / self.size()
    }

    /// The cosine.
    #[must_use]
    pub fn cosine(self) -> f64 {
        self.dot / self.size()
    }

    /// The angle itself, in radians: for messages and for choices that need no last bit.
    #[must_use]
    pub fn radians(self) -> f64 {
        libm::atan2(self.cross, self.dot)
    }
}

/// The point on the perpendicular bisector of `a b`, to the left, at `height`·|ab|.
#[must_use]
pub fn on_bisector(a: [f64; 2], b: [f64; 2], height: f64) -> [f64; 2] {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    [a[0] + (0.5 * dx - height * dy), a[1] + (0.5 * dy + height * dx)]
}

/// The point over the segment from `a` to `b`, to its left, at `height` over it and `shift` beside
/// its middle towards `b`, both in lengths of the segment.
#[must_use]
pub fn beside_bisector(a: [f64; 2], b: [f64; 2], height: f64, shift: f64) -> [f64; 2] {
    let [x, y] = on_bisector(a, b, height);
    [x + shift * (b[0] - a[0]), y + shift * (b[1] - a[1])]
}

/// The distance between two points, in double-double.
fn distance(x: [f64; 2], y: [f64; 2]) -> DoubleDouble {
    let dx = DoubleDouble::difference(y[0], x[0]);
    let dy = DoubleDouble::difference(y[1], x[1]);
    dx.times(dx).plus(dy.times(dy)).square_root()
}

/// The length of the segment from `x` to `y`, and whether the double is that length exactly.
///
/// Only along an axis can the length be a power of two, the only case that is asked about
/// (a sum of two non-zero squares is no power of four).
#[must_use]
pub fn segment_length(x: [f64; 2], y: [f64; 2]) -> (f64, bool) {
    let along_axis = x[0] == y[0] || x[1] == y[1];
    let length = distance(x, y);
    (length.hi, along_axis && length.lo == 0.0)
}

/// The point of the segment from `x` to `y` at distance `d` from `x`: x + (d/|xy|)(y − x), each
/// coordinate within 0.51 ulp of a point of the segment, at any depth.
#[must_use]
pub fn point_on_segment(x: [f64; 2], y: [f64; 2], d: f64) -> [f64; 2] {
    let ratio = DoubleDouble { hi: d, lo: 0.0 }.over(distance(x, y));
    let mut point = [0, 1].map(|i| {
        let step = ratio.times(DoubleDouble::difference(y[i], x[i]));
        let sum = two_sum(x[i], step.hi);
        sum.hi + (sum.lo + step.lo)
    });
    // Near zero the sum cancels to fewer digits than a double has: there the coordinate along
    // which the segment runs farther is taken as it is, and the other one from the line itself.
    if (0..2).any(|i| point[i].abs() * ((1_u64 << 44) as f64) < x[i].abs()) {
        let along = usize::from((y[0] - x[0]).abs() < (y[1] - x[1]).abs());
        point[1 - along] = on_line(x, y, along, point[along]);
    }
    point
}

/// The other coordinate of the point of the line through `x` and `y` whose coordinate `along` is
/// `c`: (x_o (y_a − x_a) + (c − x_a)(y_o − x_o)) / (y_a − x_a), the sum exact.
fn on_line(x: [f64; 2], y: [f64; 2], along: usize, c: f64) -> f64 {
    let other = 1 - along;
    let run = DoubleDouble::difference(y[along], x[along]);
    let rise = DoubleDouble::difference(y[other], x[other]);
    let step = DoubleDouble::difference(c, x[along]);
    let mut sum = Expansion::default();
    sum.add_product(DoubleDouble { hi: x[other], lo: 0.0 }, run);
    sum.add_product(step, rise);
    sum.value().over(run).hi
}

/// Where two segments with one point in common cross: each coordinate within 0.51 ulp, however
/// small their angle. (The cross products are exact; near zero, a coordinate is 0.)
#[must_use]
pub fn crossing([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> [f64; 2] {
    let vector = |p: [f64; 2], q: [f64; 2]| [0, 1].map(|k| DoubleDouble::difference(q[k], p[k]));
    let cross = |[ux, uy]: [DoubleDouble; 2], [vx, vy]: [DoubleDouble; 2]| {
        let mut sum = Expansion::default();
        sum.add_product(ux, vy);
        sum.add_product(DoubleDouble { hi: -uy.hi, lo: -uy.lo }, vx);
        sum.value()
    };
    let (ab, cd, ac) = (vector(a, b), vector(c, d), vector(a, c));
    let part = cross(ac, cd).over(cross(ab, cd));
    [0, 1].map(|k| {
        let step = part.times(ab[k]);
        let sum = two_sum(a[k], step.hi);
        let place = sum.hi + (sum.lo + step.lo);
        let is_noise = place.abs() * ((1_u64 << 62) as f64) * ((1_u64 << 32) as f64) < a[k].abs();
        if is_noise { 0.0 } else { place }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_at_a_tiny_angle_cross_where_they_do() {
        // y = 1 and the line through (0, 1 − 2^-52) and (3, 1 + 2^-51): at x = 1.
        let flat = [[-1.0, 1.0], [4.0, 1.0]];
        let steep = [[0.0, 1.0 - f64::EPSILON], [3.0, 1.0 + 2.0 * f64::EPSILON]];
        assert_eq!(crossing(flat, steep), [1.0, 1.0]);
        assert_eq!(crossing(steep, flat), [1.0, 1.0]);
    }

    #[test]
    fn segments_through_the_origin_cross_at_zero() {
        let (a, b) = ([[-1.0, -1.0], [2.0, 2.0]], [[-1.0, 1.0], [2.0, -2.0]]);
        assert_eq!(crossing(a, b), [0.0, 0.0]);
    }

    #[test]
    fn the_sine_of_a_tiny_angle_is_kept_far_from_the_origin() {
        let x = [1e3, 1e3];
        let (p, q) = ([1001.0, 1e3], [1001.0, 1e3 + 2f64.powi(-30)]);
        assert_eq!(Angle::at(x, p, q), Angle { cross: 2f64.powi(-30), dot: 1.0 });
    }

    #[test]
    fn a_bisector_point_stands_to_the_left() {
        assert_eq!(on_bisector([0.0, 0.0], [2.0, 0.0], 1.5), [1.0, 3.0]);
    }

    #[test]
    fn the_middle_of_a_segment_is_its_middle() {
        assert_eq!(point_on_segment([1.0, 1.0], [4.0, 5.0], 2.5), [2.5, 3.0]);
    }

    #[test]
    fn a_point_near_zero_is_on_its_segment_to_its_own_last_bit() {
        // Through the origin but for rounding: the middle is 5e-18 away from it.
        let (x, y) = ([-0.3, -0.1], [0.3, 0.1f64.next_up()]);
        let [px, py] = point_on_segment(x, y, (0.09f64 + 0.01).sqrt());
        let slope = 2f64.powi(-56) / 0.6 * (0.3 + px) + (px / 3.0);
        assert!(py.abs() < 1e-16 && px.abs() < 1e-16, "{px} {py}");
        assert!((py - slope).abs() < 1e-17, "{py} {slope}");
    }

    #[test]
    fn only_a_length_along_an_axis_counts_as_exact() {
        assert_eq!(segment_length([0.0, 1.0], [4.0, 1.0]), (4.0, true));
        assert!(!segment_length([0.0, 0.0], [1.0, 1.0]).1);
        assert!(!segment_length([1e-30, 1.0], [4.0, 1.0]).1);
    }
}
