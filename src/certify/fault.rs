//! What can be wrong with a mesh, and how it is told.

use std::fmt;

use super::wording::{Significant, degrees};
use crate::formats::Mesh;

/// One thing that is wrong, with the witness: what it is about, and where.
///
/// Indices are zero-based; [`Fault::place`] is in the coordinates of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// What is wrong.
    pub kind: FaultKind,
    /// The place: the middle of the triangle or edge, or the point.
    pub place: [f64; 2],
    /// A triangle, as index into [`Mesh::triangles`].
    pub triangle: Option<u32>,
    /// An edge, as indices into [`Mesh::points`].
    pub edge: Option<[u32; 2]>,
    /// A point, as index into [`Mesh::points`].
    pub point: Option<u32>,
    /// A segment of the outline.
    pub segment: Option<Numbered>,
    /// A point of the outline.
    pub input_point: Option<Numbered>,
    /// An angle in radians.
    pub angle: Option<f64>,
}

/// An item of the outline: its index, and the number its file gives it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Numbered {
    /// Zero-based; `u32::MAX` for an edge of the convex hull that the outline lacks.
    pub index: u32,
    /// The number in the file.
    pub number: i64,
}

/// What can be wrong with a mesh.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FaultKind {
    /// G1: a coordinate is no finite number.
    NotFinite,
    /// G1: a triangle names a point that the mesh does not have.
    NoSuchPoint,
    /// G1: a triangle has one point twice.
    RepeatedCorner,
    /// G1: the corners of a triangle are collinear.
    Flat,
    /// G1: a triangle is clockwise.
    Clockwise,
    /// G1: two triangles lie on the same side of an edge.
    Overlap,
    /// G1: no triangle has this point.
    UnusedPoint,
    /// G1: an edge that is no boundary has a triangle on one side only.
    Gap,
    /// G1: a part of a segment has no triangle on a side where the domain lies.
    Unmeshed,
    /// G1: a part of a segment has a triangle on a side where the domain does not lie.
    Overmeshed,
    /// G1: V − E + F is not what the outline makes it.
    Euler {
        /// V − E + F of the mesh.
        found: i64,
        /// V − E + F of the domain.
        expected: i64,
    },
    /// G1: the areas differ by more than (number of points)·ulp·perimeter.
    Area {
        /// Of the mesh.
        found: f64,
        /// Of the domain.
        expected: f64,
    },
    /// G2: a point is inside the circle of the triangle across the edge.
    NotDelaunay,
    /// G3: a point is inside the diametral disc of a part of a segment.
    Encroached,
    /// G4: a point of the outline is not in the mesh.
    LostPoint,
    /// G4: from this point on no edge follows the segment.
    Broken {
        /// The next point of the segment that is reached from its other end.
        until: Option<u32>,
    },
    /// G4: the mesh has the edge, but not in its list of boundary and interface edges.
    Unlisted,
    /// G4: the list of edges has one that is no part of a segment, or one twice.
    Surplus,
    /// G4: an edge of the list lies on the segment, but no triangle has it.
    NotAnEdge,
    /// G4: an edge of the list names a point that the mesh does not have.
    NoSuchEdgePoint,
    /// G4: a point of a segment is farther than 0.51 ulp from it.
    OffSegment {
        /// How far, where 0.51 is allowed.
        ulps: f64,
    },
    /// G4: the points of a segment do not follow each other from end to end.
    NotMonotone,
    /// G4: an edge is said to be a part of another segment than it is.
    WrongSegment,
    /// G4: an edge does not carry its segment's tag.
    WrongBoundaryTag {
        /// The tag in the mesh, with its name if it has one.
        found: String,
        /// The segment's.
        expected: String,
    },
    /// G4: a triangle does not carry its region's tag.
    WrongRegionTag {
        /// The tag in the mesh, with its name if it has one.
        found: String,
        /// The region's.
        expected: String,
    },
    /// G4: a point or an edge is not in a group that its point or its segment of the outline is in.
    LostGroup {
        /// The group, with its name if it has one.
        expected: String,
    },
    /// G4: a point or an edge is in a group that its point or its segment of the outline is not in.
    StrangeGroup {
        /// The group, with its name if it has one.
        found: String,
    },
    /// G5: an angle below κ̂ that no two segments excuse.
    UnexcusedAngle,
    /// G5: an angle across two segments at angle θ that is below arctan(sin θ / (2 − cos θ)).
    BelowLemma7 {
        /// The bound, in radians.
        bound: f64,
    },
    /// G6: the smallest angle is below min{κ̂, arctan(sin θ* / (2 − cos θ*))}.
    TooSmall {
        /// The bound, in radians.
        bound: f64,
    },
    /// G7: an angle above max{π − 2κ̂, π − 2 arcsin((√3 − 1)/2)}.
    TooLarge {
        /// The bound, in radians.
        bound: f64,
    },
    /// G8: an edge is shorter than lfs′_min·2 sin(θ*/2)/μ.
    TooShort {
        /// Its length.
        length: f64,
        /// The bound.
        bound: f64,
    },
    /// G9: a point does not lie where a point of its kind lies.
    WrongKind,
    /// G10: an entry of the stiffness matrix outside its diagonal is positive.
    PositiveCoupling,
}

impl Fault {
    fn new(kind: FaultKind, place: [f64; 2]) -> Self {
        Self {
            kind,
            place,
            triangle: None,
            edge: None,
            point: None,
            segment: None,
            input_point: None,
            angle: None,
        }
    }

    pub(super) fn of_mesh(kind: FaultKind, place: [f64; 2]) -> Self {
        Self::new(kind, place)
    }

    pub(super) fn at_point(mesh: &Mesh, kind: FaultKind, point: u32) -> Self {
        Self { point: Some(point), ..Self::new(kind, place(mesh, &[point])) }
    }

    pub(super) fn at_edge(mesh: &Mesh, kind: FaultKind, edge: [u32; 2]) -> Self {
        Self { edge: Some(edge), ..Self::new(kind, place(mesh, &edge)) }
    }

    pub(super) fn at_triangle(mesh: &Mesh, kind: FaultKind, triangle: u32) -> Self {
        let place = place(mesh, &mesh.triangles[triangle as usize]);
        Self { triangle: Some(triangle), ..Self::new(kind, place) }
    }

    pub(super) fn of_triangle(self, triangle: u32) -> Self {
        Self { triangle: Some(triangle), ..self }
    }

    pub(super) fn of_edge(self, edge: [u32; 2]) -> Self {
        Self { edge: Some(edge), ..self }
    }

    pub(super) fn of_point(self, point: u32) -> Self {
        Self { point: Some(point), ..self }
    }

    pub(super) fn of_segment(self, segment: Numbered) -> Self {
        Self { segment: Some(segment), ..self }
    }

    pub(super) fn of_input_point(self, input_point: Numbered) -> Self {
        Self { input_point: Some(input_point), ..self }
    }

    pub(super) fn of_angle(self, angle: f64) -> Self {
        Self { angle: Some(angle), ..self }
    }

    /// What is in a group, or is not: a point, or an edge of a segment.
    fn member(&self) -> String {
        match (self.edge, self.segment) {
            (Some([v, w]), Some(segment)) => {
                format!("edge {}–{} of {}", u64::from(v) + 1, u64::from(w) + 1, of_outline(segment))
            }
            _ => format!("point {}", self.point.map_or(0, |v| u64::from(v) + 1)),
        }
    }
}

/// The middle of some points, as far as the mesh has them.
fn place(mesh: &Mesh, points: &[u32]) -> [f64; 2] {
    let share = 1.0 / points.len() as f64;
    points
        .iter()
        .filter_map(|&v| mesh.points.get(v as usize))
        .fold([0.0, 0.0], |[x, y], p| [x + p[0] * share, y + p[1] * share])
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use FaultKind::*;
        let triangle = self.triangle.map_or(0, |t| u64::from(t) + 1);
        let point = self.point.map_or(0, |v| u64::from(v) + 1);
        let [v, w] = self.edge.map_or([0, 0], |edge| edge.map(|v| u64::from(v) + 1));
        let segment = self.segment.map_or_else(|| "the boundary".to_owned(), of_outline);
        let angle = degrees(self.angle.unwrap_or(0.0));
        match &self.kind {
            NotFinite => {
                return write!(f, "point {point} has a coordinate that is no finite number");
            }
            NoSuchPoint => return write!(f, "triangle {triangle} names a point that is not there"),
            RepeatedCorner => write!(f, "triangle {triangle} has one point twice")?,
            Flat => write!(f, "triangle {triangle} has no area")?,
            Clockwise => write!(f, "triangle {triangle} is clockwise")?,
            Overlap => write!(
                f,
                "triangle {triangle} lies on the same side of edge {v}–{w} as another one"
            )?,
            UnusedPoint => write!(f, "point {point} is in no triangle")?,
            Gap => write!(
                f,
                "edge {v}–{w} of triangle {triangle} has nothing on its other side, and is no boundary"
            )?,
            Unmeshed => write!(
                f,
                "edge {v}–{w} of {segment} has no triangle on a side where the domain lies"
            )?,
            Overmeshed => write!(
                f,
                "edge {v}–{w} of {segment} has triangle {triangle} on a side where the domain does not lie"
            )?,
            Euler { found, expected } => {
                return write!(
                    f,
                    "points − edges + triangles is {found}, the domain's is {expected}"
                );
            }
            Area { found, expected } => {
                return write!(f, "the area is {found}, the domain's is {expected}");
            }
            NotDelaunay => write!(
                f,
                "edge {v}–{w}, point {point} is inside the circle of triangle {triangle}"
            )?,
            Encroached => write!(
                f,
                "point {point} is inside the diametral disc of edge {v}–{w} of {segment}"
            )?,
            LostPoint => {
                let number = self.input_point.map_or(0, |p| p.number);
                write!(f, "point {number} of the outline is missing")?;
            }
            Broken { until } => {
                write!(f, "{segment} is missing from point {point} on")?;
                if let Some(until) = until {
                    write!(f, ", to point {}", u64::from(*until) + 1)?;
                }
            }
            Unlisted => write!(
                f,
                "edge {v}–{w} lies on {segment}, but is not listed as a boundary or interface edge"
            )?,
            Surplus => {
                write!(f, "edge {v}–{w} is listed, but is no part of a segment (or listed twice)")?
            }
            NotAnEdge => write!(f, "edge {v}–{w} of {segment} is listed, but no triangle has it")?,
            NoSuchEdgePoint => return write!(f, "a listed edge names a point that is not there"),
            OffSegment { ulps } => {
                write!(f, "point {point} is {:.2} ulp off {segment}", Significant(*ulps))?;
            }
            NotMonotone => write!(f, "{segment} runs back at point {point}")?,
            WrongSegment => {
                write!(f, "edge {v}–{w} is said to be a part of another segment than {segment}")?
            }
            WrongBoundaryTag { found, expected } => {
                write!(
                    f,
                    "edge {v}–{w} of {segment} has the tag {found}, the outline says {expected}"
                )?;
            }
            WrongRegionTag { found, expected } => {
                write!(f, "triangle {triangle} has the tag {found}, the outline says {expected}")?;
            }
            LostGroup { expected } => {
                write!(
                    f,
                    "{} is not in the group {expected}, where the outline puts it",
                    self.member()
                )?;
            }
            StrangeGroup { found } => {
                write!(
                    f,
                    "{} is in the group {found}, where the outline does not put it",
                    self.member()
                )?;
            }
            UnexcusedAngle => write!(
                f,
                "triangle {triangle} has an angle of {angle} at point {point}, and no two segments excuse it"
            )?,
            BelowLemma7 { bound } => {
                write!(
                    f,
                    "triangle {triangle} has an angle of {angle} at point {point}, below the {} of Lemma 7 by {:.2} of it",
                    degrees(*bound),
                    Significant(1.0 - self.angle.unwrap_or(0.0) / bound)
                )?;
            }
            TooSmall { bound } => write!(
                f,
                "triangle {triangle} has an angle of {angle} at point {point}, below {}",
                degrees(*bound)
            )?,
            TooShort { length, bound } => write!(
                f,
                "edge {v}–{w} is {:.3} long, below the {:.3} of Corollary 2",
                Significant(*length),
                Significant(*bound)
            )?,
            WrongKind => write!(f, "point {point} does not lie where a point of its kind does")?,
            PositiveCoupling => {
                write!(f, "edge {v}–{w} couples its points with the wrong sign")?;
            }
            TooLarge { bound } => write!(
                f,
                "triangle {triangle} has an angle of {angle} at point {point}, above {}",
                degrees(*bound)
            )?,
        }
        write!(f, " near ({:.6}, {:.6})", Significant(self.place[0]), Significant(self.place[1]))
    }
}

/// A segment, by the number that its file gives it.
pub(super) fn of_outline(segment: Numbered) -> String {
    match segment.index {
        u32::MAX => "the convex hull".to_owned(),
        _ => format!("segment {}", segment.number),
    }
}
