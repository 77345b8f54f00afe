//! The faces that the pieces in a surface divide it into.
//!
//! Faces and their sides come in the order in which OpenCASCADE finds them, because Gmsh numbers
//! curves and surfaces in that order.

use std::f64::consts::TAU;

use super::arrangement::{Arrangement, Side};
use super::track::Place;

/// A face: its outer loop, then its holes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Face {
    pub loops: Vec<Vec<Side>>,
    /// Pieces inside that bound nothing.
    pub inner: Vec<usize>,
}

impl Face {
    /// Its pieces, sorted: what tells it from others.
    pub(super) fn key(&self) -> Vec<usize> {
        let mut key: Vec<usize> = self.loops.iter().flatten().map(|side| side.piece).collect();
        key.sort_unstable();
        key
    }
}

/// Divides a surface: `loops` are its sides, the outer loop first, the surface to their left (to the
/// right, if `mirrored`); `inner` the pieces inside it.
pub(super) fn divide(
    arrangement: &Arrangement,
    loops: Vec<Vec<Side>>,
    inner: &[usize],
    mirrored: bool,
) -> Vec<Face> {
    match inner {
        [] => vec![Face { loops, inner: Vec::new() }],
        inner => trace(arrangement, &loops.concat(), inner, mirrored),
    }
}

/// The faces between the sides of a boundary and the pieces inside it.
pub(super) fn trace(
    arrangement: &Arrangement,
    boundary: &[Side],
    inner: &[usize],
    mirrored: bool,
) -> Vec<Face> {
    let (bounding, dangling) = without_ends(arrangement, boundary, inner);
    let mut sides = boundary.to_vec();
    for piece in bounding {
        sides.extend([Side { piece, forward: true }, Side { piece, forward: false }]);
    }
    let sign = if mirrored { -1.0 } else { 1.0 };
    let mut faces: Vec<(f64, Face)> = Vec::new();
    let mut holes = Vec::new();
    for one in loops(arrangement, &sides, sign) {
        let area = sign * doubled_area(arrangement, &one);
        if area > 0.0 {
            faces.push((area, Face { loops: vec![one], inner: Vec::new() }));
        } else {
            holes.push(one);
        }
    }
    for hole in holes {
        let inside = arrangement.track(hole[0]).at(0.5);
        let pieces: Vec<usize> = hole.iter().map(|side| side.piece).collect();
        let around = |(_, face): &&mut (f64, Face)| {
            let is_apart = face.loops[0].iter().all(|side| !pieces.contains(&side.piece));
            is_apart && holds(arrangement, &face.loops[..1], inside)
        };
        let smallest = faces.iter_mut().filter(around).min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, face)) = smallest {
            face.loops.push(hole);
        }
    }
    for piece in dangling {
        let inside = arrangement.pieces[piece].track.at(0.5);
        let of_face = faces.iter_mut().find(|(_, face)| holds(arrangement, &face.loops, inside));
        if let Some((_, face)) = of_face {
            face.inner.push(piece);
        }
    }
    faces.into_iter().map(|(_, face)| face).collect()
}

/// Whether a place lies within loops, by even and odd.
pub(super) fn holds(arrangement: &Arrangement, loops: &[Vec<Side>], p: Place) -> bool {
    let sides = loops.iter().flatten();
    let crossings =
        sides.map(|&side| arrangement.track(side).crossings_right_of(p, arrangement.places(side)));
    crossings.sum::<usize>() % 2 == 1
}

/// Twice the area to the left of a loop. (Its sides may come in any order.)
pub(super) fn doubled_area(arrangement: &Arrangement, sides: &[Side]) -> f64 {
    sides.iter().map(|&side| arrangement.track(side).doubled_area()).sum()
}

/// The pieces that do not dangle, then those that do: with an end where nothing else ends.
fn without_ends(
    arrangement: &Arrangement,
    boundary: &[Side],
    inner: &[usize],
) -> (Vec<usize>, Vec<usize>) {
    let mut ending = vec![0_u32; arrangement.vertices.len()];
    let all = boundary.iter().map(|side| side.piece).chain(inner.iter().copied());
    all.for_each(|piece| arrangement.pieces[piece].ends.iter().for_each(|&v| ending[v] += 1));
    let (mut left, mut dangling) = (inner.to_vec(), Vec::new());
    loop {
        let dangles =
            |&piece: &usize| arrangement.pieces[piece].ends.iter().any(|&v| ending[v] == 1);
        let Some(place) = left.iter().position(dangles) else { return (left, dangling) };
        let piece = left.remove(place);
        arrangement.pieces[piece].ends.iter().for_each(|&v| ending[v] -= 1);
        dangling.push(piece);
    }
}

/// The closed ways along sides with the least inside; in each the last side first.
fn loops(arrangement: &Arrangement, sides: &[Side], sign: f64) -> Vec<Vec<Side>> {
    let (mut simple, mut found) = (Vec::new(), Vec::new());
    for block in blocks(arrangement, sides) {
        match is_simple(arrangement, &block) {
            true => simple.push(block),
            false => found.extend(Walk::new(arrangement, &block, sign).loops()),
        }
    }
    simple.extend(found);
    simple
}

/// The connected parts of some sides, each in the order of its distance from its first side.
fn blocks(arrangement: &Arrangement, sides: &[Side]) -> Vec<Vec<Side>> {
    let mut at = vec![Vec::new(); arrangement.vertices.len()];
    for (i, &side) in sides.iter().enumerate() {
        arrangement.pieces[side.piece].ends.iter().for_each(|&v| at[v].push(i));
    }
    let mut known = vec![false; sides.len()];
    let mut blocks = Vec::new();
    for first in 0..sides.len() {
        if std::mem::replace(&mut known[first], true) {
            continue;
        }
        let mut block = vec![first];
        let mut next = 0;
        while let Some(&i) = block.get(next) {
            next += 1;
            for v in arrangement.pieces[sides[i].piece].ends {
                for &j in &at[v] {
                    if !std::mem::replace(&mut known[j], true) {
                        block.push(j);
                    }
                }
            }
        }
        blocks.push(block.into_iter().map(|i| sides[i]).collect());
    }
    blocks
}

/// Whether some sides are one closed way.
fn is_simple(arrangement: &Arrangement, block: &[Side]) -> bool {
    let mut ending = vec![0_u32; arrangement.vertices.len()];
    for side in block {
        arrangement.pieces[side.piece].ends.iter().for_each(|&v| ending[v] += 1);
    }
    let is_even = ending.iter().all(|&count| count == 0 || count == 2);
    is_even && block.iter().all(|side| !block.contains(&side.reversed()))
}

/// A walk along the sides of a block that always turns as far to the left as it can.
struct Walk<'a> {
    arrangement: &'a Arrangement,
    sign: f64,
    /// The vertices in the order in which the sides name them.
    order: Vec<usize>,
    /// By vertex: the sides that leave it, and whether they were walked along.
    leaving: Vec<Vec<(Side, bool)>>,
    /// How far from a vertex directions are taken.
    reach: Vec<f64>,
}

impl<'a> Walk<'a> {
    fn new(arrangement: &'a Arrangement, block: &[Side], sign: f64) -> Self {
        let count = arrangement.vertices.len();
        let (mut leaving, mut reach) = (vec![Vec::new(); count], vec![f64::INFINITY; count]);
        let (mut order, mut known) = (Vec::new(), vec![false; count]);
        for &side in block {
            let [from, to] = arrangement.ends(side);
            leaving[from].push((side, false));
            for v in arrangement.pieces[side.piece].ends {
                if !std::mem::replace(&mut known[v], true) {
                    order.push(v);
                }
            }
            let length = 0.01 * arrangement.pieces[side.piece].track.length();
            reach[from] = reach[from].min(length);
            reach[to] = reach[to].min(length);
        }
        Self { arrangement, sign, order, leaving, reach }
    }

    fn loops(mut self) -> Vec<Vec<Side>> {
        let mut loops = Vec::new();
        for v in self.order.clone() {
            for i in 0..self.leaving[v].len() {
                if !self.leaving[v][i].1 {
                    self.follow(v, i, &mut loops);
                }
            }
        }
        loops
    }

    /// Walks from a vertex along its `i`-th side until it is back; whatever closes on the way is a
    /// loop.
    fn follow(&mut self, v: usize, i: usize, loops: &mut Vec<Vec<Side>>) {
        let mut way: Vec<(usize, Side)> = Vec::new();
        let (mut v, mut i) = (v, i);
        loop {
            let (side, walked) = &mut self.leaving[v][i];
            *walked = true;
            way.push((v, *side));
            let arrived = *side;
            let [_, here] = self.arrangement.ends(arrived);
            if let Some(begin) = way.iter().rposition(|&(from, _)| from == here) {
                loops.push(way.drain(begin..).rev().map(|(_, side)| side).collect());
            }
            let Some(&(_, last)) = way.last() else { return };
            let Some(next) = self.leftmost(here, last) else { return };
            (v, i) = (here, next);
        }
    }

    /// The side that leaves a vertex farthest to the left, seen from the one that arrives there.
    fn leftmost(&self, v: usize, arriving: Side) -> Option<usize> {
        let back = self.direction(v, arriving.reversed());
        let turn = |side: Side| {
            let turn = self.sign * (back - self.direction(v, side));
            let turn = turn - TAU * (turn / TAU).floor();
            // The way back is the last resort.
            if side == arriving.reversed() { TAU } else { turn }
        };
        let left = self.leaving[v].iter().enumerate().filter(|(_, (_, walked))| !walked);
        let left = left.map(|(i, &(side, _))| (turn(side), i));
        left.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
    }

    /// The direction in which a side leaves a vertex, in radians.
    fn direction(&self, v: usize, side: Side) -> f64 {
        let track = self.arrangement.track(side);
        let from = self.arrangement.vertices[v];
        let to = track.at((self.reach[v] / track.length()).min(1.0));
        libm::atan2(to[1] - from[1], to[0] - from[0])
    }
}
