//! Groups and materials of an `.obj` file, as tags and names.
//!
//! A segment belongs to the last `o` or `g` before it. Groups are numbered 1, 2, … as segments use
//! them. A name that ends in a *stated* one (`wall boundary_7`) has that number: so the files that
//! are written here keep numbers beside names. Materials tell segments of one group apart: a group
//! in which there are several becomes one group for each, `group/material`; segments without a
//! group have their material's name.

use std::collections::{BTreeMap, BTreeSet};

use crate::groups::{FreshTags, stated_tag};
use crate::pslg::{Group, Tag};
use crate::text::Word;

/// No name.
const NONE: u32 = 0;

/// The names that occur, and the pairs of a group and a material that segments have.
#[derive(Default)]
pub struct Groups {
    /// Each name once; the number of the first is 1.
    names: Vec<String>,
    numbers: BTreeMap<String, u32>,
    /// The group and the material that are in force.
    now: [u32; 2],
    /// Their index, where it is known.
    current: Option<u32>,
    /// Pairs that segments have, in the order of their first use.
    pairs: Vec<[u32; 2]>,
    indices: BTreeMap<[u32; 2], u32>,
}

impl Groups {
    /// `o` or `g`.
    pub fn begin_group(&mut self, name: &Word) {
        self.now[0] = self.number(name);
        self.current = None;
    }

    /// `usemtl`
    pub fn begin_material(&mut self, name: &Word) {
        self.now[1] = self.number(name);
        self.current = None;
    }

    fn number(&mut self, name: &Word) -> u32 {
        if name.bytes.is_empty() {
            return NONE;
        }
        let name = String::from_utf8_lossy(name.bytes);
        if let Some(&number) = self.numbers.get(&*name) {
            return number;
        }
        self.names.push(name.clone().into_owned());
        let number = self.names.len() as u32;
        self.numbers.insert(name.into_owned(), number);
        number
    }

    /// The index of the pair that is in force.
    pub fn current(&mut self) -> u32 {
        *self.current.get_or_insert_with(|| {
            let next = self.pairs.len() as u32;
            let index = *self.indices.entry(self.now).or_insert(next);
            if index == next {
                self.pairs.push(self.now);
            }
            index
        })
    }

    /// The tag of each segment, by the index of its pair, and the names of the tags.
    pub fn tags(&self, of_segments: &[u32]) -> (Vec<Tag>, Vec<Group>) {
        let mut is_used = vec![false; self.pairs.len()];
        of_segments.iter().for_each(|&pair| is_used[pair as usize] = true);
        let names = self.names_of_pairs(&is_used);
        let stated_tags: BTreeSet<Tag> = names.iter().filter_map(|name| stated(name).1).collect();
        let mut fresh = FreshTags::beside(stated_tags);
        let mut of_name = BTreeMap::new();
        let mut groups = Vec::new();
        let mut tag = |name| {
            let (name, stated) = stated(name);
            let tag = stated.unwrap_or_else(|| fresh.take());
            groups.extend(name.map(|name| Group { dim: 1, tag, name: name.to_owned() }));
            tag
        };
        let tags: Vec<Tag> = names
            .iter()
            .map(|name| match &**name {
                "" => 0,
                name => *of_name.entry(name).or_insert_with(|| tag(name)),
            })
            .collect();
        (of_segments.iter().map(|&pair| tags[pair as usize]).collect(), groups)
    }

    /// The name of each pair; empty where it has none, or is not used.
    fn names_of_pairs(&self, is_used: &[bool]) -> Vec<String> {
        let used = || self.pairs.iter().zip(is_used).filter(|(_, is_used)| **is_used);
        let mut materials = BTreeMap::new();
        used().for_each(|(&[group, _], _)| *materials.entry(group).or_insert(0) += 1);
        let text = |number: u32| &*self.names[number as usize - 1];
        let name = |(&[group, material], &is_used): (&[u32; 2], &bool)| match [group, material] {
            _ if !is_used => String::new(),
            [NONE, NONE] => String::new(),
            [NONE, material] => text(material).to_owned(),
            [group, material] if material != NONE && materials[&group] > 1 => {
                format!("{}/{}", text(group), text(material))
            }
            [group, _] => text(group).to_owned(),
        };
        self.pairs.iter().zip(is_used).map(name).collect()
    }
}

/// The user's name and the number in a name that ends in a stated one.
pub fn stated(name: &str) -> (Option<&str>, Option<Tag>) {
    let (before, last) = name.rsplit_once(' ').unwrap_or(("", name));
    match stated_tag(1, last).filter(|&tag| tag != 0) {
        Some(tag) => (Some(before).filter(|before| !before.is_empty()), Some(tag)),
        None => (Some(name).filter(|name| !name.is_empty()), None),
    }
}
