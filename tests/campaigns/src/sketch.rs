//! An outline that grows piece by piece and stays clean.

use meshwright::Pslg;
use meshwright::formats::Region;

use crate::measure::{Located, in_conflict};
use crate::plane::{Point, distance, distance_of_segments, distance_to_segment, segments_meet};

/// An outline under construction.
///
/// [`Sketch::add`] takes a piece only if Assumption 1 still holds afterwards (decided exactly) and
/// disjoint features keep their distance: what a sketch holds is clean by construction.
#[derive(Debug, Clone)]
pub struct Sketch {
    outline: Pslg,
    used: Vec<bool>,
    margin: f64,
}

impl Sketch {
    /// An empty sketch. Two features that have no point in common will be at least `margin` times
    /// the length of the longer one apart.
    #[must_use]
    pub fn new(margin: f64) -> Self {
        Self { outline: Pslg::default(), used: Vec::new(), margin }
    }

    /// The outline so far.
    #[must_use]
    pub fn outline(&self) -> &Pslg {
        &self.outline
    }

    /// The finished outline.
    #[must_use]
    pub fn finish(self) -> Pslg {
        self.outline
    }

    /// The number that the next new point gets.
    #[must_use]
    pub fn next(&self) -> u32 {
        self.outline.points.len() as u32
    }

    /// Where a point is.
    #[must_use]
    pub fn point(&self, index: u32) -> Point {
        self.outline.points[index as usize]
    }

    /// Adds points, which get the numbers from [`Sketch::next`] on, and segments between them and
    /// older ones, all or nothing. Says whether they were added.
    pub fn add(&mut self, points: &[Point], segments: &[[u32; 2]], tag: i32) -> bool {
        let before = self.outline.points.len();
        let segments_before = self.outline.segments.len();
        self.outline.points.extend_from_slice(points);
        self.used.resize(self.outline.points.len(), false);
        let used_before = self.used.clone();
        for segment in segments {
            self.used[segment[0] as usize] = true;
            self.used[segment[1] as usize] = true;
        }
        let fits = segments.iter().all(|&segment| {
            let fits = self.segment_fits(segment);
            self.outline.segments.push(segment);
            fits
        }) && (0..self.outline.points.len()).all(|point| {
            // An older point may gain a new neighbour; a new one sees everything.
            let neighbours = if point < before { segments_before } else { 0 };
            self.used[point] || self.point_fits(point, neighbours)
        });
        if fits {
            self.outline.segment_tags.resize(self.outline.segments.len(), tag);
        } else {
            self.outline.points.truncate(before);
            self.outline.segments.truncate(segments_before);
            self.used = used_before;
            self.used.truncate(before);
        }
        fits
    }

    /// Adds a closed polygon of new points. Says whether it was added.
    pub fn add_polygon(&mut self, points: &[Point], tag: i32) -> bool {
        let first = self.next();
        let count = points.len() as u32;
        let segments: Vec<_> = (0..count).map(|i| [first + i, first + (i + 1) % count]).collect();
        self.add(points, &segments, tag)
    }

    /// Adds an open chain of new points. Says whether it was added.
    pub fn add_chain(&mut self, points: &[Point], tag: i32) -> bool {
        let first = self.next();
        let segments: Vec<_> =
            (1..points.len() as u32).map(|i| [first + i - 1, first + i]).collect();
        self.add(points, &segments, tag)
    }

    /// Adds segments from an old point to new ones. Says whether they were added.
    pub fn add_legs(&mut self, apex: u32, ends: &[Point], tag: i32) -> bool {
        let first = self.next();
        let segments: Vec<_> = (0..ends.len() as u32).map(|i| [apex, first + i]).collect();
        self.add(ends, &segments, tag)
    }

    /// Marks a hole.
    pub fn hole(&mut self, seed: Point) {
        self.outline.holes.push(seed);
    }

    /// Marks a region.
    pub fn region(&mut self, seed: Point, tag: i32, max_area: Option<f64>) {
        self.outline.regions.push(Region { seed, tag, attribute: f64::from(tag), max_area });
    }

    fn located(&self, [a, b]: [u32; 2]) -> Located {
        ([a, b], self.point(a), self.point(b))
    }

    fn segment_fits(&self, segment: [u32; 2]) -> bool {
        let new = self.located(segment);
        let ([a, b], p, q) = new;
        a != b
            && p != q
            && self.outline.segments.iter().all(|&other| {
                let old = self.located(other);
                let ([c, d], r, s) = old;
                let adjoin = a == c || a == d || b == c || b == d;
                let length = distance(p, q).max(distance(r, s));
                !in_conflict(new, old)
                    && (adjoin || distance_of_segments(p, q, r, s) >= self.margin * length)
            })
    }

    fn point_fits(&self, index: usize, first_segment: usize) -> bool {
        let x = self.outline.points[index];
        let keeps_distance = self.outline.segments[first_segment..].iter().all(|&segment| {
            let (_, p, q) = self.located(segment);
            !segments_meet(x, x, p, q)
                && distance_to_segment(x, p, q) >= self.margin * distance(p, q)
        });
        keeps_distance && self.outline.points.iter().enumerate().all(|(i, &p)| i == index || p != x)
    }
}
