//! What was mended, in the outline's own numbers.

use std::fmt;

use super::super::conflicts::IN_FULL;
use super::super::error::{Item, Kind, Quoted, count_of, more, number, rounded, significant};
use crate::Pslg;

/// Something that was mended.
///
/// Segments are indices into those of the outline that was given. So are points; from the number
/// of its points on they are new ones, in the order in which they were made. Distances are in the
/// units of the outline.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Repair {
    /// Two segments crossed: both are split.
    Crossing {
        /// The segments.
        segments: [u32; 2],
        /// The point at which they are split.
        point: u32,
    },
    /// Two segments shared a stretch: it is kept once.
    Overlap {
        /// The segment that keeps it, and the one that loses it.
        segments: [u32; 2],
    },
    /// A segment ended inside another one, which is split.
    TJunction {
        /// The point.
        point: u32,
        /// The segment that is split there.
        segment: u32,
    },
    /// A point that no segment used lay inside a segment, which is split.
    PointOnSegment {
        /// The point.
        point: u32,
        /// The segment that is split there.
        segment: u32,
    },
    /// Two open ends lay within the tolerance: they are one point now.
    Gap {
        /// The point that stays, and the one merged into it.
        points: [u32; 2],
        /// How far apart they were.
        distance: f64,
    },
    /// Two points lay within the tolerance: they are one point now.
    NearPoints {
        /// The point that stays, and the one merged into it.
        points: [u32; 2],
        /// How far apart they were.
        distance: f64,
    },
    /// A point lay within the tolerance of a segment, which is led through it.
    NearSegment {
        /// The point.
        point: u32,
        /// The segment.
        segment: u32,
        /// How far it was off.
        distance: f64,
    },
    /// A segment, or a piece of one, was shorter than the tolerance: its ends are one point now.
    ShortSegment {
        /// The segment.
        segment: u32,
    },
}

/// What a [`Repair`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum RepairKind {
    /// [`Repair::Crossing`].
    Crossing,
    /// [`Repair::Overlap`].
    Overlap,
    /// [`Repair::TJunction`].
    TJunction,
    /// [`Repair::PointOnSegment`].
    PointOnSegment,
    /// [`Repair::Gap`].
    Gap,
    /// [`Repair::NearPoints`].
    NearPoints,
    /// [`Repair::NearSegment`].
    NearSegment,
    /// [`Repair::ShortSegment`].
    ShortSegment,
}

impl RepairKind {
    /// The kind as a noun: `crossing`, `T-junction`, …
    #[must_use]
    pub fn noun(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::Overlap => "overlap",
            Self::TJunction => "T-junction",
            Self::PointOnSegment => "point on a segment",
            Self::Gap => "gap",
            Self::NearPoints => "near point",
            Self::NearSegment => "point near a segment",
            Self::ShortSegment => "short segment",
        }
    }
}

impl Repair {
    /// What it is.
    #[must_use]
    pub fn kind(&self) -> RepairKind {
        match self {
            Self::Crossing { .. } => RepairKind::Crossing,
            Self::Overlap { .. } => RepairKind::Overlap,
            Self::TJunction { .. } => RepairKind::TJunction,
            Self::PointOnSegment { .. } => RepairKind::PointOnSegment,
            Self::Gap { .. } => RepairKind::Gap,
            Self::NearPoints { .. } => RepairKind::NearPoints,
            Self::NearSegment { .. } => RepairKind::NearSegment,
            Self::ShortSegment { .. } => RepairKind::ShortSegment,
        }
    }

    /// The points it is about; a crossing has the point that it is split at.
    #[must_use]
    pub fn points(&self) -> &[u32] {
        match self {
            Self::Crossing { point, .. }
            | Self::TJunction { point, .. }
            | Self::PointOnSegment { point, .. }
            | Self::NearSegment { point, .. } => std::slice::from_ref(point),
            Self::Gap { points, .. } | Self::NearPoints { points, .. } => points,
            Self::Overlap { .. } | Self::ShortSegment { .. } => &[],
        }
    }

    /// The segments it is about.
    #[must_use]
    pub fn segments(&self) -> &[u32] {
        match self {
            Self::Crossing { segments, .. } | Self::Overlap { segments } => segments,
            Self::TJunction { segment, .. }
            | Self::PointOnSegment { segment, .. }
            | Self::NearSegment { segment, .. }
            | Self::ShortSegment { segment } => std::slice::from_ref(segment),
            Self::Gap { .. } | Self::NearPoints { .. } => &[],
        }
    }

    /// How far apart things were, where that matters.
    #[must_use]
    pub fn distance(&self) -> Option<f64> {
        match *self {
            Self::Gap { distance, .. }
            | Self::NearPoints { distance, .. }
            | Self::NearSegment { distance, .. } => Some(distance),
            _ => None,
        }
    }

    /// The order in which repairs are reported: kind by kind, in the order of the outline.
    pub(super) fn order(&self) -> (RepairKind, &[u32], &[u32]) {
        (self.kind(), self.segments(), self.points())
    }
}

/// Repairs with the numbers and lines of the outline that was mended.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    pub(super) outline: &'a Pslg,
    pub(super) repairs: &'a [Repair],
    /// Where the new points are.
    pub(super) new_points: &'a [[f64; 2]],
    /// The number of the first new point.
    pub(super) first_new: i64,
}

impl<'a> Report<'a> {
    /// What was mended.
    #[must_use]
    pub fn repairs(&self) -> &'a [Repair] {
        self.repairs
    }

    /// The number of a point of a [`Repair`]: that of its file, or for a new one the next number
    /// that the file does not have.
    #[must_use]
    pub fn point_number(&self, point: u32) -> i64 {
        match self.new_index(point) {
            Some(new) => self.first_new + new as i64,
            None => self.outline.source.point_number(point),
        }
    }

    /// The number of a segment of a [`Repair`].
    #[must_use]
    pub fn segment_number(&self, segment: u32) -> i64 {
        self.outline.source.segment_number(segment)
    }

    /// Where a point of a [`Repair`] is.
    #[must_use]
    pub fn place(&self, point: u32) -> [f64; 2] {
        match self.new_index(point) {
            Some(new) => self.new_points[new],
            None => self.outline.points[point as usize],
        }
    }

    /// How many repairs there are of each kind.
    #[must_use]
    pub fn counts(&self) -> Vec<(RepairKind, usize)> {
        let of_kind = self.repairs.chunk_by(|a, b| a.kind() == b.kind());
        of_kind.map(|same| (same[0].kind(), same.len())).collect()
    }

    /// One repair in one sentence: `segments 5 and 6 cross near (0.5, 0.5): split at point 9`.
    #[must_use]
    pub fn sentence(&self, repair: &Repair) -> String {
        let points: Vec<i64> = repair.points().iter().map(|&p| self.point_number(p)).collect();
        let segments: Vec<i64> =
            repair.segments().iter().map(|&s| self.segment_number(s)).collect();
        let apart = repair.distance().map(significant).unwrap_or_default();
        match (repair, &points[..], &segments[..]) {
            (Repair::Crossing { point, .. }, [p], [s, t]) => {
                let [x, y] = rounded(self.place(*point), &self.outline.points).map(number);
                format!("segments {s} and {t} cross near ({x}, {y}): split at point {p}")
            }
            (Repair::Overlap { .. }, _, [s, t]) => {
                format!("segments {s} and {t} overlap: what they share stays with segment {s}")
            }
            (Repair::TJunction { .. }, [p], [s]) => {
                format!("point {p}, where a segment ends, lies on segment {s}: split there")
            }
            (Repair::PointOnSegment { .. }, [p], [s]) => {
                format!("point {p} lies on segment {s}: split there")
            }
            (Repair::Gap { .. }, [p, q], _) => {
                format!("points {p} and {q} are open ends, {apart} apart: joined at point {p}")
            }
            (Repair::NearPoints { .. }, [p, q], _) => {
                format!("points {p} and {q} are {apart} apart: merged at point {p}")
            }
            (Repair::NearSegment { .. }, [p], [s]) => {
                format!("point {p} is {apart} off segment {s}: the segment is led through it")
            }
            (_, _, segments) => {
                let number = segments.first().copied().unwrap_or_default();
                format!("segment {number} has a piece shorter than the tolerance: dropped")
            }
        }
    }

    /// The items of a repair that stand in the file.
    fn items(&self, repair: &Repair) -> Vec<Item> {
        let old = repair.points().iter().filter(|&&point| self.new_index(point).is_none());
        let points = old.map(|&point| Item::new(self.outline, Kind::Point, point));
        let segments = repair.segments().iter();
        points.chain(segments.map(|&s| Item::new(self.outline, Kind::Segment, s))).collect()
    }

    /// The lines of the file that a repair is about: file and line (one-based) of each item.
    #[must_use]
    pub fn lines(&self, repair: &Repair) -> Vec<(String, u32)> {
        self.items(repair).into_iter().filter_map(|item| item.line).collect()
    }

    fn new_index(&self, point: u32) -> Option<usize> {
        (point as usize).checked_sub(self.outline.points.len())
    }
}

/// `1 crossing, 2 T-junctions`, then the first three of each kind, with their lines.
impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts: Vec<String> =
            self.counts().iter().map(|&(kind, count)| plural(kind, count)).collect();
        f.write_str(&counts.join(", "))?;
        for same in self.repairs.chunk_by(|a, b| a.kind() == b.kind()) {
            for repair in same.iter().take(IN_FULL) {
                write!(f, "\n{}", self.sentence(repair))?;
                let items = self.items(repair);
                write!(f, "{}", Quoted(&items.iter().collect::<Vec<_>>()))?;
            }
            more(f, same.len(), same.len().min(IN_FULL), false)?;
        }
        Ok(())
    }
}

fn plural(kind: RepairKind, count: usize) -> String {
    match (kind, count) {
        (RepairKind::PointOnSegment, 2..) => format!("{count} points on segments"),
        (RepairKind::NearSegment, 2..) => format!("{count} points near segments"),
        _ => count_of(count, kind.noun()),
    }
}
