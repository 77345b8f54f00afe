//! Where segments cross, touch or overlap: what the sweep's first violation is a part of.

use std::fmt;
use std::ops::ControlFlow;

use super::error::{Item, Kind, Quoted, more, number, rounded};
use super::sweep::{Linework, Violation, cross};
use crate::Pslg;
use crate::boxes::{Boxes, Rectangle};
use crate::columns::lexicographic;
use crate::constructions::crossing;
use crate::predicates::{Side, side};

/// This many of a kind are named in full.
pub(super) const IN_FULL: usize = 3;

/// The search for conflicts ends after this many pairs of segments with overlapping boxes.
const MOST_PAIRS: usize = 20_000_000;

/// How two parts of an outline violate Assumption 1 (ii) or (iii).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ConflictKind {
    /// Two segments cross in a point inside both.
    Crossing,
    /// Two segments on one line share a stretch.
    Overlap,
    /// A segment ends inside another one (a T-junction).
    TJunction,
    /// A point that no segment uses lies inside a segment.
    PointOnSegment,
}

/// A violation of Assumption 1 (ii) or (iii), both culprits named.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    /// What is wrong.
    pub kind: ConflictKind,
    /// The culprits: two segments, or a point and a segment.
    pub items: [Item; 2],
    /// A place where they meet, in the coordinates of the outline, rounded.
    pub place: [f64; 2],
}

/// Where an outline violates Assumption 1 (ii) or (iii).
#[derive(Debug, Clone, PartialEq)]
pub struct Conflicts {
    /// The first three of each kind, kind by kind, in the order of the outline.
    pub first: Vec<Conflict>,
    /// How many there are of each kind.
    pub counts: Vec<(ConflictKind, usize)>,
    /// Whether all were counted; the search gives up where there are too many.
    pub all_counted: bool,
    /// The file, if the outline was read from one.
    pub file: String,
}

impl Conflicts {
    /// How many conflicts of a kind were found. A segment that ends on another one which it
    /// overlaps counts as an overlap alone.
    #[must_use]
    pub fn count(&self, kind: ConflictKind) -> usize {
        self.counts.iter().find(|&&(k, _)| k == kind).map_or(0, |&(_, count)| count)
    }
}

impl fmt::Display for Conflicts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, &(kind, count)) in self.counts.iter().enumerate() {
            let of_kind = || self.first.iter().filter(|conflict| conflict.kind == kind);
            for (nth, conflict) in of_kind().enumerate() {
                let line = if index + nth > 0 { "\n" } else { "" };
                write!(f, "{line}{conflict}{}", Quoted(&conflict.items.each_ref()))?;
            }
            more(f, count, of_kind().count(), !self.all_counted)?;
        }
        let mends = match (self.count(ConflictKind::Overlap), self.counts.len()) {
            (0, _) => "splits",
            (_, 1) => "unites",
            (_, _) => "splits and unites",
        };
        write!(f, "\nhelp: `--repair` {mends} them there")?;
        if !self.file.is_empty() && self.file != "-" {
            let stem = self.file.strip_suffix(".gz").unwrap_or(&self.file);
            let stem = stem.rsplit_once('.').map_or(stem, |(stem, _)| stem);
            write!(f, "; `meshwright draw {} -o {stem}.svg` shows the place", self.file)?;
        }
        Ok(())
    }
}

/// `segments 12 and 40 cross near (2.14, 2.14)`.
impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = &self.items;
        match self.kind {
            ConflictKind::Crossing => write!(f, "segments {} and {} cross", a.number, b.number)?,
            ConflictKind::Overlap => write!(f, "segments {} and {} overlap", a.number, b.number)?,
            ConflictKind::TJunction => write!(f, "{a}, where a segment ends, lies on {b}")?,
            ConflictKind::PointOnSegment => write!(f, "{a} lies on {b}")?,
        }
        let [x, y] = self.place.map(number);
        write!(f, " near ({x}, {y})")
    }
}

/// The linework that violates Assumption 1, and what it was made from.
pub struct Dirty<'a> {
    /// The outline.
    pub pslg: &'a Pslg,
    /// Its linework, perhaps with hull edges.
    pub linework: Linework<'a>,
    /// The input point that each point is.
    pub input_points: &'a [u32],
    /// The input segment that each segment is; `u32::MAX` for hull edges, which are not judged:
    /// where one of them is in conflict, so are the point and the segment that it overlaps.
    pub input_segments: &'a [u32],
    /// Input coordinates are 2^this times those of the linework.
    pub scale_exponent: i32,
}

impl Dirty<'_> {
    /// All conflicts, with the one that is known already.
    pub fn conflicts(&self, known: Violation) -> Conflicts {
        let mut found = Found::default();
        let all_counted = self.search(&mut found).is_continue();
        if found.is_empty() {
            match known {
                Violation::Segments(pair) => self.judge(pair, &mut found),
                Violation::PointOnSegment { point, segment } => {
                    found.touching.push([point, segment])
                }
            }
        }
        found.tidy();

        let mut conflicts = Conflicts {
            first: Vec::new(),
            counts: Vec::new(),
            all_counted,
            file: self.pslg.source.file.clone(),
        };
        let (isolated, touching): (Vec<_>, Vec<_>) =
            found.touching.into_iter().partition(|&[point, _]| self.is_isolated(point));
        for (kind, pairs) in [
            (ConflictKind::Crossing, found.crossing),
            (ConflictKind::Overlap, found.overlapping),
            (ConflictKind::TJunction, touching),
            (ConflictKind::PointOnSegment, isolated),
        ] {
            if !pairs.is_empty() {
                conflicts.counts.push((kind, pairs.len()));
                let first = pairs.iter().take(IN_FULL).map(|&pair| self.conflict(kind, pair));
                conflicts.first.extend(first);
            }
        }
        conflicts
    }

    /// Judges each pair of segments, and each isolated point and segment, whose boxes overlap.
    fn search(&self, found: &mut Found) -> ControlFlow<()> {
        let count = self.input_segments.iter().take_while(|&&input| input != u32::MAX).count();
        let segments = 0..count as u32;
        let rectangle = |s| {
            let [a, b] = self.ends(s);
            Rectangle::around(a, b)
        };
        let rectangles: Vec<_> = segments.clone().map(rectangle).collect();
        let boxes = Boxes::new(&rectangles);
        let mut pairs = 0;
        let mut another_pair = || {
            pairs += 1;
            if pairs > MOST_PAIRS { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        for s in segments {
            boxes.overlapping(&rectangles[s as usize], |t| {
                if t > s {
                    self.judge([s, t], found);
                }
                another_pair()
            })?;
        }
        for (point, &place) in (0..).zip(self.linework.points) {
            if self.is_isolated(point) {
                boxes.overlapping(&Rectangle::around(place, place), |segment| {
                    if self.is_inside(point, segment) {
                        found.touching.push([point, segment]);
                    }
                    another_pair()
                })?;
            }
        }
        ControlFlow::Continue(())
    }

    /// Finds out how two segments meet.
    fn judge(&self, [s, t]: [u32; 2], found: &mut Found) {
        let ([a, b], [c, d]) = (self.ends(s), self.ends(t));
        let is_named = [s, t].iter().all(|&s| self.input_segments[s as usize] != u32::MAX);
        let on_one_line = is_named && side(a, b, c) == Side::On && side(a, b, d) == Side::On;
        let ([left, right], [other_left, other_right]) = (ordered([a, b]), ordered([c, d]));
        if on_one_line
            && lexicographic(left, other_right).is_lt()
            && lexicographic(other_left, right).is_lt()
        {
            found.overlapping.push([s, t]);
        }
        if cross([a, b], [c, d]) {
            found.crossing.push([s, t]);
            return;
        }
        for (from, onto) in [(s, t), (t, s)] {
            for point in self.linework.segments[from as usize] {
                if self.is_inside(point, onto) {
                    let list =
                        if on_one_line { &mut found.within_overlap } else { &mut found.touching };
                    list.push([point, onto]);
                }
            }
        }
    }

    fn conflict(&self, kind: ConflictKind, [first, segment]: [u32; 2]) -> Conflict {
        let item = |s: u32| match self.input_segments[s as usize] {
            // A side of the hull that the outline lacks is known by where it starts.
            u32::MAX => {
                let start = self.linework.segments[s as usize][0];
                Item::new(self.pslg, Kind::Point, self.input_points[start as usize])
            }
            input => Item::new(self.pslg, Kind::Segment, input),
        };
        let (first_item, place) = match kind {
            ConflictKind::Crossing => (item(first), crossing(self.ends(first), self.ends(segment))),
            ConflictKind::Overlap => {
                let ([a, b], [c, d]) = (ordered(self.ends(first)), ordered(self.ends(segment)));
                let start = if lexicographic(a, c).is_lt() { c } else { a };
                let end = if lexicographic(b, d).is_lt() { b } else { d };
                (item(first), [start[0].midpoint(end[0]), start[1].midpoint(end[1])])
            }
            ConflictKind::TJunction | ConflictKind::PointOnSegment => {
                let input = self.input_points[first as usize];
                (Item::new(self.pslg, Kind::Point, input), self.linework.points[first as usize])
            }
        };
        let place = place.map(|c| libm::scalbn(c, self.scale_exponent));
        Conflict {
            kind,
            items: [first_item, item(segment)],
            place: rounded(place, &self.pslg.points),
        }
    }

    /// Whether a point lies inside a segment, its ends excluded.
    fn is_inside(&self, point: u32, segment: u32) -> bool {
        is_strictly_between(self.ends(segment), self.linework.points[point as usize])
    }

    fn is_isolated(&self, point: u32) -> bool {
        let adjoining = self.linework.adjoining_at(point);
        adjoining.iter().all(|&s| self.input_segments[s as usize] == u32::MAX)
    }

    fn ends(&self, segment: u32) -> [[f64; 2]; 2] {
        self.linework.segments[segment as usize].map(|end| self.linework.points[end as usize])
    }
}

/// Pairs in conflict.
#[derive(Default)]
struct Found {
    crossing: Vec<[u32; 2]>,
    overlapping: Vec<[u32; 2]>,
    /// A point and the segment that it lies inside of.
    touching: Vec<[u32; 2]>,
    /// The same, where the point ends a segment that overlaps: one cause, one error.
    within_overlap: Vec<[u32; 2]>,
}

impl Found {
    fn is_empty(&self) -> bool {
        self.crossing.is_empty() && self.overlapping.is_empty() && self.touching.is_empty()
    }

    /// Sorts by the outline's order, and keeps each point on a segment once.
    fn tidy(&mut self) {
        self.crossing.sort_unstable();
        self.overlapping.sort_unstable();
        self.within_overlap.sort_unstable();
        self.touching.sort_unstable();
        self.touching.dedup();
        self.touching.retain(|pair| self.within_overlap.binary_search(pair).is_err());
    }
}

fn ordered([a, b]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    if lexicographic(a, b).is_lt() { [a, b] } else { [b, a] }
}

/// Whether a place lies on the segment with the given ends, but is none of them.
pub(super) fn is_strictly_between(ends: [[f64; 2]; 2], place: [f64; 2]) -> bool {
    let [a, b] = ordered(ends);
    lexicographic(a, place).is_lt()
        && lexicographic(place, b).is_lt()
        && side(a, b, place) == Side::On
}
