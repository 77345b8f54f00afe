//! What a run may be asked for.

/// Everything that a run of the Adaptive Delaunay Refinement Algorithm may vary.
///
/// ```
/// use meshwright::{Parameters, Splitting};
/// let parameters = Parameters { splitting: Splitting::Shells, ..Parameters::default() };
/// assert_eq!(parameters.min_angle.degrees().round(), 26.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// The output angle parameter κ̂.
    pub min_angle: MinAngle,
    /// An angle above κ̂ that is reached where it can be: the soft target κ_t. What is promised is
    /// κ̂ all the same. With [`Steiner::LookAhead`] fewer angles miss it than with the default.
    pub soft_angle: Option<MinAngle>,
    /// No triangle may be larger than this area (squared units of the coordinates).
    pub max_area: Option<f64>,
    /// The run stops, with what it has, at this many points.
    pub max_points: usize,
    /// Where a subsegment is split.
    pub splitting: Splitting,
    /// When a small angle is left alone.
    pub excuse: Excuse,
    /// Where the point goes that removes a bad triangle.
    pub steiner: Steiner,
    /// Whether small angles across small input angles are attacked.
    pub rule: Rule,
    /// What is meshed.
    pub region: Region,
    /// Whether points and segments are introduced one by one ([`refine::incremental`]) instead of
    /// all at once.
    ///
    /// [`refine::incremental`]: crate::refine::incremental
    pub incremental: bool,
    /// Whether the mesh is judged before it is handed out. Judging takes about as long as meshing;
    /// [`certify`](crate::certify::certify) can do it later.
    pub judged: bool,
    /// Whether the angles are measured for [`Outcome::statistics`](crate::Outcome::statistics) while
    /// what they need is at hand: without, they are measured when they are asked for, which takes longer.
    pub measured: bool,
    /// How often, at the end, a few Steiner points are taken out for fewer ones.
    pub thinning: Thinning,
}

impl Parameters {
    /// The rules of the paper (§§3, 10): splitting on concentric shells, midpoints excused,
    /// circumcenters, worst angle first, in the whole convex hull (the paper's box, where the
    /// outline has one).
    #[must_use]
    pub fn paper() -> Self {
        Self {
            splitting: Splitting::Shells,
            excuse: Excuse::Midpoints,
            steiner: Steiner::Circumcenter,
            region: Region::Hull,
            ..Self::default()
        }
    }
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            min_angle: MinAngle::default(),
            soft_angle: None,
            max_area: None,
            max_points: 10_000_000,
            splitting: Splitting::default(),
            excuse: Excuse::default(),
            steiner: Steiner::default(),
            rule: Rule::default(),
            region: Region::default(),
            incremental: false,
            judged: true,
            measured: true,
            thinning: Thinning::default(),
        }
    }
}

/// The output angle parameter κ̂, held as tan²κ̂ so that "angle < κ̂" needs no trigonometry.
///
/// The default is tan²κ̂ = 99/400 (κ̂ = 26.450057°), just below the paper's arcsin 2^(-7/6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MinAngle {
    /// tan²κ̂ = `numerator / denominator`.
    pub numerator: f64,
    /// See [`MinAngle::numerator`].
    pub denominator: f64,
}

impl Default for MinAngle {
    fn default() -> Self {
        Self { numerator: 99.0, denominator: 400.0 }
    }
}

impl MinAngle {
    /// The largest κ̂ that every promise holds for: arcsin 2^(-7/6), in degrees (rounded down).
    pub const LARGEST_DEGREES: f64 = 26.452;

    /// The largest soft target that is reached but for a few angles on every outline tried, in
    /// degrees.
    pub const LARGEST_SOFT_DEGREES: f64 = 34.0;

    /// κ̂ from degrees.
    ///
    /// # Errors
    /// What is wrong with the value: it is no number from 0 to [`MinAngle::LARGEST_DEGREES`].
    pub fn from_degrees(degrees: f64) -> Result<Self, MinAngleError> {
        Self::up_to(Self::LARGEST_DEGREES, degrees)
    }

    /// A soft target κ_t from degrees.
    ///
    /// # Errors
    /// What is wrong with the value: it is no number from 0 to [`MinAngle::LARGEST_SOFT_DEGREES`].
    pub fn soft_from_degrees(degrees: f64) -> Result<Self, MinAngleError> {
        Self::up_to(Self::LARGEST_SOFT_DEGREES, degrees)
    }

    /// A soft target that may be missed by far, or reached with a great many points: up to 60°.
    ///
    /// # Errors
    /// What is wrong with the value: it is no number from 0 to 60.
    pub fn without_guarantee_from_degrees(degrees: f64) -> Result<Self, MinAngleError> {
        Self::up_to(60.0, degrees)
    }

    fn up_to(largest: f64, degrees: f64) -> Result<Self, MinAngleError> {
        if !(0.0..=largest).contains(&degrees) {
            return Err(MinAngleError { degrees, largest });
        }
        let tangent = libm::tan(degrees.to_radians());
        Ok(Self { numerator: tangent * tangent, denominator: 1.0 })
    }

    /// κ̂ in degrees.
    #[must_use]
    pub fn degrees(self) -> f64 {
        self.radians().to_degrees()
    }

    /// κ̂ in radians.
    #[must_use]
    pub fn radians(self) -> f64 {
        libm::atan(libm::sqrt(self.numerator / self.denominator))
    }
}

/// A minimum angle that is not offered.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "a minimum angle of {degrees}° is not possible: it must be from 0° to {largest}° (the \
     refinement is proved to end up to {proved}°, arcsin 2^(-7/6))",
    proved = MinAngle::LARGEST_DEGREES
)]
pub struct MinAngleError {
    /// The value asked for.
    pub degrees: f64,
    /// The largest one possible.
    pub largest: f64,
}

/// Where a subsegment is split.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Splitting {
    /// At dyadic distances from the end it belongs to, all the way out.
    #[default]
    Ladder,
    /// On concentric circular shells at first, then at midpoints (§10 of the paper).
    Shells,
    /// At points that Algorithm 1 of the paper (§9) puts on every segment before, then at
    /// midpoints.
    Augment,
}

/// When an angle smaller than κ̂ is left alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Excuse {
    /// It lies across two segments that meet at θ ≤ π/3 and is at least arctan(sin θ/(2−cos θ)),
    /// or both ends of its edge are midpoints of ladders from the common end.
    #[default]
    Measured,
    /// Both ends of its edge are midpoints on two such segments ((Quality′) of §3).
    Midpoints,
}

/// Where the Steiner point of a bad triangle goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Steiner {
    /// On the bisector of the short edge, no farther out than the circumcenter (Üngör).
    #[default]
    OffCenter,
    /// The circumcenter.
    Circumcenter,
    /// Of some twenty points that obey the same rule as off-centers, the one that leaves the fewest
    /// bad triangles; the off-center where none obeys. Fewer points, for two to three times the
    /// work.
    LookAhead,
}

/// How often a finished mesh is tried to be made smaller ([`refine::thin`]).
///
/// [`refine::thin`]: mod@crate::refine::thin
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Thinning {
    /// Never.
    #[default]
    None,
    /// So many times.
    Tries(u64),
    /// Twenty times for each Steiner point.
    Auto,
}

/// Which small angles are attacked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rule {
    /// All but the excused ones: ends on every input.
    #[default]
    Adaptive,
    /// All of them: ends only where the input has no angle that makes smaller ones.
    Ruppert,
    /// All of them, but no subsegment of a cluster around a small input angle is split for the
    /// sake of a longer edge (Shewchuk's Terminator): for comparison.
    Terminator,
}

/// What is meshed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Region {
    /// What the segments enclose, less the holes. Without segments: the convex hull.
    #[default]
    Domain,
    /// The whole convex hull, less the holes.
    Hull,
    /// What [`Region::Domain`] meshes, but within a triangulation of the whole convex hull: what
    /// lies around takes part in encroachment, is never refined for its angles, and is taken out at
    /// the end. So the mesh is Delaunay with respect to all its vertices.
    Global,
}
