//! What is wrong with a script, and where.

use std::borrow::Cow;
use std::fmt::{self, Display, Formatter};

use crate::error::{Excerpt, Found};

/// What this reader takes, for the help of messages.
const SUBSET: &str = "read are points, lines, arcs, splines and plane surfaces, their \
                      transformations, extrusions within the plane, and Rectangle, Disk, Circle, \
                      Ellipse of OpenCASCADE with boolean operations on straight lines and circles";

/// A script that cannot be read: the place and the problem.
///
/// Its `Display` is the whole message:
///
/// ```
/// use meshwright_formats::geo;
/// let text = b"Point(1) = {0, 0, 0};\nLine(1) = {1, 7};\n";
/// let error = geo::read(text, "plate.geo", geo::no_includes).unwrap_err();
/// assert_eq!(error.to_string(), "\
/// plate.geo:2:1: there is no point 7
///   |
/// 2 | Line(1) = {1, 7};
///   | ^");
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub struct Error {
    /// The file, as the user named it or as the script includes it.
    pub file: Box<str>,
    /// The line, counted from one.
    pub line: u32,
    /// The column, counted in characters from one.
    pub column: u32,
    /// What is wrong.
    pub problem: Box<Problem>,
    /// The whole line, with what is not UTF-8 replaced by `\u{fffd}`.
    pub text: Box<str>,
}

impl Display for Error {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Self { file, line, column, problem, text } = self;
        writeln!(f, "{file}:{line}:{column}: {problem}")?;
        write!(f, "{}", Excerpt { line: *line, column: *column, text })?;
        match problem.help() {
            Some(help) => write!(f, "\nhelp: {help}"),
            None => Ok(()),
        }
    }
}

/// What can be wrong with a script.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The text is no statement or expression.
    #[error("expected {expected}, found {found}")]
    Syntax {
        /// What should have stood there.
        expected: Cow<'static, str>,
        /// What stands there.
        found: Found,
        /// What to do about it, where that is known.
        help: Option<Cow<'static, str>>,
    },
    /// A statement of Gmsh that this reader does not take.
    #[error("`{statement}` is not read")]
    Unsupported {
        /// The statement.
        statement: String,
    },
    /// A file that is no script of Gmsh.
    #[error("this is a geometry of {of}, no script of Gmsh")]
    Foreign {
        /// The program whose file it is.
        of: &'static str,
    },
    /// Something is used that does not exist.
    #[error("there is no {what} {name}")]
    Unknown {
        /// A variable, a point, a macro, …
        what: &'static str,
        /// Its name or number.
        name: String,
    },
    /// Something is made twice.
    #[error("{what} {tag} exists already (line {line})")]
    Twice {
        /// A point, a curve, …
        what: &'static str,
        /// Its number.
        tag: i32,
        /// Where it was made first.
        line: u32,
    },
    /// An operation without a finite result.
    #[error("{operation} gives no finite number")]
    NotFinite {
        /// The operation and its operands.
        operation: String,
    },
    /// A number that must be whole and is not, or is too large.
    #[error("{what} must be a whole number, not {value}")]
    NotWhole {
        /// What it is the number of.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// A list is shorter than an index.
    #[error("`{name}` has {length} elements: there is none at {index} (the first is at 0)")]
    Index {
        /// The list.
        name: String,
        /// The index.
        index: i64,
        /// How many elements there are.
        length: usize,
    },
    /// A text where a number should be, or the other way round.
    #[error("expected {expected}, found {found}")]
    Kind {
        /// What should be there.
        expected: Cow<'static, str>,
        /// What is there.
        found: &'static str,
    },
    /// Too few or too many numbers.
    #[error("{what} takes {expected}, not {found}")]
    Count {
        /// The statement or the function.
        what: &'static str,
        /// What it takes.
        expected: &'static str,
        /// How many there are.
        found: usize,
    },
    /// The script is too much work.
    #[error("this script is too much: {what}")]
    Limit {
        /// What is limited, and to how much.
        what: &'static str,
    },
    /// A loop that never ends.
    #[error("this loop never ends: its step is 0")]
    Endless,
    /// An included file that cannot be read.
    #[error("`{name}` cannot be read: {reason}")]
    Include {
        /// The file.
        name: String,
        /// Why.
        reason: String,
    },
    /// The script gives up by itself.
    #[error("the script stops with {message}")]
    Raised {
        /// The message of its `Error`.
        message: String,
    },
    /// A curve whose points do not define it.
    #[error("curve {tag}: {fault}")]
    Curve {
        /// The curve.
        tag: i32,
        /// What is wrong with it.
        fault: CurveFault,
    },
    /// A loop whose curves do not close it.
    #[error("surface {surface}: its boundary is open at point {point}")]
    Open {
        /// The surface.
        surface: i32,
        /// The point at which only one curve ends.
        point: i32,
    },
    /// A loop of a surface outside of the others.
    #[error("surface {surface}: loop {outside} lies outside of loop {outer}")]
    LoopOutside {
        /// The surface.
        surface: i32,
        /// The loop.
        outside: i32,
        /// The loop that encloses the most.
        outer: i32,
    },
    /// A boolean difference whose tools do not lie inside the object.
    #[error(
        "surface {surface}: BooleanDifference is read only where the tools lie inside the \
             object and apart from one another"
    )]
    NotInside {
        /// The surface.
        surface: i32,
    },
    /// A curve is named whose number boolean operations have changed.
    #[error("the number of curve {curve} after a boolean operation is not known here")]
    Unsure {
        /// The curve, as it is counted here.
        curve: i32,
    },
    /// Surfaces that cover the same place.
    #[error("surface {surface} overlaps surface {other} (line {line}) near ({x}, {y})", x = at[0], y = at[1])]
    Overlap {
        /// The surface.
        surface: i32,
        /// The one that was made first.
        other: i32,
        /// The line of that one.
        line: u32,
        /// A place in both.
        at: [f64; 2],
    },
    /// A surface without an inside.
    #[error("surface {surface} encloses nothing")]
    Empty {
        /// The surface.
        surface: i32,
    },
    /// Points that lie in no common plane along the axes.
    #[error("point {point} does not lie in the plane {plane} of the others (line {line})")]
    OffPlane {
        /// The point.
        point: i32,
        /// The plane of the first points.
        plane: String,
        /// Where the first of them is made.
        line: u32,
    },
    /// A group's number that no mesh file can hold.
    #[error("{number} is no number of a group")]
    GroupNumber {
        /// The number.
        number: f64,
    },
    /// The script has no surface.
    #[error("the script makes no surface: there is nothing to mesh")]
    Nothing,
}

/// What is wrong with a curve.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurveFault {
    /// An arc with an end in its centre.
    #[error("the arc ends in its own centre")]
    EndInCentre,
    /// An arc whose ends have unequal distances from its centre.
    #[error("the ends of the arc are {0} and {1} away from its centre")]
    Radii(f64, f64),
    /// An ellipse that no ends on it define.
    #[error("no ellipse with this centre and major axis goes through both ends")]
    NoEllipse,
    /// Too few points.
    #[error("a curve needs two points that differ")]
    TooFewPoints,
    /// An arc over the half circle, which the built-in kernel does not have.
    #[error("a radius must be positive, not {0}")]
    Radius(f64),
}

impl Problem {
    fn help(&self) -> Option<&str> {
        match self {
            Self::Syntax { help, .. } => help.as_deref(),
            Self::Unsupported { .. } => Some(SUBSET),
            Self::Include { .. } => Some("only files beside the script, or in folders below it"),
            Self::Twice { .. } => Some("`newp`, `newl` and `news` give numbers that are free"),
            _ => None,
        }
    }
}
