//! The variants of the algorithm: what each does that the default does not.

use meshwright::certify::{Guarantee, Verdict as Found};
use meshwright::constructions::Angle;
use meshwright::formats::Provenance;
use meshwright::{Excuse, MinAngle, Parameters, Pslg, Region, Rule, Splitting, Steiner, mesh};
use meshwright_campaigns::families::Family;
use meshwright_campaigns::figures;
use meshwright_campaigns::judge::{Verdict, judge};

/// The paper's own rules, with another way of splitting.
fn paper(splitting: Splitting) -> Parameters {
    Parameters {
        splitting,
        excuse: Excuse::Midpoints,
        steiner: Steiner::Circumcenter,
        region: Region::Hull,
        ..Parameters::default()
    }
}

/// Outlines of every family, with angles down to 0.01 rad.
fn spread() -> impl Iterator<Item = (String, Pslg)> {
    Family::ALL.into_iter().flat_map(|family| {
        [0.3, 0.05, 0.01].into_iter().enumerate().map(move |(seed, theta)| {
            (format!("{family:?} {theta}"), family.outline(6, theta, seed as u64))
        })
    })
}

#[test]
fn every_initial_triangulation_is_constrained_delaunay() {
    for (name, outline) in spread() {
        let parameters = Parameters { max_points: 0, ..Parameters::default() };
        let outcome = mesh(&outline, &parameters).expect("it is clean");
        assert!(!outcome.mesh.provenance.iter().any(|&kind| kind != Provenance::Input), "{name}");
        for guarantee in [Guarantee::Complex, Guarantee::Delaunay, Guarantee::Conforming] {
            let judgement = outcome.certificate.judgement(guarantee);
            assert_eq!(judgement.faults, 0, "{name}: {:?}", judgement.first);
        }
    }
}

#[test]
fn algorithm_1_puts_a_power_of_two_on_every_leg_of_a_spoke() {
    let mut outline = figures::spokes20(900);
    outline.segments.iter_mut().step_by(2).for_each(|ends| ends.reverse());
    let made = judge(&outline, &paper(Splitting::Augment)).well();
    let degree = |p: usize| outline.segments.iter().filter(|s| s.contains(&(p as u32))).count();
    let hub = (0..outline.points.len()).max_by_key(|&p| degree(p)).expect("there are points");
    let hub = outline.points[hub];
    let mut legs = 0;
    for (segment, ends) in outline.segments.iter().enumerate() {
        if !ends.iter().any(|&end| outline.points[end as usize] == hub) {
            continue;
        }
        let distance = |v: u32| {
            let [x, y] = made.mesh.points[v as usize];
            libm::hypot(x - hub[0], y - hub[1])
        };
        let [a, b] = ends.map(|end| outline.points[end as usize]);
        let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
        let own = made.mesh.edges.iter().zip(&made.mesh.edge_segments);
        let mut ends = own.filter(|&(_, &s)| s as usize == segment).flat_map(|(edge, _)| edge);
        let augmented = ends.any(|&v| {
            let d = distance(v);
            let power = libm::exp2(libm::round(libm::log2(d)));
            made.mesh.provenance[v as usize] == Provenance::Shell
                && (d / power - 1.0).abs() < 1e-12
                && (0.2 * length..=0.4 * length).contains(&power)
        });
        assert!(augmented, "segment {segment}");
        legs += 1;
    }
    assert_eq!(legs, 20);
}

#[test]
fn the_augmenter_keeps_every_promise() {
    for (name, outline) in spread() {
        let judged = judge(&outline, &paper(Splitting::Augment));
        assert!(!matches!(judged.verdict, Verdict::Failed(_)), "{name}: {:?}", judged.verdict);
    }
}

#[test]
fn the_terminator_ends_with_a_conforming_delaunay_mesh() {
    for (name, outline) in spread() {
        let parameters = Parameters { rule: Rule::Terminator, ..paper(Splitting::Shells) };
        let outcome = mesh(&outline, &parameters).expect("it is clean");
        assert_eq!(outcome.end, meshwright::refine::End::Finished, "{name}");
        let certificate = &outcome.certificate;
        for guarantee in [
            Guarantee::Complex,
            Guarantee::Delaunay,
            Guarantee::Unencroached,
            Guarantee::Conforming,
        ] {
            assert_ne!(certificate.verdict(guarantee), Found::Fails, "{name}: {certificate}");
        }
    }
}

#[test]
fn ruppert_above_its_limit_names_the_apex() {
    let wedge = figures::wedge(0.1);
    let parameters = Parameters { rule: Rule::Ruppert, ..Parameters::default() };
    let outcome = mesh(&wedge, &parameters).expect("it is clean");
    let apex = wedge.points.iter().position(|&p| p == [0.0, 0.0]).expect("the apex is at 0");
    assert!(outcome.refused > 0);
    assert_eq!(outcome.refused_at, [apex as u32]);
}

#[test]
fn a_soft_target_is_reached_or_the_angle_is_listed() {
    let target = MinAngle::soft_from_degrees(33.0).expect("it is at most 34");
    let parameters = Parameters { soft_angle: Some(target), ..Parameters::default() };
    let (mut angles, mut missed) = (0, 0);
    for (name, outline) in spread() {
        let outcome = mesh(&outline, &parameters).expect("it is clean");
        assert!(outcome.certificate.holds(), "{name}: {}", outcome.certificate);
        let made = &outcome.mesh;
        for (number, triangle) in made.triangles.iter().enumerate() {
            let corners = triangle.map(|v| made.points[v as usize]);
            for i in 0..3 {
                let [j, k] = [(i + 1) % 3, (i + 2) % 3];
                let opposite = [j, k].map(|corner| made.provenance[triangle[corner] as usize]);
                // An edge between two points on segments may be excused.
                let inside = opposite.contains(&Provenance::Circumcenter);
                let small = Angle::at(corners[i], corners[j], corners[k]).is_below(target);
                if small && inside {
                    let listed = |m: &meshwright::Missed| m.triangle as usize == number;
                    assert!(outcome.missed.iter().any(listed), "{name}: triangle {number}");
                }
            }
        }
        angles += 3 * made.triangles.len();
        missed += outcome.missed.len();
    }
    assert!(1000 * missed <= angles, "{missed} of {angles} angles missed");
}
