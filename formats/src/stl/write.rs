//! Writing `.stl`.

use std::io::{self, Write};

use crate::blocks::Blocks;
use crate::groups::{Names, Note, Rules, Table};
use crate::mesh::Mesh;
use crate::rows::Rows;

/// Writes the triangles of a mesh, as bytes or as text, and says what is not held.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more facets than 32 bits can count, as bytes.
///
/// ```
/// use meshwright_formats::{Mesh, stl};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.1]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![7],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// stl::write_with(&mesh, false, &mut text)?;
/// let expected = "solid region_7\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n\
///                 vertex 0 0.1 0\nendloop\nendfacet\nendsolid region_7\n";
/// assert_eq!(text, expected.as_bytes());
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write_with(mesh: &Mesh, binary: bool, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let rules =
        Rules { numberless: true, names: Names::Words, without: Some(1), ..Rules::default() };
    let (table, mut notes) = Table::new(mesh, rules);
    notes.retain(|_| !binary);
    notes.extend(Note::not_held(mesh.edges.len(), "boundary edge"));
    notes.extend(Note::data_not_held(mesh));
    let mut rows = Rows::new(out);
    if binary {
        notes.extend(Note::regions_not_held(mesh));
        notes.extend(Note::single_precision(mesh));
        write_bytes(mesh, &mut rows)?;
    } else {
        write_text(mesh, &table, &mut rows)?;
    }
    rows.finish()?;
    Ok(notes)
}

fn write_text(mesh: &Mesh, table: &Table, rows: &mut Rows<impl Write>) -> io::Result<()> {
    let groups = (0..mesh.triangles.len()).map(|t| table.region(mesh.triangle_tag(t)));
    for (group, triangles) in Blocks::new(groups, table.entries.len()).in_use() {
        let name = &table.entries[group].name;
        rows.text(&format!("solid {name}\n"))?;
        for &triangle in triangles {
            rows.text("facet normal 0 0 1\nouter loop\n")?;
            for corner in mesh.triangles[triangle as usize] {
                let [x, y] = mesh.points[corner as usize];
                rows.text("vertex ")?;
                rows.real(x);
                rows.real(y);
                rows.integer(0);
                rows.end()?;
            }
            rows.text("endloop\nendfacet\n")?;
        }
        rows.text(&format!("endsolid {name}\n"))?;
    }
    Ok(())
}

fn write_bytes(mesh: &Mesh, rows: &mut Rows<impl Write>) -> io::Result<()> {
    let count = u32::try_from(mesh.triangles.len()).map_err(|_| io::ErrorKind::FileTooLarge)?;
    // It must not start with `solid`: some readers would take it for text.
    let mut head = [b' '; 80];
    head[..10].copy_from_slice(b"meshwright");
    rows.bytes(&head);
    rows.bytes(&count.to_le_bytes());
    for triangle in &mesh.triangles {
        let mut facet = [0; 50];
        let corners = triangle.map(|corner| mesh.points[corner as usize].map(|x| x as f32));
        let numbers = [[0.0, 0.0, 1.0]].into_iter().chain(corners.map(|[x, y]| [x, y, 0.0]));
        for (place, number) in facet.chunks_exact_mut(4).zip(numbers.flatten()) {
            place.copy_from_slice(&f32::to_le_bytes(number));
        }
        rows.bytes(&facet);
        rows.hand_on()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_binary_facet_is_a_normal_and_three_corners() {
        let mesh = Mesh {
            points: vec![[0.0, 0.0], [2.0, 0.0], [0.0, 0.1]],
            triangles: vec![[0, 1, 2]],
            triangle_tags: vec![7],
            edges: vec![[0, 1]],
            ..Mesh::default()
        };
        let mut bytes = Vec::new();
        let notes = write_with(&mesh, true, &mut bytes).unwrap();
        assert_eq!(bytes.len(), 84 + 50);
        assert_eq!(bytes[80..84], [1, 0, 0, 0]);
        let numbers = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.1, 0.0];
        assert_eq!(bytes[84..132], numbers.map(f32::to_le_bytes).concat());
        assert_eq!(bytes[132..], [0, 0]);
        let notes: Vec<String> = notes.iter().map(Note::to_string).collect();
        assert_eq!(
            notes,
            [
                "1 boundary edge is not written: the format has no place for it",
                "the format has no place for regions: 7",
                "coordinates are rounded to single precision, by up to 1.5e-9",
            ]
        );
    }
}
