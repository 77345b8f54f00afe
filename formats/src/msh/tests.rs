//! What `.msh` files of other programs look like, and what is refused.

mod binary;

use super::read;
use crate::error::Warning;
use crate::mesh::Mesh;
use crate::pslg::{Group, Membership};

const HEAD: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const NODES: &str = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";

fn good(text: &str) -> (Mesh, Vec<String>) {
    let (mesh, warnings) = read(text.as_bytes(), "a.msh").unwrap_or_else(|e| panic!("{e}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
}

/// The first line of the message.
fn error(text: &str) -> String {
    let message = read(text.as_bytes(), "a.msh").expect_err("this is wrong").to_string();
    message.lines().next().unwrap_or_default().to_owned()
}

fn elements(lines: &str) -> String {
    let count = lines.lines().count();
    format!("{HEAD}{NODES}$Elements\n{count}\n{lines}$EndElements\n")
}

#[test]
fn nodes_may_be_numbered_in_any_way_and_order() {
    let nodes = "$Nodes\n4\n1 0 0 5\n70 1 0 5\n9 1 1 5\n4000000000 0 1 5\n$EndNodes\n";
    let elements = "$Elements\n2\n9 2 3 7 1 0 1 70 9\n3 1 2 8 1 4000000000 1\n$EndElements\n";
    let (mesh, warnings) = good(&format!("{HEAD}{nodes}{elements}"));
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
    assert_eq!(mesh.triangle_tags, [7]);
    assert_eq!(mesh.edges, [[3, 0]]);
    assert_eq!(mesh.edge_tags, [8]);
    assert_eq!(warnings, ["a.msh:6: all nodes have z = 5; it is dropped"]);
}

#[test]
fn names_may_hold_spaces() {
    let names = "$PhysicalNames\n2\n1 3 \"rand außen \"\n2  7\t\"\" \n$EndPhysicalNames\n";
    let text = elements("1 2 2 7 7 1 2 3\n").replace("$Nodes", &format!("{names}$Nodes"));
    let group = |dim, tag, name: &str| Group { dim, tag, name: name.into() };
    assert_eq!(good(&text).0.groups, [group(1, 3, "rand außen "), group(2, 7, "")]);
}

#[test]
fn points_with_a_number_are_in_a_group() {
    let (mesh, _) = good(&elements("1 15 2 9 1 2\n2 15 2 0 1 3\n3 2 0 1 2 3\n"));
    assert_eq!(mesh.memberships, [Membership { dim: 0, item: 1, tag: 9 }]);
    assert_eq!(mesh.triangle_tags, [0]);
}

#[test]
fn an_edge_that_is_there_again_is_in_a_further_group() {
    let lines = "1 1 2 5 1 1 2\n2 1 2 6 1 2 1\n3 1 2 7 1 2 3\n4 1 2 7 1 2 3\n5 1 2 8 1 3 1\n\
                 6 1 2 9 1 3 1\n7 2 2 4 1 1 2 3\n";
    let (mesh, _) = good(&elements(lines));
    assert_eq!(mesh.edges, [[0, 1], [1, 2], [2, 0]]);
    assert_eq!(mesh.edge_tags, [5, 7, 8]);
    let further = |item, tag| Membership { dim: 1, item, tag };
    assert_eq!(mesh.memberships, [further(0, 6), further(2, 9)]);
}

#[test]
fn memberships_are_written_as_elements_and_read_back() {
    let (mut mesh, _) = good(&elements("1 1 2 5 1 1 2\n2 2 2 4 1 1 2 3\n"));
    let group = |dim, tag, name: &str| Group { dim, tag, name: name.into() };
    mesh.groups = vec![group(0, 3, "corner"), group(1, 5, "wall")];
    mesh.memberships =
        vec![Membership { dim: 0, item: 2, tag: 3 }, Membership { dim: 1, item: 0, tag: 8 }];
    let mut text = Vec::new();
    crate::msh::write(&mesh, &mut text).unwrap();
    let (again, _) = good(std::str::from_utf8(&text).unwrap());
    assert_eq!(again.memberships, mesh.memberships);
    let names = [(0, 3, "corner"), (1, 5, "wall"), (1, 8, "boundary_8"), (2, 4, "region_4")];
    assert_eq!(again.groups, names.map(|(dim, tag, name)| group(dim, tag, name)));
}

#[test]
fn orientation_is_kept() {
    assert_eq!(good(&elements("1 2 2 7 7 3 2 1\n")).0.triangles, [[2, 1, 0]]);
}

#[test]
fn other_sections_are_skipped_and_said() {
    let text = elements("1 2 2 7 7 1 2 3\n");
    let comments = "$Comments\nabc $Nodes\n$EndComments\n";
    let data = "$Periodic\n1\n$EndPeriodic\n";
    let (mesh, warnings) =
        good(&format!("{}{data}", text.replace("$Nodes", &format!("{comments}$Nodes"))));
    assert_eq!(mesh.triangles.len(), 1);
    assert_eq!(warnings, ["a.msh:17: section `$Periodic` is ignored"]);
}

#[test]
fn errors_name_their_word() {
    let expected = [
        (String::new(), "1:1: expected $MeshFormat, found the end of the file"),
        ("$NOD\n3\n".into(), "1:1: expected $MeshFormat, found `$NOD`"),
        ("$MeshFormat\n4 0 8\n".into(), "2:1: expected version 2.2 or 4.1, found `4`"),
        (
            "$MeshFormat\n2.2 2 8\n".into(),
            "2:5: expected file type 0 (text) or 1 (binary), found `2`",
        ),
        (HEAD.into(), "3:15: expected section $Nodes, found the end of the file"),
        (format!("{HEAD}{NODES}"), "9:10: expected section $Elements, found the end of the file"),
        (
            format!("{HEAD}$Nodes\n4000000000\n1 0 0 0\n"),
            "6:8: expected node 2 of 4000000000, found the end of the file",
        ),
        (
            format!("{HEAD}{NODES}").replace("3 0 1 0", "1 0 1 0"),
            "8:1: expected a node with a new number, found `1`",
        ),
        (
            format!("{HEAD}{NODES}").replace("2 1 0 0", "5 1 0 0").replace("3 0", "5 0"),
            "8:1: expected a node with a new number, found `5`",
        ),
        (
            format!("{HEAD}{NODES}").replace("3 0 1 0", "3 0 1 .5"),
            "8:7: expected z = 0, as in the first node, found `.5`",
        ),
        (
            format!("{HEAD}{NODES}").replace("3 0 1 0", "0 0 1 0"),
            "8:1: expected the number of a node, found `0`",
        ),
        (format!("{HEAD}{NODES}{NODES}"), "10:1: expected one section $Nodes, found `$Nodes`"),
        (
            format!("{HEAD}$Elements\n"),
            "4:1: expected section $Nodes before the elements, found `$Elements`",
        ),
        (format!("{HEAD}nodes\n"), "4:1: expected a section, `$` and its name, found `nodes`"),
        (format!("{HEAD}$Foo\n1\n"), "5:2: expected $EndFoo, found the end of the file"),
        (
            elements("1 3 2 7 7 1 2 3 1\n"),
            "12:3: expected an element's type: 1 (line), 2 (triangle) or 15 (point), found `3`",
        ),
        (elements("1 2 2 7 7 1 2 4\n"), "12:15: expected the number of a node, found `4`"),
        (
            elements("1 2 2 7 7 1 2\n"),
            "12:14: expected the number of a node, found the end of the line",
        ),
        (elements("1 2 2 7 7 1 2 3 3\n"), "12:17: expected the end of the line, found `3`"),
        (elements("1 2 -1 1 2 3\n"), "12:5: expected the number of tags (0 to 1000), found `-1`"),
        (
            elements("1 1 2 7 7 1 2\n").replace("\n1\n1 1", "\n2\n1 1"),
            "13:1: expected the number of an element, found `$EndElements`",
        ),
    ];
    for (text, message) in expected {
        assert_eq!(error(&text), format!("a.msh:{message}"), "{text}");
    }
}
