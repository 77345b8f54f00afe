//! Claims 5.1–5.3 and Lemma 3: pieces of segments that are split at their midpoints.
//!
//! A piece of depth `depth` and number `i` reaches from i·2^−depth to (i+1)·2^−depth of its segment.

use std::f64::consts::{FRAC_PI_2, PI};

use meshwright_campaigns::Random;
use meshwright_campaigns::plane::{Point, distance, dot, minus, polar};

use crate::ROUNDING;

/// A subsegment, as distances from the end x of its input segment, which is `length` long.
#[derive(Debug, Clone, Copy)]
struct Piece {
    near: f64,
    far: f64,
    length: f64,
}

impl Piece {
    /// A piece that repeated bisection makes: at each step one half goes on.
    fn draw(length: f64, random: &mut Random) -> Self {
        let mut piece = Self { near: 0.0, far: length, length };
        for _ in 0..random.whole(0, 12) {
            let middle = piece.middle();
            // Towards x more often than not: that is where angles are.
            if random.chance(0.6) {
                piece.far = middle;
            } else {
                piece.near = middle;
            }
        }
        piece
    }

    fn middle(self) -> f64 {
        0.5 * (self.near + self.far)
    }

    fn size(self) -> f64 {
        self.far - self.near
    }

    fn radius(self) -> f64 {
        0.5 * self.size()
    }
}

/// Claim 5.1: a piece (a, b) with a nearer to x has x = a or |a−b| ≤ |x−a|.
#[test]
fn claim_5_1() {
    for seed in 0..20_000 {
        let random = &mut Random::new(seed);
        let piece = Piece::draw(random.log_range(0.1, 10.0), random);
        assert!(
            piece.near == 0.0 || piece.size() <= piece.near + ROUNDING,
            "seed {seed}: {piece:?}"
        );
    }
}

/// Claim 5.2: where a point p of an adjoining segment encroaches the piece (a, b):
/// |x−a| < |x−p| cos θ, θ < π/2, |x−p| < |x−b|, and |x−m| sin θ < r.
#[test]
fn claim_5_2() {
    let mut encroaching = 0;
    for seed in 0..50_000 {
        let random = &mut Random::new(seed);
        let piece = Piece::draw(1.0, random);
        let theta = random.range(1e-3, PI);
        let x_p = piece.middle() * random.range(0.2, 1.8);
        let towards = random.direction();
        let along = |d: f64| polar([0.0, 0.0], towards, d);
        let p = polar([0.0, 0.0], towards + theta, x_p);
        if !encroaches(p, along(piece.near), along(piece.far)) {
            continue;
        }
        encroaching += 1;
        assert!(theta < FRAC_PI_2, "seed {seed}");
        assert!(piece.near < x_p * libm::cos(theta) + ROUNDING, "seed {seed}");
        assert!(x_p < piece.far + ROUNDING, "seed {seed}");
        assert!(piece.middle() * libm::sin(theta) < piece.radius() + ROUNDING, "seed {seed}");
    }
    assert!(encroaching > 2_000, "only {encroaching} draws say anything");
}

/// Claim 5.3: |x−y| / |a−b| is a power of two, not below 1, and |x−a| / |a−b| and its like are
/// nonnegative integers (the paper says powers of two; 3 occurs).
#[test]
fn claim_5_3() {
    let mut threes = 0;
    for seed in 0..20_000 {
        let random = &mut Random::new(seed);
        let piece = Piece::draw(libm::exp2(random.whole(0, 20) as f64 - 10.0), random);
        // Lengths that are powers of two: every operation is exact.
        let doublings = libm::log2(piece.length / piece.size());
        assert!(doublings >= 0.0 && doublings.fract() == 0.0, "seed {seed}: {piece:?}");
        for part in [piece.near, piece.far, piece.length - piece.near, piece.length - piece.far] {
            let ratio = part / piece.size();
            assert!(ratio >= 0.0 && ratio.fract() == 0.0, "seed {seed}: {piece:?}");
            threes += u32::from(ratio == 3.0);
        }
    }
    assert!(threes > 0, "the correction is for nothing");
}

/// Lemma 3: where the lengths of two adjoining segments are the same but for a power of two, and
/// the midpoint q of a piece of one encroaches a piece of the other, whose midpoint is p:
/// r_q ≤ r_p and |p−q| ≥ 2 r_q sin(θ/2).
#[test]
fn lemma_3() {
    let mut encroaching = 0;
    for seed in 0..100_000 {
        let random = &mut Random::new(seed);
        let length = random.range(0.5, 1.0);
        let theta = random.log_range(1e-3, 2.0);
        let split = Piece::draw(length, random);
        let other = Piece::draw(length * libm::exp2(random.whole(0, 6) as f64 - 3.0), random);
        let towards = random.direction();
        let on_first = |d: f64| polar([0.0, 0.0], towards, d);
        let q = polar([0.0, 0.0], towards + theta, other.middle());
        if !encroaches(q, on_first(split.near), on_first(split.far)) {
            continue;
        }
        encroaching += 1;
        assert!(
            other.radius() <= split.radius() * (1.0 + ROUNDING),
            "seed {seed}: {split:?} {other:?}"
        );
        let bound = 2.0 * other.radius() * libm::sin(theta / 2.0);
        let p_q = distance(on_first(split.middle()), q);
        assert!(p_q >= bound * (1.0 - 1e-9), "seed {seed}: {p_q} < {bound}");
    }
    assert!(encroaching > 1_000, "only {encroaching} draws say anything");
}

/// Without Assumption 3 radii do dwindle: Lemma 3 needs it.
#[test]
fn lemma_3_has_a_reason_for_assumption_3() {
    let theta = 0.1;
    let split = Piece { near: 0.125, far: 0.25, length: 1.0 };
    let other = Piece { near: 0.0, far: 0.375, length: 1.5 };
    let q = polar([0.0, 0.0], theta, other.middle());
    assert!(encroaches(q, [split.near, 0.0], [split.far, 0.0]));
    assert!(other.radius() > split.radius());
}

/// Whether p lies inside the circle that has the segment as its diameter, beyond rounding.
fn encroaches(p: Point, a: Point, b: Point) -> bool {
    let (u, v) = (minus(a, p), minus(b, p));
    dot(u, v) < -1e-12 * (dot(u, u) + dot(v, v))
}
