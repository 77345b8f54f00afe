//! Finding a subsegment by its end points, without a map.

use super::{Cavity, Edge, Triangulation};
use crate::corners::{next, previous};
use crate::memory::give_back;
use crate::ranked_set::RankedSet;

/// For each vertex on a subsegment, one triangle that has a constrained edge at it.
#[derive(Debug, Clone, Default)]
pub(super) struct Anchors {
    /// The vertices on subsegments.
    vertices: RankedSet,
    /// A slot for each of them.
    slots: Vec<u32>,
    /// Vertices at which the region falls into several fans, which no walk around the vertex joins;
    /// empty where there is none. Only vertices of the outline can be pinched.
    pinched: Vec<bool>,
    /// The triangle of each subsegment with two pinched ends, sorted by them (smaller index first).
    pinched_edges: Vec<([u32; 2], u32)>,
}

/// What the anchors say about one edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Anchored {
    ends: [u32; 2],
    slots: [u32; 2],
    pinched: Option<(usize, u32)>,
}

impl Anchors {
    /// The anchors of a triangulation that was just made.
    pub fn of(triangulation: &Triangulation) -> Self {
        let none = || vec![false; triangulation.points.len()];
        // A fan that is no whole turn has one edge with nothing behind it that starts at its vertex: two
        // of those make a pinched vertex.
        let (mut on_subsegments, mut open, mut pinched) = (none(), none(), none());
        let mut edges = Vec::new();
        triangulation.constrained_edges().for_each(|edge| {
            edges.push(edge);
            let ends = triangulation.ends(edge);
            ends.iter().for_each(|&v| on_subsegments[v as usize] = true);
            if triangulation.behind(edge).is_outside() {
                let start = ends[0] as usize;
                pinched[start] |= open[start];
                open[start] = true;
            }
        });
        if !pinched.contains(&true) {
            pinched = Vec::new();
        }
        let vertices: RankedSet = on_subsegments.into_iter().collect();
        let slots = vec![u32::MAX; vertices.members()];
        let mut made = Self { vertices, slots, pinched, pinched_edges: Vec::new() };
        for &edge in &edges {
            let ends = triangulation.ends(edge);
            if ends.iter().all(|&v| made.is_pinched(v)) {
                made.pinched_edges.push((sorted(ends), edge.triangle()));
            }
            ends.iter().for_each(|&v| made.set_at(v, edge.triangle()));
        }
        give_back(edges);
        made.pinched_edges.sort_unstable();
        made.pinched_edges.dedup_by_key(|entry| entry.0);
        made
    }

    /// Every constrained edge of a star renews the anchors of its ends. A triangle that dies with
    /// a constrained edge leaves that edge on the cavity's boundary, or its halves at the joints:
    /// so an anchor never dangles.
    pub fn renew(&mut self, vertex: u32, cavity: &Cavity) {
        self.vertices.push(cavity.is_split());
        if cavity.is_split() {
            self.slots.push(u32::MAX);
        } else if !cavity.is_constrained() {
            return;
        }
        for (i, side) in cavity.sides().enumerate() {
            if side.behind.is_constrained() {
                self.set(side.ends, cavity.star[i]);
            }
            if !cavity.is_split() {
                continue;
            }
            if cavity.joint_before(i).is_some() {
                self.set([vertex, side.ends[0]], cavity.star[i]);
            }
            if cavity.joint_before(i + 1).is_some() {
                self.set([vertex, side.ends[1]], cavity.star[i]);
            }
        }
    }

    /// Renews the anchors of the ends of a constrained edge that a new triangle has.
    #[inline]
    pub fn set(&mut self, ends: [u32; 2], slot: u32) {
        ends.iter().for_each(|&v| self.set_at(v, slot));
        if let Some(at) = self.pinched_edge(ends) {
            self.pinched_edges[at].1 = slot;
        }
    }

    /// (An edge of the hull that is no subsegment may have ends that are on none.)
    #[inline]
    fn set_at(&mut self, vertex: u32, slot: u32) {
        if let Some(rank) = self.vertices.rank(vertex) {
            self.slots[rank] = slot;
        }
    }

    /// The slot of a vertex; `u32::MAX` for one that is on no subsegment.
    #[inline]
    fn at(&self, vertex: u32) -> u32 {
        self.vertices.rank(vertex).map_or(u32::MAX, |rank| self.slots[rank])
    }

    /// Where an edge stands among those with two pinched ends.
    #[inline]
    fn pinched_edge(&self, ends: [u32; 2]) -> Option<usize> {
        if self.pinched_edges.is_empty() {
            return None;
        }
        self.pinched_edges.binary_search_by_key(&sorted(ends), |entry| entry.0).ok()
    }

    /// What [`Anchors::set`] would change for this edge, as it is now.
    pub fn now(&self, ends: [u32; 2]) -> Anchored {
        let place = self.pinched_edge(ends);
        Anchored {
            ends,
            slots: ends.map(|v| self.at(v)),
            pinched: place.map(|at| (at, self.pinched_edges[at].1)),
        }
    }

    /// Takes a change back.
    pub fn restore(&mut self, Anchored { ends, slots, pinched }: Anchored) {
        ends.iter().zip(slots).for_each(|(&v, slot)| self.set_at(v, slot));
        if let Some((at, slot)) = pinched {
            self.pinched_edges[at].1 = slot;
        }
    }

    /// Forgets the vertices behind the first `count`, which are on no subsegment.
    pub fn truncate(&mut self, count: usize) {
        self.vertices.truncate(count);
    }

    /// Renumbers slots, and vertices: none on a subsegment is forgotten, none that is pinched gets
    /// another number.
    pub fn renumber(&mut self, stays: impl Fn(u32) -> bool, slot: impl Fn(u32) -> u32) {
        self.vertices.retain(stays);
        let pinched = self.pinched_edges.iter_mut().map(|(_, anchor)| anchor);
        self.slots.iter_mut().chain(pinched).for_each(|anchor| *anchor = slot(*anchor));
    }

    #[inline]
    fn is_pinched(&self, vertex: u32) -> bool {
        self.pinched.get(vertex as usize).copied().unwrap_or(false)
    }
}

impl Triangulation {
    /// Gives the memory back by which subsegments are found, when none is sought any more.
    pub fn forget_anchors(&mut self) {
        self.anchors = Anchors::default();
    }

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
        let start = self.anchors.at(a);
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

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
