//! The convex hull of the points.

use std::ops::ControlFlow;

use super::sweep::cross;
use crate::boxes::{Boxes, Rectangle};
use crate::columns::in_columns;
use crate::predicates::{Side, side};
use crate::vector::Vector;

/// The points from left to right that are not known to lie farther than `margin` within the convex
/// hull; `core`: a rectangle within it.
pub fn outer(points: &[[f64; 2]], core: Rectangle, margin: f64) -> Vec<u32> {
    let is_outer = |&point: &u32| !core.holds_well(points[point as usize], margin);
    let outer = in_columns(points, (0..points.len() as u32).filter(is_outer));
    outer.into_iter().map(|placed| placed as u32).collect()
}

/// The edges of the convex hull, counter-clockwise, split at every point that lies on it.
/// `outer`: from left to right points among which those are, all distinct and not all on one line.
pub fn hull_edges(points: &[[f64; 2]], outer: &[u32]) -> Vec<[u32; 2]> {
    let mut edges = chain(points, outer.iter().copied());
    edges.extend(chain(points, outer.iter().rev().copied()));
    edges
}

/// Whether all points, which are distinct, lie on one line.
pub fn is_on_a_line(points: &[[f64; 2]]) -> bool {
    let [first, second, ..] = points[..] else { return true };
    points.iter().all(|&point| side(first, second, point) == Side::On)
}

/// Those of the hull edges that are no segments yet.
pub fn missing(hull_edges: Vec<[u32; 2]>, segments: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let undirected = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
    let mut present: Vec<[u32; 2]> = segments.iter().copied().map(undirected).collect();
    present.sort_unstable();
    let missing = |&edge: &[u32; 2]| present.binary_search(&undirected(edge)).is_err();
    hull_edges.into_iter().filter(missing).collect()
}

/// The same edges, but through every one of the `outer` points that is nearer to one of them than
/// `closest`. `on_hull`: the points at which hull edges end.
///
/// A hull edge that passes a point at rounding distance (points along the side of a turned
/// rectangle) would ask for triangles as thin as that. Through those points the boundary is as
/// convex as doubles can tell.
pub fn through_near_points(
    edges: &[[u32; 2]],
    points: &[[f64; 2]],
    outer: &[u32],
    on_hull: &[bool],
    closest: f64,
) -> Vec<[u32; 2]> {
    let at = |edge: u32| edges[edge as usize].map(|end| points[end as usize]);
    let rectangles: Vec<_> =
        (0..edges.len() as u32).map(at).map(|[a, b]| Rectangle::around(a, b)).collect();
    let boxes = Boxes::new(&rectangles);
    let mut beside: Vec<(u32, f64, u32)> = Vec::new();
    for &point in outer.iter().filter(|&&point| !on_hull[point as usize]) {
        let place = points[point as usize];
        // Squared, and infinite where the foot is not between the ends.
        let distance = |edge: u32| {
            let [a, b] = at(edge);
            let (along, to_a) = (Vector::between(a, b), Vector::between(a, place));
            let height = along.cross(to_a) / along.length();
            let foot = along.dot(to_a) / along.dot(along);
            if 0.0 < foot && foot < 1.0 { height * height } else { f64::INFINITY }
        };
        let mut budget = usize::MAX;
        let bound = closest * closest;
        if let Some((edge, _)) = boxes.nearest(place, bound, &mut budget, |_| false, distance) {
            let [a, b] = at(edge);
            beside.push((edge, Vector::between(a, b).dot(Vector::between(a, place)), point));
        }
    }
    beside.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut beside = beside.into_iter().peekable();
    let mut chain = Vec::with_capacity(edges.len());
    for (edge, &[a, b]) in (0..).zip(edges) {
        let mut from = a;
        while let Some((_, _, point)) = beside.next_if(|&(own, ..)| own == edge) {
            chain.push([from, point]);
            from = point;
        }
        chain.push([from, b]);
    }
    chain
}

/// Whether a segment crosses one of the edges. Edges of the hull itself are crossed by nothing; one
/// that is bent through a point beside it may be.
pub fn is_crossed(edges: &[[u32; 2]], points: &[[f64; 2]], segments: &[[u32; 2]]) -> bool {
    let at = |ends: [u32; 2]| ends.map(|end| points[end as usize]);
    let around = |&ends: &[u32; 2]| {
        let [a, b] = at(ends);
        Rectangle::around(a, b)
    };
    let rectangles: Vec<_> = segments.iter().map(around).collect();
    let boxes = Boxes::new(&rectangles);
    edges.iter().any(|edge| {
        let crossed = boxes.overlapping(&around(edge), |segment| {
            if cross(at(*edge), at(segments[segment as usize])) {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        crossed.is_break()
    })
}

/// Whether the hull is narrower than `closest`: then its points lie on one line as far as doubles
/// can tell. (A convex set's width is at most twice its area over its diameter.)
pub fn is_line(edges: &[[u32; 2]], points: &[[f64; 2]], closest: f64) -> bool {
    let at = |end: u32| points[end as usize];
    let Some(&[first, _]) = edges.first() else { return true };
    let from_first = |end: u32| Vector::between(at(first), at(end));
    let twice_area: f64 = edges.iter().map(|&[a, b]| from_first(a).cross(from_first(b))).sum();
    let reach = edges.iter().map(|&[a, _]| from_first(a).length()).fold(0.0, f64::max);
    twice_area <= closest * reach
}

/// The part of the hull to the right of everything, walking through `order` (Andrew's monotone
/// chain, with collinear points kept).
fn chain(points: &[[f64; 2]], order: impl Iterator<Item = u32>) -> Vec<[u32; 2]> {
    let mut chain: Vec<u32> = Vec::new();
    for next in order {
        while let [.., a, b] = chain[..] {
            let [a, b, next] = [a, b, next].map(|p| points[p as usize]);
            if side(a, b, next) != Side::Right {
                break;
            }
            chain.pop();
        }
        chain.push(next);
    }
    chain.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::formats::Pslg;
    use crate::parameters::Region;

    /// A square with three points beside its lower side, at heights that doubles cannot tell from 0
    /// at its size: high, low, high.
    const POINTS: [[f64; 2]; 7] = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [0.25, 3e-17],
        [0.5, 1e-18],
        [0.75, 2e-17],
    ];

    /// The lower side, bent through them.
    const BENT: [[u32; 2]; 4] = [[0, 4], [4, 5], [5, 6], [6, 1]];

    fn domain(segments: &[[u32; 2]]) -> Domain {
        let pslg = Pslg {
            points: POINTS.to_vec(),
            segments: segments.to_vec(),
            segment_tags: vec![0; segments.len()],
            ..Pslg::default()
        };
        Domain::new(&pslg, Region::Hull).expect("nothing crosses").0
    }

    #[test]
    fn a_segment_crosses_a_bent_edge_from_one_side_to_the_other() {
        assert!(is_crossed(&BENT, &POINTS, &[[2, 3], [0, 6]]), "from below the chain to above it");
        assert!(!is_crossed(&BENT, &POINTS, &[[2, 3], [0, 4], [4, 2], [5, 3]]), "ends are shared");
        assert!(!is_crossed(&BENT, &POINTS, &[]));
    }

    #[test]
    fn a_side_that_is_bent_past_a_segment_stays_straight() {
        // From the corner to the third point: above the second, below the first.
        let crossing = domain(&[[0, 6]]);
        assert!(crossing.segments.contains(&[0, 1]), "{:?}", crossing.segments);
        // Along the chain itself nothing is crossed.
        let along = domain(&[[0, 4]]);
        assert!(!along.segments.contains(&[0, 1]), "{:?}", along.segments);
        assert!(BENT.iter().all(|edge| along.segments.contains(edge)), "{:?}", along.segments);
    }
}
