//! Holes by nesting: which faces an odd number of loops encloses.
//!
//! Slits and dangling segments (one face on both sides) enclose nothing and do not count. The
//! others form connected pieces. A piece with an even number of segments at each of its points is
//! made of loops: crossing any of its segments leads into or out of one. Another piece is the
//! partition of one whole, e.g. two rooms with a wall between them: all its faces lie equally deep.

use super::adjoining::other_end;
use super::faces::{Faces, OUTSIDE};
use super::sweep::Linework;

/// For each face whether an odd number of loops encloses it.
pub fn nested_oddly(linework: &Linework, faces: &Faces) -> Vec<bool> {
    let pieces = Pieces::new(linework, faces);
    let (start, around) = segments_around(linework, faces);
    let mut depth_is_odd = vec![None; faces.count() as usize];
    let mut inside_is_odd = vec![None; pieces.is_loops.len()];
    depth_is_odd[OUTSIDE as usize] = Some(false);
    let mut pending = vec![OUTSIDE];
    while let Some(face) = pending.pop() {
        let is_odd = depth_is_odd[face as usize] == Some(true);
        let range = start[face as usize] as usize..start[face as usize + 1] as usize;
        for &segment in &around[range] {
            let piece = pieces.of_segment(linework, segment);
            // The face around a piece is reached before those that the piece encloses.
            let inside = *inside_is_odd[piece].get_or_insert(!is_odd);
            let [left, right] = faces.sides(segment);
            let across = if left == face { right } else { left };
            if depth_is_odd[across as usize].is_none() {
                let across_is_odd = if pieces.is_loops[piece] { !is_odd } else { inside };
                depth_is_odd[across as usize] = Some(across_is_odd);
                pending.push(across);
            }
        }
    }
    depth_is_odd.into_iter().map(|is_odd| is_odd == Some(true)).collect()
}

/// The connected parts of the segments that have two faces.
struct Pieces {
    /// The piece of each point.
    of_point: Vec<u32>,
    /// Whether each piece is made of loops.
    is_loops: Vec<bool>,
}

impl Pieces {
    fn new(linework: &Linework, faces: &Faces) -> Self {
        let unknown = u32::MAX;
        let mut of_point = vec![unknown; linework.points.len()];
        let mut is_loops = Vec::new();
        let mut pending = Vec::new();
        for first in 0..of_point.len() as u32 {
            if of_point[first as usize] != unknown {
                continue;
            }
            let piece = is_loops.len() as u32;
            let mut has_only_even_points = true;
            of_point[first as usize] = piece;
            pending.push(first);
            while let Some(point) = pending.pop() {
                let mut degree = 0;
                for &segment in linework.adjoining_at(point) {
                    if !separates(faces, segment) {
                        continue;
                    }
                    degree += 1;
                    let other = other_end(linework.segments[segment as usize], point);
                    if of_point[other as usize] == unknown {
                        of_point[other as usize] = piece;
                        pending.push(other);
                    }
                }
                has_only_even_points &= degree % 2 == 0;
            }
            is_loops.push(has_only_even_points);
        }
        Self { of_point, is_loops }
    }

    fn of_segment(&self, linework: &Linework, segment: u32) -> usize {
        self.of_point[linework.segments[segment as usize][0] as usize] as usize
    }
}

/// Whether a segment has two faces.
fn separates(faces: &Faces, segment: u32) -> bool {
    let [left, right] = faces.sides(segment);
    left != right
}

/// The segments around each face that separate it from another: the array of starts and that of
/// segments.
fn segments_around(linework: &Linework, faces: &Faces) -> (Vec<u32>, Vec<u32>) {
    let separating = || (0..linework.segments.len() as u32).filter(|&s| separates(faces, s));
    let mut start = vec![0_u32; faces.count() as usize + 1];
    for face in separating().flat_map(|segment| faces.sides(segment)) {
        start[face as usize + 1] += 1;
    }
    for face in 1..start.len() {
        start[face] += start[face - 1];
    }
    let mut filled = start.clone();
    let mut around = vec![0; start[start.len() - 1] as usize];
    for segment in separating() {
        for face in faces.sides(segment) {
            around[filled[face as usize] as usize] = segment;
            filled[face as usize] += 1;
        }
    }
    (start, around)
}
