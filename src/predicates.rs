//! Exact questions: the only door to `robust`.
//!
//! Every answer is the exact one for the doubles given, as long as no product of four differences
//! of coordinates over- or underflows (the domain is scaled so that none does).
//!
//! The kernel asks all its questions about one new point at a time. So the questions of its inner
//! loop take [`Relative`] coordinates, made once per vertex, and fall back on the absolute ones
//! only where a float filter leaves them open.

use std::cell::Cell;

use robust::Coord;

use crate::double_double::{DoubleDouble, Expansion};

thread_local! {
    static EXACT: Cell<u64> = const { Cell::new(0) };
}

/// How many questions of the kernel's inner loop only exact arithmetic could answer on this thread so
/// far.
#[must_use]
pub fn exact_answers() -> u64 {
    EXACT.get()
}

fn count_exact() {
    EXACT.set(EXACT.get() + 1);
}

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

/// A vertex seen from the point `p` that is being inserted: `a − p` and its squared length,
/// rounded.
#[derive(Debug, Clone, Copy)]
pub struct Relative {
    /// `a.x − p.x`
    pub x: f64,
    /// `a.y − p.y`
    pub y: f64,
    /// `|a − p|²`
    pub squared: f64,
}

impl Relative {
    /// The vertex `a` seen from `p`.
    #[inline]
    #[must_use]
    pub fn of(a: [f64; 2], p: [f64; 2]) -> Self {
        let (x, y) = (a[0] - p[0], a[1] - p[1]);
        Self { x, y, squared: x * x + y * y }
    }

    /// The rounded dot product with another vertex seen from the same point.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The rounded cross product with another vertex seen from the same point.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }
}

/// Whether the point from which three counter-clockwise corners are seen lies strictly inside their
/// circle, by their squared lengths and, opposite each, the cross product of the other two; `None`
/// where rounding leaves that open, for [`in_circle_exactly`] to answer.
#[inline(always)]
#[must_use]
pub fn surely_in_circle([a, b, c]: [f64; 3], crosses: [f64; 3]) -> Option<bool> {
    let determinant = a * crosses[0] + b * crosses[1] + c * crosses[2];
    // The bound of DESIGN, *Kernel*: 10 ε times the sum of the products of squared lengths.
    let size = a * b + b * c + c * a;
    (determinant.abs() > 1.12e-15 * size).then_some(determinant > 0.0)
}

/// Whether `p` lies strictly inside the circle through three counter-clockwise `corners`, which
/// stand in `seen` as seen from `p`. Only where rounding leaves that open are they asked for.
#[inline]
#[must_use]
pub fn in_circle(
    seen: [Relative; 3],
    corners: impl FnOnce() -> [[f64; 2]; 3],
    p: [f64; 2],
) -> bool {
    let [a, b, c] = seen;
    surely_in_circle(seen.map(|v| v.squared), [b.cross(c), c.cross(a), a.cross(b)])
        .unwrap_or_else(|| in_circle_exactly(corners(), p))
}

/// Whether `p` lies strictly inside the circle through three counter-clockwise `corners`.
#[cold]
#[inline(never)]
#[must_use]
pub fn in_circle_exactly(corners: [[f64; 2]; 3], p: [f64; 2]) -> bool {
    count_exact();
    let [a, b, c] = corners.map(coord);
    robust::incircle(a, b, c, coord(p)) > 0.0
}

/// Whether the point from which `a` and `b` are seen lies strictly to the left of the directed line
/// from `a` to `b`; `None` where rounding leaves that open, for [`left_exactly`] to answer.
#[inline(always)]
#[must_use]
pub fn surely_left([a, b]: [Relative; 2]) -> Option<bool> {
    let (plus, minus) = (a.x * b.y, a.y * b.x);
    let cross = plus - minus;
    // Shewchuk's bound A for orientation: (3 + 16 ε) ε.
    (cross.abs() > 3.331e-16 * (plus.abs() + minus.abs())).then_some(cross > 0.0)
}

/// Whether the point from which `a` and `b` are seen surely lies to the left of the directed line from
/// `a` to `b`, by their cross product; where not, [`surely_left`] may still tell.
#[inline(always)]
#[must_use]
pub fn is_surely_left(cross: f64, [a, b]: [Relative; 2]) -> bool {
    // |a.x b.y| + |a.y b.x| ≤ |a||b| ≤ (|a|² + |b|²)/2: half of bound A, and a little more.
    cross > 1.67e-16 * (a.squared + b.squared)
}

/// Whether `p` lies strictly to the left of the directed line from `a` to `b`.
#[cold]
#[inline(never)]
#[must_use]
pub fn left_exactly([a, b]: [[f64; 2]; 2], p: [f64; 2]) -> bool {
    count_exact();
    side(a, b, p) == Side::Left
}

/// Whether `p` encroaches the subsegment `ends`: lies strictly inside its diametral circle,
/// (a − p)·(b − p) < 0. `seen` are its ends as seen from `p`.
#[inline]
#[must_use]
pub fn encroaches(seen: [Relative; 2], ends: [[f64; 2]; 2], p: [f64; 2]) -> bool {
    let [a, b] = seen;
    let (first, second) = (a.x * b.x, a.y * b.y);
    let dot = first + second;
    if dot.abs() > 3.331e-16 * (first.abs() + second.abs()) {
        return dot < 0.0;
    }
    count_exact();
    exact_dot_sign(ends[0], ends[1], p) < 0.0
}

/// A number with the sign of (a − p)·(b − p), exactly.
fn exact_dot_sign(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let mut sum = Expansion::default();
    for i in 0..2 {
        let u = DoubleDouble::difference(a[i], p[i]);
        let v = DoubleDouble::difference(b[i], p[i]);
        sum.add_product(u, v);
    }
    sum.leading()
}

fn coord([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inside(a: [f64; 2], b: [f64; 2], c: [f64; 2], p: [f64; 2]) -> bool {
        in_circle([a, b, c].map(|v| Relative::of(v, p)), || [a, b, c], p)
    }

    fn encroached(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> bool {
        encroaches([a, b].map(|v| Relative::of(v, p)), [a, b], p)
    }

    #[test]
    fn a_point_on_the_circle_is_not_inside() {
        let square = ([0.1, 0.1], [0.7, 0.1], [0.7, 0.7]);
        assert!(!inside(square.0, square.1, square.2, [0.1, 0.7]));
        assert!(inside(square.0, square.1, square.2, [0.1f64.next_up(), 0.7]));
    }

    #[test]
    fn encroachment_is_strict() {
        assert!(!encroached([-5.0, 0.0], [5.0, 0.0], [3.0, 4.0]));
        assert!(encroached([-5.0, 0.0], [5.0, 0.0], [3.0, 4.0f64.next_down()]));
        assert!(!encroached([-5.0, 0.0], [5.0, 0.0], [3.0, 4.0f64.next_up()]));
    }

    #[test]
    fn encroachment_is_exact_far_from_the_origin() {
        let big = 2f64.powi(40);
        let (a, b) = ([big - 5.0, big], [big + 5.0, big]);
        assert!(!encroached(a, b, [big + 3.0, big + 4.0]));
        assert!(encroached(a, b, [big + 3.0, (big + 4.0).next_down()]));
    }

    #[test]
    fn a_point_on_a_line_is_on_no_side() {
        assert_eq!(side([0.0, 0.0], [3.0, 3.0], [1.0, 1.0]), Side::On);
        assert_eq!(side([0.0, 0.0], [3.0, 3.0], [1.0, 1.0f64.next_up()]), Side::Left);
        assert_eq!(side([0.0, 0.0], [3.0, 3.0], [1.0, 1.0f64.next_down()]), Side::Right);
    }
}
