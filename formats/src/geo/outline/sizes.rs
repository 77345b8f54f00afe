//! Target sizes: at points, and along curves.
//!
//! As Gmsh does: a size given at a point counts there; along a curve sizes are linear in its
//! parameter. Without any the size is a tenth of the diagonal of the geometry; no size is larger
//! than that diagonal. Then come the bounds and the factor of the options.

use super::chain::Along;
use crate::geo::evaluate::Options;

/// Without a given size: this part of the diagonal.
const DEFAULT_PART: f64 = 0.1;

/// How sizes are found.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sizes<'a> {
    pub options: &'a Options,
    /// The diagonal of the box around the geometry.
    pub diagonal: f64,
}

impl Sizes<'_> {
    /// The size at a point, given there or not; `alone` where no neighbour has a size either.
    pub(super) fn at_point(&self, given: Option<f64>, alone: bool) -> f64 {
        let given = given.filter(|_| self.options.sizes_from_points);
        let own = match given {
            Some(size) => size,
            None if alone && self.options.sizes_from_points => DEFAULT_PART * self.diagonal,
            None => f64::INFINITY,
        };
        self.bounded(own)
    }

    /// The sizes along a curve between points with given sizes.
    pub(super) fn along(&self, ends: [Option<f64>; 2], curvature_size: f64) -> CurveSizes<'_> {
        CurveSizes { sizes: self, ends, curvature_size }
    }

    fn bounded(&self, size: f64) -> f64 {
        let size = size.min(self.diagonal).max(self.options.least_size).min(self.options.most_size);
        let size = size * self.options.size_factor;
        if size > 0.0 { size } else { self.diagonal }
    }
}

/// Sizes along one curve.
pub(super) struct CurveSizes<'a> {
    sizes: &'a Sizes<'a>,
    ends: [Option<f64>; 2],
    /// The size that the curvature asks for.
    curvature_size: f64,
}

impl Along for CurveSizes<'_> {
    fn size(&self, t: f64) -> f64 {
        let sizes = self.sizes;
        let given = match self.ends {
            _ if !sizes.options.sizes_from_points => f64::INFINITY,
            [Some(a), Some(b)] => (1.0 - t) * a + t * b,
            [None, None] => DEFAULT_PART * sizes.diagonal,
            _ => f64::INFINITY,
        };
        sizes.bounded(given.min(self.curvature_size))
    }
}
