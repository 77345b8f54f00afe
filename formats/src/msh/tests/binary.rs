//! Binary `.msh` files of both versions and both orders of bytes, and what is refused in them.

use super::super::read;
use crate::mesh::Mesh;
use crate::pslg::{Membership, Tag};

/// The bytes of numbers, in one order or the other.
struct Bytes {
    is_big_endian: bool,
    bytes: Vec<u8>,
}

impl Bytes {
    fn new(version: &str, is_big_endian: bool) -> Self {
        let mut file = Self { is_big_endian, bytes: Vec::new() };
        file.text(&format!("$MeshFormat\n{version} 1 8\n"));
        file.ints(&[1]);
        file.text("\n$EndMeshFormat\n");
        file
    }

    fn text(&mut self, text: &str) {
        self.bytes.extend(text.bytes());
    }

    fn number<const N: usize>(&mut self, mut bytes: [u8; N]) {
        if self.is_big_endian {
            bytes.reverse();
        }
        self.bytes.extend(bytes);
    }

    fn ints(&mut self, numbers: &[i32]) {
        numbers.iter().for_each(|number| self.number(number.to_le_bytes()));
    }

    fn sizes(&mut self, numbers: &[u64]) {
        numbers.iter().for_each(|number| self.number(number.to_le_bytes()));
    }

    fn reals(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.number(number.to_le_bytes()));
    }
}

const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

/// Two triangles and an edge; the nodes are numbered 10, 20, 30, 40.
fn version2(is_big_endian: bool) -> Vec<u8> {
    let mut file = Bytes::new("2.2", is_big_endian);
    file.text("$Nodes\n4\n");
    for (number, [x, y]) in (1..).zip(POINTS) {
        file.ints(&[10 * number]);
        file.reals(&[x, y, 0.0]);
    }
    file.text("\n$EndNodes\n$Elements\n3\n");
    file.ints(&[1, 1, 2, 1, -5, 1, 10, 20]);
    file.ints(&[2, 2, 2, 2, 7, 1, 10, 20, 30, 3, 8, 1, 10, 30, 40]);
    file.text("\n$EndElements\n");
    file.bytes
}

/// The same mesh; the edge is in groups 5 and 6.
fn version4(is_big_endian: bool) -> Vec<u8> {
    let mut file = Bytes::new("4.1", is_big_endian);
    file.text("$Entities\n");
    file.sizes(&[0, 1, 2, 0]);
    file.ints(&[3]);
    file.reals(&[0.0; 6]);
    file.sizes(&[2]);
    file.ints(&[5, -6]);
    file.sizes(&[0]);
    for (entity, group) in [(1, 7), (2, 8)] {
        file.ints(&[entity]);
        file.reals(&[0.0; 6]);
        file.sizes(&[1]);
        file.ints(&[group]);
        file.sizes(&[1]);
        file.ints(&[3]);
    }
    file.text("\n$EndEntities\n$Nodes\n");
    file.sizes(&[1, 4, 10, 40]);
    file.ints(&[2, 1, 0]);
    file.sizes(&[4, 10, 20, 30, 40]);
    POINTS.iter().for_each(|[x, y]| file.reals(&[*x, *y, 0.0]));
    file.text("\n$EndNodes\n$Elements\n");
    file.sizes(&[3, 3, 1, 3]);
    file.ints(&[1, 3, 1]);
    file.sizes(&[1, 1, 10, 20]);
    file.ints(&[2, 1, 2]);
    file.sizes(&[1, 2, 10, 20, 30]);
    file.ints(&[2, 2, 2]);
    file.sizes(&[1, 3, 10, 30, 40]);
    file.text("\n$EndElements\n");
    file.bytes
}

fn good(bytes: &[u8]) -> Mesh {
    let (mesh, warnings) = read(bytes, "a.msh").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(warnings, []);
    mesh
}

fn error(bytes: &[u8]) -> String {
    read(bytes, "a.msh").expect_err("this is wrong").to_string()
}

/// The file with the part, which is there once, replaced.
fn with(bytes: &[u8], part: &[u8], by: &[u8]) -> Vec<u8> {
    let place = bytes.windows(part.len()).position(|window| window == part);
    let place = place.expect("the part is there");
    [&bytes[..place], by, &bytes[place + part.len()..]].concat()
}

#[test]
fn both_orders_of_bytes_are_read() {
    for is_big_endian in [false, true] {
        for (bytes, edge) in [(version2(is_big_endian), -5), (version4(is_big_endian), 5)] {
            let mesh = good(&bytes);
            assert_eq!(mesh.points, POINTS);
            assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
            assert_eq!(mesh.triangle_tags, [7, 8]);
            assert_eq!((&mesh.edges[..], &mesh.edge_tags[..]), (&[[0, 1]][..], &[edge as Tag][..]));
        }
    }
}

#[test]
fn a_further_group_of_an_entity_is_a_membership() {
    let further = Membership { dim: 1, item: 0, tag: 6 };
    assert_eq!(good(&version4(false)).memberships, [further]);
}

#[test]
fn every_shorter_file_is_refused_with_its_end() {
    for bytes in [version2(false), version2(true), version4(false), version4(true)] {
        for length in 0..bytes.len() - 1 {
            let message = error(&bytes[..length]);
            assert!(message.starts_with("a.msh:"), "{length}: {message}");
            assert!(message.lines().next().is_some_and(|m| m.contains(", found ")), "{message}");
        }
    }
}

#[test]
fn any_byte_may_be_any_other() {
    for bytes in [version2(false), version4(true)] {
        for place in 0..bytes.len() {
            for value in [0, 1, 0x7f, 0x80, 0xff, b'\n', b'$'] {
                let mut changed = bytes.clone();
                changed[place] = value;
                if let Ok((mesh, _)) = read(&changed, "a.msh") {
                    let count = mesh.points.len();
                    assert!(mesh.triangles.iter().flatten().all(|&node| (node as usize) < count));
                    assert!(mesh.points.iter().flatten().all(|x| x.is_finite()));
                }
            }
        }
    }
}

#[test]
fn errors_name_their_byte() {
    let int = |number: i32| number.to_le_bytes();
    let size = |number: u64| number.to_le_bytes();
    let two = version2(false);
    let four = version4(false);
    let cases = [
        (
            with(&two, &int(1), &int(2)),
            "a.msh: byte 20: expected the number 1 in 4 bytes, found `2`",
        ),
        (
            with(
                &two,
                &[int(10), int(20), int(30)].concat(),
                &[int(10), int(21), int(30)].concat(),
            ),
            "a.msh: byte 244: expected the number of a node, found `21`",
        ),
        (
            with(&two, &1.0_f64.to_le_bytes(), &f64::NAN.to_le_bytes()),
            "a.msh: byte 81: expected an x coordinate, found `NaN`",
        ),
        (
            with(&two, &[int(20), int(0)].concat(), &[int(10), int(0)].concat()),
            "a.msh: byte 77: expected a node with a new number, found `10`",
        ),
        (
            with(
                &two,
                &[int(2), int(2), int(2), int(2)].concat(),
                &[int(4), int(2), int(2), int(2)].concat(),
            ),
            "a.msh: byte 216: expected an element's type: 1 (line), 2 (triangle) or 15 (point), found `4`\n\
             help: it is a tetrahedron; only points, lines and triangles are read",
        ),
        (
            with(
                &four,
                &[size(4), size(10), size(20)].concat(),
                &[size(5), size(10), size(20)].concat(),
            ),
            "a.msh: byte 375: expected how many nodes are in this block, of those announced, found `5`",
        ),
        (
            with(
                &four,
                &[size(1), size(4), size(10)].concat(),
                &[size(1), size(1 << 40), size(10)].concat(),
            ),
            "a.msh: byte 339: expected the number of nodes, found `1099511627776`",
        ),
        (
            with(
                &four,
                &[size(3), size(3), size(1)].concat(),
                &[size(3), size(4), size(1)].concat(),
            ),
            "a.msh: byte 713: expected a block with more elements: 3 are here, of 4 announced, found `$EndElements`",
        ),
        (
            with(&four, &[int(2), int(2), int(2)].concat(), &[int(2), int(9), int(2)].concat()),
            "a.msh: byte 664: expected an entity of dimension 2 in $Entities, found `9`",
        ),
    ];
    for (bytes, message) in cases {
        assert_eq!(error(&bytes), message);
    }
}

#[test]
fn more_nodes_than_there_are_end_where_their_bytes_are_none() {
    let message = error(&with(&version2(false), b"$Nodes\n4", b"$Nodes\n4000000000"));
    assert!(message.starts_with("a.msh: byte 190: expected z = 0, as in the first"), "{message}");
}

#[test]
fn the_other_order_of_bytes_is_told_by_the_number_one_alone() {
    let mut bytes = version2(false);
    let one = bytes.iter().position(|&byte| byte == 1).expect("it is there");
    bytes[one..one + 4].copy_from_slice(&1_i32.to_be_bytes());
    let message = error(&bytes);
    let expected = "a.msh: byte 184: expected an element's type: 1 (line), 2 (triangle) or 15 (point), \
                    found `16777216`";
    assert_eq!(message, expected);
}
