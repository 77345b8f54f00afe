//! Segments in pieces of their target sizes, before anything else is refined.
//!
//! A segment without a small angle at its ends gets as many pieces as there are sizes along it,
//! each as long as the size there: pieces halved again and again would be off by up to √2 either
//! way. Like Algorithm 1 (§9) this only changes what the refinement begins with. At a small angle
//! ladders alone keep the promises: such a segment is halved until its pieces are short enough.

use std::ops::ControlFlow;

use super::interpolation::mean;
use super::provenance::{End as SegmentEnd, Kind, Origin, SegmentPoint};
use super::trace::Cause;
use super::{Flow, Refinement, Watch};
use crate::constructions::segment_length;
use crate::predicates::Relative;
use crate::triangulation::Edge;

/// A piece may be this much longer than its size before there is one more: as in Gmsh, whose edges
/// meshes of given sizes are compared with.
const ROOM: f64 = 0.99;

/// What is halved again and again is too long where it is more than this times the size at its
/// ends: then pieces are of the size on average.
const LONGEST_PIECE: f64 = 1.4;

/// The sine of the smallest angle at an end at which a segment may be cut anywhere.
///
/// Choice: from 30° on, pieces of equal length on both legs are at least half of that apart.
const LEAST_SINE: f64 = 0.5;

/// The tangent of the largest angle by which a curve turns where two of its chords meet: 20°.
const SMOOTH: f64 = 0.364;

/// The lengths of the pieces at a vertex.
#[derive(Debug, Clone, Copy, Default)]
struct Lengths {
    sum: f64,
    count: u32,
}

impl Lengths {
    fn add(&mut self, length: f64) {
        self.sum += length;
        self.count += 1;
    }
}

impl Refinement<'_> {
    /// Restores conformality. Where there are sizes, cuts the segments to them first, and fixes those
    /// inside: at a vertex the mean of the pieces there, linear between.
    pub(super) fn divide_by_sizes(&mut self, watch: &mut Watch) -> Flow {
        if self.sizes.is_none() {
            self.find_encroached_subsegments();
            return self.restore_conformality(watch);
        }
        let mut lengths = vec![Lengths::default(); self.mesh.points.len()];
        for segment in 0..self.segments.ends.len() as u32 {
            self.divide(segment, &mut lengths)?;
        }
        self.find_encroached_subsegments();
        self.restore_conformality(watch)?;
        self.halve_what_is_longer_than_its_size()?;
        self.restore_conformality(watch)?;
        self.take_sizes_from(&lengths);
        self.keep_background();
        ControlFlow::Continue(())
    }

    /// Cuts one segment, and notes the lengths of its pieces at their ends.
    fn divide(&mut self, segment: u32, lengths: &mut Vec<Lengths>) -> Flow {
        let ends = self.segments.ends[segment as usize];
        let [a, b] = ends.map(|v| self.mesh.points[v as usize]);
        let (length, _) = segment_length(a, b);
        let Some(law) = self.law(ends, length) else { return ControlFlow::Continue(()) };
        let pieces = law.pieces(length);
        let is_free = self.segments.sines(segment).iter().all(|&s| s == 0.0 || s >= LEAST_SINE);
        if !is_free || self.mesh.subsegment(ends[0], ends[1]).is_none() {
            // Its pieces will be about as long as the size.
            let [first, last] = law.ends.map(|size| size.min(length));
            lengths[ends[0] as usize].add(first);
            lengths[ends[1] as usize].add(last);
            return ControlFlow::Continue(());
        }
        let (mut from, mut before) = (ends[0], 0.0);
        for i in 1..pieces {
            self.leave_room()?;
            let distance = law.at(i as f64 / pieces as f64, length);
            let edge = self.mesh.subsegment(from, ends[1]);
            let point = point(segment, [i, pieces], distance, length);
            if edge.is_none_or(|edge| self.commit_split(edge, point).is_err()) {
                break;
            }
            self.tell_split([from, ends[1]], Cause::Size);
            lengths.push(Lengths::default());
            lengths[from as usize].add(distance - before);
            from = self.mesh.points.len() as u32 - 1;
            lengths[from as usize].add(distance - before);
            before = distance;
        }
        lengths[from as usize].add(length - before);
        lengths[ends[1] as usize].add(length - before);
        ControlFlow::Continue(())
    }

    /// The sizes along a segment; `None` where neither end has one.
    fn law(&self, ends: [u32; 2], length: f64) -> Option<Law> {
        let sizes = self.sizes.as_ref()?;
        let any = mean(ends.map(|v| (v, 1.0)), |v| sizes.at(v));
        let at = |v: u32| Some(sizes.at(v)).filter(|size| size.is_finite()).unwrap_or(any);
        (any.is_finite() && length > 0.0).then(|| Law { ends: ends.map(at) })
    }

    /// Halves what is too long: pieces at small angles, and those that the sizes of only one end
    /// reach.
    fn halve_what_is_longer_than_its_size(&mut self) -> Flow {
        let edges: Vec<Edge> = self.mesh.constrained_edges().collect();
        let mut pieces: Vec<[u32; 2]> = edges.iter().map(|&edge| self.mesh.ends(edge)).collect();
        while let Some(ends @ [a, b]) = pieces.pop() {
            if self.is_longer_than_its_size(ends) && self.mesh.subsegment(a, b).is_some() {
                self.leave_room()?;
                if self.split(ends, Cause::Size) {
                    let middle = self.mesh.points.len() as u32 - 1;
                    pieces.extend([[a, middle], [middle, b]]);
                }
            }
        }
        ControlFlow::Continue(())
    }

    fn is_longer_than_its_size(&self, ends: [u32; 2]) -> bool {
        let [a, b] = ends.map(|v| self.mesh.points[v as usize]);
        self.sizes.as_ref().is_some_and(|sizes| {
            let longest = LONGEST_PIECE * mean(ends.map(|v| (v, 1.0)), |v| sizes.at(v));
            Relative::of(a, b).squared > longest * longest
        })
    }

    /// The size at a vertex that has one is the mean of its pieces; a point within a curve keeps
    /// the one it has: chords may be shorter for the sake of the curve's shape.
    fn take_sizes_from(&mut self, lengths: &[Lengths]) {
        let is_kept = |v: u32| self.provenances.is_input(v) && self.is_smooth_at(v);
        let kept: Vec<bool> = (0..lengths.len() as u32).map(is_kept).collect();
        let Some(sizes) = &mut self.sizes else { return };
        for (vertex, (length, kept)) in (0..).zip(lengths.iter().zip(kept)) {
            if !kept && sizes.at(vertex).is_finite() && length.count > 0 {
                sizes.set(vertex, length.sum / f64::from(length.count));
            }
        }
    }

    /// Whether two segments go on into one another at a point of the outline: at 160° or more.
    fn is_smooth_at(&self, vertex: u32) -> bool {
        let &[s, t] = self.segments.at(vertex) else { return false };
        self.segments.shared_end(s, t).is_some_and(|shared| {
            let angle = self.segments.angle(s, t, shared, &self.mesh.points);
            angle.dot < 0.0 && angle.cross <= SMOOTH * -angle.dot
        })
    }
}

/// The point between piece i and the next of so many: each half of a segment counts from its own
/// end, the point in the middle belongs to neither.
fn point(segment: u32, [i, pieces]: [u64; 2], distance: f64, length: f64) -> SegmentPoint {
    let apex = SegmentEnd::from(2 * i > pieces);
    let distance = if apex == 0 { distance } else { length - distance };
    let origin = if 2 * i == pieces { Origin::Border } else { Origin::Rung };
    SegmentPoint { segment, distance, apex, kind: Kind::Shell, origin }
}

/// Sizes that are linear along a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Law {
    ends: [f64; 2],
}

impl Law {
    /// How many pieces there are: the integral of 1/size, rounded.
    fn pieces(self, length: f64) -> u64 {
        let [a, b] = self.ends;
        let count = if self.is_even() {
            length / (0.5 * (a + b))
        } else {
            length * libm::log(b / a) / (b - a)
        };
        // What is no number, or out of all bounds, is cut elsewhere: by the budget.
        ((count + ROOM) as u64).max(1)
    }

    /// How far along a segment the fraction `x` of its pieces ends.
    fn at(self, x: f64, length: f64) -> f64 {
        let [a, b] = self.ends;
        if self.is_even() {
            return x * length;
        }
        // Sizes grow by the same factor from piece to piece.
        let along = libm::expm1(x * libm::log(b / a)) / ((b - a) / a);
        along.clamp(0.0, 1.0) * length
    }

    fn is_even(self) -> bool {
        let [a, b] = self.ends;
        (b - a).abs() <= 1e-6 * a.min(b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_has_as_many_pieces_as_sizes_fit_and_one_more_for_a_hundredth() {
        let even = Law { ends: [0.5; 2] };
        assert_eq!([0.2, 0.5, 0.506, 1.0, 1.24].map(|length| even.pieces(length)), [1, 1, 2, 2, 3]);
        // ∫ ds / (0.1 + 0.9 s) = ln 10 / 0.9 = 2.56.
        assert_eq!(Law { ends: [0.1, 1.0] }.pieces(1.0), 3);
    }

    #[test]
    fn pieces_grow_with_the_size() {
        let law = Law { ends: [0.1, 0.8] };
        let places: Vec<f64> = (0..=3).map(|i| law.at(f64::from(i) / 3.0, 0.7)).collect();
        let steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!((places[3] - 0.7).abs() < 1e-15 && places[0] == 0.0, "{places:?}");
        assert!(steps.windows(2).all(|pair| (pair[1] / pair[0] - 2.0).abs() < 1e-12), "{steps:?}");
    }

    #[test]
    fn each_half_counts_from_its_own_end() {
        let told = |i| {
            let point = point(7, [i, 4], 0.25 * i as f64, 1.0);
            (point.apex, point.distance, point.origin)
        };
        assert_eq!(told(1), (0, 0.25, Origin::Rung));
        assert_eq!(told(2), (0, 0.5, Origin::Border));
        assert_eq!(told(3), (1, 0.25, Origin::Rung));
    }
}
