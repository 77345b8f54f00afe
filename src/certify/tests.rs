//! One literal for each guarantee; thousands of random faults are in `tests/planted/`.

use proptest::prelude::*;

use super::*;
use crate::formats::{Enclosed, Group, Region as RegionSeed};
use crate::parameters::{MinAngle, Region};

/// The outline of a polygon.
fn polygon(points: &[[f64; 2]]) -> Pslg {
    let n = points.len() as u32;
    Pslg {
        points: points.to_vec(),
        segments: (0..n).map(|i| [i, (i + 1) % n]).collect(),
        segment_tags: vec![0; points.len()],
        ..Pslg::default()
    }
}

fn square() -> Pslg {
    polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
}

/// A mesh of an outline whose segments are all whole, with these further points.
fn mesh_of(pslg: &Pslg, further: &[[f64; 2]], triangles: &[[u32; 3]]) -> Mesh {
    Mesh {
        points: [&pslg.points[..], further].concat(),
        triangles: triangles.to_vec(),
        triangle_tags: vec![0; triangles.len()],
        edges: pslg.segments.clone(),
        edge_tags: pslg.segment_tags.clone(),
        ..Mesh::default()
    }
}

fn judged(pslg: &Pslg, mesh: &Mesh) -> Certificate {
    certify(pslg, mesh, &Promise::default())
}

/// Expects exactly the named guarantees to fail.
fn fails(certificate: &Certificate, expected: &[Guarantee]) {
    let failing: Vec<_> =
        Guarantee::ALL.into_iter().filter(|g| certificate.verdict(*g) == Verdict::Fails).collect();
    assert_eq!(failing, expected, "\n{certificate}");
}

fn first(certificate: &Certificate, guarantee: Guarantee) -> &Fault {
    &certificate.judgement(guarantee).first[0]
}

#[test]
fn two_triangles_are_a_mesh_of_a_square() {
    let pslg = square();
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3]]));
    fails(&certificate, &[]);
    assert_eq!(certificate.area, 1.0);
    assert_eq!(certificate.smallest_angle.unwrap().to_degrees(), 45.0);
    assert_eq!(certificate.largest_angle.unwrap().to_degrees(), 90.0);
    assert!(certificate.excused.is_empty() && certificate.apexes.is_empty());
}

#[test]
fn a_mesh_that_stops_short_of_a_corner_is_no_cover() {
    let pslg = square();
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2]]));
    assert!(matches!(first(&certificate, Guarantee::Complex).kind, FaultKind::UnusedPoint));
    assert_eq!(certificate.verdict(Guarantee::Complex), Verdict::Fails);
}

#[test]
fn a_point_inside_a_neighbours_circle_is_named() {
    // The long diagonal of a kite is not Delaunay.
    let pslg = polygon(&[[0.0, 0.0], [2.0, -1.0], [4.0, 0.0], [2.0, 1.0]]);
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3]]));
    assert_eq!(certificate.verdict(Guarantee::Delaunay), Verdict::Fails);
    let fault = first(&certificate, Guarantee::Delaunay);
    assert_eq!((fault.edge, fault.triangle, fault.point), (Some([0, 2]), Some(1), Some(1)));
    assert_eq!(fault.place, [2.0, 0.0]);
    assert!(certificate.to_string().contains(
        "Delaunay      FAILS    edge 1–3, point 2 is inside the circle of triangle 2 near (2, 0)"
    ));
}

#[test]
fn an_apex_in_a_diametral_disc_is_named() {
    let pslg = polygon(&[[0.0, 0.0], [4.0, 0.0], [2.0, 1.5]]);
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2]]));
    fails(&certificate, &[Guarantee::Unencroached, Guarantee::Matrix]);
    let fault = first(&certificate, Guarantee::Unencroached);
    assert_eq!(
        (fault.edge, fault.point, fault.segment.unwrap().number),
        (Some([0, 1]), Some(2), 0)
    );
    // On the circle is not inside.
    let pslg = polygon(&[[0.0, 0.0], [4.0, 0.0], [2.0, 2.0]]);
    fails(&judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2]])), &[]);
}

#[test]
fn where_the_whole_hull_stays_delaunay_a_hidden_vertex_in_a_diametral_disc_is_named() {
    // Two triangles with a gap between: the lower corner of the one is in the disc of the other's top.
    let below = polygon(&[[0.0, 0.0], [1.0, -1.5], [2.0, 0.0]]);
    let above = polygon(&[[1.0, 0.5], [2.0, 2.2], [0.0, 2.2]]);
    let pslg = Pslg {
        points: [below.points, above.points].concat(),
        segments: [below.segments, vec![[3, 4], [4, 5], [5, 3]]].concat(),
        segment_tags: vec![0; 6],
        ..Pslg::default()
    };
    let mesh = mesh_of(&pslg, &[], &[[0, 1, 2], [3, 4, 5]]);
    fails(&judged(&pslg, &mesh), &[]);
    let promise = Promise { region: Region::Global, ..Promise::default() };
    let certificate = certify(&pslg, &mesh, &promise);
    fails(&certificate, &[Guarantee::Unencroached, Guarantee::Matrix]);
    let fault = first(&certificate, Guarantee::Unencroached);
    assert_eq!(
        (fault.edge.map(|[a, b]| [a.min(b), a.max(b)]), fault.point),
        (Some([0, 2]), Some(3))
    );
}

#[test]
fn a_segment_is_broken_where_no_edge_follows_it() {
    let mut pslg = square();
    pslg.segments.push([1, 3]);
    pslg.segment_tags.push(5);
    let mut mesh = mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3]]);
    mesh.edges.pop();
    mesh.edge_tags.pop();
    let certificate = judged(&pslg, &mesh);
    fails(&certificate, &[Guarantee::Conforming]);
    let fault = first(&certificate, Guarantee::Conforming);
    assert_eq!(fault.kind, FaultKind::Broken { until: Some(3) });
    assert_eq!((fault.point, fault.segment.unwrap().index), (Some(1), 4));
    // Listed, but crossed by the triangles.
    let mesh = mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3]]);
    let certificate = judged(&pslg, &mesh);
    fails(&certificate, &[Guarantee::Conforming]);
    assert_eq!(first(&certificate, Guarantee::Conforming).kind, FaultKind::NotAnEdge);
}

#[test]
fn a_small_angle_of_a_whole_segment_is_not_excused() {
    let pslg = polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 1.0]]);
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2]]));
    fails(&certificate, &[Guarantee::SmallAngles]);
    let fault = first(&certificate, Guarantee::SmallAngles);
    assert_eq!(
        (fault.triangle, fault.point, &fault.kind),
        (Some(0), Some(0), &FaultKind::UnexcusedAngle)
    );
    assert!((fault.angle.unwrap() - 0.25_f64.atan()).abs() < 1e-15);
}

/// A wedge at the origin with legs (8, 0) and (8, 2) that are cut at `p` and `q`.
fn cut_wedge(p: f64, q: f64) -> Certificate {
    let pslg = polygon(&[[0.0, 0.0], [8.0, 0.0], [8.0, 2.0]]);
    let mut mesh = mesh_of(&pslg, &[[p, 0.0], [q, q / 4.0]], &[[0, 3, 4], [3, 1, 4], [1, 2, 4]]);
    mesh.edges = vec![[0, 3], [3, 1], [1, 2], [2, 4], [4, 0]];
    mesh.edge_tags = vec![0; 5];
    judged(&pslg, &mesh)
}

#[test]
fn lemma_7_excuses_an_angle_across_two_segments_and_no_smaller_one() {
    let theta = 0.25_f64.atan();
    let certificate = cut_wedge(6.0, 6.0);
    let excused = &certificate.excused[0];
    assert_eq!((excused.triangle, excused.edge), (0, [3, 4]));
    assert_eq!(excused.segments.map(|segment| segment.index), [0, 2]);
    assert!((excused.theta - theta).abs() < 1e-15 && (excused.angle - theta).abs() < 1e-15);
    // Seen from the far end of a leg the same edge is far too small.
    let certificate = cut_wedge(2.0, 2.0);
    assert_eq!(certificate.verdict(Guarantee::SmallestAngle), Verdict::Fails);
    let judgement = certificate.judgement(Guarantee::SmallAngles);
    let below = judgement
        .first
        .iter()
        .find(|fault| fault.triangle == Some(1) && fault.point == Some(1))
        .unwrap();
    let FaultKind::BelowLemma7 { bound } = below.kind else { panic!("{certificate}") };
    assert!((bound - libm::atan2(libm::sin(theta), 2.0 - libm::cos(theta))).abs() < 1e-15);
    assert!((below.angle.unwrap() - (1.0_f64 / 12.0).atan()).abs() < 1e-15);
}

#[test]
fn corollary_3_bounds_the_largest_angle() {
    let (kappa_hat, pi) = (MinAngle::default().radians(), std::f64::consts::PI);
    let bound = (pi - 2.0 * kappa_hat).max(pi - 2.0 * ((3.0_f64.sqrt() - 1.0) / 2.0).asin());
    assert_eq!((bound.to_degrees() * 1e3).round(), 137_059.0);
    for (degrees, holds) in [(137.05_f64, true), (137.07, false)] {
        let (sin, cos) = (degrees.to_radians() / 2.0).sin_cos();
        let pslg = polygon(&[[0.0, 0.0], [sin, -cos], [-0.0, -2.0 * cos], [-sin, -cos]]);
        let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 3, 1], [3, 2, 1]]));
        let verdict = if holds { Verdict::Holds } else { Verdict::Fails };
        assert_eq!(certificate.verdict(Guarantee::LargestAngle), verdict, "{certificate}");
    }
}

#[test]
fn points_and_segments_outside_of_the_region_are_left_out() {
    let mut pslg = square();
    pslg.points.extend([[3.0, 3.0], [0.25, 0.25], [0.75, 0.25], [0.5, 0.5], [-1.0, 0.0]]);
    pslg.segments.extend([[5, 6], [6, 7], [7, 5], [0, 8]]);
    pslg.segment_tags.extend([0; 4]);
    pslg.holes.push([0.5, 0.4]);
    let outline = Outline::new(&pslg, Region::Domain, Frame::new(&pslg.points));
    let inside: Vec<_> = outline.distinct_points().filter(|&v| outline.has_point(v)).collect();
    assert_eq!(inside, [0, 1, 2, 3, 5, 6, 7]);
    assert_eq!((0..8).filter(|&s| outline.is_meshed(s)).count(), 7);
    assert_eq!(outline.euler_characteristic(), 0);
    assert_eq!(outline.area_and_perimeter().0, 1.0 - 0.0625);
}

#[test]
fn what_is_meshed_is_chosen_by_the_outline() {
    // A square, within it a frame of two squares that touch in a point; a wall beside them.
    let mut pslg = square();
    pslg.points.extend([[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.5, 0.375], [0.625, 0.5]]);
    pslg.segments.extend([[4, 5], [5, 6], [6, 4], [4, 7], [7, 8], [8, 4], [0, 4]]);
    pslg.segment_tags.extend([0; 7]);
    let region = |x, y| RegionSeed { seed: [x, y], tag: 1, attribute: 1.0, max_area: None };
    pslg.regions = vec![region(0.7, 0.5), region(5.0, 5.0)];
    let area = |enclosed: Enclosed| {
        let pslg = Pslg { enclosed, ..pslg.clone() };
        Outline::new(&pslg, Region::Domain, Frame::new(&pslg.points)).area_and_perimeter().0
    };
    let (outer, inner) = (0.125, 0.0078125);
    assert_eq!(area(Enclosed::All), 1.0);
    assert_eq!(area(Enclosed::EvenOdd), 1.0 - outer + inner);
    assert_eq!(area(Enclosed::Seeded), outer - inner);
    // With a wall across it, the inner piece is one hole.
    pslg.segments.push([5, 7]);
    pslg.segment_tags.push(0);
    let walled = Pslg { enclosed: Enclosed::EvenOdd, ..pslg };
    let outline = Outline::new(&walled, Region::Domain, Frame::new(&walled.points));
    assert_eq!(outline.area_and_perimeter().0, 1.0 - outer);
}

#[test]
fn the_hull_is_meshed_whole_where_that_is_asked() {
    let mut pslg = square();
    pslg.points.push([2.0, 0.5]);
    let promise = Promise { region: Region::Hull, ..Promise::default() };
    let mut mesh = mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3], [1, 4, 2]]);
    mesh.edges.extend([[1, 4], [4, 2]]);
    mesh.edge_tags.extend([0, 0]);
    let certificate = certify(&pslg, &mesh, &promise);
    fails(&certificate, &[]);
    assert_eq!(certificate.verdict(Guarantee::Complex), Verdict::Holds);
    fails(&judged(&pslg, &mesh), &[Guarantee::Complex, Guarantee::Conforming]);
}

#[test]
fn a_point_of_an_outline_without_segments_is_on_the_hull_or_inside() {
    let pslg = Pslg {
        points: vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]],
        ..Pslg::default()
    };
    let mut mesh = mesh_of(&pslg, &[], &[[0, 1, 5], [1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 0, 5]]);
    mesh.edges = vec![[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]];
    mesh.edge_tags = vec![0; 5];
    mesh.edge_segments = vec![u32::MAX; 5];
    fails(&judged(&pslg, &mesh), &[]);
}

#[test]
fn tags_are_compared_by_name_where_there_is_one() {
    let mut pslg = square();
    pslg.segment_tags = vec![3, 3, 3, -1];
    pslg.groups = vec![Group { dim: 1, tag: 3, name: "wall".to_owned() }];
    pslg.regions = vec![RegionSeed { seed: [0.5, 0.5], tag: 4, attribute: 4.0, max_area: None }];
    let mut mesh = mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3]]);
    mesh.edge_tags = vec![8, 8, 8, 9];
    mesh.triangle_tags = vec![1, 1];
    let group = |dim, tag, name: &str| Group { dim, tag, name: name.to_owned() };
    mesh.groups = vec![group(1, 8, "wall"), group(1, 9, "boundary_-1"), group(2, 1, "region_4")];
    fails(&judged(&pslg, &mesh), &[]);
    mesh.edge_tags[1] = 9;
    mesh.triangle_tags[0] = 4;
    let certificate = judged(&pslg, &mesh);
    fails(&certificate, &[Guarantee::Conforming]);
    let kinds: Vec<_> = certificate
        .judgement(Guarantee::Conforming)
        .first
        .iter()
        .map(|fault| &fault.kind)
        .collect();
    assert!(
        matches!(kinds[0], FaultKind::WrongBoundaryTag { found, expected } if found == "9 (boundary_-1)" && expected == "3 (wall)")
    );
    assert_eq!(kinds.len(), 1, "a number without a name is the user's own: {certificate}");
}

#[test]
fn a_mesh_alone_is_judged_as_far_as_it_goes() {
    let pslg = square();
    let mut mesh = mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3]]);
    let certificate = certify_alone(&mesh, &Promise::default());
    assert!(certificate.holds());
    assert!(matches!(certificate.verdict(Guarantee::Conforming), Verdict::NotJudged(_)));
    mesh.triangles.pop();
    assert!(!certify_alone(&mesh, &Promise::default()).holds());
    assert!(certify_alone(Mesh::default(), &Promise::default()).holds());
}

#[test]
fn a_power_of_two_changes_no_verdict() {
    for exponent in [-1020, -900, -300, 300, 900, 1000] {
        let scale = 2_f64.powi(exponent);
        let mut pslg = polygon(&[[0.0, 0.0], [4.0, 0.0], [2.0, 1.5]]);
        pslg.points.iter_mut().flatten().for_each(|x| *x *= scale);
        let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2]]));
        fails(&certificate, &[Guarantee::Unencroached, Guarantee::Matrix]);
        assert!((certificate.smallest_angle.unwrap() - 0.75_f64.atan()).abs() < 1e-15);
    }
}

#[test]
fn a_point_that_nearly_touches_a_segment_limits_its_surroundings_and_no_more() {
    let gap = 1000.0 * f64::EPSILON / 2.0;
    let mut pslg = polygon(&[[0.0, 0.0], [0.9, 0.0], [0.9, 0.9], [0.0, 0.9]]);
    pslg.points.push([0.5, gap]);
    let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &triangles));
    assert_eq!(certificate.narrows[0].to, NarrowTo::Segment(Numbered { index: 0, number: 0 }));
    assert!((certificate.narrows[0].gap / gap - 1.0).abs() < 1e-12);
    assert_eq!(certificate.limited_triangles, 4);
    assert!(certificate.holds() && certificate.limited(), "{certificate}");
    // Ten times as far away doubles are fine enough.
    pslg.points[4][1] = 10.0 * gap;
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &triangles));
    assert!(certificate.narrows.is_empty() && certificate.limited_triangles == 0);
    assert_eq!(certificate.verdict(Guarantee::Unencroached), Verdict::Fails);
}

/// Two segments of length 1 that meet at 2^-30 rad, cut at `d`; the triangle between the cuts and
/// a third point is flat.
fn needle(d: f64) -> Certificate {
    let slope = 2_f64.powi(-30);
    let pslg = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, slope]]);
    let mut mesh = mesh_of(&pslg, &[[d, 0.0], [d, d * slope]], &[[0, 3, 4], [3, 1, 4], [1, 2, 4]]);
    mesh.edges = vec![[0, 3], [3, 1], [1, 2], [2, 4], [4, 0]];
    mesh.edge_tags = vec![0; 5];
    judged(&pslg, &mesh)
}

#[test]
fn an_apex_limits_as_far_as_the_bound_says() {
    // θ·d < 2^12·ulp(1) reaches to 2^-10, θ²·d < 4·ulp(1) to 2^10.
    let certificate = needle(0.5);
    assert_eq!(certificate.apexes.len(), 1);
    let apex = certificate.apexes[0];
    assert_eq!(apex.segments.map(|segment| segment.index), [0, 2]);
    assert!((apex.reach * 2_f64.powi(-10) - 1.0).abs() < 1e-9);
    assert!(certificate.holds() && certificate.limited(), "{certificate}");
    // At 2^-20 rad the reach is 2^-20·2^12 and no cut lies in it.
    let pslg = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2_f64.powi(-20)]]);
    let certificate = judged(&pslg, &mesh_of(&pslg, &[], &[[0, 1, 2]]));
    assert!(certificate.apexes.is_empty() && !certificate.holds());
}

/// An outline or a mesh of numbers that may mean nothing at all.
fn garbage() -> impl Strategy<Value = (Pslg, Mesh)> {
    let coordinate = prop_oneof![
        6 => (0..4_i32).prop_map(f64::from),
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(1e308), Just(-1e-308), Just(-0.0)],
        1 => -2.0..2.0_f64,
    ];
    let points = prop::collection::vec([coordinate.clone(), coordinate.clone()], 0..12);
    let index = prop_oneof![20 => 0..12_u32, 1 => Just(u32::MAX)];
    let tags = prop::collection::vec(-1..3_i32, 0..8);
    let pslg = (
        points.clone(),
        prop::collection::vec([index.clone(), index.clone()], 0..16),
        tags.clone(),
        points.clone(),
    );
    let mesh = (
        points,
        prop::collection::vec([index.clone(), index.clone(), index.clone()], 0..16),
        prop::collection::vec([index.clone(), index.clone()], 0..10),
        tags.clone(),
        prop::collection::vec(index, 0..10),
        any::<bool>(),
    );
    (pslg, mesh).prop_map(|((points, segments, segment_tags, seeds), mesh)| {
        let half = seeds.len() / 2;
        let regions = seeds[half..].iter().map(|&seed| RegionSeed {
            seed,
            tag: 1,
            attribute: 1.0,
            max_area: None,
        });
        let pslg = Pslg {
            points,
            segments,
            segment_tags,
            holes: seeds[..half].to_vec(),
            regions: regions.collect(),
            ..Pslg::default()
        };
        let (points, triangles, edges, tags, edge_segments, same) = mesh;
        let points = if same { pslg.points.clone() } else { points };
        let mesh = Mesh {
            points,
            triangles,
            triangle_tags: tags.clone(),
            edges,
            edge_tags: tags,
            edge_segments,
            ..Mesh::default()
        };
        (pslg, mesh)
    })
}

/// A mesh with its points and triangles in another order is judged in the same way, about the same
/// items.
#[test]
fn the_order_of_points_and_triangles_makes_no_difference() {
    let pslg = polygon(&[[0.0, 0.0], [2.0, -1.0], [4.0, 0.0], [2.0, 1.0]]);
    let mesh = mesh_of(&pslg, &[], &[[0, 1, 2], [0, 2, 3]]);
    let turned = |v: u32| (v + 1) % 4;
    let mut other = mesh.clone();
    other.points.rotate_right(1);
    other.triangles = mesh.triangles.iter().rev().map(|t| t.map(turned)).collect();
    other.edges = mesh.edges.iter().map(|edge| edge.map(turned)).collect();
    let [first, second] = [&mesh, &other].map(|mesh| {
        let certificate = judged(&pslg, mesh);
        let verdicts = Guarantee::ALL.map(|guarantee| certificate.verdict(guarantee));
        (verdicts, first(&certificate, Guarantee::Delaunay).clone())
    });
    assert_eq!(first.0, second.0);
    assert_eq!(first.1.point.map(turned), second.1.point);
    assert_eq!(first.1.triangle.map(|t| 1 - t), second.1.triangle);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_mesh_and_no_outline_makes_the_judge_fail((pslg, mesh) in garbage(), hull: bool) {
        let region = if hull { Region::Hull } else { Region::Domain };
        let promise = Promise { region, ..Promise::default() };
        let certificate = certify(&pslg, &mesh, &promise);
        prop_assert!(certificate.to_string().lines().count() >= 5);
        for fault in certificate.judgements.iter().flat_map(|judgement| &judgement.first) {
            prop_assert!(fault.triangle.is_none_or(|t| (t as usize) < mesh.triangles.len()));
            prop_assert!(fault.point.is_none_or(|v| (v as usize) < mesh.points.len()));
        }
        let alone = certify_alone(&mesh, &promise);
        prop_assert_eq!(alone.points, mesh.points.len());
    }
}
