use proptest::prelude::*;

use super::super::tests::{LOOP, SQUARE, file, square_and};
use super::*;
use crate::Region;
use crate::domain::Domain;
use crate::triangulation::initial::triangulate;

/// The outline mended; what was mended, in words.
fn mended(given: &Pslg, tolerance: f64) -> (Pslg, Vec<String>) {
    let repaired = repair(given, tolerance).expect("it can be mended");
    let report = repaired.report(given);
    let said = repaired.repairs.iter().map(|repair| report.sentence(repair)).collect();
    (repaired.outline, said)
}

#[test]
fn two_diagonals_are_split_where_they_cross() {
    let given = square_and(&[], &[[0, 2], [1, 3]]);
    let (outline, said) = mended(&given, 0.0);
    assert_eq!(said, ["segments 5 and 6 cross near (0.5, 0.5): split at point 5"]);
    assert_eq!(outline.points, [&SQUARE[..], &[[0.5, 0.5]]].concat());
    assert_eq!(outline.segments[4..], [[0, 4], [4, 2], [1, 4], [4, 3]]);
    assert_eq!(outline.source.segment_numbers, [1, 2, 3, 4, 5, 5, 6, 6]);
    assert_eq!(outline.source.segment_lines[4..], [11, 11, 12, 12]);
    assert_eq!(outline.source.point_numbers, [1, 2, 3, 4, 5]);
}

#[test]
fn a_segment_that_ends_on_another_one_splits_it_and_so_does_a_free_point() {
    let given = square_and(&[[0.5, 0.0], [0.5, 0.5], [1.0, 0.25]], &[[4, 5]]);
    let (outline, said) = mended(&given, 0.0);
    assert_eq!(
        said,
        [
            "point 5, where a segment ends, lies on segment 1: split there",
            "point 7 lies on segment 2: split there"
        ]
    );
    assert_eq!(outline.points, given.points);
    assert_eq!(outline.segments[..4], [[0, 4], [4, 1], [1, 6], [6, 2]]);
}

#[test]
fn overlapping_segments_share_their_stretch_once_and_the_first_tag_stays() {
    let mut given = square_and(&[[0.5, 0.0], [2.0, 0.0]], &[[4, 5]]);
    given.segment_tags = vec![1, 2, 3, 4, 5];
    let repaired = repair(&given, 0.0).expect("it can be mended");
    assert_eq!(
        repaired.report(&given).to_string(),
        "1 overlap\n\
         segments 1 and 5 overlap: what they share stays with segment 1\n\
         \x20 site.poly:9: 1 1 2\n\
         \x20 site.poly:13: 5 5 6"
    );
    let outline = &repaired.outline;
    assert_eq!(outline.segments, [[0, 4], [4, 1], [1, 2], [2, 3], [3, 0], [1, 5]]);
    assert_eq!(outline.segment_tags, [1, 1, 2, 3, 4, 5]);
    let warnings: Vec<String> = repaired.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        ["1 overlap of segments with different tags: the first tag stays there\n\
          \x20 segment 5 (tag 5) runs along segment 1 (tag 1)\n\
          \x20 site.poly:13: 5 5 6"]
    );
}

#[test]
fn open_ends_within_the_tolerance_are_joined_and_without_it_are_not() {
    let points = [&SQUARE[..], &[[0.0, 1e-9]]].concat();
    let given = file(&points, &[[0, 1], [1, 2], [2, 3], [3, 4]]);
    assert_eq!(mended(&given, 0.0), (given.clone(), vec![]));
    let (outline, said) = mended(&given, 1e-8);
    assert_eq!(said, ["points 1 and 5 are open ends, 1e-9 apart: joined at point 1"]);
    assert_eq!((outline.points, outline.segments), (SQUARE.to_vec(), LOOP.to_vec()));
}

#[test]
fn an_end_that_falls_short_of_a_segment_or_runs_past_it_is_joined_to_it() {
    for off in [-1e-9, 1e-9] {
        let given = square_and(&[[0.5, off], [0.5, 0.5]], &[[4, 5]]);
        let (outline, said) = mended(&given, 1e-8);
        assert_eq!(said, ["point 5 is 1e-9 off segment 1: the segment is led through it"]);
        assert_eq!(outline.points, given.points);
        assert_eq!(outline.segments[..2], [[0, 4], [4, 1]]);
    }
}

#[test]
fn a_fine_line_of_points_does_not_collapse() {
    let points: Vec<[f64; 2]> = (0..100).map(|i| [f64::from(i) * 0.75, 0.0]).collect();
    let segments: Vec<[u32; 2]> = (1..100).map(|i| [i - 1, i]).collect();
    let (outline, _) = mended(&file(&points, &segments), 1.0);
    assert_eq!((outline.points.len(), outline.segments.len()), (50, 49));
}

#[test]
fn lines_through_one_place_meet_in_one_point() {
    // Twenty diameters about a center that is no sum of their ends in doubles.
    let spoke = |i: i32| {
        let turn = f64::from(i) * std::f64::consts::PI / 20.0 + 0.1;
        [0.3 + libm::cos(turn) / 3.0, 0.7 + libm::sin(turn) / 3.0]
    };
    let points: Vec<[f64; 2]> = (0..40).map(spoke).collect();
    let segments: Vec<[u32; 2]> = (0..20).map(|i| [i, i + 20]).collect();
    let (outline, said) = mended(&file(&points, &segments), 0.0);
    assert_eq!((outline.points.len(), outline.segments.len()), (41, 40));
    assert_eq!(said.len(), 190);
}

#[test]
fn a_new_point_carries_what_its_segment_carries() {
    let mut given = square_and(&[], &[[0, 2], [1, 3]]);
    given.segment_tags = vec![1, 2, 3, 4, 5, 6];
    given.point_markers = vec![7; 4];
    given.point_sizes = vec![1.0, f64::INFINITY, 3.0, 4.0];
    given.point_attributes =
        vec![crate::formats::Attribute { name: "depth".into(), values: vec![0.0, 5.0, 8.0, 5.0] }];
    let (outline, _) = mended(&given, 0.0);
    assert_eq!(outline.point_markers, [7, 7, 7, 7, 5]);
    assert_eq!(outline.point_sizes[4], 2.0);
    assert_eq!(outline.point_attributes[0].values[4], 4.0);
}

#[test]
fn new_points_are_made_at_any_scale() {
    for exponent in [-900, 900] {
        let scaled = |[x, y]: [f64; 2]| [libm::scalbn(x, exponent), libm::scalbn(y, exponent)];
        let given = file(&SQUARE.map(scaled), &[&LOOP[..], &[[0, 2], [1, 3]]].concat());
        let (outline, _) = mended(&given, 0.0);
        assert_eq!(outline.points[4], scaled([0.5, 0.5]));
    }
}

/// Segments between points of a small grid, or anywhere, or along one line but for rounding.
fn soups() -> impl Strategy<Value = Pslg> {
    let whole = (3_usize..14, 2_u32..30).prop_flat_map(|(count, size)| {
        let point = [0..size, 0..size].prop_map(|p| p.map(f64::from));
        prop::collection::vec(point, count)
    });
    let anywhere = prop::collection::vec([-1.0..1.0, -1e-3..1.0], 3..20);
    let nearly_on_a_line = prop::collection::vec((0.0..1.0, -3_i32..4), 4..20).prop_map(|at| {
        let beside = |(x, steps): &(f64, i32)| [*x, x / 3.0 + f64::from(*steps) * 5e-17];
        at.iter().map(beside).collect()
    });
    let about_a_point = prop::collection::vec([-8_i32..8, -8..8], 4..16).prop_map(|at| {
        at.iter().map(|p| p.map(|c| 0.1 + f64::from(c) * f64::EPSILON / 8.0)).collect()
    });
    let points = prop_oneof![whole, anywhere, nearly_on_a_line, about_a_point];
    points.prop_flat_map(|points: Vec<[f64; 2]>| {
        let end = 0..points.len() as u32;
        let segments = prop::collection::vec([end.clone(), end], 1..16);
        (Just(points), segments).prop_map(|(points, segments)| file(&points, &segments))
    })
}

/// Whether an outline is clean, whatever else may keep it from being meshed.
fn is_clean(outline: &Pslg) -> Result<(), String> {
    match Domain::new(outline, Region::Domain) {
        Err(error @ Error::Conflicts(_)) => Err(error.to_string()),
        _ => Ok(()),
    }
}

/// The distance from a place to a segment.
fn distance(place: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let along = (place[0] - a[0]) * dx + (place[1] - a[1]) * dy;
    let part = (along / (dx * dx + dy * dy).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    libm::hypot(a[0] + part * dx - place[0], a[1] + part * dy - place[1])
}

fn places(outline: &Pslg) -> Vec<[[f64; 2]; 2]> {
    let ends = |s: &[u32; 2]| s.map(|end| outline.points[end as usize]);
    outline.segments.iter().map(ends).filter(|[a, b]| a != b).collect()
}

/// The farthest that a place on a segment of `from`, its ends and some between, is off `onto`.
fn farthest(from: &Pslg, onto: &Pslg) -> f64 {
    let onto = places(onto);
    let between = |[a, b]: [[f64; 2]; 2]| {
        (0..=8).map(move |i| [0, 1].map(|k| a[k] + f64::from(i) / 8.0 * (b[k] - a[k])))
    };
    let off = |place| onto.iter().map(|&s| distance(place, s)).fold(f64::INFINITY, f64::min);
    places(from).into_iter().flat_map(between).map(off).fold(0.0, f64::max)
}

fn largest(outline: &Pslg) -> f64 {
    outline.points.iter().flatten().fold(0.0, |m: f64, c| m.max(c.abs()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn a_mended_soup_is_clean_and_near_and_mending_it_changes_nothing(given in soups()) {
        let repaired = repair(&given, 0.0).expect("it can be mended");
        let outline = &repaired.outline;
        prop_assert_eq!(is_clean(outline), Ok(()));
        let again = repair(outline, 0.0).expect("it can be mended");
        prop_assert_eq!(&again.outline, outline);
        prop_assert_eq!(again.repairs, vec![]);

        // Points that are not merged are there bit for bit, in their order.
        let mut distinct: Vec<[f64; 2]> = Vec::new();
        for point in &given.points {
            if !distinct.contains(point) {
                distinct.push(*point);
            }
        }
        prop_assert_eq!(&outline.points[..distinct.len()], &distinct[..]);

        let near = 16.0 * f64::EPSILON * largest(&given);
        prop_assert!(farthest(&given, outline) <= near, "{:e}", farthest(&given, outline));
        prop_assert!(farthest(outline, &given) <= near, "{:e}", farthest(outline, &given));
    }

    #[test]
    fn a_soup_mended_within_a_tolerance_is_clean_and_keeps_its_distance(
        given in soups(), part in 1e-4..0.2
    ) {
        let tolerance = part * largest(&given);
        let Ok(repaired) = repair(&given, tolerance) else { return Ok(()) };
        let outline = &repaired.outline;
        prop_assert_eq!(is_clean(outline), Ok(()));
        for (i, p) in outline.points.iter().enumerate() {
            let is_apart =
                |q: &[f64; 2]| libm::hypot(p[0] - q[0], p[1] - q[1]) > tolerance * (1.0 - 1e-12);
            prop_assert!(outline.points[..i].iter().all(is_apart), "point {i}");
        }
        let again = repair(outline, tolerance).expect("it can be mended");
        prop_assert_eq!(&again.outline, outline);
    }

    #[test]
    fn a_loop_that_crosses_itself_keeps_the_area_that_it_winds_around(
        corners in prop::collection::vec([-50_i32..50, -50..50], 3..12)
    ) {
        let points: Vec<[f64; 2]> = corners.iter().map(|p| p.map(f64::from)).collect();
        let count = points.len() as u32;
        let segments: Vec<[u32; 2]> = (0..count).map(|i| [i, (i + 1) % count]).collect();
        let given = file(&points, &segments);
        let outline = repair(&given, 0.0).expect("it can be mended").outline;
        let Ok((domain, _)) = Domain::new(&outline, Region::Domain) else { return Ok(()) };
        let (_, initial) = triangulate(domain).expect("it can be triangulated");
        let cross = |[a, b]: [[f64; 2]; 2]| a[0] * b[1] - a[1] * b[0];
        let wound: f64 = initial.triangles.iter().map(|triangle| {
            let [a, b, c] = triangle.vertices.map(|v| initial.points[v as usize]);
            let area = 0.5 * (cross([a, b]) + cross([b, c]) + cross([c, a]));
            let center = [0, 1].map(|k| (a[k] + b[k] + c[k]) / 3.0);
            area * f64::from(winding_number(center, &places(&given)))
        }).sum();
        let expected: f64 = 0.5 * places(&given).into_iter().map(cross).sum::<f64>();
        prop_assert!((wound - expected).abs() < 1e-9, "{wound}, not {expected}");
    }
}

/// How often segments wind around a place, counter-clockwise.
fn winding_number([x, y]: [f64; 2], segments: &[[[f64; 2]; 2]]) -> i32 {
    let crosses = |&[a, b]: &[[f64; 2]; 2]| {
        let is_left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) > 0.0;
        match (a[1] <= y, b[1] <= y) {
            (true, false) if is_left => 1,
            (false, true) if !is_left => -1,
            _ => 0,
        }
    };
    segments.iter().map(crosses).sum()
}
