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
        let grouping = Self { model, of_entity };
        grouping.warn(sources, warnings);
        grouping
    }

    /// Says where an outline holds less than the script: a region has one group.
    fn warn(&self, sources: &Sources, warnings: &mut Vec<Warning>) {
        for (&(_, entity), groups) in self.of_entity.iter().filter(|((dim, _), _)| *dim == 2) {
            if let [kept, dropped, ..] = groups[..] {
                let place = self.model.groups[&(2, dropped)].place;
                let notice = Notice::SecondGroup { surface: entity, kept, dropped };
                let file = sources.name(place.file).to_owned();
                warnings.push(Warning { file, line: sources.line(place), notice });
            }
        }
    }

    /// The groups of a point.
    pub(super) fn of_point(&self, tag: i32) -> &[Tag] {
        self.of_entity.get(&(0, tag)).map_or(&[], |groups| groups)
    }

    /// The groups of a curve besides its first.
    pub(super) fn further_of_curve(&self, tag: i32) -> &[Tag] {
        self.of_entity.get(&(1, tag)).map_or(&[], |groups| &groups[1..])
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
