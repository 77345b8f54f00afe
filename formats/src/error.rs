//! What is wrong with a text file, and where.

use std::borrow::Cow;
use std::fmt::{self, Display, Formatter};

/// A place in a text file that could not be read.
///
/// Its `Display` is the whole message:
///
/// ```
/// use meshwright_formats::node;
/// let error = node::read(b"1 2 0 0\n1 1.0 0,0\n", "lake.node").unwrap_err();
/// assert_eq!(error.to_string(), "\
/// lake.node:2:7: expected a y coordinate, found `0,0`
///   |
/// 2 | 1 1.0 0,0
///   |       ^
/// help: coordinates are separated by spaces");
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub struct SyntaxError {
    /// The file, as the user named it.
    pub file: Box<str>,
    /// The line, counted from one.
    pub line: u32,
    /// The column, counted in characters from one.
    pub column: u32,
    /// What should have stood there.
    pub expected: Cow<'static, str>,
    /// What stands there.
    pub found: Found,
    /// What to do about it, where that is known.
    pub help: Option<Cow<'static, str>>,
    /// The whole line, with what is not UTF-8 replaced by `\u{fffd}`.
    pub text: Box<str>,
    /// The byte, counted from zero: the place where a file is no text.
    pub offset: usize,
}

/// What stands where something else was expected.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Found {
    /// A whole word, from white space to white space.
    Word(String),
    /// Nothing more in this line.
    EndOfLine,
    /// Nothing more in this file.
    EndOfFile,
    /// A vertex that does not lie in the plane of the others.
    OffPlane {
        /// Its number in the file.
        vertex: i64,
        /// How far it is from there.
        distance: f64,
    },
}

/// Longest word and excerpt that a message shows, in characters.
const LONGEST_WORD: usize = 40;
const LONGEST_EXCERPT: usize = 100;

impl Display for Found {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::EndOfLine => f.write_str("the end of the line"),
            Self::EndOfFile => f.write_str("the end of the file"),
            Self::OffPlane { vertex, distance } => {
                write!(f, "vertex {vertex}, which is {distance:.3e} off the plane of the others")
            }
            Self::Word(word) => {
                let mut shown: String = word.chars().take(LONGEST_WORD).map(printable).collect();
                if word.chars().nth(LONGEST_WORD).is_some() {
                    shown.push('…');
                }
                write!(f, "`{shown}`")
            }
        }
    }
}

impl Display for SyntaxError {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Self { file, line, column, expected, found, .. } = self;
        writeln!(f, "{file}:{line}:{column}: expected {expected}, found {found}")?;
        write!(f, "{}", Excerpt { line: *line, column: *column, text: &self.text })?;
        match &self.help {
            Some(help) => write!(f, "\nhelp: {help}"),
            None => Ok(()),
        }
    }
}

/// A line of a file with a caret below the column that a message is about.
pub(crate) struct Excerpt<'a> {
    /// Counted from one.
    pub line: u32,
    /// Counted in characters from one.
    pub column: u32,
    /// The whole line.
    pub text: &'a str,
}

impl Display for Excerpt<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        let (excerpt, caret) = self.shown();
        writeln!(f, "{margin} |")?;
        writeln!(f, "{number} | {excerpt}")?;
        write!(f, "{margin} | {caret}")
    }
}

impl Excerpt<'_> {
    /// The part of the line around the column, and a second line whose caret stands below it.
    fn shown(&self) -> (String, String) {
        let place = self.column as usize - 1;
        let first = place.saturating_sub(LONGEST_EXCERPT * 3 / 4);
        let shown = self.text.chars().skip(first).take(LONGEST_EXCERPT);
        let before = self.text.chars().chain(std::iter::repeat(' ')).skip(first);
        let mut caret: String =
            before.take(place - first).map(|c| if c == '\t' { c } else { ' ' }).collect();
        caret.push('^');
        (shown.map(|c| if c == '\t' { c } else { printable(c) }).collect(), caret)
    }
}

/// The character itself, or a stand-in that a terminal cannot take for a command.
fn printable(c: char) -> char {
    if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }
}

/// Something in a file that was read otherwise than it stands there, or not at all.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{file}{}: {notice}", if *line == 0 { String::new() } else { format!(":{line}") })]
pub struct Warning {
    /// The file, as the user named it.
    pub file: String,
    /// The line (the first, of several), counted from one; 0 where it is about the whole file, or
    /// the file is no text.
    pub line: u32,
    /// What was done.
    pub notice: Notice,
}

/// What a reader did with something that it could not take as it stands.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Notice {
    /// Lines hold more columns than the header announces.
    #[error("{lines} {} more columns than the header (line {header}) announces; \
             they are ignored", if *lines == 1 { "line has" } else { "lines have" })]
    ExtraColumns {
        /// How many lines.
        lines: u32,
        /// The line of the header.
        header: u32,
    },
    /// The header announces markers; some lines have none.
    #[error("{lines} {} no boundary marker, which the header (line {header}) announces; \
             taken as 0", if *lines == 1 { "line has" } else { "lines have" })]
    MissingMarkers {
        /// How many lines.
        lines: u32,
        /// The line of the header.
        header: u32,
    },
    /// Text after the last section.
    #[error("the file goes on after its last section; {lines} {} ignored",
            if *lines == 1 { "line is" } else { "lines are" })]
    TrailingText {
        /// How many lines that hold more than a comment.
        lines: u32,
    },
    /// A `.poly` file beside a `.ele` file that belongs to another mesh, or is its outline.
    #[error(
        "these are not the points of `{node}`: the file is passed over, and the mesh has no \
             edges"
    )]
    OtherPoints {
        /// The file that holds the mesh's points.
        node: String,
    },
    /// A regional attribute that is no whole number cannot be a tag.
    #[error(
        "the regional attribute {attribute} of region {region} is no whole number: \
             its triangles get the tag {tag}"
    )]
    RegionTag {
        /// The region, as the file numbers it.
        region: i64,
        /// The attribute.
        attribute: f64,
        /// The tag it got instead.
        tag: i32,
    },
    /// Regions with one value after their seed, which Triangle takes as an attribute or as an area,
    /// as its switches say.
    #[error("{regions} {} only one value after the seed; taken as {}",
            if *regions == 1 { "region has" } else { "regions have" },
            if *areas { "the largest area, for not all are whole numbers" }
            else { "the attribute, not as the largest area" })]
    LoneRegionValues {
        /// How many regions.
        regions: u32,
        /// Whether the values were taken as areas.
        areas: bool,
    },
    /// A section that holds nothing for a mesh of triangles.
    #[error("section `${name}` is ignored")]
    SkippedSection {
        /// The section's name, without its `$`.
        name: String,
    },
    /// Cells with nodes between their corners.
    #[error(
        "{cells} of second or higher order {} read by {} corners; {nodes} between them {} left out",
        if *.cells == 1 { "is" } else { "are" },
        if *.cells == 1 { "its" } else { "their" },
        if *.nodes == 1 { "is" } else { "are" },
        cells = counted(*.cells, "cell"),
        nodes = counted(*.nodes, "node")
    )]
    HigherOrder {
        /// How many cells.
        cells: usize,
        /// How many nodes that are no corner of any cell.
        nodes: usize,
    },
    /// Data of what is no triangle.
    #[error("data `{name}`: {} of what is no triangle {} left out",
            counted(*.count, "value"), if *.count == 1 { "is" } else { "are" })]
    DataLeftOut {
        /// The name of the data.
        name: String,
        /// How many values, or tuples of values.
        count: usize,
    },
    /// Data with the name of others: a further time step.
    #[error("data `{name}` are there more than once; the first are kept")]
    RepeatedData {
        /// The name of the data.
        name: String,
    },
    /// Triangles in more than one set.
    #[error("{} in more than one set of elements: {}", if *triangles == 1 { "1 triangle is".to_owned() }
            else { format!("{triangles} triangles are") },
            if *triangles == 1 { "it keeps the first" } else { "they keep the first" })]
    FurtherSets {
        /// How many triangles.
        triangles: usize,
    },
    /// Statements of a script that have no effect on a plane mesh.
    #[error("{} without effect on this mesh: {}",
            if statements.iter().map(|(_, count)| count).sum::<u32>() == 1 { "1 statement".to_owned() }
            else { format!("{} statements", statements.iter().map(|(_, count)| count).sum::<u32>()) },
            named(statements))]
    SkippedStatements {
        /// Their names, and how many of each there are.
        statements: Vec<(String, u32)>,
    },
    /// The geometry lies in a plane along two axes that is not z = 0.
    #[error("all points have {normal} = {at}: {first} and {second} are taken as x and y")]
    AxisPlane {
        /// The axis that is dropped.
        normal: char,
        /// The coordinate that all points have there.
        at: f64,
        /// The axis that becomes x.
        first: char,
        /// The axis that becomes y.
        second: char,
    },
    /// A group names what does not exist.
    #[error("physical group {tag}: there is no {} {first}{}",
            ["point", "curve", "surface"].get(*dim as usize).unwrap_or(&"entity"),
            if *count == 1 { String::new() } else { format!(", and {} more are missing", count - 1) })]
    MissingMembers {
        /// 0 for points, 1 for curves, 2 for surfaces.
        dim: u8,
        /// The group.
        tag: i32,
        /// The first entity that is missing.
        first: i32,
        /// How many are missing.
        count: usize,
    },
    /// A surface in more than one group.
    #[error("surface {surface} is in the physical groups {kept} and {dropped}: it keeps {kept}")]
    SecondGroup {
        /// The surface.
        surface: i32,
        /// The group that it keeps.
        kept: i32,
        /// The first of the others.
        dropped: i32,
    },
    /// Two surfaces between the same curves.
    #[error("surface {surface} is surface {first} once more; it is left out")]
    SameSurface {
        /// The surface.
        surface: i32,
        /// The one that stays.
        first: i32,
    },
    /// All points lie in one plane that is not z = 0.
    #[error("all nodes have z = {z}; it is dropped")]
    Plane {
        /// The z coordinate of all points.
        z: f64,
    },
    /// All vertices of an outline in space have nearly the same coordinate along an axis.
    #[error("all vertices have {axis} = {}; it is dropped", from_to(*.least, *.most))]
    FlatAxis {
        /// The axis: `x`, `y` or `z`.
        axis: char,
        /// The least coordinate along it.
        least: f64,
        /// The greatest.
        most: f64,
    },
    /// The vertices of an outline in space lie in a plane that is tilted to all axes.
    #[error(
        "all vertices lie in one plane, tilted to all axes (its normal is {:.6} {:.6} {:.6}); the \
         outline is drawn in that plane",
        .normal[0], .normal[1], .normal[2]
    )]
    Projected {
        /// The direction across the plane, of length 1.
        normal: [f64; 3],
    },
    /// Vertices that belong to no polyline.
    #[error("{vertices} {} by no polyline and left out",
            if *vertices == 1 { "vertex is used" } else { "vertices are used" })]
    UnusedVertices {
        /// How many.
        vertices: u32,
    },
    /// Faces, where only polylines are read.
    #[error("{faces} {} passed over; --faces takes their outlines",
            if *faces == 1 { "face is" } else { "faces are" })]
    SkippedFaces {
        /// How many.
        faces: u32,
    },
    /// Statements of free-form curves and surfaces, which are not read.
    #[error("{statements} {} of free-form curves or surfaces passed over",
            if *statements == 1 { "statement" } else { "statements" })]
    SkippedCurves {
        /// How many.
        statements: u32,
    },
}

/// `Mesh, Color (3)`; the first of many.
fn named(statements: &[(String, u32)]) -> String {
    const MOST: usize = 20;
    let shown = statements.iter().take(MOST).map(|(name, count)| {
        let name: String = name.chars().take(LONGEST_WORD).map(printable).collect();
        if *count == 1 { name } else { format!("{name} ({count})") }
    });
    let shown = shown.collect::<Vec<_>>().join(", ");
    if statements.len() > MOST { shown + ", …" } else { shown }
}

/// `1 node`, `2 nodes`.
fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// `0.4`, or `-0.000001 to 0.000002`.
fn from_to(least: f64, most: f64) -> String {
    if least == most { least.to_string() } else { format!("{least} to {most}") }
}
