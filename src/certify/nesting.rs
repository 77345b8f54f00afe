//! The judge's own reading of holes by nesting.
//!
//! Only the segments with two faces count, the *borders*. Where an even number of borders ends at
//! each point of a connected piece, the sectors around each point lie in and out of a loop in
//! turn. In any other piece all faces but the one around it lie in it alike.

use super::outline::Outline;

/// For each face of an outline whether it lies in an odd number of loops.
pub(super) fn is_nested_oddly(outline: &Outline) -> Vec<bool> {
    let mut is_odd = vec![false; outline.faces.len()];
    let mut is_known = vec![false; outline.points.len()];
    // From left to right: the piece that encloses another one reaches farther to the left.
    for &v in outline.points_left_to_right() {
        if is_known[v as usize] {
            continue;
        }
        let Some(outward) = outline.towards_left(&borders(outline, v)) else { continue };
        let around = outline.face(outward);
        let outside = is_odd[around as usize];
        let piece = walk(outline, outward, outside, &mut is_known);
        let is_loops = piece.iter().all(|sectors| sectors.len() % 2 == 0);
        for (h, in_turn) in piece.into_iter().flatten() {
            let face = outline.face(h);
            if face != around {
                is_odd[face as usize] = if is_loops { in_turn } else { !outside };
            }
        }
    }
    is_odd
}

/// For each point of the piece that the half-edge `from` leads into: each half-edge that leaves it
/// along a border, and whether its left lies in an odd number of loops if that changes at each.
fn walk(outline: &Outline, from: u32, odd: bool, is_known: &mut [bool]) -> Vec<Vec<(u32, bool)>> {
    let mut piece = Vec::new();
    let mut pending = vec![(from, odd)];
    is_known[outline.origin(from) as usize] = true;
    while let Some((h, odd)) = pending.pop() {
        let spokes = borders(outline, outline.origin(h));
        let turn = spokes.iter().position(|&g| g == h).unwrap_or(0);
        let in_turn = spokes[turn..].iter().chain(&spokes[..turn]).copied();
        let sectors: Vec<_> = in_turn.enumerate().map(|(i, g)| (g, odd ^ (i % 2 == 1))).collect();
        for &(g, odd) in &sectors {
            let next = outline.target(g) as usize;
            if !std::mem::replace(&mut is_known[next], true) {
                pending.push((g ^ 1, !odd));
            }
        }
        piece.push(sectors);
    }
    piece
}

/// The half-edges that leave a point with another face on their right than on their left,
/// counter-clockwise.
fn borders(outline: &Outline, v: u32) -> Vec<u32> {
    let has_two_faces = |&&h: &&u32| outline.face(h) != outline.face(h ^ 1);
    outline.spokes(v).iter().filter(has_two_faces).copied().collect()
}
