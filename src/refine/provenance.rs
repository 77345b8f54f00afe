//! How the points of a mesh came to be.

pub use crate::formats::Provenance as Kind;
use crate::ranked_set::RankedSet;

/// One of the two ends of an input segment, as an index into its ends.
pub type End = u8;

/// A point that splits an input segment: where it stands and why.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SegmentPoint {
    /// The input segment.
    pub segment: u32,
    /// The distance from the end [`SegmentPoint::apex`] of the segment. Never recomputed from
    /// coordinates.
    pub distance: f64,
    /// The end of the segment that the distance counts from.
    pub apex: End,
    /// `Shell` or `Midpoint`.
    pub kind: Kind,
    /// How the distance came about.
    pub origin: Origin,
}

/// How the distance of a segment point came about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The point where the parts of the segment's two ends meet; it belongs to neither.
    Border,
    /// A rung of its apex's ladder or one of its shells: an exact number.
    Rung,
    /// The middle of a piece that no rung splits well: a rounded number.
    Middle,
}

/// The provenance of every vertex.
#[derive(Debug, Clone, Default)]
pub struct Provenances {
    /// The vertices that split segments.
    on_segments: RankedSet,
    /// What is known of each of them.
    segment_points: Vec<SegmentPoint>,
    inputs: u32,
}

impl Provenances {
    /// The provenances of the first `vertices`, of which `inputs` are the points of a domain; others
    /// behind them are no points of the mesh.
    #[must_use]
    pub fn of_inputs(inputs: usize, vertices: usize) -> Self {
        Self {
            on_segments: RankedSet::of_none(vertices),
            segment_points: Vec::new(),
            inputs: inputs as u32,
        }
    }

    /// How many vertices are points of the domain: the first ones.
    #[must_use]
    pub fn inputs(&self) -> u32 {
        self.inputs
    }

    /// How many vertices split segments.
    #[must_use]
    pub fn on_segments(&self) -> usize {
        self.on_segments.members()
    }

    /// Notes a committed Steiner point.
    pub fn push_steiner_point(&mut self) {
        self.on_segments.push(false);
    }

    /// Notes a committed point that splits a segment.
    pub fn push_segment_point(&mut self, point: SegmentPoint) {
        self.segment_points.push(point);
        self.on_segments.push(true);
    }

    /// The segment that the vertex splits, and where; `None` for points of the domain and for
    /// Steiner points inside.
    #[inline]
    #[must_use]
    pub fn segment_point(&self, vertex: u32) -> Option<&SegmentPoint> {
        self.on_segments.rank(vertex).map(|rank| &self.segment_points[rank])
    }

    /// Whether the vertex splits a segment.
    #[inline]
    #[must_use]
    pub fn splits_segment(&self, vertex: u32) -> bool {
        self.on_segments.contains(vertex)
    }

    /// Whether the vertex is a point of the domain.
    #[must_use]
    pub fn is_input(&self, vertex: u32) -> bool {
        vertex < self.inputs
    }

    /// Whether the vertex is a Steiner point inside, on no segment.
    #[inline]
    #[must_use]
    pub fn is_steiner_point(&self, vertex: u32) -> bool {
        vertex >= self.inputs && self.on_segments.has(vertex) && !self.splits_segment(vertex)
    }

    /// Forgets the Steiner points behind the first `vertices`.
    pub(super) fn truncate(&mut self, vertices: usize) {
        self.on_segments.truncate(vertices);
    }

    /// Forgets Steiner points; those that stay keep their order.
    pub(super) fn retain(&mut self, stays: impl Fn(u32) -> bool) {
        self.on_segments.retain(stays);
    }

    /// The kind of a vertex.
    #[must_use]
    pub fn kind(&self, vertex: u32) -> Kind {
        if self.is_input(vertex) {
            return Kind::Input;
        }
        self.segment_point(vertex).map_or(Kind::Circumcenter, |point| point.kind)
    }
}
