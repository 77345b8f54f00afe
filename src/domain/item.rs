//! Items of an outline as their file knows them, for messages.

use std::fmt;

use crate::Pslg;

/// What an [`Item`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A point of the outline.
    Point,
    /// A segment.
    Segment,
    /// The seed of a hole.
    Hole,
    /// The seed of a region.
    Region,
}

/// An item of an outline as its file knows it.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// What it is.
    pub kind: Kind,
    /// Its zero-based index in the [`Pslg`].
    pub index: u32,
    /// The number by which the file knows it.
    pub number: i64,
    /// The file and the line (one-based) where it stands, if it was read from a file.
    pub line: Option<(String, u32)>,
    /// Its numbers: the coordinates of a point or seed, the numbers of a segment's ends.
    pub values: String,
}

impl Item {
    /// The item of a kind with the given (zero-based) index.
    pub(super) fn new(pslg: &Pslg, kind: Kind, index: u32) -> Self {
        let source = &pslg.source;
        let counted = i64::from(source.first_number) + i64::from(index);
        let (number, lines) = match kind {
            Kind::Point => (source.point_number(index), &source.point_lines),
            Kind::Segment => (source.segment_number(index), &source.segment_lines),
            Kind::Hole => (counted, &source.hole_lines),
            Kind::Region => (counted, &source.region_lines),
        };
        let file = match (&source.point_file, kind) {
            (Some(file), Kind::Point) => file,
            _ => &source.file,
        };
        let coordinates = |[x, y]: [f64; 2]| format!("{x} {y}");
        let index_in_array = index as usize;
        let values = match kind {
            Kind::Point => coordinates(pslg.points[index_in_array]),
            Kind::Hole => coordinates(pslg.holes[index_in_array]),
            Kind::Region => coordinates(pslg.regions[index_in_array].seed),
            Kind::Segment => {
                let [a, b] = pslg.segments[index_in_array].map(|end| source.point_number(end));
                format!("{a} {b}")
            }
        };
        let line = lines.get(index_in_array).map(|&line| (file.clone(), line));
        Self { kind, index, number, line, values }
    }

    /// A line of a message that shows where the item stands and its numbers, such as
    /// `  site.poly:61: 12 3 17`.
    pub(super) fn quote(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { number, values, .. } = self;
        match &self.line {
            Some((file, line)) if file.is_empty() => {
                write!(f, "\n  line {line}: {number} {values}")
            }
            Some((file, line)) => write!(f, "\n  {file}:{line}: {number} {values}"),
            None => write!(f, "\n  {self}: {values}"),
        }
    }
}

/// `segment 12`.
impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.kind {
            Kind::Point => "point",
            Kind::Segment => "segment",
            Kind::Hole => "hole",
            Kind::Region => "region",
        };
        write!(f, "{kind} {}", self.number)
    }
}
