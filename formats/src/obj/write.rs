//! Writing `.obj`: an outline as polylines.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};

use super::groups::stated;
use crate::groups::{FreshTags, Note, Rules, further_groups, stated_name, writable};
use crate::pslg::{Pslg, Tag};
use crate::rows::{Rows, one_based};

/// A polyline is broken after this many vertices: some readers have short lines.
const LONGEST: usize = 100;

/// Writes an outline as polylines, in the order of its segments; z is 0.
///
/// It reads back with the same points, bit for bit, the same segments and tags, and the names of
/// boundaries. A group is written as `g wall`; where reading would give it another number, as
/// `g wall boundary_7`, or `g boundary_7` without a name. Points without a segment are `p`.
/// What the format has no place for is told in notes: hole and region seeds, markers, attributes
/// and target sizes of points, names of regions and points.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Pslg, obj};
/// let outline = Pslg {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     segments: vec![[0, 1], [1, 2], [2, 0]],
///     segment_tags: vec![7, 7, 0],
///     ..Pslg::default()
/// };
/// let mut text = Vec::new();
/// obj::write_outline(&outline, &mut text)?;
/// assert_eq!(text, b"v 0 0 0\nv 1 0 0\nv 0 0.5 0\ng boundary_7\nl 1 2 3\ng\nl 3 1\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write_outline(outline: &Pslg, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let mut notes = not_held(outline);
    let names = group_names(outline, &mut notes);
    let mut rows = Rows::new(out);
    vertices(&outline.points, &mut rows)?;
    let mut last = 0;
    for line in polylines(outline) {
        if line.tag != last {
            last = line.tag;
            match names.get(&last) {
                Some(name) => rows.text(&format!("g {name}\n"))?,
                None => rows.text("g\n")?,
            }
        }
        rows.text("l ")?;
        rows.integer(one_based(line.segments[0][0]));
        line.segments.iter().for_each(|&[_, end]| rows.integer(one_based(end)));
        rows.end()?;
    }
    for point in without_segment(outline) {
        rows.text("p ")?;
        rows.integers(&[one_based(point)])?;
    }
    rows.finish()?;
    Ok(notes)
}

/// Writes points as vertices; z is 0.
pub(super) fn vertices(points: &[[f64; 2]], rows: &mut Rows<impl Write>) -> io::Result<()> {
    for &[x, y] in points {
        rows.text("v ")?;
        rows.real(x);
        rows.real(y);
        rows.integer(0);
        rows.end()?;
    }
    Ok(())
}

fn tag(outline: &Pslg, segment: usize) -> Tag {
    outline.segment_tags.get(segment).copied().unwrap_or(0)
}

/// Segments of one tag, each of which begins where the one before ends.
struct Polyline<'a> {
    segments: &'a [[u32; 2]],
    tag: Tag,
}

fn polylines(outline: &Pslg) -> impl Iterator<Item = Polyline<'_>> {
    let segments = &outline.segments;
    let mut start = 0;
    std::iter::from_fn(move || {
        let tag = tag(outline, start);
        let [_, mut last] = *segments.get(start)?;
        let mut end = start + 1;
        while let Some(&[from, to]) = segments.get(end)
            && from == last
            && self::tag(outline, end) == tag
            && end - start < LONGEST
        {
            last = to;
            end += 1;
        }
        let segments = &segments[start..end];
        start = end;
        Some(Polyline { segments, tag })
    })
}

fn without_segment(outline: &Pslg) -> impl Iterator<Item = u32> {
    let mut is_end = vec![false; outline.points.len()];
    for &end in outline.segments.iter().flatten() {
        is_end[end as usize] = true;
    }
    (0..).zip(is_end).filter(|(_, is_end)| !is_end).map(|(point, _)| point)
}

/// What follows `g` for each tag but 0.
fn group_names(outline: &Pslg, notes: &mut Vec<Note>) -> BTreeMap<Tag, String> {
    let mut given: BTreeMap<Tag, String> = BTreeMap::new();
    for group in outline.groups.iter().filter(|group| group.dim == 1 && group.tag != 0) {
        let written = writable(&group.name, Rules::default()).trim().to_owned();
        if let Some(kept) = given.get(&group.tag) {
            let (kept, dropped) = (kept.clone(), group.name.clone());
            notes.push(Note::SecondName { kept, dropped });
            continue;
        }
        if written != group.name {
            notes.push(Note::NameChanged { name: group.name.clone(), written: written.clone() });
        }
        if !written.is_empty() {
            given.insert(group.tag, written);
        }
    }
    let tags = in_order_of_use(outline);
    let are_plain = are_plain(&tags, &given);
    tags.into_iter()
        .map(|tag| {
            let stated = stated_name(1, tag);
            let name = match given.get(&tag) {
                Some(name) if are_plain => name.clone(),
                Some(name) => format!("{name} {stated}"),
                None => stated,
            };
            (tag, name)
        })
        .collect()
}

fn in_order_of_use(outline: &Pslg) -> Vec<Tag> {
    let mut seen = BTreeSet::from([0]);
    let tags = (0..outline.segments.len()).map(|segment| tag(outline, segment));
    tags.filter(|&tag| seen.insert(tag)).collect()
}

/// Whether names alone read back with their tags.
fn are_plain(tags: &[Tag], given: &BTreeMap<Tag, String>) -> bool {
    let nameless = tags.iter().filter(|tag| !given.contains_key(tag)).copied().collect();
    let mut fresh = FreshTags::beside(nameless);
    let mut seen = BTreeSet::new();
    // A `\` at the end of a line would join the next one to it.
    let reads_back = |name: &str| stated(name).1.is_none() && !name.ends_with('\\');
    tags.iter()
        .filter_map(|tag| given.get_key_value(tag))
        .all(|(&tag, name)| fresh.take() == tag && reads_back(name) && seen.insert(name))
}

/// What an `.obj` file has no place for.
fn not_held(outline: &Pslg) -> Vec<Note> {
    let is_marked = |tags: &[Tag]| tags.iter().filter(|&&tag| tag != 0).count();
    let names = |dim: u8| outline.groups.iter().filter(|group| group.dim == dim).count();
    let untagged = |group: &&crate::Group| group.dim == 1 && group.tag == 0;
    let counted = [
        (outline.holes.len(), "hole seed"),
        (outline.regions.len(), "region seed"),
        (outline.local_areas.len(), "local area bound"),
        (names(2), "region name"),
        (is_marked(&outline.point_markers), "point marker"),
        (outline.point_attributes.len(), "point attribute"),
        (names(0), "point name"),
        (outline.groups.iter().filter(untagged).count(), "name without a tag"),
    ];
    let counted = counted.into_iter().filter(|&(count, _)| count > 0);
    let mut notes: Vec<Note> = counted.map(|(count, noun)| Note::NotHeld { count, noun }).collect();
    if !outline.point_sizes.is_empty() {
        notes.push(Note::SizesDropped);
    }
    notes.extend(further_groups(outline));
    notes
}
