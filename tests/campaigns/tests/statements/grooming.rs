//! Definition 3 and Theorem 5: points put on segments beforehand.

use std::f64::consts::FRAC_PI_2;

use meshwright::domain::Domain;
use meshwright::{Pslg, Region};
use meshwright_campaigns::Random;
use meshwright_campaigns::families::Family;
use meshwright_campaigns::figures;
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::plane::{between, distance};

/// A γ-Bounded Reduction Augmenter (Definition 3): cuts some segments at random places; every
/// piece is at least 1/γ of its segment. Answers with the augmented outline.
fn augmented(outline: &Pslg, gamma: f64, random: &mut Random) -> Pslg {
    let (mut points, mut segments) = (outline.points.clone(), Vec::new());
    for &[a, b] in &outline.segments {
        let [from, to] = [a, b].map(|v| outline.points[v as usize]);
        let (mut last, mut at) = (a, 0.0);
        while random.chance(0.8) {
            let next = at + random.range(1.0, 1.3) * 1.000_001 / gamma;
            if next + 1.000_001 / gamma > 1.0 {
                break;
            }
            points.push(between(from, to, next));
            let point = points.len() as u32 - 1;
            segments.push([last, point]);
            (last, at) = (point, next);
        }
        segments.push([last, b]);
    }
    figures::outline(points, segments)
}

/// Theorem 5: lfs′(x) ≥ sin θ* / (2γ − 1) · lfs(x) everywhere, where lfs′ is that of the augmented
/// input; and Definition 3 adds at most ⌊γ − 1⌋ points to a segment.
#[test]
fn theorem_5() {
    let mut added = 0;
    let mut least = f64::INFINITY;
    for seed in 0..200 {
        let random = &mut Random::new(seed);
        let family = *random.pick(&Family::ALL);
        let drawn = family.outline(random.whole(1, 8), random.log_range(0.02, 0.5), seed);
        // The theorem knows no seeds of holes.
        let outline = figures::outline(drawn.points, drawn.segments);
        let Some(theta_star) = smallest_angle(&outline) else { continue };
        let gamma = random.range(2.0, 6.0);
        let finer = augmented(&outline, gamma, random);
        let more = finer.points.len() - outline.points.len();
        assert!(more <= (gamma - 1.0).floor() as usize * outline.segments.len(), "seed {seed}");
        added += more;
        let sigma = libm::sin(theta_star.min(FRAC_PI_2)) / (2.0 * gamma - 1.0);
        let [lfs, lfs_finer] = [&outline, &finer].map(|outline| {
            let (domain, _) = Domain::new(outline, Region::Domain).expect("it is clean");
            assert_eq!(domain.scale_exponent, 0);
            move |x| domain.lfs(x)
        });
        for _ in 0..200 {
            // Near the outline, where it matters.
            let &[a, b] = random.pick(&finer.segments);
            let [a, b] = [a, b].map(|v| finer.points[v as usize]);
            let spread = distance(a, b) * random.log_range(1e-3, 10.0);
            let x = between(a, b, random.unit()).map(|c| {
                c + spread * random.range(-1.0, 1.0) * f64::from(u8::from(random.chance(0.8)))
            });
            let (before, after) = (lfs(x), lfs_finer(x));
            assert!(
                after >= sigma * before * (1.0 - 1e-9),
                "seed {seed}: {after} < {sigma}·{before}"
            );
            assert!(
                after <= before * (1.0 + 1e-9),
                "seed {seed}: more features, {after} > {before}"
            );
            least = least.min(after / before);
        }
    }
    assert!(added > 500 && least < 0.3, "{added} points added, least ratio {least}");
}
