//! G8: Corollary 2. The shortest edge against the feature size of the outline.
//!
//! |pq| ≥ lfs′_min·2 sin(θ*/2)/μ with μ = 1 + √2/(1 − 2 sin κ̂), where lfs′_min is that of the
//! augmented outline: its segments cut at their shell points, which the analysis takes for input.
//! The corollary speaks of what the outline and κ̂ alone ask for. A mesh with sizes or a soft target
//! has shorter edges by right; so an edge below the bound is a fault only where the run is known to
//! have been a plain one.
//!

use super::closest::Runs;
use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::fault::{Fault, FaultKind};
use super::outline::{Outline, distance, distance_squared};
use super::precision::Floor;
use super::provenance::UNKNOWN;
use super::verdict::{Corollary2, Judgement, Promise};
use crate::boxes::Rectangle;
use crate::formats::Provenance;

/// Rounding of the lengths that are compared, relative.
const SLACK: f64 = 1e-9;

/// The search for lfs′_min gives up after this many pairs for each point, on average.
const MOST_VISITS_PER_POINT: usize = 1000;

/// Judges G8; what the bound rests on, in the units of the file.
pub(super) fn judge(
    outline: &Outline,
    complex: &Complex,
    chains: &Chains,
    floor: &Floor,
    promise: &Promise,
    theta_star: f64,
    g8: &mut Judgement,
) -> Option<Corollary2> {
    if complex.mesh.provenance.len() != complex.points.len() {
        *g8 = Judgement::not_judged(g8.guarantee, UNKNOWN);
        return None;
    }
    let Some(lfs_min) = Augmented::new(outline, complex, chains).lfs_min() else {
        *g8 = Judgement::not_judged(g8.guarantee, "the least feature size takes too long to find");
        return None;
    };
    let mu = 1.0 + std::f64::consts::SQRT_2 / (1.0 - 2.0 * libm::sin(promise.min_angle.radians()));
    let bound = lfs_min * 2.0 * libm::sin(0.5 * theta_star) / mu;
    let shortest = complex.shortest;
    let has_sizes = !outline.pslg.point_sizes.is_empty()
        || outline.pslg.regions.iter().any(|region| region.max_area.is_some());
    let is_plain = promise.is_plain.map(|is_plain| is_plain && !has_sizes);
    if shortest < bound * (1.0 - SLACK) && is_plain == Some(true) {
        report_short_edges(complex, floor, bound, g8);
    }
    if shortest < bound * (1.0 - SLACK) && is_plain != Some(true) {
        const REASON: &str = "edges are shorter than the outline alone asks for, as sizes and soft \
                              targets make them";
        *g8 = Judgement::not_judged(g8.guarantee, REASON);
    }
    let [lfs_min, bound, shortest] =
        [lfs_min, bound, shortest].map(|length| complex.frame.length_outside(length));
    Some(Corollary2 { lfs_min, bound, shortest })
}

/// Tells of every edge below the bound.
fn report_short_edges(complex: &Complex, floor: &Floor, bound: f64, g8: &mut Judgement) {
    for h in complex.edges_below(bound * (1.0 - SLACK)) {
        let [v, w] = complex.edge(h);
        let length = distance(complex.at(v), complex.at(w));
        let twin = complex.twin(h);
        if twin != NONE && twin < h {
            continue;
        }
        let [length, bound] = [length, bound].map(|length| complex.frame.length_outside(length));
        let fault = Fault::at_edge(complex.mesh, FaultKind::TooShort { length, bound }, [v, w]);
        g8.add_unless(floor.covers(&complex.triangles[h as usize / 3]), fault);
    }
}

/// The augmented outline: its points and shell points, and the pieces of segments between them.
struct Augmented<'o> {
    outline: &'o Outline<'o>,
    /// The shell points; they are counted on from the outline's points.
    shells: Vec<[f64; 2]>,
    /// The features that are points, in the order of the curve.
    features: Vec<u32>,
    /// The pieces, by the number of their first end in the mesh and so along the curve.
    pieces: Vec<[u32; 2]>,
}

impl<'o> Augmented<'o> {
    fn new(outline: &'o Outline, complex: &Complex, chains: &Chains) -> Self {
        let is_shell = |v: u32| complex.mesh.provenance[v as usize] == Provenance::Shell;
        let count = outline.points.len() as u32;
        let (mut shells, mut shell_points) = (Vec::new(), Vec::new());
        let kinds = complex.mesh.provenance.iter();
        let shell_count = kinds.filter(|&&kind| kind == Provenance::Shell).count();
        let mut placed = Vec::with_capacity(outline.segments.len() + shell_count);
        for (s, segment) in (0..).zip(&outline.segments) {
            let [mut from, to] = segment.ends;
            let mut first = chains.vertex[from as usize];
            for &v in chains.points(s).iter().filter(|&&v| v != NONE && is_shell(v)) {
                let shell = count + shells.len() as u32;
                shell_points.push(u64::from(v) << 32 | u64::from(shell));
                shells.push(complex.at(v));
                placed.push((first, [from, shell]));
                (first, from) = (v, shell);
            }
            placed.push((first, [from, to]));
        }
        placed.sort_unstable();
        let pieces = placed.into_iter().map(|(_, piece)| piece).collect();
        shell_points.sort_unstable();
        let features = merged(outline, chains, &shell_points);
        Self { outline, shells, features, pieces }
    }

    fn at(&self, feature: u32) -> [f64; 2] {
        let count = self.outline.points.len();
        match self.outline.points.get(feature as usize) {
            Some(&point) => point,
            None => self.shells[feature as usize - count],
        }
    }

    /// Half the least distance of a point and a feature that does not contain it; `None` where the
    /// search takes too long or there is no such pair.
    fn lfs_min(mut self) -> Option<f64> {
        let features = std::mem::take(&mut self.features);
        let at = |feature: u32| self.at(feature);
        // Most often the closest points follow each other along the curve, or nearly so.
        let neighbours = features.windows(2).map(|pair| distance_squared(at(pair[0]), at(pair[1])));
        let mut least = neighbours.fold(f64::INFINITY, f64::min);
        let mut budget = MOST_VISITS_PER_POINT * features.len();
        let ends = |piece: u32| self.pieces[piece as usize];
        let points = Runs::new(features, |v| Rectangle::around(at(v), at(v)));
        let pieces = Runs::new((0..self.pieces.len() as u32).collect(), |piece| {
            let [a, b] = ends(piece).map(at);
            Rectangle::around(a, b)
        });
        let found = points.least_within(least, &mut budget, |v, w| distance_squared(at(v), at(w)));
        least = found.unwrap_or(least);
        let to_piece = |v: u32, piece: u32| match ends(piece) {
            ends if ends.contains(&v) => f64::INFINITY,
            [a, b] => squared_from_segment(at(v), at(a), at(b)),
        };
        let found = points.least_between(&pieces, least, &mut budget, to_piece);
        least = found.unwrap_or(least);
        (budget > 0 && least.is_finite()).then(|| 0.5 * least.sqrt())
    }
}

/// The points of an outline (duplicates and what is no number are no features) and the shell points
/// in one order: that of the points of the mesh, which the outline's are in, too.
///
/// `shells`: the point of the mesh in the high half, the feature in the low one.
fn merged(outline: &Outline, chains: &Chains, shells: &[u64]) -> Vec<u32> {
    let mut features = Vec::with_capacity(outline.points.len() + shells.len());
    let mut points = outline.distinct_points().peekable();
    for &shell in shells {
        let is_before = |&w: &u32| match chains.vertex[w as usize] {
            NONE => true, // no point of the mesh
            v => u64::from(v) < shell >> 32,
        };
        features.extend(std::iter::from_fn(|| points.next_if(is_before)));
        features.push(shell as u32);
    }
    features.extend(points);
    features
}

/// The squared distance of `p` from the segment `ab`.
fn squared_from_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let part = (along[0] * to[0] + along[1] * to[1]) / distance_squared(a, b);
    if part <= 0.0 {
        distance_squared(p, a)
    } else if part >= 1.0 {
        distance_squared(p, b)
    } else {
        let height = super::exact::cross(a, b, p).to_f64();
        height * height / distance_squared(a, b)
    }
}
