//! Finding a subsegment by its end points, without a map.

use super::{Cavity, Edge, Triangulation};
use crate::corners::{next, previous};

/// For each vertex on a subsegment, one triangle that has a constrained edge at it.
#[derive(Debug, Clone, Default)]
pub(super) struct Anchors {
    /// A slot for each vertex; `u32::MAX` for a vertex on no subsegment.
    slots: Vec<u32>,
    /// Vertices at which the region falls into several fans, which no walk around the vertex joins.
    /// Only vertices of the outline can be pinched.
    pinched: Vec<bool>,
    /// The triangle of each subsegment with two pinched ends, sorted by them (smaller index first).
    pinched_edges: Vec<([u32; 2], u32)>,
}

impl Anchors {
    /// The anchors of a triangulation that was just made.
    pub fn of(triangulation: &Triangulation) -> Self {
        let count = triangulation.points.len();
        let pinched = pinched_vertices(triangulation);
        let mut made = Self { slots: vec![u32::MAX; count], pinched, pinched_edges: Vec::new() };
        for edge in triangulation.constrained_edges() {
            let ends = triangulation.ends(edge);
            if ends.iter().all(|&v| made.pinched[v as usize]) {
                made.pinched_edges.push((sorted(ends), edge.triangle()));
            }
            made.slots[ends[0] as usize] = edge.triangle();
            made.slots[ends[1] as usize] = edge.triangle();
        }
        made.pinched_edges.sort_unstable();
        made.pinched_edges.dedup_by_key(|entry| entry.0);
        made
    }

    /// Every constrained edge of a star renews the anchors of its ends. A triangle that dies with
    /// a constrained edge leaves that edge on the cavity's boundary, or its halves at the joints:
    /// so an anchor never dangles.
    pub fn renew(&mut self, vertex: u32, cavity: &Cavity) {
        self.slots.push(u32::MAX);
        for (i, side) in cavity.boundary.iter().enumerate() {
            if side.behind.is_constrained() {
                self.set(side.ends, cavity.star[i]);
            }
            if cavity.joint_before(i).is_some() {
                self.set([vertex, side.ends[0]], cavity.star[i]);
            }
            if cavity.joint_before(i + 1).is_some() {
                self.set([vertex, side.ends[1]], cavity.star[i]);
            }
        }
    }

    #[inline]
    fn set(&mut self, ends: [u32; 2], slot: u32) {
        self.slots[ends[0] as usize] = slot;
        self.slots[ends[1] as usize] = slot;
        if !self.pinched_edges.is_empty()
            && let Ok(at) = self.pinched_edges.binary_search_by_key(&sorted(ends), |e| e.0)
        {
            self.pinched_edges[at].1 = slot;
        }
    }

    #[inline]
    fn is_pinched(&self, vertex: u32) -> bool {
        self.pinched.get(vertex as usize).copied().unwrap_or(false)
    }
}

impl Triangulation {
    /// The subsegment between `a` and `b`, as the edge of a triangle; `None` if it is none (any
    /// more).
    #[must_use]
    pub fn subsegment(&self, a: u32, b: u32) -> Option<Edge> {
        if !self.anchors.is_pinched(a) {
            self.subsegment_around(a, b)
        } else if !self.anchors.is_pinched(b) {
            self.subsegment_around(b, a)
        } else {
            let table = &self.anchors.pinched_edges;
            let found = table.binary_search_by_key(&sorted([a, b]), |entry| entry.0).ok()?;
            self.constrained_edge_of(table[found].1, a, b)
        }
    }

    /// Walks around `a`, which has one fan of triangles, until it meets `b`.
    fn subsegment_around(&self, a: u32, b: u32) -> Option<Edge> {
        let start = self.anchors.slots[a as usize];
        // Counter-clockwise to the start again or to the outside, then clockwise.
        for step in [next, previous] {
            let mut slot = start;
            loop {
                if let Some(edge) = self.constrained_edge_of(slot, a, b) {
                    return Some(edge);
                }
                let triangle = self.triangles.get(slot as usize)?;
                let corner = triangle.vertices.iter().position(|&v| v == a)?;
                let across = triangle.neighbors[step(corner)];
                if across.is_outside() {
                    break;
                }
                slot = across.triangle();
                if slot == start {
                    return None;
                }
            }
        }
        None
    }

    /// The constrained edge between `a` and `b` of one triangle, if it has it.
    fn constrained_edge_of(&self, slot: u32, a: u32, b: u32) -> Option<Edge> {
        let triangle = self.triangles.get(slot as usize)?;
        let index = (0..3).find(|&i| {
            let ends = [triangle.vertices[next(i)], triangle.vertices[previous(i)]];
            triangle.neighbors[i].is_constrained() && (ends == [a, b] || ends == [b, a])
        })?;
        Some(Edge::new(slot, index).constrained_if(true))
    }
}

/// A fan that is no whole turn has one edge with nothing behind it that starts at its vertex: two
/// of those make a pinched vertex.
fn pinched_vertices(triangulation: &Triangulation) -> Vec<bool> {
    let mut pinched = vec![false; triangulation.points.len()];
    let mut open = pinched.clone();
    for edge in triangulation.constrained_edges() {
        if triangulation.behind(edge).is_outside() {
            let start = triangulation.ends(edge)[0] as usize;
            pinched[start] |= open[start];
            open[start] = true;
        }
    }
    pinched
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
