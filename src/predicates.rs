//! Exact questions: the only door to `robust`.
//!
//! Every answer is the exact one for the doubles given, as long as no product of four differences
//! of coordinates over- or underflows (the domain is scaled so that none does).

use robust::Coord;

/// Where a point lies, seen along a directed line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// To the left: the three points turn counter-clockwise.
    Left,
    /// On the line.
    On,
    /// To the right.
    Right,
}

/// On which side of the directed line from `a` to `b` the point `c` lies.
#[must_use]
pub fn side(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Side {
    let area = robust::orient2d(coord(a), coord(b), coord(c));
    if area > 0.0 {
        Side::Left
    } else if area < 0.0 {
        Side::Right
    } else {
        Side::On
    }
}

fn coord([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}
