//! Surfaces: holes, several contours, embedded curves and points, sizes, seeds.

use super::{SQUARE, read, warned};

/// A square from (a, a) to (b, b) whose points, curves and loop start at the number `n`.
fn ring(n: u32, a: f64, b: f64) -> String {
    let corners = [[a, a], [b, a], [b, b], [a, b]];
    let mut script = String::new();
    for (i, [x, y]) in (n..).zip(corners) {
        script += &format!("Point({i}) = {{{x}, {y}, 0, 1}};\n");
    }
    for i in 0..4 {
        script += &format!("Line({}) = {{{}, {}}};\n", n + i, n + i, n + (i + 1) % 4);
    }
    script + &format!("Line Loop({n}) = {{{n}:{}}};\n", n + 3)
}

#[test]
fn loops_in_a_surface_are_holes() {
    let script = ring(10, 0.0, 9.0) + &ring(20, 3.0, 6.0);
    let pslg = read(&format!("{script}Plane Surface(1) = {{10, 20}};"));
    assert_eq!((pslg.regions.len(), pslg.segments.len()), (1, 8));
    let [x, y] = pslg.regions[0].seed;
    assert!(!(3.0..=6.0).contains(&x) || !(3.0..=6.0).contains(&y), "{x} {y}");
    let turned = read(&format!("{script}Plane Surface(1) = {{20, 10}};"));
    assert_eq!(turned.regions[0].seed, [x, y], "the order does not matter");
}

#[test]
fn a_hole_may_be_another_surface() {
    let script = ring(10, 0.0, 9.0) + &ring(20, 3.0, 6.0);
    let pslg = read(&format!("{script}Plane Surface(1) = {{10, 20}}; Plane Surface(2) = {{20}};"));
    assert_eq!(pslg.regions.iter().map(|region| region.tag).collect::<Vec<_>>(), [1, 2]);
    assert_eq!(pslg.segments.len(), 8, "their border is there once");
}

#[test]
fn one_loop_may_hold_several_contours() {
    let script = ring(10, 0.0, 9.0) + &ring(20, 3.0, 6.0) + &ring(30, 4.0, 5.0);
    let pslg =
        read(&format!("{script}Line Loop(1) = {{10:13, 20:23, 30:33}}; Plane Surface(1) = {{1}};"));
    assert_eq!(pslg.regions.len(), 2, "the island in the hole is a part of its own");
    assert_eq!(pslg.regions[1].seed, [4.5, 4.5]);
}

#[test]
fn wrong_signs_in_a_loop_do_not_matter() {
    let straight = read(SQUARE);
    let turned = read(&SQUARE.replace("Line(2) = {2, 3}", "Line(2) = {3, 2}"));
    assert_eq!(turned.segments[1], [2, 1]);
    assert_eq!(turned.regions, straight.regions);
}

#[test]
fn unused_points_and_curves_are_left_out() {
    let pslg = read(&format!("{SQUARE}Point(50) = {{5, 5, 0}}; Line(50) = {{50, 1}};"));
    assert_eq!((pslg.points.len(), pslg.segments.len()), (4, 4));
}

#[test]
fn embedded_curves_and_points_are_kept() {
    let pslg = read(&format!(
        "{SQUARE}Point(5) = {{0.5, 0.25, 0, 0.1}}; Point(6) = {{0.5, 0.75, 0, 0.1}};\n\
         Point(7) = {{0.75, 0.5, 0, 0.01}};\nLine(5) = {{5, 6}};\n\
         Curve{{5}} In Surface{{1}}; Point{{7}} In Surface{{1}};"
    ));
    assert_eq!(pslg.segments.len(), 5);
    assert_eq!(pslg.points[6], [0.75, 0.5]);
    assert_eq!(pslg.point_sizes[4..], [0.1, 0.1, 0.01]);
    let [x, y] = pslg.regions[0].seed;
    let on_wall = x == 0.5 && (0.25..=0.75).contains(&y);
    assert!(!on_wall && [x, y] != [0.75, 0.5], "the seed keeps away from them: {x} {y}");
}

#[test]
fn embedded_curves_that_close_leave_no_hole() {
    let script = ring(10, 0.0, 9.0) + &ring(20, 3.0, 6.0);
    let pslg = read(&format!(
        "{script}Plane Surface(7) = {{10}}; Curve{{20, 21, 22, 23}} In Surface{{7}};"
    ));
    let inside = |seed: [f64; 2]| seed.iter().all(|c| (3.0..6.0).contains(c));
    let mut regions: Vec<_> = pslg.regions.iter().map(|r| (inside(r.seed), r.tag)).collect();
    regions.sort_unstable();
    assert_eq!(regions, [(false, 7), (true, 7)]);
}

#[test]
fn a_curve_given_twice_is_a_slit() {
    let pslg = read(&format!(
        "{SQUARE}Delete {{ Surface{{1}}; }}\nPoint(5) = {{0.5, 0.5, 0, 0.5}}; Line(5) = {{1, 5}};\n\
         Curve Loop(2) = {{5, -5, 1, 2, 3, 4}}; Plane Surface(1) = {{2}};"
    ));
    assert_eq!((pslg.segments.len(), pslg.regions.len()), (5, 1));
}

#[test]
fn the_same_surface_again_is_left_out_and_said() {
    let (pslg, warnings) = warned(&format!("{SQUARE}Plane Surface(2) = {{1}};"));
    assert_eq!(pslg.regions.len(), 1);
    assert_eq!(warnings, ["part.geo:11: surface 2 is surface 1 once more; it is left out"]);
}

#[test]
fn sizes_are_bounded_and_scaled_by_options() {
    let sizes = |options: &str| read(&format!("{SQUARE}{options}")).point_sizes[0];
    assert_eq!(sizes(""), 0.5);
    assert_eq!(sizes("Mesh.MeshSizeMax = 0.2;"), 0.2);
    assert_eq!(sizes("Mesh.CharacteristicLengthMin = 0.75;"), 0.75);
    assert_eq!(sizes("Mesh.CharacteristicLengthFactor = 0.5;"), 0.25);
    assert_eq!(sizes("Mesh.MeshSizeFromPoints = 0;"), std::f64::consts::SQRT_2);
    assert_eq!(sizes("MeshSize {:} = 0.125;"), 0.125);
    assert_eq!(sizes("h = 0.25; Mesh.MeshSizeMax = h; Mesh.MeshSizeMax *= 0.5;"), 0.125);
}

#[test]
fn without_sizes_a_tenth_of_the_diagonal_is_taken() {
    for size in ["}", ", 0}"] {
        let pslg = read(&SQUARE.replace(", 0.5}", size));
        assert_eq!(pslg.point_sizes, [0.1 * std::f64::consts::SQRT_2; 4]);
    }
}

#[test]
fn seeds_lie_inside_thin_and_odd_surfaces() {
    // A comb: teeth of width 1 with gaps of 1e-3, and a back of 1e-3.
    let mut script = String::new();
    let mut corners = vec![[0.0, 0.0], [10.01, 0.0]];
    for tooth in (0..10).rev() {
        let x = f64::from(tooth) * 1.001;
        corners.extend([[x + 1.0, 0.001], [x + 1.0, 5.0], [x, 5.0], [x, 0.001]]);
    }
    corners.dedup();
    let n = corners.len();
    for (i, [x, y]) in corners.iter().enumerate() {
        script += &format!(
            "Point({}) = {{{x}, {y}, 0}};\nLine({}) = {{{}, {}}};\n",
            i + 1,
            i + 1,
            i + 1,
            (i + 1) % n + 1
        );
    }
    let mut points = String::new();
    let mut lines = String::new();
    for line in script.lines() {
        let into = if line.starts_with("Point") { &mut points } else { &mut lines };
        into.push_str(line);
        into.push('\n');
    }
    let pslg =
        read(&format!("{points}{lines}Curve Loop(1) = {{1:{n}}}; Plane Surface(1) = {{1}};"));
    let [x, y] = pslg.regions[0].seed;
    let in_tooth = (0.0..1.0).contains(&(x % 1.001));
    assert!(in_tooth && y > 0.001 && y < 5.0, "{x} {y}");
}
