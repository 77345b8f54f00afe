//! The convex hull of the points.

use crate::predicates::{Side, side};

/// The edges of the convex hull, counter-clockwise, split at every point that lies on it.
/// `order`: the points from left to right (lexicographic), all distinct. Empty if all are collinear.
pub fn hull_edges(points: &[[f64; 2]], order: &[u32]) -> Vec<[u32; 2]> {
    let mut edges = chain(points, order.iter().copied());
    let upper = chain(points, order.iter().rev().copied());
    // Collinear points: both chains run along the same line.
    if edges.len() == upper.len()
        && edges.iter().zip(upper.iter().rev()).all(|(&[a, b], &[c, d])| [a, b] == [d, c])
    {
        return Vec::new();
    }
    edges.extend(upper);
    edges
}

/// Those of the hull edges that are no segments yet.
pub fn missing(hull_edges: Vec<[u32; 2]>, segments: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let undirected = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
    let mut present: Vec<[u32; 2]> = segments.iter().copied().map(undirected).collect();
    present.sort_unstable();
    let missing = |&edge: &[u32; 2]| present.binary_search(&undirected(edge)).is_err();
    hull_edges.into_iter().filter(missing).collect()
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
