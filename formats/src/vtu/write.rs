//! Writing `.vtu`: the arrays of a mesh.

use std::io::{self, Write};

use crate::arrays::{cells, coordinates, of_cells, of_groups, of_points};
use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;
use crate::nodes::Nodes;
use crate::vtk_xml::{Document, Options};

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
/// assert_eq!(vtu::read(&bytes, "one.vtu")?.0, mesh);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    write_with(mesh, Options::default(), out)
}

/// Writes a mesh as [`write()`] does, with options.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more nodes than 32 bits can number.
pub fn write_with(mesh: &Mesh, options: Options, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let (table, mut notes) = Table::new(mesh, Rules::default());
    let nodes = Nodes::new(mesh, options.order)?;
    let count = mesh.edges.len() + mesh.triangles.len();
    let document = Document {
        kind: "UnstructuredGrid",
        counts: vec![("NumberOfPoints", nodes.len()), ("NumberOfCells", count)],
        field: of_groups(&table.entries),
        sections: vec![
            ("PointData", of_points(&nodes, &mut notes)),
            ("CellData", of_cells(mesh, &table, &mut notes)),
            ("Points", vec![coordinates(&nodes)]),
            ("Cells", cells(&nodes).into()),
        ],
    };
    document.write(options, out)?;
    Ok(notes)
}
