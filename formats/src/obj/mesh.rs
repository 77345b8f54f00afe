//! Writing `.obj`: a mesh as faces and lines.

use std::io::{self, Write};

use super::write::vertices;
use crate::blocks::Blocks;
use crate::groups::{Names, Note, Rules, Table};
use crate::mesh::Mesh;
use crate::rows::{Rows, one_based};

/// Writes a mesh: a group of faces for each region, a group of lines for each boundary; z is 0.
///
/// Groups have names, no numbers; white space and `\` in a name become `_`. Groups of points, further
/// groups of an edge, markers, provenance and data are not written.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, obj};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![7],
///     edges: vec![[2, 0]],
///     edge_tags: vec![3],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// obj::write(&mesh, &mut text)?;
/// let expected = "v 0 0 0\nv 1 0 0\nv 0 0.5 0\ng region_7\nf 1 2 3\ng boundary_3\nl 3 1\n";
/// assert_eq!(text, expected.as_bytes());
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let rules = Rules { numberless: true, names: Names::Words, ..Rules::default() };
    let (table, mut notes) = Table::new(mesh, rules);
    notes.extend(Note::data_not_held(mesh));
    let mut rows = Rows::new(out);
    vertices(&mesh.points, &mut rows)?;
    let regions = (0..mesh.triangles.len()).map(|t| table.region(mesh.triangle_tag(t)));
    for (group, triangles) in Blocks::new(regions, table.entries.len()).in_use() {
        rows.text(&format!("g {}\n", table.entries[group].name))?;
        for &triangle in triangles {
            rows.text("f ")?;
            rows.integers(&mesh.triangles[triangle as usize].map(one_based))?;
        }
    }
    let boundaries = table.edges.iter().map(|&group| group as usize);
    for (group, edges) in Blocks::new(boundaries, table.entries.len()).in_use() {
        rows.text(&format!("g {}\n", table.entries[group].name))?;
        for &edge in edges {
            rows.text("l ")?;
            rows.integers(&mesh.edges[edge as usize].map(one_based))?;
        }
    }
    rows.finish()?;
    Ok(notes)
}
