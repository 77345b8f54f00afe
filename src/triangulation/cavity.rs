//! What a new point replaces: the one cavity routine for Steiner points and points on segments.
//!
//! The cavity is found depth first over the dual tree, so its boundary comes out
//! counter-clockwise. Nothing changes before [`Triangulation::commit`]: whether the point would
//! encroach a subsegment, or must not be committed at all, is read off the boundary.

use super::insertion::{beyond_hull, ghost_corner};
use super::{Edge, OUTSIDE_THE_REGION, Triangle, Triangulation};
use crate::corners::{each, next, previous};
use crate::predicates::{self, Relative};

/// Why a point is not committed: rounding has the last word there (ALGORITHM §9).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rejected {
    /// It is not strictly inside the circumcircle of the triangle that it is to remove.
    OutsideItsDisc,
    /// Some triangle of its star would not be counter-clockwise.
    Unseen,
    /// The cavity is no polygon of its triangles' vertices.
    Malformed,
}

/// An edge of a cavity's boundary, with the cavity to its left.
#[derive(Debug, Clone, Copy)]
pub struct BoundaryEdge {
    /// Its end points.
    pub ends: [u32; 2],
    /// The same edge in the triangle behind it.
    pub behind: Edge,
    /// Its end points as seen from the new point.
    pub seen: [Relative; 2],
}

impl BoundaryEdge {
    /// Edge `i` of a triangle whose corners are `seen`, with the triangle to its left.
    #[inline(always)]
    pub(super) fn of(triangle: &Triangle, i: usize, seen: [Relative; 3]) -> Self {
        let Triangle { vertices, neighbors } = triangle;
        Self {
            ends: [vertices[next(i)], vertices[previous(i)]],
            behind: neighbors[i],
            seen: [seen[next(i)], seen[previous(i)]],
        }
    }

    /// The other two edges of the triangle behind this one, counter-clockwise, with that triangle to
    /// their left: they meet at its apex. All is seen from `point`.
    #[inline(always)]
    pub(super) fn beyond(self, mesh: &Triangulation, point: [f64; 2]) -> [Self; 2] {
        let ([a, b], [seen_a, seen_b]) = (self.ends, self.seen);
        let (triangle, i) = (&mesh.triangles[self.behind.triangle() as usize], self.behind.index());
        let apex = triangle.vertices[i];
        let seen = Relative::of(mesh.points[apex as usize], point);
        let edge = |ends, at: usize, seen| Self { ends, behind: triangle.neighbors[at], seen };
        [edge([a, apex], next(i), [seen_a, seen]), edge([apex, b], previous(i), [seen, seen_b])]
    }
}

/// Where the two sides of a split subsegment meet in the star of its new point.
#[derive(Debug, Clone, Copy)]
pub(super) enum Joint {
    /// Both sides are meshed: the half subsegment lies between them.
    Inside,
    /// There is nothing behind the half subsegment.
    Boundary,
}

impl Joint {
    /// The link across the half subsegment, where without a joint it would be `neighbor`.
    pub fn link(self, neighbor: Edge) -> Edge {
        match self {
            Self::Inside => neighbor.constrained_if(true),
            Self::Boundary => Edge::OUTSIDE,
        }
    }
}

/// Scratch for one insertion, reused for all.
#[derive(Debug, Clone, Default)]
pub struct Cavity {
    /// The new point.
    pub point: [f64; 2],
    /// The boundary, counter-clockwise.
    pub boundary: Vec<BoundaryEdge>,
    /// The triangles that die; after the commit, the new ones, one per boundary edge.
    pub star: Vec<u32>,
    /// Of a split subsegment: where the second side's boundary starts (its length if there is none).
    second_side: Option<usize>,
    /// Whether any edge of the boundary is constrained.
    is_constrained: bool,
    regions: [u32; 2],
    /// Edges still to be looked across.
    stack: Vec<BoundaryEdge>,
}

impl Cavity {
    /// The cavity of the Steiner point `point`, which lies in the circumcircle of triangle `root`.
    ///
    /// # Errors
    /// [`Rejected::OutsideItsDisc`] and [`Rejected::Malformed`].
    pub fn of_steiner_point(
        &mut self,
        mesh: &Triangulation,
        point: [f64; 2],
        root: u32,
    ) -> Result<(), Rejected> {
        self.clear(point);
        let corners = mesh.corners(root);
        let seen = each(corners, |corner| Relative::of(corner, point));
        if !predicates::in_circle(seen, || corners, point) {
            return Err(Rejected::OutsideItsDisc);
        }
        self.begin_with(mesh, root, seen);
        self.grow(mesh, |seen, vertices| in_circle(mesh, seen, vertices, point))?;
        self.expect_polygon(2)
    }

    /// The cavity of a point to insert into a Delaunay triangulation with ghosts behind its hull;
    /// `root` holds the point, or is a ghost in whose half-plane it lies.
    pub(super) fn of_inserted_point(
        &mut self,
        mesh: &Triangulation,
        point: [f64; 2],
        root: u32,
    ) -> Result<(), Rejected> {
        self.clear(point);
        let seen = each(mesh.corners(root), |corner| Relative::of(corner, point));
        self.begin_with(mesh, root, seen);
        self.grow(mesh, |seen, vertices| match ghost_corner(vertices) {
            None => in_circle(mesh, seen, vertices, point),
            Some(i) => {
                let ends = [vertices[next(i)], vertices[previous(i)]];
                beyond_hull(ends.map(|v| mesh.points[v as usize]), point)
            }
        })?;
        self.expect_polygon(2)
    }

    /// The cavity of a point that splits the subsegment `edge`, on both sides where both are
    /// meshed.
    ///
    /// Points of one segment count as collinear: a triangle with two vertices that are
    /// `on_segment` stays, but for those of the subsegment itself (ALGORITHM §2).
    ///
    /// # Errors
    /// [`Rejected::Malformed`].
    pub fn of_split_point(
        &mut self,
        mesh: &Triangulation,
        point: [f64; 2],
        edge: Edge,
        on_segment: impl Fn(u32) -> bool,
    ) -> Result<(), Rejected> {
        self.clear(point);
        let stays = |vertices: [u32; 3]| vertices.iter().filter(|&&v| on_segment(v)).count() >= 2;
        self.grow_side(mesh, edge, stays)?;
        let second_side = self.boundary.len();
        self.second_side = Some(second_side);
        self.regions = [region(mesh, edge.triangle()); 2];
        let behind = mesh.behind(edge);
        if behind.is_outside() {
            return self.expect_polygon(1);
        }
        self.regions[1] = region(mesh, behind.triangle());
        self.grow_side(mesh, behind, stays)?;
        self.expect_polygon(2)
    }

    /// Takes in the first triangle, whose corners are `seen` from the point.
    fn begin_with(&mut self, mesh: &Triangulation, root: u32, seen: [Relative; 3]) {
        self.star.push(root);
        self.regions = [region(mesh, root); 2];
        for i in [2, 1, 0] {
            self.visit_later(mesh, root, i, seen);
        }
    }

    fn clear(&mut self, point: [f64; 2]) {
        self.point = point;
        self.boundary.clear();
        self.star.clear();
        self.stack.clear();
        self.second_side = None;
        self.is_constrained = false;
    }

    /// Grows from the triangle to the left of `edge`, away from it.
    fn grow_side(
        &mut self,
        mesh: &Triangulation,
        edge: Edge,
        stays: impl Fn([u32; 3]) -> bool,
    ) -> Result<(), Rejected> {
        let (root, point) = (edge.triangle(), self.point);
        let seen = each(mesh.corners(root), |corner| Relative::of(corner, point));
        self.star.push(root);
        self.visit_later(mesh, root, previous(edge.index()), seen);
        self.visit_later(mesh, root, next(edge.index()), seen);
        self.grow(mesh, |seen, vertices| !stays(vertices) && in_circle(mesh, seen, vertices, point))
    }

    fn visit_later(&mut self, mesh: &Triangulation, triangle: u32, i: usize, seen: [Relative; 3]) {
        self.stack.push(BoundaryEdge::of(&mesh.triangles[triangle as usize], i, seen));
    }

    /// Takes in every triangle that `goes` (asked with its corners, as seen and by their numbers)
    /// and that is reached without crossing a subsegment.
    #[inline(always)]
    fn grow(
        &mut self,
        mesh: &Triangulation,
        goes: impl Fn([Relative; 3], [u32; 3]) -> bool,
    ) -> Result<(), Rejected> {
        while let Some(mut side) = self.stack.pop() {
            while let Some([first, second]) = self.edges_beyond(mesh, side, &goes) {
                self.star.push(side.behind.triangle());
                if self.star.len() > mesh.triangles.len() {
                    return Err(Rejected::Malformed);
                }
                self.stack.push(second);
                side = first;
            }
            self.is_constrained |= side.behind.is_constrained();
            self.boundary.push(side);
        }
        Ok(())
    }

    /// The other two edges of the triangle behind `side`, counter-clockwise, if that goes.
    #[inline(always)]
    fn edges_beyond(
        &self,
        mesh: &Triangulation,
        side: BoundaryEdge,
        goes: impl Fn([Relative; 3], [u32; 3]) -> bool,
    ) -> Option<[BoundaryEdge; 2]> {
        if side.behind.is_constrained() {
            return None;
        }
        let [first, second] = side.beyond(mesh, self.point);
        let ([a, b], [seen_a, seen_b]) = (side.ends, side.seen);
        let ([_, apex], [_, seen]) = (first.ends, first.seen);
        goes([seen_b, seen_a, seen], [b, a, apex]).then_some([first, second])
    }

    /// k triangles that share no vertex inside and leave none out have `more` + k edges around
    /// them: anything else is no cavity that a star can fill.
    fn expect_polygon(&self, more: usize) -> Result<(), Rejected> {
        let fits = self.boundary.len() == self.star.len() + more;
        if fits { Ok(()) } else { Err(Rejected::Malformed) }
    }

    /// Whether every triangle of the star would be counter-clockwise.
    ///
    /// # Errors
    /// [`Rejected::Unseen`].
    pub fn expect_visible(&self, mesh: &Triangulation) -> Result<(), Rejected> {
        let visible = self.boundary.iter().all(|side| {
            let ends = || side.ends.map(|v| mesh.points[v as usize]);
            predicates::sees_left(side.seen, ends, self.point)
        });
        if visible { Ok(()) } else { Err(Rejected::Unseen) }
    }

    /// The subsegments on the boundary.
    pub fn subsegments(&self) -> impl Iterator<Item = &BoundaryEdge> + '_ {
        let sides = if self.is_constrained { &self.boundary[..] } else { &[] };
        let sides = sides.iter().enumerate();
        let subsegments = sides.filter(|(i, side)| {
            // With nothing on either side it is an edge of the hull only.
            let is_open = || side.behind.is_outside() && self.region(*i) == OUTSIDE_THE_REGION;
            side.behind.is_constrained() && !is_open()
        });
        subsegments.map(|(_, side)| side)
    }

    /// The subsegments on the boundary that the point encroaches.
    pub fn encroached<'a>(
        &'a self,
        mesh: &'a Triangulation,
    ) -> impl Iterator<Item = &'a BoundaryEdge> + 'a {
        let point = self.point;
        self.subsegments().filter(move |side| {
            let ends = side.ends.map(|v| mesh.points[v as usize]);
            predicates::encroaches(side.seen, ends, point)
        })
    }

    /// The squared distance to the nearest vertex (all nearest ones are on the boundary).
    #[must_use]
    pub fn nearest_squared(&self) -> f64 {
        self.boundary.iter().map(|side| side.seen[0].squared).fold(f64::INFINITY, f64::min)
    }

    /// Whether any edge of the boundary is constrained.
    #[inline]
    pub(super) fn is_constrained(&self) -> bool {
        self.is_constrained
    }

    /// Whether the point splits a subsegment.
    #[inline]
    pub(super) fn is_split(&self) -> bool {
        self.second_side.is_some()
    }

    /// The joint of a split between boundary edge `i − 1` and edge `i`, if there is one.
    pub(super) fn joint_before(&self, i: usize) -> Option<Joint> {
        let second_side = self.second_side?;
        let one_sided = second_side == self.boundary.len();
        if i == 0 || i == self.boundary.len() {
            Some(if one_sided { Joint::Boundary } else { Joint::Inside })
        } else if i == second_side {
            Some(Joint::Inside)
        } else {
            None
        }
    }

    /// The halves of a split subsegment as edges of the new triangles, each once for each side.
    pub fn halves(&self) -> impl Iterator<Item = Edge> + '_ {
        (0..self.boundary.len()).flat_map(move |i| {
            let before = self.joint_before(i).map(|_| Edge::new(self.star[i], 2));
            let after = self.joint_before(i + 1).map(|_| Edge::new(self.star[i], 1));
            before.into_iter().chain(after).map(|edge| edge.constrained_if(true))
        })
    }

    /// The region of the new triangle behind boundary edge `i`.
    #[inline]
    #[must_use]
    pub fn region(&self, i: usize) -> u32 {
        self.regions[usize::from(self.second_side.is_some_and(|second| i >= second))]
    }
}

/// Whether `point` lies strictly in the circle of a triangle of the mesh.
#[inline(always)]
fn in_circle(mesh: &Triangulation, seen: [Relative; 3], vertices: [u32; 3], p: [f64; 2]) -> bool {
    predicates::in_circle(seen, || each(vertices, |v| mesh.points[v as usize]), p)
}

fn region(mesh: &Triangulation, triangle: u32) -> u32 {
    mesh.regions.get(triangle as usize).copied().unwrap_or(0)
}
