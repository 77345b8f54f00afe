//! The outline that a mesh is: its boundary, its interfaces and all its points.

use crate::formats::{Attribute, Enclosed, LocalArea, Region, Source, Values};
use crate::predicates::{Side, side};
use crate::vector::Vector;
use crate::{Mesh, Pslg};

/// Why a mesh is not the mesh of an outline.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OutlineOfError {
    /// An edge with more than two triangles.
    #[error("triangles {}, {} and {} (counted from 0) share an edge: it can have two", .0[0], .0[1], .0[2])]
    ThreeTriangles([u32; 3]),
    /// A part of the mesh without room for a point inside it.
    #[error("triangle {0} (counted from 0) has no area, nor has any that it is joined to")]
    Flat(u32),
    /// Areas for another number of triangles.
    #[error("there are {areas} areas for {triangles} triangles")]
    OtherAreas {
        /// How many areas.
        areas: usize,
        /// How many triangles.
        triangles: usize,
    },
}

/// The outline of a mesh, to be refined as Triangle's `-r` does: all points are kept; the edges,
/// the boundary and what separates two regions are segments; what the triangles cover is meshed.
///
/// `max_areas` holds a bound on the area for each triangle, or nothing. It holds for every triangle
/// whose centroid lies there. Triangles are counted from zero.
///
/// ```
/// use meshwright::{Mesh, outline_of};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
///     triangles: vec![[0, 1, 2], [0, 2, 3]],
///     triangle_tags: vec![7, 7],
///     edges: vec![[0, 1]],
///     edge_tags: vec![5],
///     ..Mesh::default()
/// };
/// let outline = outline_of(&mesh, &[Some(0.1), None])?;
/// assert_eq!(outline.segments, [[0, 1], [0, 3], [1, 2], [2, 3]]);
/// assert_eq!(outline.segment_tags, [5, 0, 0, 0]);
/// assert_eq!(outline.regions[0].tag, 7);
/// # Ok::<(), meshwright::OutlineOfError>(())
/// ```
///
/// # Errors
/// See [`OutlineOfError`].
pub fn outline_of(mesh: &Mesh, max_areas: &[Option<f64>]) -> Result<Pslg, OutlineOfError> {
    let (areas, triangles) = (max_areas.len(), mesh.triangles.len());
    if areas != 0 && areas != triangles {
        return Err(OutlineOfError::OtherAreas { areas, triangles });
    }
    let sides = Sides::of(mesh)?;
    let mut segments = mesh.edges.clone();
    let mut segment_tags: Vec<_> = (0..segments.len()).map(|edge| mesh.edge_tag(edge)).collect();
    segments.extend(sides.separating(mesh).filter(|ends| !sides.is_edge(*ends)));
    segment_tags.resize(segments.len(), 0);
    let attributes = mesh.point_data.iter().filter_map(|data| match &data.values {
        Values::Real(values) if data.components == 1 => {
            Some(Attribute { name: data.name.clone(), values: values.clone() })
        }
        _ => None,
    });
    let corners = |triangle: usize| mesh.triangles[triangle].map(|v| mesh.points[v as usize]);
    let bounded = max_areas.iter().enumerate();
    let local_areas = bounded.filter_map(|(triangle, max_area)| {
        max_area.map(|max_area| LocalArea { corners: corners(triangle), max_area })
    });
    Ok(Pslg {
        points: mesh.points.clone(),
        point_markers: mesh.point_markers.clone(),
        point_attributes: attributes.collect(),
        segments,
        segment_tags,
        enclosed: Enclosed::Seeded,
        regions: regions(mesh, &sides)?,
        local_areas: local_areas.collect(),
        groups: mesh.groups.clone(),
        // The edges come first among the segments: their indices stay.
        memberships: mesh.memberships.clone(),
        source: Source { first_number: 1, ..Source::default() },
        ..Pslg::default()
    })
}

/// The outline that a mesh was made from, as far as the mesh tells: its boundary, its edges and
/// what separates two regions, with their tags, and nothing of what lies between. It can be meshed
/// anew.
///
/// Of the points those stay that are on a segment or in a group, in their order; a side of triangles
/// is a segment each.
///
/// ```
/// use meshwright::{Mesh, boundary_of};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [0.5, 0.5], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
///     triangles: vec![[0, 2, 1], [2, 3, 1], [3, 4, 1], [4, 0, 1]],
///     ..Mesh::default()
/// };
/// let outline = boundary_of(&mesh)?;
/// assert_eq!(outline.points.len(), 4);
/// assert_eq!(outline.segments, [[0, 1], [0, 3], [1, 2], [2, 3]]);
/// # Ok::<(), meshwright::OutlineOfError>(())
/// ```
///
/// # Errors
/// See [`OutlineOfError`].
pub fn boundary_of(mesh: &Mesh) -> Result<Pslg, OutlineOfError> {
    let mut pslg = outline_of(mesh, &[])?;
    let mut is_kept = vec![false; pslg.points.len()];
    pslg.segments.iter().flatten().for_each(|&point| is_kept[point as usize] = true);
    let of_points = pslg.memberships.iter().filter(|membership| membership.dim == 0);
    of_points.for_each(|membership| is_kept[membership.item as usize] = true);
    let mut kept = 0;
    let place: Vec<u32> = is_kept
        .iter()
        .map(|&is_kept| {
            kept += u32::from(is_kept);
            kept.wrapping_sub(1)
        })
        .collect();
    pslg.segments.iter_mut().flatten().for_each(|point| *point = place[*point as usize]);
    let of_points = pslg.memberships.iter_mut().filter(|membership| membership.dim == 0);
    of_points.for_each(|membership| membership.item = place[membership.item as usize]);
    keep(&mut pslg.points, &is_kept);
    keep(&mut pslg.point_markers, &is_kept);
    pslg.point_attributes.iter_mut().for_each(|attribute| keep(&mut attribute.values, &is_kept));
    Ok(pslg)
}

/// Keeps some items of an array that may be empty.
fn keep<T>(items: &mut Vec<T>, is_kept: &[bool]) {
    let mut kept = is_kept.iter();
    items.retain(|_| kept.next().is_some_and(|&kept| kept));
}

/// The sides of triangles, sorted by their ends (the smaller one first), and the edges.
struct Sides {
    of_triangles: Vec<([u32; 2], u32)>,
    edges: Vec<[u32; 2]>,
}

impl Sides {
    fn of(mesh: &Mesh) -> Result<Self, OutlineOfError> {
        let mut of_triangles: Vec<([u32; 2], u32)> = (0..)
            .zip(&mesh.triangles)
            .flat_map(|(triangle, &[a, b, c])| {
                [[a, b], [b, c], [c, a]].map(|ends| (ordered(ends), triangle))
            })
            .collect();
        of_triangles.sort_unstable();
        let shared = of_triangles.windows(3).find(|window| window[0].0 == window[2].0);
        if let Some(&[(_, a), (_, b), (_, c)]) = shared {
            return Err(OutlineOfError::ThreeTriangles([a, b, c]));
        }
        let mut edges: Vec<[u32; 2]> = mesh.edges.iter().copied().map(ordered).collect();
        edges.sort_unstable();
        Ok(Self { of_triangles, edges })
    }

    /// Each pair of ends, with one triangle or two.
    fn pairs(&self) -> impl Iterator<Item = ([u32; 2], u32, Option<u32>)> {
        let pairs = self.of_triangles.chunk_by(|(ends, _), (others, _)| ends == others);
        pairs.map(|pair| (pair[0].0, pair[0].1, pair.get(1).map(|&(_, triangle)| triangle)))
    }

    fn is_edge(&self, ends: [u32; 2]) -> bool {
        self.edges.binary_search(&ordered(ends)).is_ok()
    }

    /// The sides with one triangle, or with triangles of two regions.
    fn separating(&self, mesh: &Mesh) -> impl Iterator<Item = [u32; 2]> {
        let tag = |triangle: u32| mesh.triangle_tag(triangle as usize);
        let separates = move |a: u32, b: Option<u32>| b.is_none_or(|b| tag(a) != tag(b));
        self.pairs().filter(move |&(_, a, b)| separates(a, b)).map(|(ends, ..)| ends)
    }

    /// The pairs of triangles with nothing between them.
    fn joined(&self, mesh: &Mesh) -> impl Iterator<Item = [u32; 2]> {
        let tag = |triangle: u32| mesh.triangle_tag(triangle as usize);
        self.pairs().filter_map(move |(ends, a, b)| {
            b.filter(|&b| tag(a) == tag(b) && !self.is_edge(ends)).map(|b| [a, b])
        })
    }
}

/// A region for every part of the mesh that no segment goes through: its seed is the centroid of
/// its largest triangle.
fn regions(mesh: &Mesh, sides: &Sides) -> Result<Vec<Region>, OutlineOfError> {
    let mut parent: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
    for [a, b] in sides.joined(mesh) {
        let [a, b] = [a, b].map(|triangle| root(&mut parent, triangle));
        parent[a.max(b) as usize] = a.min(b);
    }
    let mut best = vec![(0.0, None); parent.len()];
    for (triangle, corners) in (0..).zip(&mesh.triangles) {
        let corners = corners.map(|v| mesh.points[v as usize]);
        let part = &mut best[root(&mut parent, triangle) as usize];
        let (area, seed) = centroid(corners);
        if area > part.0 && seed.is_some() {
            *part = (area, seed);
        }
    }
    let roots = (0..).zip(best).filter(|&(triangle, _)| parent[triangle as usize] == triangle);
    roots
        .map(|(triangle, (_, seed))| {
            let tag = mesh.triangle_tag(triangle as usize);
            let seed = seed.ok_or(OutlineOfError::Flat(triangle))?;
            Ok(Region { seed, tag, attribute: tag.into(), max_area: None })
        })
        .collect()
}

fn root(parent: &mut [u32], mut triangle: u32) -> u32 {
    while parent[triangle as usize] != triangle {
        let above = parent[triangle as usize];
        parent[triangle as usize] = parent[above as usize];
        triangle = above;
    }
    triangle
}

/// Twice the area of a triangle, and its centroid where that lies strictly inside it.
pub(crate) fn centroid([a, b, c]: [[f64; 2]; 3]) -> (f64, Option<[f64; 2]>) {
    let area = Vector::between(a, b).cross(Vector::between(a, c)).abs();
    let centroid = [0, 1].map(|k| a[k] + ((b[k] - a[k]) + (c[k] - a[k])) / 3.0);
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| side(from, to, centroid));
    let is_inside = sides == [Side::Left; 3] || sides == [Side::Right; 3];
    (area, is_inside.then_some(centroid))
}

fn ordered([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Parameters, Region as MeshedRegion, domain::Domain, mesh};

    /// A square of four triangles around its middle, the first of another region.
    fn square() -> Mesh {
        Mesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]],
            triangles: vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
            triangle_tags: vec![1, 2, 2, 2],
            edges: vec![[2, 4]],
            edge_tags: vec![9],
            ..Mesh::default()
        }
    }

    #[test]
    fn boundary_and_interfaces_become_segments() {
        let outline = outline_of(&square(), &[]).expect("a mesh");
        assert_eq!(outline.segments, [[2, 4], [0, 1], [0, 3], [0, 4], [1, 2], [1, 4], [2, 3]]);
        assert_eq!(outline.segment_tags, [9, 0, 0, 0, 0, 0, 0]);
        let tags: Vec<_> = outline.regions.iter().map(|region| region.tag).collect();
        assert_eq!(tags, [1, 2, 2]);
        let (domain, warnings) = Domain::new(&outline, MeshedRegion::Domain).expect("clean");
        assert_eq!(domain.area(), 1.0);
        assert!(warnings.is_empty(), "{warnings:?}");
    }

    #[test]
    fn what_no_triangle_covers_is_a_hole() {
        let mut ring = square();
        ring.triangles.remove(1);
        ring.triangle_tags.remove(1);
        let outline = outline_of(&ring, &[]).expect("a mesh");
        assert_eq!(Domain::new(&outline, MeshedRegion::Domain).expect("clean").0.area(), 0.75);
    }

    #[test]
    fn local_areas_hold_where_their_triangles_are() {
        let outline = outline_of(&square(), &[None, Some(0.01), None, None]).expect("a mesh");
        let outcome = mesh(&outline, &Parameters::default()).expect("clean");
        assert!(outcome.certificate.holds());
        assert_eq!(outcome.mesh.points[..5], square().points);
        let places = outcome.mesh.triangles.iter().map(|corners| {
            let (twice, place) = centroid(corners.map(|v| outcome.mesh.points[v as usize]));
            (twice, place.expect("no sliver"))
        });
        let (mut inside, mut outside) = (0.0_f64, 0.0_f64);
        for (twice, [x, y]) in places {
            let there = if x > y && x + y > 1.0 { &mut inside } else { &mut outside };
            *there = there.max(0.5 * twice);
        }
        assert!(inside <= 0.01 && outside > 0.02, "{inside} {outside}");
    }

    #[test]
    fn what_is_no_mesh_is_an_error() {
        let mut fan = square();
        fan.triangles.push([0, 1, 2]);
        fan.triangles.push([0, 1, 3]);
        let error = outline_of(&fan, &[]).unwrap_err();
        assert_eq!(error, OutlineOfError::ThreeTriangles([0, 4, 5]));
        let mut flat = square();
        flat.points[4] = [0.5, 0.0];
        assert_eq!(outline_of(&flat, &[]).unwrap_err(), OutlineOfError::Flat(0));
        let error = outline_of(&square(), &[None]).unwrap_err();
        assert_eq!(error, OutlineOfError::OtherAreas { areas: 1, triangles: 4 });
    }
}
