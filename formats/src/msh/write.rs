//! Writing `.msh`: what every consumer takes.
//!
//! The version is exactly `2.2`, every element has exactly two tags (physical, elementary) and
//! every physical number has a name; there is no `$Comments` section. Nodes are numbered 1 to N,
//! z is 0. Lines come before triangles.

use std::io::{self, Write};

use crate::digits::{push_integer, push_real};
use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;

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
    let rules = Rules { positive: true, unique: options.unique_ids, quoted: true };
    let (table, notes) = Table::new(mesh, rules);
    let mut text = Text { buffer: Vec::with_capacity(2 * BLOCK), out };
    text.header(&table)?;
    text.nodes(mesh)?;
    text.elements(mesh, &table)?;
    text.out.write_all(&text.buffer)?;
    Ok(notes)
}

/// Bytes that are gathered before they are handed on.
const BLOCK: usize = 1 << 16;

struct Text<'a, W> {
    buffer: Vec<u8>,
    out: &'a mut W,
}

impl<W: Write> Text<'_, W> {
    fn header(&mut self, table: &Table) -> io::Result<()> {
        self.buffer.extend(b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
        if table.entries.is_empty() {
            return Ok(());
        }
        self.buffer.extend(b"$PhysicalNames\n");
        self.line(&[table.entries.len() as i64])?;
        for entry in &table.entries {
            let (dim, number, name) = (entry.dim, entry.number, &entry.name);
            self.buffer.extend(format!("{dim} {number} \"{name}\"\n").bytes());
        }
        self.buffer.extend(b"$EndPhysicalNames\n");
        Ok(())
    }

    fn nodes(&mut self, mesh: &Mesh) -> io::Result<()> {
        self.buffer.extend(b"$Nodes\n");
        self.line(&[mesh.points.len() as i64])?;
        for (number, &[x, y]) in (1_i64..).zip(&mesh.points) {
            push_integer(&mut self.buffer, number);
            self.buffer.push(b' ');
            push_real(&mut self.buffer, x);
            self.buffer.push(b' ');
            push_real(&mut self.buffer, y);
            self.buffer.extend(b" 0\n");
            self.hand_on()?;
        }
        self.buffer.extend(b"$EndNodes\n");
        Ok(())
    }

    fn elements(&mut self, mesh: &Mesh, table: &Table) -> io::Result<()> {
        self.buffer.extend(b"$Elements\n");
        self.line(&[mesh.edges.len() as i64 + mesh.triangles.len() as i64])?;
        let mut number = 0;
        for (&[a, b], &group) in mesh.edges.iter().zip(&table.edges) {
            number += 1;
            let group = i64::from(table.entries[group as usize].number);
            self.line(&[number, 1, 2, group, group, node(a), node(b)])?;
        }
        for (triangle, &[a, b, c]) in mesh.triangles.iter().enumerate() {
            number += 1;
            let group = table.region(mesh.triangle_tag(triangle));
            let group = i64::from(table.entries[group].number);
            self.line(&[number, 2, 2, group, group, node(a), node(b), node(c)])?;
        }
        self.buffer.extend(b"$EndElements\n");
        Ok(())
    }

    fn line(&mut self, numbers: &[i64]) -> io::Result<()> {
        for &number in numbers {
            push_integer(&mut self.buffer, number);
            self.buffer.push(b' ');
        }
        if let Some(last) = self.buffer.last_mut() {
            *last = b'\n';
        }
        self.hand_on()
    }

    fn hand_on(&mut self) -> io::Result<()> {
        if self.buffer.len() >= BLOCK {
            self.out.write_all(&self.buffer)?;
            self.buffer.clear();
        }
        Ok(())
    }
}

/// The number of a node: they are counted from one.
fn node(index: u32) -> i64 {
    i64::from(index) + 1
}
