//! Writing `.mesh`.

use std::io::{self, Write};

use crate::groups::{Note, numbers_only};
use crate::mesh::Mesh;
use crate::nodes::{Nodes, Order};
use crate::pslg::Tag;
use crate::rows::{Rows, one_based};

/// Writes a mesh with corners alone, and says what became of its tags and names.
///
/// Numbers are the user's, also those below 1. A vertex has its marker or, where there are no
/// markers, the number of a group of points that it is in. Names, provenance and data are not
/// written, nor is more than one group of an edge.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, medit};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![7],
///     edges: vec![[0, 1]],
///     edge_tags: vec![-3],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// medit::write(&mesh, &mut text)?;
/// let expected = "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 0.5 0\n\
///                 Edges\n1\n1 2 -3\nTriangles\n1\n1 2 3 7\nEnd\n";
/// assert_eq!(text, expected.as_bytes());
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    write_with(mesh, Order::First, out)
}

/// Writes a mesh as [`write()`] does, in elements of this order.
///
/// Those of second order stand in `EdgesP2` and `TrianglesP2`: corners, then the middles of the sides
/// 1–2, 2–3, 3–1, whose vertices have the number 0.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more vertices than 32 bits can number.
pub fn write_with(mesh: &Mesh, order: Order, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let nodes = Nodes::new(mesh, order)?;
    let mut rows = Rows::new(out);
    rows.text("MeshVersionFormatted 2\nDimension 2\nVertices\n")?;
    rows.integers(&[nodes.len() as i64])?;
    let (numbers, notes) = point_numbers(mesh);
    for (node, [x, y]) in nodes.points().enumerate() {
        rows.real(x);
        rows.real(y);
        rows.integer(numbers.get(node).copied().unwrap_or(0));
        rows.end()?;
    }
    let suffix = if order == Order::Second { "P2" } else { "" };
    // SfePy takes an empty list for a kind of cells, and refuses a mesh of two kinds.
    if !mesh.edges.is_empty() {
        rows.text(&format!("Edges{suffix}\n"))?;
        rows.integers(&[mesh.edges.len() as i64])?;
    }
    for edge in 0..mesh.edges.len() {
        cell(&mut rows, nodes.edge(edge), mesh.edge_tag(edge))?;
    }
    if !mesh.triangles.is_empty() {
        rows.text(&format!("Triangles{suffix}\n"))?;
        rows.integers(&[mesh.triangles.len() as i64])?;
    }
    for triangle in 0..mesh.triangles.len() {
        cell(&mut rows, nodes.triangle(triangle), mesh.triangle_tag(triangle))?;
    }
    rows.text("End\n")?;
    rows.finish()?;
    Ok(notes)
}

/// A cell: its nodes and its number.
fn cell<W: Write>(
    rows: &mut Rows<'_, W>,
    nodes: impl Iterator<Item = u32>,
    tag: Tag,
) -> io::Result<()> {
    nodes.for_each(|node| rows.integer(one_based(node)));
    rows.integer(tag);
    rows.end()
}

/// The number of each point, and what becomes of all that is no number of one group.
fn point_numbers(mesh: &Mesh) -> (Vec<i32>, Vec<Note>) {
    let mut notes: Vec<Note> = (0..=2).filter_map(|dim| numbers_only(&mesh.groups, dim)).collect();
    let further = mesh.memberships.iter().filter(|membership| membership.dim == 1).count();
    if further > 0 {
        notes.push(Note::FurtherGroups { count: further });
    }
    notes.extend(Note::data_not_held(mesh));
    let mut numbers = mesh.point_markers.clone();
    let of_points = || mesh.memberships.iter().filter(|membership| membership.dim == 0);
    if numbers.is_empty() && of_points().next().is_some() {
        numbers = vec![0; mesh.points.len()];
        // The first group of a point stays.
        let mut dropped = 0;
        for membership in of_points() {
            let number = &mut numbers[membership.item as usize];
            if *number == 0 {
                *number = membership.tag;
            } else {
                dropped += 1;
            }
        }
        notes.extend(Note::not_held(dropped, "further group of a point"));
    } else {
        notes.extend(Note::not_held(of_points().count(), "point in a group"));
    }
    (numbers, notes)
}
