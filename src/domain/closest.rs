//! The finest detail of an outline: its closest pair of features that have no point in common.
//!
//! A point and a segment that does not adjoin any of the point's are found by the index of
//! features. At a common end x of segments, the nearest to a point at distance d from x are, on
//! either side, the first that is at least as long as d: so a star of many spokes takes no longer
//! than others.

use super::Domain;
use super::adjoining::other_end;

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
    /// that of the first point. Twice [`lfs_min`](Domain::lfs_min). `None` where the search takes
    /// too long, as where thousands of long segments lie across each other's boxes.
    #[must_use]
    pub fn closest_pair(&self) -> Option<ClosestPair> {
        self.closest().map(|(point, feature, squared)| ClosestPair {
            point,
            feature,
            distance: libm::scalbn(libm::sqrt(squared), self.scale_exponent),
        })
    }

    /// The closest pair and its squared distance, scaled.
    pub(super) fn closest(&self) -> Option<(u32, Feature, f64)> {
        let mut closest = Closest { domain: self, found: None };
        let mut budget = MOST_VISITS_PER_POINT * self.points.len();
        for point in 0..self.points.len() as u32 {
            closest.search_near(point, &mut budget);
        }
        for apex in 0..self.points.len() as u32 {
            closest.search_around(apex);
        }
        closest.found.filter(|_| budget > 0)
    }
}

/// The closest pair so far.
struct Closest<'a> {
    domain: &'a Domain,
    found: Option<(u32, Feature, f64)>,
}

impl Closest<'_> {
    /// The other points, and the segments that do not adjoin those of `point`.
    fn search_near(&mut self, point: u32, budget: &mut usize) {
        let (domain, features) = (self.domain, self.domain.features());
        let place = domain.points[point as usize];
        let to_point = |other| {
            if other == point { f64::INFINITY } else { domain.point_distance_squared(place, other) }
        };
        let nearest = features.points.nearest(place, self.bound(), budget, |_| false, to_point);
        if let Some((other, squared)) = nearest {
            self.found = Some((point, Feature::Point(other), squared));
        }
        let nearest = features.segments.nearest(
            place,
            self.bound(),
            budget,
            |node| features.all_adjoin(node, point),
            |segment| domain.segment_distance_squared(place, segment).0,
        );
        if let Some((segment, _)) = nearest {
            self.take(point, segment);
        }
    }

    /// The far end of each segment at `apex`, and on either side the next segment there that is at
    /// least as long.
    ///
    /// What lies between is shorter: the distance of its own far end from this segment is smaller,
    /// or that far end is what is nearest, which is a point.
    fn search_around(&mut self, apex: u32) {
        let domain = self.domain;
        let spokes = domain.adjoining(apex);
        let far_end = |s: usize| other_end(domain.segments[spokes[s] as usize], apex);
        let squared_length: Vec<f64> = (0..spokes.len())
            .map(|s| domain.point_distance_squared(domain.points[apex as usize], far_end(s)))
            .collect();
        let (once, back) = (0..spokes.len(), (0..spokes.len()).rev());
        let ways: [Vec<usize>; 2] =
            [once.clone().chain(once).collect(), back.clone().chain(back).collect()];
        for way in ways {
            // Those that have not come to one as long as they are: from the longest down.
            let mut waiting: Vec<usize> = Vec::new();
            for next in way {
                while let Some(&shorter) = waiting.last()
                    && squared_length[shorter] <= squared_length[next]
                {
                    waiting.pop();
                    if shorter != next {
                        self.take(far_end(shorter), spokes[next]);
                    }
                }
                waiting.push(next);
            }
        }
    }

    fn bound(&self) -> f64 {
        self.found.map_or(f64::INFINITY, |(_, _, squared)| squared)
    }

    /// Takes a pair, if it is the closest so far.
    fn take(&mut self, point: u32, segment: u32) {
        let place = self.domain.points[point as usize];
        let (squared, end) = self.domain.segment_distance_squared(place, segment);
        let is_first = |(first, _, least): (u32, _, f64)| {
            squared < least || (squared == least && point < first)
        };
        if self.found.is_none_or(is_first) {
            let feature = end.map_or(Feature::Segment(segment), Feature::Point);
            self.found = Some((point, feature, squared));
        }
    }
}
