//! The Delaunay triangulation of points, one after the other.
//!
//! While it grows, every edge of the convex hull has a *ghost* triangle behind it, whose third
//! vertex is [`GHOST`], "at infinity": its circumcircle is the half-plane beyond the edge. So a
//! point outside the hull is inserted like any other, and no edge is without a neighbour.

use super::cavity::BoundaryEdge;
use super::{Cavity, Edge, Rejected, Triangle, Triangulation};
use crate::corners::{each, next, previous};
use crate::predicates::{Relative, Side, side};

/// The vertex of ghosts; its coordinates mean nothing.
pub(super) const GHOST: u32 = 0;

/// Which corner of a triangle is the ghost.
#[inline]
pub(super) fn ghost_corner(vertices: [u32; 3]) -> Option<usize> {
    vertices.iter().position(|&v| v == GHOST)
}

/// Triangulates points, then those `around` them, in the given order, each found by a walk from the
/// one before: so they should come along a curve. All are distinct, and the first three are on no
/// line.
///
/// Returns the triangulation, ghosts included: vertex i + 1 is point i. `None` where the first three
/// points are on a line, or a point is there twice.
pub(super) fn delaunay(points: &[[f64; 2]], around: &[[f64; 2]]) -> Option<Triangulation> {
    let (&first, others) = points.split_first_chunk()?;
    let mut growing = Growing::of_triangle(first, points.len() + around.len())?;
    for &point in others.iter().chain(around) {
        growing.insert(point).ok()?;
    }
    Some(growing.mesh)
}

/// A triangulation that grows.
struct Growing {
    mesh: Triangulation,
    cavity: Cavity,
    /// Where the next walk begins.
    last: u32,
}

impl Growing {
    /// One triangle and its three ghosts, with room for `count` points; `None` where it is flat.
    fn of_triangle([a, b, c]: [[f64; 2]; 3], count: usize) -> Option<Self> {
        let vertices = match side(a, b, c) {
            Side::Left => [1, 2, 3],
            Side::Right => [1, 3, 2],
            Side::On => return None,
        };
        let mut triangles = Vec::with_capacity(2 * count + 2);
        triangles.push(Triangle { vertices, neighbors: [1, 2, 3].map(|slot| Edge::new(slot, 0)) });
        for i in 0..3 {
            // The ghost behind edge i, and beside it those that share an end of the edge.
            let [before, after] = [previous(i), next(i)];
            triangles.push(Triangle {
                vertices: [GHOST, vertices[before], vertices[after]],
                neighbors: [
                    Edge::new(0, i),
                    Edge::new(before as u32 + 1, 2),
                    Edge::new(after as u32 + 1, 1),
                ],
            });
        }
        let mut points = Vec::with_capacity(count + 1);
        points.extend([[0.0; 2], a, b, c]);
        let mesh = Triangulation { points, triangles, ..Triangulation::default() };
        Some(Self { mesh, cavity: Cavity::default(), last: 0 })
    }

    fn insert(&mut self, point: [f64; 2]) -> Result<(), Rejected> {
        let root = self.locate(point);
        self.cavity.of_inserted_point(&self.mesh, point, root)?;
        self.mesh.commit(&mut self.cavity);
        self.last = self.cavity.star[0];
        Ok(())
    }

    /// The triangle that holds a point, or a ghost in whose half-plane it lies. A walk through a
    /// Delaunay triangulation that always crosses an edge towards its goal ends.
    fn locate(&self, point: [f64; 2]) -> u32 {
        let mut slot = self.last;
        if let Some(corner) = ghost_corner(self.mesh.triangles[slot as usize].vertices) {
            slot = self.mesh.triangles[slot as usize].neighbors[corner].triangle();
        }
        let triangle = &self.mesh.triangles[slot as usize];
        let seen = each(triangle.vertices, |v| Relative::of(self.mesh.points[v as usize], point));
        let mut edges = (0..3).map(|i| BoundaryEdge::of(triangle, i, seen));
        edges.find(|&edge| self.is_beyond(edge, point)).map_or(slot, |edge| self.walk(edge, point))
    }

    /// Where the walk ends that is about to cross an edge.
    fn walk(&self, mut across: BoundaryEdge, point: [f64; 2]) -> u32 {
        loop {
            let slot = across.behind.triangle();
            let [first, second] = across.beyond(&self.mesh, point);
            let ([a, apex], [_, b]) = (first.ends, second.ends);
            if ghost_corner([a, b, apex]).is_some() {
                return slot;
            }
            across = if self.is_beyond(first, point) {
                first
            } else if self.is_beyond(second, point) {
                second
            } else {
                return slot;
            }
        }
    }

    /// Whether a point lies beyond an edge, which has the triangle that was looked at on its left.
    #[inline(always)]
    fn is_beyond(&self, edge: BoundaryEdge, point: [f64; 2]) -> bool {
        let ([from, to], [seen_from, seen_to]) = (edge.ends, edge.seen);
        self.mesh.is_left([to, from], [seen_to, seen_from], point)
    }
}

/// Whether a point lies in the half-plane of a ghost, whose edge runs from `u` to `w` with the hull
/// on its right; of the edge's line only what is between its ends counts.
pub(super) fn beyond_hull([u, w]: [[f64; 2]; 2], point: [f64; 2]) -> bool {
    match side(u, w, point) {
        Side::Left => true,
        Side::Right => false,
        Side::On => (0..2)
            .any(|k| (u[k] < point[k] && point[k] < w[k]) || (w[k] < point[k] && point[k] < u[k])),
    }
}
