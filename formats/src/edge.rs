//! All edges of a mesh, in Triangle's `.edge` files.
//!
//! ```text
//! edges := <number of edges> <1: markers> edge*
//! edge  := <number> <end point> <end point> <marker>
//! ```
//!
//! Everything is counted from one; the points stand in the `.node` file. Triangle itself does not
//! read these files (<https://www.cs.cmu.edu/~quake/triangle.edge.html>), nor do we: the boundary
//! and the interfaces with their tags are the segments of the `.poly` file.

use std::io::{self, Write};

use crate::groups::{Note, numbers_only};
use crate::mesh::Mesh;
use crate::pslg::Tag;
use crate::rows::{Rows, one_based};

/// Writes each edge of the mesh once, by its end points, the smaller number first.
///
/// The marker is the tag of the boundary or interface edge; all others have 0, as untagged ones
/// have. (Triangle gives 1 to an untagged edge of the boundary, which would be a number that the
/// user may have given to others.) Names are not written, which a note says.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, edge};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     edges: vec![[2, 0]],
///     edge_tags: vec![-3],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// edge::write(&mesh, &mut text)?;
/// assert_eq!(text, b"3 1\n1 1 2 0\n2 1 3 -3\n3 2 3 0\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let mut rows = Rows::new(out);
    let edges = edges(mesh);
    rows.integers(&[edges.len() as i64, 1])?;
    for (number, ([a, b], tag)) in (1..).zip(edges) {
        rows.integers(&[number, one_based(a), one_based(b), i64::from(tag)])?;
    }
    rows.finish()?;
    Ok(numbers_only(&mesh.groups, 1).into_iter().collect())
}

/// The edges of the triangles and of the list, each once, sorted, with their tags.
fn edges(mesh: &Mesh) -> Vec<([u32; 2], Tag)> {
    const UNLISTED: u32 = u32::MAX;
    let sorted = |[a, b]: [u32; 2]| if a < b { [a, b] } else { [b, a] };
    let listed = (0..).zip(&mesh.edges).map(|(edge, &ends)| (sorted(ends), edge));
    let sides = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<_> = listed.chain(sides.map(|ends| (sorted(ends), UNLISTED))).collect();
    // Of equal ends the listed one comes first and stays.
    edges.sort_unstable();
    edges.dedup_by_key(|&mut (ends, _)| ends);
    let tag = |edge| if edge == UNLISTED { 0 } else { mesh.edge_tag(edge as usize) };
    edges.into_iter().map(|(ends, edge)| (ends, tag(edge))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pslg::Group;

    /// Two triangles over a square, and an edge that no triangle has.
    fn square() -> Mesh {
        Mesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 2.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            edges: vec![[2, 0], [4, 2]],
            edge_tags: vec![7, 8],
            groups: vec![
                Group { dim: 1, tag: 7, name: "wall".into() },
                Group { dim: 2, tag: 7, name: "room".into() },
            ],
            ..Mesh::default()
        }
    }

    #[test]
    fn every_edge_stands_there_once_with_its_tag() {
        let ends = [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [2, 4]];
        let tags = [0, 7, 0, 0, 0, 8];
        assert_eq!(edges(&square()), ends.into_iter().zip(tags).collect::<Vec<_>>());
    }

    #[test]
    fn names_that_are_not_written_are_told() {
        let notes = write(&square(), &mut Vec::new()).expect("memory takes all");
        let notes: Vec<_> = notes.iter().map(Note::to_string).collect();
        assert_eq!(notes, ["boundaries have numbers here, no names: `wall` (7)"]);
    }
}
