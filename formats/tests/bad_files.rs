//! Nasty `.poly` and `.node` files: the line and the word that each message names.
//!
//! Files whose fault is one of geometry (crossings, duplicates, …) are read without complaint.

use std::fs;
use std::path::{Path, PathBuf};

use meshwright_formats::{Pslg, SyntaxError, Warning, node, poly};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/bad")
}

fn read(name: &str) -> Result<(Pslg, Vec<Warning>), SyntaxError> {
    let text = fs::read(folder().join(name)).expect("the fixture is there");
    if name.ends_with(".node") {
        return node::read(&text, name);
    }
    poly::read(&text, name, |node| fs::read(folder().join(node)))
}

fn good(name: &str) -> Pslg {
    let (pslg, warnings) = read(name).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(warnings, [], "{name}");
    pslg
}

fn warned(name: &str) -> (Pslg, Vec<String>) {
    let (pslg, warnings) = read(name).unwrap_or_else(|error| panic!("{error}"));
    (pslg, warnings.iter().map(Warning::to_string).collect())
}

fn assert_square(pslg: &Pslg) {
    assert_eq!(pslg.points, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(pslg.segments, [[0, 1], [1, 2], [2, 3], [3, 0]]);
}

#[test]
fn every_unreadable_file_names_its_line_and_its_word() {
    let expected = [
        ("binary.poly", "1:1: expected the number of points, found `\u{fffd}"),
        ("count_huge.poly", "3:6: expected point 3 of 4000000000, found the end of the file"),
        ("count_negative.poly", "1:1: expected the number of points, found `-4`"),
        ("count_too_big.poly", "6:1: expected point number 5, found `4`"),
        ("csv.poly", "1:1: expected the number of points, found `4,2,0,0`"),
        ("dim3.poly", "1:3: expected the dimension 2, found `3`"),
        ("ele_as_poly.poly", "1:3: expected the dimension 2, found `3`"),
        ("empty.poly", "1:1: expected the number of points, found the end of the file"),
        (
            "index_huge.poly",
            "7:5: expected the number of a point (1 to 4), found `99999999999999999999`",
        ),
        ("index_out_of_range.poly", "9:5: expected the number of a point (1 to 4), found `5`"),
        ("missing_y.poly", "3:4: expected a y coordinate, found the end of the line"),
        ("nan.poly", "3:3: expected an x coordinate, found `nan`"),
        ("node_ids_duplicate.poly", "4:1: expected point number 3, found `2`"),
        ("node_missing.poly", "1:1: expected points, here or in `node_missing.node`, found `0`"),
        ("overflow_literal.poly", "3:3: expected an x coordinate, found `1e999`"),
        ("trunc_vertices.poly", "3:6: expected point 3 of 4, found the end of the file"),
    ];
    for (name, message) in expected {
        let error = read(name).expect_err(name).to_string();
        let expected = format!("{name}:{message}");
        assert!(error.starts_with(&expected), "expected {expected}\nfound {error}");
    }
}

#[test]
fn an_error_is_shown_with_its_line_a_caret_and_help() {
    let error = read("csv.poly").expect_err("commas are no spaces").to_string();
    let expected = "\
csv.poly:1:1: expected the number of points, found `4,2,0,0`
  |
1 | 4,2,0,0
  | ^
help: numbers are separated by spaces";
    assert_eq!(error, expected);
}

#[test]
fn the_help_says_what_the_header_announced() {
    let error = read("count_too_big.poly").expect_err("a point is missing");
    let help = error.help.as_deref();
    assert_eq!(help, Some("line 1 announces 5 points; they count up from 1"));
}

#[test]
fn a_missing_companion_is_named() {
    let error = read("node_missing.poly").expect_err("there is no such file");
    let help = error.help.unwrap_or_default();
    assert!(help.starts_with("node_missing.node: "), "{help}");
}

#[test]
fn spellings_and_line_ends_do_not_matter() {
    for name in ["bom.poly", "crlf.poly", "fortran_d.poly", "no_hole_section.poly"] {
        assert_square(&good(name));
    }
    let pslg = good("tabs_comments.poly");
    assert_square(&pslg);
    assert_eq!(pslg.point_markers, [5; 4]);
    assert_eq!(pslg.segment_tags, [5; 4]);
    assert_eq!(pslg.source.point_lines, [5, 6, 7, 10]);
}

#[test]
fn markers_keep_their_extremes() {
    let pslg = good("marker_negative.poly");
    assert_eq!(pslg.segment_tags, [-1, i32::MIN, i32::MAX, 0]);
}

#[test]
fn points_come_from_the_node_file_beside() {
    let pslg = good("node_separate.poly");
    assert_square(&pslg);
    assert_eq!(pslg.point_markers, [3, 3, 4, 4]);
    let names: Vec<_> = pslg.point_attributes.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names, ["attribute_1", "attribute_2"]);
    assert_eq!(pslg.source.file, "node_separate.poly");
    assert_eq!(pslg.source.point_file.as_deref(), Some("node_separate.node"));
}

#[test]
fn what_is_passed_over_is_said() {
    let expected = [
        (
            "extra_columns.poly",
            "extra_columns.poly:2: 2 lines have more columns than the header (line 1) announces; \
             they are ignored",
        ),
        (
            "markers_missing.poly",
            "markers_missing.poly:3: 1 line has no boundary marker, which the header (line 1) \
             announces; taken as 0",
        ),
        (
            "trailing_garbage.poly",
            "trailing_garbage.poly:13: the file goes on after its last section; 2 lines are \
             ignored",
        ),
    ];
    for (name, warning) in expected {
        let (pslg, warnings) = warned(name);
        assert_square(&pslg);
        assert_eq!(warnings, [warning]);
    }
    assert_eq!(warned("markers_missing.poly").0.point_markers, [1, 0, 1, 1]);
}

#[test]
fn faults_of_geometry_are_not_the_readers() {
    for name in [
        "bowtie.poly",
        "circle_cocircular.poly",
        "collinear.poly",
        "crossing.poly",
        "dup.node",
        "duplicate_points.poly",
        "duplicate_segments.poly",
        "far_offset.poly",
        "hole_on_vertex.poly",
        "hole_outside.poly",
        "hole_unclosed.poly",
        "huge_1e308.poly",
        "island_in_hole.poly",
        "near_segment_point.poly",
        "needle_pair.poly",
        "no_segments.poly",
        "node_separate.node",
        "one_point.poly",
        "overlap_collinear.poly",
        "region_outside.poly",
        "t_junction.poly",
        "tiny_1e-160.poly",
        "unclosed_by_eps.poly",
        "zero_length_segment.poly",
    ] {
        let pslg = good(name);
        assert_eq!(pslg.source.point_lines.len(), pslg.points.len(), "{name}");
        assert_eq!(pslg.source.segment_lines.len(), pslg.segments.len(), "{name}");
        assert_eq!(pslg.source.hole_lines.len(), pslg.holes.len(), "{name}");
        assert_eq!(pslg.source.region_lines.len(), pslg.regions.len(), "{name}");
    }
}

#[test]
fn every_fixture_is_used() {
    let source = include_str!("bad_files.rs");
    for entry in fs::read_dir(folder()).expect("the fixtures are there") {
        let name = entry.expect("a fixture").file_name();
        let name = name.to_string_lossy();
        if name == "README.md" {
            continue;
        }
        assert!(source.contains(&format!("\"{name}\"")), "{name} is in no test");
    }
}
