//! How the points of a mesh came to be.

pub use crate::formats::Provenance as Kind;

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

/// The provenance of every vertex, in one word each.
#[derive(Debug, Clone, Default)]
pub struct Provenances {
    /// 0 for a point that splits no segment; else its place in `segment_points`, plus one.
    places: Vec<u32>,
    segment_points: Vec<SegmentPoint>,
    inputs: u32,
}

impl Provenances {
    /// The provenances of the first `vertices`, of which `inputs` are the points of a domain; others
    /// behind them are no points of the mesh.
    #[must_use]
    pub fn of_inputs(inputs: usize, vertices: usize) -> Self {
        Self { places: vec![0; vertices], segment_points: Vec::new(), inputs: inputs as u32 }
    }

    /// How many vertices are points of the domain: the first ones.
    #[must_use]
    pub fn inputs(&self) -> u32 {
        self.inputs
    }

    /// Notes a committed Steiner point.
    pub fn push_steiner_point(&mut self) {
        self.places.push(0);
    }

    /// Notes a committed point that splits a segment.
    pub fn push_segment_point(&mut self, point: SegmentPoint) {
        self.segment_points.push(point);
        self.places.push(self.segment_points.len() as u32);
    }

    /// The segment that the vertex splits, and where; `None` for points of the domain and for
    /// Steiner points inside.
    #[inline]
    #[must_use]
    pub fn segment_point(&self, vertex: u32) -> Option<&SegmentPoint> {
        match self.places[vertex as usize] {
            0 => None,
            place => Some(&self.segment_points[place as usize - 1]),
        }
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
        vertex >= self.inputs && self.places.get(vertex as usize) == Some(&0)
    }

    /// Forgets the Steiner points behind the first `vertices`.
    pub(super) fn truncate(&mut self, vertices: usize) {
        self.places.truncate(vertices);
    }

    /// Forgets Steiner points; those that stay keep their order.
    pub(super) fn retain(&mut self, stays: impl Fn(u32) -> bool) {
        let mut vertices = 0..;
        self.places.retain(|_| vertices.next().is_some_and(&stays));
    }

    /// The kind of a vertex.
    #[must_use]
    pub fn kind(&self, vertex: u32) -> Kind {
        match self.segment_point(vertex) {
            _ if self.is_input(vertex) => Kind::Input,
            None => Kind::Circumcenter,
            Some(point) => point.kind,
        }
    }
}
