//! Which triangles are bad, why, and their way into the queue.

use super::quality::{self, Look, Trigger};
use super::queue::{self, Entry, Reason};
use super::{Refinement, excuse, soft};
use crate::constructions::Angle;
use crate::corners::{next, previous};
use crate::parameters::Rule;
use crate::predicates::Relative;
use crate::triangulation::OUTSIDE_THE_REGION;
use crate::triangulation::cavity::BoundaryEdge;

/// A triangle with its corners 1 and 2 as seen from corner 0, and their cross product: twice its area.
#[derive(Debug, Clone, Copy)]
struct Seen {
    slot: u32,
    vertices: [u32; 3],
    seen: [Relative; 2],
    cross: f64,
}

impl Refinement<'_> {
    /// Queues a triangle if it is bad.
    pub(super) fn queue_if_bad(&mut self, slot: u32) {
        let vertices = self.mesh.triangles[slot as usize].vertices;
        let corners = self.mesh.corners(slot);
        let seen = [1, 2].map(|i| Relative::of(corners[i], corners[0]));
        let cross = seen[0].cross(seen[1]);
        self.queue_if_seen_to_be_bad(Seen { slot, vertices, seen, cross }, None);
    }

    /// Queues the bad ones of the triangles that were just made.
    pub(super) fn queue_bad_of_star(&mut self) {
        let newest = self.mesh.points.len() as u32 - 1;
        let tile = self.tiles.later(self.cavity.point);
        for i in 0..self.cavity.size() {
            let BoundaryEdge { ends: [a, b], seen, .. } = self.cavity.side(i);
            let made = Seen {
                slot: self.cavity.star[i],
                vertices: [newest, a, b],
                seen,
                cross: self.cavity.cross(i),
            };
            self.queue_if_seen_to_be_bad(made, tile);
        }
    }

    /// Queues a triangle if it is bad; or lets it wait, in its tile or for a vertex that is still to be
    /// introduced.
    #[inline(always)]
    fn queue_if_seen_to_be_bad(&mut self, seen: Seen, tile: Option<usize>) {
        let Some((bucket, reason)) = self.badness(seen) else { return };
        let Seen { slot, vertices, .. } = seen;
        let entry = Entry::new(slot, vertices[0], reason);
        if let Some(tile) = tile {
            self.tiles.wait(tile, (bucket, entry));
        } else if !self.introduced.as_mut().is_some_and(|those| those.lets_wait(entry, vertices)) {
            self.queue.push(bucket, entry);
        }
    }

    /// The bucket of a bad triangle, and why it is bad: measured exactly only where a glance does not
    /// tell.
    #[inline(always)]
    fn badness(&self, seen: Seen) -> Option<(usize, Reason)> {
        let Seen { slot, vertices, seen: [a, b], cross } = seen;
        let look = quality::look(cross, [a, b], self.target);
        if look == Look::Fine && !self.is_sized {
            return None;
        }
        let region = self.mesh.region(slot);
        if region == OUTSIDE_THE_REGION {
            return None;
        }
        match look {
            Look::Small { edge, squared, is_clear }
                if self.is_plain && !self.may_excuse(vertices, edge) =>
            {
                let reason = if is_clear { Reason::SmallAngle(edge) } else { Reason::Unknown };
                return Some((queue::by_length(squared), reason));
            }
            Look::Fine if self.is_plain && self.sizing.is_surely_too_large(cross, region) => {
                let (edge, squared) = quality::shortest(a, b);
                return Some((queue::by_length(squared), Reason::TooLarge(edge)));
            }
            Look::Fine if self.sizes.is_none() && !self.sizing.may_be_too_large(cross, region) => {
                return None;
            }
            _ => {}
        }
        let trigger = self.trigger(slot)?;
        Some((self.order.bucket(trigger), Reason::Unknown))
    }

    /// Why a triangle that was queued and is still there is bad.
    #[inline]
    pub(super) fn trigger_of(&self, entry: Entry) -> Option<Trigger> {
        let known = |edge| Trigger::known(self.mesh.corners(entry.slot()), edge);
        match entry.reason() {
            Reason::SmallAngle(edge) => Some(known(edge)),
            Reason::TooLarge(edge) => Some(Trigger { only_size: true, ..known(edge) }),
            Reason::Unknown => self.trigger(entry.slot()),
        }
    }

    /// Why a triangle is bad, if it is: an angle below κ̂, or below the soft target where that may
    /// be attacked, that is not excused; or its size.
    pub(super) fn trigger(&self, slot: u32) -> Option<Trigger> {
        let region = self.mesh.region(slot);
        if region == OUTSIDE_THE_REGION {
            return None;
        }
        let corners = self.mesh.corners(slot);
        let allowed = |found: &Trigger| {
            self.parameters.soft_angle.is_none()
                || found.angle.is_below(self.parameters.min_angle)
                || soft::may_attack(self.domain, corners, *found)
                || self.may_be_improved_for_its_size(slot)
        };
        self.small_angle(slot).filter(allowed).or_else(|| {
            let too_large =
                self.sizing.is_too_large(corners, region) || self.is_larger_than_its_size(slot);
            too_large.then(|| quality::by_size(corners))
        })
    }

    /// The smallest angle of a triangle that is below what is asked for and not excused. A glance
    /// mostly tells which one that is.
    pub(super) fn small_angle(&self, slot: u32) -> Option<Trigger> {
        let vertices = self.mesh.triangles[slot as usize].vertices;
        let corners = self.mesh.corners(slot);
        let [a, b] = [1, 2].map(|i| Relative::of(corners[i], corners[0]));
        match quality::look(a.cross(b), [a, b], self.target) {
            Look::Fine => None,
            Look::Small { edge, is_clear: true, .. } if !self.may_excuse(vertices, edge) => {
                Some(Trigger::opposite(corners, edge))
            }
            _ => {
                let excused = |edge: usize, angle| self.is_excused(vertices, edge, angle);
                quality::trigger(corners, self.target, excused)
            }
        }
    }

    /// The triangles with an angle below the soft target that is not excused, by their slots, with
    /// the angle; none without a soft target.
    pub fn missed(&self) -> impl Iterator<Item = (u32, Angle)> + '_ {
        let soft = self.parameters.soft_angle.map(|_| 0..self.mesh.triangles.len() as u32);
        soft.into_iter()
            .flatten()
            .filter_map(|slot| self.small_angle(slot).map(|found| (slot, found.angle)))
    }

    /// Whether an edge may lie across a small input angle: both its ends split segments.
    #[inline]
    fn may_excuse(&self, vertices: [u32; 3], edge: usize) -> bool {
        let splits = |i: usize| self.provenances.splits_segment(vertices[i]);
        splits(next(edge)) && splits(previous(edge))
    }

    /// Whether the `angle` opposite an edge is left alone, because the edge lies across a small
    /// input angle.
    fn is_excused(&self, vertices: [u32; 3], edge: usize, angle: Angle) -> bool {
        if self.parameters.rule != Rule::Adaptive {
            return false;
        }
        let segment_point = |i: usize| self.provenances.segment_point(vertices[i]).copied();
        let (Some(a), Some(b)) = (segment_point(next(edge)), segment_point(previous(edge))) else {
            return false;
        };
        if a.segment == b.segment {
            return false;
        }
        self.segments.shared_end(a.segment, b.segment).is_some_and(|shared| {
            let theta = self.segments.angle(a.segment, b.segment, shared, &self.mesh.points);
            let across = excuse::Across { points: [a, b], shared, theta };
            across.excuses(self.parameters.excuse, angle)
        })
    }

    /// A quick look at the triangle that a point makes with an edge of its cavity's boundary: whether
    /// it may be bad.
    pub(super) fn may_be_bad(&self, [a, b]: [Relative; 2], region: u32) -> bool {
        quality::may_be_small(a, b, self.target)
            || self.sizing.may_be_too_large(a.cross(b), region)
            || self.sizes.is_some()
    }
}
