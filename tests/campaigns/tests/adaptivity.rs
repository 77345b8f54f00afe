//! §3.1: where no input angle is below 36.53°, Ruppert's algorithm needs no adapting.

mod support;

use meshwright::{MinAngle, Parameters, Pslg, Rule, Splitting, Steiner};
use meshwright_campaigns::families::Family;
use meshwright_campaigns::judge::judge;
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::motion::Motion;
use meshwright_campaigns::{Random, figures};
use proptest::prelude::*;

/// The smallest θ* for which arctan(sin θ* / (2 − cos θ*)) ≥ κ̂, in degrees, rounded up.
const LIMIT: f64 = 36.54;

/// Outlines with no angle below the limit: of each draw those that have none.
fn wide_outline() -> impl Strategy<Value = Pslg> {
    let family =
        prop::sample::select(vec![Family::Lattice, Family::NestedSlits, Family::RandomPslg]);
    let drawn =
        (family, 1_usize..14, any::<u64>(), 0.0..6.3).prop_map(|(family, size, seed, turn)| {
            Motion::turn(turn).apply(&family.outline(size, 0.5, seed))
        });
    let polygon = (3_usize..9, any::<u64>()).prop_map(|(corners, seed)| {
        let random = &mut Random::new(seed);
        let turn = random.direction();
        let points: Vec<_> = (0..corners)
            .map(|i| {
                let direction = turn + std::f64::consts::TAU * i as f64 / corners as f64;
                meshwright_campaigns::plane::polar([0.0, 0.0], direction, random.range(0.8, 1.2))
            })
            .collect();
        let count = corners as u32;
        figures::outline(points, (0..count).map(|i| [i, (i + 1) % count]).collect())
    });
    prop_oneof![drawn, polygon].prop_filter("an angle below 36.54°", |outline| {
        smallest_angle(outline).is_none_or(|theta| theta.to_degrees() > LIMIT)
    })
}

fn parameters(rule: Rule, splitting: Splitting, steiner: Steiner) -> Parameters {
    Parameters { rule, splitting, steiner, ..Parameters::default() }
}

proptest! {
    #![proptest_config(support::cases(40))]

    #[test]
    fn ruppert_and_the_adaptive_rule_make_the_same_mesh(
        outline in wide_outline(),
        splitting in prop::sample::select(vec![Splitting::Shells, Splitting::Ladder]),
    ) {
        let [ruppert, adaptive] = [Rule::Ruppert, Rule::Adaptive].map(|rule| {
            judge(&outline, &parameters(rule, splitting, Steiner::Circumcenter)).well()
        });
        prop_assert_eq!(&ruppert.mesh, &adaptive.mesh);
        let smallest = adaptive.certificate.smallest_angle.expect("there are triangles");
        prop_assert!(smallest >= MinAngle::default().radians() * (1.0 - 1e-7), "{smallest}");
    }

    #[test]
    fn with_off_centers_both_rules_leave_no_small_angle(outline in wide_outline()) {
        for rule in [Rule::Ruppert, Rule::Adaptive] {
            let made = judge(&outline, &parameters(rule, Splitting::Ladder, Steiner::OffCenter)).well();
            let smallest = made.certificate.smallest_angle.expect("there are triangles");
            prop_assert!(smallest >= MinAngle::default().radians() * (1.0 - 1e-7), "{smallest}");
        }
    }
}

/// Below the limit the rules differ: Ruppert's attacks what the adaptive one leaves alone.
#[test]
fn across_a_small_angle_the_rules_differ() {
    let wedge = figures::wedge(10_f64.to_radians());
    let adaptive =
        judge(&wedge, &parameters(Rule::Adaptive, Splitting::Shells, Steiner::Circumcenter)).well();
    assert!(adaptive.certificate.smallest_angle.is_some_and(|a| a.to_degrees() < 20.0));
    let budget = Parameters {
        max_points: 20_000,
        ..parameters(Rule::Ruppert, Splitting::Shells, Steiner::Circumcenter)
    };
    if let Ok(ruppert) = meshwright::mesh(&wedge, &budget) {
        assert_ne!(ruppert.mesh.triangles, adaptive.mesh.triangles);
    }
}
