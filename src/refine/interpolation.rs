//! What is given at the points of the outline, anywhere in the mesh: linear along segments, and
//! linear on the triangles of an earlier triangulation inside.

use super::Refinement;
use crate::corners::{next, previous};
use crate::predicates::{Relative, Side, side};
use crate::triangulation::Triangle;

/// Vertices and their weights, which sum up to 1.
pub type Weights = [(u32, f64); 3];

/// A mean of what is finite; infinite where nothing is.
pub fn mean<const N: usize>(weights: [(u32, f64); N], value: impl Fn(u32) -> f64) -> f64 {
    let finite = weights.map(|(v, weight)| (weight, value(v)));
    let finite = finite.into_iter().filter(|&(weight, value)| weight > 0.0 && value.is_finite());
    let (whole, sum) = finite.fold((0.0, 0.0), |(w, s), (weight, x)| (w + weight, s + weight * x));
    if whole > 0.0 { sum / whole } else { f64::INFINITY }
}

impl Refinement<'_> {
    /// The vertices whose mean a vertex is, with their weights: itself for a point of the outline,
    /// the ends of its segment for a point on one, else the corners of the triangle that it lies
    /// in, of linked triangles from a time before it came.
    #[must_use]
    pub fn weights(&self, vertex: u32, background: &mut Background) -> Weights {
        if self.provenances.is_input(vertex) {
            return [(vertex, 1.0), (vertex, 0.0), (vertex, 0.0)];
        }
        if let Some(point) = self.provenances.segment_point(vertex) {
            let [a, b] = self.segments.ends[point.segment as usize];
            let along =
                self.distance_along(point.segment, vertex) / self.distance_along(point.segment, b);
            return [(a, 1.0 - along), (b, along), (b, 0.0)];
        }
        let points = &self.mesh.points;
        let place = points[vertex as usize];
        let corners = background.triangle_at(place, points).vertices;
        let seen = corners.map(|v| Relative::of(points[v as usize], place));
        let areas = [0, 1, 2].map(|i| seen[next(i)].cross(seen[previous(i)]).max(0.0));
        let whole: f64 = areas.iter().sum();
        [0, 1, 2].map(|i| (corners[i], areas[i] / whole))
    }
}

/// Linked triangles, and where in them the last point was found.
#[derive(Debug, Clone, Default)]
pub struct Background {
    /// The triangles.
    pub triangles: Vec<Triangle>,
    /// Where the next walk begins.
    pub slot: usize,
}

impl Background {
    /// The triangle that holds `place`; where the triangles do not reach, one that is near.
    ///
    /// A walk in a constrained triangulation may go in circles: after as many steps as there are
    /// triangles they are looked through one by one.
    fn triangle_at(&mut self, place: [f64; 2], points: &[[f64; 2]]) -> Triangle {
        self.walk_to(place, points);
        self.triangles[self.slot]
    }

    fn walk_to(&mut self, place: [f64; 2], points: &[[f64; 2]]) {
        for _ in 0..self.triangles.len() {
            let Some(i) = self.edge_towards(self.slot, place, points) else { return };
            let across = self.triangles[self.slot].neighbors[i];
            if across.is_outside() {
                return;
            }
            self.slot = across.triangle() as usize;
        }
        let holds = |&slot: &usize| self.edge_towards(slot, place, points).is_none();
        self.slot = (0..self.triangles.len()).find(holds).unwrap_or(self.slot);
    }

    /// An edge of the triangle that has `place` strictly on its other side.
    fn edge_towards(&self, slot: usize, place: [f64; 2], points: &[[f64; 2]]) -> Option<usize> {
        let corners = self.triangles[slot].vertices.map(|v| points[v as usize]);
        (0..3).find(|&i| side(corners[next(i)], corners[previous(i)], place) == Side::Right)
    }
}
