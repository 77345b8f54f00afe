//! Lemmas 1, 2 and 6: points, rays and balls.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use meshwright_campaigns::Random;
use meshwright_campaigns::plane::{angle, distance, polar};

use crate::{ROUNDING, f};

/// Lemma 1: a ball around p on one ray that holds a point q of the other ray but not their common
/// end x has |q−x| / |p−x| < 2 cos θ, and from 45° on |q−x| / |p−q| ≤ 2 cos θ.
#[test]
fn lemma_1() {
    for seed in 0..20_000 {
        let random = &mut Random::new(seed);
        let x = [random.range(-1.0, 1.0), random.range(-1.0, 1.0)];
        let theta = random.range(1e-3, FRAC_PI_2 - 1e-3);
        let towards = random.direction();
        let p_x = random.log_range(0.01, 10.0);
        let p = polar(x, towards, p_x);
        // The ball reaches the other ray and does not hold x.
        let r = p_x * random.range(libm::sin(theta), 1.0);
        let half_chord = libm::sqrt((r * r - libm::pow(p_x * libm::sin(theta), 2.0)).max(0.0));
        let q_x = p_x * libm::cos(theta) + half_chord * random.range(-1.0, 1.0);
        let q = polar(x, towards + theta, q_x);
        let bound = 2.0 * libm::cos(theta) + ROUNDING;
        assert!(q_x / p_x <= bound, "seed {seed}: {} > {bound}", q_x / p_x);
        if theta >= FRAC_PI_4 {
            let p_q = distance(p, q);
            assert!(p_q <= r + ROUNDING && q_x / p_x <= q_x / r + ROUNDING, "seed {seed}");
            assert!(q_x / p_q <= bound, "seed {seed}: {} > {bound}", q_x / p_q);
        }
    }
}

/// Below 45° the second inequality of Lemma 1 is not true: the lemma says no more than it can.
#[test]
fn lemma_1_has_a_reason_for_its_45_degrees() {
    // q is the point of the ray that is nearest to p, |p−x| = 1.
    let theta = 20_f64.to_radians();
    assert!(libm::cos(theta) / libm::sin(theta) > 2.0 * libm::cos(theta));
}

/// Lemma 2: |p−q| ≥ 2 |q−x| sin(θ/2) where |x−q| ≤ |x−p| and θ is the angle at x.
#[test]
fn lemma_2() {
    for seed in 0..20_000 {
        let random = &mut Random::new(seed);
        let x = [random.range(-1.0, 1.0), random.range(-1.0, 1.0)];
        let (theta, towards) = (random.range(1e-3, PI), random.direction());
        let q_x = random.log_range(0.01, 10.0);
        let p_x = q_x * if random.chance(0.2) { 1.0 } else { random.log_range(1.0, 100.0) };
        let (p, q) = (polar(x, towards, p_x), polar(x, towards + theta, q_x));
        let bound = 2.0 * q_x * libm::sin(theta / 2.0);
        assert!(
            distance(p, q) >= bound * (1.0 - 1e-9),
            "seed {seed}: {} < {bound}",
            distance(p, q)
        );
    }
}

/// Lemma 6: with p between x and s, |p−s| ≤ |x−p| ≤ |x−q|, θ = ∠pxq and φ = ∠psq:
/// φ ≥ arctan(sin θ / (2 − cos θ)), with equality where the three lengths are equal.
#[test]
fn lemma_6() {
    for seed in 0..20_000 {
        let random = &mut Random::new(seed);
        let x = [random.range(-1.0, 1.0), random.range(-1.0, 1.0)];
        let (theta, towards) = (random.range(1e-3, PI - 1e-3), random.direction());
        let x_p = random.log_range(0.01, 10.0);
        let equal = random.chance(0.1);
        let p_s = x_p * if equal { 1.0 } else { random.log_range(1e-3, 1.0) };
        let x_q = x_p * if equal { 1.0 } else { random.log_range(1.0, 1e3) };
        let p = polar(x, towards, x_p);
        let s = polar(x, towards, x_p + p_s);
        let q = polar(x, towards + theta, x_q);
        let phi = angle(p, s, q);
        assert!(phi >= f(theta) * (1.0 - 1e-9), "seed {seed}: {phi} < {}", f(theta));
        if equal {
            assert!((phi / f(theta) - 1.0).abs() < 1e-9, "seed {seed}: {phi}, {}", f(theta));
        }
    }
}
