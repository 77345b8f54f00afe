//! Writing `.msh`: what every consumer takes.
//!
//! The version is exactly `2.2`, every element has exactly two tags (physical, elementary) and
//! every physical number has a name; there is no `$Comments` section. Nodes are numbered 1 to N,
//! z is 0. Lines come before triangles.

use std::io::{self, Write};

use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;
use crate::rows::{Rows, one_based};

/// What may be asked of a `.msh` file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// Renumber the groups so that no number serves a boundary and a region: regions 1, 2, …,
    /// then boundaries.
    pub unique_ids: bool,
}

/// Writes a mesh, and says what became of its tags.
///
/// Numbers below 1 are not allowed there: such tags are mapped, and the notes say how. Provenance,
/// markers and data of points are not written.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, msh};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![0],
///     edges: vec![[0, 1]],
///     edge_tags: vec![-3],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// let notes = msh::write(&mesh, &mut text)?;
/// assert_eq!(notes[0].to_string(), "boundary -3 is written as 1, `boundary_-3`");
/// assert_eq!(notes[1].to_string(), "untagged triangles are group 2, `region`");
/// assert!(text.starts_with(b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    write_with(mesh, Options::default(), out)
}

/// Writes a mesh as [`write()`] does, with options.
///
/// # Errors
/// Those of `out`.
pub fn write_with(mesh: &Mesh, options: Options, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let rules =
        Rules { positive: true, unique: options.unique_ids, quoted: true, memberships: true };
    let (table, notes) = Table::new(mesh, rules);
    let mut rows = Rows::new(out);
    header(&mut rows, &table)?;
    nodes(&mut rows, mesh)?;
    elements(&mut rows, mesh, &table)?;
    rows.finish()?;
    Ok(notes)
}

fn header(rows: &mut Rows<impl Write>, table: &Table) -> io::Result<()> {
    rows.text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")?;
    if table.entries.is_empty() {
        return Ok(());
    }
    rows.text("$PhysicalNames\n")?;
    rows.integers(&[table.entries.len() as i64])?;
    for entry in &table.entries {
        let (dim, number, name) = (entry.dim, entry.number, &entry.name);
        rows.text(&format!("{dim} {number} \"{name}\"\n"))?;
    }
    rows.text("$EndPhysicalNames\n")
}

fn nodes(rows: &mut Rows<impl Write>, mesh: &Mesh) -> io::Result<()> {
    rows.text("$Nodes\n")?;
    rows.integers(&[mesh.points.len() as i64])?;
    for (number, &[x, y]) in (1_i64..).zip(&mesh.points) {
        rows.integer(number);
        rows.real(x);
        rows.real(y);
        rows.integer(0);
        rows.end()?;
    }
    rows.text("$EndNodes\n")
}

fn elements(rows: &mut Rows<impl Write>, mesh: &Mesh, table: &Table) -> io::Result<()> {
    rows.text("$Elements\n")?;
    let count = mesh.memberships.len() + mesh.edges.len() + mesh.triangles.len();
    rows.integers(&[count as i64])?;
    let mut number = 0;
    for (&[a, b], &group) in mesh.edges.iter().zip(&table.edges) {
        number += 1;
        let group = i64::from(table.entries[group as usize].number);
        rows.integers(&[number, 1, 2, group, group, one_based(a), one_based(b)])?;
    }
    // As Gmsh writes them: an element for each group that a point or an edge is in.
    for (membership, &group) in mesh.memberships.iter().zip(&table.memberships) {
        number += 1;
        let group = i64::from(table.entries[group as usize].number);
        match membership.dim {
            0 => rows.integers(&[number, 15, 2, group, group, one_based(membership.item)])?,
            _ => {
                let [a, b] = mesh.edges[membership.item as usize].map(one_based);
                rows.integers(&[number, 1, 2, group, group, a, b])?;
            }
        }
    }
    for (triangle, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        number += 1;
        let group = table.region(mesh.triangle_tag(triangle));
        let group = i64::from(table.entries[group].number);
        let [a, b, c] = [a, b, c].map(one_based);
        rows.integers(&[number, 2, 2, group, group, a, b, c])?;
    }
    rows.text("$EndElements\n")
}
