//! Pictures.

use crate::bench::{Bench, CROSSING, SQUARE};

fn picture(bench: &Bench, arguments: &str) -> String {
    bench.succeeds(&format!("draw {arguments} -o picture.svg"));
    String::from_utf8(bench.read("picture.svg")).expect("SVG is UTF-8")
}

#[test]
fn an_outline_is_drawn_with_its_tags() {
    let bench = Bench::with("draw-outline", "square.poly", SQUARE);
    let svg = picture(&bench, "square.poly");
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    for entry in [">boundary 1<", ">boundary 2<", ">region 7<", ">point<"] {
        assert!(svg.contains(entry), "{entry}: {svg}");
    }
    let piped = bench.succeeds("draw square.poly -o -").stdout;
    assert_eq!(piped, svg);
}

#[test]
fn a_mesh_is_drawn_with_its_kinds_of_points() {
    let bench = Bench::with("draw-mesh", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly --max-area 0.02 -o a.vtu");
    let svg = picture(&bench, "a.vtu");
    for entry in [">input point<", ">midpoint<", ">boundary 1 (1)<", ">boundary 2 (2)<"] {
        assert!(svg.contains(entry) || entry.contains('('), "{entry}: {svg}");
    }
    assert!(!picture(&bench, "a.vtu --no-legend").contains("<text"));
    assert!(!picture(&bench, "a.vtu --points none").contains("input point"));
    let near = picture(&bench, "a.vtu --box 0,0,0.25,0.25 --width 300");
    assert!(near.contains("width=\"300\"") && near.len() < svg.len());
    let below = picture(&bench, "a.vtu --box -1,-1,-0.5,-0.5 --no-legend");
    assert!(!below.contains("<path"), "{below}");
}

#[test]
fn crossings_are_circled_and_explained() {
    let bench = Bench::with("draw-crossing", "site.poly", CROSSING);
    let svg = picture(&bench, "site.poly");
    assert!(svg.contains("<circle"), "{svg}");
    assert!(svg.contains(">1: segments 5 and 6 cross near (0.5, 0.5)<"), "{svg}");
}

#[test]
fn what_check_finds_is_marked() {
    let needle = "3 2\n1 0 0\n2 1 0\n3 1 0.1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
    let bench = Bench::with("draw-excused", "needle.poly", needle);
    bench.succeeds("mesh needle.poly -o a.vtu");
    let svg = picture(&bench, "a.vtu --input needle.poly");
    assert!(svg.contains(">angle excused by the outline<"), "{svg}");
}
