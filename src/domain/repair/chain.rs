//! A segment as the chain of pieces that its mending makes of it.
//!
//! Every point that splits a piece lies in the smallest rectangle around it. So x and y each run
//! one way along a chain, its pieces have nothing but ends in common, and the rectangle around the
//! segment holds the chain for ever. And |dx| + |dy| of a piece is the sum of those of its parts:
//! as there are finitely many doubles, splitting comes to an end whatever is split where.

use std::cmp::Ordering;
use std::ops::Range;

use crate::boxes::Rectangle;
use crate::columns::lexicographic;

/// So few points are looked at one by one.
const FEW: usize = 6;

/// A segment and the points that split it.
#[derive(Debug, Clone)]
pub struct Chain {
    /// The ends of the segment.
    pub ends: [u32; 2],
    /// The points between them, from the first end to the second.
    inner: Vec<u32>,
}

/// What inserting points into a chain did.
#[derive(Debug, Default)]
pub struct Inserted {
    /// The pieces of the stretches that changed.
    pub pieces: Vec<[u32; 2]>,
    /// The points that do not fit into the chain as it has become.
    pub refused: Vec<u32>,
}

impl Chain {
    /// A segment that nothing splits yet.
    pub fn new(ends: [u32; 2]) -> Self {
        Self { ends, inner: Vec::new() }
    }

    /// The pieces, from the first end to the second.
    pub fn pieces(&self) -> impl Iterator<Item = [u32; 2]> {
        (1..self.count()).map(|index| [self.point(index - 1), self.point(index)])
    }

    /// The pieces whose rectangles meet `rectangle`.
    pub fn pieces_in(
        &self,
        points: &[[f64; 2]],
        rectangle: &Rectangle,
    ) -> impl Iterator<Item = [u32; 2]> {
        let range = self.range_in(points, rectangle);
        let pieces = range.map(|index| [self.point(index), self.point(index + 1)]);
        pieces.filter(|piece| {
            let [a, b] = piece.map(|end| points[end as usize]);
            Rectangle::around(a, b).overlaps(rectangle)
        })
    }

    /// The numbers of pieces among which those are whose rectangles meet `rectangle`.
    fn range_in(&self, points: &[[f64; 2]], rectangle: &Rectangle) -> Range<usize> {
        if self.inner.len() < FEW {
            return 0..self.count() - 1;
        }
        let [a, b] = self.ends.map(|end| points[end as usize]);
        let axis = usize::from((b[1] - a[1]).abs() > (b[0] - a[0]).abs());
        let sign = if b[axis] < a[axis] { -1.0 } else { 1.0 };
        let [from, to] = if sign < 0.0 {
            [-rectangle.high[axis], -rectangle.low[axis]]
        } else {
            [rectangle.low[axis], rectangle.high[axis]]
        };
        let place = |index: usize| sign * points[self.point(index) as usize][axis];
        let first = self.partition(|index| place(index) < from).saturating_sub(1);
        let last = self.partition(|index| place(index) <= to).min(self.count() - 1);
        first..last
    }

    /// Which of two places comes first on the way along the chain.
    pub fn order(&self, points: &[[f64; 2]], p: u32, q: u32) -> Ordering {
        let [a, b] = self.ends.map(|end| points[end as usize]);
        let turned = |point: u32| {
            let place = points[point as usize];
            [0, 1].map(|k| if b[k] < a[k] { -place[k] } else { place[k] })
        };
        lexicographic(turned(p), turned(q))
    }

    /// Inserts points, which come in the order of the chain, where they lie in the rectangle
    /// around the piece that they would split.
    pub fn insert(&mut self, points: &[[f64; 2]], new: &[u32]) -> Inserted {
        let mut done = Inserted::default();
        let mut chain = vec![self.ends[0]];
        let mut new = new.iter().copied().peekable();
        for index in 1..self.count() {
            let (end, start) = (self.point(index), chain.len() - 1);
            let refused = done.refused.len();
            while let Some(point) = new.next_if(|&point| self.order(points, point, end).is_lt()) {
                let last = chain[chain.len() - 1];
                if point == last {
                    continue; // it is there already
                }
                let [a, b, place] = [last, end, point].map(|p| points[p as usize]);
                if Rectangle::around(a, b).contains(place) {
                    chain.push(point);
                } else {
                    done.refused.push(point);
                }
            }
            chain.push(end);
            if chain.len() > start + 2 || done.refused.len() > refused {
                done.pieces.extend(chain[start..].windows(2).map(|pair| [pair[0], pair[1]]));
            }
        }
        done.refused.extend(new.filter(|&point| point != self.ends[1]));
        self.inner = chain[1..chain.len() - 1].to_vec();
        done
    }

    /// How many points the chain has, its ends included.
    fn count(&self) -> usize {
        self.inner.len() + 2
    }

    fn point(&self, index: usize) -> u32 {
        match index {
            0 => self.ends[0],
            index => self.inner.get(index - 1).copied().unwrap_or(self.ends[1]),
        }
    }

    /// The number of points for which `before` holds; these come first.
    fn partition(&self, before: impl Fn(usize) -> bool) -> usize {
        let (mut low, mut high) = (0, self.count());
        while low < high {
            let middle = usize::midpoint(low, high);
            if before(middle) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    }
}
