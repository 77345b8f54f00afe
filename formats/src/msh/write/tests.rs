//! The text and bytes of small files, written out by the manual.

use super::*;
use crate::mesh::{Data, Values};
use crate::pslg::{Group, Membership};

/// Two triangles of a square with a region each, the left one named; the diagonal is in a second
/// group, one corner is a point group.
fn square() -> Mesh {
    let group = |dim, tag, name: &str| Group { dim, tag, name: name.into() };
    Mesh {
        points: vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 0.1]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        triangle_tags: vec![7, 5],
        edges: vec![[0, 1], [0, 2]],
        edge_tags: vec![3, 3],
        groups: vec![group(0, 9, "corner"), group(1, 3, "wall"), group(2, 5, "left \"side\"")],
        memberships: vec![
            Membership { dim: 1, item: 1, tag: 4 },
            Membership { dim: 0, item: 1, tag: 9 },
        ],
        point_data: vec![Data {
            name: "depth".into(),
            components: 1,
            values: Values::Real(vec![1.0, 1.5, 0.1, -2.0]),
        }],
        triangle_data: vec![Data {
            name: "a\"b".into(),
            components: 2,
            values: Values::Integer(vec![1, 2, -3, 4]),
        }],
        ..Mesh::default()
    }
}

fn written(options: Options) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_with(&square(), options, &mut bytes).unwrap();
    bytes
}

fn text(version: Version, order: Order) -> String {
    String::from_utf8(written(Options { version, order, ..Options::default() })).unwrap()
}

const NAMES: &str = "$PhysicalNames\n5\n0 9 \"corner\"\n1 3 \"wall\"\n1 4 \"boundary_4\"\n\
                     2 5 \"left 'side'\"\n2 7 \"region_7\"\n$EndPhysicalNames\n";

#[test]
fn version_2_as_text() {
    let expected = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n{NAMES}\
         $Nodes\n4\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 0.1 0\n$EndNodes\n\
         $Elements\n6\n1 1 2 3 3 1 2\n2 1 2 3 3 1 3\n3 1 2 4 4 1 3\n4 15 2 9 9 2\n\
         5 2 2 7 7 1 2 3\n6 2 2 5 5 1 3 4\n$EndElements\n\
         $NodeData\n1\n\"depth\"\n1\n0\n3\n0\n1\n4\n1 1\n2 1.5\n3 0.1\n4 -2\n$EndNodeData\n\
         $ElementData\n1\n\"a'b\"\n1\n0\n3\n0\n2\n2\n5 1 2\n6 -3 4\n$EndElementData\n"
    );
    assert_eq!(text(Version::V2_2, Order::First), expected);
}

#[test]
fn version_4_as_text() {
    let expected = format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n{NAMES}\
         $Entities\n1 2 2 0\n1 2 0 0 1 9\n3 0 0 0 2 0 0 1 3 0\n1 0 0 0 2 2 0 2 3 4 0\n\
         7 0 0 0 2 2 0 1 7 0\n5 0 0 0 2 2 0 1 5 0\n$EndEntities\n\
         $Nodes\n4 4 1 4\n0 1 0 1\n2\n2 0 0\n1 3 0 1\n1\n0 0 0\n1 1 0 1\n3\n2 2 0\n\
         2 5 0 1\n4\n0 0.1 0\n$EndNodes\n\
         $Elements\n5 5 1 5\n0 1 15 1\n3 2\n1 3 1 1\n1 1 2\n1 1 1 1\n2 1 3\n2 7 2 1\n4 1 2 3\n\
         2 5 2 1\n5 1 3 4\n$EndElements\n\
         $NodeData\n1\n\"depth\"\n1\n0\n3\n0\n1\n4\n1 1\n2 1.5\n3 0.1\n4 -2\n$EndNodeData\n\
         $ElementData\n1\n\"a'b\"\n1\n0\n3\n0\n2\n2\n4 1 2\n5 -3 4\n$EndElementData\n"
    );
    assert_eq!(text(Version::V4_1, Order::First), expected);
}

#[test]
fn an_edge_may_be_in_one_group_alone() {
    for version in [Version::V2_2, Version::V4_1] {
        let options = Options { version, one_group: true, ..Options::default() };
        let mut text = Vec::new();
        let notes = write_with(&square(), options, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(!text.contains("corner") && !text.contains("boundary_4"), "{text}");
        let elements = text.split("$Elements\n").nth(1).unwrap();
        let count = if version == Version::V2_2 { "4\n" } else { "3 4 1 4\n" };
        assert!(elements.starts_with(count), "{text}");
        let said: Vec<String> = notes.iter().map(Note::to_string).collect();
        assert!(said.contains(&"the point group `corner` is not written".to_owned()), "{said:?}");
        let further = "edges keep one group each; 1 further memberships are not written";
        assert!(said.contains(&further.to_owned()), "{said:?}");
    }
}

#[test]
fn second_order_elements_have_the_middles_of_their_sides() {
    let text = text(Version::V2_2, Order::Second);
    let nodes = "$Nodes\n9\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 0.1 0\n5 1 0 0\n6 1 1 0\n7 0 0.05 0\n\
                 8 2 1 0\n9 1 1.05 0\n$EndNodes\n";
    assert!(text.contains(nodes), "{text}");
    let elements = "$Elements\n6\n1 8 2 3 3 1 2 5\n2 8 2 3 3 1 3 6\n3 8 2 4 4 1 3 6\n\
                    4 15 2 9 9 2\n5 9 2 7 7 1 2 3 5 8 6\n6 9 2 5 5 1 3 4 6 9 7\n$EndElements\n";
    assert!(text.contains(elements), "{text}");
    assert!(text.contains("9\n1 1\n2 1.5\n3 0.1\n4 -2\n5 1.25\n6 0.55\n7 -0.5\n8 0.8\n9 -0.95\n"));
}

/// The bytes of a section, between its first line and its last.
fn section<'a>(bytes: &'a [u8], name: &str) -> &'a [u8] {
    let find = |bytes: &[u8], text: String| {
        bytes.windows(text.len()).position(|window| window == text.as_bytes()).unwrap()
    };
    let start = find(bytes, format!("${name}\n")) + name.len() + 2;
    &bytes[start..start + find(&bytes[start..], format!("\n$End{name}\n"))]
}

fn ints(values: &[i32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn sizes(values: &[u64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn reals(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

#[test]
fn version_2_as_bytes() {
    let bytes = written(Options { binary: true, ..Options::default() });
    assert_eq!(section(&bytes, "MeshFormat"), [b"2.2 1 8\n".to_vec(), ints(&[1])].concat());
    let node = |number, x, y| [ints(&[number]), reals(&[x, y, 0.0])].concat();
    let nodes = [b"4\n".to_vec(), node(1, 0.0, 0.0), node(2, 2.0, 0.0), node(3, 2.0, 2.0)];
    assert_eq!(section(&bytes, "Nodes"), [nodes.concat(), node(4, 0.0, 0.1)].concat());
    let elements = [
        [1, 2, 2].as_slice(),
        &[1, 3, 3, 1, 2],
        &[2, 3, 3, 1, 3],
        &[1, 1, 2],
        &[3, 4, 4, 1, 3],
        &[15, 1, 2],
        &[4, 9, 9, 2],
        &[2, 2, 2],
        &[5, 7, 7, 1, 2, 3],
        &[6, 5, 5, 1, 3, 4],
    ];
    let elements = [b"6\n".to_vec(), ints(&elements.concat())].concat();
    assert_eq!(section(&bytes, "Elements"), elements);
    let head = b"1\n\"a'b\"\n1\n0\n3\n0\n2\n2\n".to_vec();
    let data = [head, ints(&[5]), reals(&[1.0, 2.0]), ints(&[6]), reals(&[-3.0, 4.0])];
    assert_eq!(section(&bytes, "ElementData"), data.concat());
}

#[test]
fn version_4_as_bytes() {
    let bytes = written(Options { version: Version::V4_1, binary: true, ..Options::default() });
    assert_eq!(section(&bytes, "MeshFormat"), [b"4.1 1 8\n".to_vec(), ints(&[1])].concat());
    let entity = |number, bounds: &[f64], groups: &[i32], bounded: &[u64]| {
        let count = sizes(&[groups.len() as u64]);
        [ints(&[number]), reals(bounds), count, ints(groups), sizes(bounded)].concat()
    };
    let entities = [
        sizes(&[1, 2, 2, 0]),
        entity(1, &[2.0, 0.0, 0.0], &[9], &[]),
        entity(3, &[0.0, 0.0, 0.0, 2.0, 0.0, 0.0], &[3], &[0]),
        entity(1, &[0.0, 0.0, 0.0, 2.0, 2.0, 0.0], &[3, 4], &[0]),
        entity(7, &[0.0, 0.0, 0.0, 2.0, 2.0, 0.0], &[7], &[0]),
        entity(5, &[0.0, 0.0, 0.0, 2.0, 2.0, 0.0], &[5], &[0]),
    ];
    assert_eq!(section(&bytes, "Entities"), entities.concat());
    let block = |dim, number, node, x, y| {
        [ints(&[dim, number, 0]), sizes(&[1, node]), reals(&[x, y, 0.0])].concat()
    };
    let nodes = [
        sizes(&[4, 4, 1, 4]),
        block(0, 1, 2, 2.0, 0.0),
        block(1, 3, 1, 0.0, 0.0),
        block(1, 1, 3, 2.0, 2.0),
        block(2, 5, 4, 0.0, 0.1),
    ];
    assert_eq!(section(&bytes, "Nodes"), nodes.concat());
    let block =
        |head: [i32; 3], element: &[u64]| [ints(&head), sizes(&[1]), sizes(element)].concat();
    let elements = [
        sizes(&[5, 5, 1, 5]),
        block([0, 1, 15], &[3, 2]),
        block([1, 3, 1], &[1, 1, 2]),
        block([1, 1, 1], &[2, 1, 3]),
        block([2, 7, 2], &[4, 1, 2, 3]),
        block([2, 5, 2], &[5, 1, 3, 4]),
    ];
    assert_eq!(section(&bytes, "Elements"), elements.concat());
}

#[test]
fn nodes_without_a_cell_lie_on_a_surface() {
    let mesh = Mesh { points: vec![[1.0, 2.0], [3.0, 0.0]], ..Mesh::default() };
    let mut text = Vec::new();
    let options = Options { version: Version::V4_1, ..Options::default() };
    write_with(&mesh, options, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    assert!(text.contains("$Entities\n0 0 1 0\n1 1 0 0 3 2 0 0 0\n"), "{text}");
    assert!(text.contains("$Nodes\n1 2 1 2\n2 1 0 2\n1\n2\n1 2 0\n3 0 0\n$EndNodes\n"));
    assert!(text.contains("$Elements\n0 0 0 0\n$EndElements\n"));
}

#[test]
fn whole_numbers_that_are_rounded_are_said() {
    let mut mesh = square();
    mesh.triangle_data[0].name = "id".to_owned();
    mesh.triangle_data[0].values = Values::Integer(vec![1 << 53, (1 << 53) + 1, i64::MIN, 0]);
    let said = |mesh: &Mesh| -> Vec<String> {
        write(mesh, &mut Vec::new()).unwrap().iter().map(Note::to_string).collect()
    };
    let rounded = "some of the data `id` are rounded: whole numbers above 2^53".to_owned();
    assert!(said(&mesh).contains(&rounded));
    mesh.triangle_data[0].values = Values::Integer(vec![1 << 53, 1 << 54, i64::MIN, 0]);
    assert!(!said(&mesh).contains(&rounded));
}
