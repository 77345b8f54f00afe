//! Legacy `.vtk` files of other programs, and what is refused.

use super::read;
use crate::mesh::{Mesh, Values};

const HEAD: &str = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\n";
const POINTS: &str = "POINTS 4 float\n0 0 5\n1 0 5 1 1 5 0 1 5\n";
const CELLS: &str = "CELLS 3 11\n2 0 1\n3 0 1 2\n3 0 2 3\nCELL_TYPES 3\n3 5\n5\n";

fn good(text: &str) -> Mesh {
    read(text.as_bytes(), "a.vtk").unwrap_or_else(|error| panic!("{error}")).0
}

/// The first line of the message.
fn error(text: &str) -> String {
    let message = read(text.as_bytes(), "a.vtk").expect_err("this is wrong").to_string();
    message.lines().next().unwrap_or_default().to_owned()
}

#[test]
fn numbers_stand_in_any_lines_and_the_title_may_be_empty() {
    let (mesh, warnings) =
        read(format!("{HEAD}{POINTS}{CELLS}").as_bytes(), "a.vtk").expect("good");
    assert_eq!(mesh.points, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(
        (&mesh.edges[..], &mesh.triangles[..]),
        (&[[0, 1]][..], &[[0, 1, 2], [0, 2, 3]][..])
    );
    assert_eq!(warnings[0].to_string(), "a.vtk: all nodes have z = 5; it is dropped");
}

#[test]
fn names_are_decoded_and_tags_found_in_fields_and_scalars() {
    let data = "CELL_DATA 3\nSCALARS tag int\nLOOKUP_TABLE default\n5 7 8\n\
                FIELD FieldData 1\nhot%20water%25 2 3 double\n1 2 3 4 nan 6\n\
                POINT_DATA 4\nVECTORS v float\n0 0 0 1 1 1 2 2 2 3 3 3\n";
    let mesh = good(&format!("{HEAD}{POINTS}{CELLS}{data}"));
    assert_eq!((&mesh.edge_tags[..], &mesh.triangle_tags[..]), (&[5][..], &[7, 8][..]));
    assert_eq!(mesh.triangle_data[0].name, "hot water%");
    let Values::Real(values) = &mesh.triangle_data[0].values else { panic!("real numbers") };
    assert_eq!(values[..2], [3.0, 4.0]);
    assert!(values[2].is_nan());
    assert_eq!((mesh.point_data[0].name.as_str(), mesh.point_data[0].components), ("v", 3));
}

#[test]
fn fields_of_the_whole_name_groups() {
    let field = "FIELD FieldData 2\nnothing 0 0 int\nwet%20wall 2 1 vtktypeint64\n5 1\n";
    let data = "CELL_DATA 3\nFIELD FieldData 1\ntag 1 3 int\n5 7 8\n";
    let mesh = good(&format!("{HEAD}{field}{POINTS}{CELLS}{data}"));
    let [group] = &mesh.groups[..] else { panic!("one group") };
    assert_eq!((group.dim, group.tag, group.name.as_str()), (1, 5, "wet wall"));
}

#[test]
fn polylines_are_edges_and_polygons_triangles() {
    let head = HEAD.replace("UNSTRUCTURED_GRID", "POLYDATA");
    let mesh = good(&format!("{head}{POINTS}LINES 1 4\n3 0 1 2\nPOLYGONS 1 4\n3 0 1 2\n"));
    assert_eq!((&mesh.edges[..], &mesh.triangles[..]), (&[[0, 1], [1, 2]][..], &[[0, 1, 2]][..]));
}

#[test]
fn errors_name_their_word() {
    let all = format!("{HEAD}{POINTS}{CELLS}");
    let cases = [
        (
            String::new(),
            "1:1: expected the line `# vtk DataFile Version 3.0`, found the end of the file",
        ),
        (
            "# vtk DataFile Version 6.0\n".into(),
            "1:24: expected a version from 1 to 5, found `6.0`",
        ),
        (HEAD.replace("ASCII", "HEX"), "3:1: expected ASCII or BINARY, found `HEX`"),
        (
            HEAD.replace("UNSTRUCTURED_GRID", "STRUCTURED_POINTS"),
            "4:9: expected UNSTRUCTURED_GRID or POLYDATA, found `STRUCTURED_POINTS`",
        ),
        (HEAD.into(), "4:26: expected POINTS, found the end of the file"),
        (all.replace("POINTS 4", "POINTS 4000000000"), "8:1: expected a number, found `CELLS`"),
        (all.replace("1 0 5 1", "1 0 4 1"), "7:5: expected the same z for all points, found `4`"),
        (all.replace("1 0 5 1", "nan 0 5 1"), "7:1: expected a finite number, found `nan`"),
        (all.replace("3 0 1 2", "3 0 1 4"), "10:7: expected a point, found `4`"),
        (all.replace("2 0 1", "2 -1 1"), "9:3: expected a point, found `-1`"),
        (
            all.replace("CELLS 3 11", "CELLS 3 12"),
            "12:1: expected a whole number, found `CELL_TYPES`",
        ),
        (
            all.replace("CELLS 3 11", "CELLS 4 11"),
            "8:9: expected 4 cells, each with the number of its nodes before them, found `11`",
        ),
        (
            all.replace("CELLS 3 11", "CELLS 2 11"),
            "8:9: expected 7 numbers for 2 cells, found `11`",
        ),
        (
            all.replace("\n3 5\n5\n", "\n3 5\n9\n"),
            "14:1: expected 3 (line), 5 (triangle) or 1 (vertex), found `9`",
        ),
        (
            all.replace("CELL_TYPES 3\n3 5\n5\n", ""),
            "11:8: expected CELL_TYPES of 3 cells instead of 0, found the end of the file",
        ),
        (format!("{all}CELL_DATA 4\n"), "15:11: expected the number of cells, 3, found `4`"),
        (
            format!("{all}CELL_DATA 3\nSCALARS tag string\n"),
            "16:13: expected a type of numbers: double, float, int, vtktypeint64 …, found `string`",
        ),
        (
            format!("{all}CELL_DATA 3\nSCALARS tag long\n1 2 3000000000\n"),
            "17:5: expected a whole number of 32 bits, found `3000000000`",
        ),
    ];
    for (text, message) in cases {
        assert_eq!(error(&text), format!("a.vtk:{message}"), "{text}");
    }
}

#[test]
fn binary_files_name_the_byte() {
    let mut bytes =
        b"# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 2 float\n".to_vec();
    bytes.extend([0.0_f32, 0.0, 0.0, f32::NAN, 0.0, 0.0].iter().flat_map(|x| x.to_be_bytes()));
    let message = read(&bytes, "a.vtk").expect_err("this is wrong").to_string();
    assert_eq!(message, "a.vtk: byte 80: expected a finite number, found `NaN`");
    let message = read(&bytes[..90], "a.vtk").expect_err("this is cut").to_string();
    assert_eq!(message, "a.vtk: byte 68: expected 6 numbers of 4 bytes, found the end of the file");
}
