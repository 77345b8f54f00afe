//! The input segments as the refinement sees them: their ends, what adjoins them, their angles.

use super::ladder::{self, Border};
use super::piece::{PieceEnd, Split};
use super::provenance::{End, Kind, Origin, Provenances, SegmentPoint};
use super::shells;
use crate::constructions::{Angle, segment_length};
use crate::domain::Domain;
use crate::double_double::DoubleDouble;
use crate::parameters::Splitting;

/// The segments of a domain whose points are the first vertices of its triangulation.
#[derive(Debug, Clone)]
pub struct Segments<'a> {
    /// The vertices at the ends of each segment.
    pub ends: &'a [[u32; 2]],
    domain: &'a Domain,
    /// For each end of each segment the sine of the smallest angle there to an adjoining segment,
    /// if that is below 90°, else 0: then the end needs no ladder.
    sines: Vec<[f64; 2]>,
    floor: f64,
}

/// How many segments on either side, in their order around an end, count for the gap there.
///
/// Choice: a segment farther around could only be nearer where all those between are short, and a
/// vertex may have a hundred thousand segments. The territory point may be anywhere (Theorem 4).
const GAP_NEIGHBOURS: usize = 32;

impl<'a> Segments<'a> {
    /// The segments of a domain, whose points are the first of `points`. No split makes a piece shorter
    /// than `floor`.
    #[must_use]
    pub fn of(domain: &'a Domain, points: &[[f64; 2]], floor: f64) -> Self {
        let mut made = Self { ends: &domain.segments, domain, sines: Vec::new(), floor };
        made.sines = made.smallest_sines(points);
        made
    }

    /// The segments that end at a vertex of the domain, counter-clockwise.
    #[must_use]
    pub fn at(&self, vertex: u32) -> &'a [u32] {
        self.domain.adjoining(vertex)
    }

    /// The segment between two vertices of the domain.
    #[must_use]
    pub fn between(&self, a: u32, b: u32) -> Option<u32> {
        let (few, other) = if self.at(a).len() <= self.at(b).len() { (a, b) } else { (b, a) };
        self.at(few).iter().copied().find(|&s| self.ends[s as usize].contains(&other))
    }

    /// The end that two distinct segments share, as an index into the ends of each.
    #[must_use]
    pub fn shared_end(&self, s: u32, t: u32) -> Option<[End; 2]> {
        let (s, t) = (self.ends[s as usize], self.ends[t as usize]);
        (0..4).find(|i| s[i / 2] == t[i % 2]).map(|i| [(i / 2) as End, (i % 2) as End])
    }

    /// The angle between two segments at the end they share.
    #[must_use]
    pub fn angle(&self, s: u32, t: u32, shared: [End; 2], points: &[[f64; 2]]) -> Angle {
        let (apex, [p, q]) = self.corner(s, t, shared, points);
        Angle::at(apex, p, q)
    }

    /// The end that two segments share, and their others.
    fn corner(
        &self,
        s: u32,
        t: u32,
        shared: [End; 2],
        points: &[[f64; 2]],
    ) -> ([f64; 2], [[f64; 2]; 2]) {
        let at = |v: u32| points[v as usize];
        let (s, t) = (self.ends[s as usize], self.ends[t as usize]);
        let [i, j] = shared.map(usize::from);
        (at(s[i]), [at(s[1 - i]), at(t[1 - j])])
    }

    /// The sine of the smallest angle below 90° to an adjoining segment at each end; 0 where there
    /// is none.
    #[must_use]
    pub fn sines(&self, segment: u32) -> [f64; 2] {
        self.sines[segment as usize]
    }

    /// Where the piece of `segment` between the vertices `piece` is split.
    #[must_use]
    pub fn split(
        &self,
        splitting: Splitting,
        segment: u32,
        piece: [u32; 2],
        points: &[[f64; 2]],
        provenances: &Provenances,
    ) -> SegmentPoint {
        let sines = self.sines[segment as usize];
        let whole = piece.iter().all(|&v| provenances.segment_point(v).is_none());
        let border = if whole { self.border(splitting, segment, points) } else { None };
        let (apex, split) = match border {
            Some(Border { nearer, distance }) if distance > 0.0 => {
                (nearer, Split { distance, kind: Kind::Shell, origin: Origin::Border })
            }
            _ => {
                let apex = match border {
                    Some(given_up) => 1 - given_up.nearer,
                    None => self.owner(segment, piece, provenances),
                };
                let [near, far] = self.piece_ends(segment, apex, piece, points, provenances);
                let split = match splitting {
                    Splitting::Shells => shells::split(near, far),
                    Splitting::Augment => Split::at_middle(near, far, Kind::Midpoint, Origin::Rung),
                    Splitting::Ladder if sines == [0.0, 0.0] => {
                        Split::at_middle(near, far, Kind::Midpoint, Origin::Rung)
                    }
                    Splitting::Ladder => ladder::split(sines[apex], near, far),
                };
                (apex, split)
            }
        };
        SegmentPoint {
            segment,
            distance: split.distance,
            apex: apex as End,
            kind: split.kind,
            origin: split.origin,
        }
    }

    /// Where a whole segment's two ends divide it, if both own a part.
    fn border(&self, splitting: Splitting, segment: u32, points: &[[f64; 2]]) -> Option<Border> {
        let ends = self.ends[segment as usize];
        let (length, _) = segment_length(points[ends[0] as usize], points[ends[1] as usize]);
        match splitting {
            Splitting::Shells => Some(Border { nearer: 0, distance: 0.5 * length }),
            Splitting::Augment => None,
            Splitting::Ladder if self.sines[segment as usize].contains(&0.0) => None,
            Splitting::Ladder => {
                let gaps = [0, 1].map(|end| self.gap(segment, end, points));
                let at = |end: usize| {
                    let gap = &gaps[end];
                    move |d: f64| gap.iter().map(|g| g.at(d)).fold(d, f64::min)
                };
                Some(ladder::territory_point(length, [&at(0), &at(1)], self.floor))
            }
        }
    }

    /// The end that owns a piece: the one its points count from. The border belongs to neither,
    /// so a piece between it and an end is that end's.
    fn owner(&self, segment: u32, piece: [u32; 2], provenances: &Provenances) -> usize {
        let own = piece.iter().find_map(|&v| {
            let point = provenances.segment_point(v)?;
            (point.origin != Origin::Border).then_some(usize::from(point.apex))
        });
        let border = piece.iter().any(|&v| provenances.segment_point(v).is_some());
        let ends = self.ends[segment as usize];
        own.unwrap_or_else(|| {
            if border {
                usize::from(piece.contains(&ends[1]))
            } else {
                // The whole segment: the one end with a ladder, or either.
                usize::from(self.sines[segment as usize][0] == 0.0)
            }
        })
    }

    /// The ends of a piece as its apex counts, the near one first.
    fn piece_ends(
        &self,
        segment: u32,
        apex: usize,
        piece: [u32; 2],
        points: &[[f64; 2]],
        provenances: &Provenances,
    ) -> [PieceEnd; 2] {
        let ends = self.ends[segment as usize];
        let (length, exact) = segment_length(points[ends[0] as usize], points[ends[1] as usize]);
        let mut found = piece.map(|v| match provenances.segment_point(v) {
            Some(own) if usize::from(own.apex) == apex => PieceEnd {
                distance: own.distance,
                exact: own.origin != Origin::Middle,
                bisected: own.origin == Origin::Middle,
                ends_part: own.origin == Origin::Border,
            },
            Some(border) => {
                let rest = DoubleDouble::difference(length, border.distance);
                let exact = exact && rest.lo == 0.0;
                PieceEnd { distance: rest.hi, exact, bisected: false, ends_part: true }
            }
            None if v == ends[apex] => {
                PieceEnd { distance: 0.0, exact: true, bisected: false, ends_part: false }
            }
            None => PieceEnd { distance: length, exact, bisected: false, ends_part: true },
        });
        found.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        found
    }

    /// For each end of each segment, the sine of the smallest angle below 90° there, or 0. The
    /// smallest angle is one to a rotational neighbour.
    fn smallest_sines(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut sines = vec![[0.0; 2]; self.ends.len()];
        for vertex in 0..self.domain.input_points.len() as u32 {
            let around = self.at(vertex);
            let pairs = match around.len() {
                0 | 1 => 0,
                2 => 1,
                many => many,
            };
            for i in 0..pairs {
                let (s, t) = (around[i], around[(i + 1) % around.len()]);
                let Some(shared) = self.shared_end(s, t) else { continue };
                let (apex, ends) = self.corner(s, t, shared, points);
                if Angle::is_surely_wider(apex, ends, 0.0) {
                    continue;
                }
                let angle = Angle::at(apex, ends[0], ends[1]);
                if angle.is_acute() {
                    for (segment, end) in [(s, shared[0]), (t, shared[1])] {
                        let sine = &mut sines[segment as usize][usize::from(end)];
                        if *sine == 0.0 || angle.sine() < *sine {
                            *sine = angle.sine();
                        }
                    }
                }
            }
        }
        sines
    }

    /// What the gap at an end of a segment is made of.
    fn gap(&self, segment: u32, end: usize, points: &[[f64; 2]]) -> Vec<Gap> {
        let around = self.at(self.ends[segment as usize][end]);
        let place = around.iter().position(|&s| s == segment).unwrap_or(0);
        let reach = GAP_NEIGHBOURS.min(around.len() / 2);
        let steps = (1..=reach).flat_map(|i| [i, around.len() - i]);
        steps
            .filter_map(|step| {
                let t = around[(place + step) % around.len()];
                let shared = self.shared_end(segment, t)?;
                let angle = self.angle(segment, t, shared, points);
                let [a, b] = self.ends[t as usize].map(|v| points[v as usize]);
                let (length, _) = segment_length(a, b);
                angle.is_acute().then(|| Gap { sine: angle.sine(), cosine: angle.cosine(), length })
            })
            .collect()
    }
}

/// A segment that adjoins at an acute angle.
#[derive(Debug, Clone, Copy)]
struct Gap {
    sine: f64,
    cosine: f64,
    length: f64,
}

impl Gap {
    /// The distance to it of the point at distance `d` from the common end.
    fn at(self, d: f64) -> f64 {
        let beyond = d * self.cosine - self.length;
        let across = d * self.sine;
        if beyond <= 0.0 { across } else { (beyond * beyond + across * across).sqrt() }
    }
}
