//! The coordinates in which everything is judged.
//!
//! Where the largest coordinate has an exponent outside ±100 all are multiplied by one power of
//! two, so that no product of four lengths over- or underflows (ALGORITHM §1). That changes no
//! answer: it only rounds coordinates that are some 2^900 times smaller than the largest one.

use std::borrow::Cow;

/// A power of two for the coordinates, and the spacing of doubles there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// Judged coordinates = given coordinates × 2^−`exponent`.
    exponent: i32,
    /// ulp(M), M the largest coordinate in magnitude, in judged coordinates.
    pub(super) ulp: f64,
}

impl Frame {
    /// The frame of these points; what is not finite does not count.
    pub(super) fn new(points: &[[f64; 2]]) -> Self {
        let largest = largest(points);
        let exponent = exponent_of(largest);
        let exponent = if largest > 0.0 && exponent.abs() > 100 { exponent } else { 0 };
        Self { exponent, ulp: 0.0 }.with_largest(largest)
    }

    /// The same frame for a mesh whose coordinates may be smaller: a point of the outline that is
    /// left out, far away, makes nobody's doubles coarser.
    pub(super) fn with_output(self, points: &[[f64; 2]]) -> Self {
        match largest(points) {
            0.0 => self,
            largest => Self { ulp: self.ulp.min(self.with_largest(largest).ulp), ..self },
        }
    }

    fn with_largest(self, largest: f64) -> Self {
        Self { ulp: self.ulp_at(self.scaled([largest, 0.0])[0]), ..self }
    }

    /// Points in judged coordinates, which most often are the given ones.
    pub(super) fn all_scaled(self, points: &[[f64; 2]]) -> Cow<'_, [[f64; 2]]> {
        match self.exponent {
            0 => Cow::Borrowed(points),
            _ => points.iter().map(|&p| self.scaled(p)).collect(),
        }
    }

    /// A point in judged coordinates.
    pub(super) fn scaled(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [times_power_of_two(x, -self.exponent), times_power_of_two(y, -self.exponent)]
    }

    /// An area in the units of the file.
    pub(super) fn area_outside(self, area: f64) -> f64 {
        times_power_of_two(times_power_of_two(area, self.exponent), self.exponent)
    }

    /// A length in the units of the file.
    pub(super) fn length_outside(self, length: f64) -> f64 {
        times_power_of_two(length, self.exponent)
    }

    /// The spacing of the given doubles at a judged coordinate.
    pub(super) fn ulp_at(self, x: f64) -> f64 {
        let smallest = times_power_of_two(f64::from_bits(1), -self.exponent);
        times_power_of_two(1.0, exponent_of(x) - 52).max(smallest).max(f64::from_bits(1))
    }
}

/// The largest finite coordinate in magnitude.
fn largest(points: &[[f64; 2]]) -> f64 {
    points.iter().flatten().map(|x| x.abs()).filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// The e with 2^e ≤ |x| < 2^(e+1); −1022 for what is smaller.
fn exponent_of(x: f64) -> i32 {
    (((x.to_bits() >> 52) & 0x7ff) as i32 - 1023).max(-1022)
}

/// x·2^k; exact unless it ends below the normal doubles.
fn times_power_of_two(x: f64, k: i32) -> f64 {
    if k == 0 {
        return x;
    }
    // Three factors reach every exponent that two doubles can be apart.
    let power = |k: i32| f64::from_bits(((k + 1023) as u64) << 52);
    let third = (k / 3).clamp(-1000, 1000);
    let rest = (k - 2 * third).clamp(-1022, 1023);
    if k < 0 {
        x * power(third) * power(third) * power(rest)
    } else {
        x * power(rest) * power(third) * power(third)
    }
}
