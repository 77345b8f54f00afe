//! From the user's tags and names to the groups of a file, and back.
//!
//! The user's numbers and names are kept wherever a format can hold them. What has no tag (0) gets
//! a fresh positive number and a name that says what it is: `boundary` for edges with one
//! triangle, `interface` for edges between two, `region` for triangles. A tag without a name gets
//! a *stated* one ([`stated_name`]): `boundary_3`, `region_7`. So every number in a file has a
//! name, and a name tells the user's number even where the file could not keep it.

mod note;
#[cfg(test)]
mod tests;

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use crate::mesh::Mesh;
use crate::pslg::{Group, Pslg, Tag};

pub use note::Note;
pub(crate) use note::numbers_only;

/// What a format, or the user, asks of the numbers and names of groups.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rules {
    /// Numbers must be positive: tags below 1 get fresh numbers.
    pub positive: bool,
    /// No number may serve two groups: where one does, regions are numbered 1, 2, …, then boundaries
    /// go on.
    pub unique: bool,
    /// Names stand between double quotes that nothing escapes: `"` becomes `'`.
    pub quoted: bool,
    /// The format holds groups of points and any number of groups for an edge.
    pub memberships: bool,
    /// The format holds names of groups, no numbers.
    pub numberless: bool,
    /// What a name may look like.
    pub names: Names,
    /// The dimension (1 or 2) of groups that the format does not hold; nothing is said of them.
    pub without: Option<u8>,
}

/// What a name may look like in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Names {
    /// Anything but control characters.
    #[default]
    Any,
    /// One word: white space becomes `_`, and so does `\`, which at the end of a line of `.obj`
    /// joins the next one to it.
    Words,
    /// One word of ASCII letters, digits, `_`, `-` and `.`, a letter first: all else becomes `_`.
    /// Two of them differ in more than capitals.
    Plain,
}

/// One group of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// 0 for points, 1 for edges, 2 for triangles.
    pub dim: u8,
    /// The user's tag; 0 if there is none.
    pub tag: Tag,
    /// The number that the file holds.
    pub number: Tag,
    /// The name that the file holds.
    pub name: String,
}

/// The groups that a file holds for a mesh.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    /// The groups: points before edges before triangles, by tag.
    pub entries: Vec<Entry>,
    /// The group of each edge, as an index into [`Table::entries`].
    pub edges: Vec<u32>,
    /// The group of each of [`Mesh::memberships`], as an index into [`Table::entries`]; empty where
    /// the format does not hold them.
    pub memberships: Vec<u32>,
    /// Tag and index of each group of triangles, by tag.
    regions: Vec<(Tag, usize)>,
}

fn kind(dim: u8) -> &'static str {
    match dim {
        0 => "point",
        1 => "boundary",
        _ => "region",
    }
}

fn cells(dim: u8) -> &'static str {
    match dim {
        0 => "points",
        1 => "edges",
        _ => "triangles",
    }
}

/// The name that a tag without one gets: `boundary_3`, `region_7`, `boundary_-1`.
///
/// ```
/// use meshwright_formats::groups::stated_name;
/// assert_eq!(stated_name(1, -1), "boundary_-1");
/// assert_eq!(stated_name(2, 7), "region_7");
/// ```
#[must_use]
pub fn stated_name(dim: u8, tag: Tag) -> String {
    format!("{}_{tag}", kind(dim))
}

/// The tag that a stated name tells, untagged (0) included; `None` for a name of the user's.
#[must_use]
pub fn stated_tag(dim: u8, name: &str) -> Option<Tag> {
    let untagged = match dim {
        1 => name == BOUNDARY || name == INTERFACE,
        _ => name == kind(dim),
    };
    if untagged {
        return Some(0);
    }
    let tag = name.strip_prefix(kind(dim))?.strip_prefix('_')?.parse().ok()?;
    (stated_name(dim, tag) == name).then_some(tag)
}

const BOUNDARY: &str = "boundary";
const INTERFACE: &str = "interface";
const REGION: &str = "region";

/// Whether a tag of an outline and a tag of a mesh mean the same group: by name where both have
/// one, else by number.
///
/// A stated name counts as its number, so a mesh read back from a file that had to renumber still
/// agrees with its outline.
///
/// ```
/// use meshwright_formats::{Group, groups::agree};
/// let group = |tag, name: &str| Group { dim: 1, tag, name: name.into() };
/// let outline = [group(3, "inlet")];
/// let mesh = [group(7, "inlet"), group(8, "boundary_-1")];
/// assert!(agree(1, (3, &outline), (7, &mesh)));
/// assert!(agree(1, (-1, &outline), (8, &mesh)));
/// assert!(!agree(1, (8, &outline), (8, &mesh)));
/// ```
#[must_use]
pub fn agree(dim: u8, outline: (Tag, &[Group]), mesh: (Tag, &[Group])) -> bool {
    // A name that the other side has too belongs to that group and to no number.
    let unknown = |name: &str, (_, groups): (Tag, &[Group])| {
        !groups.iter().any(|group| group.dim == dim && same_name(&group.name, name))
    };
    match (meaning(dim, outline), meaning(dim, mesh)) {
        (Meaning::Name(a, _), Meaning::Name(b, _)) => same_name(a, b),
        (Meaning::Number(a), Meaning::Number(b)) => a == b,
        (Meaning::Number(a), Meaning::Name(name, b)) => a == b && unknown(name, outline),
        (Meaning::Name(name, a), Meaning::Number(b)) => a == b && unknown(name, mesh),
    }
}

/// Whether two names are the same, or are so in a file that can hold neither as it is.
fn same_name(a: &str, b: &str) -> bool {
    let strictest = Rules { quoted: true, ..Rules::default() };
    a == b || writable(a, strictest) == writable(b, strictest)
}

enum Meaning<'a> {
    Name(&'a str, Tag),
    Number(Tag),
}

fn meaning(dim: u8, (tag, groups): (Tag, &[Group])) -> Meaning<'_> {
    let Some(group) = groups.iter().find(|g| g.dim == dim && g.tag == tag) else {
        return Meaning::Number(tag);
    };
    match stated_tag(dim, &group.name) {
        Some(tag) => Meaning::Number(tag),
        None => Meaning::Name(&group.name, tag),
    }
}

/// Positive numbers that are not taken yet, from the smallest.
pub(crate) struct FreshTags {
    used: BTreeSet<Tag>,
    next: Tag,
}

impl FreshTags {
    pub fn beside(used: BTreeSet<Tag>) -> Self {
        Self { used, next: 1 }
    }

    pub fn take(&mut self) -> Tag {
        while self.used.contains(&self.next) {
            self.next += 1;
        }
        self.next += 1;
        self.next - 1
    }
}

/// What tells groups apart before they have a name: dimension, tag, and for untagged edges
/// whether they lie between two triangles.
type Key = (u8, Tag, bool);

impl Table {
    /// The groups of a mesh under a format's rules.
    #[must_use]
    pub fn new(mesh: &Mesh, rules: Rules) -> (Self, Vec<Note>) {
        let mut notes = Vec::new();
        let names = names(mesh, rules, &mut notes);
        let interfaces = untagged_interfaces(mesh, &names);
        let edge_key = |edge: usize| (1, mesh.edge_tag(edge), interfaces.contains(&edge));
        let keys = keys(mesh, &names, rules, edge_key);
        let numbers = numbers(&keys, rules);
        let entries = entries(&keys, &numbers, names);
        let index = |key: Key| keys.binary_search(&key).unwrap_or(0);
        let edges = (0..mesh.edges.len()).map(|edge| index(edge_key(edge)) as u32).collect();
        let regions = entries.iter().enumerate().filter(|(_, e)| e.dim == 2);
        let regions = regions.map(|(i, e)| (e.tag, i)).collect();
        let held = if rules.memberships { &mesh.memberships[..] } else { &[] };
        let memberships = held.iter().map(|m| index((m.dim, m.tag, false)) as u32).collect();
        let further = mesh.memberships.iter().filter(|m| m.dim == 1).count();
        if !rules.memberships && further > 0 {
            notes.push(Note::FurtherGroups { count: further });
        }
        tell(&entries, rules, &mut notes);
        (Self { entries, edges, memberships, regions }, notes)
    }

    /// The group of the triangles with this tag, as an index into [`Table::entries`].
    #[must_use]
    pub fn region(&self, tag: Tag) -> usize {
        match self.regions.binary_search_by_key(&tag, |&(tag, _)| tag) {
            Ok(place) => self.regions[place].1,
            Err(_) => panic!("every tag of a triangle has a group"),
        }
    }
}

/// What is said of the segments of an outline that are in more than one group, where the file holds
/// one.
pub(crate) fn further_groups(outline: &Pslg) -> Option<Note> {
    let count = outline.memberships.iter().filter(|membership| membership.dim == 1).count();
    (count > 0).then_some(Note::FurtherGroups { count })
}

/// The user's names as the file can hold them, by dimension and tag.
fn names(mesh: &Mesh, rules: Rules, notes: &mut Vec<Note>) -> BTreeMap<(u8, Tag), String> {
    let mut names = BTreeMap::new();
    let mut taken = BTreeSet::new();
    for Group { dim, tag, name } in &mesh.groups {
        if rules.without == Some(*dim) {
            continue;
        }
        let is_held = matches!(dim, 1 | 2) || (rules.memberships && *dim == 0);
        if !is_held {
            notes.push(Note::PointGroup { name: name.clone() });
            continue;
        }
        let mut written = writable(name, rules);
        if rules.names == Names::Plain {
            written = other_than(&taken, *dim, written);
            taken.insert((*dim == 2, written.to_ascii_lowercase()));
        }
        if written != *name {
            notes.push(Note::NameChanged { name: name.clone(), written: written.to_string() });
        }
        if written.is_empty() {
            continue;
        }
        if let Some(kept) = names.get(&(*dim, *tag)) {
            notes.push(Note::SecondName { kept: String::clone(kept), dropped: name.clone() });
            continue;
        }
        names.insert((*dim, *tag), written.into_owned());
    }
    names
}

pub(crate) fn writable(name: &str, rules: Rules) -> Cow<'_, str> {
    // XML has no place for the last two, text files none for the others.
    let forbidden = |c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}');
    let good = |c: char| match c {
        '"' if rules.quoted => '\'',
        c if rules.names != Names::Any && (c.is_whitespace() || forbidden(c)) => '_',
        '\\' if rules.names == Names::Words => '_',
        c if rules.names == Names::Plain && !is_plain(c) => '_',
        c if forbidden(c) => ' ',
        c => c,
    };
    let begins_well = rules.names != Names::Plain
        || name.is_empty()
        || name.starts_with(|c: char| c.is_ascii_alphabetic());
    if begins_well && name.chars().all(|c| c == good(c)) {
        return name.into();
    }
    let start = if begins_well { "" } else { "g_" };
    start.chars().chain(name.chars().map(good)).collect::<String>().into()
}

fn is_plain(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.')
}

/// The name, or the name with a number that no other group of regions, or of edges and points, has.
fn other_than<'a>(taken: &BTreeSet<(bool, String)>, dim: u8, name: Cow<'a, str>) -> Cow<'a, str> {
    let is_free = |name: &str| !taken.contains(&(dim == 2, name.to_ascii_lowercase()));
    if name.is_empty() || is_free(&name) {
        return name;
    }
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    numbered.into_iter().find(|name| is_free(name)).map_or(name.clone(), Cow::Owned)
}

/// The untagged edges that two triangles use; none where the user named the untagged ones.
fn untagged_interfaces(mesh: &Mesh, names: &BTreeMap<(u8, Tag), String>) -> BTreeSet<usize> {
    if names.contains_key(&(1, 0)) {
        return BTreeSet::new();
    }
    inner_edges(mesh, |edge| mesh.edge_tag(edge) == 0)
}

/// The edges, of those that are `asked` for, that two triangles use.
pub(crate) fn inner_edges(mesh: &Mesh, asked: impl Fn(usize) -> bool) -> BTreeSet<usize> {
    let asked = || (0..mesh.edges.len()).filter(|&edge| asked(edge));
    let mut triangles: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut ends = vec![false; mesh.points.len()];
    for edge in asked() {
        let [a, b] = mesh.edges[edge];
        triangles.insert([a.min(b), a.max(b)], 0);
        for end in [a, b] {
            if let Some(end) = ends.get_mut(end as usize) {
                *end = true;
            }
        }
    }
    if triangles.is_empty() {
        return BTreeSet::new();
    }
    // Few points are ends of such an edge: most triangle edges need no search.
    let is_end = |point: u32| ends.get(point as usize).is_some_and(|&end| end);
    for &[a, b, c] in &mesh.triangles {
        for [a, b] in [[a, b], [b, c], [c, a]] {
            if is_end(a)
                && is_end(b)
                && let Some(count) = triangles.get_mut(&[a.min(b), a.max(b)])
            {
                *count += 1;
            }
        }
    }
    let shared = |&edge: &usize| {
        let [a, b] = mesh.edges[edge];
        triangles[&[a.min(b), a.max(b)]] >= 2
    };
    asked().filter(shared).collect()
}

/// The groups that occur, and those that have only a name; sorted.
fn keys(
    mesh: &Mesh,
    names: &BTreeMap<(u8, Tag), String>,
    rules: Rules,
    edge_key: impl Fn(usize) -> Key,
) -> Vec<Key> {
    let named = names.keys().filter(|&&(_, tag)| tag != 0);
    let mut keys: BTreeSet<Key> = named.map(|&(dim, tag)| (dim, tag, false)).collect();
    keys.extend((0..mesh.edges.len()).map(edge_key));
    if rules.memberships {
        keys.extend(mesh.memberships.iter().map(|m| (m.dim, m.tag, false)));
    }
    let mut last = None;
    for triangle in 0..mesh.triangles.len() {
        let tag = mesh.triangle_tag(triangle);
        if last != Some(tag) {
            keys.insert((2, tag, false));
            last = Some(tag);
        }
    }
    keys.into_iter().collect()
}

/// The number of each group in the file.
fn numbers(keys: &[Key], rules: Rules) -> BTreeMap<Key, Tag> {
    let keeps = |&(_, tag, _): &Key| tag > 0 || (tag < 0 && !rules.positive);
    let used = keys.iter().filter(|key| keeps(key)).map(|key| key.1).collect();
    let mut fresh = FreshTags::beside(used);
    let number = |&key: &Key| (key, if keeps(&key) { key.1 } else { fresh.take() });
    let numbers: BTreeMap<Key, Tag> = keys.iter().map(number).collect();
    let different = numbers.values().collect::<BTreeSet<_>>().len();
    if rules.unique && different < keys.len() {
        let regions = keys.iter().filter(|key| key.0 == 2);
        return regions.chain(keys.iter().filter(|key| key.0 != 2)).copied().zip(1..).collect();
    }
    numbers
}

fn entries(
    keys: &[Key],
    numbers: &BTreeMap<Key, Tag>,
    mut names: BTreeMap<(u8, Tag), String>,
) -> Vec<Entry> {
    let entry = |&key: &Key| {
        let (dim, tag, interface) = key;
        let name = names.remove(&(dim, tag)).unwrap_or_else(|| match (dim, tag, interface) {
            (1, 0, false) => BOUNDARY.to_owned(),
            (1, 0, true) => INTERFACE.to_owned(),
            (_, 0, _) => REGION.to_owned(),
            _ => stated_name(dim, tag),
        });
        Entry { dim, tag, number: numbers[&key], name }
    };
    keys.iter().map(entry).collect()
}

/// Says what differs from the user's tags, and what readers may misread.
fn tell(entries: &[Entry], rules: Rules, notes: &mut Vec<Note>) {
    let held = || entries.iter().filter(|entry| rules.without != Some(entry.dim));
    for &Entry { dim, tag, number, ref name } in held() {
        let name = name.clone();
        if tag == 0 {
            let number = (!rules.numberless).then_some(number);
            notes.push(Note::Untagged { dim, number, name });
        } else if tag != number && !rules.numberless {
            notes.push(Note::Renumbered { dim, tag, number, name });
        }
    }
    let numbers = |dim| held().filter(move |e| e.dim == dim).map(|e| e.number);
    let regions: BTreeSet<Tag> = numbers(2).collect();
    let shared: BTreeSet<Tag> = numbers(1).filter(|number| regions.contains(number)).collect();
    if !shared.is_empty() && !rules.numberless {
        notes.push(Note::SharedNumbers { numbers: shared.into_iter().collect() });
    }
    let mut seen = BTreeMap::new();
    for Entry { name, .. } in held() {
        *seen.entry(name).or_insert(0) += 1;
    }
    for (name, count) in seen {
        if count > 1 {
            notes.push(Note::SharedName { name: name.clone() });
        }
        if name.contains(char::is_whitespace) {
            notes.push(Note::NameWithSpace { name: name.clone() });
        }
    }
}
