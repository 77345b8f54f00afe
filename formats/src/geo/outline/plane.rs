//! The plane that the geometry lies in: z = c, else y = c, else x = c.

use crate::geo::error::Problem;
use crate::geo::syntax::Place;

/// Points that leave the plane by less than this part of the extent are in it.
const TOLERANCE: f64 = 1e-9;

/// A plane along two of the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plane {
    /// The axis that it is normal to: 0, 1, 2 for x, y, z.
    pub normal: usize,
    /// Where it meets that axis.
    pub at: f64,
}

/// What a point needs to be asked for: its tag, its place in the script, its coordinates.
pub(super) type Asked = (i32, Place, [f64; 3]);

impl Plane {
    /// The plane of some points.
    ///
    /// # Errors
    /// The first point that lies off the plane of most, with the place of the first point.
    pub(super) fn of(
        points: impl Iterator<Item = Asked> + Clone,
    ) -> Result<Self, (Problem, Place, Place)> {
        let Some(first_asked @ (_, first_place, first)) = points.clone().next() else {
            return Ok(Self { normal: 2, at: 0.0 });
        };
        let extent = |axis: usize| {
            let values = || points.clone().map(|(_, _, at)| at[axis]);
            values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
        };
        let extents = [extent(0), extent(1), extent(2)];
        let tolerance = TOLERANCE * extents.iter().copied().fold(0.0, f64::max);
        let flat = [2, 1, 0].into_iter().find(|&axis| extents[axis] <= tolerance);
        if let Some(normal) = flat {
            return Ok(Self { normal, at: first[normal] });
        }
        let off = points.clone().find(|(_, _, at)| (at[2] - first[2]).abs() > tolerance);
        let (point, place, _) = off.unwrap_or(first_asked);
        let problem = Problem::OffPlane { point, plane: format!("z = {}", first[2]), line: 0 };
        Err((problem, place, first_place))
    }

    /// The two coordinates of a place in the plane.
    pub(super) fn project(&self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        match self.normal {
            0 => [y, z],
            1 => [x, z],
            _ => [x, y],
        }
    }

    /// The names of the coordinates: `x` and `y`, …
    pub(super) fn axes(&self) -> [char; 2] {
        match self.normal {
            0 => ['y', 'z'],
            1 => ['x', 'z'],
            _ => ['x', 'y'],
        }
    }
}
