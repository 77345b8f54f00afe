//! Segments into a Delaunay triangulation: the constrained Delaunay triangulation.
//!
//! The triangles that a segment crosses are taken out; the two polygons that are left, one on
//! either side of it, are triangulated anew (Anglada, *An improved incremental algorithm for
//! constructing restricted Delaunay triangulations*, 1997). What comes in takes the slots of what
//! went out.

use super::insertion::GHOST;
use super::{Edge, Triangle, Triangulation};
use crate::corners::{each, next, previous};
use crate::memory::give_back;
use crate::predicates::{Relative, Side, in_circle, side};

/// A segment cannot be an edge: rounding aside, it would cross another or pass through a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Blocked;

/// Makes every segment an edge, constrained on both sides. No two of them cross, none passes
/// through a vertex.
pub(super) fn constrain(
    mesh: &mut Triangulation,
    segments: impl Iterator<Item = [u32; 2]>,
) -> Result<(), Blocked> {
    let mut slots = vec![0; mesh.points.len()];
    for (slot, triangle) in mesh.triangles.iter().enumerate() {
        triangle.vertices.iter().for_each(|&v| slots[v as usize] = slot as u32);
    }
    let mut constraining = Constraining {
        removed: vec![false; mesh.triangles.len()],
        mesh,
        slots,
        dead: Vec::new(),
        dangling: Vec::new(),
        stack: Vec::new(),
    };
    let constrained = segments.into_iter().try_for_each(|ends| constraining.insert(ends));
    give_back(constraining.slots);
    give_back(constraining.removed);
    constrained
}

struct Constraining<'a> {
    mesh: &'a mut Triangulation,
    /// A triangle at each vertex.
    slots: Vec<u32>,
    /// Which slots are empty for the moment, and these in the order in which they are refilled.
    removed: Vec<bool>,
    dead: Vec<u32>,
    /// Edges that both polygons, or one of them twice, run along: the new triangle on one side.
    dangling: Vec<([u32; 2], Edge)>,
    stack: Vec<Part>,
}

/// What a walk around an end of a segment finds.
enum Around {
    /// The segment is an edge.
    Edge(Edge),
    /// It crosses this edge of a triangle at that end.
    Crosses(Edge),
}

/// One side of a segment, from its start to its end: vertices, and what lies behind the edge from
/// each to the next.
struct Polygon {
    vertices: Vec<u32>,
    behind: Vec<Behind>,
}

/// What lies behind an edge of a polygon.
#[derive(Clone, Copy)]
enum Behind {
    /// A triangle that stays, by its edge.
    Triangle(Edge),
    /// The polygon again, or the other one: both sides of the edge went out.
    Dangling {
        /// Whether the edge is a segment.
        constrained: bool,
    },
}

/// A part of a polygon, between two of its vertices, and the new triangle's edge along its base.
#[derive(Clone, Copy)]
struct Part {
    from: usize,
    to: usize,
    base: Option<Edge>,
}

impl Constraining<'_> {
    fn insert(&mut self, ends: [u32; 2]) -> Result<(), Blocked> {
        let (ends, found) = self.look_around(ends)?;
        let edge = match found {
            Around::Edge(edge) => edge,
            Around::Crosses(first) => {
                let [left, right] = self.take_out(ends, first)?;
                let base = self.fill(&left)?.ok_or(Blocked)?;
                let other = self.fill(&right)?.ok_or(Blocked)?;
                self.link(base, other);
                base
            }
        };
        self.constrain(edge);
        Ok(())
    }

    /// Looks for a segment around both its ends at once, until the end with fewer triangles is
    /// done (a vertex may have a hundred thousand segments); returns it as seen from that end.
    fn look_around(&self, [a, b]: [u32; 2]) -> Result<([u32; 2], Around), Blocked> {
        let mut walks = [[a, b], [b, a]].map(|ends| (ends, self.slots[ends[0] as usize]));
        loop {
            for (ends, slot) in &mut walks {
                let [from, to] = *ends;
                let triangle = &self.mesh.triangles[*slot as usize];
                let corner = corner_at(triangle, from).ok_or(Blocked)?;
                if triangle.vertices[next(corner)] == to {
                    return Ok((*ends, Around::Edge(Edge::new(*slot, previous(corner)))));
                }
                // On, counter-clockwise: across the edge from this vertex to the last one.
                *slot = triangle.neighbors[next(corner)].triangle();
                if *slot == self.slots[from as usize] {
                    return Ok((*ends, Around::Crosses(self.crossed_around(*ends)?)));
                }
            }
        }
    }

    /// The edge opposite its start that a segment crosses. (Few segments are no edges: only for these
    /// is the second way around.)
    fn crossed_around(&self, [from, to]: [u32; 2]) -> Result<Edge, Blocked> {
        let start = self.slots[from as usize];
        let mut slot = start;
        loop {
            let triangle = &self.mesh.triangles[slot as usize];
            let corner = corner_at(triangle, from).ok_or(Blocked)?;
            if self.is_crossed(triangle, corner, to) {
                return Ok(Edge::new(slot, corner));
            }
            slot = triangle.neighbors[next(corner)].triangle();
            if slot == start {
                return Err(Blocked);
            }
        }
    }

    /// Whether the way from a corner of a triangle to a vertex leads through its opposite edge.
    fn is_crossed(&self, triangle: &Triangle, corner: usize, to: u32) -> bool {
        if triangle.vertices.contains(&GHOST) {
            return false;
        }
        let [at, right, left] = [corner, next(corner), previous(corner)]
            .map(|i| self.mesh.points[triangle.vertices[i] as usize]);
        let goal = self.mesh.points[to as usize];
        side(at, right, goal) == Side::Left && side(at, left, goal) == Side::Right
    }

    /// Takes out what the segment crosses, from the edge `first` on; returns the polygon on its
    /// left, and the one on its right as seen the other way round, from its end to its start.
    fn take_out(&mut self, [a, b]: [u32; 2], first: Edge) -> Result<[Polygon; 2], Blocked> {
        self.dead.clear();
        self.dangling.clear();
        let [from, to] = [a, b].map(|v| self.mesh.points[v as usize]);
        let mut left = Polygon { vertices: vec![a], behind: Vec::new() };
        let mut right = Polygon { vertices: vec![a], behind: Vec::new() };
        let mut edge = first;
        let triangle = self.mesh.triangles[first.triangle() as usize];
        left.go_to(
            triangle.vertices[previous(first.index())],
            triangle.neighbors[next(first.index())],
        );
        right.go_to(
            triangle.vertices[next(first.index())],
            triangle.neighbors[previous(first.index())],
        );
        self.remove(first.triangle());
        loop {
            let behind = self.mesh.behind(edge);
            if behind.is_constrained() || self.removed[behind.triangle() as usize] {
                return Err(Blocked);
            }
            let i = behind.index();
            let Triangle { vertices, neighbors } = self.mesh.triangles[behind.triangle() as usize];
            if vertices.contains(&GHOST) {
                return Err(Blocked);
            }
            self.remove(behind.triangle());
            // Seen from here the edge runs from the left to the right.
            let (apex, on_left, on_right) =
                (vertices[i], neighbors[previous(i)], neighbors[next(i)]);
            let (to_left, to_right) =
                (Edge::new(behind.triangle(), previous(i)), Edge::new(behind.triangle(), next(i)));
            if apex == b {
                left.go_to(b, on_left);
                right.go_to(b, on_right);
                right.vertices.reverse();
                right.behind.reverse();
                return Ok([left, right].map(|polygon| self.with_dangling_edges(polygon)));
            }
            edge = match side(from, to, self.mesh.points[apex as usize]) {
                Side::Left => {
                    left.go_to(apex, on_left);
                    to_right
                }
                Side::Right => {
                    right.go_to(apex, on_right);
                    to_left
                }
                Side::On => return Err(Blocked),
            };
        }
    }

    /// Marks the edges that had nothing but removed triangles on either side.
    fn with_dangling_edges(&self, mut polygon: Polygon) -> Polygon {
        for behind in &mut polygon.behind {
            if let Behind::Triangle(edge) = *behind
                && self.removed[edge.triangle() as usize]
            {
                *behind = Behind::Dangling { constrained: edge.is_constrained() };
            }
        }
        polygon
    }

    fn remove(&mut self, slot: u32) {
        self.removed[slot as usize] = true;
        self.dead.push(slot);
    }

    /// Triangulates a polygon, which lies to the left of its base from its first vertex to its
    /// last; returns the edge along the base.
    fn fill(&mut self, polygon: &Polygon) -> Result<Option<Edge>, Blocked> {
        let last = polygon.vertices.len() - 1;
        let mut found = None;
        self.stack.push(Part { from: 0, to: last, base: None });
        while let Some(Part { from, to, base }) = self.stack.pop() {
            if to == from + 1 {
                if let Some(base) = base {
                    self.link_outwards(base, polygon, from);
                }
                continue;
            }
            let apex = self.apex(&polygon.vertices[from..=to]).ok_or(Blocked)? + from;
            let slot = self.dead.pop().ok_or(Blocked)?;
            self.removed[slot as usize] = false;
            let vertices = [apex, from, to].map(|i| polygon.vertices[i]);
            self.mesh.triangles[slot as usize] =
                Triangle { vertices, neighbors: [Edge::OUTSIDE; 3] };
            vertices.iter().for_each(|&v| self.slots[v as usize] = slot);
            match base {
                Some(base) => self.link(base, Edge::new(slot, 0)),
                None => found = Some(Edge::new(slot, 0)),
            }
            self.stack.push(Part { from, to: apex, base: Some(Edge::new(slot, 2)) });
            self.stack.push(Part { from: apex, to, base: Some(Edge::new(slot, 1)) });
        }
        Ok(found)
    }

    /// Which vertex of a polygon makes with its base the triangle whose circle holds no other.
    fn apex(&self, polygon: &[u32]) -> Option<usize> {
        let at = |v: u32| self.mesh.points[v as usize];
        let [a, b] = [polygon[0], polygon[polygon.len() - 1]].map(at);
        let mut best: Option<usize> = None;
        for i in 1..polygon.len() - 1 {
            let v = at(polygon[i]);
            if side(a, b, v) != Side::Left {
                continue;
            }
            let is_better = best.is_none_or(|best| {
                let corners = [a, b, at(polygon[best])];
                in_circle(corners.map(|corner| Relative::of(corner, v)), || corners, v)
            });
            if is_better {
                best = Some(i);
            }
        }
        let mut best = best?;
        // A vertex with dangling edges stands there several times. What hangs at it on the side of
        // `a` belongs to the part before it.
        let apex = polygon[best];
        while side(a, at(apex), at(polygon[best + 1])) == Side::Left {
            let again = polygon[best + 1..polygon.len() - 1].iter().position(|&v| v == apex);
            let Some(further) = again else { break };
            best += 1 + further;
        }
        Some(best)
    }

    /// Links the edge of a new triangle with what lies behind it, outside of the polygon.
    fn link_outwards(&mut self, edge: Edge, polygon: &Polygon, from: usize) {
        let constrained = match polygon.behind[from] {
            Behind::Triangle(behind) => return self.link(edge, behind),
            Behind::Dangling { constrained } => constrained,
        };
        let [v, w] = [polygon.vertices[from], polygon.vertices[from + 1]];
        let ends = [v.min(w), v.max(w)];
        // The first of the two new triangles waits for the other.
        match self.dangling.iter().position(|waiting| waiting.0 == ends) {
            Some(i) => {
                let (_, other) = self.dangling.swap_remove(i);
                self.link(edge.constrained_if(constrained), other);
            }
            None => self.dangling.push((ends, edge)),
        }
    }

    /// Links two edges with each other; what either knows of a constraint stays.
    fn link(&mut self, a: Edge, b: Edge) {
        let constrained = a.is_constrained() || b.is_constrained();
        let neighbor_of = |edge: Edge| (edge.triangle() as usize, edge.index());
        for (one, other) in [(a, b), (b, a)] {
            let (slot, i) = neighbor_of(one);
            self.mesh.triangles[slot].neighbors[i] = other.constrained_if(constrained);
        }
    }

    fn constrain(&mut self, edge: Edge) {
        let behind = self.mesh.behind(edge);
        self.link(edge.constrained_if(true), behind);
    }
}

/// Which corner of a triangle a vertex is. (Without a branch that nobody guesses.)
#[inline]
fn corner_at(triangle: &Triangle, vertex: u32) -> Option<usize> {
    let [_, second, third] = each(triangle.vertices, |v| usize::from(v == vertex));
    let corner = second | third << 1;
    (triangle.vertices.get(corner) == Some(&vertex)).then_some(corner)
}

impl Polygon {
    fn go_to(&mut self, vertex: u32, behind: Edge) {
        self.vertices.push(vertex);
        self.behind.push(Behind::Triangle(behind));
    }
}
