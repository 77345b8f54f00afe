//! Writing `.su2`.

use std::io::{self, Write};

use crate::blocks::Blocks;
use crate::groups::{Names, Note, Rules, Table};
use crate::mesh::Mesh;
use crate::rows::Rows;
use crate::selection::without_interfaces;

/// Writes a mesh, and says what became of its tags and names.
///
/// A marker is a group of boundary edges; a name is one word there, other characters become `_`.
/// Edges between two triangles are no boundary and not written, nor are regions, groups of points,
/// markers, provenance and data.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Group, Mesh, su2};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     edges: vec![[0, 1], [1, 2], [2, 0]],
///     edge_tags: vec![3, 4, 3],
///     groups: vec![Group { dim: 1, tag: 3, name: "no slip".into() }],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// su2::write(&mesh, &mut text)?;
/// let expected = "NDIME= 2\nNELEM= 1\n5 0 1 2 0\nNPOIN= 3\n0 0 0\n1 0 1\n0 0.5 2\nNMARK= 2\n\
///                 MARKER_TAG= no_slip\nMARKER_ELEMS= 2\n3 0 1\n3 2 0\n\
///                 MARKER_TAG= boundary_4\nMARKER_ELEMS= 1\n3 1 2\n";
/// assert_eq!(text, expected.as_bytes());
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let (mesh, lost) = without_interfaces(mesh);
    let mesh = &*mesh;
    let rules =
        Rules { numberless: true, names: Names::Plain, without: Some(2), ..Rules::default() };
    let (table, mut notes) = Table::new(mesh, rules);
    notes.extend(lost);
    notes.extend(Note::regions_not_held(mesh));
    notes.extend(Note::data_not_held(mesh));
    let mut rows = Rows::new(out);
    rows.text(&format!("NDIME= 2\nNELEM= {}\n", mesh.triangles.len()))?;
    for (number, corners) in (0..).zip(&mesh.triangles) {
        let [a, b, c] = corners.map(i64::from);
        rows.integers(&[5, a, b, c, number])?;
    }
    rows.text(&format!("NPOIN= {}\n", mesh.points.len()))?;
    for (number, &[x, y]) in (0_i64..).zip(&mesh.points) {
        rows.real(x);
        rows.real(y);
        rows.integer(number);
        rows.end()?;
    }
    let groups = table.edges.iter().map(|&group| group as usize);
    let blocks = Blocks::new(groups, table.entries.len());
    rows.text(&format!("NMARK= {}\n", blocks.in_use().count()))?;
    for (group, edges) in blocks.in_use() {
        let (name, count) = (&table.entries[group].name, edges.len());
        rows.text(&format!("MARKER_TAG= {name}\nMARKER_ELEMS= {count}\n"))?;
        for &edge in edges {
            let [a, b] = mesh.edges[edge as usize].map(i64::from);
            rows.integers(&[3, a, b])?;
        }
    }
    rows.finish()?;
    Ok(notes)
}
