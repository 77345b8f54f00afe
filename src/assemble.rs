//! From the refined triangulation to the mesh that is written.

use std::collections::BTreeMap;
use std::mem;

use crate::Region;
use crate::attributes::interpolate;
use crate::corners::each;
use crate::domain::Domain;
use crate::formats::{Membership, Mesh, Pslg, Tag};
use crate::memory::give_back;
use crate::radix;
use crate::refine::Refinement;
use crate::refine::provenance::Provenances;
use crate::triangulation::{Edge, Triangle, Triangulation};

/// The mesh of a refinement, in the outline's own coordinates, numbers and tags.
///
/// `initial` are the triangles before carving (needed where points have attributes). Vertices that
/// no triangle uses (points of the outline outside the meshed region) are left out.
#[must_use]
pub fn assemble(
    mut refinement: Refinement,
    initial: Vec<Triangle>,
    domain: &Domain,
    pslg: &Pslg,
) -> Mesh {
    refinement.mesh.forget_anchors();
    let pieces = subsegments(&refinement);
    let order = OutputOrder::of(&refinement.mesh, pslg.points.len(), domain);
    let point_data =
        interpolate(&pslg.point_attributes, initial, &refinement, domain, order.vertices());
    let Triangulation { points, triangles, regions, .. } = mem::take(&mut refinement.mesh);
    let provenances = mem::take(&mut refinement.provenances);
    drop(refinement);
    // The triangles first: that gives half of their memory back for all that follows.
    let triangles = renamed(triangles, &order);
    let points = order.sorted(points, pslg, domain.scale_exponent);
    let ends = pieces.ends.into_iter().map(|ends| ends.map(|v| order.place(v)));
    let edge_segments: Vec<u32> =
        pieces.segments.iter().map(|&segment| domain.input_segments[segment as usize]).collect();
    Mesh {
        points,
        triangle_tags: region_tags(regions, triangles.len(), domain),
        triangles,
        edges: ends.collect(),
        edge_tags: pieces
            .segments
            .iter()
            .map(|&segment| domain.segment_tags[segment as usize])
            .collect(),
        memberships: memberships(&order, &edge_segments, domain, pslg),
        edge_segments,
        point_markers: markers(&provenances, &order, domain, pslg),
        provenance: order.of_each(|v| provenances.kind(v)),
        point_data,
        groups: pslg.groups.clone(),
        ..Mesh::default()
    }
}

/// The corners of triangles by their new numbers, in the first half of the memory that the triangles
/// have; the other half goes back.
fn renamed(triangles: Vec<Triangle>, order: &OutputOrder) -> Vec<[u32; 3]> {
    let renamed = triangles.into_iter().map(|triangle| each(triangle.vertices, |v| order.place(v)));
    let mut renamed: Vec<[u32; 3]> = renamed.collect();
    renamed.shrink_to_fit();
    renamed
}

/// The order of the mesh's points: the vertices that are used, the outline's in its order, then the
/// others as they were committed.
struct OutputOrder {
    /// The place of each vertex; [`UNUSED`] where it is not used.
    places: Vec<u32>,
    /// The vertex of each of the outline's points; [`UNUSED`] where there is none that is used.
    inputs: Vec<u32>,
    /// The first vertex that is none of the outline's.
    first_other: usize,
    /// How many vertices are used.
    count: usize,
}

const UNUSED: u32 = u32::MAX;
/// What stands for the place of a vertex that is used, until it has one.
const USED: u32 = 0;

/// Whether each vertex is used: [`USED`] or [`UNUSED`].
fn places_to_be(mesh: &Triangulation, domain: &Domain) -> Vec<u32> {
    if domain.region == Region::Global {
        // Points were committed outside of what is meshed, too.
        let mut places = vec![UNUSED; mesh.points.len()];
        let used = mesh.triangles.iter().flat_map(|triangle| triangle.vertices);
        used.for_each(|v| places[v as usize] = USED);
        return places;
    }
    let is_meshed = domain.meshed_points.iter();
    let mut places: Vec<u32> =
        is_meshed.map(|&is_meshed| if is_meshed { USED } else { UNUSED }).collect();
    places.resize(mesh.points.len(), USED);
    places
}

impl OutputOrder {
    /// The first vertices of the mesh are those of the domain of an outline with so many
    /// `outline_points`.
    fn of(mesh: &Triangulation, outline_points: usize, domain: &Domain) -> Self {
        let input_points = &domain.input_points;
        let mut places = places_to_be(mesh, domain);
        let mut inputs = vec![UNUSED; outline_points];
        for (v, (&input, &place)) in (0..).zip(input_points.iter().zip(&places)) {
            if place == USED {
                inputs[input as usize] = v;
            }
        }
        let mut count = 0;
        let mut next_place = || {
            count += 1;
            count - 1
        };
        for &v in inputs.iter().filter(|&&v| v != UNUSED) {
            places[v as usize] = next_place();
        }
        let first_other = input_points.len();
        for place in places[first_other..].iter_mut().filter(|place| **place == USED) {
            *place = next_place();
        }
        Self { places, inputs, first_other, count: count as usize }
    }

    /// The place of a vertex that is used.
    #[inline]
    fn place(&self, vertex: u32) -> u32 {
        self.places[vertex as usize]
    }

    /// The vertices that are used, in this order.
    fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        let inputs = self.inputs.iter().copied().filter(|&v| v != UNUSED);
        let others = (self.first_other as u32..).zip(&self.places[self.first_other..]);
        inputs.chain(others.filter(|&(_, &place)| place != UNUSED).map(|(v, _)| v))
    }

    /// What there is `of` each vertex, in this order.
    fn of_each<T>(&self, of: impl Fn(u32) -> T) -> Vec<T> {
        let mut found = Vec::with_capacity(self.count);
        self.vertices().for_each(|v| found.push(of(v)));
        found
    }

    /// The points in this order and in the outline's own coordinates, in the memory that they have.
    fn sorted(&self, mut points: Vec<[f64; 2]>, pslg: &Pslg, scale_exponent: i32) -> Vec<[f64; 2]> {
        let unscaled = |point: [f64; 2]| match scale_exponent {
            0 => point,
            _ => point.map(|c| libm::scalbn(c, scale_exponent)),
        };
        // Scaling rounds nothing: the outline's points are those that it has.
        let inputs = pslg.points.iter().zip(&self.inputs).filter(|&(_, &v)| v != UNUSED);
        points.iter_mut().zip(inputs).for_each(|(point, (&input, _))| *point = input);
        for v in self.first_other..points.len() {
            // (Nothing comes later than it stood.)
            if self.places[v] != UNUSED {
                points[self.places[v] as usize] = unscaled(points[v]);
            }
        }
        points.truncate(self.count);
        points.shrink_to_fit();
        points
    }
}

/// Every subsegment once, segment by segment, each in order from its first end to its second. The
/// meshed side of a boundary edge is to its left.
struct Subsegments {
    ends: Vec<[u32; 2]>,
    segments: Vec<u32>,
}

fn subsegments(refinement: &Refinement) -> Subsegments {
    let found = subsegments_by_segment(refinement);
    // (All ends first: one by one, between other things, each would be waited for.)
    let ends_of = |edge: u32| refinement.mesh.ends(Edge::new(edge >> 3, edge as usize & 3));
    let mut ends: Vec<[u32; 2]> = found.iter().map(|&placed| ends_of(placed as u32)).collect();
    let segments: Vec<u32> = found.iter().map(|&placed| (placed >> 32) as u32).collect();
    give_back(found);
    let mut in_order: Vec<(f64, [u32; 2])> = Vec::new();
    let mut rest = &mut ends[..];
    for of_segment in segments.chunk_by(|a, b| a == b) {
        let (pieces, others) = rest.split_at_mut(of_segment.len());
        rest = others;
        if pieces.len() > 1 {
            in_order.extend(pieces.iter().map(|&ends| {
                // Twice the distance of its middle from the segment's first end.
                let along = ends.map(|v| refinement.distance_along(of_segment[0], v));
                (along.iter().sum(), ends)
            }));
            in_order.sort_unstable_by(|(along_s, _), (along_t, _)| along_s.total_cmp(along_t));
            pieces.iter_mut().zip(in_order.drain(..)).for_each(|(piece, (_, ends))| *piece = ends);
        }
    }
    Subsegments { ends, segments }
}

/// The subsegments, each as `segment << 32 | triangle << 3 | edge`, segment by segment.
fn subsegments_by_segment(refinement: &Refinement) -> Vec<u64> {
    let mesh = &refinement.mesh;
    // (What n points split has n + 1 pieces. An array that grows leaves holes in the memory.)
    let most = refinement.segments.ends.len() + refinement.provenances.on_segments();
    let mut found = Vec::with_capacity(most);
    mesh.constrained_edges().for_each(|edge| {
        let behind = mesh.behind(edge);
        if !behind.is_outside() && edge.triangle() > behind.triangle() {
            return; // it was heard already
        }
        if let Some(segment) = refinement.segment_of(mesh.ends(edge)) {
            let edge = edge.triangle() << 3 | edge.index() as u32;
            found.push(u64::from(segment) << 32 | u64::from(edge));
        }
    });
    radix::sort(&mut found);
    found
}

/// The tags of the triangles' regions; where there is no region, of so many `triangles`.
fn region_tags(regions: Vec<u32>, triangles: usize, domain: &Domain) -> Vec<Tag> {
    let tag = |region: u32| match region {
        0 => 0,
        region => domain.regions[region as usize - 1].tag,
    };
    match regions.is_empty() {
        true => vec![0; triangles],
        false => regions.into_iter().map(tag).collect(),
    }
}

/// The groups of the outline's points, and the further groups of its segments: of each piece.
fn memberships(
    order: &OutputOrder,
    edge_segments: &[u32],
    domain: &Domain,
    pslg: &Pslg,
) -> Vec<Membership> {
    if pslg.memberships.is_empty() {
        return Vec::new();
    }
    let mut vertices = vec![u32::MAX; pslg.points.len()];
    for (&vertex, &input) in order.places.iter().zip(&domain.input_points) {
        vertices[input as usize] = vertex;
    }
    let mut pieces: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for (edge, &input) in (0..).zip(edge_segments) {
        pieces.entry(input).or_default().push(edge);
    }
    let mut found = Vec::new();
    for &membership in &pslg.memberships {
        let Membership { dim, item, .. } = membership;
        match dim {
            0 => {
                let vertex = vertices.get(item as usize).filter(|&&vertex| vertex != u32::MAX);
                found.extend(vertex.map(|&item| Membership { item, ..membership }));
            }
            _ => {
                let edges = pieces.get(&item).into_iter().flatten();
                found.extend(edges.map(|&item| Membership { item, ..membership }));
            }
        }
    }
    found
}

/// The outline's markers; a point that splits a segment inherits the segment's tag.
fn markers(
    provenances: &Provenances,
    order: &OutputOrder,
    domain: &Domain,
    pslg: &Pslg,
) -> Vec<Tag> {
    if pslg.point_markers.is_empty() && domain.segment_tags.iter().all(|&tag| tag == 0) {
        return Vec::new();
    }
    let given = |input: u32| pslg.point_markers.get(input as usize).copied();
    let inherited = |v: u32| {
        let point = provenances.segment_point(v);
        point.map(|point| domain.segment_tags[point.segment as usize])
    };
    let marker = |v: u32| match domain.input_points.get(v as usize) {
        Some(&input) => given(input),
        None => inherited(v),
    };
    order.of_each(|v| marker(v).unwrap_or(0))
}
