//! Where segments cross, touch or overlap.

use std::fmt;

use super::error::{Item, Kind, Quoted};
use super::sweep::{Linework, Violation};
use crate::Pslg;

/// A violation of Assumption 1 (ii) or (iii), both culprits named.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    /// The culprits.
    pub items: [Item; 2],
    /// A place where they meet, rounded, in the coordinates of the outline.
    pub place: [f64; 2],
}

/// All places where the linework violates Assumption 1 (ii) or (iii).
#[derive(Debug, Clone, PartialEq)]
pub struct Conflicts {
    /// The first of them.
    pub first: Vec<Conflict>,
}

impl fmt::Display for Conflicts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Conflict {
            items: [a, b],
            place: [x, y],
        } in &self.first
        {
            write!(f, "{a} and {b} meet near ({x}, {y}){}", Quoted(&[a, b]))?;
        }
        Ok(())
    }
}

/// Names a violation.
pub fn conflicts(
    pslg: &Pslg,
    linework: &Linework,
    inputs: [&[u32]; 2],
    violation: Violation,
) -> Conflicts {
    let [input_points, input_segments] = inputs;
    let segment = |s: u32| Item::new(pslg, Kind::Segment, input_segments[s as usize]);
    let (items, place) = match violation {
        Violation::PointOnSegment { point, segment: s } => (
            [
                Item::new(pslg, Kind::Point, input_points[point as usize]),
                segment(s),
            ],
            linework.points[point as usize],
        ),
        Violation::Segments([s, t]) => (
            [segment(s), segment(t)],
            linework.points[linework.segments[s as usize][0] as usize],
        ),
    };
    Conflicts {
        first: vec![Conflict { items, place }],
    }
}
