//! Taking a point out that lies on no segment.
//!
//! Its triangles make a polygon. The constrained Delaunay triangulation of that, in its place, is
//! all that changes: no other triangle's circumcircle held the point, and none holds a vertex that
//! the point had hidden, for only segments hide.

use super::{Edge, Triangle, Triangulation};
use crate::corners::next;
use crate::predicates::{Relative, Side, in_circle, side};

/// The triangles around a point and what takes their place: scratch, reused for all.
#[derive(Debug, Clone, Default)]
pub struct Star {
    /// The triangles, counter-clockwise.
    slots: Vec<u32>,
    /// The polygon around them: each vertex, with what is behind the edge to the next one.
    polygon: Vec<(u32, Edge)>,
    /// The triangles of the polygon. A part's base is an edge of a part before it, or of the
    /// polygon.
    parts: Vec<Part>,
}

/// A triangle of the polygon by the places of its vertices: `from < apex < to`.
#[derive(Debug, Clone, Copy)]
struct Part {
    from: usize,
    apex: usize,
    to: usize,
    /// The part on whose edge (1 or 2) this one stands; for the first there is none.
    base: Option<(usize, usize)>,
}

impl Star {
    /// Looks around `vertex`, of which `slot` is a triangle, for how to take it out. `None` where
    /// it is an end of a constrained edge, or where no triangulation is found that is constrained
    /// Delaunay.
    pub fn of(&mut self, mesh: &Triangulation, vertex: u32, slot: u32) -> Option<()> {
        self.slots.clear();
        self.polygon.clear();
        let mut around = slot;
        loop {
            let triangle = mesh.triangles[around as usize];
            let corner = triangle.vertices.iter().position(|&v| v == vertex)?;
            self.slots.push(around);
            self.polygon.push((triangle.vertices[next(corner)], triangle.neighbors[corner]));
            let across = triangle.neighbors[next(corner)];
            if across.is_constrained() {
                return None;
            }
            around = across.triangle();
            if around == slot {
                break;
            }
        }
        self.triangulate(mesh)
    }

    /// The triangles around the point; after [`Triangulation::remove`], those that took their
    /// place.
    #[must_use]
    pub fn slots(&self) -> &[u32] {
        &self.slots
    }

    /// The vertices around the point, counter-clockwise.
    pub fn neighbors(&self) -> impl Iterator<Item = u32> + '_ {
        self.polygon.iter().map(|&(vertex, _)| vertex)
    }

    /// The edges around the point, with what is behind each.
    pub(super) fn link(&self) -> impl Iterator<Item = ([u32; 2], Edge)> + '_ {
        let ends = self.neighbors().skip(1).chain(self.neighbors().take(1));
        self.polygon.iter().zip(ends).map(|(&(start, behind), end)| ([start, end], behind))
    }

    /// Splits the polygon into parts: on each base stands the triangle whose circle holds no other
    /// vertex in front of it. Where a vertex is hidden from the base the result may be wrong; so it
    /// is looked at.
    fn triangulate(&mut self, mesh: &Triangulation) -> Option<()> {
        self.parts.clear();
        let mut at = 0;
        self.add_part(mesh, 0, self.polygon.len() - 1, None)?;
        while let Some(&Part { from, apex, to, .. }) = self.parts.get(at) {
            for (edge, start, end) in [(1, from, apex), (2, apex, to)] {
                if end > start + 1 {
                    self.add_part(mesh, start, end, Some((at, edge)))?;
                }
            }
            at += 1;
        }
        self.is_delaunay(mesh).then_some(())
    }

    fn add_part(
        &mut self,
        mesh: &Triangulation,
        from: usize,
        to: usize,
        base: Option<(usize, usize)>,
    ) -> Option<()> {
        let at = |i: usize| mesh.points[self.polygon[i].0 as usize];
        let (a, b) = (at(from), at(to));
        let mut best: Option<usize> = None;
        for i in from + 1..to {
            if side(b, a, at(i)) != Side::Left {
                continue;
            }
            let is_better = best.is_none_or(|best| holds([b, a, at(best)], at(i)));
            if is_better {
                best = Some(i);
            }
        }
        self.parts.push(Part { from, apex: best?, to, base });
        Some(())
    }

    /// Whether the edges between the parts are locally Delaunay. All parts turn counter-clockwise,
    /// so they fill the polygon.
    fn is_delaunay(&self, mesh: &Triangulation) -> bool {
        let at = |i: usize| mesh.points[self.polygon[i].0 as usize];
        self.parts.iter().all(|part| {
            let Some((parent, edge)) = part.base else { return true };
            let parent = self.parts[parent];
            let beyond = if edge == 1 { parent.to } else { parent.from };
            !holds([part.from, part.apex, part.to].map(at), at(beyond))
        })
    }
}

fn holds(corners: [[f64; 2]; 3], point: [f64; 2]) -> bool {
    in_circle(corners.map(|corner| Relative::of(corner, point)), || corners, point)
}

impl Triangulation {
    /// Takes the point of a star out. Its index stays, without a triangle, and so do two slots,
    /// until [`Triangulation::renumber`].
    pub fn remove(&mut self, star: &mut Star) {
        let region = self.region(star.slots[0]);
        for slot in star.slots.drain(star.parts.len()..) {
            self.set_slot(slot, Triangle::VACANT, 0);
            self.vacant.push(slot);
        }
        for (&Part { from, apex, to, .. }, &slot) in star.parts.iter().zip(&star.slots) {
            let vertices = [apex, to, from].map(|i| star.polygon[i].0);
            self.set_slot(slot, Triangle { vertices, neighbors: [Edge::OUTSIDE; 3] }, region);
        }
        for (&Part { from, apex, to, base }, &slot) in star.parts.iter().zip(&star.slots) {
            match base {
                Some((parent, edge)) => {
                    self.join(Edge::new(slot, 0), Edge::new(star.slots[parent], edge));
                }
                None => self.join(Edge::new(slot, 0), star.polygon[to].1),
            }
            for (edge, start, end) in [(1, from, apex), (2, apex, to)] {
                if end == start + 1 {
                    self.join(Edge::new(slot, edge), star.polygon[start].1);
                }
            }
        }
    }

    /// Makes the edge of a new triangle and what is behind it neighbours.
    fn join(&mut self, edge: Edge, behind: Edge) {
        let slot = edge.triangle();
        self.triangles[slot as usize].neighbors[edge.index()] = behind;
        if !behind.is_outside() {
            self.triangles[behind.triangle() as usize].neighbors[behind.index()] =
                edge.constrained_if(behind.is_constrained());
        }
        if behind.is_constrained() {
            let ends = self.ends(edge);
            self.anchors.set(ends, slot);
        }
    }
}
