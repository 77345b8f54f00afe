//! Algorithm 1 (§9): a 5-Bounded Reduction Augmenter. Only to reproduce the paper: it makes some
//! ten times as many points as the outline has.

use std::ops::ControlFlow;

use super::piece::power_of_two_below;
use super::provenance::{End as SegmentEnd, Kind, Origin, SegmentPoint};
use super::trace::Cause;
use super::{End, Flow, Refinement};
use crate::constructions::segment_length;

impl Refinement<'_> {
    /// (1) For each point that is an end of at least two segments: (2) on each of them a point at
    /// a distance in [0.2, 0.4] of its length that is a power of two, so that the new segments at
    /// the point have the same length modulo a power of two (Assumption 3).
    pub(super) fn augment(&mut self) -> Flow {
        for segment in 0..self.segments.ends.len() as u32 {
            self.augment_segment(segment)?;
        }
        ControlFlow::Continue(())
    }

    /// Puts the points on one segment, and returns its pieces.
    pub(super) fn augment_segment(&mut self, segment: u32) -> ControlFlow<End, Vec<[u32; 2]>> {
        let ends = self.segments.ends[segment as usize];
        let [a, b] = ends.map(|v| self.mesh.points[v as usize]);
        let (length, _) = segment_length(a, b);
        let mut chain = vec![ends[0], ends[1]];
        for apex in [0, 1] {
            if self.segments.at(ends[apex]).len() < 2 {
                continue;
            }
            self.leave_room()?;
            let piece =
                if apex == 0 { [chain[0], chain[1]] } else { [ends[1], chain[chain.len() - 2]] };
            let point = SegmentPoint {
                segment,
                distance: power_of_two_below(0.4 * length),
                apex: apex as SegmentEnd,
                kind: Kind::Shell,
                origin: Origin::Rung,
            };
            let edge = self.mesh.subsegment(piece[0], piece[1]);
            if edge.is_some_and(|edge| self.commit_split(edge, point).is_ok()) {
                self.tell_split(piece, Cause::Augmented);
                if self.introduced.is_some() {
                    // Else nothing has been looked at yet.
                    self.queue_encroached_by_star();
                    self.queue_bad_of_star();
                }
                chain.insert(chain.len() - 1, self.mesh.points.len() as u32 - 1);
            }
        }
        ControlFlow::Continue(chain.windows(2).map(|ends| [ends[0], ends[1]]).collect())
    }
}
