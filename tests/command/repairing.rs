//! `--repair`, `--tolerance` and `--write-repaired`.

use crate::bench::{Bench, CROSSING, SQUARE};

/// A square that its last segment leaves open by 1e-9.
const OPEN: &str = "\
5 2 0 0
1 0 0
2 1 0
3 1 1
4 0 1
5 0 1e-9
4 0
1 1 2
2 2 3
3 3 4
4 4 5
0
";

#[test]
fn what_is_mended_is_said_with_the_numbers_and_lines_of_the_file() {
    let bench = Bench::with("repair", "site.poly", CROSSING);
    let said = bench.succeeds("mesh site.poly --repair").stderr;
    let expected = "\
repaired  1 crossing
          segments 5 and 6 cross near (0.5, 0.5): split at point 5
            site.poly:11: 5 1 3
            site.poly:12: 6 2 4
outline   site.poly: 5 points, 8 segments
          smallest angle 45.00°, between segments 1 and 5 at point 1
";
    assert!(said.starts_with(expected), "{said}");
    assert!(said.contains("\ncertified conforming, Delaunay"), "{said}");
    assert_eq!(bench.succeeds("mesh site.poly --repair -q").stderr, "");
    assert_eq!(bench.succeeds("mesh site.poly --repair --strict -q").stderr, "");
}

#[test]
fn a_gap_is_named_with_the_tolerance_that_closes_it() {
    let bench = Bench::with("gap", "site.poly", OPEN);
    for arguments in ["mesh site.poly", "mesh site.poly --repair -q"] {
        assert_eq!(
            bench.fails(arguments, 1),
            "\
error: the outline encloses nothing: points 1 and 5 are open ends, 1e-9 apart
  site.poly:2: 1 0 0
  site.poly:6: 5 0 0.000000001
help: `--repair --tolerance 1e-9` closes what is narrow; `--region hull` meshes the convex hull of the points
"
        );
    }
    let said = bench.succeeds("mesh site.poly --repair --tolerance 1e-9").stderr;
    let closed = "points 1 and 5 are open ends, 1e-9 apart: joined at point 1\n";
    assert!(said.starts_with(&format!("repaired  1 gap\n          {closed}")), "{said}");
}

#[test]
fn the_mended_outline_is_written_and_is_clean() {
    let bench = Bench::with("write-repaired", "site.poly", CROSSING);
    let said = bench.succeeds("mesh site.poly --repair -o a.msh --write-repaired b.poly").stderr;
    assert!(said.ends_with("), b.poly (Triangle .poly, 112 B)\n"), "{said}");
    bench.succeeds("check a.msh --input b.poly");
    let again = bench.succeeds("mesh b.poly --repair -o c.msh --write-repaired d.poly").stderr;
    assert!(again.starts_with("repaired  nothing to mend\n"), "{again}");
    assert_eq!(bench.read("b.poly"), bench.read("d.poly"));
    assert_eq!(bench.read("a.msh"), bench.read("c.msh"));
}

#[test]
fn nothing_is_written_where_mending_is_not_enough() {
    let bench = Bench::with("repair-fails", "site.poly", OPEN);
    bench.fails("mesh site.poly --repair -o a.msh --write-repaired b.poly -q", 1);
    assert_eq!(bench.names(), ["site.poly"]);
}

#[test]
fn check_draw_trace_and_convert_mend_as_mesh_does() {
    let bench = Bench::with("repair-all", "site.poly", CROSSING);
    bench.succeeds("mesh site.poly --repair -o a.msh");
    let said = bench.succeeds("check a.msh --input site.poly --repair").stdout;
    let expected = "\
repaired      1 crossing
              segments 5 and 6 cross near (0.5, 0.5): split at point 5
";
    assert!(said.starts_with(expected), "{said}");
    bench.succeeds("trace site.poly --repair -o a.jsonl");
    bench.succeeds("convert site.poly b.obj --repair");
    bench.succeeds("check a.msh --input b.obj");
    let drawn = |arguments: &str| {
        bench.succeeds(arguments);
        String::from_utf8(bench.read("a.svg")).expect("SVG is UTF-8")
    };
    assert!(drawn("draw site.poly -o a.svg").contains("segments 5 and 6 cross"));
    assert!(!drawn("draw site.poly --repair -o a.svg").contains("segments 5 and 6 cross"));
    bench.succeeds("draw a.msh --input site.poly --repair -o a.svg");
}

#[test]
fn options_that_mend_nothing_are_refused() {
    let bench = Bench::with("repair-usage", "site.poly", SQUARE);
    for (arguments, reason) in [
        ("--tolerance 1", "--repair"),
        ("--write-repaired a.poly", "--repair"),
        ("--repair --tolerance 0", "it must be greater than 0"),
        ("--repair --write-repaired a.msh", "a.msh: outlines are written to .poly, .obj"),
        ("--repair --write-repaired site.poly", "site.poly"),
    ] {
        let said = bench.fails(&format!("mesh site.poly {arguments}"), 2);
        assert!(said.contains(reason), "{arguments}: {said}");
    }
}
