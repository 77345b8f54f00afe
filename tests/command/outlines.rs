//! Outlines in other formats, and which of their faces are meshed.

use crate::bench::Bench;

/// A square with a square hole, clockwise around it, in two groups.
const FRAME: &str = "\
g wall
v 0 0 0
v 4 0 0
v 4 4 0
v 0 4 0
l 1 2 3 4 1
g pipe
v 1 1 0
v 1 3 0
v 3 3 0
v 3 1 0
l -4 -3 -2 -1 -4
";

/// The area of the mesh that these arguments make.
fn area(bench: &Bench, arguments: &str) -> f64 {
    let report = bench.succeeds(&format!("mesh {arguments} --json")).stdout;
    let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
    report["mesh"]["area"].as_f64().expect("an area")
}

#[test]
fn loops_in_loops_are_holes_as_the_format_or_the_user_says() {
    let bench = Bench::with("holes", "frame.obj", FRAME);
    assert_eq!(area(&bench, "frame.obj -o a.msh"), 12.0);
    assert_eq!(area(&bench, "frame.obj --holes even-odd"), 12.0);
    assert_eq!(area(&bench, "frame.obj --holes seeds"), 16.0);
    assert_eq!(area(&bench, "frame.obj --holes none -o b.msh --certificate b.json"), 16.0);
    bench.succeeds("check a.msh --input frame.obj");
    bench.succeeds("check b.msh --input frame.obj --holes none");
    bench.succeeds("check b.msh --input frame.obj --certificate b.json");
    assert_eq!(bench.run("check b.msh --input frame.obj").code, Some(4));
    assert_eq!(bench.run("check a.msh --input frame.obj --holes seeds").code, Some(4));
    let info = bench.succeeds("info frame.obj").stdout;
    assert!(info.contains("wall (1): 4 segments · pipe (2): 4 segments"), "{info}");
}

#[test]
fn a_poly_file_of_an_obj_file_has_seeds_in_its_holes() {
    let bench = Bench::with("convert", "frame.obj", FRAME);
    let ran = bench.succeeds("convert frame.obj frame.poly");
    assert!(ran.stderr.contains("boundaries have numbers here, no names"), "{}", ran.stderr);
    assert_eq!(area(&bench, "frame.poly"), 12.0);
    let ran = bench.succeeds("convert frame.poly again.obj");
    let said = "warning: again.obj: 1 hole seed is not written: the format has no place for it";
    assert!(ran.stderr.contains(said), "{}", ran.stderr);
    assert!(!ran.stderr.contains("each loop within a loop"), "{}", ran.stderr);
    bench.succeeds("convert again.obj again.poly");
    assert_eq!(bench.read("again.poly"), bench.read("frame.poly"));
    let ran = bench.succeeds("mesh frame.poly --holes none");
    let said = "note: frame.poly: 1 hole seed not used, as --holes asks";
    assert!(ran.stderr.contains(said), "{}", ran.stderr);
}

#[test]
fn what_is_meshed_otherwise_after_a_conversion_is_a_warning() {
    let bench = Bench::with("alike", "frame.obj", FRAME);
    let ran = bench.succeeds("convert frame.obj whole.obj --holes none");
    let said = "warning: in an .obj file each loop within a loop is a hole, here it is not; \
                `--holes none` reads it as it is here";
    assert!(ran.stderr.contains(said), "{}", ran.stderr);
    let ran = bench.run("convert frame.obj strict.obj --holes none --strict");
    assert_eq!(ran.code, Some(4), "{}", ran.stderr);
    assert!(!bench.path("strict.obj").exists());
    let crossing = FRAME.replace("l -4 -3 -2 -1", "l -4 -2 -3 -1");
    let bench = Bench::with("unclean", "crossing.obj", &crossing);
    let ran = bench.succeeds("convert crossing.obj crossing.poly");
    let said = "`--holes even-odd` reads it so: segments 5 and 7 cross near (2, 2)";
    assert!(ran.stderr.contains(said), "{}", ran.stderr);
}

/// A plate whose top is in two groups and whose corner is in one.
const PLATE: &str = "\
Point(1) = {0, 0, 0, 2}; Point(2) = {1, 0, 0, 2}; Point(3) = {1, 1, 0, 2}; Point(4) = {0, 1, 0, 2};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Curve(\"rim\", 5) = {1, 2, 3}; Physical Curve(\"top\", 6) = {3};
Physical Point(\"corner\", 9) = {1}; Physical Surface(\"plate\", 7) = {1};
";

#[test]
fn a_poly_file_of_a_geo_script_has_its_numbers_and_says_what_it_cannot_hold() {
    let bench = Bench::with("geo", "plate.geo", PLATE);
    let ran = bench.succeeds("convert plate.geo plate.poly");
    assert_eq!(
        String::from_utf8(bench.read("plate.poly")).expect("a text"),
        "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 5\n3 3 4 5\n4 4 1 0\n0\n\
         1\n1 0.5 0.5 7 -1\n"
    );
    for said in ["`rim` (5), `top` (6)", "`plate` (7)", "target sizes", "`corner`", "1 further"] {
        assert!(ran.stderr.contains(said), "{said}: {}", ran.stderr);
    }
}

#[test]
fn outlines_of_faces_are_taken_where_that_is_asked() {
    let faces = "v 0 0\nv 1 0\nv 1 1\nv 0 1\nf 1 2 3\nf 1 3 4\n";
    let bench = Bench::with("faces", "plate.obj", faces);
    let ran = bench.run("mesh plate.obj");
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("--faces takes their outlines"), "{}", ran.stderr);
    assert_eq!(area(&bench, "plate.obj --faces"), 1.0);
}

/// Triangle's files of a mesh of two triangles over the unit square, its third side tagged.
const NODE: &str = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
const POLY: &str = "0 2 0 0\n1 1\n1 3 4 7\n0\n";
const ELE: &str = "2 3 1\n1 1 2 3 5\n2 1 3 4 5\n";
const AREA: &str = "2\n1 0.01\n2 -1\n";

#[test]
fn a_mesh_is_refined_to_its_areas_as_an_outline() {
    let bench = Bench::with("refine", "a.1.ele", ELE);
    bench.put("a.1.node", NODE);
    bench.put("a.1.poly", POLY);
    let ran = bench.run("mesh a.1.ele");
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("--refine takes a mesh as the outline"), "{}", ran.stderr);
    let triangles = |arguments: &str| {
        let report = bench.succeeds(&format!("mesh {arguments} --json")).stdout;
        let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
        report["mesh"]["triangles"].as_u64().expect("a count")
    };
    assert_eq!(triangles("a.1.ele --refine"), 2);
    bench.put("a.1.area", AREA);
    let refined = triangles("a.1.ele --refine -o b.vtu --certificate b.json");
    assert!((60..200).contains(&refined), "{refined}");
    assert_eq!(triangles("a.1.area"), refined);
    bench.succeeds("check b.vtu --input a.1.ele --certificate b.json");
    bench.succeeds("check b.vtu --input a.1.ele --refine");
    let info = bench.succeeds("info b.vtu").stdout;
    assert!(info.contains("boundary 7"), "{info}");
    let ran = bench.succeeds("convert a.1.ele out.poly --refine");
    let said = "1 local area bound is not written";
    assert!(ran.stderr.contains(said), "{}", ran.stderr);
    bench.put("a.1.area", "3\n1 1\n2 1\n3 1\n");
    let ran = bench.run("mesh a.1.ele --refine");
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("a.1.ele: there are 3 areas for 2 triangles"), "{}", ran.stderr);
    bench.put("b.area", AREA);
    assert_eq!(bench.run("mesh b.area").code, Some(3));
}

#[test]
fn formats_that_hold_the_other_thing_are_refused() {
    let bench = Bench::with("refused", "frame.obj", FRAME);
    let ran = bench.run("mesh frame.obj -o mesh.geo");
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("Gmsh .geo holds no meshes"), "{}", ran.stderr);
    let ran = bench.run("convert frame.obj frame.msh");
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("outlines are written to .poly, .obj"), "{}", ran.stderr);
}
