//! The outline's point attributes at the points of the mesh: linear along segments, and linear on
//! the triangles of the initial triangulation inside.

use crate::corners::{next, previous};
use crate::domain::Domain;
use crate::formats::{Attribute, Data, Values};
use crate::predicates::{Relative, Side, side};
use crate::refine::Refinement;
use crate::triangulation::Triangle;

/// The attributes at the vertices in `order`, by name.
///
/// `initial` are the linked triangles over the points of the domain before carving: they fill the
/// convex hull, so every point lies in one. `domain_points` tells which point of the domain each
/// of the first vertices is.
#[must_use]
pub fn interpolate(
    attributes: &[Attribute],
    initial: &[Triangle],
    refinement: &Refinement,
    domain: &Domain,
    domain_points: &[u32],
    order: &[u32],
) -> Vec<Data> {
    if attributes.is_empty() {
        return Vec::new();
    }
    let mut walk = Walk { triangles: initial, points: &refinement.mesh.points, slot: 0 };
    let weights: Vec<_> = order.iter().map(|&v| weights(v, refinement, &mut walk)).collect();
    let input = |vertex: u32| domain.input_points[domain_points[vertex as usize] as usize] as usize;
    let mean = |attribute: &Attribute, weighted: &[(u32, f64)]| {
        weighted.iter().map(|&(v, weight)| weight * attribute.values[input(v)]).sum()
    };
    let data = attributes.iter().map(|attribute| Data {
        name: attribute.name.clone(),
        components: 1,
        values: Values::Real(weights.iter().map(|weighted| mean(attribute, weighted)).collect()),
    });
    data.collect()
}

/// The points of the domain whose mean is a vertex, with their weights; their sum is 1.
fn weights(vertex: u32, refinement: &Refinement, walk: &mut Walk) -> Vec<(u32, f64)> {
    if refinement.provenances.is_input(vertex) {
        return vec![(vertex, 1.0)];
    }
    if let Some(point) = refinement.provenances.segment_point(vertex) {
        let [a, b] = refinement.segments.ends[point.segment as usize];
        let along = refinement.distance_along(point.segment, vertex)
            / refinement.distance_along(point.segment, b);
        return vec![(a, 1.0 - along), (b, along)];
    }
    let place = refinement.mesh.points[vertex as usize];
    let corners = walk.triangles[walk.to(place)].vertices;
    let seen = corners.map(|v| Relative::of(refinement.mesh.points[v as usize], place));
    let areas = [0, 1, 2].map(|i| seen[next(i)].cross(seen[previous(i)]).max(0.0));
    let whole: f64 = areas.iter().sum();
    corners.into_iter().zip(areas.map(|area| area / whole)).collect()
}

/// Point location by walking from where the last point was.
struct Walk<'a> {
    triangles: &'a [Triangle],
    points: &'a [[f64; 2]],
    slot: usize,
}

impl Walk<'_> {
    /// The slot of a triangle that holds `place`.
    ///
    /// A walk in a constrained triangulation may go in circles: after as many steps as there are
    /// triangles they are looked through one by one.
    fn to(&mut self, place: [f64; 2]) -> usize {
        for _ in 0..self.triangles.len() {
            match self.edge_towards(self.slot, place) {
                None => return self.slot,
                Some(i) => {
                    let across = self.triangles[self.slot].neighbors[i];
                    if across.is_outside() {
                        return self.slot;
                    }
                    self.slot = across.triangle() as usize;
                }
            }
        }
        let holds = |&slot: &usize| self.edge_towards(slot, place).is_none();
        self.slot = (0..self.triangles.len()).find(holds).unwrap_or(self.slot);
        self.slot
    }

    /// An edge of the triangle that has `place` strictly on its other side.
    fn edge_towards(&self, slot: usize, place: [f64; 2]) -> Option<usize> {
        let corners = self.triangles[slot].vertices.map(|v| self.points[v as usize]);
        (0..3).find(|&i| side(corners[next(i)], corners[previous(i)], place) == Side::Right)
    }
}
