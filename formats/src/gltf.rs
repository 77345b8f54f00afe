//! Writing glTF 2.0, `.glb` and `.gltf`: a mesh to look at, in a browser or any viewer.
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

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;

use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;
use crate::rows::Rows;
use document::{PLACEHOLDER, document};
use parts::{Frame, Part, parts};

/// What may be asked of a glTF file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options<'a> {
    /// One file of text, `.gltf`, with the numbers as Base64 in it: a third larger.
    pub text: bool,
    /// A colour (red, green, blue, opacity) as it is seen (sRGB) for each triangle, in place of one
    /// for each region.
    /// Triangles then have their corners to themselves.
    pub colors: Option<&'a [[u8; 4]]>,
}

/// Writes a mesh as `.glb`, and says what became of its tags.
///
/// Tags are kept, also those below 1. Provenance, markers and data are not written; groups of points
/// and further groups of an edge are not either.
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
    write_with(mesh, Options::default(), out)
}

/// Writes a mesh as [`write()`] does, with options.
///
/// # Errors
/// Those of [`write()`].
pub fn write_with(mesh: &Mesh, options: Options, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let (table, mut notes) = Table::new(mesh, Rules::default());
    // The file holds tags, not group numbers, and any name, as often as it likes.
    notes.retain(|note| {
        matches!(note, Note::NameChanged { .. } | Note::SecondName { .. } | Note::PointGroup { .. })
    });
    let frame = Frame::of(&mesh.points);
    notes.extend(Note::data_not_held(mesh));
    let parts = parts(mesh, &table, &frame, options.colors);
    let json = document(&table, &frame, &parts, options.text)?;
    if options.text {
        write_text(&json, |take| write_parts(&parts, mesh, &frame, take), out)?;
    } else {
        write_binary(json, &parts, mesh, &frame, out)?;
    }
    Ok(notes)
}

/// The bytes of all parts, block by block.
fn write_parts(
    parts: &[Part],
    mesh: &Mesh,
    frame: &Frame,
    take: &mut dyn FnMut(&[u8]) -> io::Result<()>,
) -> io::Result<()> {
    parts.iter().try_for_each(|part| part.write(mesh, frame, take))
}

/// The JSON, with the bytes in it where their place is held.
fn write_text(
    json: &[u8],
    bytes: impl FnOnce(&mut dyn FnMut(&[u8]) -> io::Result<()>) -> io::Result<()>,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut rows = Rows::new(out);
    let held = json.windows(PLACEHOLDER.len()).position(|part| part == PLACEHOLDER.as_bytes());
    let Some(start) = held else {
        rows.bytes(json); // a mesh without cells
        return rows.finish();
    };
    rows.bytes(&json[..start]);
    rows.text("data:application/octet-stream;base64,")?;
    let mut text = EncoderWriter::new(&mut rows, &STANDARD);
    bytes(&mut |block| text.write_all(block))?;
    text.finish()?;
    drop(text);
    rows.bytes(&json[start + PLACEHOLDER.len()..]);
    rows.text("\n")?;
    rows.finish()
}

fn write_binary(
    mut json: Vec<u8>,
    parts: &[Part],
    mesh: &Mesh,
    frame: &Frame,
    out: &mut impl Write,
) -> io::Result<()> {
    pad(&mut json, b' ');
    let binary: u64 = parts.iter().map(Part::bytes).sum();
    let total = 12 + 8 + json.len() as u64 + if binary > 0 { 8 + binary } else { 0 };
    let length = u32::try_from(total).map_err(|_| io::ErrorKind::FileTooLarge)?;
    out.write_all(b"glTF")?;
    out.write_all(&2_u32.to_le_bytes())?;
    out.write_all(&length.to_le_bytes())?;
    chunk(out, json.len() as u64, b"JSON")?;
    out.write_all(&json)?;
    if binary > 0 {
        chunk(out, binary, b"BIN\0")?;
        write_parts(parts, mesh, frame, &mut |block| out.write_all(block))?;
    }
    Ok(())
}

fn chunk(out: &mut impl Write, length: u64, kind: &[u8; 4]) -> io::Result<()> {
    out.write_all(&(length as u32).to_le_bytes())?;
    out.write_all(kind)
}

/// Chunks are multiples of four bytes long.
fn pad(bytes: &mut Vec<u8>, with: u8) {
    bytes.resize(bytes.len().next_multiple_of(4), with);
}
