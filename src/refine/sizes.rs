//! Target sizes: how long edges should be, as it is given at the points of the outline.
//!
//! Along a segment the size is linear. Segments are cut to their sizes first (`division`), and a
//! vertex then has the mean length of the pieces there as its size; inside, the size is a mean over
//! the triangles between these points ([`interpolation`](super::interpolation)). So it is a fixed
//! function of the place, bounded from below, and the trigger keeps every promise (ALGORITHM §6).

use super::Refinement;
use super::interpolation::{Background, Weights, mean};
use super::quality::Trigger;
use crate::corners::{next, previous};
use crate::domain::Domain;
use crate::parameters::Steiner;
use crate::predicates::Relative;

/// A triangle is too large where its circumradius is more than this times the size at its corners.
///
/// Choice: an equilateral triangle of that edge has 1/√3; half a square of that edge, 1/√2, is too
/// large, as in Gmsh: a mesh of one size then has about as many triangles as equilateral ones.
const LARGEST_RADIUS: f64 = 0.7;

/// Inside, the mean of sizes is that of their powers.
///
/// Choice: away from a small detail sizes grow a little faster than on a straight line, as they
/// do in Gmsh: there a size comes from the triangle that a point is put into, and each point changes
/// the triangles.
const POWER: f64 = 1.3;

/// The least circumradius, in sizes, of a triangle that is attacked for a soft target alone: some
/// half of what sizes leave.
const LEAST_SOFT_RADIUS: f64 = 0.2;

/// The size at every vertex.
#[derive(Debug, Clone)]
pub struct Sizes {
    of_vertices: Vec<f64>,
    /// Where the size inside is linear.
    background: Background,
    /// For each vertex a slot of the background near it.
    slots: Vec<u32>,
}

impl Sizes {
    /// The sizes of a domain, if it has any. Its points are the first of the `count` vertices of its
    /// triangulation.
    #[must_use]
    pub fn of(domain: &Domain, count: usize) -> Option<Self> {
        let sizes = domain.point_sizes.iter().copied();
        let none = std::iter::repeat(f64::INFINITY);
        (!domain.point_sizes.is_empty()).then(|| Self {
            of_vertices: sizes.chain(none).take(count).collect(),
            background: Background::default(),
            slots: Vec::new(),
        })
    }

    /// The size at a vertex; infinite where there is none.
    #[must_use]
    pub fn at(&self, vertex: u32) -> f64 {
        self.of_vertices[vertex as usize]
    }

    /// Changes the size at a vertex.
    pub fn set(&mut self, vertex: u32, size: f64) {
        self.of_vertices[vertex as usize] = size;
    }

    /// The size at a place inside, by the vertices around it.
    fn inside(&self, weights: Weights) -> f64 {
        let finite = weights.map(|(v, _)| self.at(v)).into_iter().filter(|size| size.is_finite());
        // Of parts of the largest, so that twice the sizes have exactly twice the mean.
        let largest = finite.fold(0.0, f64::max);
        let mean = mean(weights, |v| libm::pow(self.at(v) / largest, POWER));
        libm::pow(mean, 1.0 / POWER) * largest
    }

    /// The size at every vertex, and the slot of the background near it.
    #[cfg(test)]
    pub(super) fn of_all(&self) -> (&[f64], &[u32]) {
        (&self.of_vertices, &self.slots)
    }

    /// Forgets the vertices behind the first `vertices`.
    pub(super) fn truncate(&mut self, vertices: usize) {
        self.of_vertices.truncate(vertices);
        self.slots.truncate(vertices);
    }

    /// Forgets vertices that no triangle of the background has; those that stay keep their order.
    pub(super) fn retain(&mut self, stays: impl Fn(u32) -> bool) {
        let mut vertices = 0..;
        self.of_vertices.retain(|_| vertices.next().is_some_and(&stays));
        let mut vertices = 0..;
        self.slots.retain(|_| vertices.next().is_some_and(&stays));
    }

    fn mean_at<const N: usize>(&self, vertices: [u32; N]) -> f64 {
        mean(vertices.map(|v| (v, 1.0)), |v| self.at(v))
    }

    /// The circumradius of a triangle, in the sizes at its corners.
    fn radius(&self, vertices: [u32; 3], [p, a, b]: [[f64; 2]; 3]) -> f64 {
        let [a, b] = [a, b].map(|corner| Relative::of(corner, p));
        let third = a.squared + b.squared - 2.0 * a.dot(b);
        // R = |a||b||c| / (2·cross)
        let product = a.squared.sqrt() * b.squared.sqrt() * third.sqrt();
        product / (self.mean_at(vertices) * 2.0 * a.cross(b))
    }
}

impl Refinement<'_> {
    /// From here on the size inside is linear on the triangles that there are now.
    pub(super) fn keep_background(&mut self) {
        let Some(sizes) = &mut self.sizes else { return };
        sizes.background = Background { triangles: self.mesh.triangles.clone(), slot: 0 };
        sizes.slots = vec![0; self.mesh.points.len()];
        for (slot, triangle) in self.mesh.triangles.iter().enumerate() {
            triangle.vertices.iter().for_each(|&v| sizes.slots[v as usize] = slot as u32);
        }
    }

    /// Whether a triangle is larger than the sizes at its corners ask for.
    pub(super) fn is_larger_than_its_size(&self, slot: u32) -> bool {
        self.radius_in_sizes(slot).is_some_and(|radius| radius > LARGEST_RADIUS)
    }

    /// The size over the shortest edge of a triangle that is only too large for it; `None` where
    /// Steiner points are circumcenters, or there are no sizes.
    pub(super) fn size_over_edge(&self, vertices: [u32; 3], trigger: Trigger) -> Option<f64> {
        let sizes = self.sizes.as_ref().filter(|_| trigger.only_size)?;
        let edge = [next(trigger.edge), previous(trigger.edge)].map(|i| vertices[i]);
        let size = mean(edge.map(|v| (v, 1.0)), |v| sizes.at(v));
        (size.is_finite() && self.parameters.steiner != Steiner::Circumcenter).then_some(size)
    }

    /// Whether a triangle is so large for the size there that an angle may be attacked that only
    /// misses the soft target: sizes are a floor of their own (ALGORITHM §6).
    pub(super) fn may_be_improved_for_its_size(&self, slot: u32) -> bool {
        self.radius_in_sizes(slot).is_some_and(|radius| radius >= LEAST_SOFT_RADIUS)
    }

    fn radius_in_sizes(&self, slot: u32) -> Option<f64> {
        let vertices = self.mesh.triangles[slot as usize].vertices;
        self.sizes.as_ref().map(|sizes| sizes.radius(vertices, self.mesh.corners(slot)))
    }

    /// Gives the vertex that was just committed its size.
    pub(super) fn size_new_vertex(&mut self) {
        let Some(mut sizes) = self.sizes.take() else { return };
        let vertex = self.mesh.points.len() as u32 - 1;
        let near = self.cavity.sides().next().map_or(0, |side| side.ends[0] as usize);
        sizes.background.slot = sizes.slots.get(near).map_or(0, |&slot| slot as usize);
        let weights = self.weights(vertex, &mut sizes.background);
        let on_segment = self.provenances.splits_segment(vertex);
        let size = if on_segment { mean(weights, |v| sizes.at(v)) } else { sizes.inside(weights) };
        sizes.of_vertices.push(size);
        sizes.slots.push(sizes.background.slot as u32);
        self.sizes = Some(sizes);
    }
}
