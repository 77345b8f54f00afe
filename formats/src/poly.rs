//! Outlines in Triangle's `.poly` files.
//!
//! ```text
//! poly     := points segments [holes [regions]]
//! points   := see `node`; 0 points: they stand in the `.node` file of the same name
//! segments := <number of segments> [<0 or 1: markers>] segment*
//! segment  := <number> <end point> <end point> [<marker>]
//! holes    := <number of holes> hole*
//! hole     := <number> <x> <y>
//! regions  := <number of regions> region*
//! region   := <number> <x> <y> <attribute> [<largest area>]
//! ```
//!
//! One line each; `#` starts a comment; blank lines are skipped. The numbers of segments, holes
//! and regions are free (<https://www.cs.cmu.edu/~quake/triangle.poly.html>). TetGen's `.poly`
//! files, which have three coordinates, are refused.

mod write;

use std::collections::{BTreeMap, BTreeSet};
use std::io;

use crate::error::{Notice, SyntaxError, Warning};
use crate::groups::FreshTags;
use crate::node::{self, Lines, MOST, marker, optional, reserved, trailing_text};
use crate::pslg::{Pslg, Region, Tag};
use crate::text::Scanner;

pub use write::{Options, write, write_outline, write_with};

/// Reads the text of a `.poly` file.
///
/// `file` is the name that messages use. Where the file holds no points, `companion` is asked for
/// the text of the `.node` file beside it, by name: `dir/lake.node` for `dir/lake.poly` and for
/// `dir/lake.poly.gz`.
///
/// # Errors
/// The first word that cannot be read, in either file; a companion that cannot be had.
///
/// ```
/// use std::fs;
/// use meshwright_formats::poly;
/// let text = b"3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 1\n1 1 2 7\n2 2 3 7\n3 3 1 8\n0\n";
/// let (outline, warnings) = poly::read(text, "corner.poly", |node| fs::read(node))?;
/// assert_eq!(outline.segments, [[0, 1], [1, 2], [2, 0]]);
/// assert_eq!(outline.segment_tags, [7, 7, 8]);
/// assert!(warnings.is_empty());
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(
    text: &[u8],
    file: &str,
    companion: impl FnOnce(&str) -> io::Result<Vec<u8>>,
) -> Result<(Pslg, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::new(text, file, Some(b'#'));
    let mut warnings = Vec::new();
    let mut pslg = points(&mut scanner, companion, &mut warnings)?;
    segments(&mut scanner, &mut pslg, &mut warnings)?;
    holes(&mut scanner, &mut pslg, &mut warnings)?;
    regions(&mut scanner, &mut pslg, &mut warnings)?;
    trailing_text(&mut scanner, &mut warnings);
    Ok((pslg, warnings))
}

/// The points, from this file or from the `.node` file beside it.
fn points(
    scanner: &mut Scanner,
    companion: impl FnOnce(&str) -> io::Result<Vec<u8>>,
    warnings: &mut Vec<Warning>,
) -> Result<Pslg, SyntaxError> {
    let header = node::header(scanner, warnings)?;
    let mut pslg = Pslg::default();
    if header.count > 0 {
        node::points(scanner, &header, &mut pslg, warnings)?;
    } else {
        let name = beside(scanner.file(), ".poly", ".node");
        let text = companion(&name).map_err(|error| {
            let found = scanner.first_word_of_line();
            let mut syntax = scanner.unexpected(found, format!("points, here or in `{name}`"));
            syntax.help = Some(format!("{name}: {error}").into());
            syntax
        })?;
        let (read, more) = node::read(&text, &name)?;
        pslg = read;
        pslg.source.point_file = Some(name);
        warnings.extend(more);
    }
    pslg.source.file = scanner.file().to_owned();
    Ok(pslg)
}

/// The file beside a file that ends in `end`: the same name with another end.
pub(crate) fn beside(file: &str, end: &str, other: &str) -> String {
    let file = file.strip_suffix(".gz").unwrap_or(file);
    format!("{}{other}", file.strip_suffix(end).unwrap_or(file))
}

fn segments(
    scanner: &mut Scanner,
    pslg: &mut Pslg,
    warnings: &mut Vec<Warning>,
) -> Result<(), SyntaxError> {
    if !scanner.next_line() {
        return Err(scanner.missing("the number of segments"));
    }
    let header = scanner.line();
    let count = scanner.integer("the number of segments", 0, MOST)?;
    let markers = optional(scanner, "the number of boundary markers (0 or 1)", 0, 1)? == 1;
    let (mut extra, mut unmarked) = (Lines::default(), Lines::default());
    extra.ignore_rest(scanner);
    // The shortest segment, `1 1 2` and a line end, has six bytes.
    let room = reserved(count, scanner.left(), 6);
    pslg.segments.reserve(room);
    pslg.segment_tags.reserve(room);
    pslg.source.segment_lines.reserve(room);
    let mut numbers = Vec::new();
    for index in 0..count {
        if !scanner.next_line() {
            return Err(scanner.missing(format!("segment {} of {count}", index + 1)));
        }
        numbers.push(number(scanner, "the number of a segment")?);
        let ends = [point(scanner, pslg)?, point(scanner, pslg)?];
        pslg.segments.push(ends);
        pslg.segment_tags.push(if markers { marker(scanner, &mut unmarked)? } else { 0 });
        pslg.source.segment_lines.push(scanner.line());
        extra.ignore_rest(scanner);
    }
    if !counts_up(&numbers, pslg.source.first_number) {
        pslg.source.segment_numbers = numbers;
    }
    extra.warn(scanner, warnings, |lines| Notice::ExtraColumns { lines, header });
    unmarked.warn(scanner, warnings, |lines| Notice::MissingMarkers { lines, header });
    Ok(())
}

/// The (zero-based) index of the point whose number is the next word.
pub(crate) fn point(scanner: &mut Scanner, pslg: &Pslg) -> Result<u32, SyntaxError> {
    let first = i64::from(pslg.source.first_number);
    let last = first + pslg.points.len() as i64 - 1;
    let number = scanner.integer("", first, last).map_err(|mut error| {
        error.expected = format!("the number of a point ({first} to {last})").into();
        error
    })?;
    Ok((number - first) as u32)
}

fn counts_up(numbers: &[i64], first: u32) -> bool {
    numbers.iter().zip(i64::from(first)..).all(|(&number, counted)| number == counted)
}

fn holes(
    scanner: &mut Scanner,
    pslg: &mut Pslg,
    warnings: &mut Vec<Warning>,
) -> Result<(), SyntaxError> {
    // Files that end after the segments are common; Triangle itself wants a number of holes.
    let Some((count, header, mut extra)) = section(scanner, "the number of holes")? else {
        return Ok(());
    };
    for index in 0..count {
        if !scanner.next_line() {
            return Err(scanner.missing(format!("hole {} of {count}", index + 1)));
        }
        number(scanner, "the number of a hole")?;
        let seed = [scanner.real("an x coordinate")?, scanner.real("a y coordinate")?];
        pslg.holes.push(seed);
        pslg.source.hole_lines.push(scanner.line());
        extra.ignore_rest(scanner);
    }
    extra.warn(scanner, warnings, |lines| Notice::ExtraColumns { lines, header });
    Ok(())
}

fn regions(
    scanner: &mut Scanner,
    pslg: &mut Pslg,
    warnings: &mut Vec<Warning>,
) -> Result<(), SyntaxError> {
    let Some((count, header, mut extra)) = section(scanner, "the number of regions")? else {
        return Ok(());
    };
    let mut numbers = Vec::new();
    let mut lone = Vec::new();
    for index in 0..count {
        if !scanner.next_line() {
            return Err(scanner.missing(format!("region {} of {count}", index + 1)));
        }
        numbers.push(number(scanner, "the number of a region")?);
        let (region, has_area) = region(scanner)?;
        if !has_area {
            lone.push(pslg.regions.len());
        }
        pslg.regions.push(region);
        pslg.source.region_lines.push(scanner.line());
        extra.ignore_rest(scanner);
    }
    extra.warn(scanner, warnings, |lines| Notice::ExtraColumns { lines, header });
    lone_values(pslg, &lone, warnings);
    region_tags(pslg, &numbers, warnings);
    Ok(())
}

/// One region, its tag still 0, and whether an area follows its attribute.
fn region(scanner: &mut Scanner) -> Result<(Region, bool), SyntaxError> {
    let seed = [scanner.real("an x coordinate")?, scanner.real("a y coordinate")?];
    let attribute = scanner.real("a regional attribute")?;
    let area = match scanner.word() {
        Some(word) => Some(scanner.real_in(word, "a largest area")?),
        None => None,
    };
    Ok((Region { seed, tag: 0, attribute, max_area: bound(area) }, area.is_some()))
}

/// "A negative maximum area" leaves a region without a bound; Triangle ignores 0 as well.
pub(crate) fn bound(area: Option<f64>) -> Option<f64> {
    area.filter(|&area| area > 0.0)
}

/// Regions with one value after their seed.
///
/// Triangle takes it as an attribute (`-A`) or as an area (`-a`), as its switches say. Here it is
/// an attribute where all of a file are whole numbers, and so can be tags; else an area.
fn lone_values(pslg: &mut Pslg, lone: &[usize], warnings: &mut Vec<Warning>) {
    let Some(&first) = lone.first() else { return };
    let areas = lone.iter().any(|&region| whole(pslg.regions[region].attribute).is_none());
    if areas {
        for &region in lone {
            let region = &mut pslg.regions[region];
            region.max_area = bound(Some(region.attribute));
            region.attribute = 0.0;
        }
    }
    let notice = Notice::LoneRegionValues { regions: lone.len() as u32, areas };
    let (file, line) = (pslg.source.file.clone(), pslg.source.region_lines[first]);
    warnings.push(Warning { file, line, notice });
}

/// The tag that a regional attribute is.
pub(crate) fn whole(attribute: f64) -> Option<Tag> {
    let tag = attribute as Tag;
    (f64::from(tag) == attribute).then_some(tag)
}

/// The tag of a region is its attribute, where that is a whole number. Others get the smallest
/// positive numbers that no region has, the same for the same attribute.
fn region_tags(pslg: &mut Pslg, numbers: &[i64], warnings: &mut Vec<Warning>) {
    let used: BTreeSet<Tag> = pslg.regions.iter().filter_map(|r| whole(r.attribute)).collect();
    let mut fresh = FreshTags::beside(used);
    let mut given = BTreeMap::new();
    let places = numbers.iter().zip(&pslg.source.region_lines);
    for (region, (&number, &line)) in pslg.regions.iter_mut().zip(places) {
        let attribute = region.attribute;
        if let Some(tag) = whole(attribute) {
            region.tag = tag;
            continue;
        }
        region.tag = *given.entry(attribute.to_bits()).or_insert_with(|| fresh.take());
        let notice = Notice::RegionTag { region: number, attribute, tag: region.tag };
        warnings.push(Warning { file: pslg.source.file.clone(), line, notice });
    }
}

/// The header of an optional section: its count, its line and whether it holds more; nothing at
/// the end of the file.
fn section(
    scanner: &mut Scanner,
    what: &'static str,
) -> Result<Option<(i64, u32, Lines)>, SyntaxError> {
    if !scanner.next_line() {
        return Ok(None);
    }
    let header = scanner.line();
    let count = scanner.integer(what, 0, MOST)?;
    let mut extra = Lines::default();
    extra.ignore_rest(scanner);
    Ok(Some((count, header, extra)))
}

/// A number that only names its line.
fn number(scanner: &mut Scanner, what: &'static str) -> Result<i64, SyntaxError> {
    scanner.integer(what, i64::MIN, i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square, and what follows its segments.
    fn read_tail(tail: &str) -> Result<(Pslg, Vec<Warning>), SyntaxError> {
        let square = "4 2\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n";
        let text = square.to_owned() + tail;
        read(text.as_bytes(), "square.poly", |_| unreachable!("the points are there"))
    }

    fn regions_of(lines: &str) -> (Vec<Region>, Vec<String>) {
        let (pslg, warnings) = read_tail(&format!("0\n{lines}")).unwrap();
        (pslg.regions, warnings.iter().map(Warning::to_string).collect())
    }

    fn region(attribute: f64, tag: Tag, max_area: Option<f64>) -> Region {
        Region { seed: [0.5, 0.5], tag, attribute, max_area }
    }

    #[test]
    fn holes_and_regions_are_read_with_their_lines() {
        let (pslg, warnings) = read_tail("1\n9 .5 .25\n\n1\n8 .5 .5 7 .1\n").unwrap();
        assert_eq!(pslg.holes, [[0.5, 0.25]]);
        assert_eq!(pslg.regions, [region(7.0, 7, Some(0.1))]);
        assert_eq!(pslg.source.hole_lines, [12]);
        assert_eq!(pslg.source.region_lines, [15]);
        assert_eq!(warnings, []);
    }

    #[test]
    fn an_area_that_is_not_positive_is_no_bound() {
        let (regions, warnings) = regions_of("2\n1 .5 .5 -7 -1\n2 .5 .5 0 0\n");
        assert_eq!(regions, [region(-7.0, -7, None), region(0.0, 0, None)]);
        assert!(warnings.is_empty());
    }

    #[test]
    fn attributes_that_are_no_whole_numbers_get_free_tags() {
        let lines = "4\n1 .5 .5 .5 -1\n2 .5 .5 1 -1\n3 .5 .5 1e10 -1\n4 .5 .5 .5 -1\n";
        let (regions, warnings) = regions_of(lines);
        let tags: Vec<Tag> = regions.iter().map(|region| region.tag).collect();
        assert_eq!(tags, [2, 1, 3, 2]);
        assert_eq!(regions[0].attribute, 0.5);
        let warning = "square.poly:13: the regional attribute 0.5 of region 1 is no whole number: \
                       its triangles get the tag 2";
        assert_eq!(warnings.len(), 3);
        assert_eq!(warnings[0], warning);
    }

    #[test]
    fn a_lone_value_is_an_attribute_if_all_are_whole() {
        let (regions, warnings) = regions_of("2\n1 .5 .5 1\n2 .5 .5 3\n");
        assert_eq!(regions, [region(1.0, 1, None), region(3.0, 3, None)]);
        let warning = "square.poly:13: 2 regions have only one value after the seed; taken as the \
                       attribute, not as the largest area";
        assert_eq!(warnings, [warning]);
    }

    #[test]
    fn a_lone_value_is_an_area_if_one_is_not_whole() {
        let (regions, warnings) = regions_of("2\n1 .5 .5 .05\n2 .5 .5 3\n");
        assert_eq!(regions, [region(0.0, 0, Some(0.05)), region(0.0, 0, Some(3.0))]);
        assert_eq!(warnings.len(), 1);
    }

    #[test]
    fn a_region_without_a_value_is_an_error() {
        let error = read_tail("0\n1\n1 .5 .5\n").unwrap_err();
        let message = "square.poly:13:8: expected a regional attribute, found the end of the line";
        assert!(error.to_string().starts_with(message), "{error}");
    }

    #[test]
    fn segments_keep_numbers_that_do_not_count_up() {
        let text = b"2 2\n0 0 0\n1 1 0\n2 1\n7 0 1 5\n7 1 0 -5\n";
        let (pslg, _) = read(text, "two.poly", |_| unreachable!("the points are there")).unwrap();
        assert_eq!(pslg.source.first_number, 0);
        assert_eq!(pslg.source.segment_number(1), 7);
        assert_eq!(pslg.source.point_number(1), 1);
        assert_eq!(pslg.segment_tags, [5, -5]);
    }

    #[test]
    fn the_companion_is_named_after_the_file() {
        for (file, node) in [
            ("dir.poly/lake.poly", "dir.poly/lake.node"),
            ("lake.1.poly", "lake.1.node"),
            ("lake.poly.gz", "lake.node"),
            ("-", "-.node"),
        ] {
            assert_eq!(beside(file, ".poly", ".node"), node);
        }
    }
}
