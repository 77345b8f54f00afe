//! G5, G6 and G7: Lemma 7 and Corollary 3 for every angle of the mesh.
//!
//! Angles are compared by cross and dot product. The bounds carry a stated relative slack: 1e-7
//! (equality occurs), so rounding in the comparison cannot matter where an angle is large; small
//! ones are computed again from products of 100 bits. Where an angle is compared with f(θ) the
//! slack is 1e-7 + 1.5·ulp(M)/|ab|: the bound is met with equality by points that are then rounded
//! to the coordinates of the output, each by up to 0.51 ulp, which turns the edge ab opposite the
//! angle by that much of itself (ALGORITHM §8 states 1e-7 alone; far from the origin the rounding
//! is more).

use std::f64::consts::PI;

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::exact;
use super::fault::{Fault, FaultKind};
use super::outline::{Angle, Outline};
use super::precision::Floor;
use super::verdict::{ExcusedAngle, Judgement};
use crate::corners::{each, next, previous};
use crate::parameters::MinAngle;

/// "Equality occurs: stated relative slack 1e-7" (ALGORITHM §8).
const SLACK: f64 = 1e-7;

/// How much rounding its two ends may shorten the edge opposite an angle, in ulp(M): each by
/// 0.51·√2.
const ROUNDING: f64 = 1.5;

/// What the angles of a mesh are.
#[derive(Default)]
pub(super) struct Angles {
    pub(super) smallest: Option<f64>,
    pub(super) largest: Option<f64>,
    pub(super) excused: Vec<ExcusedAngle>,
}

/// The judgements that this file makes. Without an outline G5 and G6 are not judged.
pub(super) struct AngleJudgements<'j> {
    pub(super) g5: &'j mut Judgement,
    pub(super) g6: &'j mut Judgement,
    pub(super) g7: &'j mut Judgement,
}

/// An outline and how it runs through the mesh.
#[derive(Clone, Copy)]
pub(super) struct Laid<'o, 'a> {
    pub(super) outline: &'o Outline<'a>,
    pub(super) theta_star: f64,
}

/// Judges every angle.
pub(super) fn judge(
    complex: &Complex,
    chains: &Chains,
    laid: Option<Laid>,
    floor: &Floor,
    min_angle: MinAngle,
    judgements: AngleJudgements,
) -> Angles {
    let AngleJudgements { g5, g6, g7 } = judgements;
    let kappa_hat = min_angle.radians();
    let tangent = libm::tan(kappa_hat * (1.0 - SLACK));
    let limit = largest_allowed(kappa_hat);
    // cot is monotone: an angle above the limit has dot < cross·cot(limit).
    let cotangent = 1.0 / libm::tan(limit + 1e-12);
    let bound = laid.map(|laid| kappa_hat.min(lemma_7(laid.theta_star)));
    let mut found = Angles::default();
    let mut extremes = Extremes::default();
    let usual = Usual { most: 1.0 / tangent, least: cotangent };
    let mut between = usual.within(&extremes);
    for t in 0..complex.triangles.len() {
        let points = complex.corners(t);
        let [p, q, r] = points;
        let sides = [vector(p, q), vector(q, r), vector(r, p)];
        let corners = each([0, 1, 2], |k| {
            let [x, y] = sides[previous(k)];
            cross_and_dot(sides[k], [-x, -y])
        });
        // (Most triangles are told by one question.)
        let [first, second, third] = each(corners, |corner| between.has(corner));
        if first & second & third {
            continue;
        }
        for (k, corner) in corners.into_iter().enumerate() {
            if between.has(corner) {
                continue;
            }
            let (cross, dot) = corner;
            // Plain numbers decide unless the angle is small or the triangle tiny or flat.
            let plain = cross > 1e-12 * dot.abs() && cross > 1e-150;
            let is_small = !plain || (dot > 0.0 && cross < tangent * dot);
            let is_large = dot < cross * cotangent;
            let (cross, dot) = if is_small || is_large {
                exact::corner(points[k], points[next(k)], points[previous(k)]).cross_and_dot()
            } else {
                (cross, dot)
            };
            extremes.see(cross, dot);
            between = usual.within(&extremes);
            if is_small && dot > 0.0 && cross < tangent * dot {
                let suspect =
                    Suspect { complex, chains, floor, t, k, angle: libm::atan2(cross, dot) };
                if let Some(laid) = laid {
                    suspect.judge_small(laid, g5, &mut found.excused);
                    suspect.judge_smallest(bound.unwrap_or(kappa_hat), g6);
                }
            }
            if is_large && dot < cross * cotangent {
                let angle = libm::atan2(cross, dot);
                Suspect { complex, chains, floor, t, k, angle }.judge_large(limit, g7);
            }
        }
    }
    found.smallest = Extremes::radians(extremes.smallest);
    found.largest = Extremes::radians(extremes.largest);
    found
}

/// The cotangents between which nothing is to be said of an angle: its bounds are kept, and the mesh
/// has smaller and larger ones.
#[derive(Clone, Copy)]
struct Usual {
    most: f64,
    least: f64,
}

impl Usual {
    /// Whether an angle is clearly one of these. (The answer is no for what is no number.)
    #[inline(always)]
    fn has(&self, (cross, dot): (f64, f64)) -> bool {
        (cross > 1e-150) & (dot < self.most * cross) & (dot > self.least * cross)
    }

    /// Those of these that lie between two angles of the mesh, by more than rounding.
    fn within(&self, extremes: &Extremes) -> Self {
        const MARGIN: f64 = 1e-9;
        let (Some(smallest), Some(largest)) = (&extremes.smallest, &extremes.largest) else {
            return Self { most: f64::NEG_INFINITY, least: f64::INFINITY };
        };
        let [most, least] = [smallest.cotangent.min(self.most), largest.cotangent.max(self.least)];
        // Beyond 1e9 a cross product may be too small for its digits.
        let most = (most - MARGIN * most.abs()).min(1e9);
        let least = (least + MARGIN * least.abs()).max(-1e9);
        Self { most, least }
    }
}

/// Corollary 3: max{π − 2κ̂, π − 2·arcsin((√3 − 1)/2)}.
fn largest_allowed(kappa_hat: f64) -> f64 {
    (PI - 2.0 * kappa_hat).max(PI - 2.0 * libm::asin((3.0_f64.sqrt() - 1.0) / 2.0))
}

/// Lemma 7: f(θ) = arctan(sin θ / (2 − cos θ)).
fn lemma_7(theta: f64) -> f64 {
    libm::atan2(libm::sin(theta), 2.0 - libm::cos(theta))
}

/// From one point to another, rounded.
fn vector(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn cross_and_dot([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> (f64, f64) {
    (ax * by - ay * bx, ax * bx + ay * by)
}

/// The smallest and the largest angle.
#[derive(Default)]
struct Extremes {
    smallest: Option<Extreme>,
    largest: Option<Extreme>,
}

/// An angle by its cross and dot product, and their quotient.
#[derive(Clone, Copy)]
struct Extreme {
    cross: f64,
    dot: f64,
    cotangent: f64,
}

impl Extremes {
    fn see(&mut self, cross: f64, dot: f64) {
        let this = Extreme { cross, dot, cotangent: dot / cross.abs() };
        // (Where all three points are one there is no angle: NaN is neither more nor less.)
        if this.cotangent.is_nan() {
            return;
        }
        if self.smallest.is_none_or(|other| this.cotangent > other.cotangent) {
            self.smallest = Some(this);
        }
        if self.largest.is_none_or(|other| this.cotangent < other.cotangent) {
            self.largest = Some(this);
        }
    }

    fn radians(extreme: Option<Extreme>) -> Option<f64> {
        extreme.map(|Extreme { cross, dot, .. }| libm::atan2(cross.abs(), dot))
    }
}

/// An angle that has to be looked at.
struct Suspect<'c, 'a> {
    complex: &'c Complex<'a>,
    chains: &'c Chains,
    floor: &'c Floor,
    /// The triangle and its corner.
    t: usize,
    k: usize,
    angle: f64,
}

impl Suspect<'_, '_> {
    /// Lemma 7 for an angle below κ̂: the ends of the edge opposite it lie inside of two segments
    /// that share an end at θ ≤ π/3, and the angle is at least f(θ).
    fn judge_small(&self, laid: Laid, g5: &mut Judgement, excused: &mut Vec<ExcusedAngle>) {
        let outline = laid.outline;
        let Some([s, t]) = self.segments_of_ends() else {
            return g5.add_unless(self.is_limited(), self.fault(FaultKind::UnexcusedAngle));
        };
        let theta = common_angle(outline, s, t).filter(|theta| theta.is_small());
        let Some(theta) = theta else {
            return g5.add_unless(self.is_limited(), self.fault(FaultKind::UnexcusedAngle));
        };
        let bound = theta.lemma_7();
        if self.angle < bound * (1.0 - self.slack()) {
            let fault = self.fault(FaultKind::BelowLemma7 { bound });
            return g5.add_unless(self.is_limited(), fault.of_segment(outline.segment_name(s)));
        }
        excused.push(ExcusedAngle {
            triangle: self.number(),
            angle: self.angle,
            edge: self.edge(),
            segments: [s, t].map(|s| outline.segment_name(s)),
            theta: theta.radians(),
        });
    }

    /// The relative slack of a bound that is met with equality but for the rounding of points.
    fn slack(&self) -> f64 {
        let [a, b] = self.edge().map(|v| self.complex.at(v));
        let length = libm::hypot(a[0] - b[0], a[1] - b[1]);
        SLACK + ROUNDING * self.complex.frame.ulp / length
    }

    fn judge_smallest(&self, bound: f64, g6: &mut Judgement) {
        if self.angle < bound * (1.0 - self.slack()) {
            g6.add_unless(self.is_limited(), self.fault(FaultKind::TooSmall { bound }));
        }
    }

    fn judge_large(&self, bound: f64, g7: &mut Judgement) {
        g7.add_unless(self.is_limited(), self.fault(FaultKind::TooLarge { bound }));
    }

    /// The distinct segments that the ends of the opposite edge lie strictly inside of.
    fn segments_of_ends(&self) -> Option<[u32; 2]> {
        let [s, t] = self.edge().map(|v| self.chains.inside(v));
        (s != NONE && t != NONE && s != t).then_some([s, t])
    }

    /// The edge opposite the angle.
    fn edge(&self) -> [u32; 2] {
        let corners = self.complex.triangles[self.t];
        [corners[(self.k + 1) % 3], corners[(self.k + 2) % 3]]
    }

    fn number(&self) -> u32 {
        self.complex.number_of(self.t)
    }

    fn is_limited(&self) -> bool {
        self.floor.covers(&self.complex.triangles[self.t])
            || self.floor.stops(self.complex, self.chains, self.t)
    }

    fn fault(&self, kind: FaultKind) -> Fault {
        Fault::at_triangle(self.complex.mesh, kind, self.number())
            .of_point(self.complex.triangles[self.t][self.k])
            .of_edge(self.edge())
            .of_angle(self.angle)
    }
}

/// The angle of two segments at their common end, if they have one.
fn common_angle(outline: &Outline, s: u32, t: u32) -> Option<Angle> {
    let ends = |s: u32| outline.segments[s as usize].ends;
    let pairs = (0..2).flat_map(|i| (0..2).map(move |j| (i, j)));
    let mut shared = pairs.filter(|&(i, j)| ends(s)[i as usize] == ends(t)[j as usize]);
    shared.next().map(|(i, j)| outline.angle(2 * s + i, 2 * t + j))
}
