//! The judge's own reading of an outline: what the segments are, what they enclose, and which of
//! that is to be meshed.
//!
//! Exact duplicates of points count as one point, zero-length and duplicate segments do not count
//! (the first of each keeps its tag). The faces are found by walking the half-edges, and are put
//! inside one another by one sweep from left to right.

use std::borrow::Cow;
use std::cmp::Ordering;

use super::complex::NONE;
use super::exact;
use super::fault::Numbered;
use super::frame::Frame;
use super::hull;
use super::nesting;
use super::precision::FLOOR;
use crate::boxes::Rectangle;
use crate::columns::{in_columns, lexicographic};
use crate::formats::{Enclosed, Pslg, Tag};
use crate::parameters::Region;

/// An outline, understood. Coordinates are judged coordinates.
pub(super) struct Outline<'a> {
    pub(super) pslg: &'a Pslg,
    frame: Frame,
    pub(super) points: Cow<'a, [[f64; 2]]>,
    /// The first point with the same coordinates; [`NONE`] for what is not finite.
    pub(super) same: Vec<u32>,
    /// The distinct points, from left to right (below to above where equal).
    sorted: Vec<u32>,
    /// The distinct segments; then the edges of the convex hull that are none, where it is meshed.
    pub(super) segments: Vec<Segment>,
    /// Half-edges (2s from the first end of segment s, 2s + 1 from the second) that leave a point,
    /// counter-clockwise from the direction of x; `start` delimits them.
    spokes: Vec<u32>,
    start: Vec<u32>,
    /// The face on the left of each half-edge.
    face: Vec<u32>,
    /// The face that an isolated point is in.
    face_around: Vec<u32>,
    /// The faces; the first is what lies outside of everything.
    pub(super) faces: Vec<Face>,
}

/// A segment that counts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment {
    /// Its ends, as indices into [`Outline::points`].
    pub(super) ends: [u32; 2],
    /// The segment of the outline, or [`NONE`] for an edge of the convex hull.
    pub(super) input: u32,
    pub(super) tag: Tag,
}

/// A face of the outline.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Face {
    /// Whether it is meshed.
    pub(super) meshed: bool,
    /// The region that it is part of: the first whose seed lies in it.
    region: Option<u32>,
    /// The tag of its region.
    pub(super) tag: Tag,
    /// How many connected pieces its boundary has.
    pieces: i64,
}

/// So many points are fetched at once: one by one, each would be waited for.
const FETCHED: usize = 4096;

/// Where a seed lies.
type Seat = Option<u32>;

impl<'a> Outline<'a> {
    /// Reads an outline.
    pub(super) fn new(pslg: &'a Pslg, region: Region, frame: Frame) -> Self {
        let mut outline = Self {
            pslg,
            frame,
            points: frame.all_scaled(&pslg.points),
            same: Vec::new(),
            sorted: Vec::new(),
            segments: Vec::new(),
            spokes: Vec::new(),
            start: Vec::new(),
            face: Vec::new(),
            face_around: Vec::new(),
            faces: vec![Face::default()],
        };
        outline.merge_points();
        outline.take_segments();
        let hull = region == Region::Hull || outline.segments.is_empty();
        if hull {
            outline.add_hull();
        }
        outline.sort_spokes();
        let seats = outline.find_faces();
        outline.choose(&seats, if hull { Enclosed::All } else { pslg.enclosed });
        outline
    }

    fn merge_points(&mut self) {
        let points = &self.points;
        let finite = |v: u32| self.pslg.points[v as usize].iter().all(|x| x.is_finite());
        let all = 0..points.len() as u32;
        let placed = in_columns(points, all.clone().filter(|&v| finite(v)));
        let mut same: Vec<u32> = all.map(|v| if finite(v) { v } else { NONE }).collect();
        // Equals share a column, which few do.
        for column in placed.chunk_by(|v, w| v >> 32 == w >> 32).filter(|column| column.len() > 1) {
            let at = |placed: u64| points[placed as u32 as usize];
            for group in column.chunk_by(|&v, &w| at(v) == at(w)) {
                group.iter().for_each(|&v| same[v as u32 as usize] = group[0] as u32);
            }
        }
        let mut sorted: Vec<u32> = placed.into_iter().map(|placed| placed as u32).collect();
        if (0..).zip(&same).any(|(v, &same)| same != NONE && same != v) {
            sorted.retain(|&v| same[v as usize] == v);
        }
        (self.sorted, self.same) = (sorted, same);
    }

    fn take_segments(&mut self) {
        let same = |v: u32| self.same.get(v as usize).copied().unwrap_or(NONE);
        let mut found = Vec::with_capacity(self.pslg.segments.len());
        for (input, &[v, w]) in self.pslg.segments.iter().enumerate() {
            let (v, w) = (same(v), same(w));
            if v != NONE && w != NONE && v != w {
                let tag = self.pslg.segment_tags.get(input).copied().unwrap_or(0);
                found.push(Segment { ends: [v, w], input: input as u32, tag });
            }
        }
        found.sort_unstable_by_key(|s| {
            (s.ends[0].min(s.ends[1]), s.ends[0].max(s.ends[1]), s.input)
        });
        found.dedup_by_key(|s| (s.ends[0].min(s.ends[1]), s.ends[0].max(s.ends[1])));
        found.sort_unstable_by_key(|s| s.input);
        self.segments = found;
    }

    /// Adds the edges of the convex hull that are no segments. A point on the hull ends an edge.
    fn add_hull(&mut self) {
        let mut known: Vec<[u32; 2]> = self.segments.iter().map(|s| ordered(s.ends)).collect();
        known.sort_unstable();
        let at = |v: u32| self.points[v as usize];
        let chain = |points: &mut dyn Iterator<Item = u32>| {
            let mut chain: Vec<u32> = Vec::new();
            for p in points {
                while let [.., a, b] = chain[..] {
                    if exact::orientation(at(a), at(b), at(p)) != Ordering::Less {
                        break;
                    }
                    chain.pop();
                }
                chain.push(p);
            }
            chain
        };
        let core = Rectangle::within_hull(self.sorted.iter().map(|&v| at(v)));
        let outer = self.sorted.iter().copied().filter(|&v| !core.holds_well(at(v), 0.0));
        let outer: Vec<u32> = outer.collect();
        let lower = chain(&mut outer.iter().copied());
        let upper = chain(&mut outer.iter().rev().copied());
        let edges = lower.windows(2).chain(upper.windows(2)).map(|pair| [pair[0], pair[1]]);
        let is_new = |edge: &[u32; 2]| known.binary_search(&ordered(*edge)).is_err();
        let hull: Vec<_> = edges.collect();
        let mut on_hull = vec![false; self.points.len()];
        hull.iter().flatten().for_each(|&v| on_hull[v as usize] = true);
        let new: Vec<_> = hull.into_iter().filter(is_new).collect();
        let closest = 2.0 * FLOOR * self.frame.ulp;
        let is_near = |&v: &u32| !on_hull[v as usize] && !core.holds_well(at(v), 2.0 * closest);
        let others = self.sorted.iter().copied().filter(is_near);
        let new = hull::through_near_points(&new, &self.points, others, closest);
        let new: Vec<_> = new.into_iter().filter(is_new).collect();
        self.segments.extend(new.into_iter().map(|ends| Segment { ends, input: NONE, tag: 0 }));
    }

    fn sort_spokes(&mut self) {
        let ends = self.segments.iter().enumerate();
        let leaving = ends.flat_map(|(s, segment)| {
            (0..2).map(move |way| (segment.ends[way], (2 * s + way) as u32))
        });
        let (start, mut spokes) = super::grouped(self.points.len(), leaving);
        for v in 0..self.points.len() {
            let around = &mut spokes[start[v] as usize..start[v + 1] as usize];
            let at = |h: u32| self.points[self.target(h) as usize];
            around.sort_by(|&g, &h| by_direction(self.points[v], at(g), at(h)).then(g.cmp(&h)));
        }
        (self.start, self.spokes) = (start, spokes);
    }

    /// The point where a half-edge begins.
    pub(super) fn origin(&self, h: u32) -> u32 {
        self.segments[h as usize / 2].ends[h as usize % 2]
    }

    /// The point where a half-edge ends.
    pub(super) fn target(&self, h: u32) -> u32 {
        self.segments[h as usize / 2].ends[1 - h as usize % 2]
    }

    /// The half-edges that leave a point, counter-clockwise.
    pub(super) fn spokes(&self, v: u32) -> &[u32] {
        &self.spokes[self.start[v as usize] as usize..self.start[v as usize + 1] as usize]
    }

    /// The face on the left of each half-edge, and the seat of each seed (holes, then regions).
    fn find_faces(&mut self) -> Vec<Seat> {
        let (cycle, cycles) = self.cycles();
        // The lowest leftmost point of a connected part sees its outside towards the left.
        let part = self.parts();
        let mut outside = vec![NONE; self.points.len()]; // by part: its outer cycle
        let mut first = vec![NONE; self.points.len()]; // by part: that point
        for &v in self.sorted.iter().filter(|&&v| !self.spokes(v).is_empty()) {
            let part = part[v as usize] as usize;
            if first[part] == NONE {
                first[part] = v;
                let towards_left = self.towards_left(self.spokes(v));
                outside[part] = towards_left.map_or(NONE, |h| cycle[h as usize]);
            }
        }
        let mut face_of_cycle = vec![NONE; cycles];
        let mut is_outside = vec![false; cycles];
        for &c in outside.iter().filter(|&&c| c != NONE) {
            is_outside[c as usize] = true;
        }
        for c in (0..cycles).filter(|&c| !is_outside[c]) {
            face_of_cycle[c] = self.faces.len() as u32;
            self.faces.push(Face { pieces: 1, ..Face::default() });
        }
        self.face_around = vec![NONE; self.points.len()];
        let seats = self.sweep(&cycle, &mut face_of_cycle, |v| {
            (first[part[v as usize] as usize] == v).then(|| outside[part[v as usize] as usize])
        });
        self.face = cycle
            .iter()
            .map(|&c| face_of_cycle[c as usize])
            .map(|f| if f == NONE { 0 } else { f })
            .collect();
        seats
    }

    /// Of the half-edges that leave the first point of a piece, counter-clockwise, the one that
    /// sees the outside of the piece on its left.
    pub(super) fn towards_left(&self, spokes: &[u32]) -> Option<u32> {
        spokes.iter().rev().find(|&&h| self.rises(h)).or(spokes.last()).copied()
    }

    /// Whether a half-edge goes up, or level to the right: the first half of a turn.
    fn rises(&self, h: u32) -> bool {
        let (p, q) = (self.points[self.origin(h) as usize], self.points[self.target(h) as usize]);
        rises(p, q)
    }

    /// The boundary cycle that each half-edge is on, its face to the left; and how many there are.
    fn cycles(&self) -> (Vec<u32>, usize) {
        let mut place = vec![0_u32; self.spokes.len()];
        for (i, &h) in self.spokes.iter().enumerate() {
            place[h as usize] = i as u32;
        }
        let mut cycle = vec![NONE; self.spokes.len()];
        let mut cycles = 0;
        for first in 0..cycle.len() as u32 {
            let mut h = first;
            while cycle[h as usize] == NONE {
                cycle[h as usize] = cycles;
                // On along the spoke that is clockwise next from the way back.
                let v = self.target(h) as usize;
                let (from, to) = (self.start[v], self.start[v + 1]);
                let back = place[(h ^ 1) as usize];
                h = self.spokes[if back == from { to - 1 } else { back - 1 } as usize];
            }
            if h == first && cycle[first as usize] == cycles {
                cycles += 1;
            }
        }
        (cycle, cycles as usize)
    }

    /// A representative of the connected part that each point belongs to.
    fn parts(&self) -> Vec<u32> {
        let mut parent: Vec<u32> = (0..self.points.len() as u32).collect();
        fn root(parent: &mut [u32], mut v: u32) -> u32 {
            while parent[v as usize] != v {
                parent[v as usize] = parent[parent[v as usize] as usize];
                v = parent[v as usize];
            }
            v
        }
        for segment in &self.segments {
            let [v, w] = segment.ends.map(|v| root(&mut parent, v));
            parent[v.max(w) as usize] = v.min(w);
        }
        (0..parent.len() as u32).map(|v| root(&mut parent, v)).collect()
    }

    /// Sweeps from left to right, and tells what lies below each isolated point, below the first point
    /// of each connected part (`outer_cycle` gives its cycle), and below each seed. What lies below is
    /// the face there.
    fn sweep(
        &mut self,
        cycle: &[u32],
        face_of_cycle: &mut [u32],
        outer_cycle: impl Fn(u32) -> Option<u32>,
    ) -> Vec<Seat> {
        let mut seeds: Vec<(usize, [f64; 2])> = self.seeds().into_iter().enumerate().collect();
        let mut seats = vec![None; seeds.len()];
        seeds.retain(|(_, p)| p.iter().all(|x| x.is_finite()));
        seeds.sort_by(|(_, p), (_, q)| lexicographic(*p, *q));
        let mut seeds = seeds.into_iter().peekable();
        let mut seat = |status: &Status, face_of_cycle: &[u32], outline: &Self, (seed, p)| {
            let below = status.below(outline, p);
            let on = status.on(outline, below, p);
            seats[seed] = (!on).then(|| status.face_above(below, cycle, face_of_cycle));
        };
        let mut status = Status::default();
        let sorted = std::mem::take(&mut self.sorted);
        let mut stops = Vec::new();
        for many in sorted.chunks(FETCHED) {
            stops.clear();
            stops.extend(many.iter().map(|&v| {
                (v, self.points[v as usize], self.start[v as usize], self.start[v as usize + 1])
            }));
            for &(v, at, start, end) in &stops {
                // Seeds before the point; a seed on a point lies in no face.
                while let Some(seed) = seeds.next_if(|&(_, p)| lexicographic(p, at).is_le()) {
                    if lexicographic(seed.1, at).is_lt() {
                        seat(&status, face_of_cycle, self, seed);
                    }
                }
                if start == end {
                    let below = status.below(self, at);
                    let face = status.face_above(below, cycle, face_of_cycle);
                    self.faces[face as usize].pieces += 1;
                    self.face_around[v as usize] = face;
                    continue;
                }
                let below = status.remove_ending(self, v);
                if let Some(outer) = outer_cycle(v) {
                    let face = status.face_above(below, cycle, face_of_cycle);
                    self.faces[face as usize].pieces += 1;
                    face_of_cycle[outer as usize] = face;
                }
                // From below to above: first what falls, then what rises.
                let spokes = &self.spokes[start as usize..end as usize];
                let right = |h: &&u32| {
                    lexicographic(at, self.points[self.target(**h) as usize]) == Ordering::Less
                };
                let falling = spokes.iter().filter(|h| !self.rises(**h)).filter(right);
                let rising = spokes.iter().filter(|h| self.rises(**h)).filter(right);
                status.insert(below, falling.chain(rising).copied());
            }
        }
        seeds.for_each(|seed| seat(&status, face_of_cycle, self, seed));
        self.sorted = sorted;
        seats
    }

    /// Hole seeds, then region seeds, in judged coordinates.
    fn seeds(&self) -> Vec<[f64; 2]> {
        let regions = self.pslg.regions.iter().map(|region| region.seed);
        self.pslg.holes.iter().copied().chain(regions).map(|p| self.frame.scaled(p)).collect()
    }

    /// Which faces are meshed, and of which region they are.
    fn choose(&mut self, seats: &[Seat], enclosed: Enclosed) {
        let (holes, regions) = seats.split_at(self.pslg.holes.len());
        match enclosed {
            Enclosed::All => self.faces[1..].iter_mut().for_each(|face| face.meshed = true),
            Enclosed::EvenOdd => {
                let is_odd = nesting::is_nested_oddly(self);
                self.faces.iter_mut().zip(is_odd).for_each(|(face, is_odd)| face.meshed = is_odd);
            }
            Enclosed::Seeded => {
                for &face in regions.iter().flatten().filter(|face| **face != 0) {
                    self.faces[face as usize].meshed = true;
                }
            }
        }
        for &face in holes.iter().flatten().filter(|face| **face != 0) {
            self.faces[face as usize].meshed = false;
        }
        for (i, face) in regions.iter().enumerate() {
            let Some(face) = face.map(|face| &mut self.faces[face as usize]) else { continue };
            if face.region.is_none() {
                face.region = Some(i as u32);
                face.tag = self.pslg.regions[i].tag;
            }
        }
    }

    /// The faces on the left and on the right of a segment, seen from its first end.
    pub(super) fn sides(&self, s: u32) -> [Face; 2] {
        [0, 1].map(|way| self.faces[self.face[2 * s as usize + way] as usize])
    }

    /// The face on the left of a half-edge.
    pub(super) fn face(&self, h: u32) -> u32 {
        self.face[h as usize]
    }

    /// Whether a segment lies in the closed region that is meshed.
    pub(super) fn is_meshed(&self, s: u32) -> bool {
        self.sides(s).iter().any(|face| face.meshed)
    }

    /// Whether a (distinct) point lies in the closed region that is meshed.
    pub(super) fn has_point(&self, v: u32) -> bool {
        match self.spokes(v) {
            [] => self
                .faces
                .get(self.face_around[v as usize] as usize)
                .is_some_and(|face| face.meshed),
            spokes => spokes.iter().any(|&h| self.faces[self.face[h as usize] as usize].meshed),
        }
    }

    /// The distinct points, from left to right (below to above where equal).
    pub(super) fn points_left_to_right(&self) -> &[u32] {
        &self.sorted
    }

    /// The distinct points, in the order of the file.
    pub(super) fn distinct_points(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.points.len() as u32).filter(|&v| self.same[v as usize] == v)
    }

    /// V − E + F of the closed region that is meshed, however it is triangulated: a face whose
    /// boundary has k pieces counts 2 − k.
    pub(super) fn euler_characteristic(&self) -> i64 {
        let faces = self.faces.iter().filter(|face| face.meshed).map(|face| 2 - face.pieces);
        let segments =
            (0..self.segments.len() as u32).filter(|&s| self.is_meshed(s)).count() as i64;
        let points = self.distinct_points().filter(|&v| self.has_point(v)).count() as i64;
        faces.sum::<i64>() - segments + points
    }

    /// Area and perimeter of the region that is meshed, in judged coordinates.
    pub(super) fn area_and_perimeter(&self) -> (f64, f64) {
        let Some(&origin) = self.sorted.first() else { return (0.0, 0.0) };
        let origin = self.points[origin as usize];
        let (mut doubled, mut perimeter) = (exact::Double::default(), 0.0);
        for (s, segment) in self.segments.iter().enumerate() {
            let [left, right] = self.sides(s as u32).map(|face| face.meshed);
            let [a, b] = segment.ends.map(|v| self.points[v as usize]);
            match (left, right) {
                (true, false) => doubled = doubled + exact::cross(origin, a, b),
                (false, true) => doubled = doubled - exact::cross(origin, a, b),
                _ => continue,
            }
            perimeter += distance(a, b);
        }
        (0.5 * doubled.to_f64(), perimeter)
    }

    /// The angle, from 0 to π, between two half-edges that leave one point.
    pub(super) fn angle(&self, g: u32, h: u32) -> Angle {
        let [x, p, q] =
            [self.origin(g), self.target(g), self.target(h)].map(|v| self.points[v as usize]);
        Angle(exact::corner(x, p, q))
    }

    /// Whether the half-edge `h` is reached from `g` by a turn to the right.
    pub(super) fn turns_back(&self, g: u32, h: u32) -> bool {
        self.angle(g, h).0.cross < 0.0
    }

    /// θ*: the smallest angle between two rotational neighbours at a point, at most π/3.
    pub(super) fn smallest_angle(&self) -> f64 {
        let mut smallest = std::f64::consts::FRAC_PI_3;
        for v in 0..self.points.len() as u32 {
            let spokes = self.spokes(v);
            for (i, &g) in spokes.iter().enumerate().skip(usize::from(spokes.len() == 2)) {
                let angle = self.angle(g, spokes[(i + 1) % spokes.len()]);
                if spokes.len() > 1 && angle.is_small() {
                    smallest = smallest.min(angle.radians());
                }
            }
        }
        smallest
    }

    /// How the outline's file counts a segment.
    pub(super) fn segment_name(&self, s: u32) -> Numbered {
        match self.segments[s as usize].input {
            NONE => Numbered { index: NONE, number: -1 },
            index => Numbered { index, number: self.pslg.source.segment_number(index) },
        }
    }

    /// How the outline's file counts a point.
    pub(super) fn point_name(&self, index: u32) -> Numbered {
        Numbered { index, number: self.pslg.source.point_number(index) }
    }
}

/// The angle θ of two segments at their common end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Angle(exact::Corner);

impl Angle {
    pub(super) fn radians(self) -> f64 {
        libm::atan2(self.0.cross.abs(), self.0.dot)
    }

    /// Whether it is at most π/3 (1e-12 more counts as π/3).
    pub(super) fn is_small(self) -> bool {
        self.0.dot > 0.0 && self.0.cross.abs() <= 3.0_f64.sqrt() * (1.0 + 1e-12) * self.0.dot
    }

    /// f(θ) = arctan(sin θ / (2 − cos θ)) of Lemma 7.
    pub(super) fn lemma_7(self) -> f64 {
        libm::atan2(self.0.cross.abs(), 2.0 * self.0.lengths - self.0.dot)
    }
}

/// The segments that a vertical line meets, from below to above, each as the half-edge that goes
/// to the right.
#[derive(Default)]
struct Status {
    halves: Vec<u32>,
}

impl Status {
    /// How many of them lie below `p`.
    fn below(&self, outline: &Outline, p: [f64; 2]) -> usize {
        self.halves.partition_point(|&h| side(outline, h, p) == Ordering::Greater)
    }

    /// Whether `p`, above `below` of them, lies on the next one.
    fn on(&self, outline: &Outline, below: usize, p: [f64; 2]) -> bool {
        self.halves.get(below).is_some_and(|&h| side(outline, h, p) == Ordering::Equal)
    }

    /// The face between the one that is `below` and the next.
    fn face_above(&self, below: usize, cycle: &[u32], face_of_cycle: &[u32]) -> u32 {
        let half = below.checked_sub(1).map(|i| self.halves[i]);
        let face = half.map_or(0, |h| face_of_cycle[cycle[h as usize] as usize]);
        if face == NONE { 0 } else { face }
    }

    /// Takes out what ends at `v`; how many lie below it.
    fn remove_ending(&mut self, outline: &Outline, v: u32) -> usize {
        let ending = |h: u32| outline.target(h) == v;
        let below = self.below(outline, outline.points[v as usize]);
        let count = self.halves[below..].iter().take_while(|&&h| ending(h)).count();
        self.halves.drain(below..below + count);
        let expected = outline.spokes(v).iter().filter(|&&h| {
            lexicographic(outline.points[outline.target(h) as usize], outline.points[v as usize])
                == Ordering::Less
        });
        if expected.count() != count {
            // Segments cross: the order is not what it should be.
            self.halves.retain(|&h| !ending(h));
        }
        below.min(self.halves.len())
    }

    fn insert(&mut self, below: usize, halves: impl Iterator<Item = u32>) {
        self.halves.splice(below..below, halves);
    }
}

/// On which side of a half-edge `p` lies: `Greater` above.
fn side(outline: &Outline, h: u32, p: [f64; 2]) -> Ordering {
    let [a, b] = [outline.origin(h), outline.target(h)].map(|v| outline.points[v as usize]);
    exact::orientation(a, b, p)
}

/// Counter-clockwise around `x`, from the direction of the first axis.
fn by_direction(x: [f64; 2], p: [f64; 2], q: [f64; 2]) -> Ordering {
    rises(x, q).cmp(&rises(x, p)).then_with(|| exact::orientation(x, q, p))
}

fn rises(p: [f64; 2], q: [f64; 2]) -> bool {
    q[1] > p[1] || (q[1] == p[1] && q[0] > p[0])
}

fn ordered([v, w]: [u32; 2]) -> [u32; 2] {
    [v.min(w), v.max(w)]
}

/// The distance of two points, rounded.
pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    distance_squared(a, b).sqrt()
}

/// Its square.
pub(super) fn distance_squared(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    x * x + y * y
}
