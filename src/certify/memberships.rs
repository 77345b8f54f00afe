//! G4, memberships: a point is in the groups that the outline gives it, a piece of a segment in all
//! groups of its segment.

use std::collections::{BTreeMap, BTreeSet};

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::fault::{Fault, FaultKind};
use super::outline::Outline;
use super::tags::Tags;
use super::verdict::Judgement;
use crate::formats::{Membership, Mesh, Tag};

/// The groups of a point or an edge.
#[derive(Debug, Clone, Default)]
struct Groups {
    /// That of the edge's tag; judged elsewhere.
    tag: Option<Tag>,
    further: BTreeSet<Tag>,
}

impl Groups {
    fn all(&self) -> impl Iterator<Item = Tag> + '_ {
        self.tag.into_iter().chain(self.further.iter().copied())
    }
}

/// Judges the groups of points and the further groups of edges.
pub(super) fn judge(outline: &Outline, complex: &Complex, chains: &Chains, g4: &mut Judgement) {
    let (pslg, mesh) = (outline.pslg, complex.mesh);
    if pslg.memberships.is_empty() && mesh.memberships.is_empty() {
        return;
    }
    let compared = |dim| Tags::new(dim, &pslg.groups, &mesh.groups);

    let expected = expected_at_points(outline, chains);
    compare(&expected, &found_at_points(mesh), compared(0), |point, kind| {
        g4.add(Fault::at_point(mesh, kind, point));
    });

    let (expected, segments) = expected_on_edges(outline, chains);
    let mut found = found_on_edges(mesh);
    // Edges that are no piece of a segment are told of elsewhere.
    found.retain(|edge, _| segments.contains_key(edge));
    compare(&expected, &found, compared(1), |edge, kind| {
        let segment = outline.segment_name(segments[&edge]);
        g4.add(Fault::at_edge(mesh, kind, edge).of_segment(segment));
    });
}

/// Tells what is in a group that the outline does not give it, or not in one that it does.
fn compare<T: Copy + Ord>(
    expected: &BTreeMap<T, Groups>,
    found: &BTreeMap<T, Groups>,
    mut tags: Tags,
    mut tell: impl FnMut(T, FaultKind),
) {
    let none = Groups::default();
    for (&item, groups) in expected {
        let there = found.get(&item).unwrap_or(&none);
        for &group in &groups.further {
            if !there.all().any(|found| tags.agree(group, found)) {
                tell(item, FaultKind::LostGroup { expected: tags.expected(group) });
            }
        }
    }
    for (&item, groups) in found {
        let given = expected.get(&item).unwrap_or(&none);
        for &group in &groups.further {
            if !given.all().any(|given| tags.agree(given, group)) {
                tell(item, FaultKind::StrangeGroup { found: tags.found(group) });
            }
        }
    }
}

/// By points of the mesh.
fn expected_at_points(outline: &Outline, chains: &Chains) -> BTreeMap<u32, Groups> {
    let mut groups: BTreeMap<u32, Groups> = BTreeMap::new();
    for membership in of_dimension(0, &outline.pslg.memberships) {
        // Of points in one place the first counts; those outside of the domain are not there.
        let vertex = chains.vertex.get(membership.item as usize);
        if let Some(&vertex) = vertex.filter(|&&vertex| vertex != NONE) {
            groups.entry(vertex).or_default().further.insert(membership.tag);
        }
    }
    groups
}

fn found_at_points(mesh: &Mesh) -> BTreeMap<u32, Groups> {
    let mut groups: BTreeMap<u32, Groups> = BTreeMap::new();
    for membership in of_dimension(0, &mesh.memberships) {
        if (membership.item as usize) < mesh.points.len() {
            groups.entry(membership.item).or_default().further.insert(membership.tag);
        }
    }
    groups
}

/// By edges of the mesh: the groups of their segment; and the segments.
fn expected_on_edges(
    outline: &Outline,
    chains: &Chains,
) -> (BTreeMap<[u32; 2], Groups>, BTreeMap<[u32; 2], u32>) {
    let mut further: BTreeMap<u32, BTreeSet<Tag>> = BTreeMap::new();
    for membership in of_dimension(1, &outline.pslg.memberships) {
        further.entry(membership.item).or_default().insert(membership.tag);
    }
    let (mut groups, mut segments) = (BTreeMap::new(), BTreeMap::new());
    for (s, segment) in (0..).zip(&outline.segments) {
        let further = further.get(&segment.input).cloned().unwrap_or_default();
        let of_segment = Groups { tag: Some(segment.tag), further };
        for edge in chains.pieces(s) {
            groups.insert(ordered(edge), of_segment.clone());
            segments.insert(ordered(edge), s);
        }
    }
    (groups, segments)
}

fn found_on_edges(mesh: &Mesh) -> BTreeMap<[u32; 2], Groups> {
    let mut groups: BTreeMap<[u32; 2], Groups> = BTreeMap::new();
    for (&edge, &tag) in mesh.edges.iter().zip(&mesh.edge_tags) {
        groups.entry(ordered(edge)).or_default().tag = Some(tag);
    }
    for membership in of_dimension(1, &mesh.memberships) {
        if let Some(&edge) = mesh.edges.get(membership.item as usize) {
            groups.entry(ordered(edge)).or_default().further.insert(membership.tag);
        }
    }
    groups
}

fn of_dimension(dim: u8, all: &[Membership]) -> impl Iterator<Item = &Membership> {
    all.iter().filter(move |membership| membership.dim == dim)
}

fn ordered([v, w]: [u32; 2]) -> [u32; 2] {
    [v.min(w), v.max(w)]
}
