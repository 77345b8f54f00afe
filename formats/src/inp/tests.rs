//! Input files as users write them, and what is refused.

use super::{read, write_with};
use crate::error::Warning;
use crate::mesh::Mesh;
use crate::nodes::Order;
use crate::pslg::Membership;

const MESH: &str = "** a square\n*Heading\n a title, 3\n*NODE, NSET=NALL\n1, 0, 0, 0\n2,1.,0,0\n\
                    30, 1, 1\n4, 0, 1, 0.\n*Element, type=CPS3, elset=EALL\n1, 1, 2, 30\n\
                    2, 1, 30, 4\n*ELEMENT, TYPE=T3D2, ELSET=wall\n11, 1, 2\n\
                    *ELSET, ELSET=steel\n1,\n*ELSET, ELSET=region_8\n2\n\
                    *SURFACE, NAME=outlet, TYPE=ELEMENT\n2, S2\n2, S3\n*NSET, NSET=Outlet\n30, 4, 1\n\
                    *NSET, NSET=corner\n30\n*STEP\n*STATIC\n0.1, 1\n*END STEP\n";

fn good(text: &str) -> (Mesh, Vec<String>) {
    let (mesh, warnings) = read(text.as_bytes(), "a.inp").unwrap_or_else(|e| panic!("{e}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
}

/// The first line of the message for the file with a part replaced.
fn error(part: &str, by: &str) -> String {
    let text = MESH.replacen(part, by, 1);
    let message = read(text.as_bytes(), "a.inp").expect_err("this is wrong").to_string();
    message.lines().next().unwrap_or_default().to_owned()
}

fn groups(mesh: &Mesh) -> Vec<(u8, i32, &str)> {
    mesh.groups.iter().map(|group| (group.dim, group.tag, group.name.as_str())).collect()
}

#[test]
fn sets_and_surfaces_are_groups() {
    let (mesh, warnings) = good(MESH);
    assert_eq!(mesh.points, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(mesh.triangle_tags, [1, 8]);
    assert_eq!(
        (&mesh.edges[..], &mesh.edge_tags[..]),
        (&[[0, 1], [2, 3], [3, 0]][..], &[2, 3, 3][..])
    );
    assert_eq!(mesh.memberships, [Membership { dim: 0, item: 2, tag: 4 }]);
    let expected = [(2, 1, "steel"), (1, 2, "wall"), (1, 3, "outlet"), (0, 4, "corner")];
    assert_eq!(groups(&mesh), expected);
    let skipped = "*END STEP, *HEADING, *STATIC, *STEP";
    assert_eq!(warnings, [format!("a.inp: 4 statements without effect on this mesh: {skipped}")]);
}

#[test]
fn all_sides_between_two_regions_are_those_of_the_smaller_number() {
    // Two squares side by side, cut the other way round; the weir between them runs up and on.
    let points = vec![
        [0., 0.],
        [1., 0.],
        [2., 0.],
        [0., 1.],
        [1., 1.],
        [2., 1.],
        [0., 2.],
        [1., 2.],
        [2., 2.],
    ];
    let mesh = Mesh {
        points,
        triangles: vec![
            [1, 2, 4],
            [2, 5, 4],
            [0, 1, 3],
            [1, 4, 3],
            [3, 4, 6],
            [4, 7, 6],
            [4, 5, 7],
            [5, 8, 7],
        ],
        triangle_tags: vec![9, 9, 4, 4, 4, 4, 9, 9],
        edges: vec![[1, 4], [7, 4], [4, 3]],
        edge_tags: vec![1, 1, 2],
        ..Mesh::default()
    };
    let mut text = Vec::new();
    write_with(&mesh, Order::First, &mut text).expect("a vector takes all");
    let text = String::from_utf8(text).expect("text");
    assert!(text.contains("NAME=boundary_1, TYPE=ELEMENT\n4, S1\n6, S1\n"), "{text}");
    assert!(text.contains("NAME=boundary_2, TYPE=ELEMENT\n4, S2\n"), "{text}");
}

#[test]
fn ranges_and_sets_of_sets_are_followed() {
    let sets = "*ELSET, ELSET=low, GENERATE\n1, 1000000000000, 1\n*ELSET, ELSET=steel\n";
    let (mesh, warnings) =
        good(&MESH.replace("*ELSET, ELSET=steel\n1,\n", &format!("{sets}low\n")));
    assert_eq!(mesh.triangle_tags, [1, 1], "both are in `low` first");
    assert!(
        warnings[0]
            .ends_with("2 triangles are in more than one set of elements: they keep the first")
    );
    assert_eq!(mesh.memberships.len(), 2, "the line is in `low` and `steel`");
}

#[test]
fn the_set_of_the_elements_counts_where_there_is_no_other() {
    let text = MESH.replace("EALL", "rock").replace("*ELSET, ELSET=steel\n1,\n", "");
    let (mesh, _) = good(&text);
    assert_eq!(mesh.triangle_tags, [1, 8]);
    assert_eq!(groups(&mesh)[0], (2, 1, "rock"));
}

#[test]
fn errors_name_their_word() {
    let cases = [
        ("** a square\n", "1, 2\n", "1:1: expected a keyword: *NODE, *ELEMENT …, found `1`"),
        ("2,1.,0,0", "1,1.,0,0", "6:1: expected a node with a new number, found `1`"),
        ("2,1.,0,0", "0,1.,0,0", "6:1: expected the number of a node, 1 or more, found `0`"),
        ("2,1.,0,0", "2,inf,0,0", "6:3: expected an x coordinate, found `inf`"),
        ("2,1.,0,0", "2,1.,0,3", "6:8: expected z = 0, as in the first node, found `3`"),
        ("2,1.,0,0", "2,1.", "6:5: expected a y coordinate, found the end of the line"),
        ("1, 1, 2, 30", "1, 1, 2, 3", "10:10: expected the number of a node, found `3`"),
        (
            "1, 1, 2, 30",
            "1, 1, 2",
            "10:8: expected the number of a node, found the end of the line",
        ),
        (
            "1, 1, 2, 30",
            "1, 1, 2, 30, 4",
            "10:14: expected the end of the line behind 3 nodes, found `4`",
        ),
        ("2, 1, 30, 4", "1, 1, 30, 4", "11:1: expected an element with a new number, found `1`"),
        ("type=CPS3", "type=C3D4", "9:1: expected triangles or lines, found `*Element`"),
        ("type=CPS3", "x", "9:1: expected a keyword with TYPE=, found `*Element`"),
        ("steel\n1", "steel\n7", "15:1: expected the number of an element, found `7`"),
        (
            "steel\n1",
            "steel\niron",
            "15:1: expected the number of an element or the name of a set above, found `iron`",
        ),
        ("2, S2", "2, S4", "19:4: expected a side of triangles: S1, S2 or S3, found `S4`"),
        ("2, S2", "11, S2", "19:1: expected a triangle, found `11`"),
    ];
    for (part, by, message) in cases {
        assert_eq!(error(part, by), format!("a.inp:{message}"));
    }
    let message = read(b"*STEP\n", "a.inp").expect_err("it holds no mesh").to_string();
    assert!(
        message.starts_with("a.inp:1:6: expected *NODE, found the end of the file"),
        "{message}"
    );
}

#[test]
fn every_shorter_file_is_read_or_refused() {
    for length in 0..MESH.len() {
        let _ = read(&MESH.as_bytes()[..length], "a.inp");
    }
}
