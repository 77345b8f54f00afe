//! Curves as functions of a parameter from 0 to 1.

use std::f64::consts::{PI, TAU};

use crate::geo::error::{CurveFault, Problem};
use crate::geo::model::{Arc, Curve, CurveKind, RADIUS_TOLERANCE};

/// A Bézier curve has at most this many control points: a place on it takes their square in time.
const MOST_BEZIER_POINTS: usize = 1000;

/// A curve in the plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Path {
    /// Straight from point to point.
    Straight(Vec<[f64; 2]>),
    /// `centre + cos(t)·u + sin(t)·v`.
    Arc {
        centre: [f64; 2],
        u: [f64; 2],
        v: [f64; 2],
        from: f64,
        to: f64,
    },
    CatmullRom(Vec<[f64; 2]>),
    BSpline {
        points: Vec<[f64; 2]>,
        closed: bool,
    },
    Bezier(Vec<[f64; 2]>),
}

impl Path {
    /// The path of a curve whose points lie at these places of the plane.
    ///
    /// # Errors
    /// Points that define no such curve.
    pub(super) fn of(
        tag: i32,
        curve: &Curve,
        points: Vec<[f64; 2]>,
        project: impl Fn([f64; 3]) -> [f64; 2],
    ) -> Result<Self, Problem> {
        let fault = |fault| Problem::Curve { tag, fault };
        if points.iter().all(|&p| p == points[0]) && !matches!(curve.kind, CurveKind::Arc(_)) {
            let in_centre =
                matches!(curve.kind, CurveKind::Circle { .. } | CurveKind::Ellipse { .. });
            let what = if in_centre { CurveFault::EndInCentre } else { CurveFault::TooFewPoints };
            return Err(fault(what));
        }
        match &curve.kind {
            CurveKind::Line => Ok(Self::Straight(points)),
            CurveKind::Spline => Ok(Self::CatmullRom(points)),
            CurveKind::BSpline => {
                let [first, last] = curve.ends();
                Ok(Self::BSpline { points, closed: first == last && curve.points.len() > 3 })
            }
            CurveKind::Bezier if points.len() > MOST_BEZIER_POINTS => {
                Err(Problem::Limit { what: "a Bezier curve has more than 1000 control points" })
            }
            CurveKind::Bezier => Ok(Self::Bezier(points)),
            CurveKind::Circle { reversed } => {
                circle([points[0], points[1], points[2]], *reversed).map_err(fault)
            }
            CurveKind::Ellipse { reversed } => {
                let [first, centre, major, last] = [points[0], points[1], points[2], points[3]];
                ellipse([first, centre, major, last], *reversed).map_err(fault)
            }
            CurveKind::Arc(arc) => {
                let Arc { centre, u, v, from, to } = **arc;
                let origin = project([0.0; 3]);
                let [u, v] = [u, v].map(|axis| difference(project(axis), origin));
                Ok(Self::Arc { centre: project(centre), u, v, from, to })
            }
        }
    }

    /// The place at a parameter from 0 to 1.
    pub(super) fn at(&self, t: f64) -> [f64; 2] {
        match self {
            Self::Straight(points) => {
                let (i, t) = piece(points.len() - 1, t);
                mix(points[i], points[i + 1], t)
            }
            Self::Arc { centre, u, v, from, to } => {
                let (sin, cos) = libm::sincos(from + t * (to - from));
                [0, 1].map(|i| centre[i] + cos * u[i] + sin * v[i])
            }
            Self::CatmullRom(points) => catmull_rom(points, t),
            Self::BSpline { points, closed: true } => closed_b_spline(points, t),
            Self::BSpline { points, closed: false } => clamped_b_spline(points, t),
            Self::Bezier(points) => bezier(points, t),
        }
    }

    /// How many pieces of it are smooth.
    pub(super) fn pieces(&self) -> usize {
        match self {
            Self::Straight(points) | Self::CatmullRom(points) => points.len() - 1,
            Self::Arc { .. } => 1,
            Self::BSpline { points, .. } => points.len(),
            Self::Bezier(_) => 4,
        }
    }

    pub(super) fn is_straight(&self) -> bool {
        matches!(self, Self::Straight(_))
    }

    /// The least number of straight pieces that Gmsh takes for it.
    pub(super) fn least_pieces(&self) -> u32 {
        match self {
            Self::Straight(points) => points.len() as u32 - 1,
            Self::Arc { from, to, .. } if (to - from).abs() > 0.999 * TAU => 7,
            Self::Arc { from, to, .. } => (0.99 + 6.0 * (to - from).abs() / TAU).max(2.0) as u32,
            _ => 2,
        }
    }
}

/// The circle about a centre from one end to the other: the shorter arc; of two half circles the
/// one that runs counter-clockwise (from the last end, if reversed).
fn circle([first, centre, last]: [[f64; 2]; 3], reversed: bool) -> Result<Path, CurveFault> {
    let (a, b) = (difference(first, centre), difference(last, centre));
    let (ra, rb) = (libm::hypot(a[0], a[1]), libm::hypot(b[0], b[1]));
    if ra == 0.0 || rb == 0.0 {
        return Err(CurveFault::EndInCentre);
    }
    if (ra - rb).abs() > RADIUS_TOLERANCE * (ra + rb) {
        return Err(CurveFault::Radii(ra, rb));
    }
    let sine = (a[0] * b[1] - a[1] * b[0]) / (ra * rb);
    let cosine = (a[0] * b[0] + a[1] * b[1]) / (ra * rb);
    let sweep = if sine.abs() < 1e-15 && cosine < 0.0 {
        if reversed { -PI } else { PI }
    } else if sine.abs() < 1e-15 {
        // One end: a whole turn.
        if reversed { -TAU } else { TAU }
    } else {
        libm::atan2(sine, cosine)
    };
    Ok(Path::Arc { centre, u: a, v: [-a[1], a[0]], from: 0.0, to: sweep })
}

/// The ellipse about a centre with a given direction of an axis, through both ends.
fn ellipse(
    [first, centre, major, last]: [[f64; 2]; 4],
    reversed: bool,
) -> Result<Path, CurveFault> {
    let axis = difference(major, centre);
    let length = libm::hypot(axis[0], axis[1]);
    if length == 0.0 || first == centre || last == centre {
        return Err(CurveFault::EndInCentre);
    }
    let e = [axis[0] / length, axis[1] / length];
    let local = |p: [f64; 2]| {
        let d = difference(p, centre);
        [d[0] * e[0] + d[1] * e[1], d[1] * e[0] - d[0] * e[1]]
    };
    let ([x1, y1], [x2, y2]) = (local(first), local(last));
    // (x/a)² + (y/b)² = 1 at both ends: two linear equations for 1/a² and 1/b².
    let (a1, b1, a2, b2) = (x1 * x1, y1 * y1, x2 * x2, y2 * y2);
    let determinant = a1 * b2 - a2 * b1;
    let size = a1.max(b1) * a2.max(b2);
    let (radius_a, radius_b) = if determinant.abs() <= 1e-12 * size {
        // Ends on one axis, or opposite ones: a circle, if they are as far away.
        let (r1, r2) = ((a1 + b1).sqrt(), (a2 + b2).sqrt());
        if (r1 - r2).abs() > RADIUS_TOLERANCE * (r1 + r2) {
            return Err(CurveFault::NoEllipse);
        }
        (r1, r1)
    } else {
        let (p, q) = ((b2 - b1) / determinant, (a1 - a2) / determinant);
        if p.is_nan() || q.is_nan() || p <= 0.0 || q <= 0.0 {
            return Err(CurveFault::NoEllipse);
        }
        (1.0 / p.sqrt(), 1.0 / q.sqrt())
    };
    let angle = |x: f64, y: f64| libm::atan2(y / radius_b, x / radius_a);
    let (from, to) = (angle(x1, y1), angle(x2, y2));
    let mut sweep = to - from;
    if sweep.abs() > PI + 1e-12 {
        sweep -= TAU * sweep.signum();
    }
    if (sweep.abs() - PI).abs() < 1e-12 {
        sweep = if reversed { -PI } else { PI };
    }
    let u = [radius_a * e[0], radius_a * e[1]];
    let v = [-radius_b * e[1], radius_b * e[0]];
    Ok(Path::Arc { centre, u, v, from, to: from + sweep })
}

/// The piece in which a parameter lies, and the parameter within it.
fn piece(pieces: usize, t: f64) -> (usize, f64) {
    let scaled = t * pieces as f64;
    let i = (scaled as usize).min(pieces - 1);
    (i, scaled - i as f64)
}

/// A Catmull–Rom spline; beyond its ends it goes on straight, or around if it is closed.
fn catmull_rom(points: &[[f64; 2]], t: f64) -> [f64; 2] {
    let n = points.len();
    let (i, t) = piece(n - 1, t);
    let closed = points[0] == points[n - 1] && n > 2;
    let (b, c) = (points[i], points[i + 1]);
    let a = match i {
        0 if closed => points[n - 2],
        0 => mix(b, c, -1.0),
        i => points[i - 1],
    };
    let d = match points.get(i + 2) {
        Some(&d) => d,
        None if closed => points[1],
        None => mix(b, c, 2.0),
    };
    let (t2, t3) = (t * t, t * t * t);
    let weights = [
        -0.5 * t3 + t2 - 0.5 * t,
        1.5 * t3 - 2.5 * t2 + 1.0,
        -1.5 * t3 + 2.0 * t2 + 0.5 * t,
        0.5 * t3 - 0.5 * t2,
    ];
    combine([a, b, c, d], weights)
}

/// A uniform cubic B-spline around a closed polygon, whose last point is its first.
fn closed_b_spline(points: &[[f64; 2]], t: f64) -> [f64; 2] {
    let n = points.len() - 1;
    let (i, t) = piece(n, t);
    let (t2, t3) = (t * t, t * t * t);
    let weights = [
        (1.0 - 3.0 * t + 3.0 * t2 - t3) / 6.0,
        (4.0 - 6.0 * t2 + 3.0 * t3) / 6.0,
        (1.0 + 3.0 * t + 3.0 * t2 - 3.0 * t3) / 6.0,
        t3 / 6.0,
    ];
    combine([0, 1, 2, 3].map(|j| points[(i + n - 1 + j) % n]), weights)
}

/// A cubic B-spline whose knots are evenly spaced and repeated at the ends (de Boor's algorithm).
fn clamped_b_spline(points: &[[f64; 2]], t: f64) -> [f64; 2] {
    let degree = 3.min(points.len() - 1);
    let spans = points.len() - degree;
    let (span, within) = piece(spans, t);
    let x = span as f64 + within;
    let knot = |i: usize| (i as f64 - degree as f64).clamp(0.0, spans as f64);
    let mut d: Vec<[f64; 2]> = points[span..=span + degree].to_vec();
    for r in 1..=degree {
        for j in (r..=degree).rev() {
            let (low, high) = (knot(j + span), knot(j + 1 + span + degree - r));
            let weight = if high > low { (x - low) / (high - low) } else { 0.0 };
            d[j] = mix(d[j - 1], d[j], weight);
        }
    }
    d[degree]
}

/// De Casteljau's algorithm.
fn bezier(points: &[[f64; 2]], t: f64) -> [f64; 2] {
    let mut d = points.to_vec();
    for last in (0..d.len() - 1).rev() {
        for j in 0..=last {
            d[j] = mix(d[j], d[j + 1], t);
        }
    }
    d[0]
}

fn combine(points: [[f64; 2]; 4], weights: [f64; 4]) -> [f64; 2] {
    [0, 1].map(|i| points.iter().zip(weights).map(|(p, weight)| p[i] * weight).sum())
}

fn mix(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    [0, 1].map(|i| (1.0 - t) * a[i] + t * b[i])
}

pub(super) fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
