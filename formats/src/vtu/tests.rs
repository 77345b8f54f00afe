//! Files of every encoding, written out.

use super::{Encoding, Options, write, write_with};
use crate::mesh::{Data, Mesh, Provenance, Values};
use crate::nodes::Order;

fn mesh() -> Mesh {
    Mesh {
        points: vec![[0.0, 0.0], [2.0, 0.0], [0.0, 0.1]],
        point_markers: vec![4, 4, 0],
        provenance: vec![Provenance::Input, Provenance::Shell, Provenance::Midpoint],
        triangles: vec![[0, 1, 2]],
        triangle_tags: vec![-7],
        edges: vec![[0, 1]],
        edge_tags: vec![4],
        edge_segments: vec![8],
        triangle_data: vec![Data {
            name: "a<b".into(),
            components: 1,
            values: Values::Real(vec![0.25]),
        }],
        ..Mesh::default()
    }
}

fn text(options: Options) -> String {
    let mut bytes = Vec::new();
    write_with(&mesh(), options, &mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn arrays_as_text() {
    let expected = "\
<?xml version=\"1.0\"?>
<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">
  <UnstructuredGrid>
      <FieldData>
        <DataArray type=\"UInt8\" Name=\"meshwright\" NumberOfTuples=\"1\" format=\"ascii\">
0
        </DataArray>
        <DataArray type=\"Int64\" Name=\"boundary_4\" NumberOfTuples=\"2\" format=\"ascii\">
4 1
        </DataArray>
        <DataArray type=\"Int64\" Name=\"region_-7\" NumberOfTuples=\"2\" format=\"ascii\">
-7 2
        </DataArray>
      </FieldData>
    <Piece NumberOfPoints=\"6\" NumberOfCells=\"2\">
      <PointData>
        <DataArray type=\"Int32\" Name=\"provenance\" format=\"ascii\">
0 1 2 -1 -1 -1
        </DataArray>
        <DataArray type=\"Int32\" Name=\"marker\" format=\"ascii\">
4 4 0 4 0 0
        </DataArray>
      </PointData>
      <CellData>
        <DataArray type=\"Int32\" Name=\"gmsh:physical\" format=\"ascii\">
4 -7
        </DataArray>
        <DataArray type=\"Int32\" Name=\"tag\" format=\"ascii\">
4 -7
        </DataArray>
        <DataArray type=\"Int64\" Name=\"segment\" format=\"ascii\">
8 -1
        </DataArray>
        <DataArray type=\"Float64\" Name=\"a&lt;b\" format=\"ascii\">
NaN 0.25
        </DataArray>
      </CellData>
      <Points>
        <DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">
0 0 0 2 0 0 0 0.1 0 1 0 0
0 0.05 0 1 0.05 0
        </DataArray>
      </Points>
      <Cells>
        <DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">
0 1 3 0 1 2 3 5 4
        </DataArray>
        <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">
3 9
        </DataArray>
        <DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">
21 22
        </DataArray>
      </Cells>
    </Piece>
  </UnstructuredGrid>
</VTKFile>
";
    let options = Options { encoding: Encoding::Ascii, order: Order::Second, ..Options::default() };
    assert_eq!(text(options), expected);
}

#[test]
fn arrays_as_base64_with_their_length_before_them() {
    let text = text(Options { encoding: Encoding::Base64, ..Options::default() });
    // Eight bytes: the length, 8; then 4 and −7 in 32 bits.
    let tag = "Name=\"tag\" format=\"binary\">\nCAAAAAAAAAAEAAAA+f///w==\n        </DataArray>";
    assert!(text.contains(tag), "{text}");
}

#[test]
fn compressed_arrays_say_so() {
    let options = |compress, encoding| Options { compress, encoding, ..Options::default() };
    let says = |options| text(options).contains(" compressor=\"vtkZLibDataCompressor\">");
    assert!(says(options(true, Encoding::Base64)));
    assert!(!says(options(false, Encoding::Base64)));
    assert!(!says(options(true, Encoding::Ascii)), "text is not compressed");
}

#[test]
fn offsets_of_compressed_arrays_lead_to_their_headers() {
    let mut bytes = Vec::new();
    write_with(&mesh(), Options { compress: true, ..Options::default() }, &mut bytes).unwrap();
    let find = |part: &[u8]| bytes.windows(part.len()).position(|w| w == part).unwrap();
    let start = find(b"\n   _") + 5;
    let head = std::str::from_utf8(&bytes[..start]).unwrap();
    for part in head.split("offset=\"").skip(1) {
        let offset: usize = part.split('"').next().unwrap().parse().unwrap();
        let header = &bytes[start + offset..][..24];
        let numbers: Vec<u64> =
            header.chunks(8).map(|w| u64::from_le_bytes(w.try_into().unwrap())).collect();
        assert_eq!(numbers[..2], [1, 1 << 15], "one block, of at most 32 kB");
    }
}

#[test]
fn raw_is_the_default() {
    let mut plain = Vec::new();
    write(&mesh(), &mut plain).unwrap();
    let mut raw = Vec::new();
    let options = Options { encoding: Encoding::Raw, compress: false, order: Order::First };
    write_with(&mesh(), options, &mut raw).unwrap();
    assert_eq!(plain, raw);
}
