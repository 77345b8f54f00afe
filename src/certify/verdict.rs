//! What the judge says: a verdict for each guarantee, with witnesses.

use std::fmt;

use super::fault::{Fault, Numbered, of_outline};
use super::wording::{Significant, degrees, grouped};
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
    /// The triangle, as index into [`Mesh::triangles`](crate::formats::Mesh::triangles).
    pub triangle: u32,
    /// The angle, in radians.
    pub angle: f64,
    /// The edge opposite it, as indices into [`Mesh::points`](crate::formats::Mesh::points).
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
    /// The area of the mesh, in squared units of its coordinates; no number where the mesh was not
    /// judged.
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

    /// Whether anything was judged.
    #[must_use]
    pub fn is_judged(&self) -> bool {
        let is_judged = |judgement: &Judgement| judgement.not_judged.is_none();
        self.judgements.iter().any(is_judged)
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
