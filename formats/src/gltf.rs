//! Writing glTF 2.0, `.glb`: a mesh to look at, in a browser or any viewer.
//!
//! One node and one mesh for each group: triangles for a region, lines for a boundary. The node
//! has the group's name and `extras {tag, dim}`. Coordinates are single precision there, so they
//! are relative to the middle of the mesh; its true coordinates are `origin` in the root's
//! `extras`: x = origin + scale · position, `scale` a power of two, 1 but for meshes that single
//! precision cannot hold. glTF's unit is the metre. Colours are per vertex, and unlit: no lights
//! are needed. (<https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html>)

mod document;
mod parts;
#[cfg(test)]
mod tests;

use std::io::{self, Write};

use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;
use parts::Frame;

/// Writes a mesh as `.glb`, and says what became of its tags.
///
/// Tags are kept, also those below 1. Provenance, markers and data are not written.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more than the 4 GiB that `.glb` can hold.
///
/// ```
/// use meshwright_formats::{Mesh, gltf};
/// let mesh = Mesh {
///     points: vec![[500_000.0, 0.0], [500_001.0, 0.0], [500_000.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![7],
///     ..Mesh::default()
/// };
/// let mut bytes = Vec::new();
/// gltf::write(&mesh, &mut bytes)?;
/// let text = String::from_utf8_lossy(&bytes);
/// assert!(text.starts_with("glTF"));
/// assert!(text.contains(r#""extras":{"origin":[500000.5,0.25],"scale":1.0}"#));
/// assert!(text.contains(r#""extras":{"tag":7,"dim":2},"mesh":0,"name":"region_7""#));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let (table, mut notes) = Table::new(mesh, Rules::default());
    // The file holds tags, not group numbers, and any name, as often as it likes.
    notes.retain(|note| {
        matches!(note, Note::NameChanged { .. } | Note::SecondName { .. } | Note::PointGroup { .. })
    });
    let frame = Frame::of(&mesh.points);
    let parts = parts::parts(mesh, &table, &frame);
    let mut json = document::document(&table, &frame, &parts)?;
    pad(&mut json, b' ');
    let binary: u64 = parts.iter().map(parts::Part::bytes).sum();
    let total = 12 + 8 + json.len() as u64 + if binary > 0 { 8 + binary } else { 0 };
    let length = u32::try_from(total).map_err(|_| io::ErrorKind::FileTooLarge)?;
    out.write_all(b"glTF")?;
    out.write_all(&2_u32.to_le_bytes())?;
    out.write_all(&length.to_le_bytes())?;
    chunk(out, json.len() as u64, b"JSON")?;
    out.write_all(&json)?;
    if binary > 0 {
        chunk(out, binary, b"BIN\0")?;
        for part in &parts {
            part.write(mesh, &frame, out)?;
        }
    }
    Ok(notes)
}

fn chunk(out: &mut impl Write, length: u64, kind: &[u8; 4]) -> io::Result<()> {
    out.write_all(&(length as u32).to_le_bytes())?;
    out.write_all(kind)
}

/// Chunks are multiples of four bytes long.
fn pad(bytes: &mut Vec<u8>, with: u8) {
    bytes.resize(bytes.len().next_multiple_of(4), with);
}
