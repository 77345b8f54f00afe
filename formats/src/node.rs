//! Points in the files of Triangle: `.node`, and the first section of `.poly`.
//!
//! ```text
//! points := header point*
//! header := <number of points> [<dimension: 2> [<number of attributes> [<0 or 1: markers>]]]
//! point  := <number> <x> <y> <attribute>* [<marker>]
//! ```
//!
//! One line each; `#` starts a comment; blank lines are skipped. The points are numbered one after
//! the other from 0 or 1 (<https://www.cs.cmu.edu/~quake/triangle.node.html>); from 1 in the files
//! that are written here.

use std::io::{self, Write};

use crate::attributes;
use crate::error::{Notice, SyntaxError, Warning};
use crate::groups::Note;
use crate::mesh::Mesh;
use crate::pslg::{Attribute, Group, Pslg, Source, Tag};
use crate::rows::Rows;
use crate::text::{Scanner, parse_integer};

/// Reads the text of a `.node` file: an outline without segments.
///
/// `file` is the name that messages use.
///
/// # Errors
/// The first word that cannot be read.
///
/// ```
/// use meshwright_formats::node;
/// let (outline, warnings) = node::read(b"2 2 0 1\n1 0 0 7\n2 1 0 8\n", "two.node")?;
/// assert_eq!(outline.points, [[0.0, 0.0], [1.0, 0.0]]);
/// assert_eq!(outline.point_markers, [7, 8]);
/// assert!(warnings.is_empty());
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(text: &[u8], file: &str) -> Result<(Pslg, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::new(text, file, Some(b'#'));
    let mut warnings = Vec::new();
    let mut pslg = Pslg::default();
    let header = header(&mut scanner, &mut warnings)?;
    points(&mut scanner, &header, &mut pslg, &mut warnings)?;
    pslg.source.file = file.to_owned();
    trailing_text(&mut scanner, &mut warnings);
    Ok((pslg, warnings))
}

/// Writes the points of a mesh with their markers, and their data as attributes.
///
/// Coordinates read back bit for bit. Attributes are the arrays of [`Mesh::point_data`] with one
/// real number for each point; they have no names in the file, which notes say. How a point came
/// to be is not written.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, node};
/// let points = vec![[0.0, 0.0], [0.1, 0.0]];
/// let mesh = Mesh { points, point_markers: vec![7, -8], ..Mesh::default() };
/// let mut text = Vec::new();
/// node::write(&mesh, &mut text)?;
/// assert_eq!(text, b"2 2 0 1\n1 0 0 7\n2 0.1 0 -8\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let mut notes = Vec::new();
    let mut rows = Rows::new(out);
    Columns::of_mesh(mesh, &mut notes).write(&mut rows)?;
    rows.finish()?;
    Ok(notes)
}

/// What a list of points holds.
pub(crate) struct Columns<'a> {
    points: &'a [[f64; 2]],
    attributes: Vec<&'a [f64]>,
    /// One per point, or empty.
    markers: &'a [Tag],
}

impl<'a> Columns<'a> {
    pub fn of_mesh(mesh: &'a Mesh, notes: &mut Vec<Note>) -> Self {
        point_groups(&mesh.groups, notes);
        let attributes = attributes::columns(&mesh.point_data, 0, notes);
        Self { points: &mesh.points, attributes, markers: &mesh.point_markers }
    }

    pub fn of_outline(pslg: &'a Pslg, notes: &mut Vec<Note>) -> Self {
        point_groups(&pslg.groups, notes);
        for (index, Attribute { name, .. }) in (1..).zip(&pslg.point_attributes) {
            if *name != attributes::name(index) {
                notes.push(Note::Column { name: name.clone(), attribute: index });
            }
        }
        let attributes = pslg.point_attributes.iter().map(|a| a.values.as_slice()).collect();
        Self { points: &pslg.points, attributes, markers: &pslg.point_markers }
    }

    pub fn write(&self, rows: &mut Rows<impl Write>) -> io::Result<()> {
        self.header(self.points.len(), rows)?;
        for (index, &[x, y]) in self.points.iter().enumerate() {
            rows.integer(index as i64 + 1);
            rows.real(x);
            rows.real(y);
            for attribute in &self.attributes {
                rows.real(attribute.get(index).copied().unwrap_or(0.0));
            }
            if !self.markers.is_empty() {
                rows.integer(self.markers.get(index).copied().unwrap_or(0));
            }
            rows.end()?;
        }
        Ok(())
    }

    /// The header alone, with another number of points.
    pub fn header(&self, count: usize, rows: &mut Rows<impl Write>) -> io::Result<()> {
        let markers = i64::from(!self.markers.is_empty());
        rows.integers(&[count as i64, 2, self.attributes.len() as i64, markers])
    }
}

fn point_groups(groups: &[Group], notes: &mut Vec<Note>) {
    let groups = groups.iter().filter(|group| group.dim == 0);
    notes.extend(groups.map(|group| Note::PointGroup { name: group.name.clone() }));
}

/// The header of a list of points.
pub(crate) struct Header {
    pub count: i64,
    pub line: u32,
    attributes: usize,
    markers: bool,
}

/// Most items that a list may announce: their indices are `u32`, and its largest means "none".
pub(crate) const MOST: i64 = u32::MAX as i64 - 1;
/// More attributes than any file has; the bound keeps a wrong number from filling the memory.
const MOST_ATTRIBUTES: i64 = 1000;

pub(crate) fn header(
    scanner: &mut Scanner,
    warnings: &mut Vec<Warning>,
) -> Result<Header, SyntaxError> {
    scanner.next_line();
    let line = scanner.line();
    let count = scanner.integer("the number of points", 0, MOST)?;
    if let Some(word) = scanner.word() {
        scanner.integer_in(word, "the dimension 2", 2, 2).map_err(|mut error| {
            error
                .help
                .get_or_insert("points here have two coordinates; is this another file?".into());
            error
        })?;
    }
    let attributes = optional(scanner, "the number of attributes", 0, MOST_ATTRIBUTES)?;
    let markers = optional(scanner, "the number of boundary markers (0 or 1)", 0, 1)?;
    let mut extra = Lines::default();
    extra.ignore_rest(scanner);
    extra.warn(scanner, warnings, |lines| Notice::ExtraColumns { lines, header: line });
    Ok(Header { count, line, attributes: attributes as usize, markers: markers == 1 })
}

pub(crate) fn points(
    scanner: &mut Scanner,
    header: &Header,
    pslg: &mut Pslg,
    warnings: &mut Vec<Warning>,
) -> Result<(), SyntaxError> {
    // The shortest point, `1 0 0` and a line end, has six bytes.
    let room = reserved(header.count, scanner.left(), 6);
    pslg.points.reserve(room);
    pslg.source.point_lines.reserve(room);
    pslg.point_attributes = (1..=header.attributes)
        .map(|i| Attribute { name: attributes::name(i), values: Vec::new() })
        .collect();
    let (mut extra, mut unmarked) = (Lines::default(), Lines::default());
    for index in 0..header.count {
        point(scanner, header, index, pslg, &mut unmarked)?;
        extra.ignore_rest(scanner);
    }
    extra.warn(scanner, warnings, |lines| Notice::ExtraColumns { lines, header: header.line });
    unmarked.warn(scanner, warnings, |lines| Notice::MissingMarkers { lines, header: header.line });
    Ok(())
}

fn point(
    scanner: &mut Scanner,
    header: &Header,
    index: i64,
    pslg: &mut Pslg,
    unmarked: &mut Lines,
) -> Result<(), SyntaxError> {
    if !scanner.next_line() {
        let expected = format!("point {} of {}", index + 1, header.count);
        return Err(scanner.missing(expected));
    }
    point_number(scanner, header, index, &mut pslg.source)?;
    let x = scanner.real("an x coordinate")?;
    let y = scanner.real("a y coordinate")?;
    for attribute in &mut pslg.point_attributes {
        attribute.values.push(scanner.real("an attribute")?);
    }
    if header.markers {
        pslg.point_markers.push(marker(scanner, unmarked)?);
    }
    pslg.points.push([x, y]);
    pslg.source.point_lines.push(scanner.line());
    Ok(())
}

/// The first number is the base; the others count up from it.
fn point_number(
    scanner: &mut Scanner,
    header: &Header,
    index: i64,
    source: &mut Source,
) -> Result<(), SyntaxError> {
    if index == 0 {
        let what = "the number of the first point (0 or 1)";
        source.first_number = scanner.integer(what, 0, 1)? as u32;
        return Ok(());
    }
    let first = source.first_number;
    let number = i64::from(first) + index;
    if scanner.plain_integer(|found| found == number).is_some() {
        return Ok(());
    }
    let Some(word) = scanner.word() else { return Err(scanner.missing("a point")) };
    if parse_integer(word.bytes) == Some(number) {
        return Ok(());
    }
    let mut error = scanner.unexpected(word, format!("point number {number}"));
    let Header { count, line, .. } = header;
    let help = format!("line {line} announces {count} points; they count up from {first}");
    error.help.get_or_insert(help.into());
    Err(error)
}

/// The boundary marker that the header announces; 0 where the line ends without one.
pub(crate) fn marker(scanner: &mut Scanner, missing: &mut Lines) -> Result<Tag, SyntaxError> {
    let Some(word) = scanner.word() else {
        missing.note(scanner.line());
        return Ok(0);
    };
    let what = "a boundary marker (a whole number of 32 bits)";
    let (least, most) = (i64::from(Tag::MIN), i64::from(Tag::MAX));
    Ok(scanner.integer_in(word, what, least, most)? as Tag)
}

/// A number that a header may leave out; 0 then.
pub(crate) fn optional(
    scanner: &mut Scanner,
    what: &'static str,
    least: i64,
    most: i64,
) -> Result<i64, SyntaxError> {
    match scanner.word() {
        Some(word) => scanner.integer_in(word, what, least, most),
        None => Ok(0),
    }
}

/// How many items to make room for: no more than the text that is left can hold.
pub(crate) fn reserved(count: i64, left: usize, shortest: usize) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX).min(left / shortest + 1)
}

/// Says how many lines stand after the last section.
pub(crate) fn trailing_text(scanner: &mut Scanner, warnings: &mut Vec<Warning>) {
    let mut lines = Lines::default();
    while scanner.next_line() {
        lines.note(scanner.line());
        scanner.leave_line();
    }
    lines.warn(scanner, warnings, |lines| Notice::TrailingText { lines });
}

/// Lines that share one warning.
#[derive(Default)]
pub(crate) struct Lines {
    first: u32,
    count: u32,
}

impl Lines {
    pub fn note(&mut self, line: u32) {
        if self.count == 0 {
            self.first = line;
        }
        self.count += 1;
    }

    /// Notes the line if it holds more words.
    pub fn ignore_rest(&mut self, scanner: &mut Scanner) {
        if scanner.word().is_some() {
            self.note(scanner.line());
        }
        scanner.leave_line();
    }

    pub fn warn(
        self,
        scanner: &Scanner,
        warnings: &mut Vec<Warning>,
        notice: impl FnOnce(u32) -> Notice,
    ) {
        if self.count > 0 {
            let file = scanner.file().to_owned();
            warnings.push(Warning { file, line: self.first, notice: notice(self.count) });
        }
    }
}
