//! Vectors in the plane, and the exact and the rounded questions that the generators ask.

use meshwright::predicates::{Side, side};

/// A point or a vector, `[x, y]`.
pub type Point = [f64; 2];

/// `a − b`.
#[must_use]
pub fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// The point at `distance` from `a` in a direction given in radians.
#[must_use]
pub fn polar(a: Point, direction: f64, distance: f64) -> Point {
    [a[0] + distance * libm::cos(direction), a[1] + distance * libm::sin(direction)]
}

/// The point that divides `a`–`b` in the ratio `t : 1 − t`.
#[must_use]
pub fn between(a: Point, b: Point, t: f64) -> Point {
    [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
}

/// The direction from `a` to `b` in radians.
#[must_use]
pub fn direction(a: Point, b: Point) -> f64 {
    libm::atan2(b[1] - a[1], b[0] - a[0])
}

/// The dot product.
#[must_use]
pub fn dot(u: Point, v: Point) -> f64 {
    u[0] * v[0] + u[1] * v[1]
}

/// The cross product, its two products as exact as the result allows (Kahan's difference of
/// products), so that an angle of 1e-9 still has seven good digits.
#[must_use]
pub fn cross(u: Point, v: Point) -> f64 {
    let product = u[1] * v[0];
    let lost = u[1].mul_add(v[0], -product);
    u[0].mul_add(v[1], -product) - lost
}

/// The distance of two points.
#[must_use]
pub fn distance(a: Point, b: Point) -> f64 {
    libm::hypot(b[0] - a[0], b[1] - a[1])
}

/// The angle at `x` between the directions to `a` and to `b`, in radians, 0 to π.
#[must_use]
pub fn angle(a: Point, x: Point, b: Point) -> f64 {
    let (u, v) = (minus(a, x), minus(b, x));
    libm::atan2(cross(u, v).abs(), dot(u, v))
}

/// The distance from `p` to the segment `a`–`b`.
#[must_use]
pub fn distance_to_segment(p: Point, a: Point, b: Point) -> f64 {
    let (along, to) = (minus(b, a), minus(p, a));
    let length_squared = dot(along, along);
    if length_squared == 0.0 || dot(along, to) <= 0.0 {
        distance(p, a)
    } else if dot(along, to) >= length_squared {
        distance(p, b)
    } else {
        cross(along, to).abs() / libm::sqrt(length_squared)
    }
}

/// The distance of two segments that do not cross.
#[must_use]
pub fn distance_of_segments(a: Point, b: Point, c: Point, d: Point) -> f64 {
    distance_to_segment(a, c, d)
        .min(distance_to_segment(b, c, d))
        .min(distance_to_segment(c, a, b))
        .min(distance_to_segment(d, a, b))
}

/// Whether two segments have a point in common. Exact.
#[must_use]
pub fn segments_meet(a: Point, b: Point, c: Point, d: Point) -> bool {
    let (abc, abd) = (side(a, b, c), side(a, b, d));
    let (cda, cdb) = (side(c, d, a), side(c, d, b));
    let all_on = [abc, abd, cda, cdb].iter().all(|&s| s == Side::On);
    if all_on {
        return spans_meet(a[0], b[0], c[0], d[0]) && spans_meet(a[1], b[1], c[1], d[1]);
    }
    let apart = |s: Side, t: Side| s == t && s != Side::On;
    !apart(abc, abd) && !apart(cda, cdb)
}

/// Whether the segments `x`–`p` and `x`–`q` have more in common than `x`. Exact.
#[must_use]
pub fn legs_overlap(x: Point, p: Point, q: Point) -> bool {
    side(x, p, q) == Side::On
        && same_half(p[0] - x[0], q[0] - x[0])
        && same_half(p[1] - x[1], q[1] - x[1])
}

fn same_half(u: f64, v: f64) -> bool {
    (u >= 0.0 && v >= 0.0) || (u <= 0.0 && v <= 0.0)
}

fn spans_meet(a: f64, b: f64, c: f64, d: f64) -> bool {
    a.min(b) <= c.max(d) && c.min(d) <= a.max(b)
}
