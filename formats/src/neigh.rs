//! The neighbours of each triangle, in Triangle's `.neigh` files.
//!
//! ```text
//! neighbours := <number of triangles> <neighbours per triangle: 3> triangle*
//! triangle   := <number> <neighbour> <neighbour> <neighbour>
//! ```
//!
//! Everything is counted from one; the triangles stand in the `.ele` file. The first neighbour
//! lies opposite the first corner, and so on; −1 where there is none. Triangle itself does not
//! read these files (<https://www.cs.cmu.edu/~quake/triangle.neigh.html>), nor do we.

use std::io::{self, Write};

use crate::groups::Note;
use crate::mesh::Mesh;
use crate::rows::{Rows, one_based};

/// Writes the neighbours of each triangle. There is nothing to note.
///
/// Triangles on both sides of an interface are neighbours. Where more than two triangles share an
/// edge, which no triangulation of a plane domain has, none is a neighbour across it.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, neigh};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
///     triangles: vec![[0, 1, 2], [0, 2, 3]],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// neigh::write(&mesh, &mut text)?;
/// assert_eq!(text, b"2 3\n1 -1 2 -1\n2 -1 -1 1\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let mut rows = Rows::new(out);
    rows.integers(&[mesh.triangles.len() as i64, 3])?;
    for (number, neighbors) in (1..).zip(neighbors(&mesh.triangles)) {
        let [a, b, c] = neighbors.map(|neighbor| neighbor.map_or(-1, one_based));
        rows.integers(&[number, a, b, c])?;
    }
    rows.finish()?;
    Ok(Vec::new())
}

/// The triangles opposite the corners of each triangle.
fn neighbors(triangles: &[[u32; 3]]) -> Vec<[Option<u32>; 3]> {
    let mut sides = Vec::with_capacity(3 * triangles.len());
    for (triangle, &[a, b, c]) in (0_u32..).zip(triangles) {
        for (corner, [v, w]) in [[b, c], [c, a], [a, b]].into_iter().enumerate() {
            sides.push(([v.min(w), v.max(w)], triangle, corner));
        }
    }
    sides.sort_unstable();
    let mut neighbors = vec![[None; 3]; triangles.len()];
    for shared in sides.chunk_by(|one, other| one.0 == other.0) {
        if let &[(_, one, corner), (_, other, opposite)] = shared {
            neighbors[one as usize][corner] = Some(other);
            neighbors[other as usize][opposite] = Some(one);
        }
    }
    neighbors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbors_lie_opposite_the_corners() {
        // A triangle in the middle of three.
        let triangles = [[0, 1, 2], [1, 0, 3], [4, 2, 1], [2, 0, 5]];
        let around = neighbors(&triangles);
        assert_eq!(around[0], [Some(2), Some(3), Some(1)]);
        assert_eq!(around[1], [None, None, Some(0)]);
        assert_eq!(around[2], [Some(0), None, None]);
        assert_eq!(around[3], [None, None, Some(0)]);
    }

    #[test]
    fn an_edge_of_three_triangles_has_no_neighbors() {
        assert_eq!(neighbors(&[[0, 1, 2], [1, 0, 3], [0, 1, 4]]), [[None; 3]; 3]);
    }
}
