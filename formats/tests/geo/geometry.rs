//! Curves, transformations, extrusions, shapes of OpenCASCADE, and the numbers they get.

use std::f64::consts::PI;

use super::{SQUARE, area, error, read, value_after};

/// The outline between a curve from (1, 0) to (0, 1) and the axes.
fn quarter(curve: &str) -> meshwright_formats::Pslg {
    read(&format!(
        "Point(1) = {{0, 0, 0, 0.05}}; Point(2) = {{1, 0, 0, 0.05}}; Point(3) = {{0, 1, 0, 0.05}};\n\
         Point(4) = {{1, 1, 0, 0.05}};\nLine(1) = {{1, 2}}; Line(2) = {{3, 1}}; {curve}\n\
         Line Loop(1) = {{1, 3, 2}}; Plane Surface(1) = {{1}};"
    ))
}

#[test]
fn an_arc_is_cut_into_chords_as_long_as_the_size() {
    let pslg = quarter("Circle(3) = {2, 1, 3};");
    let pieces = pslg.segments.len() - 2;
    assert_eq!(pieces, 32, "π/2 by 0.05");
    for p in &pslg.points[3..] {
        assert!((libm::hypot(p[0], p[1]) - 1.0).abs() < 1e-15, "{p:?}");
    }
    assert!((area(&pslg) - PI / 4.0).abs() < 1e-3);
    assert_eq!(pslg.source.segment_numbers[2..], vec![3; pieces]);
}

#[test]
fn sizes_are_linear_along_an_arc() {
    let pslg = quarter("Characteristic Length {3} = 0.2; Circle(3) = {2, 1, 3};");
    let chord = |[a, b]: [u32; 2]| {
        let ([ax, ay], [bx, by]) = (pslg.points[a as usize], pslg.points[b as usize]);
        libm::hypot(ax - bx, ay - by)
    };
    let arc: Vec<_> = pslg.segments[2..].to_vec();
    let (first, last) = (chord(arc[0]), chord(arc[arc.len() - 1]));
    assert!(first < 0.06 && last > 0.15, "{first} {last}");
    let inner = &pslg.point_sizes[3..];
    assert!(inner.windows(2).all(|pair| pair[0] < pair[1]), "{inner:?}");
}

#[test]
fn a_half_circle_turns_counter_clockwise() {
    let script = "Point(1) = {-1, 0, 0, 0.1}; Point(2) = {0, 0, 0, 0.1}; Point(3) = {1, 0, 0, 0.1};\n\
                  Circle(1) = {3, 2, 1}; Circle(2) = {1, 2, 3};\n\
                  Curve Loop(1) = {1, 2}; Plane Surface(1) = {1};";
    let pslg = read(script);
    assert!(pslg.points[2..32].iter().all(|p| p[1] > 0.0));
    assert!((area(&pslg) - PI).abs() < 0.02);
}

#[test]
fn coarse_circles_keep_their_area() {
    let script = "Point(1) = {-1, 0, 0, 9}; Point(2) = {0, 0, 0, 9}; Point(3) = {1, 0, 0, 9};\n\
                  Circle(1) = {3, 2, 1}; Circle(2) = {1, 2, 3};\n\
                  Curve Loop(1) = {1, 2}; Plane Surface(1) = {1};";
    let lost = 1.0 - area(&read(script)) / PI;
    assert!((0.0..0.01).contains(&lost), "{lost}");
}

#[test]
fn what_is_finer_for_the_area_keeps_the_size_of_what_was_asked_for() {
    let script = "Point(1) = {-1, 0, 0, 9}; Point(2) = {0, 0, 0, 9}; Point(3) = {1, 0, 0, 9};\n\
                  Circle(1) = {3, 2, 1}; Circle(2) = {1, 2, 3};\n\
                  Curve Loop(1) = {1, 2}; Plane Surface(1) = {1};";
    let pslg = read(script);
    assert!(pslg.segments.len() > 20, "{}", pslg.segments.len());
    // Three pieces for each half.
    assert!(pslg.point_sizes.iter().all(|size| (size - PI / 3.0).abs() < 1e-3), "{pslg:?}");
}

#[test]
fn an_ellipse_goes_through_its_ends() {
    let script = "Point(1) = {0, 0, 0, 0.05}; Point(2) = {2, 0, 0, 0.05}; Point(3) = {0, 1, 0, 0.05};\n\
                  Line(1) = {1, 2}; Line(2) = {3, 1}; Ellipse(3) = {2, 1, 2, 3};\n\
                  Curve Loop(1) = {1, 3, 2}; Plane Surface(1) = {1};";
    let pslg = read(script);
    for p in &pslg.points[3..] {
        assert!((p[0] * p[0] / 4.0 + p[1] * p[1] - 1.0).abs() < 1e-14, "{p:?}");
    }
    assert!((area(&pslg) - PI / 2.0).abs() < 1e-2);
    let old = read(&script.replace("Ellipse(3) = {2, 1, 2, 3}", "Ellipsis(3) = {2, 1, 3, 3}"));
    assert_eq!(old.points.len(), pslg.points.len());
}

#[test]
fn splines_end_in_their_outer_points() {
    // The exact areas below the curves, by integration of their polynomials.
    for (curve, exact) in [
        ("Spline(3) = {2, 4, 3};", 13.0 / 12.0),
        ("Bezier(3) = {2, 4, 3};", 5.0 / 6.0),
        ("BSpline(3) = {2, 4, 3};", 5.0 / 6.0),
    ] {
        let pslg = quarter(curve);
        let found = area(&pslg);
        assert!((found - exact).abs() < 0.02, "{curve} {found} {exact}");
    }
}

#[test]
fn a_b_spline_of_many_points_is_smooth_at_its_knots() {
    let pslg =
        quarter("Point(5) = {1, 0.5, 0}; Point(6) = {0.5, 1, 0}; BSpline(3) = {2, 5, 4, 6, 3};");
    let arc: Vec<[f64; 2]> = pslg.points[3..].to_vec();
    let turn = |w: &[[f64; 2]]| {
        let (a, b) =
            ([w[1][0] - w[0][0], w[1][1] - w[0][1]], [w[2][0] - w[1][0], w[2][1] - w[1][1]]);
        libm::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])
    };
    assert!(arc.windows(3).all(|w| turn(w).abs() < 0.25));
}

#[test]
fn a_line_through_many_points_keeps_all_of_them() {
    let pslg = quarter("Line(3) = {2, 4, 3};");
    assert_eq!(pslg.segments.len(), 4);
    assert_eq!(area(&pslg), 1.0);
}

#[test]
fn transfinite_curves_have_their_own_points() {
    let square = |law: &str| read(&format!("{SQUARE}Transfinite Curve {{1}} = 5 {law};"));
    let xs = |law: &str| square(law).points[4..].iter().map(|p| p[0]).collect::<Vec<_>>();
    assert_eq!(xs(""), [0.25, 0.5, 0.75]);
    let close = |found: Vec<f64>, expected: [f64; 3]| {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{found:?}");
    };
    close(xs("Using Progression 2"), [1.0 / 15.0, 3.0 / 15.0, 7.0 / 15.0]);
    close(xs("Using Bump 1"), [0.25, 0.5, 0.75]);
    let bump = xs("Using Bump 0.1");
    assert!(bump[0] < 0.2 && (bump[1] - 0.5).abs() < 1e-3 && bump[2] > 0.8, "{bump:?}");
    let back = read(&format!("{SQUARE}Transfinite Line {{-1}} = 5 Using Progression 2;"));
    assert!((back.points[4][0] - 8.0 / 15.0).abs() < 1e-3);
}

#[test]
fn the_sizes_of_a_transfinite_curve_are_its_steps() {
    let pslg = read(&format!("{SQUARE}Transfinite Curve \"*\" = 11;"));
    assert!(pslg.point_sizes.iter().all(|size| (size - 0.1).abs() < 1e-12));
    assert_eq!(pslg.segments.len(), 40);
}

#[test]
fn shapes_are_moved_with_the_points_that_define_them() {
    let moved = |motion: &str| {
        let pslg = read(&format!("{SQUARE}{motion}"));
        (pslg.points[0], pslg.points[2])
    };
    assert_eq!(moved("Translate {2, 3, 0} { Surface{1}; }"), ([2.0, 3.0], [3.0, 4.0]));
    assert_eq!(moved("Dilate {{0, 0, 0}, 2} { Surface{1}; }"), ([0.0, 0.0], [2.0, 2.0]));
    assert_eq!(moved("Dilate {{0, 0, 0}, {2, 3, 1}} { Curve{1:4}; }"), ([0.0, 0.0], [2.0, 3.0]));
    assert_eq!(moved("Symmetry {1, 0, 0, -2} { Surface{1}; }"), ([4.0, 0.0], [3.0, 1.0]));
    let (_, turned) = moved("Rotate {{0, 0, 1}, {0, 0, 0}, Pi/2} { Surface{1}; }");
    assert!((turned[0] + 1.0).abs() < 1e-15 && (turned[1] - 1.0).abs() < 1e-15);
}

#[test]
fn copies_that_touch_share_their_border() {
    let script =
        format!("{SQUARE}s[] = Translate {{1, 0, 0}} {{ Duplicata {{ Surface{{1}}; }} }};\n");
    let pslg = read(&script);
    assert_eq!((pslg.points.len(), pslg.segments.len(), pslg.regions.len()), (6, 7, 2));
    assert_eq!(value_after(&script, "s[0]"), 5.0);
}

#[test]
fn without_coherence_copies_stay_apart() {
    let script = format!(
        "Geometry.AutoCoherence = 0;\n{SQUARE}Translate {{1, 0, 0}} {{ Duplicata {{ Surface{{1}}; }} }}"
    );
    assert!(error(&script).ends_with("surface 5: its boundary is open at point 5"));
    assert_eq!(read(&format!("{script}\nCoherence;")).segments.len(), 7);
}

#[test]
fn extruded_points_become_lines_and_lines_surfaces() {
    let script = "Point(1) = {0, 0, 0, 0.5};\nl[] = Extrude {2, 0, 0} { Point{1}; };\n\
                  s[] = Extrude {0, 3, 0} { Line{l[1]}; Layers{3}; Recombine; };\n";
    let pslg = read(script);
    assert_eq!(area(&pslg), 6.0);
    // The line above, the surface, the sides; as Gmsh counts.
    for (i, tag) in [2.0, 5.0, 4.0, -3.0].into_iter().enumerate() {
        assert_eq!(value_after(script, &format!("s[{i}]")), tag);
    }
    assert_eq!(pslg.segments.len(), 2 + 3 + 3, "three layers");
}

#[test]
fn turning_a_line_makes_a_sector() {
    let script = "Point(1) = {1, 0, 0, 0.05}; Point(2) = {2, 0, 0, 0.05}; Line(1) = {1, 2};\n\
                  Extrude {{0, 0, 1}, {0, 0, 0}, Pi/2} { Line{1}; }\n";
    let pslg = read(script);
    assert!((area(&pslg) - 0.75 * PI).abs() < 2e-3);
    let centre = read(&script.replace("{1, 0, 0, 0.05}", "{0, 0, 0, 0.05}"));
    assert!((area(&centre) - PI).abs() < 2e-3, "its point on the axis does not move");
}

#[test]
fn shapes_of_opencascade_need_no_points() {
    let occ = |shapes: &str| read(&format!("SetFactory(\"OpenCASCADE\");\n{shapes}"));
    let rectangle = occ("Rectangle(1) = {1, 2, 0, 3, 4};");
    assert_eq!(rectangle.points[2], [4.0, 6.0]);
    assert_eq!(area(&rectangle), 12.0);
    let round =
        occ("Rectangle(1) = {0, 0, 0, 3, 4, 0, 0.5};".replace(", 0, 0.5", ", 0.5").as_str());
    assert!((area(&round) - (12.0 - (4.0 - PI) * 0.25)).abs() < 0.12);
    assert!((area(&occ("Disk(1) = {1, 2, 0, 2};")) - 4.0 * PI).abs() < 0.04 * PI);
    assert!((area(&occ("Disk(1) = {1, 2, 0, 2, 1};")) - 2.0 * PI).abs() < 0.02 * PI);
    let circle = "Circle(5) = {0, 0, 0, 1}; Curve Loop(1) = {5}; Plane Surface(1) = {1};";
    assert!((area(&occ(circle)) - PI).abs() < 0.01 * PI);
    let part = "Circle(1) = {0, 0, 0, 1, 0, Pi}; Line(2) = {2, 1}; Wire(1) = {1, 2}; Plane Surface(1) = {1};";
    assert!((area(&occ(part)) - PI / 2.0).abs() < 0.02);
}

#[test]
fn a_dilated_circle_is_an_ellipse() {
    let script = "SetFactory(\"OpenCASCADE\"); Circle(5) = {0, 0, 0, 1, 0, 2*Pi};\n\
                  Dilate {{0, 0, 0}, {2, 1, 1}} { Curve{5}; }\n\
                  Curve Loop(1) = {5}; Plane Surface(1) = {1};";
    assert!((area(&read(script)) - 2.0 * PI).abs() < 0.02 * PI);
}

#[test]
fn new_numbers_count_as_gmsh_counts() {
    let new = |script: &str, new: &str| value_after(&format!("{script}n = {new};"), "n");
    assert_eq!(new(SQUARE, "newp"), 5.0);
    assert_eq!(new(SQUARE, "newl"), 5.0);
    let script = format!("{SQUARE}Physical Surface(40) = {{1}};");
    assert_eq!(new(&script, "news"), 41.0);
    assert_eq!(new(&format!("Geometry.OldNewReg = 0;\n{script}"), "news + newll"), 4.0);
}

#[test]
fn queries_find_what_bounds_and_what_lies_in_a_box() {
    let two = format!("{SQUARE}Translate {{1, 0, 0}} {{ Duplicata {{ Surface{{1}}; }} }}\n");
    for (query, expected) in [
        ("l[] = Boundary { Surface{1}; };", 4.0),
        ("l[] = CombinedBoundary { Surface{:}; };", 6.0),
        ("l[] = PointsOf { Surface{:}; };", 6.0),
        ("l[] = Curve In BoundingBox {-0.1, -0.1, -0.1, 1.1, 0.1, 0.1};", 1.0),
        ("l[] = Point In BoundingBox {-1, -1, -1, 0.5, 2, 1};", 2.0),
        ("l[] = Surface{:};", 2.0),
        ("l[] = Point{3};", 3.0),
        ("Physical Curve(3) = {1, 2}; l[] = Physical Curve{3};", 2.0),
    ] {
        assert_eq!(value_after(&format!("{two}{query}"), "#l[]"), expected, "{query}");
    }
}

#[test]
fn deleted_shapes_can_be_made_anew() {
    let script = format!(
        "{SQUARE}Delete {{ Surface{{1}}; Curve{{2}}; }}\nPoint(5) = {{2, 0.5, 0, 0.5}};\n\
         Line(2) = {{2, 5}}; Line(5) = {{5, 3}};\nCurve Loop(2) = {{1, 2, 5, 3, 4}};\n\
         Plane Surface(1) = {{2}};"
    );
    assert_eq!(area(&read(&script)), 1.5);
    // A curve of a surface cannot be taken away.
    assert_eq!(area(&read(&format!("{SQUARE}Delete {{ Curve{{1}}; }}"))), 1.0);
}

#[test]
fn geometry_in_another_plane_is_laid_into_it() {
    let (pslg, warnings) = super::warned(&SQUARE.replace(", 0, 0.5}", ", -2, 0.5}"));
    assert_eq!(pslg.points[2], [1.0, 1.0]);
    assert_eq!(warnings, ["part.geo:1: all points have z = -2: x and y are taken as x and y"]);
    let turned = format!("{SQUARE}Rotate {{{{1, 0, 0}}, {{0, 0, 0}}, Pi/2}} {{ Surface{{1}}; }}");
    let (pslg, warnings) = super::warned(&turned);
    assert!((pslg.points[2][1] - 1.0).abs() < 1e-15);
    assert!(warnings[0].contains("x and z are taken as x and y"), "{warnings:?}");
}

#[test]
fn what_leaves_the_plane_is_refused() {
    let script = SQUARE.replace("{1, 1, 0, 0.5}", "{1, 1, 0.3, 0.5}");
    assert_eq!(
        error(&script),
        "3:1: point 3 does not lie in the plane z = 0 of the others (line 1)"
    );
    let up = error(&format!("{SQUARE}Extrude {{0, 0, 1}} {{ Surface{{1}}; }}"));
    assert_eq!(up, "11:1: `Extrude of a surface` is not read");
}
