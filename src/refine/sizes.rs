//! Target sizes: how long edges should be, as it is given at the points of the outline.
//!
//! Along a segment the size is linear. Segments are cut to their sizes first; inside, the size is
//! then linear on the triangles between these points ([`interpolation`](super::interpolation)). So
//! it is a fixed function of the place, bounded from below by the smallest size given, and the
//! trigger keeps every promise (ALGORITHM §6).

use std::ops::ControlFlow;

use super::interpolation::{Background, mean};
use super::trace::Cause;
use super::{Flow, Refinement, Watch};
use crate::domain::Domain;
use crate::predicates::Relative;
use crate::triangulation::Edge;

/// A triangle is too large where its circumradius is more than this times the size at its corners.
///
/// Choice: so a mesh of one size has as many triangles as equilateral ones of that edge would be
/// (those have 1/√3), and as many as Gmsh makes: the circumradii end between half of the bound and
/// the bound.
const LARGEST_RADIUS: f64 = 0.78;

/// The least circumradius, in sizes, of a triangle that is attacked for a soft target alone: some
/// half of what sizes leave.
const LEAST_SOFT_RADIUS: f64 = 0.2;

/// A subsegment is too long where it is more than this times the size at its ends: halved again and
/// again, pieces are of the size on average.
const LONGEST_PIECE: f64 = 1.4;

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
    /// The sizes of a domain, if it has any; vertex v of its triangulation, which has `count`, is
    /// `domain_points[v]`, or no point of the domain.
    #[must_use]
    pub fn of(domain: &Domain, domain_points: &[u32], count: usize) -> Option<Self> {
        let size = |&point: &u32| domain.point_sizes[point as usize];
        let none = std::iter::repeat(f64::INFINITY);
        (!domain.point_sizes.is_empty()).then(|| Self {
            of_vertices: domain_points.iter().map(size).chain(none).take(count).collect(),
            background: Background::default(),
            slots: Vec::new(),
        })
    }

    fn mean_at<const N: usize>(&self, vertices: [u32; N]) -> f64 {
        mean(vertices.map(|v| (v, 1.0)), |v| self.of_vertices[v as usize])
    }

    /// The circumradius of a triangle, in the sizes at its corners.
    fn radius(&self, vertices: [u32; 3], [p, a, b]: [[f64; 2]; 3]) -> f64 {
        let [a, b] = [a, b].map(|corner| Relative::of(corner, p));
        let third = a.squared + b.squared - 2.0 * a.dot(b);
        // R = |a||b||c| / (2·cross)
        let product = a.squared.sqrt() * b.squared.sqrt() * third.sqrt();
        product / (self.mean_at(vertices) * 2.0 * a.cross(b))
    }

    fn is_too_long(&self, ends: [u32; 2], [a, b]: [[f64; 2]; 2]) -> bool {
        let longest = LONGEST_PIECE * self.mean_at(ends);
        Relative::of(a, b).squared > longest * longest
    }
}

impl Refinement<'_> {
    /// Cuts every subsegment to its size; what lies between the points that there are then is the
    /// background of the sizes inside.
    pub(super) fn split_what_is_longer_than_its_size(&mut self, watch: &mut Watch) -> Flow {
        if self.sizes.is_none() {
            return ControlFlow::Continue(());
        }
        let edges: Vec<Edge> = self.mesh.constrained_edges().collect();
        let mut pieces: Vec<[u32; 2]> = edges.iter().map(|&edge| self.mesh.ends(edge)).collect();
        while let Some(ends @ [a, b]) = pieces.pop() {
            if self.is_longer_than_its_size(ends) && self.mesh.subsegment(a, b).is_some() {
                self.leave_room()?;
                if self.split(ends, Cause::Size) {
                    let middle = self.mesh.points.len() as u32 - 1;
                    pieces.extend([[a, middle], [middle, b]]);
                }
            }
        }
        self.restore_conformality(watch)?;
        self.keep_background();
        ControlFlow::Continue(())
    }

    /// From here on the size inside is linear on the triangles that there are now.
    pub(super) fn keep_background(&mut self) {
        let Some(sizes) = &mut self.sizes else { return };
        sizes.background = Background { triangles: self.mesh.triangles.clone(), slot: 0 };
        sizes.slots = vec![0; self.mesh.points.len()];
        for (slot, triangle) in self.mesh.triangles.iter().enumerate() {
            triangle.vertices.iter().for_each(|&v| sizes.slots[v as usize] = slot as u32);
        }
    }

    fn is_longer_than_its_size(&self, ends: [u32; 2]) -> bool {
        let corners = ends.map(|v| self.mesh.points[v as usize]);
        self.sizes.as_ref().is_some_and(|sizes| sizes.is_too_long(ends, corners))
    }

    /// Whether a triangle is larger than the sizes at its corners ask for.
    pub(super) fn is_larger_than_its_size(&self, slot: u32) -> bool {
        self.radius_in_sizes(slot).is_some_and(|radius| radius > LARGEST_RADIUS)
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
        let near = self.cavity.boundary[0].ends[0] as usize;
        sizes.background.slot = sizes.slots.get(near).map_or(0, |&slot| slot as usize);
        let weights = self.weights(vertex, &mut sizes.background);
        let size = mean(weights, |v| sizes.of_vertices[v as usize]);
        sizes.of_vertices.push(size);
        sizes.slots.push(sizes.background.slot as u32);
        self.sizes = Some(sizes);
    }
}
