//! The outline's point attributes at the points of the mesh: linear along segments, and linear on
//! the triangles of the initial triangulation inside.

use crate::domain::Domain;
use crate::formats::{Attribute, Data, Values};
use crate::refine::Refinement;
use crate::refine::interpolation::{Background, Weights};
use crate::triangulation::Triangle;

/// The attributes at the vertices in `order`, by name.
///
/// `initial` are the linked triangles over the points of the domain before carving: they fill the
/// convex hull, so every point lies in one.
#[must_use]
pub fn interpolate(
    attributes: &[Attribute],
    initial: Vec<Triangle>,
    refinement: &Refinement,
    domain: &Domain,
    order: impl Iterator<Item = u32>,
) -> Vec<Data> {
    if attributes.is_empty() {
        return Vec::new();
    }
    let mut background = Background { triangles: initial, slot: 0 };
    let weights: Vec<_> = order.map(|v| refinement.weights(v, &mut background)).collect();
    let input = |vertex: u32| domain.input_points[vertex as usize] as usize;
    let mean = |attribute: &Attribute, weights: &Weights| {
        weights.iter().map(|&(v, weight)| weight * attribute.values[input(v)]).sum()
    };
    let data = attributes.iter().map(|attribute| Data {
        name: attribute.name.clone(),
        components: 1,
        values: Values::Real(weights.iter().map(|weights| mean(attribute, weights)).collect()),
    });
    data.collect()
}
