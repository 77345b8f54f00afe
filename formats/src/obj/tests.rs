use super::*;
use crate::pslg::{Group, Tag};

fn outline(text: &str) -> (Pslg, Vec<String>) {
    let (pslg, warnings) = read(text.as_bytes(), "a.obj").expect(text);
    (pslg, warnings.iter().map(Warning::to_string).collect())
}

/// A reading without warnings.
fn clean(text: &str) -> Pslg {
    let (pslg, warnings) = outline(text);
    assert_eq!(warnings, [""; 0]);
    pslg
}

fn error(text: &str) -> String {
    read(text.as_bytes(), "a.obj").expect_err(text).to_string()
}

/// The first line of the message, and the help.
fn rejects(text: &str, message: &str, help: &str) {
    let error = error(text);
    assert_eq!(error.lines().next(), Some(message), "{error}");
    let found = error.lines().find_map(|line| line.strip_prefix("help: ")).unwrap_or_default();
    assert_eq!(found, help, "{error}");
}

fn group(tag: Tag, name: &str) -> Group {
    Group { dim: 1, tag, name: name.into() }
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const LOOP: [[u32; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];

fn square(tail: &str) -> String {
    SQUARE.to_owned() + tail
}

#[test]
fn a_polyline_is_a_segment_for_each_step() {
    let pslg = clean(&square("l 1 2 3 4 1\n"));
    assert_eq!(pslg.segments, LOOP);
    assert_eq!(pslg.points, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(pslg.segment_tags, [0; 4]);
    assert_eq!(pslg.source.point_lines, [1, 2, 3, 4]);
    assert_eq!(pslg.source.segment_lines, [5; 4]);
    assert_eq!(pslg.source.point_number(3), 4);
    assert_eq!(pslg.enclosed, Enclosed::EvenOdd);
}

#[test]
fn negative_numbers_count_back_from_the_last_vertex() {
    assert_eq!(clean(&square("l -4 -3 -2 -1 -4\n")).segments, LOOP);
    let text = "v 0 0\nv 1 0\nl -2 -1\nv 1 1\nl -2 -1\nl 3 1\n";
    assert_eq!(clean(text).segments, [[0, 1], [1, 2], [2, 0]]);
}

#[test]
fn a_backslash_joins_lines_also_before_crlf_and_at_a_word() {
    for tail in ["l 1 2 \\\n 3 4 \\\n 1\n", "l 1 2 \\\r\n3 4\\\r\n\t1\r\n", "l 1 2 3 4\\\n\\\n 1"] {
        assert_eq!(clean(&square(tail)).segments, LOOP, "{tail}");
    }
    // What is passed over is passed over whole; a comment ends with its line.
    let tail = "s 1 \\\n 2\n# C:\\drawings\\\nl 1 2 3 4 1\n";
    assert_eq!(clean(&square(tail)).segments, LOOP);
    // The place of a segment is that of its second end.
    assert_eq!(clean(&square("l 1 2 \\\n 3 4\n")).source.segment_lines, [5, 6, 6]);
}

#[test]
fn textures_normals_colours_and_weights_are_passed_over() {
    let text = "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1\nv 1 1 0 1 .5 .5 .5\nvt 0 0\nvn 0 0 1\n\
                l 1/1 2/1/1 3//1 1/\n";
    assert_eq!(clean(text).segments, [[0, 1], [1, 2], [2, 0]]);
}

#[test]
fn vertices_may_come_after_the_lines_that_name_them() {
    assert_eq!(clean(&format!("l 1 2 3 4 1\n{SQUARE}")).segments, LOOP);
    rejects(
        &format!("l 1 2 3 5\n{SQUARE}"),
        "a.obj:1:9: expected the number of a vertex (1 to 4), found `5`",
        "",
    );
}

#[test]
fn vertices_that_are_not_there_are_named() {
    let known = "expected the number of a vertex (1 to 4, or -1 to -4)";
    let help = "vertices count from 1, or from -1 backwards";
    rejects(&square("l 0 1\n"), &format!("a.obj:5:3: {known}, found `0`"), help);
    rejects(&square("l 1 -5\n"), &format!("a.obj:5:5: {known}, found `-5`"), "");
    let huge = "18446744073709551617";
    rejects(&square(&format!("l 1 {huge}\n")), &format!("a.obj:5:5: {known}, found `{huge}`"), "");
    for word in ["1/x", "1/1/1/1", "/1", "1.0", "x", "-9223372036854775808"] {
        let message = format!("a.obj:5:3: {known}, found `{word}`");
        rejects(&square(&format!("l {word} 2\n")), &message, "");
    }
}

#[test]
fn a_line_of_one_vertex_is_an_error() {
    let message = "a.obj:5:4: expected the second vertex of a line, found the end of the line";
    rejects(&square("l 1\nl 1 2 3 4 1\n"), message, "");
}

#[test]
fn groups_are_numbered_as_segments_use_them() {
    let pslg = clean(&square(
        "g unused\ng Außen kontur  mit Leerzeichen \nl 1 2\no Loch # 2\nl 2 3\n\
         g Außen kontur  mit Leerzeichen\nl 3 4\ng\nl 4 1\n",
    ));
    assert_eq!(pslg.segment_tags, [1, 2, 1, 0]);
    let names = [group(1, "Außen kontur  mit Leerzeichen"), group(2, "Loch # 2")];
    assert_eq!(pslg.groups, names);
}

#[test]
fn materials_tell_segments_of_one_group_apart() {
    let alone = clean(&square("usemtl steel\nl 1 2 3\nusemtl air\nl 3 4 1\n"));
    assert_eq!(alone.segment_tags, [1, 1, 2, 2]);
    assert_eq!(alone.groups, [group(1, "steel"), group(2, "air")]);
    let text = "o a\nusemtl steel\nl 1 2\nusemtl air\nl 2 3\no b\nl 3 4 1\n";
    let both = clean(&square(text));
    assert_eq!(both.segment_tags, [1, 2, 3, 3]);
    assert_eq!(both.groups, [group(1, "a/steel"), group(2, "a/air"), group(3, "b")]);
}

#[test]
fn stated_names_are_numbers() {
    let pslg =
        clean(&square("g wall\nl 1 2\ng boundary_-7\nl 2 3\ng door 2 boundary_1\nl 3 4 1\n"));
    assert_eq!(pslg.segment_tags, [2, -7, 1, 1]);
    assert_eq!(pslg.groups, [group(2, "wall"), group(1, "door 2")]);
}

#[test]
fn vertices_without_a_polyline_are_left_out_but_free_points_are_kept() {
    let (pslg, warnings) =
        outline("v 9 9 9\nv 8 8 8\nv 0 0\nv 1 0\nv 0 1\nv .2 .2\nl 3 4 5 3\np 6\n");
    assert_eq!(pslg.points, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.2, 0.2]]);
    assert_eq!(pslg.segments, [[0, 1], [1, 2], [2, 0]]);
    assert_eq!(pslg.source.point_number(0), 3);
    assert_eq!(pslg.source.point_lines, [3, 4, 5, 6]);
    assert_eq!(warnings, ["a.obj:1: 2 vertices are used by no polyline and left out"]);
}

#[test]
fn a_plane_along_two_axes_is_dropped_bit_for_bit() {
    let (pslg, warnings) = outline("v 0 .4 .1\nv 1 .4 0\nv 0 .4 1\nl 1 2 3 1\n");
    assert_eq!(pslg.points, [[0.0, 0.1], [1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(warnings, ["a.obj:1: all vertices have y = 0.4; it is dropped"]);
    let (pslg, warnings) = outline("v 3 .1 0\nv 3 0 1\nv 3 1 0\nl 1 2 3 1\n");
    assert_eq!(pslg.points, [[0.1, 0.0], [0.0, 1.0], [1.0, 0.0]]);
    assert_eq!(warnings, ["a.obj:1: all vertices have x = 3; it is dropped"]);
    let (pslg, warnings) = outline("v 0 0 1e-6\nv 1 0 0\nv 0 1 -2e-6\nl 1 2 3 1\n");
    assert_eq!(pslg.points, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(warnings, ["a.obj:1: all vertices have z = -0.000002 to 0.000001; it is dropped"]);
}

#[test]
fn a_tilted_outline_is_drawn_in_its_plane() {
    // A square of side √2, turned by 45° about the x axis, and then some.
    let text = "v 0 0 0\nv 2 1 1\nv 2 2 2\nv 0 1 1\nl 1 2 3 4 1\n";
    let (pslg, warnings) = outline(text);
    let root = 2.0_f64.sqrt();
    for (point, expected) in
        pslg.points.iter().zip([[0.0, 0.0], [2.0, root], [2.0, 2.0 * root], [0.0, root]])
    {
        let far = (point[0] - expected[0]).hypot(point[1] - expected[1]);
        assert!(far < 1e-15, "{point:?}");
    }
    let said = "a.obj:1: all vertices lie in one plane, tilted to all axes (its normal is \
                -0.000000 -0.707107 0.707107); the outline is drawn in that plane";
    assert_eq!(warnings, [said.replace("-0.000000", "0.000000")]);
}

#[test]
fn an_outline_in_space_names_a_vertex_that_is_off() {
    rejects(
        "v 0 0 0\nv 1 0 0.5\nv 1 1 0\nv 0 1 2\nl 1 2 3 4 1\n",
        "a.obj:4:1: expected vertices in one plane, found vertex 4, which is 2.000e0 off the \
         plane of the others",
        "an outline is flat: export a drawing in one plane",
    );
    let huge = "v 0 0 0\nv 1e305 0 1e305\nv 1e305 1e305 0\nl 1 2 3 1\n";
    let message = "a.obj:2:1: expected coordinates up to 1e300, for the plane is tilted, found `v`";
    rejects(huge, message, "");
}

#[test]
fn faces_are_passed_over_or_asked_for() {
    let text = square("f 1 2 3 4\n");
    rejects(
        &text,
        "a.obj:5:10: expected a polyline (`l`), found the end of the file",
        "there is a face (`f`, line 5); --faces takes their outlines",
    );
    let (_, warnings) = outline(&(text.clone() + "l 1 2 3 1\n f 1 2 3\n"));
    assert_eq!(warnings[0], "a.obj:5: 2 faces are passed over; --faces takes their outlines");
    let (pslg, _) = with_faces(&text);
    assert_eq!(pslg.segments, LOOP);
}

fn with_faces(text: &str) -> (Pslg, Vec<Warning>) {
    read_with(text.as_bytes(), "a.obj", Options { faces: true }).expect(text)
}

#[test]
fn of_faces_only_the_edges_of_one_face_are_taken_wherever_their_vertices_are() {
    // Two triangles of a square, each with its own vertices.
    let text = square("v 0 0 -0\nv 1 1 0\ng a\nf 1 2 3\ng b\nf 5 6 4\n");
    let (pslg, _) = with_faces(&text);
    assert_eq!(pslg.segments, [[0, 1], [1, 2], [5, 3], [3, 4]]);
    assert_eq!(pslg.segment_tags, [1, 1, 2, 2]);
    let twice = square("f 1 2 3 4\nf 4 3 2 1\n");
    let error = read_with(twice.as_bytes(), "a.obj", Options { faces: true }).unwrap_err();
    let expected = "a polyline (`l`), or an edge that belongs to one face (`f`)";
    assert_eq!(error.expected, expected);
}

#[test]
fn statements_that_are_none_are_errors_and_curves_are_passed_over() {
    rejects(
        "# a comment\nvertex 1 2 3\n",
        "a.obj:2:1: expected an OBJ statement, found `vertex`",
        "an outline is made of `v` and `l`, or of `v` and `f`",
    );
    rejects("v 1 zero 0\n", "a.obj:1:5: expected a y coordinate, found `zero`", "");
    rejects("", "a.obj:1:1: expected a polyline (`l`), found the end of the file", "");
    let (_, warnings) = outline(&square("cstype bezier\ncurv 0 1 1 2\nl 1 2 3 1\nend\n"));
    let said = "a.obj:5: 3 statements of free-form curves or surfaces passed over";
    assert_eq!(warnings[0], said);
}

/// What is written of an outline, and the notes.
fn written(pslg: &Pslg) -> (String, Vec<String>) {
    let mut text = Vec::new();
    let notes = write_outline(pslg, &mut text).expect("memory takes all");
    let notes = notes.iter().map(ToString::to_string).collect();
    (String::from_utf8(text).expect("text"), notes)
}

#[test]
fn names_are_written_with_their_numbers_where_reading_would_change_them() {
    let mut pslg = clean(&square("l 1 2 3 4 1\n"));
    pslg.segment_tags = vec![1, 1, 2, 3];
    pslg.groups = vec![group(1, "wall"), group(2, "inlet")];
    let groups = |text: &str| {
        text.lines().filter(|l| l.starts_with('g')).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(groups(&written(&pslg).0), ["g wall", "g inlet", "g boundary_3"]);
    pslg.segment_tags = vec![2, 1, 2, -3];
    let expected =
        ["g inlet boundary_2", "g wall boundary_1", "g inlet boundary_2", "g boundary_-3"];
    let text = written(&pslg).0;
    assert_eq!(groups(&text), expected);
    let read = clean(&text);
    assert_eq!(read.segment_tags, pslg.segment_tags);
    assert_eq!(read.groups, [group(2, "inlet"), group(1, "wall")]);
}

#[test]
fn a_backslash_that_ends_a_name_joins_no_lines() {
    let mut pslg = clean(&square("l 1 2 3 4 1\n"));
    pslg.segment_tags = vec![1; 4];
    pslg.groups = vec![group(1, "wall\\")];
    let (text, notes) = written(&pslg);
    assert_eq!(notes, [""; 0]);
    assert_eq!(clean(&text), Pslg { source: clean(&text).source, ..pslg });

    let mesh = crate::Mesh {
        points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        triangles: vec![[0, 1, 2]],
        triangle_tags: vec![1],
        groups: vec![Group { dim: 2, tag: 1, name: "field\\".into() }],
        ..crate::Mesh::default()
    };
    let mut text = Vec::new();
    let notes = write(&mesh, &mut text).expect("memory takes all");
    assert_eq!(String::from_utf8(text).expect("text").lines().nth(3), Some("g field_"));
    assert_eq!(notes.len(), 1);
}

#[test]
fn what_the_format_has_no_place_for_is_told() {
    let mut pslg = clean(&square("l 1 2 3 4 1\n"));
    pslg.holes = vec![[0.5, 0.5]];
    pslg.point_markers = vec![0, 1, 2, 0];
    pslg.point_sizes = vec![1.0; 4];
    let (_, notes) = written(&pslg);
    assert_eq!(
        notes,
        [
            "1 hole seed is not written: the format has no place for it",
            "2 point markers are not written: the format has no place for them",
            "the target sizes of points are not written",
        ]
    );
}
