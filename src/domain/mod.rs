//! Assumption 1: from an outline to a domain that may be refined.

/// A PSLG for which Assumption 1 holds exactly, in the coordinates that the refinement works in.
///
/// Every array is zero-based and in the order of the outline; "input" indices are those of the
/// [`Pslg`](crate::Pslg) it was made from.
#[derive(Debug, Clone)]
pub struct Domain {
    /// Distinct points, scaled by 2^−[`scale_exponent`](Domain::scale_exponent).
    pub points: Vec<[f64; 2]>,
    /// The input point that each point is (the first of those that were merged).
    pub input_points: Vec<u32>,
    /// Distinct segments as indices into [`Domain::points`]; then, where the convex hull is
    /// meshed, the hull edges that are not segments yet.
    pub segments: Vec<[u32; 2]>,
    /// The input segment that each segment is; `u32::MAX` for a hull edge that the outline lacks.
    pub input_segments: Vec<u32>,
    /// Boundary tag of each segment (0: untagged).
    pub segment_tags: Vec<i32>,
    /// Hole seeds, scaled.
    pub holes: Vec<[f64; 2]>,
    /// Region seeds, scaled (areas too).
    pub regions: Vec<crate::formats::Region>,
    /// Input coordinates = these coordinates × 2^`scale_exponent`; 0 unless the outline's
    /// largest coordinate has an exponent outside ±100.
    pub scale_exponent: i32,
    /// Whether the whole convex hull is meshed: asked for, or there is no segment at all.
    pub hull: bool,
    /// For each point, the segments that end there, counter-clockwise: those of point `p` are
    /// `adjoining[adjoining_start[p]..adjoining_start[p + 1]]`.
    pub adjoining_start: Vec<u32>,
    /// See [`Domain::adjoining_start`].
    pub adjoining: Vec<u32>,
}
