//! The faces that segments cut the plane into, and which of them are meshed.
//!
//! A face is what a flood from a seed reaches without crossing a segment: what lies inside a loop
//! less what lies inside the loops within it. Every segment has two directed sides, each with a
//! face to its left; following them, always taking the next side clockwise at a point, runs around
//! a face. A connected part of the linework has one such cycle around its outside, recognised
//! where it passes its leftmost point; that cycle bounds the face in which the part lies, which the
//! segment below its leftmost point tells.

use super::adjoining::other_end;
use super::sweep::{Linework, Located};
use crate::columns::lexicographic;

/// The face outside of everything.
pub const OUTSIDE: u32 = 0;

/// The faces of a linework.
#[derive(Debug, Clone)]
pub struct Faces {
    /// The face to the left of each directed segment: `2s` is segment `s` as it is given, `2s + 1`
    /// is its reverse.
    left: Vec<u32>,
    /// For each face: whether it is meshed.
    meshed: Vec<bool>,
    /// For each face: the region whose seed it holds.
    regions: Vec<Option<u32>>,
}

impl Faces {
    /// The faces; none of them is meshed or has a region yet.
    pub(super) fn new(linework: &Linework, located: &Located) -> Self {
        let cycles = Cycles::new(linework);
        let unknown = u32::MAX;
        // The face of each cycle; cycles around the outside of a connected part come last.
        let mut face = vec![unknown; cycles.count];
        let parts = connected_parts(linework);
        let outer: Vec<usize> =
            parts.iter().map(|&place| cycles.around(linework.order[place])).collect();
        for &cycle in &outer {
            face[cycle] = OUTSIDE;
        }
        let mut count = OUTSIDE + 1;
        for face in face.iter_mut().filter(|face| **face == unknown) {
            *face = count;
            count += 1;
        }
        let mut faces = Self { left: Vec::new(), meshed: Vec::new(), regions: Vec::new() };
        // From left to right: what lies below a part belongs to one that is done.
        for (&place, &cycle) in parts.iter().zip(&outer) {
            if let Some(side) = upper_side(linework, located.below[place]) {
                face[cycle] = face[cycles.of_side[side] as usize];
            }
        }
        faces.left = cycles.of_side.iter().map(|&cycle| face[cycle as usize]).collect();
        faces.meshed = vec![false; count as usize];
        faces.regions = vec![None; count as usize];
        faces
    }

    /// The number of faces, the [`OUTSIDE`] included.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.meshed.len() as u32
    }

    /// The faces to the left and to the right of a segment, seen from its first end.
    #[must_use]
    pub fn sides(&self, segment: u32) -> [u32; 2] {
        let side = 2 * segment as usize;
        [self.left[side], self.left[side + 1]]
    }

    /// Whether a face is meshed.
    #[must_use]
    pub fn is_meshed(&self, face: u32) -> bool {
        self.meshed[face as usize]
    }

    /// Whether every face but the [`OUTSIDE`] is meshed.
    #[must_use]
    pub fn all_are_meshed(&self) -> bool {
        (OUTSIDE + 1..self.count()).all(|face| self.is_meshed(face))
    }

    /// Whether no face belongs to a region.
    #[must_use]
    pub fn none_has_a_region(&self) -> bool {
        self.regions.iter().all(Option::is_none)
    }

    /// The region that a face belongs to, as an index into
    /// [`Domain::regions`](super::Domain::regions).
    #[must_use]
    pub fn region(&self, face: u32) -> Option<u32> {
        self.regions[face as usize]
    }

    /// The face directly above a segment; outside of everything where there is none.
    pub(super) fn above(&self, linework: &Linework, segment: u32) -> u32 {
        upper_side(linework, segment).map_or(OUTSIDE, |side| self.left[side])
    }

    pub(super) fn set_meshed(&mut self, face: u32, is_meshed: bool) {
        self.meshed[face as usize] = is_meshed;
    }

    pub(super) fn set_region(&mut self, face: u32, region: u32) {
        self.regions[face as usize] = Some(region);
    }
}

/// The side of a segment that looks upwards; `None` for no segment.
fn upper_side(linework: &Linework, segment: u32) -> Option<usize> {
    let &[a, b] = linework.segments.get(segment as usize)?;
    let is_reversed =
        lexicographic(linework.points[a as usize], linework.points[b as usize]).is_gt();
    Some(2 * segment as usize + usize::from(is_reversed))
}

/// The cycles of sides around faces.
struct Cycles<'a> {
    linework: &'a Linework<'a>,
    count: usize,
    /// The cycle of each directed side.
    of_side: Vec<u32>,
}

impl<'a> Cycles<'a> {
    fn new(linework: &'a Linework<'a>) -> Self {
        let next = next_sides(linework);
        let unknown = u32::MAX;
        let mut of_side = vec![unknown; next.len()];
        let mut count = 0;
        for start in 0..next.len() {
            let mut side = start;
            if of_side[side] == unknown {
                while of_side[side] == unknown {
                    of_side[side] = count;
                    side = next[side] as usize;
                }
                count += 1;
            }
        }
        Self { linework, count: count as usize, of_side }
    }

    /// The cycle around a connected part, from its leftmost point.
    fn around(&self, leftmost: u32) -> usize {
        // All segments lead to the right, the last one is the highest: left of it is outside.
        let last = self.linework.adjoining_start[leftmost as usize + 1] - 1;
        let highest = self.linework.adjoining[last as usize];
        self.of_side[side_from(self.linework, leftmost, highest)] as usize
    }
}

/// The side of a segment that leads away from one of its ends.
fn side_from(linework: &Linework, end: u32, segment: u32) -> usize {
    2 * segment as usize + usize::from(linework.segments[segment as usize][0] != end)
}

/// For each side the one that follows it around the face to its left.
fn next_sides(linework: &Linework) -> Vec<u32> {
    let mut next = vec![0; 2 * linework.segments.len()];
    for point in 0..linework.points.len() as u32 {
        let adjoining = linework.adjoining_at(point);
        for (index, &segment) in adjoining.iter().enumerate() {
            // Arriving along the reverse of `counter_clockwise`, the face to the left lies
            // clockwise of it: leave along `segment`.
            let counter_clockwise = adjoining[(index + 1) % adjoining.len()];
            let arriving = side_from(linework, point, counter_clockwise) ^ 1;
            next[arriving] = side_from(linework, point, segment) as u32;
        }
    }
    next
}

/// The leftmost point of each connected part of the linework, from left to right, by its place in the
/// order.
fn connected_parts(linework: &Linework) -> Vec<usize> {
    let mut parts = Vec::new();
    let mut is_known = vec![false; linework.points.len()];
    let mut pending = Vec::new();
    for (place, &leftmost) in linework.order.iter().enumerate() {
        if is_known[leftmost as usize] || linework.adjoining_at(leftmost).is_empty() {
            continue;
        }
        parts.push(place);
        is_known[leftmost as usize] = true;
        pending.push(leftmost);
        while let Some(point) = pending.pop() {
            for &segment in linework.adjoining_at(point) {
                let other = other_end(linework.segments[segment as usize], point);
                if !is_known[other as usize] {
                    is_known[other as usize] = true;
                    pending.push(other);
                }
            }
        }
    }
    parts
}
