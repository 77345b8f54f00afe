use super::super::source::find;
use super::*;
use crate::mesh::Provenance;

fn file() -> Vec<u8> {
    let mesh = Mesh {
        points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        point_markers: vec![1, 2, 3],
        provenance: vec![Provenance::Input; 3],
        triangles: vec![[0, 1, 2]],
        triangle_tags: vec![7],
        edges: vec![[0, 1]],
        edge_tags: vec![5],
        ..Mesh::default()
    };
    let mut bytes = Vec::new();
    crate::vtu::write(&mesh, &mut bytes).unwrap();
    bytes
}

/// The message for a file with one piece of its header changed.
fn error(from: &str, to: &str) -> String {
    let bytes = file();
    let place = find(&bytes, from.as_bytes()).expect("this is in the header");
    let changed = [&bytes[..place], to.as_bytes(), &bytes[place + from.len()..]].concat();
    read(&changed, "a.vtu").expect_err("this is wrong").to_string()
}

#[test]
fn other_kinds_of_vtu_are_refused_by_their_attribute() {
    let other = error("type=\"UnstructuredGrid\"", "type=\"PolyData\"");
    assert_eq!(other, "a.vtu: expected type=\"UnstructuredGrid\", found \"PolyData\"");
    let other = error("UInt64\"", "UInt16\"");
    assert_eq!(other, "a.vtu: expected header_type=\"UInt32 or UInt64\", found \"UInt16\"");
    let other = error("encoding=\"raw\"", "encoding=\"hex\"");
    assert_eq!(other, "a.vtu: expected encoding=\"raw or base64\", found \"hex\"");
    let other = error("header_type", "compressor=\"vtkLZ4DataCompressor\" header_type");
    let expected = "compressor=\"vtkZLibDataCompressor\", found \"vtkLZ4DataCompressor\"";
    assert_eq!(other, format!("a.vtu: expected {expected}"));
    assert_eq!(error("<VTKFile", "<File"), "a.vtu: this is no .vtu file: it holds no <VTKFile>");
}

#[test]
fn wrong_counts_and_offsets_name_the_array() {
    let other = error("NumberOfPoints=\"3\"", "NumberOfPoints=\"4\"");
    assert_eq!(other, "a.vtu: array `Points` holds 9 numbers, expected 12");
    let other = error("NumberOfCells=\"2\"", "NumberOfCells=\"18446744073709551615\"");
    assert_eq!(other, "a.vtu: array `types` holds 2 numbers, expected 18446744073709551615");
    let other = error("NumberOfCells=\"2\"", "NumberOfCells=\"-2\"");
    assert_eq!(other, "a.vtu: line 9: expected a number in NumberOfCells, found `-2`");
    let many = "NumberOfComponents=\"18446744073709551615\"";
    let other = error("Name=\"marker\"", &format!("Name=\"depth\" {many}"));
    assert_eq!(other, "a.vtu: array `depth` holds 3 numbers, expected 18446744073709551615");
    let other = error("Name=\"connectivity\"", "Name=\"corners\"");
    assert_eq!(other, "a.vtu: array `connectivity` is missing");
    let other = error("offset=\"0\"", "offset=\"18446744073709551615\"");
    assert!(other.starts_with("a.vtu: array `meshwright` ends at byte 18446744073709551615"));
}

#[test]
fn broken_xml_names_its_line() {
    let other = error("</Piece>", "</Peace>");
    assert!(other.starts_with("a.vtu: line 26: "), "{other}");
}

#[test]
fn corners_out_of_range_name_their_place() {
    let mut bytes = file();
    let wrong = 3_i64.to_le_bytes();
    let tail = b"\n  </AppendedData>\n</VTKFile>\n".len();
    // Before the tail: two types and two offsets with their eight bytes each, one corner.
    let end = bytes.len() - tail - (8 + 2) - (8 + 16);
    bytes[end - 8..end].copy_from_slice(&wrong);
    let message = read(&bytes, "a.vtu").expect_err("this is wrong").to_string();
    let expected = "a.vtu: array `connectivity`, number 4 (from 0): expected a point, found 3";
    assert_eq!(message, expected);
}

#[test]
fn every_shorter_file_is_refused() {
    let bytes = file();
    let whole = bytes.trim_ascii_end().len();
    for length in 0..whole {
        let message = read(&bytes[..length], "a.vtu").expect_err("it is cut").to_string();
        assert!(message.starts_with("a.vtu: "), "{message}");
    }
}

#[test]
fn base64_and_zlib_that_mean_nothing_name_their_array() {
    let inline = |data: &str, compressor: &str| {
        let text = format!(
            "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"{compressor}>\
             <UnstructuredGrid><Piece NumberOfPoints=\"1\" NumberOfCells=\"0\"><Points>\
             <DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"binary\">{data}\
             </DataArray></Points></Piece></UnstructuredGrid></VTKFile>"
        );
        read(text.as_bytes(), "a.vtu").expect_err("this is wrong").to_string()
    };
    assert_eq!(
        inline("DAAA*A==", ""),
        "a.vtu: array ``: expected Base64, four letters for three bytes, found byte 42"
    );
    let found = inline("DAAAAA==AAAAAAAAAAAAAAA", "");
    assert!(found.ends_with("four letters for three bytes, found `AAA`"));
    assert_eq!(
        inline("/////w==AAAA", ""),
        "a.vtu: array `` ends at byte 4294967299 of its data, which have 8"
    );
    let zlib = " compressor=\"vtkZLibDataCompressor\"";
    // One block of 12 bytes, in 4 bytes that zlib did not make.
    let found = inline("AQAAAAwAAAAAAAAABAAAAA==AAAAAA==", zlib);
    assert!(found.contains("expected compressed blocks of the announced size, found"), "{found}");
    let found = inline("/////wwAAAAAAAAABAAAAA==AAAAAA==", zlib);
    assert!(found.contains("of its data, which have"), "a billion blocks: {found}");
}

/// A file of which the system refuses what lies behind its first bytes, but for the end.
struct Refused {
    bytes: Cursor<Vec<u8>>,
    readable: u64,
}

impl Read for Refused {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let at = self.bytes.position();
        let last = self.bytes.get_ref().len() as u64 - 20;
        if at >= last {
            return self.bytes.read(bytes);
        }
        match self.readable.saturating_sub(at) {
            0 => Err(std::io::Error::other("the disk is gone")),
            left => self.bytes.by_ref().take(left).read(bytes),
        }
    }
}

impl Seek for Refused {
    fn seek(&mut self, to: std::io::SeekFrom) -> std::io::Result<u64> {
        self.bytes.seek(to)
    }
}

#[test]
fn what_the_system_says_is_said() {
    let bytes = file();
    let data = find(&bytes, b"_\x01").expect("the appended data begin") as u64;
    for readable in [0, 100, data + 40] {
        let refused = Refused { bytes: Cursor::new(bytes.clone()), readable };
        let error = read_from(refused, "a.vtu").expect_err("the disk is gone");
        assert_eq!(error.to_string(), "a.vtu: the disk is gone");
        assert!(matches!(error.fault, Fault::Io { kind: std::io::ErrorKind::Other, .. }));
    }
}
