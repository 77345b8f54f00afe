//! The segments that end at each point, in rotational order.

use std::cmp::Ordering;

use crate::columns::lexicographic;
use crate::predicates::{Side, side};

/// For each point the segments that end there, counter-clockwise from straight down (exclusive):
/// first those that lead to lexicographically greater points, from the lowest to the highest,
/// then those to smaller points, from the highest to the lowest. Segments in one direction follow
/// each other by their numbers.
///
/// Returns the array of starts (one more than there are points) and the array of segments.
pub fn adjoining(points: &[[f64; 2]], segments: &[[u32; 2]]) -> (Vec<u32>, Vec<u32>) {
    let mut start = vec![0_u32; points.len() + 1];
    for &[a, b] in segments {
        start[a as usize + 1] += 1;
        start[b as usize + 1] += 1;
    }
    for point in 0..points.len() {
        start[point + 1] += start[point];
    }
    let mut filled = start.clone();
    let mut adjoining = vec![0_u32; 2 * segments.len()];
    for (index, &ends) in (0..).zip(segments) {
        for end in ends {
            adjoining[filled[end as usize] as usize] = index;
            filled[end as usize] += 1;
        }
    }
    for (apex, range) in (0..).zip(start.windows(2)) {
        adjoining[range[0] as usize..range[1] as usize]
            .sort_unstable_by(|&s, &t| rotational(points, segments, apex, s, t).then(s.cmp(&t)));
    }
    (start, adjoining)
}

/// The other end of the segment with the given ends. (Without a branch: which one it is nobody
/// guesses.)
#[inline]
pub fn other_end([a, b]: [u32; 2], end: u32) -> u32 {
    a ^ b ^ end
}

/// Which of the segments `s`, `t` comes first, turning counter-clockwise about `apex` from
/// straight down; `Equal` where they leave in one direction.
fn rotational(points: &[[f64; 2]], segments: &[[u32; 2]], apex: u32, s: u32, t: u32) -> Ordering {
    let apex_place = points[apex as usize];
    let place = |segment: u32| points[other_end(segments[segment as usize], apex) as usize];
    let leads_left = |place| lexicographic(place, apex_place).is_lt();
    let (a, b) = (place(s), place(t));
    leads_left(a).cmp(&leads_left(b)).then_with(|| match side(apex_place, a, b) {
        Side::Left => Ordering::Less,
        Side::On => Ordering::Equal,
        Side::Right => Ordering::Greater,
    })
}
