//! Definition 1: the local feature size.
//!
//! Two features (points and segments of the outline) are disjoint where they have no point in
//! common. Under Assumption 1 that is a question of their ends alone, and a handful of features
//! tells whether a ball meets two disjoint ones: either all that it meets share a point, or they
//! are the sides of one triangle.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::Domain;
use crate::boxes::{Below, Boxes, Node, Rectangle};
use crate::vector::Vector;

impl Domain {
    /// lfs: the local feature size at a place (Definition 1), that is the least radius of a closed
    /// ball around it that meets two disjoint features of the outline; hull edges that are meshed
    /// are features too. The place is in the coordinates of [`Domain::points`], and so is the
    /// answer: infinite for a place that is not finite.
    ///
    /// The first question builds an index of the features (n log n), which is kept: the domain's
    /// points and segments must not change after it.
    ///
    /// ```
    /// use meshwright::domain::Domain;
    /// use meshwright::{Pslg, Region};
    /// let square = Pslg {
    ///     points: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]],
    ///     segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
    ///     segment_tags: vec![0; 4],
    ///     ..Pslg::default()
    /// };
    /// let (domain, _) = Domain::new(&square, Region::Domain)?;
    /// assert_eq!(domain.lfs([2.0, 2.0]), 2.0); // two opposite sides
    /// assert_eq!(domain.lfs([0.0, 0.0]), 4.0); // the corner and the sides across
    /// assert_eq!(domain.lfs_min(), Some(2.0));
    /// # Ok::<(), meshwright::domain::Error>(())
    /// ```
    #[must_use]
    pub fn lfs(&self, place: [f64; 2]) -> f64 {
        if !place.iter().all(|x| x.is_finite()) {
            return f64::INFINITY;
        }
        libm::sqrt(self.features().lfs_squared(self, place))
    }

    /// lfs_min: the least local feature size, half the least distance of a point and a feature
    /// that does not contain it. In the coordinates of [`Domain::points`]; half the distance of
    /// [`Domain::closest_pair`], and `None` where that is.
    #[must_use]
    pub fn lfs_min(&self) -> Option<f64> {
        self.closest().map(|(_, _, squared)| 0.5 * libm::sqrt(squared))
    }

    /// Whether two disjoint features lie within `radius` of a place, both in the coordinates of
    /// [`Domain::points`]: whether [`lfs`](Domain::lfs)`(place) <= radius`, up to the rounding of
    /// a square root, but found at the first such pair and so faster by far.
    #[must_use]
    pub fn has_two_features_within(&self, place: [f64; 2], radius: f64) -> bool {
        place.iter().all(|x| x.is_finite())
            && radius >= 0.0
            && self.features().has_two_within(self, place, radius * radius, Met::default())
    }

    /// The index of the features, built when it is first asked for.
    pub(super) fn features(&self) -> &Features {
        self.features.get_or_init(|| Features::new(self))
    }

    /// The squared distance of a place from a point.
    pub(super) fn point_distance_squared(&self, place: [f64; 2], point: u32) -> f64 {
        let between = Vector::between(place, self.points[point as usize]);
        between.dot(between)
    }

    /// The squared distance of a place from a segment, and the end that is nearest where it is
    /// not the inside.
    pub(super) fn segment_distance_squared(
        &self,
        place: [f64; 2],
        segment: u32,
    ) -> (f64, Option<u32>) {
        let ends = self.segments[segment as usize];
        let [a, b] = ends.map(|end| self.points[end as usize]);
        let (along, to_a, to_b) =
            (Vector::between(a, b), Vector::between(a, place), Vector::between(b, place));
        if along.dot(to_a) <= 0.0 {
            (to_a.dot(to_a), Some(ends[0]))
        } else if along.dot(to_b) >= 0.0 {
            (to_b.dot(to_b), Some(ends[1]))
        } else {
            let height = along.cross(to_a) / along.length();
            (height * height, None)
        }
    }
}

/// The features of a domain, findable by place.
#[derive(Debug, Clone)]
pub struct Features {
    /// All points.
    pub points: Boxes,
    /// All segments.
    pub segments: Boxes,
    /// The points that all segments of a node of [`Features::segments`] end at: the spokes of one
    /// star need not be looked at one by one. (No number is a point's: there is none.)
    common: Vec<[u32; 2]>,
    /// The segments as pairs of ends, the smaller first, sorted.
    joined: Vec<[u32; 2]>,
}

/// No point.
const NONE: u32 = u32::MAX;

impl Features {
    fn new(domain: &Domain) -> Self {
        let place = |point: u32| domain.points[point as usize];
        let points: Vec<_> = domain.points.iter().map(|&p| Rectangle::around(p, p)).collect();
        let segments: Vec<_> =
            domain.segments.iter().map(|&[a, b]| Rectangle::around(place(a), place(b))).collect();
        let segments = Boxes::new(&segments);
        let common = segments.in_common(
            |segment| domain.segments[segment as usize],
            |a, b| a.map(|end| if b.contains(&end) { end } else { NONE }),
        );
        let mut joined: Vec<_> =
            domain.segments.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        joined.sort_unstable();
        Self { points: Boxes::new(&points), segments, common, joined }
    }

    /// Whether all segments of a node end at `point`.
    fn all_end_at(&self, node: Node, point: u32) -> bool {
        self.common[node.index].contains(&point)
    }

    /// Whether all segments of a node end at `point`, or all at one neighbour of it.
    pub fn all_adjoin(&self, node: Node, point: u32) -> bool {
        self.common[node.index].iter().any(|&end| {
            let pair = [point.min(end), point.max(end)];
            end == point || (end != NONE && self.joined.binary_search(&pair).is_ok())
        })
    }

    /// Whether two disjoint features lie in the ball, of which some are `met` already.
    fn has_two_within(
        &self,
        domain: &Domain,
        place: [f64; 2],
        radius_squared: f64,
        mut met: Met,
    ) -> bool {
        for kind in [Kind::Point, Kind::Segment] {
            let tree = self.tree(kind);
            let mut pending: Vec<Node> = tree.root().into_iter().collect();
            while let Some(node) = pending.pop() {
                if tree.rectangle(node).distance_squared(place) > radius_squared
                    || self.is_settled(&met, kind, node)
                {
                    continue;
                }
                match tree.below(node) {
                    Below::Halves(halves) => pending.extend(halves),
                    Below::Item(item) => {
                        let (squared, feature) = kind.feature(domain, place, item);
                        if squared <= radius_squared && met.meets_disjoint(feature) {
                            return true;
                        }
                    }
                }
            }
        }
        false
    }

    fn tree(&self, kind: Kind) -> &Boxes {
        match kind {
            Kind::Point => &self.points,
            Kind::Segment => &self.segments,
        }
    }

    /// Whether the features of a node can tell nothing new: segments that end where all features
    /// met do.
    fn is_settled(&self, met: &Met, kind: Kind, node: Node) -> bool {
        kind == Kind::Segment && met.center.is_some_and(|center| self.all_end_at(node, center))
    }

    /// The nearest point of the outline, unless two disjoint features lie as near: with it the
    /// segments that end there need not be looked at, however many pass nearer.
    fn met_with_nearest_point(&self, domain: &Domain, place: [f64; 2]) -> Met {
        let squared = |point| domain.point_distance_squared(place, point);
        let mut budget = usize::MAX;
        let nearest = self.points.nearest(place, f64::INFINITY, &mut budget, |_| false, squared);
        let Some((point, squared)) = nearest else { return Met::default() };
        let met = Met { first: vec![[point, point]], center: Some(point) };
        if self.has_two_within(domain, place, squared, met.clone()) { Met::default() } else { met }
    }

    /// The squared distance of the first feature, by increasing distance, that is disjoint from
    /// one before it.
    fn lfs_squared(&self, domain: &Domain, place: [f64; 2]) -> f64 {
        let key = |squared: f64| squared.to_bits(); // in order, as no square is negative
        let part = |kind, node| {
            let squared = self.tree(kind).rectangle(node).distance_squared(place);
            Reverse((key(squared), Next::Part(kind, node)))
        };
        let mut nearest = BinaryHeap::new();
        for kind in [Kind::Point, Kind::Segment] {
            nearest.extend(self.tree(kind).root().map(|root| part(kind, root)));
        }
        let mut met = self.met_with_nearest_point(domain, place);
        while let Some(Reverse((squared, next))) = nearest.pop() {
            match next {
                Next::Feature(feature) => {
                    if met.meets_disjoint(feature) {
                        return f64::from_bits(squared);
                    }
                }
                Next::Part(kind, node) if self.is_settled(&met, kind, node) => {}
                Next::Part(kind, node) => match self.tree(kind).below(node) {
                    Below::Halves(halves) => nearest.extend(halves.map(|half| part(kind, half))),
                    Below::Item(item) => {
                        let (squared, feature) = kind.feature(domain, place, item);
                        nearest.push(Reverse((key(squared), Next::Feature(feature))));
                    }
                },
            }
        }
        f64::INFINITY
    }
}

/// Which of the two trees.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Point,
    Segment,
}

impl Kind {
    /// An item of the tree: its squared distance from a place, and its ends.
    fn feature(self, domain: &Domain, place: [f64; 2], item: u32) -> (f64, [u32; 2]) {
        match self {
            Self::Point => (domain.point_distance_squared(place, item), [item, item]),
            Self::Segment => {
                let (squared, _) = domain.segment_distance_squared(place, item);
                (squared, domain.segments[item as usize])
            }
        }
    }
}

/// What a search by increasing distance comes to next.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Next {
    /// A feature, by its ends.
    Feature([u32; 2]),
    /// A part of one of the two trees.
    Part(Kind, Node),
}

/// The features that a ball meets, as long as no two of them are disjoint. A feature is given by
/// its ends, a point is both of its ends.
///
/// Three distinct features stand for all: they are the sides of a triangle, which nothing else
/// meets without being disjoint from a side, or they have one point in common, which every other
/// feature that meets all three has too.
#[derive(Clone, Default)]
struct Met {
    first: Vec<[u32; 2]>,
    /// The one point that all features have, once it is known.
    center: Option<u32>,
}

impl Met {
    /// Takes one more feature in, unless it is disjoint from one before: then true.
    fn meets_disjoint(&mut self, feature: [u32; 2]) -> bool {
        let shares = |other: &[u32; 2]| other.contains(&feature[0]) || other.contains(&feature[1]);
        if !self.first.iter().all(shares) {
            return true;
        }
        if self.first.len() < 3 && !self.first.contains(&feature) {
            self.first.push(feature);
            self.center = self.only_common_point();
        }
        false
    }

    fn only_common_point(&self) -> Option<u32> {
        let (&one, others) = self.first.split_first()?;
        let is_common = |end: &u32| others.iter().all(|other| other.contains(end));
        let point = |&[a, b]: &[u32; 2]| (a == b).then_some(a);
        let known = || one.into_iter().find(is_common).filter(|_| self.first.len() == 3);
        self.first.iter().find_map(point).or_else(known)
    }
}
