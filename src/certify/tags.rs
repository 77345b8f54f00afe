//! G4, tags: what is a part of a segment or of a region carries its tag.
//!
//! Formats renumber and name (no number below 1 in `.msh`; whatever has no tag gets a name there),
//! so tags are compared by name where the outline or the format gave one, else by number.

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::outline::Outline;
use super::verdict::{Fault, FaultKind, Judgement};
use crate::formats::{Group, Tag};

/// The names of the tags of one dimension, in the outline and in the mesh.
pub(super) struct Tags<'a> {
    dim: u8,
    outline: Vec<(Tag, &'a str)>,
    mesh: Vec<(Tag, &'a str)>,
    /// The last pair that was compared, and the answer: neighbours mostly ask the same.
    last: Option<(Tag, Tag, bool)>,
}

impl<'a> Tags<'a> {
    pub(super) fn new(dim: u8, outline: &'a [Group], mesh: &'a [Group]) -> Self {
        let names = |groups: &'a [Group]| {
            let of_dim = groups.iter().filter(|group| group.dim == dim);
            let mut names: Vec<_> = of_dim.map(|group| (group.tag, group.name.as_str())).collect();
            names.sort_unstable();
            names
        };
        Self { dim, outline: names(outline), mesh: names(mesh), last: None }
    }

    /// Whether the tag `found` in the mesh stands for the tag `expected` of the outline.
    pub(super) fn agree(&mut self, expected: Tag, found: Tag) -> bool {
        if let Some((e, f, answer)) = self.last
            && (e, f) == (expected, found)
        {
            return answer;
        }
        let answer = match (name(&self.outline, expected), name(&self.mesh, found)) {
            (Some(expected), Some(found)) => expected == found,
            (None, Some(found)) if self.is_stated_name(found, expected) => true,
            _ => expected == found,
        };
        self.last = Some((expected, found, answer));
        answer
    }

    /// Whether this is the name that writers give to a tag without a name.
    fn is_stated_name(&self, name: &str, tag: Tag) -> bool {
        let stems: &[&str] = if self.dim == 2 { &["region"] } else { &["boundary", "interface"] };
        stems.iter().any(|stem| {
            name.strip_prefix(stem).is_some_and(|rest| match rest.strip_prefix('_') {
                None => rest.is_empty() && tag == 0,
                Some(number) => number.parse() == Ok(tag),
            })
        })
    }

    /// A tag of the outline, for a message.
    pub(super) fn expected(&self, tag: Tag) -> String {
        with_name(tag, name(&self.outline, tag))
    }

    /// A tag of the mesh, for a message.
    pub(super) fn found(&self, tag: Tag) -> String {
        with_name(tag, name(&self.mesh, tag))
    }
}

fn name<'a>(names: &[(Tag, &'a str)], tag: Tag) -> Option<&'a str> {
    names.binary_search_by_key(&tag, |(tag, _)| *tag).ok().map(|i| names[i].1)
}

fn with_name(tag: Tag, name: Option<&str>) -> String {
    name.map_or_else(|| tag.to_string(), |name| format!("{tag} ({name})"))
}

/// Judges the region tags: each triangle belongs to the face of the outline that it can be
/// reached from without crossing a segment.
pub(super) fn judge_regions(
    outline: &Outline,
    complex: &Complex,
    chains: &Chains,
    g4: &mut Judgement,
) {
    let mesh = complex.mesh;
    if mesh.triangle_tags.is_empty() {
        return; // said elsewhere
    }
    let mut tags = Tags::new(2, &outline.pslg.groups, &mesh.groups);
    let faces = faces_of_triangles(outline, complex, chains);
    for (t, &face) in faces.iter().enumerate().filter(|(_, face)| **face != NONE) {
        let number = complex.numbers[t];
        let expected = outline.faces[face as usize].tag;
        let found = mesh.triangle_tags.get(number as usize).copied().unwrap_or(0);
        if !tags.agree(expected, found) {
            let (found, expected) = (tags.found(found), tags.expected(expected));
            g4.add(Fault::at_triangle(mesh, FaultKind::WrongRegionTag { found, expected }, number));
        }
    }
}

/// The face of the outline that each triangle lies in; [`NONE`] where no segment says so.
fn faces_of_triangles(outline: &Outline, complex: &Complex, chains: &Chains) -> Vec<u32> {
    let mut faces = vec![NONE; complex.triangles.len()];
    let mut stack = Vec::new();
    for h in 0..complex.twin.len() as u32 {
        let Some(half) = chains.outline_half(h) else { continue };
        let face = outline.face(half);
        if faces[h as usize / 3] == NONE && outline.faces[face as usize].meshed {
            faces[h as usize / 3] = face;
            stack.push(h / 3);
        }
        while let Some(t) = stack.pop() {
            for side in 3 * t..3 * t + 3 {
                let twin = complex.twin[side as usize];
                if twin != NONE && !chains.is_bound(side) && faces[twin as usize / 3] == NONE {
                    faces[twin as usize / 3] = face;
                    stack.push(twin / 3);
                }
            }
        }
    }
    faces
}
