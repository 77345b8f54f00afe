//! The initial constrained Delaunay triangulation: points along a Hilbert curve, then segments.

use std::borrow::Cow;

use super::constraints::constrain;
use super::insertion::{GHOST, delaunay};
use super::{Edge, Triangle, Triangulation};
use crate::Region;
use crate::corners::each;
use crate::domain::Domain;
use crate::hilbert::Curve;
use crate::radix::sort_by_upper_half;

/// The constrained Delaunay triangulation of a whole domain's convex hull (or of a box around it),
/// before carving.
#[derive(Debug)]
pub struct Initial {
    /// The domain's points along a Hilbert curve; behind them, where the whole is refined
    /// ([`Region::Global`]), the corners of a box around them.
    pub points: Vec<[f64; 2]>,
    /// For each point of the domain, its index there.
    pub domain_points: Vec<u32>,
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

/// Triangulates the convex hull of the domain, with every segment an edge.
///
/// Where the whole is refined it is a box. A segment along the hull would have nothing behind it but
/// triangles as flat as rounding made them, and a point that splits it would lie beyond those.
///
/// # Errors
/// See [`Error`].
pub fn triangulate(domain: &Domain) -> Result<Initial, Error> {
    if domain.points.len() >= 1 << 27 {
        return Err(Error::TooManyPoints);
    }
    let mut order = along_hilbert_curve(&domain.points);
    let mut points = Cow::Borrowed(&domain.points);
    if domain.region == Region::Global {
        order.extend((points.len() as u32..).take(4));
        points.to_mut().extend(box_around(&domain.points));
    }
    let (mut mesh, mut domain_points) = delaunay(order, &points).ok_or(Error::Range)?;
    domain_points.truncate(domain.points.len());
    constrain(&mut mesh, segments(domain, &domain_points)).map_err(|_| Error::Range)?;
    Ok(without_ghosts(mesh, domain_points))
}

/// The segments by the vertices of their points: vertex i + 1 is `domain_points[i]`.
fn segments(domain: &Domain, domain_points: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let mut vertices = vec![0; domain_points.len()];
    for (vertex, &point) in (1..).zip(domain_points) {
        vertices[point as usize] = vertex;
    }
    domain.segments.iter().map(move |ends| ends.map(|point| vertices[point as usize]))
}

/// The triangles that are none, taken out; the others in the order of their first vertices, for
/// locality.
fn without_ghosts(mesh: Triangulation, domain_points: Vec<u32>) -> Initial {
    let Triangulation { mut points, triangles: with_ghosts, .. } = mesh;
    let (places, count) = places_without_ghosts(&with_ghosts, points.len());
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
    points.remove(GHOST as usize);
    Initial { points, domain_points, triangles, open }
}

/// The new slot of each triangle, by its first vertex, and how many are left: ghosts, which are not,
/// come behind these. (A counting sort.)
fn places_without_ghosts(triangles: &[Triangle], vertices: usize) -> (Vec<u32>, u32) {
    let first = |triangle: &Triangle| match triangle.vertices.into_iter().min() {
        Some(GHOST) | None => vertices,
        Some(vertex) => vertex as usize,
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
    (triangles.iter().map(place).collect(), count)
}

/// The corners of a box that is larger than the points' by its size on every side: no segment's
/// diametral disc reaches them.
fn box_around(points: &[[f64; 2]]) -> [[f64; 2]; 4] {
    let (low, high) = extent(points.iter().copied());
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let ([left, bottom], [right, top]) = (low.map(|c| c - size), high.map(|c| c + size));
    [[left, bottom], [right, bottom], [right, top], [left, top]]
}

/// The least and the largest coordinates.
fn extent(points: impl Iterator<Item = [f64; 2]>) -> ([f64; 2], [f64; 2]) {
    let empty = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    points.fold(empty, |(low, high), point| {
        ([0, 1].map(|i| low[i].min(point[i])), [0, 1].map(|i| high[i].max(point[i])))
    })
}

/// The indices of the points in their order along a Hilbert curve through their bounding square.
/// Scaling by a power of two changes nothing.
fn along_hilbert_curve(points: &[[f64; 2]]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    sort_along_hilbert_curve(points, &mut order);
    order
}

/// So many points may share a cell of the curve; more get a curve of their own, or the walks
/// through a cluster would be long.
const CLUSTER: usize = 64;

fn sort_along_hilbert_curve(points: &[[f64; 2]], indices: &mut [u32]) {
    let (low, high) = extent(indices.iter().map(|&i| points[i as usize]));
    let curve = Curve::new(low, high);
    let placed = indices.iter().map(|&i| (points[i as usize], u64::from(i)));
    let mut placed: Vec<u64> = placed.map(|(p, i)| u64::from(curve.place(p)) << 32 | i).collect();
    sort_by_upper_half(&mut placed);
    indices.iter_mut().zip(&placed).for_each(|(i, &placed)| *i = placed as u32);
    let mut rest = indices;
    for cell in placed.chunk_by(|a, b| a >> 32 == b >> 32) {
        let (own, others) = rest.split_at_mut(cell.len());
        if cell.len() > CLUSTER && cell.len() < placed.len() {
            sort_along_hilbert_curve(points, own);
        }
        rest = others;
    }
}
