//! The initial constrained Delaunay triangulation: points along a Hilbert curve, then segments.

use super::constraints::constrain;
use super::insertion::{GHOST, delaunay};
use super::{Edge, Triangle, Triangulation};
use crate::Region;
use crate::corners::each;
use crate::domain::{Domain, coarse_points, extent};
use crate::memory::give_back;

/// The constrained Delaunay triangulation of a whole domain's convex hull (or of a box around it),
/// before carving.
#[derive(Debug)]
pub struct Initial {
    /// The domain's points; behind them, where the whole is refined ([`Region::Global`]), the corners
    /// of a box around them.
    pub points: Vec<[f64; 2]>,
    /// All triangles, in the order of their first vertices.
    pub triangles: Vec<Triangle>,
    /// The triangles at an edge of the convex hull that is no segment.
    pub open: Vec<u32>,
}

/// Why there is no initial triangulation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// More points than 32-bit indices, less the three bits of an edge, can tell apart.
    #[error("the outline has too many points: 2^27 are possible")]
    TooManyPoints,
    /// The coordinates of the outline differ so much in magnitude that no triangle can be told
    /// from a line.
    #[error(
        "the coordinates differ too much in magnitude to be told apart; move the outline to the \
         origin, or leave out the details"
    )]
    Range,
}

/// Triangulates the convex hull of the domain, with every segment an edge. Returns the domain too,
/// with its points in the order of the vertices.
///
/// Where the whole is refined it is a box. A segment along the hull would have nothing behind it but
/// triangles as flat as rounding made them, and a point that splits it would lie beyond those.
///
/// # Errors
/// See [`Error`].
pub fn triangulate(domain: Domain) -> Result<(Domain, Initial), Error> {
    if domain.points.len() >= 1 << 27 {
        return Err(Error::TooManyPoints);
    }
    let domain = domain.along_hilbert_curve();
    let around = (domain.region == Region::Global).then(|| box_around(&domain.points));
    let mut mesh =
        delaunay(&domain.points, around.as_slice().as_flattened()).ok_or(Error::Range)?;
    // Vertex i + 1 is point i, until the ghosts' vertex goes.
    let segments = domain.segments.iter().map(|ends| ends.map(|point| point + 1));
    constrain(&mut mesh, segments).map_err(|_| Error::Range)?;
    let coarse = coarse_points(domain.points.len()) as u32;
    Ok((domain, without_ghosts(mesh, coarse)))
}

/// The triangles that are none, taken out; the others in the order of their first vertices, for
/// locality: those that come behind the `coarse` points, which are spread everywhere.
fn without_ghosts(mesh: Triangulation, coarse: u32) -> Initial {
    let Triangulation { mut points, triangles: with_ghosts, .. } = mesh;
    let (places, count) = places_without_ghosts(&with_ghosts, points.len(), coarse);
    let mut open = Vec::new();
    // (Moved in their own memory, each would wait for the one whose place it takes.)
    let mut triangles = vec![Triangle::VACANT; count as usize];
    for (triangle, &place) in with_ghosts.iter().zip(&places) {
        let Some(moved) = triangles.get_mut(place as usize) else { continue };
        moved.vertices = each(triangle.vertices, |v| v - 1);
        moved.neighbors = each(triangle.neighbors, |edge| {
            let behind = places[edge.triangle() as usize];
            if behind < count {
                return Edge::new(behind, edge.index()).constrained_if(edge.is_constrained());
            }
            if !edge.is_constrained() {
                open.push(place);
            }
            Edge::OUTSIDE
        });
    }
    give_back(with_ghosts);
    give_back(places);
    points.remove(GHOST as usize);
    Initial { points, triangles, open }
}

/// The new slot of each triangle, by its first vertex, and how many are left: ghosts, which are not,
/// come behind these. (A counting sort.)
fn places_without_ghosts(triangles: &[Triangle], vertices: usize, coarse: u32) -> (Vec<u32>, u32) {
    let first = |triangle: &Triangle| match triangle.vertices.into_iter().min() {
        Some(GHOST) | None => vertices,
        Some(vertex) => {
            // (Vertex i + 1 is point i.)
            let others = triangle.vertices.into_iter().filter(|&v| v > coarse);
            others.min().unwrap_or(vertex) as usize
        }
    };
    let mut starts = vec![0_u32; vertices + 2];
    triangles.iter().for_each(|triangle| starts[first(triangle) + 1] += 1);
    for v in 1..starts.len() {
        starts[v] += starts[v - 1];
    }
    let count = starts[vertices];
    let place = |triangle: &Triangle| {
        let start = &mut starts[first(triangle)];
        *start += 1;
        *start - 1
    };
    let places = triangles.iter().map(place).collect();
    give_back(starts);
    (places, count)
}

/// The corners of a box that is larger than the points' by its size on every side: no segment's
/// diametral disc reaches them.
fn box_around(points: &[[f64; 2]]) -> [[f64; 2]; 4] {
    let (low, high) = extent(points.iter().copied());
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let ([left, bottom], [right, top]) = (low.map(|c| c - size), high.map(|c| c + size));
    [[left, bottom], [right, bottom], [right, top], [left, top]]
}
