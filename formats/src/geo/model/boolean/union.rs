//! The union: faces put together, without what lay between them.

use super::Cut;
use super::arrangement::{Arrangement, Piece, Side};
use super::faces::{Face, doubled_area, trace};
use super::track::{Track, distance};

impl Cut {
    /// Puts faces together; the new faces, as indices.
    pub(super) fn unite(&mut self, faces: &[usize]) -> Vec<usize> {
        let mut boundary: Vec<Side> = Vec::new();
        for &face in faces {
            let (face, _) = &self.faces[face];
            let is_mirrored = doubled_area(&self.arrangement, &face.loops[0]) < 0.0;
            for &side in face.loops.iter().flatten() {
                let side = if is_mirrored { side.reversed() } else { side };
                match boundary.iter().position(|other| other.piece == side.piece) {
                    // It lies between two faces.
                    Some(place) => drop(boundary.remove(place)),
                    None => boundary.push(side),
                }
            }
        }
        let united = trace(&self.arrangement, &boundary, &[], false);
        let mut indices = Vec::with_capacity(united.len());
        for face in united {
            let loops = face.loops.iter().map(|sides| joined(&mut self.arrangement, sides));
            let face = Face { loops: loops.collect(), inner: Vec::new() };
            let index = self.faces.len();
            for argument in &mut self.arguments {
                let is_part = |&old: &usize| {
                    let inside = self.faces[old].0.loops[0][0];
                    let at = self.arrangement.track(inside).at(0.5);
                    let is_on = face.loops.iter().flatten().any(|&side| {
                        let track = self.arrangement.track(side);
                        track.parameter(at, self.arrangement.tolerance).is_some()
                    });
                    is_on || super::holds(&self.arrangement, &face.loops, at)
                };
                if argument.faces.iter().any(is_part) {
                    argument.faces.push(index);
                }
            }
            self.faces.push((face, usize::MAX));
            indices.push(index);
        }
        indices
    }
}

/// A loop whose sides on one line or circle are one piece each.
fn joined(arrangement: &mut Arrangement, sides: &[Side]) -> Vec<Side> {
    let mut ring = in_a_row(arrangement, sides);
    // Begin where two sides do not join, so that none joins around the end.
    let breaks =
        |i: usize| join(arrangement, ring[(i + ring.len() - 1) % ring.len()], ring[i]).is_none();
    if let Some(first) = (0..ring.len()).find(|&i| breaks(i)) {
        ring.rotate_left(first);
    }
    let mut result: Vec<Side> = Vec::new();
    for side in ring {
        let joined = result.last().and_then(|&last| join(arrangement, last, side));
        match joined {
            Some(piece) => {
                arrangement.pieces.push(piece);
                result.pop();
                result.push(Side { piece: arrangement.pieces.len() - 1, forward: true });
            }
            None => result.push(side),
        }
    }
    result.reverse();
    result
}

/// The sides of a loop, each behind the one that ends where it begins.
fn in_a_row(arrangement: &Arrangement, sides: &[Side]) -> Vec<Side> {
    let mut left = sides.to_vec();
    let mut ring = Vec::with_capacity(left.len());
    while let Some(side) = match ring.last() {
        None => left.pop(),
        Some(&last) => {
            let [_, end] = arrangement.ends(last);
            let next = left.iter().position(|&side| arrangement.ends(side)[0] == end);
            next.map(|next| left.remove(next))
        }
    } {
        ring.push(side);
    }
    ring.append(&mut left);
    ring
}

/// The one piece that two sides in a row are, where they are parts of one line or circle; where a
/// circle began they stay two, as in Gmsh.
fn join(arrangement: &Arrangement, a: Side, b: Side) -> Option<Piece> {
    let ([first, middle], [next, last]) = (arrangement.ends(a), arrangement.ends(b));
    if middle != next || a.piece == b.piece || arrangement.seams.contains(&middle) {
        return None;
    }
    let tolerance = arrangement.tolerance;
    let track = match (arrangement.track(a), arrangement.track(b)) {
        (Track::Line { from, .. }, Track::Line { to, .. }) => {
            let whole = Track::Line { from, to };
            whole.parameter(arrangement.vertices[middle], tolerance)?;
            whole
        }
        (
            Track::Arc { centre, radius, from, to },
            Track::Arc { centre: other, radius: s, from: begin, to: end },
        ) => {
            let is_one = distance(centre, other) <= tolerance
                && (radius - s).abs() <= tolerance
                && (to > from) == (end > begin);
            if !is_one {
                return None;
            }
            Track::Arc { centre, radius, from, to: to + (end - begin) }
        }
        _ => return None,
    };
    Some(Piece { track, ends: [first, last], whole: None })
}
