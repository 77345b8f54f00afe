//! Lemmas 4 and 5, Corollary 1: circumcenter sequences (Definition 2).

use meshwright_campaigns::Random;
use meshwright_campaigns::plane::{Point, between, direction, distance, polar};

use crate::{ROUNDING, kappa_hat};

/// A circumcenter sequence b₀ … b_{l−1} with the other ends a₀ … a_{l−2} of its short edges and
/// its radii.
#[derive(Debug)]
struct Sequence {
    b: Vec<Point>,
    a: Vec<Point>,
    radius: Vec<f64>,
}

impl Sequence {
    /// A random sequence of l points for a κ̂: b_i is the center of a circle through a_{i−1} and
    /// b_{i−1} that sees them under an angle below κ̂; a_i is not inside that circle.
    fn draw(l: usize, kappa_hat: f64, random: &mut Random) -> Self {
        let mut b = vec![[random.range(-1.0, 1.0), random.range(-1.0, 1.0)]];
        let mut radius = vec![random.log_range(0.1, 10.0)];
        let mut a = vec![polar(b[0], random.direction(), radius[0])];
        for i in 1..l {
            let (previous, other) = (b[i - 1], a[i - 1]);
            let edge = distance(previous, other);
            let angle = kappa_hat
                * if random.chance(0.5) { random.range(0.9, 1.0) } else { random.range(0.05, 1.0) };
            let r = edge / (2.0 * libm::sin(angle));
            let side = if random.chance(0.5) { 1.0 } else { -1.0 };
            let normal = direction(previous, other) + side * std::f64::consts::FRAC_PI_2;
            let center = polar(between(previous, other, 0.5), normal, r * libm::cos(angle));
            b.push(center);
            radius.push(r);
            if i + 1 < l {
                let away = if random.chance(0.5) { 1.0 } else { random.range(1.0, 1.5) };
                a.push(polar(center, random.direction(), r * away));
            }
        }
        Self { b, a, radius }
    }
}

/// Lemma 4: a sequence from the midpoint of S₁ that ends inside the diametral circle of a shorter
/// segment S₂ on the same line has at least four points.
#[test]
fn lemma_4() {
    for seed in 0..50_000 {
        let random = &mut Random::new(seed);
        let line = Line::draw(random);
        let b_1 = closer_to(line.b_0, line.x, random);
        assert!(!line.encroached_by(b_1), "seed {seed}: b₁ = {b_1:?}, {line:?}");
        let b_2 = closer_to(b_1, line.x, random);
        assert!(!line.encroached_by(b_2), "seed {seed}: b₂ = {b_2:?}, {line:?}");
    }
}

/// Figure 7: the fourth point b₃ can lie in the circle of S₂, so Lemma 4 cannot be extended.
#[test]
fn lemma_4_is_sharp() {
    let reached = (0..50_000).filter(|&seed| {
        let random = &mut Random::new(seed);
        let line = Line::draw(random);
        let b_1 = closer_to(line.b_0, line.x, random);
        let b_2 = closer_to(b_1, line.x, random);
        line.encroached_by(closer_to(b_2, line.x, random))
    });
    assert!(reached.count() > 10);
}

/// Two segments of one line with disjoint interiors: S₁ from x = (0, 0) to the right, S₂ shorter,
/// to the left.
#[derive(Debug)]
struct Line {
    x: Point,
    b_0: Point,
    middle: Point,
    radius: f64,
}

impl Line {
    fn draw(random: &mut Random) -> Self {
        let radius =
            if random.chance(0.5) { random.range(0.9, 1.0) } else { random.log_range(0.01, 1.0) };
        let gap = if random.chance(0.7) { 0.0 } else { random.log_range(1e-3, 1.0) };
        Self {
            x: [0.0, 0.0],
            b_0: [1.0, 0.0],
            middle: [-gap - radius, 0.0],
            radius: radius * (1.0 - 1e-9),
        }
    }

    fn encroached_by(&self, p: Point) -> bool {
        distance(p, self.middle) < self.radius * (1.0 - ROUNDING)
    }
}

/// A point that is at least as near to `from` as to `x`: the center of a circle through `from`
/// that does not hold `x`. Often on the bisector, where it matters.
fn closer_to(from: Point, x: Point, random: &mut Random) -> Point {
    let middle = between(from, x, 0.5);
    let along = direction(from, x) + std::f64::consts::FRAC_PI_2;
    let on_bisector = polar(middle, along, distance(from, x) * random.range(-4.0, 4.0));
    if random.chance(0.7) {
        return on_bisector;
    }
    polar(on_bisector, direction(x, from), random.log_range(1e-3, 1.0))
}

/// Lemma 5: r̃_{i−1} < 2 r̃_i sin κ̂, and |b_{l−1} − b_i|, |b_{l−1} − a_i| < r̃_{l−1} / (1 − 2 sin κ̂).
#[test]
fn lemma_5() {
    for seed in 0..20_000 {
        let random = &mut Random::new(seed);
        let kappa_hat = if random.chance(0.5) { kappa_hat() } else { random.range(0.1, 0.52) };
        let l = random.whole(2, 12);
        let sequence = Sequence::draw(l, kappa_hat, random);
        let (last, r) = (sequence.b[l - 1], sequence.radius[l - 1]);
        let ratio = 2.0 * libm::sin(kappa_hat);
        for i in 1..l {
            let bound = sequence.radius[i] * ratio * (1.0 + ROUNDING);
            assert!(sequence.radius[i - 1] <= bound, "seed {seed}: {sequence:?}");
            let power = libm::pow(ratio, (l - 1 - i) as f64);
            assert!(sequence.radius[i] <= power * r * (1.0 + 1e-9), "seed {seed}: {sequence:?}");
        }
        let reach = r / (1.0 - ratio) * (1.0 + ROUNDING);
        for &point in sequence.b.iter().chain(&sequence.a) {
            assert!(distance(last, point) <= reach, "seed {seed}: {sequence:?}");
        }
    }
}

/// Corollary 1: where b_{l−1} yields to the midpoint p of a segment of radius r_p that no committed
/// point encroaches: r̃_i < (2 sin κ̂)^{l−1−i} √2 r_p, and a_i and b_i lie within η r_p of p.
#[test]
fn corollary_1() {
    let kappa_hat = kappa_hat();
    let ratio = 2.0 * libm::sin(kappa_hat);
    let eta = 1.0 + std::f64::consts::SQRT_2 / (1.0 - ratio);
    let mut yielding = 0;
    for seed in 0..50_000 {
        let random = &mut Random::new(seed);
        let l = random.whole(2, 10);
        let sequence = Sequence::draw(l, kappa_hat, random);
        let (last, r) = (sequence.b[l - 1], sequence.radius[l - 1]);
        // A segment that the last circumcenter encroaches and whose ends its circle does not hold.
        let r_p = r * random.range(0.7, 1.5);
        let p = polar(last, random.direction(), r_p * random.unit());
        let towards = random.direction();
        let ends = [polar(p, towards, r_p), polar(p, towards, -r_p)];
        if ends.iter().any(|&end| distance(end, last) < r) {
            continue;
        }
        yielding += 1;
        for (i, radius) in sequence.radius.iter().enumerate() {
            let bound = libm::pow(ratio, (l - 1 - i) as f64) * std::f64::consts::SQRT_2 * r_p;
            assert!(*radius <= bound * (1.0 + 1e-9), "seed {seed}: {radius} > {bound}");
        }
        for &point in sequence.b.iter().chain(&sequence.a) {
            assert!(distance(p, point) <= eta * r_p * (1.0 + ROUNDING), "seed {seed}");
        }
    }
    assert!(yielding > 2_000, "only {yielding} draws say anything");
}
