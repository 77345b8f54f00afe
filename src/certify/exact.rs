//! Exact answers about doubles, by the judge's own arithmetic.
//!
//! Each question is first asked in floating point with a bound on its error. Where that does not
//! decide, the coordinates become whole numbers (every double is one, times a power of two) and
//! the same polynomial is evaluated exactly: in `i128` where it fits, else in big integers.
//! Coordinates are expected within 2^±200 of one, or zero: [`Frame`](super::frame::Frame) sees to
//! that. Smaller ones are only slower.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};

type Point = [f64; 2];

/// Added to every error bound: more than all that is lost to gradual underflow.
const UNDERFLOW: f64 = 1e-290;

/// `Greater` if `a`, `b`, `c` turn counter-clockwise, `Less` if clockwise, `Equal` if they are
/// collinear.
pub(super) fn orientation(a: Point, b: Point, c: Point) -> Ordering {
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    decided(left - right, 5e-16 * (left.abs() + right.abs())).unwrap_or_else(|| {
        let w = whole(&[a[0], a[1], b[0], b[1], c[0], c[1]]);
        match w {
            Whole::Small(v) => {
                sign_i128((v[0] - v[4]) * (v[3] - v[5]) - (v[1] - v[5]) * (v[2] - v[4]))
            }
            Whole::Big(v) => {
                sign_big(&((&v[0] - &v[4]) * (&v[3] - &v[5]) - (&v[1] - &v[5]) * (&v[2] - &v[4])))
            }
        }
    })
}

/// The sign of (b − a)·(d − c).
pub(super) fn dot(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    let x = (b[0] - a[0]) * (d[0] - c[0]);
    let y = (b[1] - a[1]) * (d[1] - c[1]);
    decided(x + y, 5e-16 * (x.abs() + y.abs())).unwrap_or_else(|| {
        let w = whole(&[a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]]);
        match w {
            Whole::Small(v) => {
                sign_i128((v[2] - v[0]) * (v[6] - v[4]) + (v[3] - v[1]) * (v[7] - v[5]))
            }
            Whole::Big(v) => {
                sign_big(&((&v[2] - &v[0]) * (&v[6] - &v[4]) + (&v[3] - &v[1]) * (&v[7] - &v[5])))
            }
        }
    })
}

/// `Less` if `p` lies strictly inside the disc whose diameter is `ab`, `Equal` on its circle.
pub(super) fn diametral(a: Point, b: Point, p: Point) -> Ordering {
    dot(p, a, p, b)
}

/// `Greater` if `d` lies strictly inside the circle through `a`, `b`, `c` (counter-clockwise),
/// `Equal` on it.
pub(super) fn in_circle(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    let ([ax, ay], [bx, by], [cx, cy]) = (minus(a, d), minus(b, d), minus(c, d));
    let (bc, cb) = (bx * cy, cx * by);
    let (ca, ac) = (cx * ay, ax * cy);
    let (ab, ba) = (ax * by, bx * ay);
    let (a2, b2, c2) = (ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy);
    let determinant = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
    let permanent =
        a2 * (bc.abs() + cb.abs()) + b2 * (ca.abs() + ac.abs()) + c2 * (ab.abs() + ba.abs());
    decided(determinant, 1.2e-15 * permanent).unwrap_or_else(|| in_circle_exactly(a, b, c, d))
}

fn in_circle_exactly(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    let values = match whole(&[a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]]) {
        Whole::Small(v) => {
            let r: [i128; 6] = std::array::from_fn(|i| v[i] - v[6 + i % 2]);
            // Four factors below 2^30 and a sum of six products stay below 2^124.
            if r.iter().all(|x| x.unsigned_abs() < 1 << 30) {
                let [ax, ay, bx, by, cx, cy] = r;
                return sign_i128(
                    (ax * ax + ay * ay) * (bx * cy - cx * by)
                        + (bx * bx + by * by) * (cx * ay - ax * cy)
                        + (cx * cx + cy * cy) * (ax * by - bx * ay),
                );
            }
            v.map(BigInt::from)
        }
        Whole::Big(v) => v,
    };
    let relative: [BigInt; 6] = std::array::from_fn(|i| &values[i] - &values[6 + i % 2]);
    let [ax, ay, bx, by, cx, cy] = &relative;
    sign_big(
        &((ax * ax + ay * ay) * (bx * cy - cx * by)
            + (bx * bx + by * by) * (cx * ay - ax * cy)
            + (cx * cx + cy * cy) * (ax * by - bx * ay)),
    )
}

/// Whether some point of the line `ab` is within 0.51 `ulp[i]` of `p` in each coordinate `i`.
///
/// The line meets the box around `p` exactly if |(b − a) × (p − a)| ≤ 0.51·(ulp₀·|b₁ − a₁| +
/// ulp₁·|b₀ − a₀|).
pub(super) fn within_half_ulp(a: Point, b: Point, p: Point, ulp: Point) -> bool {
    let (dx, dy) = (Double::difference(b[0], a[0]), Double::difference(b[1], a[1]));
    let (px, py) = (Double::difference(p[0], a[0]), Double::difference(p[1], a[1]));
    let offset = (dx * py - dy * px).to_f64().abs();
    let allowed = 0.51 * (ulp[0] * dy.hi.abs() + ulp[1] * dx.hi.abs());
    let error = 1e-12 * allowed + 1e-29 * ((dx.hi * py.hi).abs() + (dy.hi * px.hi).abs());
    match decided(offset - allowed, error) {
        Some(order) => order != Ordering::Greater,
        None => {
            let v = match whole(&[a[0], a[1], b[0], b[1], p[0], p[1], ulp[0], ulp[1]]) {
                Whole::Small(v) => v.map(BigInt::from),
                Whole::Big(v) => v,
            };
            let (dx, dy) = (&v[2] - &v[0], &v[3] - &v[1]);
            let offset = &dx * (&v[5] - &v[1]) - &dy * (&v[4] - &v[0]);
            let allowed = &v[6] * magnitude(&dy) + &v[7] * magnitude(&dx);
            magnitude(&offset) * 100 <= allowed * 51
        }
    }
}

/// How far `p` is from the line `ab`, in the unit of [`within_half_ulp`] (rounded).
pub(super) fn ulps_off(a: Point, b: Point, p: Point, ulp: Point) -> f64 {
    let (dx, dy) = (Double::difference(b[0], a[0]), Double::difference(b[1], a[1]));
    let (px, py) = (Double::difference(p[0], a[0]), Double::difference(p[1], a[1]));
    (dx * py - dy * px).to_f64().abs() / (ulp[0] * dy.hi.abs() + ulp[1] * dx.hi.abs())
}

/// The angle at `p` between the directions to `a` and to `b`.
///
/// Each direction is first multiplied by a power of two that makes it about as long as one. The
/// products are rounded from about 100 correct bits: the cross product of nearly parallel
/// directions keeps its relative accuracy.
pub(super) fn corner(p: Point, a: Point, b: Point) -> Corner {
    let [ax, ay] = direction(p, a);
    let [bx, by] = direction(p, b);
    let length = |x: Double, y: Double| (x.hi * x.hi + y.hi * y.hi).sqrt();
    Corner {
        cross: (ax * by - ay * bx).to_f64(),
        dot: (ax * bx + ay * by).to_f64(),
        lengths: length(ax, ay) * length(bx, by),
    }
}

/// An angle by the products of two vectors that enclose it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    /// Their cross product: positive if the second is to the left of the first.
    pub(super) cross: f64,
    /// Their dot product.
    pub(super) dot: f64,
    /// The product of their lengths.
    pub(super) lengths: f64,
}

impl Corner {
    pub(super) fn cross_and_dot(self) -> (f64, f64) {
        (self.cross, self.dot)
    }
}

/// q − p times the power of two that makes it about as long as one.
fn direction(p: Point, q: Point) -> [Double; 2] {
    let vector = [0, 1].map(|i| Double::difference(q[i], p[i]));
    let size = vector[0].hi.abs().max(vector[1].hi.abs());
    let exponent = ((size.to_bits() >> 52) & 0x7ff) as i64 - 1023;
    // Below the normal doubles 2^1000 is enough.
    let power = f64::from_bits(((1023 - exponent.clamp(-1000, 1000)) as u64) << 52);
    vector.map(|x| Double { hi: x.hi * power, lo: x.lo * power })
}

/// (a − o) × (b − o), unrounded: for sums of areas.
pub(super) fn cross(o: Point, a: Point, b: Point) -> Double {
    let (ax, ay) = (Double::difference(a[0], o[0]), Double::difference(a[1], o[1]));
    let (bx, by) = (Double::difference(b[0], o[0]), Double::difference(b[1], o[1]));
    ax * by - ay * bx
}

/// An unevaluated sum of two doubles: 106 bits.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Double {
    hi: f64,
    lo: f64,
}

impl Double {
    /// `a − b`, exactly.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        let hi = a - b;
        let virtual_b = a - hi;
        let lo = (a - (hi + virtual_b)) + (virtual_b - b);
        Self { hi, lo }
    }

    pub(super) fn to_f64(self) -> f64 {
        self.hi + self.lo
    }

    fn sum(hi: f64, lo: f64) -> Self {
        let sum = hi + lo;
        Self { hi: sum, lo: lo - (sum - hi) }
    }
}

impl std::ops::Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let high = Self::difference(self.hi, -other.hi);
        let low = Self::difference(self.lo, -other.lo);
        let first = Self::sum(high.hi, high.lo + low.hi);
        Self::sum(first.hi, first.lo + low.lo)
    }
}

impl std::ops::Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl std::ops::Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl std::ops::Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let lo = self.hi.mul_add(other.hi, -hi);
        Self::sum(hi, lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

/// The sign of `value` if it is larger than `error`; the comparison is false for NaN.
fn decided(value: f64, error: f64) -> Option<Ordering> {
    let error = error + UNDERFLOW;
    if value > error {
        Some(Ordering::Greater)
    } else if -value > error {
        Some(Ordering::Less)
    } else {
        None
    }
}

fn minus(p: Point, q: Point) -> Point {
    [p[0] - q[0], p[1] - q[1]]
}

/// Doubles as whole multiples of one power of two.
enum Whole<const N: usize> {
    /// All below 2^61 in magnitude.
    Small([i128; N]),
    Big([BigInt; N]),
}

fn whole<const N: usize>(values: &[f64; N]) -> Whole<N> {
    let parts = values.map(parts);
    let least = parts.iter().filter(|(m, _)| *m != 0).map(|(_, e)| *e).min().unwrap_or(0);
    let bits = |(m, e): &(i64, i32)| 64 - m.unsigned_abs().leading_zeros() as i32 + e - least;
    if parts.iter().all(|p| p.0 == 0 || bits(p) <= 61) {
        let shifted = |(m, e): (i64, i32)| if m == 0 { 0 } else { i128::from(m) << (e - least) };
        Whole::Small(parts.map(shifted))
    } else {
        let shifted = |(m, e): (i64, i32)| {
            if m == 0 { BigInt::default() } else { BigInt::from(m) << (e - least).unsigned_abs() }
        };
        Whole::Big(parts.map(shifted))
    }
}

/// `value` = m·2^e with m odd or zero. (What is not finite never comes here.)
fn parts(value: f64) -> (i64, i32) {
    let bits = value.to_bits();
    let stored = ((bits >> 52) & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (m, e) = if stored == 0 { (fraction, -1074) } else { (fraction | 1 << 52, stored - 1075) };
    if m == 0 {
        return (0, 0);
    }
    let zeros = m.trailing_zeros() as i32;
    let m = m >> zeros;
    (if value < 0.0 { -m } else { m }, e + zeros)
}

fn sign_i128(value: i128) -> Ordering {
    value.cmp(&0)
}

fn sign_big(value: &BigInt) -> Ordering {
    match value.sign() {
        Sign::Minus => Ordering::Less,
        Sign::NoSign => Ordering::Equal,
        Sign::Plus => Ordering::Greater,
    }
}

fn magnitude(value: &BigInt) -> BigInt {
    BigInt::from(value.magnitude().clone())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Whole numbers for doubles of moderate size: all multiples of 2^-200.
    fn big(value: f64) -> BigInt {
        let (m, e) = parts(value);
        BigInt::from(m) << (e + 200).unsigned_abs()
    }

    fn vector(a: Point, b: Point) -> [BigInt; 2] {
        [big(b[0]) - big(a[0]), big(b[1]) - big(a[1])]
    }

    fn cross_of([a, b]: &[BigInt; 2], [c, d]: &[BigInt; 2]) -> BigInt {
        a * d - b * c
    }

    fn dot_of([a, b]: &[BigInt; 2], [c, d]: &[BigInt; 2]) -> BigInt {
        a * c + b * d
    }

    /// Plain determinant of the lifted points, nothing shared with [`in_circle`].
    fn in_circle_by_definition([a, b, c, d]: [Point; 4]) -> Ordering {
        let rows = [a, b, c].map(|p| {
            let v = vector(d, p);
            let lifted = dot_of(&v, &v);
            [v[0].clone(), v[1].clone(), lifted]
        });
        let [[a, b, c], [d, e, f], [g, h, i]] = &rows;
        sign_big(&(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)))
    }

    /// Coordinates that are often equal, nearly equal or on a grid, so that floats cannot decide.
    fn coordinate() -> impl Strategy<Value = f64> {
        let steps = (-4_i32..5, -3_i64..4).prop_map(|(grid, ulps)| {
            let x = f64::from(grid) * 0.375 + 1.0;
            x + ulps as f64 * f64::EPSILON
        });
        let far = (-3_i32..4).prop_map(|x| 5.4e6 + f64::from(x) * 1e-3);
        prop_oneof![4 => steps, 1 => -1.0..1.0_f64, 1 => far, 1 => Just(1e-30)]
    }

    fn point() -> impl Strategy<Value = Point> {
        [coordinate(), coordinate()]
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn orientation_is_the_sign_of_the_determinant(a in point(), b in point(), c in point()) {
            let expected = sign_big(&cross_of(&vector(a, b), &vector(a, c)));
            prop_assert_eq!(orientation(a, b, c), expected);
        }

        #[test]
        fn dot_is_the_sign_of_the_product(a in point(), b in point(), c in point(), d in point()) {
            prop_assert_eq!(dot(a, b, c, d), sign_big(&dot_of(&vector(a, b), &vector(c, d))));
            prop_assert_eq!(diametral(a, b, c), sign_big(&dot_of(&vector(c, a), &vector(c, b))));
        }

        #[test]
        fn in_circle_is_the_sign_of_the_determinant(points in [point(), point(), point(), point()]) {
            let [a, b, c, d] = points;
            prop_assert_eq!(in_circle(a, b, c, d), in_circle_by_definition(points));
        }

        #[test]
        fn a_point_is_within_half_an_ulp_where_the_line_meets_its_box(
            a in point(), b in point(), p in point(), up in [0..20_i32, 0..20],
        ) {
            let ulp = up.map(|e| f64::EPSILON * 2_f64.powi(e - 10));
            let (along, to) = (vector(a, b), vector(a, p));
            let corners = [(-1, -1), (-1, 1), (1, -1), (1, 1)].map(|(x, y)| {
                // 100 times as large: 51 hundredths are whole numbers then.
                let corner = [&to[0] * 100 + big(ulp[0]) * (51 * x), &to[1] * 100 + big(ulp[1]) * (51 * y)];
                sign_big(&cross_of(&along, &corner))
            });
            let misses = corners.iter().all(|&s| s == Ordering::Less) || corners.iter().all(|&s| s == Ordering::Greater);
            prop_assert_eq!(within_half_ulp(a, b, p, ulp), !misses);
        }
    }

    #[test]
    fn four_points_of_a_grid_are_cocircular_in_whole_numbers_and_in_big_ones() {
        for step in [1.0, 0.1, 1e-9, 3.7e5] {
            let at = |x: f64, y: f64| [step * x, step * y];
            let (a, b, c, d) = (at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0));
            assert_eq!(in_circle(a, b, c, d), Ordering::Equal);
            assert_eq!(in_circle(a, b, c, [d[0].next_up(), d[1]]), Ordering::Greater);
            assert_eq!(in_circle(a, b, c, [d[0], d[1].next_up()]), Ordering::Less);
            assert_eq!(diametral(a, c, b), Ordering::Equal);
        }
    }

    #[test]
    fn numbers_that_underflow_in_floats_are_still_told_apart() {
        let tiny = 1e-200;
        let (a, b) = ([0.0, 0.0], [tiny, tiny]);
        assert_eq!(orientation(a, b, [2.0 * tiny, 2.0 * tiny]), Ordering::Equal);
        assert_eq!(orientation(a, b, [2.0 * tiny, 2.0 * tiny.next_up()]), Ordering::Greater);
        assert_eq!(in_circle(a, [tiny, 0.0], b, [0.5 * tiny, 0.5 * tiny]), Ordering::Greater);
    }

    #[test]
    fn a_needle_angle_keeps_its_digits() {
        for theta in [1e-3, 1e-9, 1e-15] {
            let corner = corner([1.0, 1.0], [2.0, 1.0], [2.0, 1.0 + theta]);
            let exact = (1.0_f64 + theta) - 1.0;
            assert!(
                (libm::atan2(corner.cross, corner.dot) / libm::atan(exact) - 1.0).abs() < 1e-14
            );
        }
    }
}
