//! How large a triangle may be.
//!
//! A further trigger keeps every promise of the algorithm as long as it fires only where the
//! insertion radius of its Steiner point is above a positive floor (ALGORITHM §6): the
//! circumradius of a triangle of area A is at least √(4A/(3√3)).

use super::local_areas::LocalAreas;
use crate::formats::LocalArea;
use crate::predicates::Relative;

/// Bounds on the area of triangles.
#[derive(Debug, Clone, Default)]
pub struct Sizing {
    /// Twice the largest area in each region; the last one counts for all regions beyond.
    twice_largest: Vec<f64>,
    /// Bounds that depend on the place.
    local: Option<LocalAreas>,
}

impl Sizing {
    /// No triangle larger than `max_area`, none of region i + 1 larger than `of_regions[i]`, none
    /// with its centroid in a local area larger than that asks.
    #[must_use]
    pub fn new(
        max_area: Option<f64>,
        of_regions: &[Option<f64>],
        local_areas: &[LocalArea],
    ) -> Self {
        let everywhere = max_area.unwrap_or(f64::INFINITY);
        let regions = of_regions.iter().map(|area| area.unwrap_or(f64::INFINITY).min(everywhere));
        let twice_largest: Vec<f64> =
            std::iter::once(everywhere).chain(regions).map(|area| 2.0 * area).collect();
        let none = twice_largest.iter().all(|&area| area == f64::INFINITY);
        let twice_largest = if none { Vec::new() } else { twice_largest };
        Self { twice_largest, local: LocalAreas::new(local_areas) }
    }

    /// Whether there is any bound.
    #[must_use]
    pub fn has_bounds(&self) -> bool {
        !self.twice_largest.is_empty() || self.local.is_some()
    }

    /// Whether a triangle of this rounded area, twice, may be too large: a bound that depends on the
    /// place counts everywhere.
    #[inline]
    #[must_use]
    pub fn may_be_too_large(&self, twice_area: f64, region: u32) -> bool {
        (!self.twice_largest.is_empty() && twice_area > self.twice_largest[region as usize])
            || self.local.as_ref().is_some_and(|local| twice_area > 2.0 * local.least())
    }

    /// Whether that triangle, none of whose angles is small, is too large for its region whatever
    /// rounding did.
    #[inline]
    #[must_use]
    pub fn is_surely_too_large(&self, twice_area: f64, region: u32) -> bool {
        let bound = self.twice_largest.get(region as usize);
        bound.is_some_and(|bound| twice_area > bound * 1.000_000_1)
    }

    /// Whether a counter-clockwise triangle is too large.
    #[must_use]
    pub fn is_too_large(&self, [p, a, b]: [[f64; 2]; 3], region: u32) -> bool {
        let twice = Relative::of(a, p).cross(Relative::of(b, p));
        let centroid = || [0, 1].map(|k| p[k] + ((a[k] - p[k]) + (b[k] - p[k])) / 3.0);
        (!self.twice_largest.is_empty() && twice > self.twice_largest[region as usize])
            || self.local.as_ref().is_some_and(|local| {
                twice > 2.0 * local.least() && twice > 2.0 * local.at(centroid())
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HALF: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

    #[test]
    fn the_smaller_of_two_bounds_counts() {
        let sizing = Sizing::new(Some(0.6), &[Some(0.4), Some(2.0)], &[]);
        assert_eq!([0, 1, 2].map(|region| sizing.is_too_large(HALF, region)), [false, true, false]);
    }

    #[test]
    fn a_local_bound_counts_where_the_centroid_lies() {
        let local = |[x, y]: [f64; 2]| LocalArea {
            corners: [[x, y], [x + 1.0, y], [x, y + 1.0]],
            max_area: 0.4,
        };
        let is_too_large = |at| {
            let sizing = Sizing::new(None, &[], &[local(at)]);
            assert!(sizing.may_be_too_large(1.0, 0));
            sizing.is_too_large(HALF, 0)
        };
        assert!(is_too_large([0.0, 0.0]) && !is_too_large([0.5, 0.5]));
    }

    #[test]
    fn without_bounds_nothing_is_too_large() {
        let sizing = Sizing::new(None, &[None], &[]);
        assert!(!sizing.is_too_large([[0.0, 0.0], [1e100, 0.0], [0.0, 1e100]], 1));
    }
}
