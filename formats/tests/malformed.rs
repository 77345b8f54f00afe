//! Malformed meshes: each reader names the place and the cause, and gives nothing half-read.
//!
//! Truncated anywhere, a wrong count, a number out of range, a number twice, a billion announced,
//! the other order of bytes, a wrong version, a coordinate that is no number: each of these in each
//! format that can have it. (Half a surrogate in a name: `others.rs`; bytes of `.msh`: in its module.)

use std::io;

use meshwright_formats::{Mesh, Order, ele, inp, medit, msh, su2, vtk, vtu};

/// Two triangles in two regions, a boundary of two edges, one point in a group.
fn mesh() -> Mesh {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 5 \"rim\"\n2 7 \"sand\"\n\
                2 8 \"clay\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n\
                $EndNodes\n$Elements\n4\n1 1 2 5 5 1 2\n2 1 2 5 5 2 3\n3 2 2 7 7 1 2 3\n\
                4 2 2 8 8 1 3 4\n$EndElements\n";
    msh::read(text.as_bytes(), "mesh").expect("it is good").0
}

/// A reader's answer: the message, or nothing where the file is good.
type Read = fn(&[u8]) -> Option<String>;

fn says<T>(read: Result<T, impl ToString>) -> Option<String> {
    read.err().map(|error| error.to_string())
}

/// A format: a good file, and its reader.
struct Format {
    name: &'static str,
    good: Vec<u8>,
    read: Read,
}

fn formats() -> Vec<Format> {
    let mesh = &mesh();
    let file = |name, read: Read, write: &dyn Fn(&mut Vec<u8>) -> io::Result<()>| {
        let mut good = Vec::new();
        write(&mut good).expect("memory takes all");
        assert_eq!(read(&good), None, "{name}");
        Format { name, good, read }
    };
    let msh_options = |version, binary| msh::Options { version, binary, ..msh::Options::default() };
    let read_msh: Read = |bytes| says(msh::read(bytes, "a"));
    let read_vtk: Read = |bytes| says(vtk::read(bytes, "a"));
    let mut all = Vec::new();
    for (name, version, binary) in [
        ("msh 2.2", msh::Version::V2_2, false),
        ("msh 2.2 binary", msh::Version::V2_2, true),
        ("msh 4.1", msh::Version::V4_1, false),
        ("msh 4.1 binary", msh::Version::V4_1, true),
    ] {
        let options = msh_options(version, binary);
        all.push(file(name, read_msh, &|out| msh::write_with(mesh, options, out).map(drop)));
    }
    for (name, binary) in [("vtk", false), ("vtk binary", true)] {
        let options = vtk::Options { binary, order: Order::First };
        all.push(file(name, read_vtk, &|out| vtk::write_with(mesh, options, out).map(drop)));
    }
    let text = vtu::Options { encoding: vtu::Encoding::Ascii, ..vtu::Options::default() };
    let read_vtu: Read = |bytes| says(vtu::read(bytes, "a"));
    all.push(file("vtu text", read_vtu, &|out| vtu::write_with(mesh, text, out).map(drop)));
    all.push(file("vtu", read_vtu, &|out| vtu::write(mesh, out).map(drop)));
    all.push(file("mesh", |b| says(medit::read(b, "a")), &|out| medit::write(mesh, out).map(drop)));
    all.push(file("su2", |b| says(su2::read(b, "a")), &|out| su2::write(mesh, out).map(drop)));
    let write_inp = |out: &mut Vec<u8>| inp::write_with(mesh, Order::First, out).map(drop);
    all.push(file("inp", |b| says(inp::read(b, "a")), &write_inp));
    let read_ele: Read = |bytes| {
        let nodes = b"4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n".to_vec();
        says(ele::read_with_companions(bytes, "a.ele", move |name| {
            if name.ends_with(".node") {
                Ok(nodes.clone())
            } else {
                Err(io::ErrorKind::NotFound.into())
            }
        }))
    };
    all.push(file("ele", read_ele, &|out| ele::write(mesh, out).map(drop)));
    all
}

/// The message for the file of a format with its first `part` replaced.
fn message(format: &Format, part: &str, by: &str) -> String {
    let place = format.good.windows(part.len()).position(|bytes| bytes == part.as_bytes());
    let place = place.unwrap_or_else(|| panic!("{} holds `{part}`", format.name));
    let mut bytes = format.good.clone();
    bytes.splice(place..place + part.len(), by.bytes());
    let message = (format.read)(&bytes);
    let message = message.unwrap_or_else(|| "it is read".to_owned());
    message.lines().next().unwrap_or_default().to_owned()
}

#[test]
fn a_file_that_is_cut_off_anywhere_is_refused_or_whole() {
    for Format { name, good, read } in formats() {
        let mut refused = 0;
        for length in 0..good.trim_ascii_end().len() {
            let Some(message) = read(&good[..length]) else { continue };
            refused += 1;
            assert!(
                message.starts_with("a:") || message.starts_with("a.ele:"),
                "{name}: {message}"
            );
        }
        // What is left may be whole where no count and no end tells of more: sets and boundaries.
        let least = if matches!(name, "inp" | "su2" | "vtk" | "vtk binary") { 2 } else { 1 };
        assert!(refused * least + 3 >= good.len(), "{name}: {refused} of {}", good.len());
    }
}

/// Format, what is replaced by what, the message.
const FAULTS: &[(&str, &str, &str, &str)] = &[
    // Wrong counts.
    (
        "msh 2.2",
        "$Nodes\n4",
        "$Nodes\n5",
        "a:16:1: expected the number of a node, found `$EndNodes`",
    ),
    ("msh 2.2", "$Nodes\n4", "$Nodes\n3", "a:15:1: expected $EndNodes, found `4`"),
    (
        "msh 2.2",
        "$Elements\n4",
        "$Elements\n5",
        "a:23:1: expected the number of an element, found `$EndElements`",
    ),
    ("msh 2.2", "$Elements\n4", "$Elements\n3", "a:22:1: expected $EndElements, found `4`"),
    (
        "msh 4.1",
        "2 4 1 4",
        "2 5 1 5",
        "a:28:1: expected a block with more nodes: 4 are here, of 5 announced, found `$EndNodes`",
    ),
    ("msh 4.1", "1 5 0 3", "1 5 0 4", "a:22:1: expected the number of a node, found `0`"),
    (
        "msh 4.1",
        "3 4 1 4",
        "3 5 1 5",
        "a:38:1: expected a block with more elements: 4 are here, of 5 announced, found `$EndElements`",
    ),
    ("vtk", "POINTS 4", "POINTS 5", "a:16:1: expected a number, found `CELLS`"),
    (
        "vtk",
        "CELLS 4 14",
        "CELLS 5 14",
        "a:16:9: expected 5 cells, each with the number of its nodes before them, found `14`",
    ),
    (
        "vtk",
        "CELLS 4 14",
        "CELLS 4 13",
        "a:16:9: expected 4 cells, each with the number of its nodes before them, found `13`",
    ),
    (
        "vtu",
        "NumberOfPoints=\"4\"",
        "NumberOfPoints=\"5\"",
        "a: array `Points` holds 12 numbers, expected 15",
    ),
    (
        "vtu",
        "NumberOfCells=\"4\"",
        "NumberOfCells=\"3\"",
        "a: array `types` holds 4 numbers, expected 3",
    ),
    ("mesh", "Vertices\n4", "Vertices\n5", "a:9:1: expected an x coordinate, found `Edges`"),
    (
        "mesh",
        "Triangles\n2",
        "Triangles\n3",
        "a:17:1: expected the number of a vertex, found `End`",
    ),
    ("su2", "NPOIN= 4", "NPOIN= 5", "a:10:1: expected an x coordinate, found `NMARK`"),
    (
        "su2",
        "NELEM= 2",
        "NELEM= 3",
        "a:5:1: expected an element's kind, 5 (triangle), found `NPOIN`",
    ),
    (
        "su2",
        "MARKER_ELEMS= 2",
        "MARKER_ELEMS= 3",
        "a:14:6: expected element 3 of 3, found the end of the file",
    ),
    ("ele", "2 3 1", "3 3 1", "a.ele:3:10: expected triangle 3 of 3, found the end of the file"),
    // Numbers out of range.
    (
        "msh 2.2",
        "3 2 2 7 7 1 2 3",
        "3 2 2 7 7 1 2 5",
        "a:21:15: expected the number of a node, found `5`",
    ),
    ("msh 4.1", "3 1 2 3", "3 1 2 5", "a:35:7: expected the number of a node, found `5`"),
    ("vtk", "3 0 2 3", "3 0 2 4", "a:20:7: expected a point, found `4`"),
    ("mesh", "1 3 4 8", "1 3 0 8", "a:16:5: expected the number of a vertex, found `0`"),
    ("su2", "5 0 2 3", "5 0 2 4", "a:4:7: expected a point, 0 to 3, found `4`"),
    ("inp", "2, 1, 3, 4", "2, 1, 3, 9", "a:8:10: expected the number of a node, found `9`"),
    ("ele", "2 1 3 4", "2 1 3 5", "a.ele:3:7: expected the number of a point (1 to 4), found `5`"),
    (
        "vtu text",
        "0 2 3\n",
        "0 2 4\n",
        "a: array `connectivity`, number 9 (from 0): expected a point, found 4",
    ),
    ("vtu text", "2 4 7 10", "2 4 7 11", "a: array `connectivity` holds 10 numbers, expected 11"),
    // Numbers twice.
    ("msh 2.2", "4 0 1 0", "3 0 1 0", "a:15:1: expected a node with a new number, found `3`"),
    ("msh 4.1", "4\n0 1 0", "3\n0 1 0", "a:26:1: expected a node with a new number, found `3`"),
    ("inp", "4, 0, 1, 0", "3, 0, 1, 0", "a:5:1: expected a node with a new number, found `3`"),
    ("inp", "2, 1, 3, 4", "1, 1, 3, 4", "a:8:1: expected an element with a new number, found `1`"),
    (
        "ele",
        "2 1 3 4",
        "1 1 3 4",
        "a.ele:3:1: expected triangle 2 of 2, counted up from the first, found `1`",
    ),
    // A billion announced.
    (
        "msh 2.2",
        "$Elements\n4",
        "$Elements\n1000000000",
        "a:23:1: expected the number of an element, found `$EndElements`",
    ),
    (
        "msh 4.1",
        "2 4 1 4",
        "1000000000 4 1 4",
        "a:28:1: expected the dimension of an entity (0 to 3), found `$EndNodes`",
    ),
    (
        "vtk",
        "CELLS 4 14",
        "CELLS 1000000000 4000000000",
        "a:21:1: expected a whole number, found `CELL_TYPES`",
    ),
    (
        "vtu",
        "NumberOfCells=\"4\"",
        "NumberOfCells=\"1000000000\"",
        "a: array `types` holds 4 numbers, expected 1000000000",
    ),
    (
        "mesh",
        "Triangles\n2",
        "Triangles\n1000000000",
        "a:17:1: expected the number of a vertex, found `End`",
    ),
    (
        "su2",
        "NELEM= 2",
        "NELEM= 1000000000",
        "a:5:1: expected an element's kind, 5 (triangle), found `NPOIN`",
    ),
    (
        "ele",
        "2 3 1",
        "1000000000 3 1",
        "a.ele:3:10: expected triangle 3 of 1000000000, found the end of the file",
    ),
    // Wrong versions, and the other order of bytes.
    ("msh 2.2", "2.2 0 8", "2.1.3 0 8", "a:2:1: expected version 2.2 or 4.1, found `2.1.3`"),
    ("msh 2.2", "2.2 0 8", "1 0 8", "a:2:1: expected version 2.2 or 4.1, found `1`"),
    ("msh 4.1", "4.1 0 8", "4.2 0 8", "a:2:1: expected version 2.2 or 4.1, found `4.2`"),
    ("msh 2.2 binary", "2.2 1 8", "2.2 1 4", "a:2:7: expected the size of a double, 8, found `4`"),
    (
        "msh 2.2 binary",
        "\u{1}\0\0\0",
        "\0\0\u{1}\0",
        "a: byte 20: expected the number 1 in 4 bytes, found `65536`",
    ),
    ("vtk", "Version 3.0", "Version 9.0", "a:1:24: expected a version from 1 to 5, found `9.0`"),
    (
        "vtu",
        "Grid\" version=\"1.0\"",
        "Grid\" version=\"7.0\"",
        "a: expected version=\"0.1 or 1.0 or 2.0 or 2.1 or 2.2 or 2.3\", found \"7.0\"",
    ),
    (
        "vtu",
        "LittleEndian",
        "BigEndian",
        "a: array `Points` ends at byte 6917529027641081864 of its data, which have 274",
    ),
    (
        "vtu",
        "LittleEndian",
        "MiddleEndian",
        "a: expected byte_order=\"LittleEndian or BigEndian\", found \"MiddleEndian\"",
    ),
    ("mesh", "Formatted 2", "Formatted 7", "a:1:22: expected the version (1 to 4), found `7`"),
    // No numbers.
    ("msh 2.2", "3 1 1 0", "3 1 nan 0", "a:14:5: expected a y coordinate, found `nan`"),
    ("msh 4.1", "\n1 1 0", "\n1 inf 0", "a:24:3: expected a y coordinate, found `inf`"),
    ("vtk", "1 0 0 1 1 0", "1 0 0 NaN 1 0", "a:15:13: expected a finite number, found `NaN`"),
    (
        "vtu text",
        "1 0 0 1 1 0",
        "1 0 0 1 nan 0",
        "a: array `Points`, number 7 (from 0): expected a finite number, found NaN",
    ),
    ("mesh", "1 1 0", "1 nan 0", "a:7:3: expected a y coordinate, found `nan`"),
    ("su2", "1 1 2", "1 nan 2", "a:8:3: expected a y coordinate, found `nan`"),
    ("inp", "3, 1, 1, 0", "3, 1, nan, 0", "a:4:7: expected a y coordinate, found `nan`"),
];

#[test]
fn a_fault_is_named_with_its_place_and_its_cause() {
    let formats = formats();
    let mut wrong = String::new();
    for &(name, part, by, wanted) in FAULTS {
        let format = formats.iter().find(|format| format.name == name).expect("a format");
        let found = message(format, part, by);
        if found != wanted {
            wrong += &format!("{name}: {part:?} -> {by:?}\n  {found}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}
