//! Counts and angles of a mesh, for summaries.

use std::collections::BTreeMap;

use meshwright_formats::{Group, Mesh, Provenance, Tag};

use crate::corners::each;
use crate::order::{greater, lesser};
use crate::triangulation::Triangulation;

mod bins;
mod quality;

pub use crate::certify::Kinds;
pub use quality::Quality;

use bins::Bins;

/// What a mesh consists of.
///
/// ```
/// use meshwright::{Mesh, statistics::Statistics};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]],
///     triangles: vec![[0, 1, 2]],
///     ..Mesh::default()
/// };
/// let statistics = Statistics::of(&mesh);
/// assert_eq!(statistics.area, 2.0);
/// assert_eq!(statistics.smallest_angle.to_degrees(), 45.0);
/// assert_eq!(statistics.largest_angle.to_degrees(), 90.0);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Statistics {
    /// Number of points.
    pub points: usize,
    /// Number of points of each kind; `None` where the mesh does not know the kinds.
    pub kinds: Option<Kinds>,
    /// Number of triangles.
    pub triangles: usize,
    /// Number of boundary and interface edges.
    pub edges: usize,
    /// Sum of the triangles' areas, in squared units of the coordinates.
    pub area: f64,
    /// The smallest angle in radians; 0 for a mesh without triangles.
    pub smallest_angle: f64,
    /// The largest angle in radians; 0 for a mesh without triangles.
    pub largest_angle: f64,
    /// How many triangles have their smallest angle in each of [0°, 5°), [5°, 10°), … [55°, 60°].
    pub smallest_angles: [usize; 12],
    /// How many triangles have their largest angle in each of [60°, 65°), … [175°, 180°].
    pub largest_angles: [usize; 24],
    /// The groups of edges, then those of triangles, each by tag; tag 0 stands for those without.
    pub groups: Vec<GroupCount>,
}

/// A group and how much belongs to it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GroupCount {
    /// 1 for edges, 2 for triangles.
    pub dim: u8,
    /// The tag.
    pub tag: Tag,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Number of edges or triangles.
    pub count: usize,
}

impl Statistics {
    /// Counts a mesh and measures its angles. Triangles that name points which do not exist are
    /// counted, not measured.
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        let angles = Angles::new(&mesh.points);
        Self::with(mesh, angles.measured(mesh.triangles.iter().copied(), false))
    }

    /// The counts of a mesh of which the angles were measured before.
    pub(crate) fn with(mesh: &Mesh, measured: Measured) -> Self {
        let triangle_tags = if measured.is_untagged { &[] } else { &mesh.triangle_tags[..] };
        Self {
            points: mesh.points.len(),
            kinds: kinds(mesh),
            triangles: mesh.triangles.len(),
            edges: mesh.edges.len(),
            area: measured.area,
            smallest_angle: measured.smallest_angle,
            largest_angle: measured.largest_angle,
            smallest_angles: measured.smallest_angles,
            largest_angles: measured.largest_angles,
            groups: groups(mesh, triangle_tags),
        }
    }
}

/// What is measured of triangles: as in [`Statistics`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measured {
    area: f64,
    smallest_angle: f64,
    largest_angle: f64,
    smallest_angles: [usize; 12],
    largest_angles: [usize; 24],
    /// Whether it is known that no triangle has a tag.
    is_untagged: bool,
}

impl Measured {
    /// Measures a triangulation before a mesh is assembled from it: the triangles are the same, but
    /// their corners are near each other in memory still. `None` where its coordinates are scaled.
    pub(crate) fn of_refined(refined: &Triangulation, scale_exponent: i32) -> Option<Self> {
        let triangles = refined.triangles.iter().map(|triangle| triangle.vertices);
        let angles = (scale_exponent == 0).then(|| Angles::scaled(&refined.points, 0));
        angles.map(|angles| angles.measured(triangles, refined.regions.is_empty()))
    }
}

/// The smallest angle in radians of all but the excused ones, each given by its triangle and the
/// edge opposite it (in the order of the triangles); 0 where no angle is left.
#[must_use]
pub fn smallest_angle_but(mesh: &Mesh, excused: impl IntoIterator<Item = (u32, [u32; 2])>) -> f64 {
    let mut excused = excused.into_iter().peekable();
    let angles = Angles::new(&mesh.points);
    let mut largest_cotangent = f64::NEG_INFINITY;
    for (t, triangle) in mesh.triangles.iter().enumerate() {
        let Some(cotangents) = angles.cotangents(*triangle) else { continue };
        let mut left = [true; 3];
        while let Some((_, edge)) = excused.next_if(|&(of, _)| of as usize <= t) {
            for (left, corner) in left.iter_mut().zip(triangle) {
                *left &= edge.contains(corner);
            }
        }
        for (cotangent, _) in cotangents.iter().zip(left).filter(|&(_, left)| left) {
            largest_cotangent = largest_cotangent.max(*cotangent);
        }
    }
    angle(largest_cotangent)
}

fn kinds(mesh: &Mesh) -> Option<Kinds> {
    if mesh.provenance.len() != mesh.points.len() {
        return None;
    }
    let mut kinds = Kinds::default();
    for kind in &mesh.provenance {
        *match kind {
            Provenance::Input => &mut kinds.input,
            Provenance::Shell => &mut kinds.shell,
            Provenance::Midpoint => &mut kinds.midpoint,
            Provenance::Circumcenter => &mut kinds.circumcenter,
        } += 1;
    }
    Some(kinds)
}

fn groups(mesh: &Mesh, triangle_tags: &[Tag]) -> Vec<GroupCount> {
    let mut counts = BTreeMap::<(u8, Tag), usize>::new();
    for (dim, count, tags) in
        [(1, mesh.edges.len(), &mesh.edge_tags[..]), (2, mesh.triangles.len(), triangle_tags)]
    {
        let (tagged, untagged) = (tags.len().min(count), count.saturating_sub(tags.len()));
        for run in tags[..tagged].chunk_by(|a, b| a == b) {
            *counts.entry((dim, run[0])).or_default() += run.len();
        }
        if untagged > 0 {
            *counts.entry((dim, 0)).or_default() += untagged;
        }
    }
    let named = |dim, tag| {
        let group = mesh.groups.iter().find(|g: &&Group| g.dim == dim && g.tag == tag);
        group.map(|group| group.name.clone())
    };
    let counted = counts.into_iter();
    counted
        .map(|((dim, tag), count)| GroupCount { dim, tag, name: named(dim, tag), count })
        .collect()
}

/// Angles are kept as cotangents, which fall as angles grow: no trigonometry per triangle.
struct Angles<'a> {
    points: &'a [[f64; 2]],
    /// See [`exponent`].
    exponent: i32,
    bins: Bins,
    largest_cotangent: f64,
    smallest_cotangent: f64,
    twice_area: f64,
    smallest_angles: [usize; 12],
    largest_angles: [usize; 24],
}

impl<'a> Angles<'a> {
    fn new(points: &'a [[f64; 2]]) -> Self {
        Self::scaled(points, exponent(points))
    }

    fn scaled(points: &'a [[f64; 2]], exponent: i32) -> Self {
        Self {
            points,
            exponent,
            bins: Bins::of_five_degrees(),
            largest_cotangent: f64::NEG_INFINITY,
            smallest_cotangent: f64::INFINITY,
            twice_area: 0.0,
            smallest_angles: [0; 12],
            largest_angles: [0; 24],
        }
    }

    /// Measures triangles, but not those with corners that do not exist.
    fn measured(
        mut self,
        triangles: impl Iterator<Item = [u32; 3]>,
        is_untagged: bool,
    ) -> Measured {
        let points = self.points;
        let corners = triangles.filter_map(|triangle| corners(points, triangle));
        match self.exponent {
            0 => corners.for_each(|corners| self.measure(corners)),
            exponent => corners.for_each(|corners| self.measure(scaled(corners, exponent))),
        }
        Measured {
            area: libm::scalbn(self.twice_area / 2.0, -2 * self.exponent),
            smallest_angle: angle(self.largest_cotangent),
            largest_angle: angle(self.smallest_cotangent),
            smallest_angles: self.smallest_angles,
            largest_angles: self.largest_angles,
            is_untagged,
        }
    }

    #[inline(always)]
    fn measure(&mut self, corners: [[f64; 2]; 3]) {
        let (twice_area, [a, b, c]) = area_and_dots(corners);
        self.twice_area += twice_area;
        // Quotients by one number are in the order of what is divided.
        let steepest = greater(greater(a, b), c) / twice_area.abs();
        let flattest = lesser(lesser(a, b), c) / twice_area.abs();
        self.largest_cotangent = greater(steepest, self.largest_cotangent);
        self.smallest_cotangent = lesser(flattest, self.smallest_cotangent);
        // The smallest angle is at most 60°, the largest at least.
        self.smallest_angles[self.bins.of(steepest).min(11)] += 1;
        self.largest_angles[self.bins.of(flattest).saturating_sub(12)] += 1;
    }

    /// The cotangents of a triangle's angles, or nothing where a corner does not exist.
    fn cotangents(&self, triangle: [u32; 3]) -> Option<[f64; 3]> {
        let (twice_area, dots) = area_and_dots(self.corners(triangle)?);
        Some(each(dots, |dot| dot / twice_area.abs()))
    }

    /// The corners of a triangle, scaled, or nothing where one does not exist.
    fn corners(&self, triangle: [u32; 3]) -> Option<[[f64; 2]; 3]> {
        corners(self.points, triangle).map(|corners| scaled(corners, self.exponent))
    }
}

/// The power of 2 that points are multiplied by, so that no product over- or underflows.
fn exponent(points: &[[f64; 2]]) -> i32 {
    let largest = points.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    let exponent = if largest > 0.0 && largest.is_finite() { -libm::ilogb(largest) } else { 0 };
    // Within ±100 nothing happens to products of two lengths.
    if exponent.abs() <= 100 { 0 } else { exponent }
}

/// The corners of a triangle, or nothing where one does not exist.
#[inline(always)]
fn corners(points: &[[f64; 2]], [a, b, c]: [u32; 3]) -> Option<[[f64; 2]; 3]> {
    let at = |i: u32| points.get(i as usize).copied();
    Some([at(a)?, at(b)?, at(c)?])
}

/// Corners multiplied by 2 to this power.
fn scaled(corners: [[f64; 2]; 3], exponent: i32) -> [[f64; 2]; 3] {
    match exponent {
        0 => corners,
        _ => corners.map(|corner| corner.map(|x| libm::scalbn(x, exponent))),
    }
}

/// Twice the area, and at each corner the dot product of the edges to the others.
#[inline(always)]
fn area_and_dots([a, b, c]: [[f64; 2]; 3]) -> (f64, [f64; 3]) {
    let (ab, ac, bc) = (difference(b, a), difference(c, a), difference(c, b));
    (cross(ab, ac), [dot(ab, ac), -dot(ab, bc), dot(ac, bc)])
}

/// The angle from 0 to π with this cotangent; 0 where nothing was measured.
fn angle(cotangent: f64) -> f64 {
    if cotangent.is_infinite() {
        return 0.0;
    }
    libm::atan2(1.0, cotangent)
}

#[inline(always)]
fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

#[inline(always)]
fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// a × b, to the last bits also where the products nearly cancel (Kahan).
#[inline]
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    let product = a[1] * b[0];
    let rounded = a[0] * b[1] - product;
    if rounded.abs() > 0.125 * product.abs() {
        return rounded;
    }
    let error = (-a[1]).mul_add(b[0], product);
    a[0].mul_add(b[1], -product) + error
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two right triangles, one of them with a thin corner of about 0.57°.
    fn two() -> Mesh {
        Mesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, -0.01]],
            triangles: vec![[0, 1, 2], [0, 3, 1]],
            triangle_tags: vec![4, 0],
            edges: vec![[0, 1], [1, 2], [2, 0]],
            edge_tags: vec![2, -1, 2],
            groups: vec![Group { dim: 1, tag: 2, name: "wall".into() }],
            ..Mesh::default()
        }
    }

    #[test]
    fn angles_fall_into_bins_of_five_degrees() {
        let statistics = Statistics::of(&two());
        assert_eq!(statistics.smallest_angles, [1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0]);
        assert_eq!(statistics.largest_angles.iter().position(|&n| n == 2), Some(6));
        assert!((statistics.smallest_angle - 0.01_f64.atan()).abs() < 1e-15);
    }

    #[test]
    fn a_run_is_told_of_alike_whenever_it_is_measured() {
        let square = crate::Pslg {
            points: vec![[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 2.0]],
            segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
            segment_tags: vec![1, 0, 2, 0],
            ..crate::Pslg::default()
        };
        let told = |measured| {
            let parameters = crate::Parameters { measured, ..crate::Parameters::default() };
            let parameters = crate::Parameters { max_area: Some(0.01), ..parameters };
            crate::mesh(&square, &parameters).expect("it is clean").statistics()
        };
        assert_eq!(told(true), told(false));
        assert!(told(false).triangles > 500);
    }

    #[test]
    fn excused_angles_are_left_out_one_by_one() {
        let mesh = two();
        let thin = Statistics::of(&mesh).smallest_angle;
        assert_eq!(smallest_angle_but(&mesh, []), thin);
        // Without its thin corner the second triangle still has two large ones.
        let left = smallest_angle_but(&mesh, [(1, [1, 3])]);
        assert!((left.to_degrees() - 45.0).abs() < 1e-12, "{left}");
    }

    #[test]
    fn scaling_changes_no_angle() {
        let plain = Statistics::of(&two());
        for exponent in [-1000, 1000] {
            let mut mesh = two();
            for point in &mut mesh.points {
                *point = point.map(|x| libm::scalbn(x, exponent));
            }
            let scaled = Statistics::of(&mesh);
            assert_eq!(scaled.smallest_angle, plain.smallest_angle);
            assert_eq!(scaled.largest_angle, plain.largest_angle);
            assert_eq!(scaled.largest_angles, plain.largest_angles);
        }
    }

    #[test]
    fn groups_are_counted_by_dimension_and_tag() {
        let counts: Vec<_> = Statistics::of(&two())
            .groups
            .into_iter()
            .map(|group| (group.dim, group.tag, group.name, group.count))
            .collect();
        let wall = Some("wall".to_string());
        assert_eq!(counts, [(1, -1, None, 1), (1, 2, wall, 2), (2, 0, None, 1), (2, 4, None, 1)]);
    }

    #[test]
    fn kinds_are_unknown_where_the_mesh_does_not_tell() {
        let mut mesh = two();
        assert_eq!(Statistics::of(&mesh).kinds, None);
        mesh.provenance = vec![Provenance::Input; 4];
        assert_eq!(Statistics::of(&mesh).kinds, Some(Kinds { input: 4, ..Kinds::default() }));
    }

    #[test]
    fn an_empty_mesh_has_no_angles() {
        let statistics = Statistics::of(&Mesh::default());
        assert_eq!((statistics.smallest_angle, statistics.area), (0.0, 0.0));
    }

    #[test]
    fn broken_triangles_do_no_harm() {
        let mut mesh = two();
        mesh.triangles = vec![[0, 1, 9], [0, 0, 1], [0, 0, 0]];
        assert_eq!(Statistics::of(&mesh).triangles, 3);
    }
}
