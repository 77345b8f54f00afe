//! What a new point replaces: the one cavity routine for Steiner points and points on segments.
//!
//! The cavity is found depth first over the dual tree, so its boundary comes out
//! counter-clockwise. Nothing changes before [`Triangulation::commit`]: whether the point would
//! encroach a subsegment, or must not be committed at all, is read off the boundary.

use super::insertion::{beyond_hull, ghost_corner};
use super::{Edge, OUTSIDE_THE_REGION, Triangle, Triangulation};
use crate::corners::{each, next, previous};
use crate::order::lesser;
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

/// A vertex by its index and as seen from the new point.
#[derive(Debug, Clone, Copy)]
struct Vertex {
    index: u32,
    seen: Relative,
}

/// A corner of a cavity's boundary, where an edge ends and the next one starts.
#[derive(Debug, Clone, Copy)]
struct Corner {
    vertex: u32,
    /// What is behind the edge that ends here.
    behind: Edge,
    seen: Relative,
    /// The cross product of that edge's ends as seen from the point.
    cross: f64,
}

/// An edge that a growing cavity has come to, which starts where its boundary ends so far.
#[derive(Debug, Clone, Copy)]
struct Front {
    end: Vertex,
    behind: Edge,
    /// The cross product of its ends.
    cross: f64,
    /// Whether the triangle behind it goes.
    goes: bool,
    /// If so, the vertex opposite there.
    apex: Vertex,
    /// The cross products of the edge's start and the apex, and of the apex and the edge's end.
    crosses: [f64; 2],
}

/// A triangle that may go, as seen from the new point.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    corners: [Vertex; 3],
    /// Opposite each corner, the cross product of the other two.
    crosses: [f64; 3],
}

impl Candidate {
    #[inline(always)]
    fn of(corners: [Vertex; 3]) -> Self {
        let [a, b, c] = each(corners, |corner| corner.seen);
        Self { corners, crosses: [b.cross(c), c.cross(a), a.cross(b)] }
    }

    #[inline(always)]
    fn vertices(&self) -> [u32; 3] {
        each(self.corners, |corner| corner.index)
    }
}

/// Which triangles a cavity takes in.
trait Rule {
    /// Whether a triangle goes.
    fn goes(&self, mesh: &Triangulation, candidate: Candidate, point: [f64; 2]) -> bool;
}

/// Those whose circumcircle holds the point.
struct Delaunay;

impl Rule for Delaunay {
    #[inline(always)]
    fn goes(&self, mesh: &Triangulation, candidate: Candidate, point: [f64; 2]) -> bool {
        let squared = each(candidate.corners, |corner| corner.seen.squared);
        match predicates::surely_in_circle(squared, candidate.crosses) {
            Some(is_inside) => is_inside,
            None => mesh.is_in_circle(candidate.vertices(), point),
        }
    }
}

/// The same, where ghosts stand behind the hull: their circumcircle is the half-plane beyond.
struct WithGhosts;

impl Rule for WithGhosts {
    #[inline(always)]
    fn goes(&self, mesh: &Triangulation, candidate: Candidate, point: [f64; 2]) -> bool {
        let vertices = candidate.vertices();
        match ghost_corner(vertices) {
            None => Delaunay.goes(mesh, candidate, point),
            Some(i) => {
                let ends = [vertices[next(i)], vertices[previous(i)]];
                beyond_hull(ends.map(|v| mesh.points[v as usize]), point)
            }
        }
    }
}

/// The same, but triangles stay that have two corners on the segment that is split.
struct BesideSegment<F>(F);

impl<F: Fn(u32) -> bool> Rule for BesideSegment<F> {
    #[inline(always)]
    fn goes(&self, mesh: &Triangulation, candidate: Candidate, point: [f64; 2]) -> bool {
        Delaunay.goes(mesh, candidate, point)
            && candidate.corners.iter().filter(|corner| self.0(corner.index)).count() < 2
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
    /// The boundary, counter-clockwise; the first corner is where its first edge starts.
    boundary: Vec<Corner>,
    /// The triangles that die; after the commit, the new ones, one per boundary edge.
    pub star: Vec<u32>,
    /// Of a split subsegment: where the second side's boundary starts (its length if there is none).
    second_side: Option<usize>,
    /// Whether any edge of the boundary is constrained.
    is_constrained: bool,
    /// Whether the point surely lies to the left of every edge of the boundary, rounding or not.
    is_surely_seen: bool,
    /// The squared distance to the nearest corner of the boundary.
    nearest_squared: f64,
    regions: [u32; 2],
    /// Edges still to be followed.
    fronts: Vec<Front>,
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
        let corners = each(mesh.triangles[root as usize].vertices, |v| self.vertex(mesh, v));
        if !Delaunay.goes(mesh, Candidate::of(corners), point) {
            return Err(Rejected::OutsideItsDisc);
        }
        self.regions = [mesh.region(root); 2];
        self.grow(mesh, root, [0, 1, 2], &Delaunay)?;
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
        self.grow(mesh, root, [0, 1, 2], &WithGhosts)?;
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
        let rule = BesideSegment(on_segment);
        let beside = |edge: Edge| [next(edge.index()), previous(edge.index())];
        self.grow(mesh, edge.triangle(), beside(edge), &rule)?;
        self.second_side = Some(self.size());
        self.regions = [mesh.region(edge.triangle()); 2];
        let behind = mesh.behind(edge);
        if behind.is_outside() {
            return self.expect_polygon(1);
        }
        self.regions[1] = mesh.region(behind.triangle());
        self.grow(mesh, behind.triangle(), beside(behind), &rule)?;
        self.expect_polygon(2)
    }

    fn clear(&mut self, point: [f64; 2]) {
        self.point = point;
        self.boundary.clear();
        self.star.clear();
        self.fronts.clear();
        self.second_side = None;
        self.is_constrained = false;
        self.is_surely_seen = true;
        self.nearest_squared = f64::INFINITY;
    }

    /// Takes in the first triangle on a side: the boundary is to go along these edges of it. Returns
    /// the vertex where it starts.
    #[inline(always)]
    fn take_root<const N: usize>(
        &mut self,
        mesh: &Triangulation,
        root: u32,
        edges: [usize; N],
        rule: &impl Rule,
    ) -> Vertex {
        let triangle = &mesh.triangles[root as usize];
        let corners = each(triangle.vertices, |v| self.vertex(mesh, v));
        let Candidate { crosses, .. } = Candidate::of(corners);
        let start = corners[next(edges[0])];
        if self.boundary.is_empty() {
            self.nearest_squared = start.seen.squared;
            let (vertex, behind, seen) = (start.index, Edge::OUTSIDE, start.seen);
            self.boundary.push(Corner { vertex, behind, seen, cross: 0.0 });
        }
        self.star.push(root);
        for i in edges.into_iter().rev() {
            let ends = [corners[next(i)], corners[previous(i)]];
            let behind = triangle.neighbors[i];
            let apex = self.apex_behind(mesh, behind);
            self.fronts.push(self.front(mesh, ends, crosses[i], behind, apex, rule));
        }
        start
    }

    /// Takes in every triangle that goes by the rule and that is reached without crossing a
    /// subsegment.
    ///
    /// What is behind both edges of a triangle that goes is looked at together: so the one need not
    /// wait for the other.
    #[inline(always)]
    fn grow<const N: usize>(
        &mut self,
        mesh: &Triangulation,
        root: u32,
        edges: [usize; N],
        rule: &impl Rule,
    ) -> Result<(), Rejected> {
        let mut start = self.take_root(mesh, root, edges, rule);
        while let Some(mut front) = self.fronts.pop() {
            while front.goes {
                let Front { end, behind, apex, crosses, .. } = front;
                self.star.push(behind.triangle());
                if self.star.len() > mesh.triangles.len() {
                    return Err(Rejected::Malformed);
                }
                let neighbors = &mesh.triangles[behind.triangle() as usize].neighbors;
                let (i, j) = (next(behind.index()), previous(behind.index()));
                let [before, after] = [neighbors[i], neighbors[j]];
                let apices = [self.apex_behind(mesh, before), self.apex_behind(mesh, after)];
                let second = self.front(mesh, [apex, end], crosses[1], after, apices[1], rule);
                front = self.front(mesh, [start, apex], crosses[0], before, apices[0], rule);
                self.fronts.push(second);
            }
            let Front { end, behind, cross, .. } = front;
            self.is_constrained |= behind.is_constrained();
            self.is_surely_seen &= predicates::is_surely_left(cross, [start.seen, end.seen]);
            self.nearest_squared = lesser(self.nearest_squared, end.seen.squared);
            self.boundary.push(Corner { vertex: end.index, behind, seen: end.seen, cross });
            start = end;
        }
        Ok(())
    }

    /// The edge between two vertices, by what is behind it and the vertex opposite there; and whether
    /// that triangle goes.
    #[inline(always)]
    fn front(
        &self,
        mesh: &Triangulation,
        [start, end]: [Vertex; 2],
        cross: f64,
        behind: Edge,
        apex: Option<Vertex>,
        rule: &impl Rule,
    ) -> Front {
        let Some(apex) = apex else {
            return Front { end, behind, cross, goes: false, apex: end, crosses: [0.0; 2] };
        };
        let crosses = [start.seen.cross(apex.seen), apex.seen.cross(end.seen)];
        let corners = [end, start, apex];
        let candidate = Candidate { corners, crosses: [crosses[0], crosses[1], -cross] };
        let goes = rule.goes(mesh, candidate, self.point);
        Front { end, behind, cross, goes, apex, crosses }
    }

    /// The vertex opposite in the triangle behind, if the edge may be crossed.
    #[inline(always)]
    fn apex_behind(&self, mesh: &Triangulation, behind: Edge) -> Option<Vertex> {
        (!behind.is_constrained()).then(|| self.vertex(mesh, mesh.apex(behind)))
    }

    #[inline(always)]
    fn vertex(&self, mesh: &Triangulation, index: u32) -> Vertex {
        Vertex { index, seen: Relative::of(mesh.points[index as usize], self.point) }
    }

    /// k triangles that share no vertex inside and leave none out have `more` + k edges around
    /// them: anything else is no cavity that a star can fill.
    fn expect_polygon(&self, more: usize) -> Result<(), Rejected> {
        let fits = self.size() == self.star.len() + more;
        if fits { Ok(()) } else { Err(Rejected::Malformed) }
    }

    /// Whether every triangle of the star would be counter-clockwise.
    ///
    /// # Errors
    /// [`Rejected::Unseen`].
    pub fn expect_visible(&self, mesh: &Triangulation) -> Result<(), Rejected> {
        let sees = |side: BoundaryEdge| mesh.is_left(side.ends, side.seen, self.point);
        if self.is_surely_seen || self.sides().all(sees) { Ok(()) } else { Err(Rejected::Unseen) }
    }

    /// How many edges the boundary has.
    #[must_use]
    pub fn size(&self) -> usize {
        self.boundary.len().saturating_sub(1)
    }

    /// The edges of the boundary, counter-clockwise.
    pub fn sides(&self) -> impl ExactSizeIterator<Item = BoundaryEdge> + '_ {
        self.boundary.windows(2).map(side)
    }

    /// Edge `i` of the boundary.
    #[inline]
    #[must_use]
    pub fn side(&self, i: usize) -> BoundaryEdge {
        side(&self.boundary[i..i + 2])
    }

    /// The cross product of the ends of edge `i` of the boundary as seen from the point: twice the area
    /// of the new triangle there.
    #[inline]
    #[must_use]
    pub fn cross(&self, i: usize) -> f64 {
        self.boundary[i + 1].cross
    }

    /// The subsegments on the boundary.
    pub fn subsegments(&self) -> impl Iterator<Item = BoundaryEdge> + '_ {
        let sides = self.is_constrained.then(|| self.sides().enumerate());
        let subsegments = sides.into_iter().flatten().filter(|(i, side)| {
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
    ) -> impl Iterator<Item = BoundaryEdge> + 'a {
        let point = self.point;
        self.subsegments().filter(move |side| {
            let ends = side.ends.map(|v| mesh.points[v as usize]);
            predicates::encroaches(side.seen, ends, point)
        })
    }

    /// The squared distance to the nearest vertex (all nearest ones are on the boundary).
    #[inline]
    #[must_use]
    pub fn nearest_squared(&self) -> f64 {
        self.nearest_squared
    }

    /// Whether any edge of the boundary is constrained.
    #[inline]
    #[must_use]
    pub fn is_constrained(&self) -> bool {
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
        let count = self.size();
        let one_sided = second_side == count;
        if i == 0 || i == count {
            Some(if one_sided { Joint::Boundary } else { Joint::Inside })
        } else if i == second_side {
            Some(Joint::Inside)
        } else {
            None
        }
    }

    /// The halves of a split subsegment as edges of the new triangles, each once for each side.
    pub fn halves(&self) -> impl Iterator<Item = Edge> + '_ {
        (0..self.size()).flat_map(move |i| {
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

/// The edge between two successive corners of a boundary.
#[inline(always)]
fn side(ends: &[Corner]) -> BoundaryEdge {
    BoundaryEdge {
        ends: [ends[0].vertex, ends[1].vertex],
        behind: ends[1].behind,
        seen: [ends[0].seen, ends[1].seen],
    }
}
