//! Where doubles end (ALGORITHM §9).
//!
//! Two segments that meet at x with angle θ cannot be told apart, as the theorem needs it, at a
//! distance d from x with θ²·d < 4·ulp(M) or θ·d < φ = 2^12·ulp(M). What lies in that stretch of
//! the two, or between them, follows from the outline alone; the triangles with a point there are
//! not promised G3 and G5–G7, and those whose circumcenter would replace such a triangle are not
//! promised G5–G7.
//!
//! Neither are those at two features that do not adjoin and are less than 2φ apart: between them
//! the theorem asks for edges that are shorter than φ, which are refused.

use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_3;

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::exact;
use super::outline::{Outline, distance};
use super::verdict::{Apex, Narrow, NarrowTo};

/// The points of the mesh that lie where doubles end.
pub(super) struct Floor {
    limited: Vec<bool>,
    /// The apexes that have such a point.
    pub(super) apexes: Vec<Apex>,
    /// The features that are too close to each other.
    pub(super) narrows: Vec<Narrow>,
}

impl Floor {
    /// No point of the mesh is taken to be there: nothing is known of an outline.
    pub(super) fn none(complex: &Complex) -> Self {
        Self { limited: vec![false; complex.points.len()], apexes: Vec::new(), narrows: Vec::new() }
    }

    /// The points that lie in the stretch of two segments of the outline.
    pub(super) fn new(outline: &Outline, complex: &Complex, chains: &Chains) -> Self {
        let mut floor = Self::none(complex);
        for x in outline.distinct_points() {
            let spokes = outline.spokes(x);
            let nearest = spokes
                .iter()
                .map(|&h| first_length(complex, chains, h))
                .fold(f64::INFINITY, f64::min);
            for (i, &g) in spokes.iter().enumerate() {
                // On counter-clockwise, as long as the angle is small enough to matter.
                for j in 1..spokes.len() {
                    let h = spokes[(i + j) % spokes.len()];
                    let theta = outline.angle(g, h).radians();
                    let reach = reach(theta, complex.frame.ulp);
                    let is_wide = theta > FRAC_PI_3;
                    if reach <= nearest || (is_wide && j > 1) || outline.turns_back(g, h) {
                        break;
                    }
                    floor.mark(outline, complex, chains, Stretch { x, g, h, theta, reach });
                }
            }
        }
        floor.find_narrows(outline, complex, chains);
        floor
    }

    /// Finds what is too close: a point of the outline opposite a piece of a segment, or beside
    /// another such point.
    fn find_narrows(&mut self, outline: &Outline, complex: &Complex, chains: &Chains) {
        let closest = 2.0 * FLOOR * complex.frame.ulp;
        let mut suspects: Vec<u32> = chains.bound().chain(complex.edges_below(closest)).collect();
        suspects.sort_unstable();
        suspects.dedup();
        for h in suspects {
            let (v, w, apex) = (complex.origin(h), complex.target(h), complex.apex(h));
            let [from, to, across] = [v, w, apex].map(|v| chains.input(v));
            if let Some(s) = chains.segment(h)
                && across != NONE
            {
                let ends = outline.segments[s as usize].ends;
                let [a, b] = ends.map(|v| outline.points[v as usize]);
                let gap = exact::cross(a, b, complex.at(apex)).to_f64().abs() / distance(a, b);
                if gap < closest && !ends.contains(&across) {
                    let to = NarrowTo::Segment(outline.segment_name(s));
                    self.mark_narrow(complex, apex, narrow(outline, complex, across, to, gap));
                }
            }
            if from < to && to != NONE {
                let gap = distance(complex.at(v), complex.at(w));
                if gap < closest {
                    let to = NarrowTo::Point(outline.point_name(to));
                    self.mark_narrow(complex, v, narrow(outline, complex, from, to, gap));
                }
            }
        }
    }

    /// Marks `v` and its neighbours within 4φ: as far as edges may be refused.
    fn mark_narrow(&mut self, complex: &Complex, v: u32, narrow: Narrow) {
        let reach = 4.0 * FLOOR * complex.frame.ulp;
        self.limited[v as usize] = true;
        for w in complex.around(v) {
            if distance(complex.at(v), complex.at(w)) < reach {
                self.limited[w as usize] = true;
            }
        }
        // (A gap is found once from either side.)
        if self.narrows.last() != Some(&narrow) {
            self.narrows.push(narrow);
        }
    }

    /// Whether a triangle or an edge, given by its points, has one in a stretch.
    pub(super) fn covers(&self, points: &[u32]) -> bool {
        self.is_anywhere() && points.iter().any(|&v| self.limited[v as usize])
    }

    /// Whether doubles end anywhere in the mesh.
    fn is_anywhere(&self) -> bool {
        !self.apexes.is_empty() || !self.narrows.is_empty()
    }

    /// Whether the cavity of the circumcenter of triangle `t` has a point in a stretch. There the
    /// circumcenter would encroach a subsegment whose splits were refused, or have a star that
    /// rounding makes no star: it was refused, and the triangle is as it is because of the stretch,
    /// though it has no point there.
    pub(super) fn stops(&self, complex: &Complex, chains: &Chains, t: usize) -> bool {
        if !self.is_anywhere() {
            return false;
        }
        let center = circumcenter(complex.triangles[t].map(|v| complex.at(v)));
        let (mut found, mut i) = (vec![t as u32], 0);
        while i < found.len() && found.len() < MOST_IN_A_CAVITY {
            if self.covers(&complex.triangles[found[i] as usize]) {
                return true;
            }
            for h in (3 * found[i]..3 * found[i] + 3).filter(|&h| !chains.is_subsegment(h)) {
                let beyond = complex.twin(h);
                if beyond == NONE || found.contains(&(beyond / 3)) {
                    continue;
                }
                let corners = complex.triangles[beyond as usize / 3];
                let [a, b, c] = corners.map(|v| complex.at(v));
                if exact::in_circle(a, b, c, center) == Ordering::Greater {
                    found.push(beyond / 3);
                }
            }
            i += 1;
        }
        false
    }

    fn mark(&mut self, outline: &Outline, complex: &Complex, chains: &Chains, stretch: Stretch) {
        let Stretch { x, g, h, theta, reach } = stretch;
        let origin = outline.points[x as usize];
        let near = |v: u32| distance(complex.at(v), origin) < reach;
        let mut found = Vec::new();
        for half in [g, h] {
            let chain = outward(chains, half).take_while(|&v| v != NONE);
            found.extend(chain.skip(1).take_while(|&v| near(v)));
        }
        if found.is_empty() {
            return;
        }
        // Then what is strictly between the two, from neighbour to neighbour. (At a
        // wide angle only what lies on the two.)
        let [p, q] = [g, h].map(|half| outline.points[outline.target(half) as usize]);
        let between = |v: u32| {
            let at = complex.at(v);
            exact::orientation(origin, p, at) == Ordering::Greater
                && exact::orientation(origin, q, at) == Ordering::Less
        };
        let mut seen: Vec<u32> = found.clone();
        seen.sort_unstable();
        let mut i = 0;
        while i < found.len() && theta <= FRAC_PI_3 {
            for w in complex.around(found[i]) {
                if let Err(place) = seen.binary_search(&w)
                    && near(w)
                    && between(w)
                {
                    seen.insert(place, w);
                    found.push(w);
                }
            }
            i += 1;
        }
        for v in found {
            self.limited[v as usize] = true;
        }
        self.apexes.push(Apex {
            point: outline.point_name(x),
            segments: [g, h].map(|half| outline.segment_name(half / 2)),
            theta,
            reach: complex.frame.length_outside(reach),
            place: outline.pslg.points[x as usize],
        });
    }
}

/// Two half-edges of the outline that leave x, counter-clockwise at angle θ.
struct Stretch {
    x: u32,
    g: u32,
    h: u32,
    theta: f64,
    reach: f64,
}

/// φ in ulp(M): nothing shorter is made.
pub(super) const FLOOR: f64 = 4096.0;

/// A circumcenter is looked for in no more triangles.
const MOST_IN_A_CAVITY: usize = 64;

/// The circumcenter, rounded.
fn circumcenter([a, b, c]: [[f64; 2]; 3]) -> [f64; 2] {
    let [p, q] = [b, c].map(|corner| [corner[0] - a[0], corner[1] - a[1]]);
    let [pp, qq] = [p, q].map(|side| side[0] * side[0] + side[1] * side[1]);
    let twice = 2.0 * exact::cross(a, b, c).to_f64();
    [a[0] + (q[1] * pp - p[1] * qq) / twice, a[1] + (p[0] * qq - q[0] * pp) / twice]
}

fn narrow(outline: &Outline, complex: &Complex, point: u32, to: NarrowTo, gap: f64) -> Narrow {
    Narrow {
        point: outline.point_name(point),
        to,
        gap: complex.frame.length_outside(gap),
        place: outline.pslg.points[point as usize],
    }
}

/// The distance from the apex at which θ²·d ≥ 4·ulp(M) and θ·d ≥ 2^12·ulp(M).
fn reach(theta: f64, ulp: f64) -> f64 {
    (4.0 * ulp / (theta * theta)).max(FLOOR * ulp / theta)
}

/// The chain of a half-edge of the outline, from the point that it leaves.
fn outward(chains: &Chains, half: u32) -> impl Iterator<Item = u32> + '_ {
    let points = chains.points(half / 2);
    let count = points.len();
    let forward = half.is_multiple_of(2);
    (0..count).map(move |i| points[if forward { i } else { count - 1 - i }])
}

/// The length of the first piece of a half-edge of the outline.
fn first_length(complex: &Complex, chains: &Chains, half: u32) -> f64 {
    let mut chain = outward(chains, half);
    match (chain.next(), chain.next()) {
        (Some(v), Some(w)) if v != NONE && w != NONE => distance(complex.at(v), complex.at(w)),
        _ => f64::INFINITY,
    }
}
