//! G8: Corollary 2. The shortest edge against the feature size of the outline.
//!
//! |pq| ≥ lfs′_min·2 sin(θ*/2)/μ with μ = 1 + √2/(1 − 2 sin κ̂), where lfs′_min is that of the
//! augmented outline: its segments cut at their shell points, which the analysis takes for input.
//! The corollary speaks of what the outline and κ̂ alone ask for. A mesh with sizes or a soft target
//! has shorter edges by right; so an edge below the bound is a fault only where the run is known to
//! have been a plain one.
//!
//! The index is [`boxes`](crate::boxes), which knows rectangles and nothing else.

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::fault::{Fault, FaultKind};
use super::outline::{Outline, distance};
use super::precision::Floor;
use super::provenance::UNKNOWN;
use super::verdict::{Corollary2, Judgement, Promise};
use crate::boxes::{Boxes, Rectangle};
use crate::formats::Provenance;
use crate::hilbert::Curve;

/// Rounding of the lengths that are compared, relative.
const SLACK: f64 = 1e-9;

/// The search for lfs′_min gives up after this many nodes of the tree for each point, on average.
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
    let augmented = Augmented::new(outline, complex, chains);
    let Some(lfs_min) = augmented.lfs_min(shortest_between_features(complex, chains)) else {
        *g8 = Judgement::not_judged(g8.guarantee, "the least feature size takes too long to find");
        return None;
    };
    let mu = 1.0 + std::f64::consts::SQRT_2 / (1.0 - 2.0 * libm::sin(promise.min_angle.radians()));
    let bound = lfs_min * 2.0 * libm::sin(0.5 * theta_star) / mu;
    let mut shortest = f64::INFINITY;
    let has_sizes = !outline.pslg.point_sizes.is_empty()
        || outline.pslg.regions.iter().any(|region| region.max_area.is_some());
    let is_plain = promise.is_plain.map(|is_plain| is_plain && !has_sizes);
    for h in 0..complex.twin.len() as u32 {
        let [v, w] = complex.edge(h);
        let twin = complex.twin[h as usize];
        if twin != NONE && twin < h {
            continue;
        }
        let length = distance(complex.at(v), complex.at(w));
        shortest = shortest.min(length);
        if length < bound * (1.0 - SLACK) && is_plain == Some(true) {
            let bound = complex.frame.length_outside(bound);
            let length = complex.frame.length_outside(length);
            let kind = FaultKind::TooShort { length, bound };
            let is_limited = floor.covers(&complex.triangles[h as usize / 3]);
            g8.add_unless(is_limited, Fault::at_edge(complex.mesh, kind, [v, w]));
        }
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

/// The squared length of the shortest edge between points of the augmented outline: its closest
/// pair is as close or closer, and most often just that, as the closest points are Delaunay
/// neighbours.
fn shortest_between_features(complex: &Complex, chains: &Chains) -> f64 {
    let is_feature = |v: u32| {
        chains.input[v as usize] != NONE
            || (complex.mesh.provenance[v as usize] == Provenance::Shell
                && chains.inside[v as usize] != NONE)
    };
    let edges = (0..complex.twin.len() as u32).map(|h| complex.edge(h));
    let between = edges.filter(|edge| edge.iter().all(|&v| is_feature(v)));
    between.map(|[v, w]| squared(complex.at(v), complex.at(w))).fold(f64::INFINITY, f64::min)
}

/// The augmented outline: its points and shell points, and the pieces of segments between them.
struct Augmented {
    points: Vec<[f64; 2]>,
    pieces: Vec<[u32; 2]>,
}

impl Augmented {
    fn new(outline: &Outline, complex: &Complex, chains: &Chains) -> Self {
        let mut points = outline.points.clone();
        let mut pieces = Vec::new();
        for (segment, chain) in outline.segments.iter().zip(&chains.points) {
            let [mut from, to] = segment.ends;
            for &v in chain.iter().filter(|&&v| v != NONE) {
                if complex.mesh.provenance[v as usize] == Provenance::Shell {
                    let shell = points.len() as u32;
                    points.push(complex.at(v));
                    pieces.push([from, shell]);
                    from = shell;
                }
            }
            pieces.push([from, to]);
        }
        // Duplicates of points and what is no number are no features.
        let is_feature = |v: usize| outline.same.get(v).is_none_or(|&same| same as usize == v);
        for v in (0..points.len()).filter(|&v| !is_feature(v)) {
            points[v] = [f64::NAN; 2];
        }
        Self { points, pieces }
    }

    /// The points that are features, so ordered that neighbours are near each other.
    fn features_along_a_curve(&self) -> Vec<u32> {
        let at = |v: u32| self.points[v as usize];
        let is_feature = |&v: &u32| !at(v)[0].is_nan();
        let mut features: Vec<u32> = (0..self.points.len() as u32).filter(is_feature).collect();
        let nothing = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let (low, high) = features.iter().map(|&v| at(v)).fold(nothing, |(low, high), p| {
            ([0, 1].map(|i| low[i].min(p[i])), [0, 1].map(|i| high[i].max(p[i])))
        });
        let curve = Curve::new(low, high);
        features.sort_by_cached_key(|&v| curve.place(at(v)));
        features
    }

    /// Half the least distance of a point and a feature that does not contain it, of which the
    /// square is known to be `least` or less; `None` where the search takes too long or there is no
    /// such pair.
    fn lfs_min(&self, mut least: f64) -> Option<f64> {
        let at = |v: u32| self.points[v as usize];
        let features = self.features_along_a_curve();
        let around = |[v, w]: [u32; 2]| Rectangle::around(at(v), at(w));
        let points: Vec<_> = features.iter().map(|&v| around([v, v])).collect();
        let pieces: Vec<_> = self.pieces.iter().map(|&piece| around(piece)).collect();
        let (points, pieces) = (Boxes::in_order(&points), Boxes::new(&pieces));
        let mut budget = MOST_VISITS_PER_POINT * features.len();
        let place = |i: u32| at(features[i as usize]);
        let between_points = |i: u32, j: u32| match i == j {
            true => f64::INFINITY,
            false => squared(place(i), place(j)),
        };
        let to_piece = |i: u32, piece: u32| match self.pieces[piece as usize] {
            ends if ends.contains(&features[i as usize]) => f64::INFINITY,
            [a, b] => squared_from_segment(place(i), at(a), at(b)),
        };
        let found = points.least_distance_squared(&points, least, &mut budget, between_points);
        least = found.unwrap_or(least);
        let found = points.least_distance_squared(&pieces, least, &mut budget, to_piece);
        least = found.unwrap_or(least);
        (budget > 0 && least.is_finite()).then(|| 0.5 * least.sqrt())
    }
}

fn squared(p: [f64; 2], q: [f64; 2]) -> f64 {
    let (x, y) = (p[0] - q[0], p[1] - q[1]);
    x * x + y * y
}

/// The squared distance of `p` from the segment `ab`.
fn squared_from_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let part = (along[0] * to[0] + along[1] * to[1]) / squared(a, b);
    if part <= 0.0 {
        squared(p, a)
    } else if part >= 1.0 {
        squared(p, b)
    } else {
        let height = super::exact::cross(a, b, p).to_f64();
        height * height / squared(a, b)
    }
}
