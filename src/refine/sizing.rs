//! How large a triangle may be.
//!
//! A further trigger keeps every promise of the algorithm as long as it fires only where the
//! insertion radius of its Steiner point is above a positive floor (ALGORITHM §6): the
//! circumradius of a triangle of area A is at least √(4A/(3√3)).

use crate::predicates::Relative;

/// Bounds on the area of triangles.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sizing {
    /// Twice the largest area in each region; the last one counts for all regions beyond.
    twice_largest: Vec<f64>,
}

impl Sizing {
    /// No triangle larger than `max_area`, none of region i + 1 larger than `of_regions[i]`.
    #[must_use]
    pub fn new(max_area: Option<f64>, of_regions: &[Option<f64>]) -> Self {
        let everywhere = max_area.unwrap_or(f64::INFINITY);
        let regions = of_regions.iter().map(|area| area.unwrap_or(f64::INFINITY).min(everywhere));
        let twice_largest: Vec<f64> =
            std::iter::once(everywhere).chain(regions).map(|area| 2.0 * area).collect();
        let none = twice_largest.iter().all(|&area| area == f64::INFINITY);
        Self { twice_largest: if none { Vec::new() } else { twice_largest } }
    }

    /// Whether the triangle of the point that `a` and `b` are seen from is too large.
    #[inline]
    #[must_use]
    pub fn may_be_too_large(&self, a: Relative, b: Relative, region: u32) -> bool {
        !self.twice_largest.is_empty() && a.cross(b) > self.twice_largest[region as usize]
    }

    /// Whether a counter-clockwise triangle is too large.
    #[must_use]
    pub fn is_too_large(&self, [p, a, b]: [[f64; 2]; 3], region: u32) -> bool {
        self.may_be_too_large(Relative::of(a, p), Relative::of(b, p), region)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HALF: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

    #[test]
    fn the_smaller_of_two_bounds_counts() {
        let sizing = Sizing::new(Some(0.6), &[Some(0.4), Some(2.0)]);
        assert_eq!([0, 1, 2].map(|region| sizing.is_too_large(HALF, region)), [false, true, false]);
    }

    #[test]
    fn without_bounds_nothing_is_too_large() {
        let sizing = Sizing::new(None, &[None]);
        assert!(!sizing.is_too_large([[0.0, 0.0], [1e100, 0.0], [0.0, 1e100]], 1));
    }
}
