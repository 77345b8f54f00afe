//! (Conformality) of §3: a subsegment that a committed point encroaches is split.
//!
//! Every subsegment is an edge of the constrained triangulation, so only its apexes need be
//! asked; a point that encroaches it unseen is behind another subsegment, or behind an apex that
//! encroaches it too.

use std::ops::ControlFlow;

use super::provenance::SegmentPoint;
use super::trace::{Cause, Refusal};
use super::{Flow, Refinement, Watch};
use crate::constructions::point_on_segment;
use crate::memory::give_back;
use crate::predicates::{Relative, encroaches};
use crate::triangulation::Edge;

impl Refinement<'_> {
    /// Queues every subsegment that an apex of its encroaches.
    pub(super) fn find_encroached_subsegments(&mut self) {
        let mut subsegments = Vec::new();
        self.mesh.constrained_edges().for_each(|edge| subsegments.push(edge));
        subsegments.iter().for_each(|&edge| self.queue_if_encroached(edge));
        give_back(subsegments);
    }

    /// Splits until no subsegment is encroached, or what is left is refused.
    pub(super) fn restore_conformality(&mut self, watch: &mut Watch) -> Flow {
        self.tell_progress(watch)?;
        while let Some((ends, cause)) = self.pending.pop_front() {
            self.leave_room()?;
            self.split(ends, cause);
            self.tell_progress(watch)?;
        }
        ControlFlow::Continue(())
    }

    pub(super) fn queue_if_encroached(&mut self, edge: Edge) {
        let apex = self.mesh.apex(edge);
        let ends = self.mesh.ends(edge);
        if self.is_to_conform(ends) && self.is_encroached(ends, apex) {
            self.pending.push_back((ends, Cause::Encroached(apex)));
        }
    }

    /// Whether a subsegment is one of a segment that has been introduced.
    fn is_to_conform(&self, ends: [u32; 2]) -> bool {
        self.introduced.is_none()
            || self.segment_of(ends).is_some_and(|segment| self.is_introduced(segment))
    }

    /// Whether the committed vertex `p` encroaches the subsegment between `ends`.
    fn is_encroached(&self, ends: [u32; 2], p: u32) -> bool {
        let corners = ends.map(|v| self.mesh.points[v as usize]);
        let point = self.mesh.points[p as usize];
        let seen = corners.map(|corner| Relative::of(corner, point));
        encroaches(seen, corners, point) && !self.is_within_rounding(ends, seen, p)
    }

    /// The rule of ALGORITHM §2 for where doubles end: two points on adjoining segments, at equal
    /// distances from x as far as rounding can tell, do not encroach upon each other's
    /// subsegments. Without it the two legs of a tiny angle split each other down to the floor.
    fn is_within_rounding(&self, ends: [u32; 2], seen: [Relative; 2], p: u32) -> bool {
        let slack = 4.0 * self.precision.ulp;
        let [a, b] = seen;
        if a.dot(b) < -slack * (a.squared.sqrt() + b.squared.sqrt()) {
            return false;
        }
        let Some(segment) = self.segment_of(ends) else {
            return false;
        };
        let own;
        let through = match self.provenances.segment_point(p) {
            Some(point) => {
                own = [point.segment];
                &own[..]
            }
            None if self.provenances.is_input(p) => self.segments.at(p),
            None => &[],
        };
        through.iter().any(|&other| {
            let Some(shared) = self.segments.shared_end(segment, other) else {
                return false;
            };
            let x = self.segments.ends[segment as usize][usize::from(shared[0])];
            if other == segment || x == p {
                return false;
            }
            let theta = self.segments.angle(segment, other, shared, &self.mesh.points).radians();
            let distance = Relative::of(self.mesh.points[x as usize], self.mesh.points[p as usize]);
            theta * theta * distance.squared.sqrt() < slack
        })
    }

    /// The input segment that a subsegment is a piece of.
    pub(crate) fn segment_of(&self, [a, b]: [u32; 2]) -> Option<u32> {
        let splits = |v| self.provenances.segment_point(v).map(|point| point.segment);
        splits(a).or_else(|| splits(b)).or_else(|| self.segments.between(a, b))
    }

    /// Splits a subsegment, unless it is gone or the split is refused. Queues what the new point
    /// encroaches and which triangles it makes bad.
    pub(super) fn split(&mut self, ends: [u32; 2], cause: Cause) -> bool {
        let key = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        if self.refused.subsegments.contains(&key) {
            return false;
        }
        let Some(edge) = self.mesh.subsegment(ends[0], ends[1]) else {
            return false;
        };
        let committed = self.split_of(edge).and_then(|split| self.commit_split(edge, split));
        if let Err(refusal) = committed {
            self.refused.subsegments.insert(key);
            self.tell_refused_split(ends, cause, refusal);
            return false;
        }
        self.tell_split(ends, cause);
        self.queue_encroached_by_star();
        self.queue_bad_of_star();
        true
    }

    /// Where (§10 or ours) a subsegment is to be split.
    fn split_of(&self, edge: Edge) -> Result<SegmentPoint, Refusal> {
        let piece = self.mesh.ends(edge);
        let segment = self.segment_of(piece).ok_or(Refusal::Malformed)?;
        let splitting = self.parameters.splitting;
        let points = &self.mesh.points;
        Ok(self.segments.split(splitting, segment, piece, points, &self.provenances))
    }

    /// Splits the subsegment `edge` there, unless that is refused (ALGORITHM §9).
    pub(super) fn commit_split(&mut self, edge: Edge, split: SegmentPoint) -> Result<(), Refusal> {
        let (piece, points) = (self.mesh.ends(edge), &self.mesh.points);
        let segment = split.segment;
        let ends = self.segments.ends[segment as usize];
        let [from, to] =
            [split.apex, 1 - split.apex].map(|e| points[ends[usize::from(e)] as usize]);
        let point = self.precision.round(point_on_segment(from, to, split.distance));

        let floor = self.precision.floor;
        let too_short =
            piece.iter().any(|&v| Relative::of(points[v as usize], point).squared < floor * floor);
        let on_segment = |v: u32| match self.provenances.segment_point(v) {
            Some(other) => other.segment == segment,
            None => ends.contains(&v),
        };
        if too_short {
            return Err(Refusal::Floor);
        }
        self.cavity.of_split_point(&self.mesh, point, edge, on_segment)?;
        self.cavity.expect_visible(&self.mesh)?;
        self.commit();
        self.provenances.push_segment_point(split);
        self.size_new_vertex();
        Ok(())
    }

    /// After a split: the subsegments around the new point that it encroaches, and its own two
    /// halves where an apex encroaches them.
    pub(super) fn queue_encroached_by_star(&mut self) {
        let vertex = self.mesh.points.len() as u32 - 1;
        for side in self.cavity.subsegments() {
            if self.is_to_conform(side.ends) && self.is_encroached(side.ends, vertex) {
                self.pending.push_back((side.ends, Cause::Encroached(vertex)));
            }
        }
        let halves: Vec<Edge> = self.cavity.halves().collect();
        for half in halves {
            self.queue_if_encroached(half);
        }
    }
}
