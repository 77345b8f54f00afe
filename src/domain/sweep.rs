//! Assumption 1 (ii) and (iii), judged exactly by one plane sweep (Shamos & Hoey 1976), which also
//! finds what lies below each point.
//!
//! The sweep line moves through the points in lexicographic order. Until the leftmost place where
//! two segments meet elsewhere than at a common end, the order of the segments along the line is
//! right; there, the two are neighbours or one of them ends on the other.

use super::adjoining::other_end;
use super::status::{NONE, Position, Status};
use crate::columns::lexicographic;
use crate::predicates::{Side, side};

/// The linework that is swept.
#[derive(Clone, Copy)]
pub struct Linework<'a> {
    /// Distinct points.
    pub points: &'a [[f64; 2]],
    /// Distinct segments of positive length.
    pub segments: &'a [[u32; 2]],
    /// The points in lexicographic order; of those that no segment ends at or meets, perhaps not all.
    pub order: &'a [u32],
    /// As [`Domain::adjoining_start`](super::Domain::adjoining_start).
    pub adjoining_start: &'a [u32],
    /// As [`Domain::adjoining`](super::Domain::adjoining).
    pub adjoining: &'a [u32],
}

impl<'a> Linework<'a> {
    /// The segments that end at a point, counter-clockwise from straight down.
    pub fn adjoining_at(&self, point: u32) -> &'a [u32] {
        let [start, end] = [point, point + 1].map(|p| self.adjoining_start[p as usize] as usize);
        &self.adjoining[start..end]
    }
}

/// What a clean sweep finds.
#[derive(Debug)]
pub struct Located {
    /// For each point of the order the segment directly below it, [`NOTHING`] where there is none.
    /// ("Below" is meant lexicographically: a point above the upper end of a vertical segment lies
    /// beside it.)
    pub below: Vec<u32>,
    /// Where each seed lies.
    pub seeds: Vec<Place>,
}

/// Where a seed lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// On a point.
    Point(u32),
    /// On a segment.
    Segment(u32),
    /// Directly above this segment, [`NOTHING`] where there is none.
    Above(u32),
}

/// No segment.
pub const NOTHING: u32 = u32::MAX;

/// The first violation of Assumption 1 that the sweep meets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Violation {
    /// A point lies on a segment that does not end there.
    PointOnSegment {
        /// The point.
        point: u32,
        /// The segment.
        segment: u32,
    },
    /// Two segments cross or overlap.
    Segments([u32; 2]),
}

/// So many points are fetched at once: one by one, each would be waited for.
const FETCHED: usize = 4096;

/// Sweeps the linework, and locates seeds on the way.
///
/// # Errors
/// The first violation of Assumption 1.
pub fn sweep(linework: &Linework, seeds: &[[f64; 2]]) -> Result<Located, Violation> {
    let mut sweep = Sweep::new(linework);
    let mut located = Located {
        below: Vec::with_capacity(linework.order.len()),
        seeds: vec![Place::Above(NOTHING); seeds.len()],
    };
    // A seed beyond the points may be too far off for exact arithmetic.
    let (low, high) = vertical_extent(linework.points);
    let is_near = |&seed: &u32| {
        let [x, y] = seeds[seed as usize];
        x.is_finite() && (low..=high).contains(&y)
    };
    let mut seed_order: Vec<u32> = (0..seeds.len() as u32).filter(is_near).collect();
    seed_order.sort_by(|&i, &j| lexicographic(seeds[i as usize], seeds[j as usize]));
    let mut waiting = seed_order.into_iter().peekable();
    let fetch = |&point: &u32| Stop {
        point,
        place: linework.points[point as usize],
        adjoining: linework.adjoining_at(point),
    };
    let mut stops = Vec::new();
    for many in linework.order.chunks(FETCHED) {
        stops.clear();
        stops.extend(many.iter().map(fetch));
        for stop in &stops {
            let &Stop { point, place, .. } = stop;
            while let Some(seed) =
                waiting.next_if(|&seed| lexicographic(seeds[seed as usize], place).is_le())
            {
                located.seeds[seed as usize] = if seeds[seed as usize] == place {
                    Place::Point(point)
                } else {
                    sweep.locate(seeds[seed as usize])
                };
            }
            located.below.push(sweep.pass(stop)?);
        }
    }
    Ok(located)
}

fn vertical_extent(points: &[[f64; 2]]) -> (f64, f64) {
    points
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &[_, y]| (low.min(y), high.max(y)))
}

/// A point that the sweep line comes to.
#[derive(Clone, Copy)]
struct Stop<'a> {
    point: u32,
    place: [f64; 2],
    /// The segments that end there, counter-clockwise from straight down.
    adjoining: &'a [u32],
}

struct Sweep<'a> {
    linework: &'a Linework<'a>,
    status: Status,
    /// The status's node of each segment.
    node: Vec<u32>,
}

impl<'a> Sweep<'a> {
    fn new(linework: &'a Linework<'a>) -> Self {
        Self { linework, status: Status::new(), node: vec![NONE; linework.segments.len()] }
    }

    fn locate(&self, place: [f64; 2]) -> Place {
        match self.status.find(place) {
            Position::On(node) => Place::Segment(self.status.segment(node)),
            Position::Between { below: NONE, .. } => Place::Above(NOTHING),
            Position::Between { below, .. } => Place::Above(self.status.segment(below)),
        }
    }

    /// Moves the sweep line past a point; returns the segment below it.
    fn pass(&mut self, stop: &Stop<'a>) -> Result<u32, Violation> {
        let (starting, ending) = self.starting_and_ending(stop);
        let [below, above] = self.neighbours(stop, ending)?;
        let segment_below = if below == NONE { NOTHING } else { self.status.segment(below) };
        if starting.is_empty() && ending.is_empty() {
            return Ok(segment_below);
        }
        self.no_two_in_one_direction(stop.place, starting)?;

        // From bottom to top, starting segments take the places of ending ones.
        let mut last = below;
        let mut ended = ending.iter().rev();
        for &segment in starting {
            let ends = self.ends(segment);
            last = match ended.next() {
                Some(&old) => {
                    let node = self.node[old as usize];
                    self.status.replace(node, segment, ends);
                    node
                }
                None => self.status.insert_above(last, segment, ends),
            };
            self.node[segment as usize] = last;
        }
        for &old in ended {
            self.status.remove(self.node[old as usize]);
        }

        match starting {
            [] => self.no_crossing(below, above)?,
            [lowest, ..] => {
                self.no_crossing(below, self.node[*lowest as usize])?;
                self.no_crossing(last, above)?;
            }
        }
        Ok(segment_below)
    }

    /// The segments that start at a point, from bottom to top, and those that end there, from top
    /// to bottom.
    fn starting_and_ending(&self, stop: &Stop<'a>) -> (&'a [u32], &'a [u32]) {
        let Linework { points, segments, .. } = *self.linework;
        let starts = |&segment: &u32| {
            let other = other_end(segments[segment as usize], stop.point);
            lexicographic(points[other as usize], stop.place).is_gt()
        };
        stop.adjoining.split_at(stop.adjoining.partition_point(starts))
    }

    /// The nodes directly below and above a point, once the segments that end there are known to
    /// lie between those two, and no other.
    fn neighbours(&self, stop: &Stop, ending: &[u32]) -> Result<[u32; 2], Violation> {
        let &Stop { point, place, .. } = stop;
        let on = |node| Violation::PointOnSegment { point, segment: self.status.segment(node) };
        let (Some(&highest), Some(&lowest)) = (ending.first(), ending.last()) else {
            return match self.status.find(place) {
                Position::Between { below, above } => Ok([below, above]),
                Position::On(node) => Err(on(node)),
            };
        };
        for pair in ending.windows(2) {
            let above_lower = self.status.above(self.node[pair[1] as usize]);
            if above_lower != self.node[pair[0] as usize] {
                return Err(on(above_lower));
            }
        }
        let below = self.status.below(self.node[lowest as usize]);
        let above = self.status.above(self.node[highest as usize]);
        if below != NONE && self.status.side(below, place) != Side::Left {
            return Err(on(below));
        }
        if above != NONE && self.status.side(above, place) != Side::Right {
            return Err(on(above));
        }
        Ok([below, above])
    }

    /// Overlapping segments that start at one point.
    fn no_two_in_one_direction(&self, from: [f64; 2], starting: &[u32]) -> Result<(), Violation> {
        for pair in starting.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|segment| self.ends(segment)[1]);
            if side(from, a, b) == Side::On {
                return Err(Violation::Segments([pair[0], pair[1]]));
            }
        }
        Ok(())
    }

    /// Neighbours that cross. (That one ends on the other shows when the sweep gets there.)
    fn no_crossing(&self, below: u32, above: u32) -> Result<(), Violation> {
        if below != NONE && above != NONE && cross(self.status.ends(below), self.status.ends(above))
        {
            return Err(Violation::Segments([below, above].map(|node| self.status.segment(node))));
        }
        Ok(())
    }

    /// A segment's ends, lexicographically ordered.
    fn ends(&self, segment: u32) -> [[f64; 2]; 2] {
        let [a, b] =
            self.linework.segments[segment as usize].map(|end| self.linework.points[end as usize]);
        if lexicographic(a, b).is_lt() { [a, b] } else { [b, a] }
    }
}

/// Whether two segments cross in one point inside both.
pub fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let separates = |a, b, c, d| {
        matches!(
            (side(a, b, c), side(a, b, d)),
            (Side::Left, Side::Right) | (Side::Right, Side::Left)
        )
    };
    separates(a, b, c, d) && separates(c, d, a, b)
}
