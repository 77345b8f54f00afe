//! What is wrong with an outline, and what was done about what is only untidy.

use std::fmt;

use super::conflicts::{Conflicts, IN_FULL};
pub use super::item::{Item, Kind};
use super::open_ends::OpenEnds;

/// Why an outline cannot be meshed. Items are named by the numbers and lines of their file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A coordinate is infinite or no number.
    #[error("{item} has a coordinate that is no finite number{}", Quoted(&[item]))]
    NotFinite {
        /// The point.
        item: Item,
    },
    /// A coordinate is so small beside the largest one that products of coordinates underflow.
    #[error(
        "{item}: the coordinate {coordinate:e} is too small beside {largest:e} for exact \
         arithmetic in doubles{}\nhelp: if it stands for zero, write 0",
        Quoted(&[item])
    )]
    TooSmall {
        /// The point.
        item: Box<Item>,
        /// The coordinate.
        coordinate: f64,
        /// The largest coordinate of the outline in magnitude.
        largest: f64,
    },
    /// There is nothing to mesh: fewer than three distinct points.
    #[error("{}: a mesh needs at least three", count_of(*.points, "distinct point"))]
    TooFewPoints {
        /// How many distinct points there are.
        points: usize,
    },
    /// All points lie on one line.
    #[error("all {points} points lie on one line: there is no area to mesh")]
    Collinear {
        /// How many distinct points there are.
        points: usize,
    },
    /// Segments cross, touch or overlap.
    #[error("{0}")]
    Conflicts(Box<Conflicts>),
    /// There is more to repair than bounded time and memory allow.
    #[error(
        "this is too tangled to repair: {pairs} pairs of segments lie near each other, \
         {meetings} of them meet"
    )]
    TooTangled {
        /// How many pairs of segments were looked at.
        pairs: usize,
        /// How many meetings were found.
        meetings: usize,
    },
    /// What the tolerance of a repair joins brings ever more within it.
    #[error(
        "a tolerance of {} is too large for this outline: after {rounds} rounds it still joins \
         points\nhelp: a smaller --tolerance joins fewer",
        significant(*tolerance)
    )]
    Unsettled {
        /// The tolerance, in the units of the outline.
        tolerance: f64,
        /// How many rounds were made.
        rounds: usize,
    },
    /// The seed of a hole or region lies on the outline.
    #[error(
        "{seed} lies on {on}: it does not say which side is meant{}\nhelp: move it inside",
        Quoted(&[seed, on])
    )]
    SeedOnOutline {
        /// The seed.
        seed: Item,
        /// The point or segment that it lies on.
        on: Box<Item>,
    },
    /// The segments form no closed loop.
    #[error(
        "the outline encloses nothing{open_ends}\n\
         help: {}{}`--region hull` meshes the convex hull of the points",
        .open_ends.advice().map(|advice| advice + "; ").unwrap_or_default(),
        .last_line.map(|line| format!("line {line} is the last: is the file whole? "))
            .unwrap_or_default()
    )]
    EnclosesNothing {
        /// Where it is open.
        open_ends: OpenEnds,
        /// The last line of a file that may have been cut off.
        last_line: Option<u32>,
    },
    /// Faces are enclosed, but only those with a region's seed are meshed, and none has one.
    #[error(
        "no region's seed lies in any of the {}: nothing is meshed",
        count_of(*.faces as usize, "face")
    )]
    NoFaceHasSeed {
        /// How many faces the segments enclose.
        faces: u32,
    },
    /// The holes take everything out.
    #[error(
        "the holes leave nothing to mesh{open_ends}{}{}",
        Quoted(&holes.iter().take(IN_FULL).collect::<Vec<_>>()),
        .open_ends.advice().map(|advice| format!("\nhelp: {advice}")).unwrap_or_default()
    )]
    HolesLeaveNothing {
        /// The holes.
        holes: Vec<Item>,
        /// Where their outlines may be open.
        open_ends: OpenEnds,
    },
}

/// What was merged, dropped or left out: nothing is in silence. `first` holds the first three.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// Points with equal coordinates were merged.
    DuplicatePoints {
        /// How many points were merged into earlier ones.
        count: usize,
        /// Pairs of the point that stays and the one merged into it.
        first: Vec<[Item; 2]>,
    },
    /// Segments of length zero were dropped.
    ZeroLength {
        /// How many.
        count: usize,
        /// The segments.
        first: Vec<Item>,
    },
    /// Segments that join the same two points as an earlier one were dropped.
    DuplicateSegments {
        /// How many.
        count: usize,
        /// Pairs of the segment that stays and the one dropped.
        first: Vec<[Item; 2]>,
    },
    /// Segments that join the same two points as an earlier one, with another tag, were dropped.
    TagsDiffer {
        /// How many.
        count: usize,
        /// Pairs of the segment that stays and the one dropped.
        first: Vec<[Item; 2]>,
        /// The tags of each pair.
        tags: Vec<[i32; 2]>,
    },
    /// Segments with different tags overlapped: what they shared has the tag of the first.
    TagsOverlap {
        /// How many pairs of segments.
        count: usize,
        /// Pairs of the segment whose tag stays and the other one.
        first: Vec<[Item; 2]>,
        /// The tags of each pair.
        tags: Vec<[i32; 2]>,
    },
    /// The outline has no segments: the convex hull of its points is meshed.
    NoSegments,
    /// Seeds of holes or regions outside of the outline were ignored.
    SeedsOutside {
        /// How many.
        count: usize,
        /// The seeds.
        first: Vec<Item>,
    },
    /// Region seeds in holes were ignored.
    RegionsInHoles {
        /// How many.
        count: usize,
        /// The seeds.
        first: Vec<Item>,
    },
    /// Region seeds in a face that holds another one before them were ignored.
    RegionsShareFace {
        /// How many.
        count: usize,
        /// Pairs of the seed that counts and the one ignored.
        first: Vec<[Item; 2]>,
    },
    /// Points or segments outside of what is meshed are left out.
    LeftOut {
        /// How many.
        count: usize,
        /// The points, or the segments.
        first: Vec<Item>,
    },
    /// Doubles are too coarse for the angles at some points (§9).
    LimitedByPrecision {
        /// How many points.
        count: usize,
        /// The points.
        first: Vec<LimitedApex>,
    },
}

/// A point near which doubles are too coarse for its smallest angle.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitedApex {
    /// The point.
    pub point: Item,
    /// The segments of its smallest angle; `None` is an edge of the convex hull.
    pub segments: [Option<Item>; 2],
    /// The angle.
    pub radians: f64,
    /// Nearer than this (in the units of the outline) no angle is promised.
    pub reach: f64,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DuplicatePoints { count, first } => {
                write!(f, "{} merged", count_of(*count, "duplicate point"))?;
                for [kept, merged] in first {
                    write!(f, "\n  {merged} is {kept}")?;
                    merged.quote(f)?;
                }
                more(f, *count, first.len(), false)
            }
            Self::ZeroLength { count, first } => list(f, *count, first, "of length zero dropped"),
            Self::DuplicateSegments { count, first } => {
                write!(f, "{} dropped", count_of(*count, "duplicate segment"))?;
                for [kept, dropped] in first {
                    write!(f, "\n  {dropped} is {kept} again")?;
                    dropped.quote(f)?;
                }
                more(f, *count, first.len(), false)
            }
            Self::TagsDiffer { count, first, tags } => {
                let segments = count_of(*count, "duplicate segment");
                write!(f, "{segments} with another tag dropped: the first tag stays")?;
                for ([kept, dropped], [tag, other]) in first.iter().zip(tags) {
                    write!(f, "\n  {dropped} (tag {other}) is {kept} (tag {tag}) again")?;
                    dropped.quote(f)?;
                }
                more(f, *count, first.len(), false)
            }
            Self::TagsOverlap { count, first, tags } => {
                let overlaps = count_of(*count, "overlap");
                write!(f, "{overlaps} of segments with different tags: the first tag stays there")?;
                for ([kept, other], [tag, lost]) in first.iter().zip(tags) {
                    write!(f, "\n  {other} (tag {lost}) runs along {kept} (tag {tag})")?;
                    other.quote(f)?;
                }
                more(f, *count, first.len(), false)
            }
            Self::NoSegments => write!(f, "no segments: the convex hull of the points is meshed"),
            Self::SeedsOutside { count, first } => {
                list(f, *count, first, "outside of the outline ignored")
            }
            Self::RegionsInHoles { count, first } => list(f, *count, first, "in a hole ignored"),
            Self::RegionsShareFace { count, first } => {
                write!(
                    f,
                    "{} in a region that has a seed already ignored",
                    count_of(*count, "region seed")
                )?;
                for [kept, ignored] in first {
                    write!(f, "\n  {ignored} is {kept} again")?;
                    ignored.quote(f)?;
                }
                more(f, *count, first.len(), false)
            }
            Self::LimitedByPrecision { count, first } => {
                write!(f, "{} limited by precision", count_of(*count, "small angle"))?;
                for LimitedApex { point, segments, radians, reach } in first {
                    let degrees = significant(radians.to_degrees());
                    let name = |segment: &Option<Item>| match segment {
                        Some(item) => item.to_string(),
                        None => "the convex hull".to_owned(),
                    };
                    let [a, b] = segments.each_ref().map(name);
                    let reach = significant(*reach);
                    write!(f, "\n  {point}: {degrees}° between {a} and {b}: ")?;
                    write!(f, "nearer than {reach} no angle is promised")?;
                    point.quote(f)?;
                }
                more(f, *count, first.len(), false)
            }
            Self::LeftOut { count, first } => {
                list(f, *count, first, "outside of what is meshed left out")
            }
        }
    }
}

/// `2 segments of length zero dropped`, and where the first ones stand.
fn list(f: &mut fmt::Formatter<'_>, count: usize, first: &[Item], what: &str) -> fmt::Result {
    let noun = match first.first().map(|item| item.kind) {
        Some(Kind::Hole) => "hole seed",
        Some(Kind::Region) => "region seed",
        Some(Kind::Segment) => "segment",
        Some(Kind::Point) | None => "point",
    };
    write!(f, "{} {what}{}", count_of(count, noun), Quoted(&first.iter().collect::<Vec<_>>()))?;
    more(f, count, first.len(), false)
}

/// A length to three significant digits.
pub(super) fn significant(x: f64) -> String {
    number(format!("{x:.2e}").parse().unwrap_or(x))
}

/// `1 point`, `2 points`.
pub(super) fn count_of(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// The line after the first few of a kind, where there are more.
pub(super) fn more(
    f: &mut fmt::Formatter<'_>,
    count: usize,
    shown: usize,
    at_least: bool,
) -> fmt::Result {
    match (count - shown, at_least) {
        (0, _) => Ok(()),
        (rest, false) => write!(f, "\nand {rest} more"),
        (rest, true) => write!(f, "\nand at least {rest} more"),
    }
}

/// A number as people write it: without an exponent where it needs none.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 || (1e-5..1e15).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

/// A place, rounded to about a ten-thousandth of the extent of `points`.
pub(super) fn rounded(place: [f64; 2], points: &[[f64; 2]]) -> [f64; 2] {
    let extent = |k: usize| {
        let (low, high) = points
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[k]), h.max(p[k])));
        high - low
    };
    let digits = 4.0 - libm::floor(libm::log10(extent(0).max(extent(1))));
    place.map(|c| {
        let text = if digits < 0.0 {
            format!("{c:.0}")
        } else if digits < 20.0 {
            format!("{c:.*}", digits as usize)
        } else {
            format!("{c:.2e}")
        };
        text.parse().unwrap_or(c)
    })
}

/// The lines that show where items stand.
pub(super) struct Quoted<'a>(pub &'a [&'a Item]);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|item| item.quote(f))
    }
}
