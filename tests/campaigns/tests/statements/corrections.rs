//! Where the paper's text says something else than its proofs: each correction with a case that
//! the text gets wrong.

use std::f64::consts::{FRAC_PI_3, PI};

use meshwright::refine::piece::PieceEnd;
use meshwright::refine::{quality, shells};
use meshwright::{MinAngle, Parameters, mesh};
use meshwright_campaigns::figures::{self, corners};
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::plane::{angle, distance, polar};

use crate::{f, kappa_hat};

/// The proof of Lemma 2 ends with |p−q| / |x−p|; with |x−p| for |x−q| it is not true.
#[test]
fn the_last_denominator_of_lemma_2_is_x_q() {
    let (x, theta) = ([0.0, 0.0], 2.0);
    let (p, q) = (polar(x, 0.0, 100.0), polar(x, theta, 1.0));
    let bound = 2.0 * libm::sin(theta / 2.0);
    assert!(distance(p, q) / distance(x, q) >= bound);
    assert!(distance(p, q) / distance(x, p) < bound);
}

/// Claim 8.1 speaks of the side of L "as p", but p lies on L. The apex r sees more than others on
/// r's side; those on the other side may see more.
#[test]
fn claim_8_1_is_about_the_side_of_r() {
    let (p, q) = ([0.0, 0.0], [2.0, 0.0]);
    let (r, other) = ([1.0, 2.0], [1.0, -0.75]);
    // Both triangles are Delaunay: the angles opposite their common edge have a sum below 180°.
    assert!(angle(p, r, q) + angle(p, other, q) < PI);
    assert!(angle(p, other, q) > angle(p, r, q));
}

/// Lemma 7 (i) says "> κ̂", but (Quality′) acts on "< κ̂": an angle of κ̂ stays.
#[test]
fn an_angle_of_kappa_hat_stays() {
    let kappa = MinAngle { numerator: 1.0, denominator: 16.0 };
    let bad = |height: f64| {
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, height]];
        quality::trigger(corners, kappa, |_, _| false).is_some()
    };
    assert!(!bad(1.0), "tan 1/4 is κ̂ itself");
    assert!(bad(0.999_999));
}

/// The abstract has no angle below f(θ*). From θ* = 36.53° on that is more than κ̂, and only κ̂ is
/// kept: the bound is min{κ̂, f(θ*)}, as Lemma 7 says.
#[test]
fn the_bound_of_the_abstract_needs_kappa_hat() {
    let rectangle = corners([0.0, 0.0], [1.0, 0.53]).to_vec();
    let outline = figures::outline(rectangle, vec![[0, 1], [1, 2], [2, 3], [3, 0]]);
    let theta_star = smallest_angle(&outline).expect("it has corners").min(FRAC_PI_3);
    let outcome = mesh(&outline, &Parameters::default()).expect("it is clean");
    let smallest = outcome.certificate.smallest_angle.expect("there are triangles");
    assert!(outcome.certificate.holds(), "{}", outcome.certificate);
    assert!(kappa_hat() < smallest && smallest < f(theta_star), "{smallest}");
}

/// §10 speaks of "three subsegments": the three points that count as input make four, none shorter
/// than a sixth of the segment.
#[test]
fn three_shells_make_four_subsegments() {
    let end = |distance, ends_part| PieceEnd { distance, exact: true, bisected: false, ends_part };
    let mut shortest = f64::INFINITY;
    for i in 1..=4096 {
        let length = f64::from(i) / 64.0;
        let half = 0.5 * length;
        let shell = shells::split(end(0.0, false), end(half, true)).distance;
        // The other half is its mirror image.
        let ends = [0.0, shell, half, length - shell, length];
        let pieces = ends.windows(2).map(|pair| pair[1] - pair[0]);
        assert_eq!(pieces.clone().count(), 4);
        shortest = pieces.map(|piece| piece / length).fold(shortest, f64::min);
    }
    assert!((1.0 / 6.0 - 1e-12..0.17).contains(&shortest), "{shortest}");
}

/// The angles that the paper rounds: 26.45°, 36.53°, 21.47°, 137.1°.
#[test]
fn the_papers_angles_are_confirmed() {
    let near = |radians: f64, degrees: f64| (radians.to_degrees() - degrees).abs() < 6e-4;
    assert!(near(kappa_hat(), 26.452));
    let crossing = libm::asin((libm::sqrt(3.0) - 1.0) / 2.0);
    assert!(near(crossing, 21.471) && near(PI - 2.0 * crossing, 137.059));
    // θ* at which f(θ*) is κ̂: §8 gives it as arcsin(2 sin κ̂) − κ̂.
    let limit = libm::asin(2.0 * libm::sin(kappa_hat())) - kappa_hat();
    assert!(near(limit, 36.534) && near(f(limit), 26.452));
}
