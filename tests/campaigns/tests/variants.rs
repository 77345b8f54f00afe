//! The variants of the algorithm: what each does that the default does not.

use std::collections::BTreeMap;

use meshwright::certify::{Guarantee, Promise, Verdict as Found, certify};
use meshwright::constructions::Angle;
use meshwright::formats::Provenance;
use meshwright::refine::incremental::Feature;
use meshwright::{
    Excuse, Mesh, MinAngle, Parameters, Pslg, Region, Rule, Splitting, Steiner, Thinning, mesh,
};
use meshwright_campaigns::families::Family;
use meshwright_campaigns::figures;
use meshwright_campaigns::judge::{Verdict, judge};
use meshwright_campaigns::plane::polar;

/// The paper's own rules, with another way of splitting.
fn paper(splitting: Splitting) -> Parameters {
    Parameters { splitting, ..Parameters::paper() }
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

/// The rules under which features may come one by one.
fn one_by_one() -> [Parameters; 4] {
    let ours = Parameters { incremental: true, ..Parameters::default() };
    [
        ours,
        Parameters { region: Region::Global, ..ours },
        Parameters { incremental: true, ..Parameters::paper() },
        Parameters { incremental: true, ..paper(Splitting::Augment) },
    ]
}

#[test]
fn features_that_come_one_by_one_leave_every_promise_kept() {
    for (name, outline) in spread() {
        for parameters in one_by_one() {
            let judged = judge(&outline, &parameters);
            assert!(!matches!(judged.verdict, Verdict::Failed(_)), "{name}: {:?}", judged.verdict);
        }
    }
}

#[test]
fn every_feature_comes_once_and_in_its_turn_unless_it_is_called() {
    for (name, outline) in spread() {
        for parameters in one_by_one() {
            let outcome = mesh(&outline, &parameters).expect("it is clean");
            let segment = |feature| match feature {
                Feature::Segment(segment) if segment != u32::MAX => Some(segment),
                _ => None,
            };
            let order = || outcome.introduced.iter().filter(|it| segment(it.feature).is_some());
            let mut all: Vec<_> = order().filter_map(|it| segment(it.feature)).collect();
            let in_turn = order().filter(|it| it.called_by.is_none());
            let in_turn: Vec<_> = in_turn.filter_map(|it| segment(it.feature)).collect();
            assert!(in_turn.is_sorted(), "{name}: {in_turn:?}");
            all.sort_unstable();
            assert!(all.into_iter().eq(0..outline.segments.len() as u32), "{name}");
        }
    }
}

/// Two rooms with a thin gap between them: a vertex of one encroaches the wall of the other, unseen.
#[test]
fn global_refinement_sees_through_what_is_not_meshed() {
    let gap = 0.01;
    let outline = Pslg {
        points: vec![
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
            [4.0 + gap, 2.0],
            [8.0, 0.0],
            [8.0, 4.0],
        ],
        segments: vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]],
        segment_tags: vec![0; 7],
        ..Pslg::default()
    };
    let alone = judge(&outline, &Parameters::default()).well();
    let global = Parameters { region: Region::Global, ..Parameters::default() };
    let promise = Promise::from(&global);
    let held = certify(&outline, &alone.mesh, &promise);
    assert_eq!(held.verdict(Guarantee::Unencroached), Found::Fails, "{held}");
    let together = judge(&outline, &global).well();
    assert!(together.mesh.points.len() > alone.mesh.points.len());
    assert!(certify(&outline, &together.mesh, &promise).holds());
}

/// Two legs at 1.5e-9 rad and a point beside them: the circumcenter of a triangle at that point
/// encroaches a subsegment that doubles no longer split, though the triangle has no point there.
#[test]
fn a_circumcenter_that_doubles_refuse_is_their_limit() {
    let outline = figures::outline(
        vec![
            [-0.2619558813927706, -1.3897406650896191],
            [1.3897406650896191, -0.2619558813927706],
            [0.2619558813927706, 1.3897406650896191],
            [-1.3897406650896191, 0.2619558813927706],
            [-0.21148691872219363, -0.6361624663025858],
            [-0.29071728723238177, -0.6011305488681432],
            [-0.36619168935204915, -0.5677593422052731],
            [-0.3411682790000613, -0.5788235095995568],
        ],
        vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 6], [4, 7]],
    );
    let steiner = Steiner::Circumcenter;
    let judged =
        judge(&outline, &Parameters { steiner, incremental: true, ..Parameters::default() });
    assert_eq!(judged.verdict, Verdict::Limited);
}

/// Legs at 1e-9 rad: three points of one leg count as collinear, though their rounding puts one into
/// the circle of the other two and a point of the other leg.
#[test]
fn three_points_of_a_segment_are_no_circle() {
    let outline = figures::outline(
        vec![
            [-59.58369945433974, -51.43998534576479],
            [-57.58369945433974, -51.43998534576479],
            [-57.58369945433974, -49.43998534576479],
            [-59.58369945433974, -49.43998534576479],
            [-58.313596003523145, -49.60702092780105],
            [-58.23142827680238, -49.59681195758216],
            [-58.25236050042439, -49.599412691745954],
            [-58.1483879436201, -49.586494567510016],
            [-58.17938134532821, -49.59034535817671],
        ],
        vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [4, 6], [4, 7], [4, 8]],
    );
    let parameters = Parameters {
        excuse: Excuse::Midpoints,
        steiner: Steiner::Circumcenter,
        incremental: true,
        ..Parameters::default()
    };
    let judged = judge(&outline, &parameters);
    assert_eq!(judged.verdict, Verdict::Limited);
    let certificate = judged.well().certificate;
    assert_eq!(certificate.verdict(Guarantee::Delaunay), Found::LimitedByPrecision);
}

/// A segment beside the hull at rounding distance: where it is split, the new point may lie beyond
/// the hull.
#[test]
fn global_refinement_splits_what_runs_along_the_hull() {
    for turn in (0..60).map(|i| 0.1 * f64::from(i)) {
        let at = |distance: f64, towards: f64| polar([0.0, 0.0], turn + towards, distance);
        let outline = Pslg {
            points: vec![[0.0, 0.0], at(1.0, 0.0), at(1.0, 0.05), at(3.0, 0.0)],
            segments: vec![[0, 1], [1, 2], [2, 0]],
            segment_tags: vec![0; 3],
            ..Pslg::default()
        };
        for steiner in [Steiner::OffCenter, Steiner::Circumcenter] {
            let global = Parameters { region: Region::Global, steiner, ..Parameters::default() };
            let outcome = mesh(&outline, &global).expect("it is clean");
            assert!(outcome.certificate.holds(), "{turn}: {}", outcome.certificate);
            assert_eq!(outcome.refused, 0, "{turn}");
        }
    }
}

#[test]
fn global_refinement_keeps_every_promise() {
    for (name, outline) in spread() {
        for base in [Parameters::default(), paper(Splitting::Shells)] {
            let judged = judge(&outline, &Parameters { region: Region::Global, ..base });
            assert!(!matches!(judged.verdict, Verdict::Failed(_)), "{name}: {:?}", judged.verdict);
        }
    }
}

#[test]
fn looking_ahead_makes_fewer_points_and_keeps_every_promise() {
    let (mut ahead, mut usual) = (0, 0);
    for (name, outline) in spread() {
        let parameters = Parameters { steiner: Steiner::LookAhead, ..Parameters::default() };
        let judged = judge(&outline, &parameters);
        assert!(!matches!(judged.verdict, Verdict::Failed(_)), "{name}: {:?}", judged.verdict);
        ahead += judged.points();
        usual += judge(&outline, &Parameters::default()).points();
    }
    assert!(100 * ahead < 90 * usual, "{ahead} points against {usual}");
}

/// The ways of meshing whose meshes are thinned here.
fn thinned() -> [Parameters; 5] {
    let ours = Parameters { thinning: Thinning::Tries(300), ..Parameters::default() };
    let soft = MinAngle::soft_from_degrees(33.0).expect("it is at most 34");
    [
        Parameters { steiner: Steiner::LookAhead, ..ours },
        Parameters { steiner: Steiner::LookAhead, soft_angle: Some(soft), ..ours },
        Parameters { max_area: Some(0.02), incremental: true, ..ours },
        Parameters { region: Region::Global, ..ours },
        Parameters { thinning: ours.thinning, ..paper(Splitting::Shells) },
    ]
}

#[test]
fn thinning_makes_no_more_points_misses_no_more_angles_and_keeps_every_promise() {
    let (mut with, mut without) = (0, 0);
    for (name, outline) in spread() {
        for parameters in thinned() {
            let judged = judge(&outline, &parameters);
            assert!(!matches!(judged.verdict, Verdict::Failed(_)), "{name}: {:?}", judged.verdict);
            let thin = mesh(&outline, &parameters).expect("it is clean");
            let usual = Parameters { thinning: Thinning::None, ..parameters };
            let usual = mesh(&outline, &usual).expect("it is clean");
            let saved = usual.mesh.points.len() - thin.mesh.points.len();
            let told = thin.thinned.expect("it is thinned");
            assert_eq!(saved as u64, told.saved, "{name}, {parameters:?}");
            assert!(thin.missed.len() <= usual.missed.len(), "{name}, {parameters:?}");
            with += thin.mesh.points.len();
            without += usual.mesh.points.len();
        }
    }
    assert!(100 * with < 98 * without, "{with} points, {without} without thinning");
}

#[test]
fn thinning_keeps_the_outline_first_and_the_order_of_what_was_there() {
    for (name, outline) in spread() {
        let parameters = Parameters { thinning: Thinning::Tries(300), ..Parameters::default() };
        let thin = mesh(&outline, &parameters).expect("it is clean").mesh;
        let usual = mesh(&outline, &Parameters::default()).expect("it is clean").mesh;
        let inside = |kind: &Provenance| *kind == Provenance::Circumcenter;
        let others = |made: &Mesh| {
            let points = made.points.iter().zip(&made.provenance);
            points
                .filter(|(_, kind)| !inside(kind))
                .map(|(&p, &kind)| (p, kind))
                .collect::<Vec<_>>()
        };
        assert_eq!(others(&thin), others(&usual), "{name}");
        // Of the Steiner points that were there before, those that stay keep their order.
        let places: BTreeMap<_, _> =
            usual.points.iter().enumerate().map(|(i, p)| (p.map(f64::to_bits), i)).collect();
        let stay = thin.points.iter().filter_map(|p| places.get(&p.map(f64::to_bits)));
        assert!(stay.is_sorted(), "{name}");
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
