//! VTK's XML format for polygonal data, `.vtp`: the boundary lines of a mesh, alone.
//!
//! Lines and arrays are those of [`vtu`](crate::vtu); points are those that lines have.
//! (<https://docs.vtk.org/en/latest/vtk_file_formats/index.html>)

use std::io::{self, Write};
use std::ops::Range;

use crate::arrays::{Array, Kind, coordinates, of_cells, of_groups, of_points};
use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;
use crate::nodes::{Nodes, Order};
use crate::selection::{Cells, select};
use crate::vtk_xml::{Document, Options};

/// Writes the boundary and the interfaces of a mesh, and says what became of their tags.
///
/// Triangles, their data and their groups are not written. There are no lines of second order:
/// [`Options::order`] is not heeded.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, vtp, vtu};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [9.0, 9.0], [1.0, 0.0]],
///     edges: vec![[0, 2]],
///     edge_tags: vec![3],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// let options = vtu::Options { encoding: vtu::Encoding::Ascii, ..vtu::Options::default() };
/// vtp::write_with(&mesh, options, &mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.contains("<Piece NumberOfPoints=\"2\" NumberOfLines=\"1\">"));
/// assert!(text.contains("0 0 0 1 0 0\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_with(mesh: &Mesh, options: Options, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let mesh = &*select(mesh, Cells::Segments);
    let (table, mut notes) = Table::new(mesh, Rules::default());
    let nodes = Nodes::new(mesh, Order::First)?;
    let count = mesh.edges.len();
    let ends = |edges: Range<usize>, out: &mut Vec<i64>| {
        out.extend(mesh.edges[edges].iter().flatten().map(|&end| i64::from(end)));
    };
    let lines = vec![
        Array::wholes("connectivity", Kind::Int64, [count, 2 * count], ends),
        Array::whole("offsets", Kind::Int64, count, |line| 2 * (line as i64 + 1)),
    ];
    let document = Document {
        kind: "PolyData",
        counts: vec![("NumberOfPoints", nodes.len()), ("NumberOfLines", count)],
        field: of_groups(&table.entries),
        sections: vec![
            ("PointData", of_points(&nodes, &mut notes)),
            ("CellData", of_cells(mesh, &table, &mut notes)),
            ("Points", vec![coordinates(&nodes)]),
            ("Lines", lines),
        ],
    };
    document.write(options, out)?;
    Ok(notes)
}
