//! Straight lines and arcs of circles in the plane, and where two of them meet.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::geo::model::{Arc, Curve, CurveKind, Model};

/// A place in the plane.
pub(super) type Place = [f64; 2];

/// A curve as a function of a parameter from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Track {
    Line {
        from: Place,
        to: Place,
    },
    /// Angles in radians; `to` may lie beyond a turn.
    Arc {
        centre: Place,
        radius: f64,
        from: f64,
        to: f64,
    },
}

impl Track {
    /// The track of a curve in a plane z = c; `None` for curves of other kinds.
    pub(super) fn of(model: &Model, curve: &Curve) -> Option<Self> {
        let at = |point: i32| model.points.get(point).map(|point| [point.at[0], point.at[1]]);
        match (&curve.kind, &curve.points[..]) {
            (CurveKind::Line, &[first, last]) => {
                Some(Self::Line { from: at(first)?, to: at(last)? })
            }
            (CurveKind::Arc(arc), _) => Self::of_arc(arc),
            (&CurveKind::Circle { reversed }, &[first, centre, last]) => {
                let (first, centre, last) = (at(first)?, at(centre)?, at(last)?);
                let angle = |p: Place| libm::atan2(p[1] - centre[1], p[0] - centre[0]);
                let (from, to) = (angle(first), angle(last));
                // The shorter way; of two half circles the one that turns to the left.
                let turn = (to - from) - TAU * ((to - from) / TAU).floor();
                let is_half = (turn - PI).abs() < 1e-12;
                let turn = match () {
                    () if is_half && reversed => -PI,
                    () if turn > PI && !is_half => turn - TAU,
                    () => turn,
                };
                Some(Self::Arc { centre, radius: distance(first, centre), from, to: from + turn })
            }
            _ => None,
        }
    }

    fn of_arc(arc: &Arc) -> Option<Self> {
        let (u, v) = (arc.u, arc.v);
        let radius = libm::hypot(u[0], u[1]);
        // A circle in this plane: both axes are as long and upright to each other.
        let is_round = (libm::hypot(v[0], v[1]) - radius).abs() <= 1e-12 * radius
            && (u[0] * v[0] + u[1] * v[1]).abs() <= 1e-12 * radius * radius
            && u[2] == 0.0
            && v[2] == 0.0;
        let begin = libm::atan2(u[1], u[0]);
        let way = (u[0] * v[1] - u[1] * v[0]).signum();
        let centre = [arc.centre[0], arc.centre[1]];
        let (from, to) = (begin + way * arc.from, begin + way * arc.to);
        is_round.then_some(Self::Arc { centre, radius, from, to })
    }

    /// The curve's kind, in the plane z = `z`.
    pub(super) fn kind(&self, z: f64) -> CurveKind {
        match *self {
            Self::Line { .. } => CurveKind::Line,
            Self::Arc { centre: [x, y], radius, from, to } => CurveKind::Arc(Box::new(Arc {
                centre: [x, y, z],
                u: [radius, 0.0, 0.0],
                v: [0.0, radius, 0.0],
                from,
                to,
            })),
        }
    }

    pub(super) fn at(&self, t: f64) -> Place {
        match *self {
            Self::Line { from, to } => [0, 1].map(|i| (1.0 - t) * from[i] + t * to[i]),
            Self::Arc { centre, radius, from, to } => {
                let (sin, cos) = libm::sincos(from + t * (to - from));
                [centre[0] + radius * cos, centre[1] + radius * sin]
            }
        }
    }

    /// A box around it: its least and its largest coordinates.
    pub(super) fn around(&self) -> [Place; 2] {
        match *self {
            Self::Line { from, to } => {
                [[0, 1].map(|i| from[i].min(to[i])), [0, 1].map(|i| from[i].max(to[i]))]
            }
            Self::Arc { centre, radius, .. } => {
                [centre.map(|x| x - radius), centre.map(|x| x + radius)]
            }
        }
    }

    pub(super) fn length(&self) -> f64 {
        match *self {
            Self::Line { from, to } => distance(from, to),
            Self::Arc { radius, from, to, .. } => radius * (to - from).abs(),
        }
    }

    /// The part between two parameters.
    pub(super) fn part(&self, first: f64, last: f64) -> Self {
        match *self {
            Self::Line { .. } => Self::Line { from: self.at(first), to: self.at(last) },
            Self::Arc { centre, radius, from, to } => {
                let angle = |t: f64| from + t * (to - from);
                Self::Arc { centre, radius, from: angle(first), to: angle(last) }
            }
        }
    }

    /// The parameter of a place that lies within `tolerance` of the curve; a little below 0 or
    /// above 1 at its ends.
    pub(super) fn parameter(&self, p: Place, tolerance: f64) -> Option<f64> {
        let (t, off) = match *self {
            Self::Line { from, to } => {
                let (d, e) = (minus(to, from), minus(p, from));
                let squared = dot(d, d);
                (dot(d, e) / squared, cross(d, e).abs() / squared.sqrt())
            }
            Self::Arc { centre, radius, from, to } => {
                let d = minus(p, centre);
                let turn = (libm::atan2(d[1], d[0]) - from) * (to - from).signum();
                let turn = turn - TAU * (turn / TAU).floor();
                let sweep = (to - from).abs();
                // Nearer to the begin from behind than to the end.
                let turn = if turn > 0.5 * (sweep + TAU) { turn - TAU } else { turn };
                (turn / sweep, (libm::hypot(d[0], d[1]) - radius).abs())
            }
        };
        let room = tolerance / self.length();
        (off <= tolerance && (-room..=1.0 + room).contains(&t)).then_some(t)
    }

    /// Twice the area between the curve and the lines from the origin to its ends.
    pub(super) fn doubled_area(&self) -> f64 {
        let chord = cross(self.at(0.0), self.at(1.0));
        match *self {
            Self::Line { .. } => chord,
            Self::Arc { radius, from, to, .. } => {
                let turn = to - from;
                chord + radius * radius * (turn - libm::sin(turn))
            }
        }
    }

    /// How often the ray from a place to the right crosses the curve, whose ends are `ends`.
    pub(super) fn crossings_right_of(&self, p: Place, ends: [Place; 2]) -> usize {
        let is_between = |a: f64, b: f64| (a > p[1]) != (b > p[1]);
        match *self {
            Self::Line { .. } => {
                let [a, b] = ends;
                let x = a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                usize::from(is_between(a[1], b[1]) && p[0] < x)
            }
            Self::Arc { centre, radius, from, to } => {
                // Between its highest and lowest places an arc goes up or down.
                let (low, high) = (from.min(to), from.max(to));
                let first = ((low - FRAC_PI_2) / PI).floor() as i64 + 1;
                let mut angles = vec![low];
                let turning = |k: i64| FRAC_PI_2 + PI * k as f64;
                angles.extend((first..).map(turning).take_while(|&angle| angle < high));
                angles.push(high);
                let height = |angle: f64| match angle {
                    angle if angle == from => ends[0][1],
                    angle if angle == to => ends[1][1],
                    angle => centre[1] + radius * libm::sin(angle),
                };
                let up = p[1] - centre[1];
                let across = (radius * radius - up * up).max(0.0).sqrt();
                let crosses = |pair: &&[f64]| {
                    let side = libm::cos(0.5 * (pair[0] + pair[1])).signum();
                    is_between(height(pair[0]), height(pair[1])) && p[0] < centre[0] + side * across
                };
                angles.windows(2).filter(crosses).count()
            }
        }
    }
}

/// The places where two curves cross or touch, as far as they are not ends of one of them on the
/// other; those on the lines and circles that they are parts of, too.
pub(super) fn meetings(a: &Track, b: &Track, tolerance: f64) -> Vec<Place> {
    match (*a, *b) {
        (Track::Line { from: p, to: q }, Track::Line { from: r, to: s }) => {
            let (d, e, f) = (minus(q, p), minus(s, r), minus(r, p));
            let turn = cross(d, e);
            if turn.abs() <= 1e-12 * (dot(d, d) * dot(e, e)).sqrt() {
                return Vec::new();
            }
            vec![a.at(cross(f, e) / turn)]
        }
        (Track::Line { from, to }, Track::Arc { centre, radius, .. })
        | (Track::Arc { centre, radius, .. }, Track::Line { from, to }) => {
            let d = minus(to, from);
            let foot = dot(minus(centre, from), d) / dot(d, d);
            let foot = [0, 1].map(|i| from[i] + foot * d[i]);
            on_circle(centre, radius, foot, d, tolerance)
        }
        (Track::Arc { centre: c, radius: r, .. }, Track::Arc { centre: d, radius: s, .. }) => {
            let between = minus(d, c);
            let squared = dot(between, between);
            if squared.sqrt() <= tolerance {
                return Vec::new();
            }
            // The foot of the line through both places where the circles meet.
            let along = 0.5 * (1.0 + (r * r - s * s) / squared);
            let foot = [0, 1].map(|i| c[i] + along * between[i]);
            on_circle(c, r, foot, [-between[1], between[0]], tolerance)
        }
    }
}

/// The places of a circle on a line, whose nearest place to the centre is `foot`.
fn on_circle(centre: Place, radius: f64, foot: Place, along: Place, tolerance: f64) -> Vec<Place> {
    let apart = distance(foot, centre);
    if (apart - radius).abs() <= tolerance {
        return vec![foot];
    }
    if apart > radius {
        return Vec::new();
    }
    let half = (radius * radius - apart * apart).sqrt() / dot(along, along).sqrt();
    [half, -half].map(|t| [0, 1].map(|i| foot[i] + t * along[i])).to_vec()
}

pub(super) fn distance(a: Place, b: Place) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

fn minus(a: Place, b: Place) -> Place {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Place, b: Place) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
