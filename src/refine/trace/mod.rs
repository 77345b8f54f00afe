//! What a refinement does, told step by step to whoever listens.
//!
//! Every commit, split, rejection and refusal is one [`Event`] with its reason.
//! [`Replay`] rebuilds the triangulation from them, and from nothing else. Where nobody listens no
//! event is made.

mod names;
mod replay;
mod tell;

pub(crate) use names::Names;
pub use replay::{Damaged, Replay};
pub use tell::Listener;
pub(super) use tell::Proposer;

use super::incremental::Introduction;
use super::provenance::Kind;
use crate::triangulation;

/// One step of a refinement.
///
/// What [`trace`](crate::trace()) tells is in the outline's terms: coordinates are the outline's;
/// vertices are its points by their (zero-based) indices, then the new points, in the order in
/// which they are committed, by the indices that follow; segments are its segments, `u32::MAX` for
/// an edge of the convex hull that it lacks.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// What the refinement begins with: the first event, once.
    Start(Start),
    /// A point or a segment comes into the mesh, where they do so one by one.
    Introduced(Introduction),
    /// The Steiner point of a bad triangle is committed.
    Commit {
        /// Why.
        bad: BadTriangle,
        /// The point and its triangles.
        made: Made,
    },
    /// A subsegment is split.
    Split {
        /// The subsegment.
        subsegment: Subsegment,
        /// Why.
        cause: Cause,
        /// `Shell` or `Midpoint`.
        kind: Kind,
        /// The point and its triangles.
        made: Made,
    },
    /// The Steiner point of a bad triangle is not committed: it would encroach subsegments. These
    /// are split instead, all or (the Terminator) those that may be.
    Rejected {
        /// The triangle.
        bad: BadTriangle,
        /// Where its Steiner point would be.
        point: [f64; 2],
        /// What it would encroach.
        encroached: Vec<Subsegment>,
    },
    /// A subsegment is left as it is from now on.
    RefusedSplit {
        /// The subsegment.
        subsegment: Subsegment,
        /// Why it was to be split.
        cause: Cause,
        /// Why it is not.
        refusal: Refusal,
    },
    /// A bad triangle is left as it is.
    RefusedPoint {
        /// The triangle.
        bad: BadTriangle,
        /// Where its Steiner point would be.
        point: [f64; 2],
        /// Why it is not committed.
        refusal: Refusal,
    },
}

/// The triangulation that a refinement begins with.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Start {
    /// Every point that a triangle uses, with its index; in the order of the indices.
    pub points: Vec<(u32, [f64; 2])>,
    /// The triangles, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// The segments in the meshed region.
    pub subsegments: Vec<Subsegment>,
}

/// A piece of an input segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Subsegment {
    /// Its ends.
    pub ends: [u32; 2],
    /// The segment that it is a piece of.
    pub segment: u32,
}

/// A committed point.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// Its index.
    pub vertex: u32,
    /// Its coordinates.
    pub point: [f64; 2],
    /// The triangles around it, the new point first, counter-clockwise. They replace those that
    /// lay in their place.
    pub star: Vec<[u32; 3]>,
}

/// A triangle that proposes a Steiner point, and why.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BadTriangle {
    /// Its vertices, counter-clockwise.
    pub vertices: [u32; 3],
    /// Its trigger edge: the one opposite the angle.
    pub edge: [u32; 2],
    /// What is wrong with it.
    pub fault: Fault,
}

/// What is wrong with a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// An angle (in radians) is below κ̂ and not excused.
    Angle(f64),
    /// Its area is larger than allowed.
    Area(f64),
}

/// Why a subsegment is to be split.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// This vertex encroaches it: (Conformality).
    Encroached(u32),
    /// The Steiner point of this bad triangle would encroach it: (Quality′), the last
    /// [`Event::Rejected`].
    Rejected([u32; 3]),
    /// It is longer than the size that is asked for there.
    Size,
    /// Algorithm 1 (§9) puts a point on it before the refinement.
    Augmented,
}

/// Why a point is not committed: always a matter of precision (ALGORITHM §9).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// It would be nearer to a vertex than the precision floor.
    Floor,
    /// Rounded, it is not inside the circumcircle of its triangle.
    OutsideItsDisc,
    /// Rounded, some triangle of its star would not be counter-clockwise.
    Unseen,
    /// Rounded, what it would replace is no polygon that a star can fill.
    Malformed,
    /// It would encroach subsegments whose splits are all refused.
    AllSplitsRefused,
}

impl From<triangulation::Rejected> for Refusal {
    fn from(rejected: triangulation::Rejected) -> Self {
        match rejected {
            triangulation::Rejected::OutsideItsDisc => Self::OutsideItsDisc,
            triangulation::Rejected::Unseen => Self::Unseen,
            triangulation::Rejected::Malformed => Self::Malformed,
        }
    }
}
