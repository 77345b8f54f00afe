//! Writing `.vtu`: first the description of every array, then the arrays.

use std::io::{self, Write};

use quick_xml::escape::escape;

use super::{LINE, MARKER, PHYSICAL, PROVENANCE, SEGMENT, TAG, TRIANGLE, VERSION};
use crate::groups::{Entry, Note, Rules, Table, writable};
use crate::mesh::{Data, Mesh, Values};

/// Writes a mesh with all that it holds, and says what became of its tags.
///
/// Tags are kept, also those below 1. See [`vtu`](super) for the arrays.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, vtu};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![-7],
///     ..Mesh::default()
/// };
/// let mut bytes = Vec::new();
/// vtu::write(&mesh, &mut bytes)?;
/// assert_eq!(vtu::read(&bytes, "one.vtu")?, mesh);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let (table, mut notes) = Table::new(mesh, Rules::default());
    let arrays = Arrays::of(mesh, &table, &mut notes);
    let mut bytes = Bytes { buffer: Vec::with_capacity(2 * BLOCK), out };
    bytes.header(mesh, &arrays)?;
    for array in arrays.all() {
        bytes.array(array)?;
    }
    bytes.buffer.extend(b"\n  </AppendedData>\n</VTKFile>\n");
    bytes.out.write_all(&bytes.buffer)?;
    Ok(notes)
}

/// An array of the file: its description, and its numbers one by one.
struct Array<'a> {
    name: String,
    kind: Kind,
    components: usize,
    length: usize,
    values: Numbers<'a>,
}

/// VTK's types of numbers.
#[derive(Clone, Copy)]
enum Kind {
    Float64,
    Int64,
    Int32,
    UInt8,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Float64 => "Float64",
            Self::Int64 => "Int64",
            Self::Int32 => "Int32",
            Self::UInt8 => "UInt8",
        }
    }

    fn size(self) -> usize {
        match self {
            Self::Float64 | Self::Int64 => 8,
            Self::Int32 => 4,
            Self::UInt8 => 1,
        }
    }
}

/// The numbers of an array, by index.
enum Numbers<'a> {
    Real(Box<dyn Fn(usize) -> f64 + 'a>),
    Whole(Box<dyn Fn(usize) -> i64 + 'a>),
}

impl Array<'_> {
    fn bytes(&self) -> u64 {
        (self.length * self.kind.size()) as u64
    }
}

/// The arrays of a mesh, by the section they stand in.
struct Arrays<'a> {
    field: Vec<Array<'a>>,
    point: Vec<Array<'a>>,
    cell: Vec<Array<'a>>,
    points: Vec<Array<'a>>,
    cells: Vec<Array<'a>>,
}

impl<'a> Arrays<'a> {
    fn of(mesh: &'a Mesh, table: &'a Table, notes: &mut Vec<Note>) -> Self {
        Self {
            field: field_arrays(&table.entries),
            point: point_arrays(mesh, notes),
            cell: cell_arrays(mesh, table, notes),
            points: vec![coordinates(mesh)],
            cells: cells(mesh),
        }
    }

    /// All arrays, in the order of their bytes.
    fn all(&self) -> impl Iterator<Item = &Array<'a>> {
        [&self.field, &self.point, &self.cell, &self.points, &self.cells].into_iter().flatten()
    }
}

/// One array for each name, `[number, dimension]` for each group of that name.
///
/// The first array is a single byte. It, and that no other array but the last has a length that
/// is no multiple of four, keeps all further offsets odd: meshio 5.3 gives each array a new offset
/// (a multiple of four) and then looks for the next one by its old offset; where an old and a new
/// one are the same number, it mixes up the two arrays.
fn field_arrays(entries: &[Entry]) -> Vec<Array<'_>> {
    let mut names: Vec<&str> = Vec::new();
    let mut pairs: Vec<Vec<i64>> = Vec::new();
    for entry in entries {
        let place = names.iter().position(|&name| name == entry.name).unwrap_or_else(|| {
            names.push(&entry.name);
            pairs.push(Vec::new());
            names.len() - 1
        });
        pairs[place].extend([i64::from(entry.number), i64::from(entry.dim)]);
    }
    let array =
        |(name, pairs): (&str, Vec<i64>)| whole(name, Kind::Int64, pairs.len(), move |i| pairs[i]);
    let first = whole(VERSION, Kind::UInt8, 1, |_| 0);
    std::iter::once(first).chain(names.into_iter().zip(pairs).map(array)).collect()
}

fn point_arrays<'a>(mesh: &'a Mesh, notes: &mut Vec<Note>) -> Vec<Array<'a>> {
    let count = mesh.points.len();
    let mut arrays = Vec::new();
    if !mesh.provenance.is_empty() {
        let value = |i| mesh.provenance.get(i).map_or(0, |&kind| kind as i64);
        arrays.push(whole(PROVENANCE, Kind::Int32, count, value));
    }
    if !mesh.point_markers.is_empty() {
        let value = |i| mesh.point_markers.get(i).map_or(0, |&marker| i64::from(marker));
        arrays.push(whole(MARKER, Kind::Int32, count, value));
    }
    for data in &mesh.point_data {
        let name = data_name(&data.name, &[PROVENANCE, MARKER], notes);
        arrays.push(data_array(data, name, 0, count));
    }
    arrays
}

fn cell_arrays<'a>(mesh: &'a Mesh, table: &'a Table, notes: &mut Vec<Note>) -> Vec<Array<'a>> {
    let (edges, count) = (mesh.edges.len(), mesh.edges.len() + mesh.triangles.len());
    let group = move |cell: usize| match table.edges.get(cell) {
        Some(&group) => group as usize,
        None => table.region(mesh.triangle_tag(cell - edges)),
    };
    let mut arrays = vec![
        whole(PHYSICAL, Kind::Int32, count, move |i| i64::from(table.entries[group(i)].number)),
        whole(TAG, Kind::Int32, count, move |i| i64::from(table.entries[group(i)].tag)),
    ];
    if !mesh.edge_segments.is_empty() {
        let value = move |i| match mesh.edge_segments.get(i) {
            Some(&segment) if i < edges && segment != u32::MAX => i64::from(segment),
            _ => -1,
        };
        arrays.push(whole(SEGMENT, Kind::Int64, count, value));
    }
    for data in &mesh.triangle_data {
        let name = data_name(&data.name, &[PHYSICAL, TAG, SEGMENT], notes);
        arrays.push(data_array(data, name, edges, mesh.triangles.len()));
    }
    arrays
}

/// The name of a data array in the file, which the names that have a meaning are kept from.
fn data_name(name: &str, meant: &[&str], notes: &mut Vec<Note>) -> String {
    let mut written = writable(name, Rules::default()).into_owned();
    while meant.contains(&written.as_str()) {
        written.push('_');
    }
    if written != name {
        notes.push(Note::NameChanged { name: name.to_owned(), written: written.clone() });
    }
    written
}

/// `count` tuples of data, after `before` tuples that say nothing.
fn data_array(data: &Data, name: String, before: usize, count: usize) -> Array<'_> {
    let components = data.components.max(1);
    let before = before * components;
    let length = before + count * components;
    let (kind, values) = match &data.values {
        Values::Real(values) => (
            Kind::Float64,
            Numbers::Real(Box::new(move |i: usize| {
                i.checked_sub(before).and_then(|i| values.get(i)).copied().unwrap_or(f64::NAN)
            })),
        ),
        Values::Integer(values) => (
            Kind::Int64,
            Numbers::Whole(Box::new(move |i: usize| {
                i.checked_sub(before).and_then(|i| values.get(i)).copied().unwrap_or(0)
            })),
        ),
    };
    Array { name, kind, components, length, values }
}

/// The points as VTK wants them: with a z coordinate, 0.
fn coordinates(mesh: &Mesh) -> Array<'_> {
    let value = |i: usize| mesh.points[i / 3].get(i % 3).copied().unwrap_or(0.0);
    let values = Numbers::Real(Box::new(value));
    let length = 3 * mesh.points.len();
    Array { name: "Points".to_owned(), kind: Kind::Float64, components: 3, length, values }
}

fn cells(mesh: &Mesh) -> Vec<Array<'_>> {
    let (edges, triangles) = (mesh.edges.len(), mesh.triangles.len());
    let connectivity = move |i: usize| {
        let corner = match i.checked_sub(2 * edges) {
            None => mesh.edges[i / 2][i % 2],
            Some(i) => mesh.triangles[i / 3][i % 3],
        };
        i64::from(corner)
    };
    let offset = move |i: usize| {
        let end = i + 1;
        (2 * end.min(edges) + 3 * end.saturating_sub(edges)) as i64
    };
    let kind = move |i: usize| i64::from(if i < edges { LINE } else { TRIANGLE });
    vec![
        whole("connectivity", Kind::Int64, 2 * edges + 3 * triangles, connectivity),
        whole("offsets", Kind::Int64, edges + triangles, offset),
        whole("types", Kind::UInt8, edges + triangles, kind),
    ]
}

fn whole<'a>(
    name: &str,
    kind: Kind,
    length: usize,
    value: impl Fn(usize) -> i64 + 'a,
) -> Array<'a> {
    let values = Numbers::Whole(Box::new(value));
    Array { name: name.to_owned(), kind, components: 1, length, values }
}

/// Bytes that are gathered before they are handed on.
const BLOCK: usize = 1 << 16;

struct Bytes<'a, W> {
    buffer: Vec<u8>,
    out: &'a mut W,
}

impl<W: Write> Bytes<'_, W> {
    fn header(&mut self, mesh: &Mesh, arrays: &Arrays) -> io::Result<()> {
        let mut offset = 0;
        let mut section = |name: &str, arrays: &[Array]| {
            let mut text = format!("      <{name}>\n");
            for array in arrays {
                text += &description(array, name == "FieldData", offset);
                offset += 8 + array.bytes();
            }
            text + &format!("      </{name}>\n")
        };
        let (points, cells) = (mesh.points.len(), mesh.edges.len() + mesh.triangles.len());
        let field = section("FieldData", &arrays.field);
        let point = section("PointData", &arrays.point);
        let cell = section("CellData", &arrays.cell);
        let place = section("Points", &arrays.points);
        let corner = section("Cells", &arrays.cells);
        // White space before the `_`: VTK's parser needs it there.
        write!(
            self.buffer,
            "<?xml version=\"1.0\"?>\n\
             <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n  <UnstructuredGrid>\n{field}    \
             <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">\n\
             {point}{cell}{place}{corner}    </Piece>\n  </UnstructuredGrid>\n  \
             <AppendedData encoding=\"raw\">\n   _"
        )
    }

    fn array(&mut self, array: &Array) -> io::Result<()> {
        self.buffer.extend(array.bytes().to_le_bytes());
        for index in 0..array.length {
            match &array.values {
                Numbers::Real(value) => self.buffer.extend(value(index).to_le_bytes()),
                Numbers::Whole(value) => {
                    let bytes = value(index).to_le_bytes();
                    self.buffer.extend(&bytes[..array.kind.size()]);
                }
            }
            if self.buffer.len() >= BLOCK {
                self.out.write_all(&self.buffer)?;
                self.buffer.clear();
            }
        }
        Ok(())
    }
}

fn description(array: &Array, field: bool, offset: u64) -> String {
    let (kind, name) = (array.kind.name(), escape(&array.name));
    let shape = match (field, array.components) {
        (true, _) => format!(" NumberOfTuples=\"{}\"", array.length),
        (false, 1) => String::new(),
        (false, components) => format!(" NumberOfComponents=\"{components}\""),
    };
    format!(
        "        <DataArray type=\"{kind}\" Name=\"{name}\"{shape} format=\"appended\" \
         offset=\"{offset}\"/>\n"
    )
}
