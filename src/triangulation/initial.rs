//! The initial constrained triangulation: the only door to `spade`.

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};

use super::{Edge, Triangle};
use crate::Region;
use crate::corners::previous;
use crate::domain::Domain;
use crate::predicates::{Side, side};

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

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

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
    let domain_points = along_hilbert_curve(&domain.points);
    let mut points: Vec<_> = domain_points.iter().map(|&i| domain.points[i as usize]).collect();
    if domain.region == Region::Global {
        points.extend(box_around(&points));
    }
    let cdt = load(&points, &constraints(domain, &domain_points))?;
    let (triangles, slots) = triangles_of(&cdt);
    if triangles.iter().any(|t| !counter_clockwise(t, &points)) {
        return Err(Error::Range);
    }
    let open = open_to_the_outside(&cdt).map(|face| slots[face]).collect();
    Ok(Initial { points, domain_points, triangles, open })
}

/// The segments by the new numbers of their points.
fn constraints(domain: &Domain, domain_points: &[u32]) -> Vec<[usize; 2]> {
    let mut place = vec![0; domain_points.len()];
    for (new, &old) in domain_points.iter().enumerate() {
        place[old as usize] = new;
    }
    domain.segments.iter().map(|ends| ends.map(|v| place[v as usize])).collect()
}

fn load(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<Cdt, Error> {
    let vertices = points.iter().map(|&point| position(point)).collect();
    let mut conflicts = 0;
    let cdt = Cdt::try_bulk_load_cdt(vertices, segments.to_vec(), |_| conflicts += 1)
        .map_err(|_| Error::Range)?;
    let whole = conflicts == 0 && cdt.num_vertices() == points.len();
    if whole { Ok(cdt) } else { Err(Error::Range) }
}

/// `spade` takes no coordinate below 2^-142; in a domain whose largest is above 2^-100 those are
/// zero for every purpose but an exact predicate's, which [`triangulate`] asks afterwards.
fn position([x, y]: [f64; 2]) -> Point2<f64> {
    let snap = |c: f64| if c.abs() < spade::MIN_ALLOWED_VALUE { 0.0 } else { c };
    Point2::new(snap(x), snap(y))
}

/// The inner faces as linked triangles in the order of their smallest vertex, for locality; and
/// the slot of each face.
fn triangles_of(cdt: &Cdt) -> (Vec<Triangle>, Vec<u32>) {
    let mut order: Vec<(u32, u32)> = cdt
        .inner_faces()
        .map(|face| {
            let smallest = face.vertices().iter().map(|v| v.index()).min().unwrap_or(0);
            (smallest as u32, face.index() as u32)
        })
        .collect();
    order.sort_unstable();
    let mut slots = vec![u32::MAX; cdt.num_all_faces()];
    for (slot, &(_, face)) in order.iter().enumerate() {
        slots[face as usize] = slot as u32;
    }

    let mut triangles = vec![None; order.len()];
    for face in cdt.inner_faces() {
        let edges = face.adjacent_edges();
        // Vertex i starts edge i of spade's, which is opposite our vertex i + 2.
        let vertices = edges.map(|edge| edge.from().index() as u32);
        let neighbors = [1, 2, 0].map(|i| {
            let twin = edges[i].rev();
            let Some(inner) = twin.face().as_inner() else {
                return Edge::OUTSIDE;
            };
            let own = inner.adjacent_edges().map(|edge| edge.fix());
            let place = own.iter().position(|&edge| edge == twin.fix()).unwrap_or(0);
            Edge::new(slots[inner.index()], previous(place))
                .constrained_if(twin.is_constraint_edge())
        });
        triangles[slots[face.index()] as usize] = Some(Triangle { vertices, neighbors });
    }
    (triangles.into_iter().flatten().collect(), slots)
}

/// The inner faces at an edge of the hull that is no segment.
fn open_to_the_outside(cdt: &Cdt) -> impl Iterator<Item = usize> + '_ {
    let open = cdt.convex_hull().filter(|edge| !edge.is_constraint_edge());
    open.filter_map(|edge| edge.rev().face().as_inner().map(|face| face.index()))
}

fn counter_clockwise(triangle: &Triangle, points: &[[f64; 2]]) -> bool {
    let [a, b, c] = triangle.vertices.map(|v| points[v as usize]);
    side(a, b, c) == Side::Left
}

/// The corners of a box that is larger than the points' by its size on every side: no segment's
/// diametral disc reaches them.
fn box_around(points: &[[f64; 2]]) -> [[f64; 2]; 4] {
    let (low, high) = extent(points);
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let ([left, bottom], [right, top]) = (low.map(|c| c - size), high.map(|c| c + size));
    [[left, bottom], [right, bottom], [right, top], [left, top]]
}

/// The least and the largest coordinates.
fn extent(points: &[[f64; 2]]) -> ([f64; 2], [f64; 2]) {
    let empty = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    points.iter().fold(empty, |(low, high), point| {
        ([0, 1].map(|i| low[i].min(point[i])), [0, 1].map(|i| high[i].max(point[i])))
    })
}

/// The indices of the points in their order along a Hilbert curve through their bounding square,
/// 2^16 cells a side. Scaling by a power of two changes nothing.
fn along_hilbert_curve(points: &[[f64; 2]]) -> Vec<u32> {
    let (low, high) = extent(points);
    let width = (high[0] - low[0]).max(high[1] - low[1]);
    let cell = |c: f64, i: usize| ((c - low[i]) / width * 65535.0) as u32;
    let mut keyed: Vec<(u32, u32)> = points
        .iter()
        .enumerate()
        .map(|(index, &[x, y])| (hilbert_index(cell(x, 0), cell(y, 1)), index as u32))
        .collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, index)| index).collect()
}

/// The place along the Hilbert curve of cell (x, y) of a grid of 2^16 by 2^16 cells.
fn hilbert_index(mut x: u32, mut y: u32) -> u32 {
    let mut index = 0;
    for level in (0..16).rev() {
        let (right, up) = (x >> level & 1, y >> level & 1);
        index = index << 2 | ((3 * right) ^ up);
        if up == 0 {
            if right == 1 {
                (x, y) = (!x, !y);
            }
            (x, y) = (y, x);
        }
    }
    index
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_along_the_hilbert_curve_share_a_side() {
        let mut cells: Vec<_> = (0..64)
            .flat_map(|x| (0..64).map(move |y| (hilbert_index(x << 10, y << 10), x, y)))
            .collect();
        cells.sort_unstable();
        for pair in cells.windows(2) {
            let ((_, x, y), (_, u, v)) = (pair[0], pair[1]);
            assert_eq!(u32::abs_diff(x, u) + u32::abs_diff(y, v), 1, "{pair:?}");
        }
    }
}
