//! Boolean operations of OpenCASCADE. Expected numbers of curves and surfaces are those of Gmsh 4.15.

use std::f64::consts::PI;

use meshwright_formats::Pslg;

use crate::{error, read, warned};

/// The box around each curve, by its number, to three digits.
fn boxes(pslg: &Pslg) -> Vec<(i64, [f64; 4])> {
    let mut found: Vec<(i64, [f64; 4])> = Vec::new();
    for (segment, &number) in pslg.segments.iter().zip(&pslg.source.segment_numbers) {
        if found.last().is_none_or(|(last, _)| *last != number) {
            found.push((number, [f64::INFINITY, f64::INFINITY, -f64::INFINITY, -f64::INFINITY]));
        }
        let (_, around) = found.last_mut().expect("just pushed");
        for [x, y] in segment.map(|v| pslg.points[v as usize]) {
            let [low, left, high, right] = *around;
            *around = [low.min(x), left.min(y), high.max(x), right.max(y)];
        }
    }
    let round = |x: f64| (1000.0 * x).round() / 1000.0 + 0.0;
    found.into_iter().map(|(number, around)| (number, around.map(round))).collect()
}

fn occ(script: &str) -> Pslg {
    read(&format!("SetFactory(\"OpenCASCADE\");\n{script}"))
}

/// The number of the surface at each seed, and the seed.
fn surfaces(pslg: &Pslg) -> Vec<i32> {
    pslg.regions.iter().map(|region| region.tag).collect()
}

#[test]
fn a_difference_takes_what_lies_inside_out() {
    let script = "SetFactory(\"OpenCASCADE\");\nDisk(1) = {0, 0, 0, 0.5}; Disk(2) = {0, 0, 0, 2};\n\
                  v() = BooleanDifference{ Surface{2}; Delete; }{ Surface{1}; Delete; };\n\
                  Physical Curve(1) = {1}; Physical Curve(5) = {2}; Physical Surface(9) = {v()};";
    let pslg = read(script);
    assert_eq!(pslg.regions.iter().map(|region| region.tag).collect::<Vec<_>>(), [9]);
    let [x, y] = pslg.regions[0].seed;
    assert!((0.5..2.0).contains(&libm::hypot(x, y)));
    let radius = |tag: i32| {
        let of = pslg.segment_tags.iter().position(|&other| other == tag).expect("it is there");
        let [x, y] = pslg.points[pslg.segments[of][0] as usize];
        libm::hypot(x, y)
    };
    assert!((radius(1) - 0.5).abs() < 1e-15 && (radius(5) - 2.0).abs() < 1e-15);
    let kept = read(&script.replace("1}; Delete;", "1};").replace("(9) = {v()}", "(9) = {1}"));
    assert_eq!(kept.regions.len(), 2, "the tool stays");
}

#[test]
fn a_tool_across_an_object_cuts_it_in_two() {
    let pslg = occ("Rectangle(1) = {0, 0, 0, 4, 2}; Rectangle(2) = {1, -1, 0, 1, 4};\n\
                    BooleanDifference{ Surface{1}; Delete; }{ Surface{2}; Delete; }");
    assert_eq!(surfaces(&pslg), [1, 2]);
    assert_eq!(pslg.source.point_numbers, (1..=8).collect::<Vec<_>>());
    assert_eq!(
        boxes(&pslg),
        [
            (1, [0.0, 0.0, 0.0, 2.0]),
            (2, [0.0, 2.0, 1.0, 2.0]),
            (3, [1.0, 0.0, 1.0, 2.0]),
            (4, [0.0, 0.0, 1.0, 0.0]),
            (5, [2.0, 0.0, 2.0, 2.0]),
            (6, [2.0, 2.0, 4.0, 2.0]),
            (7, [4.0, 0.0, 4.0, 2.0]),
            (8, [2.0, 0.0, 4.0, 0.0]),
        ]
    );
}

#[test]
fn a_tool_that_touches_nothing_changes_nothing() {
    let pslg = occ("Rectangle(1) = {0, 0, 0, 1, 1}; Disk(2) = {3, 3, 0, 0.2};\n\
                    BooleanDifference{ Surface{1}; Delete; }{ Surface{2}; Delete; }");
    assert_eq!(surfaces(&pslg), [1]);
    assert_eq!(pslg.points, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
}

#[test]
fn what_a_tool_covers_is_gone() {
    let script = "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\n\
                  Disk(2) = {0.5, 0.5, 0, 5};\n\
                  BooleanDifference{ Surface{1}; Delete; }{ Surface{2}; Delete; }";
    assert!(error(script).ends_with("the script makes no surface: there is nothing to mesh"));
}

#[test]
fn a_circle_across_an_edge_is_cut_where_they_meet() {
    let pslg =
        occ("Rectangle(1) = {0, 0, 0, 4, 2}; Disk(2) = {2, 0, 0, 1}; Disk(3) = {1, 1, 0, 0.1};\n\
                    BooleanDifference(10) = { Surface{1}; Delete; }{ Surface{2, 3}; Delete; }");
    assert_eq!(surfaces(&pslg), [10]);
    let numbers: Vec<(i64, [f64; 4])> = boxes(&pslg);
    assert_eq!(
        numbers,
        [
            (1, [1.0, 0.0, 3.0, 1.0]),
            (2, [0.0, 0.0, 1.0, 0.0]),
            (3, [0.0, 0.0, 0.0, 2.0]),
            (4, [0.0, 2.0, 4.0, 2.0]),
            (5, [4.0, 0.0, 4.0, 2.0]),
            (6, [3.0, 0.0, 4.0, 0.0]),
            (7, numbers[6].1),
        ]
    );
    assert!((numbers[6].1[0] - 0.9).abs() < 0.02 && (numbers[6].1[2] - 1.1).abs() < 0.02);
}

#[test]
fn circles_share_a_lens() {
    let pslg = occ("Disk(1) = {0, 0, 0, 1}; Disk(2) = {1, 0, 0, 1};\n\
                    s() = BooleanIntersection{ Surface{1}; Delete; }{ Surface{2}; Delete; };\n\
                    Physical Surface(7) = {s()}; Physical Curve(8) = {2}; Physical Curve(9) = {1, 3};");
    assert_eq!(surfaces(&pslg), [7]);
    let lens = 2.0 * PI / 3.0 - 0.5 * f64::sqrt(3.0);
    assert!((crate::area(&pslg) - lens).abs() < 0.01 * lens);
    for (tag, centre) in [(8, 1.0), (9, 0.0)] {
        for (segment, _) in pslg.segments.iter().zip(&pslg.segment_tags).filter(|s| *s.1 == tag) {
            let [x, y] = pslg.points[segment[0] as usize];
            assert!((libm::hypot(x - centre, y) - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn fragments_share_what_lies_between_them() {
    let pslg = occ("Rectangle(1) = {0, 0, 0, 4, 2}; Disk(2) = {1, 1, 0, 0.5};\n\
                    Rectangle(3) = {3, 1, 0, 2, 2};\n\
                    BooleanFragments{ Surface{1}; Delete; }{ Surface{2, 3}; Delete; }");
    assert_eq!(surfaces(&pslg), [2, 3, 4, 5]);
    let found = boxes(&pslg);
    assert_eq!(found.len(), 13);
    assert_eq!(found[2..4], [(3, [3.0, 1.0, 3.0, 2.0]), (4, [3.0, 1.0, 4.0, 1.0])]);
    assert_eq!(found[8..10], [(9, [4.0, 1.0, 4.0, 2.0]), (10, [3.0, 2.0, 3.0, 3.0])]);
}

#[test]
fn neighbours_become_one_mesh_and_keep_their_numbers() {
    let pslg = occ("Rectangle(1) = {0, 0, 0, 1, 1}; Rectangle(2) = {1, 0, 0, 1, 2};\n\
                    BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }");
    assert_eq!(surfaces(&pslg), [1, 2]);
    assert_eq!((pslg.points.len(), pslg.segments.len()), (7, 8), "one side is shared");
}

#[test]
fn lines_cut_a_surface_and_stay_where_they_only_enter_it() {
    let pslg = occ("Rectangle(1) = {0, 0, 0, 4, 2};\n\
                    Point(5) = {1, 0, 0}; Point(6) = {1, 2, 0}; Line(5) = {5, 6};\n\
                    Point(7) = {3, 0, 0}; Point(8) = {3, 1, 0}; Line(6) = {7, 8};\n\
                    v() = BooleanFragments{ Surface{1}; Delete; }{ Curve{5, 6}; Delete; };\n\
                    Physical Curve(1) = {5, 6}; Physical Surface(2) = {1, 2};");
    assert_eq!(surfaces(&pslg), [2, 2]);
    let of_lines = pslg.segments.iter().zip(&pslg.segment_tags).filter(|(_, tag)| **tag == 1);
    let xs: Vec<f64> = of_lines.map(|(segment, _)| pslg.points[segment[0] as usize][0]).collect();
    assert_eq!(xs, [1.0, 3.0]);
}

#[test]
fn a_union_has_nothing_inside() {
    let pslg = occ("Rectangle(1) = {0, 0, 0, 4, 2}; Rectangle(3) = {3, 0, 0, 2, 2};\n\
                    Disk(4) = {0, 1, 0, 0.5};\n\
                    s() = BooleanUnion{ Surface{1}; Delete; }{ Surface{3, 4}; Delete; };\n\
                    Physical Surface(9) = {s()};");
    assert_eq!(surfaces(&pslg), [9]);
    let expected = 10.0 + 0.125 * PI;
    assert!((crate::area(&pslg) - expected).abs() < 0.01 * expected);
    let corner = |p: &[f64; 2]| *p == [3.0, 0.0] || *p == [4.0, 0.0];
    assert!(!pslg.points.iter().any(corner), "sides on one line are one");
}

#[test]
fn curves_that_gmsh_numbers_in_another_order_are_not_to_be_named() {
    let script = "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 4, 2};\n\
                  Rectangle(3) = {3, 1, 0, 2, 2};\n\
                  BooleanUnion{ Surface{1}; Delete; }{ Surface{3}; Delete; }\n\
                  Physical Curve(1) = {8};";
    let message = "5:1: the number of curve 8 after a boolean operation is not known here";
    assert_eq!(error(script), message);
}

#[test]
fn booleans_of_what_is_not_read_are_refused_by_name() {
    let spline = "Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {1, 2, 0};\n\
                  Line(1) = {1, 2}; Spline(2) = {2, 3, 1}; Curve Loop(1) = {1, 2};\n\
                  Plane Surface(1) = {1}; Rectangle(2) = {1, 0, 0, 3, 1};\n";
    let ellipse = "Disk(1) = {0, 0, 0, 2, 1}; Rectangle(2) = {1, 0, 0, 3, 1};\n";
    let tilted = "Rectangle(1) = {0, 0, 0, 1, 1}; Rectangle(2) = {0, 0, 1, 1, 1};\n";
    let others = "BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }";
    for (shapes, statement, what) in [
        (
            spline,
            others,
            "`a boolean operation of curves other than lines and circles` is not read",
        ),
        (
            ellipse,
            others,
            "`a boolean operation of curves other than lines and circles` is not read",
        ),
        (tilted, others, "`BooleanFragments of shapes that lie in no plane z = c` is not read"),
        (
            tilted,
            "BooleanUnion{ Curve{1}; }{ Curve{2}; }",
            "`BooleanUnion of anything but surfaces` is not read",
        ),
    ] {
        let message = error(&format!("SetFactory(\"OpenCASCADE\");\n{shapes}{statement}"));
        assert!(message.ends_with(what), "{message}");
    }
    // Holes may be of any curves.
    let hole = "Rectangle(1) = {0, 0, 0, 4, 4}; Disk(2) = {2, 2, 0, 1, 0.5};\n\
                BooleanDifference{ Surface{1}; Delete; }{ Surface{2}; Delete; }";
    assert_eq!(surfaces(&occ(hole)), [1]);
    let across = hole.replace("{2, 2, 0, 1, 0.5}", "{0, 2, 0, 1, 0.5}");
    let message = error(&format!("SetFactory(\"OpenCASCADE\");\n{across}"));
    assert!(message.contains("read only where the tools lie inside"), "{message}");
}

#[test]
fn hostile_booleans_end() {
    let grid = "SetFactory(\"OpenCASCADE\");\nFor i In {1:300}\n\
                Rectangle(i) = {i, 0, 0, 0.5, 400}; Rectangle(1000 + i) = {0, i, 0, 400, 0.5};\n\
                EndFor\nBooleanFragments{ Surface{1:300}; Delete; }{ Surface{1001:1300}; Delete; }";
    assert!(error(grid).ends_with("a boolean operation makes more than 20000 pieces"));
    for odd in [
        "Plane Surface(1) = {}; BooleanUnion{ Surface{1}; Delete; }{ }",
        "Rectangle(1) = {0, 0, 0, 1, 1}; BooleanUnion{ Surface{1, 1}; Delete; }{ Surface{1}; Delete; }",
        "BooleanFragments{ }{ }",
        "Point(1) = {0, 0, 0}; Line(1) = {1, 1}; Curve Loop(1) = {1}; Plane Surface(1) = {1};\
         Rectangle(2) = {0, 0, 0, 1, 1};\
         BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }",
    ] {
        let script = format!("SetFactory(\"OpenCASCADE\");\n{odd}");
        let read = meshwright_formats::geo::read(
            script.as_bytes(),
            "odd.geo",
            meshwright_formats::geo::no_includes,
        );
        assert!(read.is_ok() || read.is_err_and(|error| error.file.as_ref() == "odd.geo"));
    }
    let (_, warnings) = warned(
        "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 1, 1}; Rectangle(2) = {0, 0, 0, 1, 1};\
         BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }",
    );
    assert!(warnings.is_empty(), "two that are the same become one: {warnings:?}");
}
