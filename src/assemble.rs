//! From the refined triangulation to the mesh that is written.

use std::collections::BTreeMap;

use crate::attributes::interpolate;
use crate::corners::each;
use crate::domain::Domain;
use crate::formats::{Membership, Mesh, Pslg, Tag};
use crate::refine::Refinement;
use crate::triangulation::Triangle;

/// The mesh of a refinement, in the outline's own coordinates, numbers and tags.
///
/// `initial` are the triangles before carving (needed where points have attributes);
/// `domain_points` tells which point of the domain each of the first vertices is. Vertices that no
/// triangle uses (points of the outline outside the meshed region) are left out.
#[must_use]
pub fn assemble(
    refinement: Refinement,
    initial: Vec<Triangle>,
    domain_points: &[u32],
    domain: &Domain,
    pslg: &Pslg,
) -> Mesh {
    let order = output_order(&refinement, domain_points);
    let mut place = vec![u32::MAX; refinement.mesh.points.len()];
    for (new, &vertex) in order.iter().enumerate() {
        place[vertex as usize] = new as u32;
    }
    let edges = subsegments(&refinement);
    let unscale = |[x, y]: [f64; 2]| match domain.scale_exponent {
        0 => [x, y],
        exponent => [libm::scalbn(x, exponent), libm::scalbn(y, exponent)],
    };
    let mut mesh = Mesh {
        points: order.iter().map(|&v| unscale(refinement.mesh.points[v as usize])).collect(),
        point_markers: markers(&refinement, &order, domain_points, domain, pslg),
        provenance: order.iter().map(|&v| refinement.provenances.kind(v)).collect(),
        triangle_tags: region_tags(&refinement, domain),
        edges: edges.iter().map(|edge| edge.ends.map(|v| place[v as usize])).collect(),
        edge_tags: edges.iter().map(|edge| domain.segment_tags[edge.segment as usize]).collect(),
        edge_segments: edges
            .iter()
            .map(|edge| domain.input_segments[edge.segment as usize])
            .collect(),
        groups: pslg.groups.clone(),
        memberships: memberships(&place, &edges, domain_points, domain, pslg),
        point_data: interpolate(
            &pslg.point_attributes,
            initial,
            &refinement,
            domain,
            domain_points,
            &order,
        ),
        ..Mesh::default()
    };
    mesh.triangles = renamed(refinement.mesh.triangles, &place);
    mesh
}

/// The corners of triangles by their new numbers. (From the last one on, so that the memory of
/// those that are done can be given back on the way: there are never two lists as a whole.)
fn renamed(mut triangles: Vec<Triangle>, place: &[u32]) -> Vec<[u32; 3]> {
    const GIVEN_BACK: usize = 1 << 20;
    let mut renamed = vec![[0; 3]; triangles.len()];
    for corners in renamed.iter_mut().rev() {
        let Some(triangle) = triangles.pop() else { break };
        *corners = each(triangle.vertices, |v| place[v as usize]);
        if triangles.len().is_multiple_of(GIVEN_BACK) {
            triangles.shrink_to_fit();
        }
    }
    renamed
}

/// The vertices that are used: the outline's in its order, then the others as they were committed.
fn output_order(refinement: &Refinement, domain_points: &[u32]) -> Vec<u32> {
    let mut used = vec![false; refinement.mesh.points.len()];
    for triangle in &refinement.mesh.triangles {
        for v in triangle.vertices {
            used[v as usize] = true;
        }
    }
    let mut inputs = vec![0; domain_points.len()];
    for (v, &point) in (0..).zip(domain_points) {
        inputs[point as usize] = v;
    }
    let others = domain_points.len() as u32..refinement.mesh.points.len() as u32;
    inputs.into_iter().chain(others).filter(|&v| used[v as usize]).collect()
}

/// A piece of a segment in the mesh.
struct Subsegment {
    segment: u32,
    ends: [u32; 2],
    /// Twice the distance of its middle from the segment's first end.
    along: f64,
}

/// Every subsegment once, segment by segment, each in order from its first end to its second.
/// The meshed side of a boundary edge is to its left.
fn subsegments(refinement: &Refinement) -> Vec<Subsegment> {
    let mesh = &refinement.mesh;
    let mut found: Vec<_> = mesh
        .constrained_edges()
        .filter(|&edge| {
            let behind = mesh.behind(edge);
            behind.is_outside() || edge.triangle() < behind.triangle()
        })
        .filter_map(|edge| {
            let ends = mesh.ends(edge);
            let segment = refinement.segment_of(ends)?;
            let along = ends.iter().map(|&v| refinement.distance_along(segment, v)).sum();
            Some(Subsegment { segment, ends, along })
        })
        .collect();
    found.sort_by(|a, b| a.segment.cmp(&b.segment).then(a.along.total_cmp(&b.along)));
    found
}

fn region_tags(refinement: &Refinement, domain: &Domain) -> Vec<Tag> {
    let tag = |region: u32| match region {
        0 => 0,
        region => domain.regions[region as usize - 1].tag,
    };
    match &refinement.mesh.regions[..] {
        [] => vec![0; refinement.mesh.triangles.len()],
        regions => regions.iter().map(|&region| tag(region)).collect(),
    }
}

/// The groups of the outline's points, and the further groups of its segments: of each piece.
fn memberships(
    place: &[u32],
    edges: &[Subsegment],
    domain_points: &[u32],
    domain: &Domain,
    pslg: &Pslg,
) -> Vec<Membership> {
    if pslg.memberships.is_empty() {
        return Vec::new();
    }
    let mut vertices = vec![u32::MAX; pslg.points.len()];
    for (&vertex, &point) in place.iter().zip(domain_points) {
        vertices[domain.input_points[point as usize] as usize] = vertex;
    }
    let mut pieces: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for (edge, piece) in (0..).zip(edges) {
        let input = domain.input_segments[piece.segment as usize];
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
    refinement: &Refinement,
    order: &[u32],
    domain_points: &[u32],
    domain: &Domain,
    pslg: &Pslg,
) -> Vec<Tag> {
    if pslg.point_markers.is_empty() && domain.segment_tags.iter().all(|&tag| tag == 0) {
        return Vec::new();
    }
    let marker = |v: u32| {
        if let Some(point) = refinement.provenances.segment_point(v) {
            return domain.segment_tags[point.segment as usize];
        }
        let input = domain_points.get(v as usize).map(|&point| domain.input_points[point as usize]);
        let given = input.and_then(|input| pslg.point_markers.get(input as usize));
        given.copied().unwrap_or(0)
    };
    order.iter().map(|&v| marker(v)).collect()
}
