//! What the judge says: a verdict for each guarantee, with witnesses.

use std::fmt;

use crate::formats::Mesh;
use crate::parameters::{Excuse, MinAngle, Parameters, Region, Rule};

/// How many faults of each guarantee are kept; all are counted.
const KEPT: usize = 64;

/// What a mesh is held to.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Promise {
    /// The output angle parameter κ̂.
    pub min_angle: MinAngle,
    /// What was to be meshed.
    pub region: Region,
    /// The rule by which small angles were left alone. The bound that is judged (G5) is the same
    /// for both; the certificate only states it.
    pub excuse: Excuse,
    /// Whether the run was a plain one, of which Corollary 2 speaks: the adaptive rule, and no
    /// sizes or soft target that ask for more points than the outline does. `None`: not known.
    pub is_plain: Option<bool>,
}

impl From<&Parameters> for Promise {
    fn from(parameters: &Parameters) -> Self {
        Self {
            min_angle: parameters.min_angle,
            region: parameters.region,
            excuse: parameters.excuse,
            is_plain: Some(
                parameters.rule == Rule::Adaptive
                    && parameters.max_area.is_none()
                    && parameters.soft_angle.is_none(),
            ),
        }
    }
}

/// The guarantees that are judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Guarantee {
    /// G1: counter-clockwise triangles that meet in edges and corners only, every point used,
    /// Euler characteristic and area those of the domain.
    Complex,
    /// G2: no apex inside the circle of the triangle across an edge that lies on no segment.
    Delaunay,
    /// G3: no apex inside the diametral disc of a subsegment.
    Unencroached,
    /// G4: each segment is a chain of edges, each point of the outline is there, tags are kept.
    Conforming,
    /// G5: Lemma 7 for every angle.
    SmallAngles,
    /// G6: Lemma 7 for the smallest angle.
    SmallestAngle,
    /// G7: Corollary 3.
    LargestAngle,
    /// G8: Corollary 2.
    ShortestEdge,
    /// G9: the points are of the kinds that they are said to be.
    Provenance,
    /// G10: the P1 stiffness matrix is an M-matrix, the circumcenters make an admissible
    /// finite-volume mesh.
    Matrix,
}

impl Guarantee {
    /// All of them, G1 first.
    pub const ALL: [Self; 10] = [
        Self::Complex,
        Self::Delaunay,
        Self::Unencroached,
        Self::Conforming,
        Self::SmallAngles,
        Self::SmallestAngle,
        Self::LargestAngle,
        Self::ShortestEdge,
        Self::Provenance,
        Self::Matrix,
    ];

    /// `G1` to `G10`.
    #[must_use]
    pub fn code(self) -> &'static str {
        ["G1", "G2", "G3", "G4", "G5", "G6", "G7", "G8", "G9", "G10"][self as usize]
    }

    /// The word that a report uses.
    #[must_use]
    pub fn name(self) -> &'static str {
        [
            "complex",
            "Delaunay",
            "unencroached",
            "conforming",
            "small angles",
            "smallest angle",
            "largest angle",
            "shortest edge",
            "provenance",
            "M-matrix",
        ][self as usize]
    }
}

/// The answer for one guarantee.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It holds.
    Holds,
    /// It does not: there is at least one [`Fault`].
    Fails,
    /// It holds but for triangles in the stretch that doubles cannot resolve (see
    /// [`Certificate::apexes`]).
    LimitedByPrecision,
    /// It was not judged, for this reason.
    NotJudged(&'static str),
}

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
}

/// The middle of some points, as far as the mesh has them.
fn place(mesh: &Mesh, points: &[u32]) -> [f64; 2] {
    let share = 1.0 / points.len() as f64;
    points
        .iter()
        .filter_map(|&v| mesh.points.get(v as usize))
        .fold([0.0, 0.0], |[x, y], p| [x + p[0] * share, y + p[1] * share])
}

/// The verdict on one guarantee and what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// Which guarantee.
    pub guarantee: Guarantee,
    /// How many faults there are.
    pub faults: usize,
    /// The first of them.
    pub first: Vec<Fault>,
    /// How many deviations lie in the stretch that doubles cannot resolve.
    pub limited: usize,
    /// The first of those.
    pub first_limited: Vec<Fault>,
    /// Why it was not judged.
    not_judged: Option<&'static str>,
}

impl Judgement {
    pub(super) fn new(guarantee: Guarantee) -> Self {
        Self {
            guarantee,
            faults: 0,
            first: Vec::new(),
            limited: 0,
            first_limited: Vec::new(),
            not_judged: None,
        }
    }

    pub(super) fn not_judged(guarantee: Guarantee, reason: &'static str) -> Self {
        Self { not_judged: Some(reason), ..Self::new(guarantee) }
    }

    pub(super) fn add(&mut self, fault: Fault) {
        self.faults += 1;
        if self.first.len() < KEPT {
            self.first.push(fault);
        }
    }

    /// A fault, or, if `limited`, a deviation that precision excuses.
    pub(super) fn add_unless(&mut self, limited: bool, fault: Fault) {
        if !limited {
            return self.add(fault);
        }
        self.limited += 1;
        if self.first_limited.len() < KEPT {
            self.first_limited.push(fault);
        }
    }

    /// The verdict.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match self.not_judged {
            Some(reason) => Verdict::NotJudged(reason),
            None if self.faults > 0 => Verdict::Fails,
            None if self.limited > 0 => Verdict::LimitedByPrecision,
            None => Verdict::Holds,
        }
    }
}

/// How many points of each kind a mesh has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Kinds {
    /// Points of the outline.
    pub input: usize,
    /// Points on segments that the analysis treats as input.
    pub shell: usize,
    /// Midpoints of subsegments.
    pub midpoint: usize,
    /// Circumcenters and off-centers.
    pub circumcenter: usize,
}

/// What Corollary 2 says of a mesh, in the units of its coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corollary2 {
    /// lfs′_min: the least local feature size of the outline with its shell points.
    pub lfs_min: f64,
    /// No edge may be shorter: lfs′_min·2 sin(θ*/2)/μ.
    pub bound: f64,
    /// The length of the shortest edge; its ratio to the bound says how pessimistic that is.
    pub shortest: f64,
}

/// A small angle that Lemma 7 allows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExcusedAngle {
    /// The triangle, as index into [`Mesh::triangles`].
    pub triangle: u32,
    /// The angle, in radians.
    pub angle: f64,
    /// The edge opposite it, as indices into [`Mesh::points`].
    pub edge: [u32; 2],
    /// The two segments that the ends of the edge lie inside of.
    pub segments: [Numbered; 2],
    /// The angle θ of those segments at their common end, in radians.
    pub theta: f64,
}

/// The common end of two segments that doubles cannot tell apart near it (ALGORITHM §9).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apex {
    /// The point of the outline.
    pub point: Numbered,
    /// The two segments.
    pub segments: [Numbered; 2],
    /// Their angle θ, in radians.
    pub theta: f64,
    /// How far from the apex the stretch reaches: where θ²·d < 4·ulp(M) or θ·d < 2^12·ulp(M).
    pub reach: f64,
    /// Where it is.
    pub place: [f64; 2],
}

/// Two features of the outline that do not adjoin, too close for doubles: less than
/// 2^13·ulp(M) apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Narrow {
    /// A point of the outline.
    pub point: Numbered,
    /// What it is close to.
    pub to: NarrowTo,
    /// The distance of the two.
    pub gap: f64,
    /// Where the point is.
    pub place: [f64; 2],
}

/// What a point of an outline is close to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NarrowTo {
    /// Another point.
    Point(Numbered),
    /// A segment, not its own.
    Segment(Numbered),
}

/// What was found about a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// What the mesh was held to.
    pub promise: Promise,
    /// One judgement for each guarantee, G1 first.
    pub judgements: Vec<Judgement>,
    /// How many points and triangles the mesh has.
    pub points: usize,
    /// See [`Certificate::points`].
    pub triangles: usize,
    /// The area of the mesh, in squared units of its coordinates.
    pub area: f64,
    /// The smallest angle, in radians; `None` without triangles.
    pub smallest_angle: Option<f64>,
    /// The largest angle, in radians; `None` without triangles.
    pub largest_angle: Option<f64>,
    /// θ*: the smallest angle between two adjoining segments, at most π/3, in radians; `None`
    /// where the mesh was judged alone.
    pub theta_star: Option<f64>,
    /// The angles below κ̂ that Lemma 7 allows, in the order of the triangles.
    pub excused: Vec<ExcusedAngle>,
    /// Points by kind; `None` where the mesh or its outline are not known so well.
    pub kinds: Option<Kinds>,
    /// What G8 rests on; `None` as above.
    pub corollary_2: Option<Corollary2>,
    /// The apexes in whose stretch a point of the mesh lies.
    pub apexes: Vec<Apex>,
    /// The features that are too close to each other.
    pub narrows: Vec<Narrow>,
    /// How many triangles have a point in such a stretch, or at such features.
    pub limited_triangles: usize,
    /// What else could not be judged, e.g. tags of a mesh that carries none.
    pub not_judged: Vec<&'static str>,
}

impl Certificate {
    /// The judgement on one guarantee.
    #[must_use]
    pub fn judgement(&self, guarantee: Guarantee) -> &Judgement {
        &self.judgements[guarantee as usize]
    }

    /// The verdict on one guarantee.
    #[must_use]
    pub fn verdict(&self, guarantee: Guarantee) -> Verdict {
        self.judgement(guarantee).verdict()
    }

    /// Whether nothing that was judged fails; what is limited by precision does not fail.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.judgements.iter().all(|judgement| judgement.faults == 0)
    }

    /// Whether something is limited by precision.
    #[must_use]
    pub fn limited(&self) -> bool {
        self.judgements.iter().any(|judgement| judgement.limited > 0)
    }
}

/// One line per guarantee; the angles share one unless they fail. Items of the mesh are counted
/// from one, as `.msh` files do; segments and points of the outline as their file does.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for judgement in &self.judgements[..4] {
            line(f, judgement.guarantee.name(), judgement, &self.summary(judgement.guarantee))?;
        }
        self.write_angles(f)?;
        for judgement in &self.judgements[7..] {
            line(f, judgement.guarantee.name(), judgement, &self.summary(judgement.guarantee))?;
        }
        if self.limited() {
            self.write_limits(f)?;
        }
        for reason in &self.not_judged {
            writeln!(f, "not judged    {reason}")?;
        }
        Ok(())
    }
}

impl Certificate {
    /// One line for all that holds, or one for each guarantee that fails.
    fn write_angles(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let angles = &self.judgements[4..7];
        let mut failing = angles.iter().filter(|judgement| judgement.faults > 0).peekable();
        if failing.peek().is_some() {
            return failing
                .try_for_each(|judgement| line(f, judgement.guarantee.name(), judgement, ""));
        }
        let limited = angles.iter().find(|judgement| judgement.limited > 0);
        // The last one, the largest angle, is judged without an outline too.
        line(f, "angles", limited.unwrap_or(&angles[2]), &self.angles())
    }

    /// Where doubles end: the first apex and the first narrow place, and how many more there are.
    fn write_limits(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let more = |count: usize| match count - 1 {
            0 => String::new(),
            more => format!(", and {} more such places", grouped(more)),
        };
        if let Some(apex) = self.apexes.first() {
            let [first, second] = apex.segments.map(of_outline);
            let (point, theta) = (apex.point.number, degrees(apex.theta));
            let more = more(self.apexes.len());
            writeln!(
                f,
                "precision     {first} and {second} meet at {theta} at point {point}{more}"
            )?;
        }
        if let Some(narrow) = self.narrows.first() {
            let other = match narrow.to {
                NarrowTo::Point(point) => format!("point {}", point.number),
                NarrowTo::Segment(segment) => of_outline(segment),
            };
            let (point, gap, more) =
                (narrow.point.number, Significant(narrow.gap), more(self.narrows.len()));
            writeln!(f, "precision     point {point} is {gap:.3} from {other}{more}")?;
        }
        writeln!(f, "precision     {} triangles are there", grouped(self.limited_triangles))
    }

    fn summary(&self, guarantee: Guarantee) -> String {
        match guarantee {
            Guarantee::Complex => format!(
                "{} points, {} triangles, area {:.6}",
                grouped(self.points),
                grouped(self.triangles),
                Significant(self.area)
            ),
            Guarantee::ShortestEdge => self.corollary_2.map_or_else(String::new, |found| {
                let [shortest, times] =
                    [found.shortest, found.shortest / found.bound].map(Significant);
                format!("{shortest:.3}, {times:.2} times what Corollary 2 promises")
            }),
            Guarantee::Provenance => self.kinds.map_or_else(String::new, |kinds| {
                let Kinds { input, shell, midpoint, circumcenter } = kinds;
                let [input, shell, midpoint, circumcenter] =
                    [input, shell, midpoint, circumcenter].map(grouped);
                format!(
                    "{input} input, {shell} shell, {midpoint} midpoint, {circumcenter} circumcenter"
                )
            }),
            Guarantee::Matrix => "and admissible for finite volumes".to_owned(),
            _ => String::new(),
        }
    }

    fn angles(&self) -> String {
        let (Some(smallest), Some(largest)) = (self.smallest_angle, self.largest_angle) else {
            return "none".to_owned();
        };
        let excused = match self.excused.len() {
            0 => String::new(),
            n => format!(", {} excused by the outline", grouped(n)),
        };
        format!("{} to {}{excused}", degrees(smallest), degrees(largest))
    }
}

/// Writes one line of the report.
fn line(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    judgement: &Judgement,
    summary: &str,
) -> fmt::Result {
    let (word, text) = match judgement.verdict() {
        Verdict::Holds => ("holds", summary.to_owned()),
        Verdict::NotJudged(reason) => ("-", format!("not judged: {reason}")),
        Verdict::LimitedByPrecision => (
            "limited",
            format!(
                "by precision in {}; first: {}",
                grouped(judgement.limited),
                judgement.first_limited[0]
            ),
        ),
        Verdict::Fails => match judgement.faults {
            1 => ("FAILS", judgement.first[0].to_string()),
            n => ("FAILS", format!("{} faults; first: {}", grouped(n), judgement.first[0])),
        },
    };
    writeln!(f, "{}", format!("{name:<13} {word:<8} {text}").trim_end())
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
fn of_outline(segment: Numbered) -> String {
    match segment.index {
        u32::MAX => "the convex hull".to_owned(),
        _ => format!("segment {}", segment.number),
    }
}

/// An angle in degrees, as a person writes it.
fn degrees(radians: f64) -> String {
    let degrees = radians.to_degrees();
    if degrees >= 100.0 {
        format!("{degrees:.1}°")
    } else if degrees >= 0.1 || degrees == 0.0 {
        format!("{degrees:.2}°")
    } else {
        format!("{:.3}°", Significant(degrees))
    }
}

/// A count with its thousands apart.
fn grouped(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// A number with at most `precision` significant digits.
struct Significant(f64);

impl fmt::Display for Significant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f.precision().unwrap_or(6);
        let scientific = format!("{:.*e}", digits.saturating_sub(1), self.0);
        let exponent = scientific.split_once('e').and_then(|(_, e)| e.parse::<i32>().ok());
        match exponent {
            Some(e) if (-4..digits.max(6) as i32).contains(&e) => {
                let places = (digits as i32 - 1 - e).max(0) as usize;
                let text = format!("{:.*}", places, self.0);
                let text = if text.contains('.') {
                    text.trim_end_matches('0').trim_end_matches('.')
                } else {
                    &text
                };
                f.write_str(text)
            }
            _ => f.write_str(&scientific),
        }
    }
}
