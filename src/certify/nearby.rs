//! Renumbering: what is near in the plane is near in memory.
//!
//! A mesh has its points in the order in which they came to be. Judged in that order, each triangle
//! would wait for three places of memory far apart. So the judge works on copies, in which points
//! stand in the order of a Hilbert curve and triangles in that of their first points, and gives
//! what it found the numbers of the mesh and of the outline again.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::cmp::Ordering;
use std::mem::{self, discriminant};

use super::complex::NONE;
use super::fault::{Fault, FaultKind, Numbered};
use super::verdict::{Certificate, NarrowTo};
use crate::corners::each;
use crate::formats::{Membership, Mesh, Pslg, Source, Tag};
use crate::hilbert::Curve;
use crate::radix;

/// An outline and a mesh with other numbers of points and triangles.
pub(super) struct Nearby<'a> {
    /// The outline. Its segments keep their numbers.
    pub(super) pslg: Pslg,
    /// The mesh, without its triangles' tags. Its edges keep their numbers.
    pub(super) mesh: Mesh,
    /// The mesh as it is given; of one that is handed over the triangles' tags alone.
    given: Cow<'a, Mesh>,
    /// The old numbers of the outline's points and of the mesh's points.
    inputs: Vec<u32>,
    points: Vec<u32>,
    /// The old numbers of the triangles, made when first asked for.
    triangles: OnceCell<Vec<u32>>,
}

impl<'a> Nearby<'a> {
    /// Copies what is judged of an outline and a mesh; of a mesh that is handed over nothing stays
    /// twice. And for each point of the copied mesh the point of the copied outline at the very same
    /// place, the first of several; or [`NONE`].
    pub(super) fn new(pslg: &Pslg, mut given: Cow<'a, Mesh>) -> (Self, Vec<u32>) {
        let curve = curve_through(&pslg.points, &given.points);
        let points = along(curve, &given.points);
        let points_at = in_order(&points, &given.points);
        if let Cow::Owned(mesh) = &mut given {
            mesh.points = Vec::new();
        }
        let inputs = along(curve, &pslg.points);
        let inputs_at = in_order(&inputs, &pslg.points);
        let at_input = places_in_common((&points, &points_at), (&inputs, &inputs_at));
        drop(inputs_at); // until the triangles, which take most memory, are in order
        let [inputs, points] = [inputs, points]
            .map(|along| along.into_iter().map(|placed| placed as u32).collect::<Vec<_>>());
        let new = inverse(&points);
        let (triangles, numbers) = triangles_along(&mut given, &new);
        let mesh = renumbered(&given, &points, &new, (points_at, triangles));
        if let Cow::Owned(mesh) = &mut given {
            let triangle_tags = mem::take(&mut mesh.triangle_tags);
            *mesh = Mesh { triangle_tags, ..Mesh::default() };
        }
        let pslg = outline(pslg, &inputs);
        (Self { pslg, mesh, given, inputs, points, triangles: numbers }, at_input)
    }

    /// The old number of a triangle.
    fn triangle(&self, t: u32) -> u32 {
        let numbers = || {
            let new = inverse(&self.points);
            by_first_point(self.given.triangles.iter().map(|t| named(t, &new)), new.len())
        };
        self.triangles.get_or_init(numbers)[t as usize]
    }

    /// The tag of a triangle; 0 where it has none.
    pub(super) fn triangle_tag(&self, t: u32) -> Tag {
        self.given.triangle_tags.get(self.triangle(t) as usize).copied().unwrap_or(0)
    }

    /// The tags of all triangles, in the order in which they are given.
    pub(super) fn triangle_tags(&self) -> &[Tag] {
        &self.given.triangle_tags
    }

    /// Gives everything that a certificate names its number in the mesh or the outline.
    pub(super) fn restore(&self, pslg: &Pslg, certificate: &mut Certificate) {
        let input = |numbered: &mut Numbered| {
            if let Some(&index) = self.inputs.get(numbered.index as usize) {
                *numbered = Numbered { index, number: pslg.source.point_number(index) };
            }
        };
        for judgement in &mut certificate.judgements {
            for faults in [&mut judgement.first, &mut judgement.first_limited] {
                for fault in faults.iter_mut() {
                    self.restore_fault(fault);
                    fault.input_point.iter_mut().for_each(input);
                }
                // As they were found, but those of one kind by their numbers.
                for alike in
                    faults.chunk_by_mut(|a, b| discriminant(&a.kind) == discriminant(&b.kind))
                {
                    alike.sort_by_key(|fault| (fault.triangle, fault.point, fault.edge));
                }
            }
        }
        for angle in &mut certificate.excused {
            angle.triangle = self.triangle(angle.triangle);
            angle.edge = angle.edge.map(|v| self.points[v as usize]);
        }
        certificate.excused.sort_by_key(|angle| (angle.triangle, angle.edge));
        certificate.apexes.iter_mut().for_each(|apex| input(&mut apex.point));
        for narrow in &mut certificate.narrows {
            input(&mut narrow.point);
            if let NarrowTo::Point(point) = &mut narrow.to {
                input(point);
            }
        }
        certificate.apexes.sort_by_key(|apex| (apex.point.index, apex.segments.map(|s| s.index)));
        certificate.narrows.sort_by_key(|narrow| narrow.point.index);
    }

    fn restore_fault(&self, fault: &mut Fault) {
        let point = |v: &mut u32| *v = self.points.get(*v as usize).copied().unwrap_or(*v);
        fault.triangle.iter_mut().for_each(|t| *t = self.triangle(*t));
        fault.edge.iter_mut().flatten().for_each(point);
        fault.point.iter_mut().for_each(point);
        if let FaultKind::Broken { until } = &mut fault.kind {
            until.iter_mut().for_each(point);
        }
    }
}

/// The curve through all that is finite.
fn curve_through(outline: &[[f64; 2]], mesh: &[[f64; 2]]) -> Curve {
    let finite = outline.iter().chain(mesh).filter(|p| p.iter().all(|x| x.is_finite()));
    let nothing = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    let (low, high) = finite.fold(nothing, |(low, high), p| {
        ([0, 1].map(|i| low[i].min(p[i])), [0, 1].map(|i| high[i].max(p[i])))
    });
    Curve::new(low, high)
}

/// The points' places along a curve (in the high half) with their numbers, in that order. Where the
/// curve cannot tell them apart they stand as [`by_place`] says, so that two lists along one curve can
/// be compared step by step.
fn along(curve: Curve, points: &[[f64; 2]]) -> Vec<u64> {
    let places = points.iter().map(|&p| u64::from(curve.place(p)));
    let mut placed: Vec<_> = (0..).zip(places).map(|(v, place)| place << 32 | v).collect();
    radix::sort(&mut placed);
    for same in placed.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|same| same.len() > 1) {
        let at = |placed: u64| points[placed as u32 as usize];
        same.sort_unstable_by(|&v, &w| by_place(at(v), at(w)).then(v.cmp(&w)));
    }
    placed
}

/// From left to right, then from below to above; what is no number comes last.
fn by_place(p: [f64; 2], q: [f64; 2]) -> Ordering {
    // (−0 equals 0.)
    let order = |x: f64, y: f64| x.partial_cmp(&y).unwrap_or_else(|| x.is_nan().cmp(&y.is_nan()));
    order(p[0], q[0]).then(order(p[1], q[1]))
}

/// Where points are, in their order [`along`] a curve.
fn in_order(along: &[u64], points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    along.iter().map(|&placed| points[placed as u32 as usize]).collect()
}

/// A list of points as [`along`] gives it, and where they are, in that order.
type Placed<'a> = (&'a [u64], &'a [[f64; 2]]);

/// For each point of the first list the first one of the second at the very same place, both by
/// their new numbers; or [`NONE`].
fn places_in_common((points, at): Placed, (others, others_at): Placed) -> Vec<u32> {
    let mut others = (0..).zip(others.iter().zip(others_at)).peekable();
    let found = points.iter().zip(at).map(|(&placed, &p)| {
        let order = |other: u64, q| (other >> 32).cmp(&(placed >> 32)).then_with(|| by_place(q, p));
        while others.next_if(|&(_, (&other, &q))| order(other, q).is_lt()).is_some() {}
        match others.peek() {
            Some(&(number, (&other, &q))) if order(other, q).is_eq() => number,
            _ => NONE,
        }
    });
    found.collect()
}

/// The new number of each old one.
fn inverse(old: &[u32]) -> Vec<u32> {
    let mut new = vec![0; old.len()];
    for (i, &old) in (0..).zip(old) {
        new[old as usize] = i;
    }
    new
}

/// The triangles by their corners' new numbers, in the order of the smallest of these; and their old
/// numbers, where the mesh is handed over: its own list goes.
fn triangles_along(given: &mut Cow<Mesh>, new: &[u32]) -> (Vec<[u32; 3]>, OnceCell<Vec<u32>>) {
    match given {
        Cow::Owned(mesh) => {
            let mut all = mem::take(&mut mesh.triangles);
            all.iter_mut().for_each(|corners| *corners = named(corners, new));
            let order = by_first_point(all.iter().copied(), new.len());
            (order.iter().map(|&t| all[t as usize]).collect(), OnceCell::from(order))
        }
        Cow::Borrowed(mesh) => {
            let all = &mesh.triangles;
            let order = by_first_point(all.iter().map(|corners| named(corners, new)), new.len());
            let of_order = order.iter().map(|&t| named(&all[t as usize], new));
            (of_order.collect(), OnceCell::new())
        }
    }
}

/// A triangle by its corners' new numbers.
fn named(corners: &[u32; 3], new: &[u32]) -> [u32; 3] {
    each(*corners, |v| renamed(v, new))
}

/// The numbers of triangles, given by their corners' new numbers, in the order of the smallest of
/// these, which are below `points`.
fn by_first_point(triangles: impl Iterator<Item = [u32; 3]>, points: usize) -> Vec<u32> {
    let first = |[a, b, c]: [u32; 3]| {
        let first = a.min(b).min(c);
        // (What names a point that is not there comes first.)
        if (first as usize) < points { first } else { 0 }
    };
    let first: Vec<u32> = triangles.map(first).collect();
    super::grouped(points.max(1), first.iter().copied().zip(0..)).1
}

/// An outline with its points in a new order, `inputs` by their old numbers.
fn outline(pslg: &Pslg, inputs: &[u32]) -> Pslg {
    let new = inverse(inputs);
    let item = |membership: &Membership| match membership.dim {
        0 => renamed(membership.item, &new),
        _ => membership.item,
    };
    Pslg {
        points: inputs.iter().map(|&v| pslg.points[v as usize]).collect(),
        point_sizes: match pslg.point_sizes.len() == inputs.len() {
            true => inputs.iter().map(|&v| pslg.point_sizes[v as usize]).collect(),
            false => pslg.point_sizes.clone(),
        },
        segments: pslg.segments.iter().map(|ends| ends.map(|v| renamed(v, &new))).collect(),
        segment_tags: pslg.segment_tags.clone(),
        enclosed: pslg.enclosed,
        holes: pslg.holes.clone(),
        regions: pslg.regions.clone(),
        groups: pslg.groups.clone(),
        memberships: pslg.memberships.iter().map(|m| Membership { item: item(m), ..*m }).collect(),
        source: Source {
            first_number: pslg.source.first_number,
            segment_numbers: pslg.source.segment_numbers.clone(),
            ..Source::default()
        },
        ..Pslg::default()
    }
}

/// A mesh with its points in a new order, `points` by their old numbers, where they are, and with
/// its triangles.
fn renumbered(
    mesh: &Mesh,
    points: &[u32],
    new: &[u32],
    (at, triangles): (Vec<[f64; 2]>, Vec<[u32; 3]>),
) -> Mesh {
    let item = |membership: &Membership| match membership.dim {
        0 => renamed(membership.item, new),
        _ => membership.item,
    };
    Mesh {
        points: at,
        provenance: match mesh.provenance.len() == points.len() {
            true => points.iter().map(|&v| mesh.provenance[v as usize]).collect(),
            false => Vec::new(),
        },
        triangles,
        edges: mesh.edges.iter().map(|ends| ends.map(|v| renamed(v, new))).collect(),
        edge_tags: mesh.edge_tags.clone(),
        edge_segments: mesh.edge_segments.clone(),
        groups: mesh.groups.clone(),
        memberships: mesh.memberships.iter().map(|m| Membership { item: item(m), ..*m }).collect(),
        ..Mesh::default()
    }
}

/// The new number of a point; one that is none stays none.
fn renamed(v: u32, new: &[u32]) -> u32 {
    new.get(v as usize).copied().unwrap_or(v)
}
