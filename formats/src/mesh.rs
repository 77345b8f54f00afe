//! The triangle mesh that a solver reads.

use std::borrow::Cow;

use crate::pslg::{Group, Membership, Tag};

/// A triangle mesh with boundary and region tags.
///
/// All arrays are flat and zero-based. A mesh that meshwright makes uses every point, and its
/// edges are the subsegments of the outline: its boundary and its interfaces.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Coordinates `[x, y]`: the outline's points in their order, then the Steiner points in the
    /// order in which they were committed.
    pub points: Vec<[f64; 2]>,
    /// One marker per point (a point on a segment inherits the segment's tag), or empty.
    pub point_markers: Vec<Tag>,
    /// How each point came to be, or empty where that is not known (a mesh read from a file that
    /// does not hold it).
    pub provenance: Vec<Provenance>,
    /// Triangles as indices into [`Mesh::points`], counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// The region tag of each triangle; 0 where no region seed reaches.
    pub triangle_tags: Vec<Tag>,
    /// Boundary and interface edges as indices into [`Mesh::points`].
    pub edges: Vec<[u32; 2]>,
    /// The boundary tag of each edge: that of the segment it is a part of.
    pub edge_tags: Vec<Tag>,
    /// The (zero-based) input segment that each edge is a part of, `u32::MAX` where it belongs to
    /// none (an edge of the convex hull that the outline lacks); empty where that is not known.
    pub edge_segments: Vec<u32>,
    /// Names of boundary and region tags.
    pub groups: Vec<Group>,
    /// Groups of single points, and further groups of edges that are in more than one.
    pub memberships: Vec<Membership>,
    /// Named data, one tuple per point.
    pub point_data: Vec<Data>,
    /// Named data, one tuple per triangle.
    pub triangle_data: Vec<Data>,
}

impl Mesh {
    /// The tag of an edge; 0 where [`Mesh::edge_tags`] does not reach.
    #[must_use]
    pub fn edge_tag(&self, edge: usize) -> Tag {
        self.edge_tags.get(edge).copied().unwrap_or(0)
    }

    /// The tag of a triangle; 0 where [`Mesh::triangle_tags`] does not reach.
    #[must_use]
    pub fn triangle_tag(&self, triangle: usize) -> Tag {
        self.triangle_tags.get(triangle).copied().unwrap_or(0)
    }
}

impl From<Mesh> for Cow<'_, Mesh> {
    fn from(mesh: Mesh) -> Self {
        Self::Owned(mesh)
    }
}

impl<'m> From<&'m Mesh> for Cow<'m, Mesh> {
    fn from(mesh: &'m Mesh) -> Self {
        Self::Borrowed(mesh)
    }
}

/// How a point of a mesh came to be (*When and Why*, §§3, 10).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Provenance {
    /// A point of the outline.
    Input = 0,
    /// A point on a segment that the analysis treats as input: §10's "off-center".
    Shell = 1,
    /// The midpoint of a subsegment.
    Midpoint = 2,
    /// A Steiner point inside: a circumcenter, or an off-center in Üngör's sense.
    Circumcenter = 3,
}

/// A named array of numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Data {
    /// The array's name in the file.
    pub name: String,
    /// How many numbers belong to one point or triangle.
    pub components: usize,
    /// The numbers, tuple after tuple.
    pub values: Values,
}

/// The numbers of a [`Data`] array.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Floating-point numbers.
    Real(Vec<f64>),
    /// Whole numbers.
    Integer(Vec<i64>),
}

impl Values {
    /// Whether real numbers hold all of them to the last digit.
    pub(crate) fn are_real_numbers(&self) -> bool {
        const LARGEST: u64 = 1 << 53;
        match self {
            Self::Real(_) => true,
            Self::Integer(values) => values.iter().all(|value| {
                value.unsigned_abs() <= LARGEST || (*value as f64) as i128 == i128::from(*value)
            }),
        }
    }
}
