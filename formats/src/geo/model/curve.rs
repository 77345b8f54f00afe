//! Curves, by their control points.

use std::ops::{Deref, DerefMut};

use super::{Motion, Spread};
use crate::geo::syntax::Place;

/// The ends of an arc may differ this much, of both radii, in their distance from its centre.
pub(in crate::geo) const RADIUS_TOLERANCE: f64 = 1e-3;

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::geo) struct Curve {
    pub place: Place,
    pub kind: CurveKind,
    /// The points that define it, from its first to its last; see [`CurveKind`].
    pub points: Points,
    pub spread: Option<Box<Spread>>,
}

/// The tags of the points of a curve. Most curves have two: those take no room of their own.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::geo) enum Points {
    Two([i32; 2]),
    Any(Box<[i32]>),
}

impl From<Vec<i32>> for Points {
    fn from(points: Vec<i32>) -> Self {
        match points[..] {
            [first, last] => Self::Two([first, last]),
            _ => Self::Any(points.into()),
        }
    }
}

impl Deref for Points {
    type Target = [i32];

    fn deref(&self) -> &[i32] {
        match self {
            Self::Two(points) => points,
            Self::Any(points) => points,
        }
    }
}

impl DerefMut for Points {
    fn deref_mut(&mut self) -> &mut [i32] {
        match self {
            Self::Two(points) => points,
            Self::Any(points) => points,
        }
    }
}

/// What a curve is.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::geo) enum CurveKind {
    /// Straight from point to point.
    Line,
    /// First end, centre, last end. Of the two arcs the shorter; of two half circles the one that
    /// runs counter-clockwise from the first end, or from the last where it is a reversed copy.
    Circle { reversed: bool },
    /// First end, centre, a point of the major axis, last end; as for a circle.
    Ellipse { reversed: bool },
    /// A Catmull–Rom spline through the points.
    Spline,
    /// A cubic B-spline with these control points; it begins and ends in the outer ones.
    BSpline,
    /// A Bézier curve with these control points.
    Bezier,
    /// A part of a circle or an ellipse that needs no centre point (OpenCASCADE); its two points
    /// are its ends.
    Arc(Box<Arc>),
}

/// `centre + cos(t)·u + sin(t)·v` for `t` from `from` to `to`, in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::geo) struct Arc {
    pub centre: [f64; 3],
    pub u: [f64; 3],
    pub v: [f64; 3],
    pub from: f64,
    pub to: f64,
}

impl Arc {
    /// The place at the angle `t`.
    pub(in crate::geo) fn at(&self, t: f64) -> [f64; 3] {
        let (sin, cos) = libm::sincos(t);
        [0, 1, 2].map(|i| self.centre[i] + cos * self.u[i] + sin * self.v[i])
    }

    /// The arc moved.
    pub(super) fn moved(&self, motion: &Motion) -> Self {
        let centre = motion.apply(self.centre);
        let [u, v] = [self.u, self.v].map(|axis| motion.turn(axis));
        Self { centre, u, v, ..*self }
    }

    fn reversed(&self) -> Self {
        Self { from: self.to, to: self.from, ..*self }
    }
}

impl Curve {
    /// Its first and its last point.
    pub(in crate::geo) fn ends(&self) -> [i32; 2] {
        let first = self.points.first().copied().unwrap_or_default();
        [first, self.points.last().copied().unwrap_or_default()]
    }

    /// The same curve from its last point to its first.
    pub(in crate::geo) fn reversed(&self) -> Self {
        let mut points = self.points.clone();
        points.reverse();
        let kind = match self.kind {
            CurveKind::Circle { reversed } => CurveKind::Circle { reversed: !reversed },
            CurveKind::Ellipse { reversed } => {
                points.swap(1, 2);
                CurveKind::Ellipse { reversed: !reversed }
            }
            CurveKind::Arc(ref arc) => CurveKind::Arc(Box::new(arc.reversed())),
            ref kind => kind.clone(),
        };
        Self { kind, points, ..self.clone() }
    }

    /// The curve, or the reversed curve if the sign is negative.
    pub(in crate::geo) fn signed(&self, sign: i32) -> Self {
        if sign < 0 { self.reversed() } else { self.clone() }
    }
}
