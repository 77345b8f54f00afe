//! Which group each point, curve and surface belongs to.

use std::collections::BTreeMap;

use crate::error::{Notice, Warning};
use crate::geo::model::Model;
use crate::geo::sources::Sources;
use crate::pslg::{Group, Tag};

/// The groups of a script. Without any, each curve and each surface is a group of its own, as in
/// the meshes that Gmsh then writes.
pub(super) struct Grouping<'a> {
    model: &'a Model,
    /// By dimension and tag of the entity: the groups that hold it, the smallest number first.
    of_entity: BTreeMap<(u8, i32), Vec<Tag>>,
}

impl<'a> Grouping<'a> {
    pub(super) fn new(model: &'a Model, sources: &Sources, warnings: &mut Vec<Warning>) -> Self {
        let mut of_entity: BTreeMap<(u8, i32), Vec<Tag>> = BTreeMap::new();
        for (&(dim, tag), group) in &model.groups {
            let exists = |member: i32| match dim {
                0 => model.points.contains_key(&member),
                1 => model.curves.contains_key(&member),
                _ => model.surfaces.contains_key(&member),
            };
            let mut missing = Vec::new();
            for &member in &group.members {
                if exists(member) {
                    let groups = of_entity.entry((dim, member)).or_default();
                    if groups.last() != Some(&tag) {
                        groups.push(tag);
                    }
                } else {
                    missing.push(member);
                }
            }
            if let Some(&first) = missing.first() {
                let notice = Notice::MissingMembers { dim, tag, first, count: missing.len() };
                let (file, line) =
                    (sources.name(group.place.file).to_owned(), sources.line(group.place));
                warnings.push(Warning { file, line, notice });
            }
        }
        Self { model, of_entity }
    }

    /// Whether any point is in a group.
    pub(super) fn has_points(&self) -> bool {
        self.of_entity.keys().any(|&(dim, _)| dim == 0)
    }

    /// The group of a point; 0 for none.
    pub(super) fn point(&self, tag: i32) -> Tag {
        self.first(0, tag)
    }

    /// The group of a curve; 0 for none.
    pub(super) fn curve(&self, tag: i32) -> Tag {
        if self.model.groups.is_empty() { tag } else { self.first(1, tag) }
    }

    /// The group of a surface; 0 for none.
    pub(super) fn surface(&self, tag: i32) -> Tag {
        if self.model.groups.is_empty() { tag } else { self.first(2, tag) }
    }

    fn first(&self, dim: u8, tag: i32) -> Tag {
        self.of_entity.get(&(dim, tag)).and_then(|groups| groups.first()).copied().unwrap_or(0)
    }

    /// The names of the groups.
    pub(super) fn names(&self) -> Vec<Group> {
        let named =
            self.model.groups.iter().filter_map(|(&(dim, tag), group)| {
                Some(Group { dim, tag, name: group.name.clone()? })
            });
        named.collect()
    }
}
