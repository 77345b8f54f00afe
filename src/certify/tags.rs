//! G4, tags: what is a part of a segment or of a region carries its tag.
//!
//! Formats renumber and name (no number below 1 in `.msh`; whatever has no tag gets a name there),
//! so tags are compared by name where the outline or the format gave one, else by number.

use std::collections::BTreeMap;

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::fault::{Fault, FaultKind};
use super::nearby::Nearby;
use super::outline::Outline;
use super::verdict::Judgement;
use crate::formats::{Group, Tag, groups};

/// The tags of one dimension, in the outline and in the mesh.
pub(super) struct Tags<'a> {
    dim: u8,
    outline: &'a [Group],
    mesh: &'a [Group],
    /// The pairs that were compared, and the answers.
    known: BTreeMap<(Tag, Tag), bool>,
}

impl<'a> Tags<'a> {
    pub(super) fn new(dim: u8, outline: &'a [Group], mesh: &'a [Group]) -> Self {
        Self { dim, outline, mesh, known: BTreeMap::new() }
    }

    /// Whether the tag `found` in the mesh stands for the tag `expected` of the outline.
    pub(super) fn agree(&mut self, expected: Tag, found: Tag) -> bool {
        let Self { dim, outline, mesh, known } = self;
        let answer = || groups::agree(*dim, (expected, outline), (found, mesh));
        *known.entry((expected, found)).or_insert_with(answer)
    }

    /// A tag of the outline, for a message.
    pub(super) fn expected(&self, tag: Tag) -> String {
        self.described(tag, self.outline)
    }

    /// A tag of the mesh, for a message.
    pub(super) fn found(&self, tag: Tag) -> String {
        self.described(tag, self.mesh)
    }

    fn described(&self, tag: Tag, groups: &[Group]) -> String {
        let group = groups.iter().find(|group| group.dim == self.dim && group.tag == tag);
        group.map_or_else(|| tag.to_string(), |group| format!("{tag} ({})", group.name))
    }
}

/// Judges the region tags: each triangle belongs to the face of the outline that it can be
/// reached from without crossing a segment.
pub(super) fn judge_regions(
    nearby: &Nearby,
    outline: &Outline,
    complex: &Complex,
    chains: &Chains,
    g4: &mut Judgement,
) {
    let mesh = complex.mesh;
    if nearby.triangle_tags().is_empty() {
        return; // said elsewhere
    }
    let mut tags = Tags::new(2, &outline.pslg.groups, &mesh.groups);
    if are_all_alike(outline, nearby, &mut tags) {
        return;
    }
    let faces = faces_of_triangles(outline, complex, chains);
    for (t, &face) in faces.iter().enumerate().filter(|(_, face)| **face != NONE) {
        let number = complex.number_of(t);
        let expected = outline.faces[face as usize].tag;
        let found = nearby.triangle_tag(number);
        if !tags.agree(expected, found) {
            let (found, expected) = (tags.found(found), tags.expected(expected));
            g4.add(Fault::at_triangle(mesh, FaultKind::WrongRegionTag { found, expected }, number));
        }
    }
}

/// Whether one tag is expected of all triangles, and found.
fn are_all_alike(outline: &Outline, nearby: &Nearby, tags: &mut Tags) -> bool {
    let mut expected = outline.faces.iter().filter(|face| face.meshed).map(|face| face.tag);
    let Some(first) = expected.next() else { return false };
    expected.all(|tag| tag == first)
        && nearby.triangle_tags().len() == nearby.mesh.triangles.len()
        && nearby.triangle_tags().chunk_by(|a, b| a == b).all(|run| tags.agree(first, run[0]))
}

/// The face of the outline that each triangle lies in; [`NONE`] where no segment says so.
fn faces_of_triangles(outline: &Outline, complex: &Complex, chains: &Chains) -> Vec<u32> {
    let mut faces = vec![NONE; complex.triangles.len()];
    let mut stack = Vec::new();
    for h in chains.bound() {
        let Some(half) = chains.outline_half(h) else { continue };
        let face = outline.face(half);
        if faces[h as usize / 3] == NONE && outline.faces[face as usize].meshed {
            faces[h as usize / 3] = face;
            stack.push(h / 3);
        }
        while let Some(t) = stack.pop() {
            for side in 3 * t..3 * t + 3 {
                if chains.is_bound(side) {
                    continue;
                }
                let twin = complex.twin(side);
                if twin != NONE && faces[twin as usize / 3] == NONE {
                    faces[twin as usize / 3] = face;
                    stack.push(twin / 3);
                }
            }
        }
    }
    faces
}
