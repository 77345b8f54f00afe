//! Bounds on the area of triangles that hold in a part of the plane only.
//!
//! They are a fixed function of the place, bounded from below by the smallest of them, so the
//! trigger keeps every promise (ALGORITHM §6).

use std::ops::ControlFlow;

use crate::boxes::{Boxes, Rectangle};
use crate::formats::LocalArea;
use crate::predicates::{Side, side};

/// Triangles in the plane, each with the largest area of what has its centroid in it.
#[derive(Debug, Clone)]
pub struct LocalAreas {
    areas: Vec<LocalArea>,
    boxes: Boxes,
    least: f64,
}

impl LocalAreas {
    /// The bounds, if there are any.
    #[must_use]
    pub fn new(areas: &[LocalArea]) -> Option<Self> {
        let around = |LocalArea { corners: [a, b, c], .. }: &LocalArea| {
            Rectangle::around(*a, *b).union(Rectangle::around(*b, *c))
        };
        let rectangles: Vec<Rectangle> = areas.iter().map(around).collect();
        let least = areas.iter().map(|area| area.max_area).reduce(f64::min)?;
        Some(Self { areas: areas.to_vec(), boxes: Boxes::new(&rectangles), least })
    }

    /// The smallest of the bounds.
    #[must_use]
    pub fn least(&self) -> f64 {
        self.least
    }

    /// The bound at a place; infinite where there is none.
    #[must_use]
    pub fn at(&self, place: [f64; 2]) -> f64 {
        let mut bound = f64::INFINITY;
        let visited: ControlFlow<()> =
            self.boxes.overlapping(&Rectangle::around(place, place), |item| {
                let LocalArea { corners, max_area } = self.areas[item as usize];
                if max_area < bound && holds(corners, place) {
                    bound = max_area;
                }
                ControlFlow::Continue(())
            });
        debug_assert!(visited.is_continue());
        bound
    }
}

/// Whether a place lies in a triangle or on its boundary, whichever way it turns.
fn holds([a, b, c]: [[f64; 2]; 3], place: [f64; 2]) -> bool {
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| side(from, to, place));
    !(sides.contains(&Side::Left) && sides.contains(&Side::Right))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_holds_in_its_triangle_and_the_smaller_one_where_two_meet() {
        let left = LocalArea { corners: [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], max_area: 0.5 };
        let right = LocalArea { corners: [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]], max_area: 0.25 };
        let areas = LocalAreas::new(&[left, right]).expect("two of them");
        assert_eq!(areas.least(), 0.25);
        assert_eq!([0.25, 0.5, 0.75].map(|x| areas.at([x, x])), [0.5, 0.25, 0.25]);
        assert_eq!(areas.at([2.0, 2.0]), f64::INFINITY);
        assert!(LocalAreas::new(&[]).is_none());
    }
}
