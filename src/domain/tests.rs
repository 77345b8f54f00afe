use proptest::prelude::*;

use super::*;
use crate::formats::Enclosed;

/// An untagged outline without a file.
fn outline(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Pslg {
    Pslg {
        points: points.to_vec(),
        segments: segments.to_vec(),
        segment_tags: vec![0; segments.len()],
        ..Pslg::default()
    }
}

fn domain(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Result<Domain, Error> {
    Domain::new(&outline(points, segments), Region::Domain).map(|(domain, _)| domain)
}

/// The sign of the area of a triangle of small whole numbers.
fn turn(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
}

/// Whether `p` lies on the segment (ends included).
fn lies_on(p: [i64; 2], [a, b]: [[i64; 2]; 2]) -> bool {
    turn(a, b, p) == 0 && (0..2).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k]))
}

/// Assumption 1 (ii) and (iii), pair by pair: the oracle.
fn is_clean(points: &[[i64; 2]], segments: &[[u32; 2]]) -> bool {
    let place = |s: [u32; 2]| s.map(|end| points[end as usize]);
    for &s in segments {
        if points.iter().any(|&p| !place(s).contains(&p) && lies_on(p, place(s))) {
            return false;
        }
    }
    for (i, &s) in segments.iter().enumerate() {
        for &t in &segments[..i] {
            let ([a, b], [c, d]) = (place(s), place(t));
            if turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0 {
                return false;
            }
        }
    }
    true
}

/// Points of a small grid and segments between them: crossings, touches and overlaps abound.
fn soups() -> impl Strategy<Value = (Vec<[i64; 2]>, Vec<[u32; 2]>)> {
    (3_usize..12, 2_i64..40).prop_flat_map(|(count, size)| {
        let point = [0..size, 0..size];
        let end = 0..count as u32;
        (prop::collection::vec(point, count), prop::collection::vec([end.clone(), end], 0..8))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn a_soup_is_accepted_exactly_if_assumption_1_holds((points, segments) in soups()) {
        let places: Vec<[f64; 2]> = points.iter().map(|p| p.map(|c| c as f64)).collect();
        match domain(&places, &segments) {
            Ok(_) => prop_assert!(is_clean(&points, &segments)),
            Err(Error::Conflicts(_)) => prop_assert!(!is_clean(&points, &segments)),
            Err(_) => {}
        }
    }
}

/// An outline as if read from a one-based `.poly` file, its points on lines 2, 3, …
pub(super) fn file(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Pslg {
    let mut pslg = outline(points, segments);
    pslg.source.file = "site.poly".to_owned();
    pslg.source.first_number = 1;
    let first = points.len() as u32 + 3;
    pslg.source.point_lines = (2..first - 1).collect();
    pslg.source.segment_lines = (first..).take(segments.len()).collect();
    pslg.source.hole_lines = vec![100];
    pslg.source.region_lines = vec![200, 201];
    pslg
}

fn message(pslg: &Pslg) -> String {
    Domain::new(pslg, Region::Domain).expect_err("the outline is wrong").to_string()
}

fn warnings(pslg: &Pslg) -> Vec<String> {
    let (_, warnings) = Domain::new(pslg, Region::Domain).expect("the outline is right");
    warnings.iter().map(ToString::to_string).collect()
}

pub(super) const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
pub(super) const LOOP: [[u32; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];

/// The square with more points and segments.
pub(super) fn square_and(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Pslg {
    file(&[&SQUARE, points].concat(), &[&LOOP, segments].concat())
}

#[test]
fn crossing_segments_are_both_named() {
    assert_eq!(
        message(&square_and(&[], &[[0, 2], [1, 3]])),
        "segments 5 and 6 cross near (0.5, 0.5)\n\
         \x20 site.poly:11: 5 1 3\n\
         \x20 site.poly:12: 6 2 4\n\
         help: `--repair` splits them there; \
         `meshwright draw site.poly -o site.svg` shows the place"
    );
}

#[test]
fn a_segment_that_ends_on_another_one_is_named_by_its_end() {
    let text = message(&square_and(&[[0.5, 0.0], [0.5, 0.5]], &[[4, 5]]));
    assert!(
        text.starts_with(
            "point 5, where a segment ends, lies on segment 1 near (0.5, 0)\n\
         \x20 site.poly:6: 5 0.5 0\n\
         \x20 site.poly:9: 1 1 2\n"
        ),
        "{text}"
    );
}

#[test]
fn segments_that_overlap_are_one_error_not_three() {
    let text = message(&square_and(&[[0.5, 0.0], [2.0, 0.0]], &[[4, 5]]));
    assert!(text.starts_with("segments 1 and 5 overlap near (0.75, 0)\n"), "{text}");
    assert!(!text.contains("where a segment ends"), "{text}");
}

#[test]
fn a_point_on_a_segment_is_named_with_it() {
    let text = message(&square_and(&[[1.0, 0.25]], &[]));
    assert!(text.starts_with("point 5 lies on segment 2 near (1, 0.25)\n"), "{text}");
}

#[test]
fn a_point_on_a_segment_of_the_hull_is_named_where_the_hull_is_meshed() {
    let error = Domain::new(&square_and(&[[1.0, 0.25]], &[]), Region::Hull).expect_err("wrong");
    assert!(error.to_string().starts_with("point 5 lies on segment 2 near (1, 0.25)\n"));
}

#[test]
fn of_many_conflicts_three_are_named_and_the_rest_counted() {
    let rungs: Vec<[f64; 2]> =
        (1..6).flat_map(|i| [[-1.0, f64::from(i) / 8.0], [0.5, f64::from(i) / 8.0]]).collect();
    let text = message(&square_and(&rungs, &[[4, 5], [6, 7], [8, 9], [10, 11], [12, 13]]));
    assert_eq!(text.matches(" cross near ").count(), 3, "{text}");
    assert!(text.contains("\nand 2 more\n"), "{text}");
}

#[test]
fn an_outline_open_by_a_hair_names_its_open_ends_and_the_gap() {
    let points = [&SQUARE[..], &[[0.0, 1e-9]]].concat();
    let text = message(&file(&points, &[[0, 1], [1, 2], [2, 3], [3, 4]]));
    assert!(
        text.starts_with(
            "the outline encloses nothing: points 1 and 5 are open ends, 1e-9 apart\n\
             \x20 site.poly:2: 1 0 0\n\
             \x20 site.poly:6: 5 0 0.000000001\n"
        ),
        "{text}"
    );
}

/// A square with another, smaller one in it, and a hole seed in the middle of that.
fn frame(segments: &[[u32; 2]]) -> Pslg {
    let inner = [[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75]];
    Pslg { holes: vec![[0.5, 0.5]], ..square_and(&inner, segments) }
}

#[test]
fn a_hole_whose_outline_is_open_eats_everything_and_names_the_open_ends() {
    let text = message(&frame(&[[4, 5], [5, 6], [6, 7]]));
    assert!(
        text.starts_with(
            "the holes leave nothing to mesh: points 5 and 8 are open ends, 0.5 apart\n"
        ) && text.ends_with("\n  site.poly:100: 1 0.5 0.5"),
        "{text}"
    );
}

#[test]
fn a_hole_seed_on_a_point_or_a_segment_is_refused() {
    let closed = [[4, 5], [5, 6], [6, 7], [7, 4]];
    let on_point = Pslg { holes: vec![[0.25, 0.25]], ..frame(&closed) };
    let text = message(&on_point);
    assert!(text.starts_with("hole 1 lies on point 5: "), "{text}");
    assert!(text.contains("\n  site.poly:100: 1 0.25 0.25\n"), "{text}");
    let on_segment = Pslg { holes: vec![[0.25, 0.5]], ..frame(&closed) };
    assert!(message(&on_segment).starts_with("hole 1 lies on segment 8: "));
}

#[test]
fn seeds_that_hit_nothing_are_warnings_with_their_lines() {
    let mut pslg = square_and(&[], &[]);
    pslg.holes = vec![[5.0, 5.0]];
    let region =
        |x: f64| crate::formats::Region { seed: [x, 0.5], tag: 7, attribute: 7.0, max_area: None };
    pslg.regions = vec![region(0.5), region(0.75)];
    assert_eq!(
        warnings(&pslg),
        [
            "1 hole seed outside of the outline ignored\n  site.poly:100: 1 5 5",
            "1 region seed in a region that has a seed already ignored\n  \
             region 2 is region 1 again\n  site.poly:201: 2 0.75 0.5",
        ]
    );
}

#[test]
fn faces_know_their_regions_and_whether_they_are_meshed() {
    let mut pslg = frame(&[[4, 5], [5, 6], [6, 7], [7, 4]]);
    pslg.regions =
        vec![crate::formats::Region { seed: [0.1, 0.1], tag: 3, attribute: 3.0, max_area: None }];
    let (domain, _) = Domain::new(&pslg, Region::Domain).expect("clean");
    let [frame, outside] = domain.faces.sides(0);
    assert_eq!(outside, OUTSIDE);
    assert!(domain.faces.is_meshed(frame) && !domain.faces.is_meshed(outside));
    assert_eq!(domain.faces.region(frame), Some(0));
    // Segment 4 runs counter-clockwise around the hole: the hole lies to its left.
    let [hole, other] = domain.faces.sides(4);
    assert_eq!(other, frame);
    assert!(!domain.faces.is_meshed(hole) && domain.faces.region(hole).is_none());
    assert_eq!(domain.area(), 0.75);
}

/// The area of what is meshed of the frame (its hole seed taken away) with more segments.
fn area(segments: &[[u32; 2]], enclosed: Enclosed) -> f64 {
    let pslg = Pslg { enclosed, holes: Vec::new(), ..frame(segments) };
    Domain::new(&pslg, Region::Domain).expect("clean").0.area()
}

#[test]
fn a_loop_in_a_loop_is_a_hole_where_holes_are_by_nesting() {
    let inner = [[4, 5], [5, 6], [6, 7], [7, 4]];
    assert_eq!(area(&inner, Enclosed::All), 1.0);
    assert_eq!(area(&inner, Enclosed::EvenOdd), 0.75);
    // A bridge between the loops changes nothing.
    assert_eq!(area(&[&inner[..], &[[0, 4]]].concat(), Enclosed::EvenOdd), 0.75);
}

#[test]
fn a_loop_that_touches_the_one_around_it_is_a_hole_of_it() {
    assert_eq!(area(&[[0, 5], [5, 7], [7, 0]], Enclosed::EvenOdd), 0.75);
}

#[test]
fn faces_that_share_borders_are_meshed_together() {
    let inner = [[4, 5], [5, 6], [6, 7], [7, 4]];
    // A ring of four rooms around a fifth: walls on all four diagonals.
    let walls = [[0, 4], [1, 5], [2, 6], [3, 7]];
    assert_eq!(area(&[inner, walls].concat(), Enclosed::EvenOdd), 1.0);
    // A wall across the inner loop makes it a hole of two rooms.
    assert_eq!(area(&[&inner[..], &[[4, 6]]].concat(), Enclosed::EvenOdd), 0.75);
}

#[test]
fn only_faces_with_a_region_seed_are_meshed_where_that_is_asked() {
    let mut pslg = frame(&[[4, 5], [5, 6], [6, 7], [7, 4]]);
    pslg.holes.clear();
    pslg.enclosed = Enclosed::Seeded;
    assert_eq!(message(&pslg), "no region's seed lies in any of the 2 faces: nothing is meshed");
    let region =
        |x: f64| crate::formats::Region { seed: [x, 0.5], tag: 7, attribute: 7.0, max_area: None };
    pslg.regions = vec![region(0.5), region(9.0)];
    assert_eq!(Domain::new(&pslg, Region::Domain).expect("clean").0.area(), 0.25);
    assert_eq!(Domain::new(&pslg, Region::Hull).expect("clean").0.area(), 1.0);
}

#[test]
fn what_is_given_twice_is_merged_and_said() {
    let mut pslg = square_and(&[[-0.0, 1.0]], &[[2, 1], [4, 4], [4, 0]]);
    pslg.segment_tags = vec![1, 2, 3, 4, 5, 6, 4];
    let (domain, _) = Domain::new(&pslg, Region::Domain).expect("clean");
    assert_eq!(domain.points.len(), 4);
    assert_eq!(domain.segment_tags, [1, 2, 3, 4]);
    let said = warnings(&pslg);
    assert!(said[0].starts_with("1 duplicate point merged\n  point 5 is point 4\n"), "{said:?}");
    assert!(said[1].starts_with("1 segment of length zero dropped\n  site.poly:13: 6 5 5"));
    assert!(said[2].starts_with("1 duplicate segment dropped\n  segment 7 is segment 4 again"));
    assert!(said[3].contains("segment 5 (tag 5) is segment 2 (tag 2) again"), "{said:?}");
}

#[test]
fn points_alone_mean_their_convex_hull_split_at_every_point_on_it() {
    let points = [&SQUARE[..], &[[0.5, 0.0], [0.5, 0.5]]].concat();
    let (domain, warnings) = Domain::new(&file(&points, &[]), Region::Domain).expect("clean");
    assert_eq!(warnings, [Warning::NoSegments]);
    assert_eq!(domain.segments.len(), 5);
    assert!(domain.region == Region::Hull && domain.meshed_points.iter().all(|&is_in| is_in));
    assert_eq!(domain.area(), 1.0);
}

#[test]
fn points_on_one_line_enclose_no_area() {
    let error = domain(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]], &[[0, 1], [1, 2]]);
    assert_eq!(error.expect_err("no area"), Error::Collinear { points: 3 });
    let error = domain(&[[0.0, 0.0], [0.0, 0.0]], &[]).expect_err("no area");
    assert_eq!(error, Error::TooFewPoints { points: 1 });
}

#[test]
fn coordinates_far_from_one_are_scaled_without_error() {
    for exponent in [-997, -500, 500, 1000] {
        let corner = |[x, y]: [f64; 2]| [libm::scalbn(x, exponent), libm::scalbn(y, exponent)];
        let domain = domain(&SQUARE.map(corner), &LOOP).expect("clean");
        assert_eq!(domain.scale_exponent, exponent);
        assert_eq!(domain.points, SQUARE);
    }
    let mut points = SQUARE;
    points[0] = [1e-300, 0.0];
    points[2] = [1e300, 1e300];
    let error = domain(&points, &LOOP).expect_err("too small");
    assert!(matches!(error, Error::TooSmall { coordinate: 1e-300, .. }), "{error}");
    points[0] = [f64::NAN, 0.0];
    assert!(matches!(domain(&points, &LOOP), Err(Error::NotFinite { .. })));
}

/// A unit square with a wedge of `theta` in it, everything moved by `offset`.
fn wedge(theta: f64, offset: f64) -> Domain {
    let tip = [offset, offset];
    let square = SQUARE.map(|p| p.map(|c| 4.0 * c - 2.0 + offset));
    let second = [offset + 0.83 * libm::cos(theta), offset + 0.83 * libm::sin(theta)];
    let points = [&square[..], &[tip, [offset + 1.0, offset], second]].concat();
    domain(&points, &[&LOOP[..], &[[4, 5], [4, 6]]].concat()).expect("clean")
}

#[test]
fn tiny_angles_are_measured_to_the_last_digits() {
    for (theta, offset) in [(1e-9, 0.0), (1e-3, 0.0), (1e-9, 1024.0), (1e-3, 1024.0)] {
        let domain = wedge(theta, offset);
        let smallest = domain.smallest_angle().expect("segments adjoin");
        // At an offset the second end is rounded; what counts is the angle of the doubles.
        let [x, y] = domain.points[6].map(|c| c - offset);
        let exact = libm::atan2(y, x);
        assert!((smallest.radians - exact).abs() <= 1e-15 * exact, "{smallest:?}, not {exact}");
        assert_eq!((smallest.apex, smallest.segments), (4, [4, 5]));
        assert!(smallest.is_meshed);
    }
}

#[test]
fn an_angle_too_small_for_doubles_is_said_before_meshing() {
    assert!(wedge(1e-3, 0.0).precision_limits().is_empty());
    let limits = wedge(1e-9, 0.0).precision_limits();
    assert_eq!(limits.len(), 1);
    assert_eq!(limits[0].angle.apex, 4);
    // M = 2, so ulp(M) = 2^-51, and θ²·d ≥ 4·ulp(M) only far beyond the legs.
    assert!((limits[0].reach - 4.0 * libm::scalbn(1.0, -51) * 1e18).abs() < 1e-6 * limits[0].reach);
}

#[test]
fn the_closest_pair_is_that_of_a_look_at_all_pairs() {
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig::with_cases(500));
    let outcome = runner.run(&soups(), |(points, segments)| {
        let places: Vec<[f64; 2]> = points.iter().map(|p| p.map(|c| c as f64)).collect();
        let Ok((domain, _)) = Domain::new(&outline(&places, &segments), Region::Hull) else {
            return Ok(());
        };
        let found = domain.closest_pair().expect("three points").distance;
        let mut least = f64::INFINITY;
        for (index, &p) in (0..).zip(&domain.points) {
            let distance = |q: [f64; 2]| libm::hypot(p[0] - q[0], p[1] - q[1]);
            for (other, &q) in (0..).zip(&domain.points) {
                if index != other {
                    least = least.min(distance(q));
                }
            }
            for &ends in &domain.segments {
                let [a, b] = ends.map(|end| domain.points[end as usize]);
                let along = [b[0] - a[0], b[1] - a[1]];
                let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
                let part = dot([p[0] - a[0], p[1] - a[1]], along) / dot(along, along);
                if !ends.contains(&index) && (0.0..=1.0).contains(&part) {
                    least = least.min(distance([a[0] + part * along[0], a[1] + part * along[1]]));
                }
            }
        }
        prop_assert!((found - least).abs() <= 1e-12 * least.max(1.0), "{found}, not {least}");
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_star_of_100_000_spokes_is_no_matter_of_all_pairs() {
    let count = 100_000;
    let spoke = |i: u32| {
        let angle = std::f64::consts::TAU * (f64::from(i) + 0.5) / f64::from(count);
        [libm::cos(angle), libm::sin(angle)]
    };
    let square = SQUARE.map(|p| p.map(|c| 4.0 * c - 2.0));
    let points: Vec<[f64; 2]> =
        square.into_iter().chain([[0.0, 0.0]]).chain((0..count).map(spoke)).collect();
    let spokes = (0..count).map(|i| [4, 5 + i]);
    let segments: Vec<[u32; 2]> = LOOP.into_iter().chain(spokes).collect();
    let domain = domain(&points, &segments).expect("clean");
    assert_eq!((domain.faces.count(), domain.area()), (2, 16.0));
    assert_eq!(domain.adjoining(4).len(), count as usize);
    // A tip and the spoke beside it: sin(2π / 100 000) apart.
    let closest = domain.closest_pair().expect("no search is given up");
    assert!((closest.distance / (std::f64::consts::TAU / 1e5) - 1.0).abs() < 1e-9, "{closest:?}");
}

#[test]
fn the_closest_pair_of_a_star_with_spokes_of_many_lengths_is_found() {
    let count = 20_000;
    let length = |i: u32| 0.25 + 0.5 * f64::from(i.wrapping_mul(2_654_435_761) >> 8) / 16_777_216.0;
    let spoke = |i: u32| {
        let angle = std::f64::consts::TAU * (f64::from(i) + 0.5) / f64::from(count);
        [length(i) * libm::cos(angle), length(i) * libm::sin(angle)]
    };
    let square = SQUARE.map(|p| p.map(|c| 4.0 * c - 2.0));
    let points: Vec<[f64; 2]> =
        square.into_iter().chain([[0.0, 0.0]]).chain((0..count).map(spoke)).collect();
    let spokes = (0..count).map(|i| [4, 5 + i]);
    let segments: Vec<[u32; 2]> = LOOP.into_iter().chain(spokes).collect();
    let domain = domain(&points, &segments).expect("clean");
    // The shortest tip beside a longer spoke: L·sin(2π / 20 000), or two tips.
    let step = std::f64::consts::TAU / f64::from(count);
    let gap = |i: u32, j: u32| {
        let (short, long) = (length(i).min(length(j)), length(i).max(length(j)));
        if short <= long * libm::cos(step) {
            short * libm::sin(step)
        } else {
            libm::hypot(long - short * libm::cos(step), short * libm::sin(step))
                .min(long * libm::sin(step))
                .min(short * libm::sin(step))
        }
    };
    let least = (0..count).map(|i| gap(i, (i + 1) % count)).fold(f64::INFINITY, f64::min);
    let found = domain.closest_pair().expect("no search is given up").distance;
    assert!((found / least - 1.0).abs() < 1e-9, "{found}, not {least}");
    // Asked beside the hub, each question passes the spokes by.
    for i in 0..2000 {
        let place = [1e-6 * f64::from(i), 1e-6 * f64::from(i % 7)];
        assert!(!domain.has_two_features_within(place, 0.2));
        assert!(domain.lfs(place) > 0.2);
    }
}

/// Definition 1 by a look at all pairs of features.
fn lfs_of_all_pairs(domain: &Domain, place: [f64; 2]) -> f64 {
    let points = (0..domain.points.len() as u32).map(|p| [p, p]);
    let features: Vec<[u32; 2]> = points.chain(domain.segments.iter().copied()).collect();
    let distance = |ends: [u32; 2]| {
        let [a, b] = ends.map(|end| domain.points[end as usize]);
        let along = [b[0] - a[0], b[1] - a[1]];
        let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
        let length = dot(along, along).max(f64::MIN_POSITIVE);
        let part = dot([place[0] - a[0], place[1] - a[1]], along) / length;
        let part = part.clamp(0.0, 1.0);
        libm::hypot(place[0] - a[0] - part * along[0], place[1] - a[1] - part * along[1])
    };
    let mut least = f64::INFINITY;
    for (i, &f) in features.iter().enumerate() {
        for &g in &features[..i] {
            if f.iter().all(|end| !g.contains(end)) {
                least = least.min(distance(f).max(distance(g)));
            }
        }
    }
    least
}

/// Some of [`soups`], clean or not, and places about it.
#[derive(Debug)]
struct Asked {
    outline: Pslg,
    places: Vec<[f64; 2]>,
}

fn asked() -> impl Strategy<Value = Asked> {
    let places = prop::collection::vec([-10.0..50.0, -10.0..50.0_f64], 8);
    (soups(), places).prop_map(|((points, segments), places)| {
        let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(|c| c as f64)).collect();
        Asked { outline: outline(&points, &segments), places }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn definition_1_is_that_of_a_look_at_all_pairs(Asked { outline, places } in asked()) {
        let Ok((domain, _)) = Domain::new(&outline, Region::Hull) else {
            return Ok(());
        };
        let lfs_min = domain.lfs_min().expect("a small outline");
        for place in places.into_iter().chain(domain.points.iter().copied().take(4)) {
            let (lfs, wanted) = (domain.lfs(place), lfs_of_all_pairs(&domain, place));
            prop_assert!((lfs - wanted).abs() <= 1e-12 * wanted.max(1.0), "{lfs}, not {wanted}");
            prop_assert!(lfs >= lfs_min * (1.0 - 1e-12));
            for factor in [0.5, 1.0 - 1e-9, 1.0 + 1e-9, 2.0] {
                let within = domain.has_two_features_within(place, factor * lfs);
                prop_assert_eq!(within, factor > 1.0, "{} of {}", factor, lfs);
            }
        }
    }

    #[test]
    fn the_local_feature_size_is_lipschitz(Asked { outline, places } in asked()) {
        let Ok((domain, _)) = Domain::new(&outline, Region::Domain) else {
            return Ok(());
        };
        for pair in places.windows(2) {
            let apart = libm::hypot(pair[0][0] - pair[1][0], pair[0][1] - pair[1][1]);
            prop_assert!(domain.lfs(pair[0]) <= apart + domain.lfs(pair[1]) * (1.0 + 1e-12));
        }
    }

    #[test]
    fn doubling_the_outline_doubles_the_feature_size(Asked { outline, places } in asked(), power in -300..300_i32) {
        let Ok((domain, _)) = Domain::new(&outline, Region::Hull) else {
            return Ok(());
        };
        let times = |p: [f64; 2]| p.map(|c| libm::scalbn(c, power));
        let points = outline.points.iter().copied().map(times).collect();
        let larger = Pslg { points, ..outline };
        let (larger, _) = Domain::new(&larger, Region::Hull).expect("as clean");
        let power = power - larger.scale_exponent;
        let times = |c: f64| libm::scalbn(c, power);
        prop_assert_eq!(larger.lfs_min(), domain.lfs_min().map(times));
        for place in places {
            prop_assert_eq!(larger.lfs(place.map(times)), times(domain.lfs(place)));
        }
    }
}

#[test]
fn the_hull_runs_through_points_at_rounding_distance() {
    // A turned square with points along its sides: inside by some 1e-17, or outside, or on them.
    let (sine, cosine) = (0.29552020666133955, 0.955336489125606);
    let mut points = Vec::new();
    for (x, y) in [(0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (3, 2), (3, 3), (2, 3), (0, 3), (0, 1)] {
        let (x, y) = (f64::from(x), f64::from(y));
        points.push([cosine * x - sine * y, sine * x + cosine * y]);
    }
    let (domain, _) = Domain::new(&outline(&points, &[]), Region::Hull).expect("it is clean");
    assert_eq!(domain.segments.len(), 10);
    assert!((0..10).all(|point| domain.adjoining(point).len() == 2));
}

#[test]
fn points_on_a_line_but_for_rounding_enclose_nothing() {
    let points = [[0.1, 0.3], [0.2, 0.6], [0.3, 0.9], [0.7, 2.1]];
    let error = Domain::new(&outline(&points, &[]), Region::Hull).expect_err("it is a line");
    assert!(matches!(error, Error::Collinear { points: 4 }), "{error}");
}
