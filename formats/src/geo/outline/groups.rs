//! Which group each point, curve and surface belongs to.

use super::places::first_place;
use crate::error::{Notice, Warning};
use crate::geo::model::Model;
use crate::geo::sources::Sources;
use crate::pslg::{Group, Tag};

/// The groups of a script. Without any, each curve and each surface is a group of its own, as in
/// the meshes that Gmsh then writes.
pub(super) struct Grouping {
    is_empty: bool,
    /// By dimension: entities and the groups that hold them, in this order.
    members: [Vec<(i32, Tag)>; 3],
    names: Vec<Group>,
}

impl Grouping {
    pub(super) fn new(model: &Model, sources: &Sources, warnings: &mut Vec<Warning>) -> Self {
        let mut members = [Vec::new(), Vec::new(), Vec::new()];
        for (&(dim, tag), group) in &model.groups {
            let exists = |member: i32| match dim {
                0 => model.points.contains(member),
                1 => model.curves.contains(member),
                _ => model.surfaces.contains_key(&member),
            };
            let mut missing = Vec::new();
            for &member in &group.members {
                if exists(member) {
                    members[usize::from(dim)].push((member, tag));
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
        for members in &mut members {
            members.sort_unstable();
            members.dedup();
        }
        let names = model
            .groups
            .iter()
            .filter_map(|(&(dim, tag), group)| Some(Group { dim, tag, name: group.name.clone()? }));
        let grouping = Self { is_empty: model.groups.is_empty(), members, names: names.collect() };
        grouping.warn(model, sources, warnings);
        grouping
    }

    /// Says where an outline holds less than the script: a region has one group.
    fn warn(&self, model: &Model, sources: &Sources, warnings: &mut Vec<Warning>) {
        for of_one in self.members[2].chunk_by(|(a, _), (b, _)| a == b) {
            if let [(surface, kept), (_, dropped), ..] = *of_one {
                let place = model.groups[&(2, dropped)].place;
                let notice = Notice::SecondGroup { surface, kept, dropped };
                let file = sources.name(place.file).to_owned();
                warnings.push(Warning { file, line: sources.line(place), notice });
            }
        }
    }

    /// The groups of a point.
    pub(super) fn of_point(&self, tag: i32) -> impl Iterator<Item = Tag> + '_ {
        self.of(0, tag)
    }

    /// The groups of a curve besides its first.
    pub(super) fn further_of_curve(&self, tag: i32) -> impl Iterator<Item = Tag> + '_ {
        self.of(1, tag).skip(1)
    }

    /// The group of a curve; 0 for none.
    pub(super) fn curve(&self, tag: i32) -> Tag {
        if self.is_empty { tag } else { self.of(1, tag).next().unwrap_or(0) }
    }

    /// The group of a surface; 0 for none.
    pub(super) fn surface(&self, tag: i32) -> Tag {
        if self.is_empty { tag } else { self.of(2, tag).next().unwrap_or(0) }
    }

    /// The groups of an entity, the smallest number first.
    fn of(&self, dim: usize, entity: i32) -> impl Iterator<Item = Tag> + '_ {
        let members = &self.members[dim];
        let first = first_place(members, |&(member, _)| i64::from(member), i64::from(entity));
        let of_one = members[first..].iter().take_while(move |&&(member, _)| member == entity);
        of_one.map(|&(_, tag)| tag)
    }

    /// The names of the groups.
    pub(super) fn names(self) -> Vec<Group> {
        self.names
    }
}
