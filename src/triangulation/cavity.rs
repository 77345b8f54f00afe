//! What a new point replaces: the one cavity routine for Steiner points and points on segments.
//!
//! The cavity is found depth first over the dual tree, so its boundary comes out
//! counter-clockwise. Nothing changes before [`Triangulation::commit`]: whether the point would
//! encroach a subsegment, or must not be committed at all, is read off the boundary.

use super::insertion::{beyond_hull, ghost_corner};
use super::{Edge, OUTSIDE_THE_REGION, Triangulation};
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
    regions: [u32; 2],
    stack: Vec<Visit>,
}

/// An edge still to be looked across.
#[derive(Debug, Clone, Copy)]
struct Visit {
    edge: Edge,
    seen: [Relative; 2],
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
        if !predicates::in_circle(seen, corners, point) {
            return Err(Rejected::OutsideItsDisc);
        }
        self.begin_with(mesh, root, seen);
        self.grow(mesh, |_| true, in_circle)?;
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
        self.grow(
            mesh,
            |_| true,
            |seen, corners, point, vertices| match ghost_corner(vertices) {
                None => predicates::in_circle(seen, corners, point),
                Some(i) => beyond_hull([corners[next(i)], corners[previous(i)]], point),
            },
        )?;
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
            self.visit_later(root, i, seen);
        }
    }

    fn clear(&mut self, point: [f64; 2]) {
        self.point = point;
        self.boundary.clear();
        self.star.clear();
        self.stack.clear();
        self.second_side = None;
    }

    /// Grows from the triangle to the left of `edge`, away from it.
    fn grow_side(
        &mut self,
        mesh: &Triangulation,
        edge: Edge,
        stays: impl Fn([u32; 3]) -> bool,
    ) -> Result<(), Rejected> {
        let root = edge.triangle();
        let seen = each(mesh.corners(root), |corner| Relative::of(corner, self.point));
        self.star.push(root);
        self.visit_later(root, previous(edge.index()), seen);
        self.visit_later(root, next(edge.index()), seen);
        self.grow(mesh, |vertices| !stays(vertices), in_circle)
    }

    fn visit_later(&mut self, triangle: u32, i: usize, seen: [Relative; 3]) {
        let seen = [seen[next(i)], seen[previous(i)]];
        self.stack.push(Visit { edge: Edge::new(triangle, i), seen });
    }

    /// Takes in every triangle that may go, whose circumcircle strictly holds the point and that is
    /// reached without crossing a subsegment.
    fn grow(
        &mut self,
        mesh: &Triangulation,
        may_go: impl Fn([u32; 3]) -> bool,
        holds: impl Fn([Relative; 3], [[f64; 2]; 3], [f64; 2], [u32; 3]) -> bool,
    ) -> Result<(), Rejected> {
        while let Some(Visit { edge, seen }) = self.stack.pop() {
            let behind = mesh.behind(edge);
            if !behind.is_constrained() {
                let triangle = mesh.triangles[behind.triangle() as usize];
                let corners = each(triangle.vertices, |v| mesh.points[v as usize]);
                let apex = Relative::of(corners[behind.index()], self.point);
                let mut all = [apex; 3];
                all[next(behind.index())] = seen[1];
                all[previous(behind.index())] = seen[0];
                if may_go(triangle.vertices) && holds(all, corners, self.point, triangle.vertices) {
                    self.star.push(behind.triangle());
                    self.visit_later(behind.triangle(), previous(behind.index()), all);
                    self.visit_later(behind.triangle(), next(behind.index()), all);
                    if self.star.len() > mesh.triangles.len() {
                        return Err(Rejected::Malformed);
                    }
                    continue;
                }
            }
            self.boundary.push(BoundaryEdge { ends: mesh.ends(edge), behind, seen });
        }
        Ok(())
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
            let [a, b] = side.ends;
            let ends = [mesh.points[a as usize], mesh.points[b as usize]];
            predicates::sees_left(side.seen, ends, self.point)
        });
        if visible { Ok(()) } else { Err(Rejected::Unseen) }
    }

    /// The subsegments on the boundary.
    pub fn subsegments(&self) -> impl Iterator<Item = &BoundaryEdge> + '_ {
        let sides = self.boundary.iter().enumerate();
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

fn in_circle(seen: [Relative; 3], corners: [[f64; 2]; 3], p: [f64; 2], _: [u32; 3]) -> bool {
    predicates::in_circle(seen, corners, p)
}

fn region(mesh: &Triangulation, triangle: u32) -> u32 {
    mesh.regions.get(triangle as usize).copied().unwrap_or(0)
}
