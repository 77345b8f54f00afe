//! The planar straight-line graph (PSLG) that an outline file holds.

/// A number that the user gave to a segment (boundary tag), a region or a point (marker).
///
/// Zero means *untagged*, as in Triangle's files. Negative tags are legal; a format that forbids
/// them maps them and says so.
pub type Tag = i32;

/// An outline as its file gives it: nothing merged, nothing repaired, nothing checked beyond
/// "every index is in range and every number is finite".
///
/// All arrays are flat and zero-based. Coordinates carry no units.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Pslg {
    /// Coordinates `[x, y]`, in the order of the file. Finite.
    pub points: Vec<[f64; 2]>,
    /// One marker per point, or empty where the file has none.
    pub point_markers: Vec<Tag>,
    /// Named attributes of the points; each holds one value per point.
    pub point_attributes: Vec<Attribute>,
    /// One target size per point (a length, in the units of the coordinates; `f64::INFINITY`
    /// where there is none), or empty.
    pub point_sizes: Vec<f64>,
    /// Segments as pairs of indices into [`Pslg::points`].
    pub segments: Vec<[u32; 2]>,
    /// The boundary tag of each segment; as long as [`Pslg::segments`].
    pub segment_tags: Vec<Tag>,
    /// Which of the faces that the segments enclose are meshed.
    pub enclosed: Enclosed,
    /// A seed point in each hole.
    pub holes: Vec<[f64; 2]>,
    /// Regions, each given by a seed point.
    pub regions: Vec<Region>,
    /// Largest areas of triangles that hold in a part of the plane only.
    pub local_areas: Vec<LocalArea>,
    /// Names of boundary and region tags.
    pub groups: Vec<Group>,
    /// Groups of single points, and further groups of segments that are in more than one.
    pub memberships: Vec<Membership>,
    /// Where each item stands in the file, for messages.
    pub source: Source,
}

/// Which of the faces that segments enclose are meshed, before hole seeds take any out.
///
/// It does not count where the whole convex hull is meshed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Enclosed {
    /// All of them, as in Triangle's files.
    #[default]
    All,
    /// By nesting: what lies in a loop is meshed, a loop within it is a hole, a loop within that
    /// is meshed again. Where faces share borders they are the parts of one whole: all of them
    /// are meshed, or none.
    EvenOdd,
    /// Those that hold the seed of a region.
    Seeded,
}

/// A named number that each point carries, e.g. a depth.
#[derive(Debug, Clone, PartialEq)]
pub struct Attribute {
    /// The attribute's name; files that name none give `attribute_1`, `attribute_2`, …
    pub name: String,
    /// One value per point.
    pub values: Vec<f64>,
}

/// A region: everything that can be reached from `seed` without crossing a segment.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// A point inside the region.
    pub seed: [f64; 2],
    /// The region's number; Triangle's regional attribute where that is an integer.
    pub tag: Tag,
    /// The regional attribute as the file gives it.
    pub attribute: f64,
    /// No triangle of the region may be larger than this area; `None` if the file sets no bound.
    pub max_area: Option<f64>,
}

/// A bound on the area of the triangles whose centroid lies in a triangle of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalArea {
    /// The corners of that triangle, whichever way it turns.
    pub corners: [[f64; 2]; 3],
    /// The bound; positive.
    pub max_area: f64,
}

/// A group that a point is in, or that a segment (in a mesh: an edge) is in besides the one of its
/// tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Membership {
    /// 0 for a point, 1 for a segment or an edge.
    pub dim: u8,
    /// The (zero-based) index of the point, the segment or the edge.
    pub item: u32,
    /// The number of the group.
    pub tag: Tag,
}

/// A name for a tag in one dimension (a physical group, in Gmsh's words).
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Group {
    /// 0 for points, 1 for segments and edges, 2 for regions and triangles.
    pub dim: u8,
    /// The number of the group.
    pub tag: Tag,
    /// The name that the user gave it.
    pub name: String,
}

/// Where the items of a [`Pslg`] stand in its file, so that messages can use the file's own
/// numbers and lines. Every table is empty where a PSLG was not read from a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Source {
    /// The file that holds the segments, as the user named it; empty without a file.
    pub file: String,
    /// The file that holds the points, where that is another one (`.node` beside a `.poly`).
    pub point_file: Option<String>,
    /// The number that the file gives to the first point and the first segment (0 or 1).
    pub first_number: u32,
    /// The line (one-based) of each point.
    pub point_lines: Vec<u32>,
    /// The line (one-based) of each segment.
    pub segment_lines: Vec<u32>,
    /// The line (one-based) of each hole seed.
    pub hole_lines: Vec<u32>,
    /// The line (one-based) of each region seed.
    pub region_lines: Vec<u32>,
    /// The file's own number of each segment, where those do not simply count up from
    /// [`Source::first_number`]; else empty.
    pub segment_numbers: Vec<i64>,
    /// The file's own number of each point, where those do not simply count up; else empty.
    pub point_numbers: Vec<i64>,
    /// The last line (one-based) that holds a point or a segment, where nothing in the file says
    /// how many there are: only so can it be seen that a file was cut off.
    pub last_line: Option<u32>,
}

impl Source {
    /// The number by which the file knows the point with this (zero-based) index.
    #[must_use]
    pub fn point_number(&self, index: u32) -> i64 {
        number(&self.point_numbers, self.first_number, index)
    }

    /// The number by which the file knows the segment with this (zero-based) index.
    #[must_use]
    pub fn segment_number(&self, index: u32) -> i64 {
        number(&self.segment_numbers, self.first_number, index)
    }
}

fn number(table: &[i64], first: u32, index: u32) -> i64 {
    let counted = i64::from(first) + i64::from(index);
    table.get(index as usize).copied().unwrap_or(counted)
}
