//! Gmsh's `.geo` scripts: the language, the geometry, the outline it becomes, what is refused.

mod booleans;
mod errors;
mod geometry;
mod groups;
mod language;
mod outline;
mod skipped;

use std::io;

use meshwright_formats::{Pslg, Warning, geo};

/// The corners of the unit square and its sides, with loop 1 and surface 1.
const SQUARE: &str = "\
Point(1) = {0, 0, 0, 0.5};
Point(2) = {1, 0, 0, 0.5};
Point(3) = {1, 1, 0, 0.5};
Point(4) = {0, 1, 0, 0.5};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
";

/// The outline and the warnings of a script that stands alone.
fn warned(script: &str) -> (Pslg, Vec<String>) {
    let (pslg, warnings) = geo::read(script.as_bytes(), "part.geo", geo::no_includes)
        .unwrap_or_else(|error| panic!("{error}"));
    (pslg, warnings.iter().map(Warning::to_string).collect())
}

/// The outline of a script that stands alone and is read without a warning.
fn read(script: &str) -> Pslg {
    let (pslg, warnings) = warned(script);
    assert_eq!(warnings, [""; 0]);
    pslg
}

/// The first line of the error of a script, without the file's name.
fn error(script: &str) -> String {
    error_with(script, geo::no_includes)
}

fn error_with(script: &str, include: impl FnMut(&str) -> io::Result<Vec<u8>>) -> String {
    let error = geo::read(script.as_bytes(), "part.geo", include).expect_err(script).to_string();
    let line = error.lines().next().expect("a message has a line");
    line.strip_prefix("part.geo:").unwrap_or_else(|| panic!("{line}")).to_owned()
}

/// The value of an expression after some statements.
fn value_after(statements: &str, expression: &str) -> f64 {
    let script = format!(
        "{statements}\nPoint(901) = {{-7, -50, 0}}; Point(902) = {{{expression}, -60, 0}};\n\
         Point(903) = {{-7, -40, 0}};\nLine(901) = {{901, 902}}; Line(902) = {{902, 903}};\n\
         Line(903) = {{903, 901}};\nCurve Loop(901) = {{901, 902, 903}};\n\
         Plane Surface(901) = {{901}};\n"
    );
    let (pslg, _) = warned(&script);
    let index = pslg.source.point_numbers.iter().position(|&number| number == 902);
    pslg.points[index.expect("point 902 is used")][0]
}

/// The value of an expression.
fn value(expression: &str) -> f64 {
    value_after("", expression)
}

/// The area of the polygon that the segments of a single outline enclose, however they are turned.
fn area(pslg: &Pslg) -> f64 {
    let mut left = pslg.segments.clone();
    let [start, mut here] = left.swap_remove(0);
    let mut doubled = 0.0;
    let mut add = |a: u32, b: u32| {
        let ([ax, ay], [bx, by]) = (pslg.points[a as usize], pslg.points[b as usize]);
        doubled += ax * by - ay * bx;
    };
    add(start, here);
    while here != start {
        let next =
            left.iter().position(|ends| ends.contains(&here)).expect("the outline is closed");
        let [a, b] = left.swap_remove(next);
        let there = if a == here { b } else { a };
        add(here, there);
        here = there;
    }
    0.5 * f64::abs(doubled)
}

#[test]
fn a_square_becomes_its_four_sides_and_a_region() {
    let pslg = read(SQUARE);
    assert_eq!(pslg.points, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(pslg.segments, [[0, 1], [1, 2], [2, 3], [3, 0]]);
    assert_eq!(pslg.point_sizes, [0.5; 4]);
    assert_eq!(pslg.source.point_lines, [1, 2, 3, 4]);
    assert_eq!(pslg.source.segment_lines, [5, 6, 7, 8]);
    assert_eq!(pslg.source.region_lines, [10]);
    assert_eq!(pslg.regions[0].seed, [0.5, 0.5]);
    assert_eq!(pslg.enclosed, meshwright_formats::Enclosed::Seeded);
}
