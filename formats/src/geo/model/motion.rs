//! Transformations of space.

use super::{CurveKind, Model, Shape, unknown};
use crate::geo::error::Problem;

/// An affine map: `x ↦ matrix · x + shift`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::geo) struct Motion {
    matrix: [[f64; 3]; 3],
    shift: [f64; 3],
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Motion {
    /// A translation.
    pub(in crate::geo) fn translation(by: [f64; 3]) -> Self {
        Self { matrix: IDENTITY, shift: by }
    }

    /// A rotation about an axis through a point, by an angle in radians.
    pub(in crate::geo) fn rotation(axis: [f64; 3], point: [f64; 3], angle: f64) -> Self {
        let length = dot(axis, axis).sqrt();
        let k = axis.map(|x| x / length);
        let (sin, cos) = libm::sincos(angle);
        // Rodrigues' formula, row by row.
        let cross = [[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]];
        let entry = |i: usize, j: usize| {
            cos * IDENTITY[i][j] + sin * cross[i][j] + (1.0 - cos) * k[i] * k[j]
        };
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)));
        Self { matrix, shift: [0.0; 3] }.about(point)
    }

    /// The mirror image at the plane `a·x + b·y + c·z + d = 0`.
    pub(in crate::geo) fn reflection([a, b, c, d]: [f64; 4]) -> Self {
        let normal = [a, b, c];
        let scale = 2.0 / dot(normal, normal);
        let entry = |i: usize, j: usize| IDENTITY[i][j] - scale * normal[i] * normal[j];
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)));
        Self { matrix, shift: normal.map(|x| -scale * d * x) }
    }

    /// A stretch about a point.
    pub(in crate::geo) fn dilation(centre: [f64; 3], factors: [f64; 3]) -> Self {
        let entry = |i: usize, j: usize| if i == j { factors[i] } else { 0.0 };
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)));
        Self { matrix, shift: [0.0; 3] }.about(centre)
    }

    /// The same map with `point` as its origin.
    fn about(self, point: [f64; 3]) -> Self {
        let turned = self.turn(point);
        Self { shift: [0, 1, 2].map(|i| point[i] - turned[i]), ..self }
    }

    /// Where a place goes.
    pub(in crate::geo) fn apply(&self, x: [f64; 3]) -> [f64; 3] {
        let turned = self.turn(x);
        [0, 1, 2].map(|i| turned[i] + self.shift[i])
    }

    /// Where a direction goes.
    pub(super) fn turn(&self, x: [f64; 3]) -> [f64; 3] {
        self.matrix.map(|row| dot(row, x))
    }

    /// Whether all of its numbers are finite.
    pub(in crate::geo) fn is_finite(&self) -> bool {
        self.matrix.iter().flatten().chain(&self.shift).all(|x| x.is_finite())
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Model {
    /// Moves shapes, with all points that define them; each point once.
    pub(in crate::geo) fn transform(
        &mut self,
        motion: &Motion,
        shapes: &[Shape],
    ) -> Result<(), Problem> {
        let (mut points, mut curves) = (Vec::new(), Vec::new());
        for &(dim, tag) in shapes {
            match dim {
                0 => points.push(tag),
                1 => curves.push(tag.abs()),
                _ => curves.extend(self.surface(tag)?.curves().map(i32::abs)),
            }
        }
        sort(&mut curves);
        for &tag in &curves {
            points.extend(self.curve(tag)?.points.iter());
        }
        sort(&mut points);
        for tag in points {
            let point = self.points.get_mut(tag).ok_or_else(|| unknown("point", tag))?;
            let moved = motion.apply(point.at);
            if moved.iter().any(|x| !x.is_finite()) {
                return Err(Problem::NotFinite { operation: format!("moving point {tag}") });
            }
            point.at = moved;
        }
        for tag in curves {
            let curve = self.curves.get_mut(tag).ok_or_else(|| unknown("curve", tag))?;
            if let CurveKind::Arc(arc) = &mut curve.kind {
                **arc = arc.moved(motion);
            }
        }
        Ok(())
    }
}

fn sort(tags: &mut Vec<i32>) {
    tags.sort_unstable();
    tags.dedup();
}
