//! The mesh kernel: a constrained Delaunay triangulation that grows point by point.
//!
//! Laid out for speed: 24 bytes a triangle, slots reused in place, no allocation per triangle.
//! [`cavity`] finds what a new point replaces, [`Triangulation::commit`] is the one place that
//! changes the mesh, [`initial`] makes the first triangulation.

pub mod cavity;
mod constraints;
pub mod initial;
mod insertion;
mod journal;
mod removal;
mod renumbering;
mod subsegments;

pub use cavity::{Cavity, Rejected};
pub use journal::Journal;
pub use removal::Star;
pub use renumbering::Renumbering;
use subsegments::Anchors;

use crate::corners::{each, next, previous};
use crate::predicates::{self, Relative};

/// A triangle's edge, with whether it may be crossed:
/// `triangle << 3 | constrained << 2 | edge`; edge `i` is opposite vertex `i`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge(u32);

impl Edge {
    /// What lies beyond an edge with no triangle behind it: all ones, so it counts as constrained.
    pub const OUTSIDE: Self = Self(u32::MAX);

    /// The edge opposite vertex `edge` of the triangle in slot `triangle`, free to be crossed.
    #[inline]
    #[must_use]
    pub fn new(triangle: u32, edge: usize) -> Self {
        Self(triangle << 3 | edge as u32)
    }

    /// The same edge with its constraint set or not.
    #[inline]
    #[must_use]
    pub fn constrained_if(self, constrained: bool) -> Self {
        Self(self.0 & !4 | u32::from(constrained) << 2)
    }

    /// Whether the edge is a subsegment, or has nothing behind it.
    #[inline]
    #[must_use]
    pub fn is_constrained(self) -> bool {
        self.0 & 4 != 0
    }

    /// Whether there is no triangle.
    #[inline]
    #[must_use]
    pub fn is_outside(self) -> bool {
        self == Self::OUTSIDE
    }

    /// The slot of the triangle.
    #[inline]
    #[must_use]
    pub fn triangle(self) -> u32 {
        self.0 >> 3
    }

    /// Which edge of the triangle: 0, 1 or 2.
    #[inline]
    #[must_use]
    pub fn index(self) -> usize {
        (self.0 & 3) as usize
    }
}

/// A triangle: its vertices counter-clockwise, and what is behind the edge opposite each.
/// Vertex 0 of a triangle made by a committed point is that point, so that a stale reference to a
/// reused slot shows by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Triangle {
    /// Vertices, counter-clockwise.
    pub vertices: [u32; 3],
    /// The neighbour's own edge behind each edge; the constraint bit is that of the shared edge.
    pub neighbors: [Edge; 3],
}

impl Triangle {
    /// What stands in a slot that no triangle has.
    pub const VACANT: Self = Self { vertices: [u32::MAX; 3], neighbors: [Edge::OUTSIDE; 3] };
}

/// A constrained Delaunay triangulation of a region: each interior edge that is no subsegment is
/// locally Delaunay, exactly.
#[derive(Debug, Clone, Default)]
pub struct Triangulation {
    /// Vertices; those of the domain come first, along a Hilbert curve.
    pub points: Vec<[f64; 2]>,
    /// All triangles; there is no free slot, but where points are taken out ([`Star`]) and until
    /// [`Triangulation::renumber`].
    pub triangles: Vec<Triangle>,
    /// The region of each triangle (0: none); empty where there is no region.
    pub regions: Vec<u32>,
    anchors: Anchors,
    /// Slots that no triangle has; the last one is taken first.
    vacant: Vec<u32>,
}

/// The region of a triangle that is not meshed: it only takes part, until it is taken out.
pub const OUTSIDE_THE_REGION: u32 = u32::MAX;

impl Triangulation {
    /// A triangulation of `points` by triangles that are linked already.
    #[must_use]
    pub fn new(points: Vec<[f64; 2]>, triangles: Vec<Triangle>, regions: Vec<u32>) -> Self {
        let mut made = Self { points, triangles, regions, ..Self::default() };
        made.anchors = Anchors::of(&made);
        made
    }

    /// The region of a triangle; 0 where there is none.
    #[inline]
    #[must_use]
    pub fn region(&self, triangle: u32) -> u32 {
        self.regions.get(triangle as usize).copied().unwrap_or(0)
    }

    /// Whether a triangle is not meshed, but there all the same.
    #[inline]
    #[must_use]
    pub fn is_outside_the_region(&self, triangle: u32) -> bool {
        self.regions.get(triangle as usize) == Some(&OUTSIDE_THE_REGION)
    }

    /// Whether the triangle in a slot is still the one whose vertex 0, its newest, is this.
    #[inline]
    #[must_use]
    pub fn has(&self, triangle: u32, newest: u32) -> bool {
        self.triangles[triangle as usize].vertices[0] == newest
    }

    /// The coordinates of a triangle's vertices.
    #[inline]
    #[must_use]
    pub fn corners(&self, triangle: u32) -> [[f64; 2]; 3] {
        each(self.triangles[triangle as usize].vertices, |v| self.points[v as usize])
    }

    /// The end points of an edge, with its triangle to the left.
    #[inline]
    #[must_use]
    pub fn ends(&self, edge: Edge) -> [u32; 2] {
        let vertices = self.triangles[edge.triangle() as usize].vertices;
        [vertices[next(edge.index())], vertices[previous(edge.index())]]
    }

    /// What is behind an edge: the same edge in the neighbour.
    #[inline]
    #[must_use]
    pub fn behind(&self, edge: Edge) -> Edge {
        self.triangles[edge.triangle() as usize].neighbors[edge.index()]
    }

    /// The vertex opposite an edge.
    #[inline]
    #[must_use]
    pub fn apex(&self, edge: Edge) -> u32 {
        self.triangles[edge.triangle() as usize].vertices[edge.index()]
    }

    /// Whether a point lies strictly in the circle of three vertices, exactly.
    #[cold]
    #[inline(never)]
    fn is_in_circle(&self, vertices: [u32; 3], point: [f64; 2]) -> bool {
        predicates::in_circle_exactly(vertices.map(|v| self.points[v as usize]), point)
    }

    /// Whether the point from which two vertices are `seen` lies strictly to the left of the line
    /// from the first to the second.
    #[inline(always)]
    fn is_left(&self, vertices: [u32; 2], seen: [Relative; 2], point: [f64; 2]) -> bool {
        match predicates::surely_left(seen) {
            Some(is_left) => is_left,
            None => predicates::left_exactly(vertices.map(|v| self.points[v as usize]), point),
        }
    }

    /// Every subsegment, once for each triangle that has it, by slots. (Most triangles have none, and
    /// are told by one question. What is heard by `for_each` comes faster than by a loop.)
    pub fn constrained_edges(&self) -> impl Iterator<Item = Edge> + '_ {
        let has_any = |(_, triangle): &(u32, &Triangle)| {
            let [a, b, c] = each(triangle.neighbors, Edge::is_constrained);
            a | b | c
        };
        let triangles = (0..).zip(&self.triangles).filter(has_any);
        triangles.flat_map(move |(slot, triangle)| {
            let is_constrained = move |&i: &usize| {
                let behind = triangle.neighbors[i];
                // With nothing on either side it is an edge of the hull only.
                let is_open = || behind.is_outside() && self.is_outside_the_region(slot);
                behind.is_constrained() && !is_open()
            };
            let edges = (0..3).filter(is_constrained);
            edges.map(move |i| Edge::new(slot, i).constrained_if(true))
        })
    }

    /// Puts the new point of `cavity` in and returns its index. The new triangles are
    /// [`Cavity::star`], in the order of [`Cavity::sides`].
    ///
    /// k triangles die and at most k + 2 are born: they take the slots of the dead, then new ones.
    pub fn commit(&mut self, cavity: &mut Cavity) -> u32 {
        let vertex = self.points.len() as u32;
        self.points.push(cavity.point);
        self.claim_slots(cavity);
        self.link_star(vertex, cavity);
        self.anchors.renew(vertex, cavity);
        vertex
    }

    /// Makes `cavity.star` the slots of the new triangles, one for each edge of its boundary.
    fn claim_slots(&mut self, cavity: &mut Cavity) {
        while cavity.star.len() < cavity.size() {
            let slot = self.vacant.pop().unwrap_or_else(|| self.new_slot());
            cavity.star.push(slot);
        }
    }

    fn new_slot(&mut self) -> u32 {
        self.triangles.push(Triangle::VACANT);
        if !self.regions.is_empty() {
            self.regions.push(0);
        }
        self.triangles.len() as u32 - 1
    }

    /// Joins every boundary edge to the new vertex. The boundary runs counter-clockwise, so a
    /// triangle's neighbours in the star are the ones before and after it; where a subsegment was
    /// split its halves are the constrained edges at the joints of the two sides.
    fn link_star(&mut self, vertex: u32, cavity: &Cavity) {
        let star = &cavity.star[..cavity.size()];
        let (Some(&first), Some(&last)) = (star.first(), star.last()) else { return };
        let (mut before, mut slot) = (last, first);
        for (i, side) in cavity.sides().enumerate() {
            let after = star.get(i + 1).copied().unwrap_or(first);
            let mut neighbors = [side.behind, Edge::new(after, 2), Edge::new(before, 1)];
            if cavity.is_split() {
                neighbors[1] =
                    cavity.joint_before(i + 1).map_or(neighbors[1], |j| j.link(neighbors[1]));
                neighbors[2] =
                    cavity.joint_before(i).map_or(neighbors[2], |j| j.link(neighbors[2]));
            }
            let [a, b] = side.ends;
            self.triangles[slot as usize] = Triangle { vertices: [vertex, a, b], neighbors };
            if !side.behind.is_outside() {
                self.triangles[side.behind.triangle() as usize].neighbors[side.behind.index()] =
                    Edge::new(slot, 0).constrained_if(side.behind.is_constrained());
            }
            (before, slot) = (slot, after);
        }
        if !self.regions.is_empty() {
            for (i, &slot) in star.iter().enumerate() {
                self.regions[slot as usize] = cavity.region(i);
            }
        }
    }
}
