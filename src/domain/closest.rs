//! The finest detail of an outline: its closest pair of features that have no point in common.

use super::Domain;
use super::adjoining::other_end;
use super::boxes::{Boxes, Rectangle};
use crate::vector::Vector;

/// The search for the closest pair gives up after this many nodes of the tree for each point, on
/// average. Outlines need about 50.
const MOST_VISITS_PER_POINT: usize = 1000;

/// A point and the nearest feature that does not contain it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosestPair {
    /// The point.
    pub point: u32,
    /// The feature: a segment if the nearest place lies inside it, else a point.
    pub feature: Feature,
    /// Their distance, in the units of the outline.
    pub distance: f64,
}

/// A feature of a domain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// A point.
    Point(u32),
    /// A segment.
    Segment(u32),
}

impl Domain {
    /// The closest pair of a point and a feature that does not contain it; of equally close ones
    /// the first. Twice the least local feature size that a point has. `None` where the search
    /// takes too long, as in a star of many spokes of unequal length.
    #[must_use]
    pub fn closest_pair(&self) -> Option<ClosestPair> {
        let features = Features::new(self);
        let mut budget = MOST_VISITS_PER_POINT * self.points.len();
        let mut closest: Option<(u32, u32, f64)> = None;
        for point in 0..self.points.len() as u32 {
            let bound = closest.map_or(f64::INFINITY, |(_, _, squared)| squared);
            if let Some((item, squared)) = features.nearest(point, bound, &mut budget) {
                closest = Some((point, item, squared));
            }
        }
        closest.filter(|_| budget > 0).map(|(point, item, squared)| ClosestPair {
            point,
            feature: features.distance_squared(point, item).1,
            distance: libm::scalbn(libm::sqrt(squared), self.scale_exponent),
        })
    }
}

/// All segments, then all isolated points, findable by place.
struct Features<'a> {
    domain: &'a Domain,
    isolated: Vec<u32>,
    boxes: Boxes,
}

impl<'a> Features<'a> {
    fn new(domain: &'a Domain) -> Self {
        let isolated: Vec<u32> = (0..domain.points.len() as u32)
            .filter(|&point| domain.adjoining(point).is_empty())
            .collect();
        let place = |point: u32| domain.points[point as usize];
        let segments = domain.segments.iter().map(|&[a, b]| Rectangle::around(place(a), place(b)));
        let points = isolated.iter().map(|&point| Rectangle::around(place(point), place(point)));
        let rectangles: Vec<_> = segments.chain(points).collect();
        let boxes = Boxes::new(&rectangles);
        Self { domain, isolated, boxes }
    }

    /// The nearest item that does not contain a point, and their squared distance.
    fn nearest(&self, point: u32, bound: f64, budget: &mut usize) -> Option<(u32, f64)> {
        let place = self.domain.points[point as usize];
        self.boxes.nearest(place, bound, budget, |item| self.distance_squared(point, item).0)
    }

    /// The squared distance between a point and an item, and the part of the item that is nearest.
    /// Of a segment that ends at the point, that is the other end.
    fn distance_squared(&self, point: u32, item: u32) -> (f64, Feature) {
        let to_point = |other: u32| {
            let between = Vector::between(
                self.domain.points[point as usize],
                self.domain.points[other as usize],
            );
            (between.dot(between), Feature::Point(other))
        };
        let Some(&ends) = self.domain.segments.get(item as usize) else {
            let other = self.isolated[item as usize - self.domain.segments.len()];
            return if other == point {
                (f64::INFINITY, Feature::Point(other))
            } else {
                to_point(other)
            };
        };
        if ends.contains(&point) {
            return to_point(other_end(ends, point));
        }
        let [p, a, b] = [point, ends[0], ends[1]].map(|point| self.domain.points[point as usize]);
        let (along, to_a, to_b) =
            (Vector::between(a, b), Vector::between(a, p), Vector::between(b, p));
        if along.dot(to_a) <= 0.0 {
            to_point(ends[0])
        } else if along.dot(to_b) >= 0.0 {
            to_point(ends[1])
        } else {
            let height = along.cross(to_a) / along.length();
            (height * height, Feature::Segment(item))
        }
    }
}
