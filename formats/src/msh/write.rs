//! Writing `.msh`: what every consumer takes.
//!
//! Every element has exactly two tags (physical, elementary) and every physical number has a name;
//! there is no `$Comments` section. Nodes are numbered 1 to N as in the mesh, z is 0. Elements are
//! numbered from 1, edges first, triangles last. Data stand at the end of the file.

mod data;
mod entities;
mod layer;
mod scribe;
#[cfg(test)]
mod tests;
mod version_2;
mod version_4;

use std::io::{self, Write};

use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;
use crate::nodes::{Nodes, Order};
use scribe::Scribe;

/// What may be asked of a `.msh` file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// The version of the format.
    pub version: Version,
    /// Numbers as bytes (little endian), not as text: smaller and faster, and fewer programs read
    /// it.
    pub binary: bool,
    /// How many nodes an element has.
    pub order: Order,
    /// Write an edge once, in its first group alone, and no groups of points: for programs that would
    /// count an edge twice, or keep its last group.
    pub one_group: bool,
    /// Renumber the groups where a number serves a boundary and a region: regions 1, 2, …, then
    /// boundaries.
    pub unique_ids: bool,
}

/// A version of the format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Version {
    /// 2.2, which every program tried reads.
    #[default]
    V2_2,
    /// 4.1, Gmsh's own since 2019: it has entities, so an edge in several groups stands there once.
    V4_1,
}

/// Writes a mesh as 2.2 text, and says what became of its tags.
///
/// Numbers below 1 are not allowed there: such tags are mapped, and the notes say how. Provenance
/// and markers of points are not written.
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
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more nodes or elements than a file with
/// numbers of 32 bits can count.
pub fn write_with(mesh: &Mesh, options: Options, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let rules = Rules {
        positive: true,
        unique: options.unique_ids,
        quoted: true,
        memberships: !options.one_group,
        ..Rules::default()
    };
    let (table, mut notes) = Table::new(mesh, rules);
    let nodes = Nodes::new(mesh, options.order)?;
    let mut scribe = Scribe::new(out, options.binary);
    scribe.format(options.version)?;
    names(&mut scribe, &table)?;
    let elements = match options.version {
        Version::V2_2 => version_2::write(&mut scribe, &nodes, &table)?,
        Version::V4_1 => version_4::write(&mut scribe, &nodes, &table)?,
    };
    data::write(&mut scribe, &nodes, elements - mesh.triangles.len(), &mut notes)?;
    scribe.finish()?;
    Ok(notes)
}

fn names(scribe: &mut Scribe<impl Write>, table: &Table) -> io::Result<()> {
    if table.entries.is_empty() {
        return Ok(());
    }
    scribe.text(&format!("$PhysicalNames\n{}\n", table.entries.len()))?;
    for entry in &table.entries {
        let (dim, number, name) = (entry.dim, entry.number, &entry.name);
        scribe.text(&format!("{dim} {number} \"{name}\"\n"))?;
    }
    scribe.text("$EndPhysicalNames\n")
}

/// Writes a mesh as one layer of prisms, which is how OpenFOAM takes a plane domain: `gmshToFoam`
/// reads the file.
///
/// Triangles become prisms of this thickness from z = 0 on, edges become quadrangles, and the
/// triangles of both ends are a group of their own, `frontAndBack`. Regions are groups of volumes,
/// boundaries of surfaces. The version is 2.2, as text; names are single words. Groups of points,
/// further groups of an edge and data are not written.
///
/// # Errors
/// Those of `out`.
pub fn write_layer(mesh: &Mesh, thickness: f64, out: &mut impl Write) -> io::Result<Vec<Note>> {
    layer::write(mesh, thickness, out)
}

/// Gmsh's numbers of the kinds of elements.
fn kinds(order: Order) -> [i32; 3] {
    match order {
        Order::First => [15, 1, 2],
        Order::Second => [15, 8, 9],
    }
}
