//! G4: every segment is a chain of edges of the mesh, every point of the outline is there.
//!
//! A chain is found by walking from one end of its segment: from point to point along edges that
//! the mesh lists as boundary or interface and that end on the segment again. What the list lacks
//! is looked for among the edges of the triangles; what breaks off is walked from the other end.

use std::cmp::Ordering;

use super::complex::{Complex, NONE};
use super::exact;
use super::fault::{Fault, FaultKind};
use super::outline::Outline;
use super::roles::Roles;
use super::sequences::Sequences;
use super::tags::Tags;
use super::verdict::Judgement;

/// How the segments run through the mesh.
pub(super) struct Chains {
    /// The points of each segment's chain.
    chain: Sequences,
    /// What the half-edges along segments are.
    roles: Roles,
    /// By point: twice the point of the outline that it is, or twice the segment that it lies
    /// strictly inside of and one more, or [`NONE`].
    seats: Vec<u32>,
    /// The point of the mesh that each point of the outline is, or [`NONE`].
    pub(super) vertex: Vec<u32>,
    /// Whether there is no outline.
    alone: bool,
}

impl Chains {
    /// The chains of a mesh without an outline: its list of edges.
    pub(super) fn listed(complex: &Complex, g4: &mut Judgement) -> Self {
        let mut chains = Self::nothing(complex);
        chains.seats = vec![NONE; complex.points.len()];
        chains.alone = true;
        List::new(complex, g4).mark_open_edges(complex, &mut chains.roles);
        if complex.mesh.edges.is_empty() {
            // A mesh that lists none: what has one side is taken for a boundary.
            complex.one_sided().iter().for_each(|&h| chains.roles.list(h));
        }
        chains.roles.settle();
        chains
    }

    fn nothing(complex: &Complex) -> Self {
        Self {
            chain: Sequences::default(),
            roles: Roles::new(complex.halves().end, complex.mesh.edges.len()),
            seats: Vec::new(),
            vertex: Vec::new(),
            alone: false,
        }
    }

    /// The half-edges that are pieces of segments or at least listed, in order.
    pub(super) fn bound(&self) -> impl Iterator<Item = u32> + '_ {
        self.roles.halves()
    }

    /// The half-edge of the outline that a half-edge is a part of.
    pub(super) fn outline_half(&self, h: u32) -> Option<u32> {
        self.roles.outline_half(h)
    }

    /// The segment that a half-edge is a part of.
    pub(super) fn segment(&self, h: u32) -> Option<u32> {
        self.outline_half(h).map(|half| half / 2)
    }

    /// Whether a half-edge is a piece of a segment; without an outline, whether it is
    /// listed.
    pub(super) fn is_subsegment(&self, h: u32) -> bool {
        if self.alone { self.is_bound(h) } else { self.segment(h).is_some() }
    }

    /// The point of the outline that a point is, or [`NONE`].
    pub(super) fn input(&self, v: u32) -> u32 {
        match self.seats[v as usize] {
            seat if seat.is_multiple_of(2) => seat / 2,
            _ => NONE,
        }
    }

    /// The segment that a point lies strictly inside of, or [`NONE`].
    pub(super) fn inside(&self, v: u32) -> u32 {
        match self.seats[v as usize] {
            NONE => NONE,
            seat if seat.is_multiple_of(2) => NONE,
            seat => seat / 2,
        }
    }

    /// The points of a segment from its first end on; [`NONE`] where the chain has a gap.
    pub(super) fn points(&self, s: u32) -> &[u32] {
        self.chain.of(s)
    }

    /// The pieces of a segment's chain, in its direction.
    pub(super) fn pieces(&self, s: u32) -> impl Iterator<Item = [u32; 2]> + '_ {
        let pairs = self.points(s).windows(2).map(|pair| [pair[0], pair[1]]);
        pairs.filter(|pair| !pair.contains(&NONE))
    }

    /// Whether a half-edge is a part of a segment or at least listed.
    pub(super) fn is_bound(&self, h: u32) -> bool {
        self.roles.is_bound(h)
    }
}

/// Judges G4, except for the regions' tags.
///
/// `at_input`: for each point of the mesh a point of the outline at the very same place, or [`NONE`].
pub(super) fn judge(
    outline: &Outline,
    complex: &Complex,
    at_input: Vec<u32>,
    g4: &mut Judgement,
) -> Chains {
    let mut chains = Chains::nothing(complex);
    chains.chain = Sequences::with_capacity(outline.segments.len(), complex.mesh.edges.len());
    chains.vertex = find_points(outline, complex, &at_input, g4);
    chains.seats = at_input; // (in its place)
    chains.seats.fill(NONE);
    let list = List::new(complex, g4);
    for (input, &v) in (0..).zip(&chains.vertex).filter(|(_, v)| **v != NONE) {
        chains.seats[v as usize] = 2 * input;
    }
    let tags = Tags::new(1, &outline.pslg.groups, &complex.mesh.groups);
    let mut walk = Walk { outline, complex, chains, list, tags, g4 };
    // Whole chains first: a broken one may then only take what is left over.
    let segments = 0..outline.segments.len() as u32;
    let broken: Vec<_> = segments.clone().filter_map(|s| walk.follow(s)).collect();
    for gap in broken {
        walk.mend(gap);
    }
    for s in segments {
        walk.claim(s);
    }
    walk.list.mark_open_edges(complex, &mut walk.chains.roles);
    walk.chains.roles.settle();
    walk.report_surplus();
    walk.chains
}

/// The point of the mesh at each distinct point of the outline.
fn find_points(
    outline: &Outline,
    complex: &Complex,
    at_input: &[u32],
    g4: &mut Judgement,
) -> Vec<u32> {
    let mut vertex = vec![NONE; outline.points.len()];
    for (v, &at) in at_input.iter().enumerate().filter(|(_, at)| **at != NONE) {
        let w = outline.same[at as usize];
        if w != NONE {
            let known = vertex[w as usize];
            if known == NONE || (!complex.used[known as usize] && complex.used[v]) {
                vertex[w as usize] = v as u32;
            }
        }
    }
    for w in outline.distinct_points().filter(|&w| outline.has_point(w)) {
        if vertex[w as usize] == NONE {
            let fault = Fault::of_mesh(FaultKind::LostPoint, outline.pslg.points[w as usize]);
            g4.add(fault.of_input_point(outline.point_name(w)));
        }
    }
    vertex
}

/// The list of boundary and interface edges that the mesh carries.
struct List {
    /// By point: its edges, as indices into the list.
    start: Vec<u32>,
    edges: Vec<u32>,
    /// By edge of the list: whether a chain has it.
    taken: Vec<bool>,
}

impl List {
    fn new(complex: &Complex, g4: &mut Judgement) -> Self {
        let mesh = complex.mesh;
        let there =
            |v: u32| mesh.points.get(v as usize).is_some_and(|p| p.iter().all(|x| x.is_finite()));
        let mut taken = vec![false; mesh.edges.len()];
        for (e, &[v, w]) in mesh.edges.iter().enumerate() {
            if !there(v) || !there(w) {
                g4.add(Fault::at_edge(mesh, FaultKind::NoSuchEdgePoint, [v, w]));
                taken[e] = true;
            }
        }
        let sound = mesh.edges.iter().enumerate().filter(|(e, _)| !taken[*e]);
        let ends = sound.flat_map(|(e, &edge)| edge.map(|v| (v, e as u32)));
        let (start, edges) = super::grouped(complex.points.len(), ends);
        Self { start, edges, taken }
    }

    /// Makes the half-edges along edges that no chain has ones that are listed.
    fn mark_open_edges(&self, complex: &Complex, roles: &mut Roles) {
        let edges = complex.mesh.edges.iter().zip(&self.taken);
        for &[v, w] in edges.filter(|(_, taken)| !**taken).map(|(edge, _)| edge) {
            for h in complex.find(v, w).into_iter().filter(|&h| h != NONE) {
                if !roles.is_bound(h) {
                    roles.list(h);
                }
            }
        }
    }

    fn at(&self, v: u32) -> &[u32] {
        &self.edges[self.start[v as usize] as usize..self.start[v as usize + 1] as usize]
    }
}

/// A segment whose chain breaks off.
struct Break {
    segment: u32,
    /// The chain from its first end, as far as it goes.
    front: Vec<u32>,
    /// The chain from its second end.
    back: Vec<u32>,
}

struct Walk<'w, 'a> {
    outline: &'w Outline<'a>,
    complex: &'w Complex<'a>,
    chains: Chains,
    list: List,
    tags: Tags<'w>,
    g4: &'w mut Judgement,
}

/// A step of a walk along a segment.
struct Step {
    to: u32,
    /// The edge of the list, if it has one.
    listed: Option<u32>,
}

impl Walk<'_, '_> {
    /// Follows a segment from end to end; what remains where the chain breaks off. What is not
    /// meshed has no chain.
    fn follow(&mut self, s: u32) -> Option<Break> {
        self.chains.chain.begin();
        if !self.outline.is_meshed(s) {
            return None;
        }
        let [from, to] = self.ends(s);
        let front = self.run(s, from, to, 0);
        if front.last() == Some(&to) {
            self.chains.chain.extend(&front);
            return None;
        }
        let back = self.run(s, to, from, 1);
        Some(Break { segment: s, front, back })
    }

    /// The points of the mesh at the ends of a segment.
    fn ends(&self, s: u32) -> [u32; 2] {
        self.outline.segments[s as usize].ends.map(|v| self.chains.vertex[v as usize])
    }

    /// Goes from `from` towards `to` as long as there is an edge; `way` 1 is against the segment.
    fn run(&mut self, s: u32, from: u32, to: u32, way: usize) -> Vec<u32> {
        let mut chain = Vec::new();
        let mut v = from;
        while v != NONE {
            chain.push(v);
            if v == to {
                break;
            }
            let Some(step) = self.next(s, v, to, way) else { break };
            match step.listed {
                Some(e) => self.take(e, s),
                None if self.complex.mesh.edges.is_empty() => {}
                None => {
                    let fault =
                        Fault::at_edge(self.complex.mesh, FaultKind::Unlisted, [v, step.to]);
                    self.g4.add(fault.of_segment(self.outline.segment_name(s)));
                }
            }
            v = step.to;
        }
        chain
    }

    /// The edge that follows the segment from `v`: the shortest listed one, one that is said to be
    /// a part of this segment before others; else the shortest edge of a triangle.
    fn next(&self, s: u32, v: u32, to: u32, way: usize) -> Option<Step> {
        let mut best: Option<(bool, f64, Step)> = None;
        for (e, w) in self.open_edges(v) {
            if !self.leads(s, v, w, to, way) {
                continue;
            }
            let key = (!self.is_said_to_be(e, s), self.length(v, w));
            if best.as_ref().is_none_or(|(other, length, _)| key < (*other, *length)) {
                best = Some((key.0, key.1, Step { to: w, listed: Some(e) }));
            }
        }
        if let Some((_, _, step)) = best {
            return Some(step);
        }
        let unbound = self.complex.around(v).filter(|&w| self.leads(s, v, w, to, way));
        let nearest = unbound.min_by(|&u, &w| self.length(v, u).total_cmp(&self.length(v, w)))?;
        Some(Step { to: nearest, listed: None })
    }

    /// The edges of the list at `v` that no chain has yet, with their other ends.
    fn open_edges(&self, v: u32) -> impl Iterator<Item = (u32, u32)> + '_ {
        let open = self.list.at(v).iter().filter(|&&e| !self.list.taken[e as usize]);
        open.map(move |&e| {
            let [p, q] = self.complex.mesh.edges[e as usize];
            (e, if p == v { q } else { p })
        })
    }

    fn length(&self, v: u32, w: u32) -> f64 {
        super::outline::distance(self.complex.at(v), self.complex.at(w))
    }

    /// Whether the list says that its edge `e` is a part of segment `s` (or of one equal to it).
    fn is_said_to_be(&self, e: u32, s: u32) -> bool {
        let said = self.complex.mesh.edge_segments.get(e as usize);
        let Some(&said) = said else { return false };
        let segment = self.outline.segments[s as usize];
        let pslg = self.outline.pslg;
        said == segment.input
            || pslg.segments.get(said as usize).is_some_and(|ends| {
                let [v, w] =
                    ends.map(|v| self.outline.same.get(v as usize).copied().unwrap_or(NONE));
                [v, w] == segment.ends || [w, v] == segment.ends
            })
    }

    /// Whether the edge from `v` to `w` goes forward along the segment and ends on it.
    fn leads(&self, s: u32, v: u32, w: u32, to: u32, way: usize) -> bool {
        self.is_forward(s, v, w, way) && (w == to || (!self.is_input(w) && self.is_on(s, w)))
    }

    fn is_forward(&self, s: u32, v: u32, w: u32, way: usize) -> bool {
        let [a, b] = self.line(s);
        let order = exact::dot(a, b, self.complex.at(v), self.complex.at(w));
        order == if way == 0 { Ordering::Greater } else { Ordering::Less }
    }

    /// Whether a point of the mesh is a point of the outline.
    fn is_input(&self, v: u32) -> bool {
        self.chains.input(v) != NONE
    }

    /// Whether a point lies within 0.51 ulp of a segment's line.
    fn is_on(&self, s: u32, w: u32) -> bool {
        let [a, b] = self.line(s);
        let p = self.complex.at(w);
        exact::within_half_ulp(a, b, p, p.map(|x| self.complex.frame.ulp_at(x)))
    }

    fn line(&self, s: u32) -> [[f64; 2]; 2] {
        self.outline.segments[s as usize].ends.map(|v| self.outline.points[v as usize])
    }

    /// Goes on where a chain broke off, along edges that are nearly right, and says what is wrong
    /// with them.
    fn mend(&mut self, gap: Break) {
        let Break { segment: s, mut front, mut back } = gap;
        let name = self.outline.segment_name(s);
        let to = back.last().copied().unwrap_or(NONE);
        while let Some(&v) = front.last().filter(|&&v| v != to) {
            let Some((e, w)) = self.next_nearly(s, v, to) else { break };
            self.take(e, s);
            let [a, b] = self.line(s);
            let p = self.complex.at(w);
            if w != to && !self.is_on(s, w) {
                let ulps = exact::ulps_off(a, b, p, p.map(|x| self.complex.frame.ulp_at(x)));
                let fault = Fault::at_point(self.complex.mesh, FaultKind::OffSegment { ulps }, w);
                self.g4.add(fault.of_segment(name));
            }
            if !self.is_forward(s, v, w, 0) {
                let fault = Fault::at_point(self.complex.mesh, FaultKind::NotMonotone, w);
                self.g4.add(fault.of_segment(name).of_edge([v, w]));
            }
            front.push(w);
        }
        match front.last() {
            Some(&v) if v == to => {
                back.pop();
                front.extend(back.into_iter().rev());
            }
            Some(&v) if to != NONE => {
                let until = Some(to);
                let fault = Fault::at_point(self.complex.mesh, FaultKind::Broken { until }, v);
                self.g4.add(fault.of_segment(name));
                front.push(NONE); // a break
                front.extend(back.into_iter().rev());
            }
            // An end is lost, and reported.
            _ => {
                front.push(NONE);
                front.extend(back.into_iter().rev());
            }
        }
        self.chains.chain.replace(s, front);
    }

    /// The listed edge at `v` that is nearly right: it is said to be a part of the segment, or it
    /// ends on it but runs back, or it runs forward and ends near it.
    fn next_nearly(&self, s: u32, v: u32, to: u32) -> Option<(u32, u32)> {
        let [a, b] = self.line(s);
        let off = |w: u32| {
            let [p, q] = [v, w].map(|v| self.complex.at(v));
            let parallel = [p[0] + (b[0] - a[0]), p[1] + (b[1] - a[1])];
            let (cross, dot) = exact::corner(p, parallel, q).cross_and_dot();
            if dot > 0.0 { cross.abs() / dot } else { f64::INFINITY }
        };
        let candidates = self.open_edges(v).filter(|&(e, w)| {
            let free = w == to || !self.is_input(w);
            free && (self.is_said_to_be(e, s)
                || self.is_on(s, w)
                || (off(w) < 0.5 && !self.says_segments()))
        });
        candidates.min_by(|&(_, u), &(_, w)| off(u).total_cmp(&off(w)))
    }

    fn says_segments(&self) -> bool {
        self.complex.mesh.edge_segments.len() == self.complex.mesh.edges.len()
    }

    /// Gives an edge of the list to a segment, and judges what it says of itself.
    fn take(&mut self, e: u32, s: u32) {
        self.list.taken[e as usize] = true;
        let mesh = self.complex.mesh;
        let edge = mesh.edges[e as usize];
        let segment = self.outline.segments[s as usize];
        let name = self.outline.segment_name(s);
        if mesh.edge_segments.get(e as usize).is_some() && !self.is_said_to_be(e, s) {
            self.g4.add(Fault::at_edge(mesh, FaultKind::WrongSegment, edge).of_segment(name));
        }
        if mesh.edge_tags.is_empty() {
            return; // said elsewhere
        }
        let found = mesh.edge_tags.get(e as usize).copied().unwrap_or(0);
        if !self.tags.agree(segment.tag, found) {
            let (found, expected) = (self.tags.found(found), self.tags.expected(segment.tag));
            let kind = FaultKind::WrongBoundaryTag { found, expected };
            self.g4.add(Fault::at_edge(mesh, kind, edge).of_segment(name));
        }
    }

    /// Makes the pieces of a chain parts of their segment.
    fn claim(&mut self, s: u32) {
        let between_triangles = self.outline.sides(s).iter().all(|face| face.meshed);
        let chain = self.chains.chain.of(s);
        for piece in chain.windows(2).filter(|piece| !piece.contains(&NONE)) {
            let (v, w) = (piece[0], piece[1]);
            let halves = self.complex.find(v, w);
            if between_triangles && halves == [NONE; 2] {
                let fault = Fault::at_edge(self.complex.mesh, FaultKind::NotAnEdge, [v, w]);
                self.g4.add(fault.of_segment(self.outline.segment_name(s)));
            }
            for (way, h) in (0..2).zip(halves).filter(|(_, h)| *h != NONE) {
                self.chains.roles.claim(h, 2 * s + way);
            }
        }
        for &v in self.chains.chain.of(s).iter().filter(|&&v| v != NONE) {
            if self.chains.input(v) == NONE {
                self.chains.seats[v as usize] = 2 * s + 1;
            }
        }
    }

    /// What the list has besides the chains.
    fn report_surplus(&mut self) {
        for e in (0..self.list.taken.len()).filter(|&e| !self.list.taken[e]) {
            let edge = self.complex.mesh.edges[e];
            self.g4.add(Fault::at_edge(self.complex.mesh, FaultKind::Surplus, edge));
        }
    }
}
