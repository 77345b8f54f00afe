//! Tags for groups that a file tells by their names alone.

use std::collections::{BTreeMap, BTreeSet};

use crate::groups::{FreshTags, stated_tag};
use crate::pslg::{Group, Tag};

/// The groups of one dimension, by their names.
pub(crate) struct Named<'a> {
    pub dim: u8,
    pub names: Vec<&'a str>,
}

/// The tag of each name: the one that it states (`boundary_3`), the number that it is, or else the
/// next number that no other group of the file has. Names that are none of the user's, as they
/// state a tag, are no groups.
pub(crate) fn of_names(all: &[Named], groups: &mut Vec<Group>) -> Vec<Vec<Tag>> {
    let told = |dim: u8, name: &str| {
        let number = || name.parse().ok().filter(|tag: &Tag| tag.to_string() == name);
        stated_tag(dim, name).or_else(number)
    };
    let each = all.iter().flat_map(|Named { dim, names }| names.iter().map(|name| (*dim, *name)));
    let used: BTreeSet<Tag> = each.filter_map(|(dim, name)| told(dim, name)).collect();
    let mut fresh = FreshTags::beside(used);
    let mut known = BTreeMap::new();
    let mut all_tags = Vec::new();
    for Named { dim, names } in all {
        let mut tags = Vec::new();
        for &name in names {
            let tag = told(*dim, name).unwrap_or_else(|| {
                *known.entry((*dim, name)).or_insert_with(|| {
                    let tag = fresh.take();
                    groups.push(Group { dim: *dim, tag, name: name.to_owned() });
                    tag
                })
            });
            tags.push(tag);
        }
        all_tags.push(tags);
    }
    all_tags
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_the_numbers_that_they_tell() {
        let names = |dim, names: &[&'static str]| Named { dim, names: names.to_vec() };
        let all = [
            names(2, &["water", "region_3", "1"]),
            names(1, &["wall", "boundary", "wall", "boundary_-4", "01"]),
        ];
        let mut groups = Vec::new();
        let tags = of_names(&all, &mut groups);
        assert_eq!(tags, [vec![2, 3, 1], vec![4, 0, 4, -4, 5]]);
        let named: Vec<_> = groups.iter().map(|g| (g.dim, g.tag, g.name.as_str())).collect();
        assert_eq!(named, [(2, 2, "water"), (1, 4, "wall"), (1, 5, "01")]);
    }
}
