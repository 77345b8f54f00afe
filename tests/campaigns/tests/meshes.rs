//! Random outlines of every family, meshed and judged: every promise is kept.

mod support;

use meshwright::certify::{Promise, certify};
use meshwright::{
    Excuse, MinAngle, Parameters, Pslg, Region, Splitting, Steiner, Thinning, domain,
};
use meshwright_campaigns::families::Family;
use meshwright_campaigns::hostile::hostile;
use meshwright_campaigns::judge::{Verdict, judge};
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::run::{Ending, guarded, in_order};
use meshwright_campaigns::tangle::Tangle;
use meshwright_campaigns::{Random, figures, poly, profiles};
use proptest::prelude::*;

/// A tangled outline in a box.
fn tangled(kind: Tangle, segments: usize, seed: u64) -> Pslg {
    let mut outline = kind.outline(segments, segments / 3, &mut Random::new(seed));
    let first = outline.points.len() as u32;
    outline.points.extend([[-2.0, -2.0], [3.0, -2.0], [3.0, 3.0], [-2.0, 3.0]]);
    outline.segments.extend((0..4).map(|i| [first + i, first + (i + 1) % 4]));
    outline.segment_tags.extend([1; 4]);
    outline
}

proptest! {
    #![proptest_config(support::cases(16))]

    #[test]
    fn what_is_mended_is_meshed_and_keeps_every_promise(
        kind in prop::sample::select(vec![Tangle::Soup, Tangle::Hatch]),
        segments in 2_usize..60,
        seed: u64,
    ) {
        let outline = tangled(kind, segments, seed);
        let mended = domain::repair(&outline, 0.0).expect("it can be mended").outline;
        if let Verdict::Failed(reasons) = judge(&mended, &Parameters::default()).verdict {
            panic!("{}\n{}", reasons.join("\n"), poly::text(&outline, ""));
        }
    }
}

/// A random choice of everything that a run may vary and that keeps the promises.
fn parameters() -> impl Strategy<Value = Parameters> {
    let splitting = prop::sample::select(vec![Splitting::Ladder, Splitting::Shells]);
    let excuse = prop::sample::select(vec![Excuse::Measured, Excuse::Midpoints]);
    let steiner =
        prop::sample::select(vec![Steiner::OffCenter, Steiner::Circumcenter, Steiner::LookAhead]);
    let region = prop::sample::select(vec![Region::Domain, Region::Hull, Region::Global]);
    let min_angle = prop_oneof![
        Just(MinAngle::default()),
        (5.0..MinAngle::LARGEST_DEGREES)
            .prop_map(|degrees| MinAngle::from_degrees(degrees).expect("within the range"))
    ];
    let thinning = prop_oneof![Just(Thinning::None), (1_u64..200).prop_map(Thinning::Tries)];
    (splitting, excuse, steiner, region, min_angle, any::<bool>(), thinning).prop_map(
        |(splitting, excuse, steiner, region, min_angle, incremental, thinning)| Parameters {
            splitting,
            excuse,
            steiner,
            region,
            min_angle,
            incremental,
            thinning,
            ..Parameters::default()
        },
    )
}

/// Meshes an outline of a family; the failure message holds the outline.
fn keeps_its_promises(family: Family, size: usize, theta: f64, seed: u64, parameters: &Parameters) {
    let outline = family.outline(size, theta, seed);
    if let Verdict::Failed(reasons) = judge(&outline, parameters).verdict {
        panic!("{family:?}, {parameters:?}\n{}\n{}", reasons.join("\n"), poly::text(&outline, ""));
    }
}

macro_rules! families {
    ($($name:ident: $family:expr, $size:expr, $smallest:expr;)*) => { $(
        proptest! {
            #![proptest_config(support::cases(24))]
            #[test]
            fn $name(size in 1_usize..$size, exponent in $smallest..-0.3, seed: u64) {
                keeps_its_promises($family, size, libm::exp10(exponent), seed, &Parameters::default());
            }
        }
    )* };
}

families! {
    random_pslgs_keep_every_promise: Family::RandomPslg, 40, -1.0;
    needles_keep_every_promise: Family::Needles, 12, -7.0;
    fans_keep_every_promise: Family::Fan, 40, -5.0;
    stars_keep_every_promise: Family::Star, 30, -3.0;
    combs_keep_every_promise: Family::Comb, 20, -3.0;
    nested_slits_keep_every_promise: Family::NestedSlits, 8, -1.0;
    long_thin_wedges_keep_every_promise: Family::LongThinWedge, 6, -6.0;
    lattices_keep_every_promise: Family::Lattice, 32, -1.0;
}

proptest! {
    #![proptest_config(support::cases(60))]

    /// Thin angles are left to the tests above: shells make 1/θ points of them.
    #[test]
    fn every_way_of_refining_keeps_every_promise(
        family in prop::sample::select(Family::ALL.to_vec()),
        size in 1_usize..12,
        exponent in -2.0..-0.3,
        seed: u64,
        parameters in parameters(),
    ) {
        keeps_its_promises(family, size, libm::exp10(exponent), seed, &parameters);
    }

    #[test]
    fn no_triangle_is_larger_than_asked(
        family in prop::sample::select(Family::ALL.to_vec()),
        seed: u64,
        largest in 1e-3..1e-1,
    ) {
        let outline = family.outline(6, 0.1, seed);
        let parameters = Parameters { max_area: Some(largest), ..Parameters::default() };
        let made = judge(&outline, &parameters).well();
        for triangle in &made.mesh.triangles {
            let [a, b, c] = triangle.map(|v| made.mesh.points[v as usize]);
            let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
            prop_assert!(area <= largest * (1.0 + 1e-12), "{area} in {family:?}");
        }
    }
}

#[test]
fn the_certificate_is_that_of_the_mesh_it_comes_with() {
    for number in 0..20 {
        let outline = hostile(6, number);
        let parameters = Parameters::default();
        let made = judge(&outline, &parameters).well();
        let again = certify(&outline, &made.mesh, &Promise::from(&parameters));
        assert_eq!(made.certificate, again, "seed 6, number {number}");
    }
}

#[test]
fn sixty_hostile_outlines_keep_every_promise() {
    sixty_hostile_outlines(Parameters::default());
}

#[test]
fn sixty_hostile_outlines_keep_every_promise_when_they_are_thinned() {
    let thinning = Thinning::Tries(200);
    let soft_angle = MinAngle::soft_from_degrees(30.0).ok();
    sixty_hostile_outlines(Parameters { thinning, ..Parameters::default() });
    sixty_hostile_outlines(Parameters { thinning, soft_angle, ..Parameters::default() });
}

fn sixty_hostile_outlines(parameters: Parameters) {
    let mesh_one =
        |i: usize| guarded(move || judge(&hostile(3, i as u64), &parameters).verdict).ending;
    in_order(60, 2, mesh_one, |i, ending| match ending {
        Ending::Done(Verdict::Failed(reasons)) => {
            let outline = hostile(3, i as u64);
            panic!("seed 3, number {i}:\n{}\n{}", reasons.join("\n"), poly::text(&outline, ""));
        }
        Ending::Done(_) => {}
        ending => panic!("seed 3, number {i}: {ending:?}"),
    });
}

/// Outlines of the campaign where doubles end in the midst of a cavity: their faults were reported
/// as such before they were known to be limited by precision.
#[test]
fn what_doubles_end_in_the_midst_of_is_limited_not_broken() {
    for number in [3571, 5716, 6935] {
        let drawn = profiles::draw(1, number, smallest_angle(&hostile(1, number)));
        for steiner in [Steiner::OffCenter, Steiner::Circumcenter, Steiner::LookAhead] {
            let parameters = Parameters { steiner, ..drawn };
            let outline = profiles::prepared(hostile(1, number), &parameters);
            if let Verdict::Failed(reasons) = judge(&outline, &parameters).verdict {
                panic!("number {number}, {parameters:?}: {}", reasons.join("\n"));
            }
        }
    }
}

/// Where the whole hull stays Delaunay, a hidden vertex may encroach what is far from where doubles end,
/// because what hides it is there.
#[test]
fn what_is_hidden_where_doubles_end_is_limited_not_broken() {
    let outline = hostile(46, 1862);
    for steiner in [Steiner::OffCenter, Steiner::Circumcenter] {
        let parameters = Parameters { steiner, region: Region::Global, ..Parameters::default() };
        if let Verdict::Failed(reasons) = judge(&outline, &parameters).verdict {
            panic!("{parameters:?}: {}", reasons.join("\n"));
        }
    }
}

#[test]
fn wedges_take_few_points() {
    for (degrees, most) in [(1.0, 100), (0.1, 130), (0.01, 220), (0.001, 300)] {
        let judged = judge(&figures::wedge(f64::to_radians(degrees)), &Parameters::default());
        assert_eq!(judged.verdict, Verdict::Kept, "{degrees}°");
        assert!(judged.points() <= most, "{} points at {degrees}°", judged.points());
    }
}

#[test]
fn where_doubles_end_wedges_still_take_few_points() {
    for theta in [1e-7, 1e-8, 1e-9] {
        let judged = judge(&figures::wedge(theta), &Parameters::default());
        assert!(!matches!(judged.verdict, Verdict::Failed(_)), "{:?}", judged.verdict);
        assert!(judged.points() <= 600, "{} points at {theta} rad", judged.points());
    }
}

/// A judge that always says yes would pass every other test here.
#[test]
fn the_judge_notices_a_moved_point() {
    let random = &mut Random::new(5);
    let outline = Family::RandomPslg.outline(20, 0.1, 5);
    let made = judge(&outline, &Parameters::default()).well();
    let mut found = 0;
    for _ in 0..20 {
        let mut mesh = made.mesh.clone();
        let moved = random.whole(0, mesh.points.len() - 1);
        mesh.points[moved][0] += 0.5;
        found += u32::from(!certify(&outline, &mesh, &Promise::default()).holds());
    }
    assert_eq!(found, 20);
}
