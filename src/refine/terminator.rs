//! Shewchuk's Terminator (*Delaunay refinement algorithms for triangular mesh generation*, 2002,
//! §6.2), for comparison: it ends on every outline too, but bounds no large angle.
//!
//! No small angle is excused. Instead, a subsegment that only a rejected circumcenter encroaches
//! is not always split: not if that would make an edge, within its cluster, that is shorter than
//! the edge that asks for it.

use std::f64::consts::FRAC_PI_3;

use super::Refinement;
use super::piece::power_of_two_below;

/// A subsegment at the apex of a cluster: segments of one end, each within 60° of the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clustered {
    /// Its length.
    pub length: f64,
    /// The smallest angle of the cluster, in radians.
    pub smallest_angle: f64,
}

/// Whether a subsegment that a rejected circumcenter encroaches is split, for the sake of a
/// triangle whose shortest edge is `shortest`. `cluster` is `None` where the subsegment belongs to
/// none, or to two (one at either end).
#[must_use]
pub fn may_split(cluster: Option<Clustered>, shortest: f64) -> bool {
    let Some(Clustered { length, smallest_angle }) = cluster else {
        return true;
    };
    // The others of the cluster are as long only once all are a power of two.
    if length != power_of_two_below(length) {
        return true;
    }
    // When the whole cluster is split at half that length, its points are this near.
    length * libm::sin(0.5 * smallest_angle) >= shortest
}

impl Refinement<'_> {
    /// Whether the Terminator lets the triangle with this shortest edge split a subsegment.
    pub(super) fn terminator_splits(&self, ends: [u32; 2], shortest: f64) -> bool {
        may_split(self.clustered(ends), shortest)
    }

    fn clustered(&self, ends: [u32; 2]) -> Option<Clustered> {
        let segment = self.segment_of(ends)?;
        let at = |apex: u32| {
            let smallest_angle = self.smallest_angle_of_cluster(apex, segment)?;
            let along = ends.map(|v| self.distance_along(segment, v));
            Some(Clustered { length: (along[0] - along[1]).abs(), smallest_angle })
        };
        let [a, b] = ends.map(|v| if self.provenances.is_input(v) { at(v) } else { None });
        if a.is_some() && b.is_some() { None } else { a.or(b) }
    }

    /// The smallest angle between neighbours in the cluster at `apex` that `segment` belongs to.
    fn smallest_angle_of_cluster(&self, apex: u32, segment: u32) -> Option<f64> {
        let around = self.segments.at(apex);
        let start = around.iter().position(|&s| s == segment)?;
        let count = around.len();
        let angle = |from: usize, to: usize| {
            let (s, t) = (around[from], around[to]);
            let shared = self.segments.shared_end(s, t).filter(|_| s != t)?;
            let angle = self.segments.angle(s, t, shared, &self.mesh.points).radians();
            (angle < FRAC_PI_3).then_some(angle)
        };
        let mut smallest: Option<f64> = None;
        for step in [1, count - 1] {
            let mut from = start;
            for _ in 1..count {
                let to = (from + step) % count;
                let Some(angle) = angle(from, to) else { break };
                smallest = Some(smallest.map_or(angle, |least| least.min(angle)));
                from = to;
            }
        }
        smallest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cluster(length: f64) -> Option<Clustered> {
        Some(Clustered { length, smallest_angle: 0.1 })
    }

    #[test]
    fn a_subsegment_of_no_cluster_is_split() {
        assert!(may_split(None, 1.0));
    }

    #[test]
    fn a_cluster_is_first_brought_to_powers_of_two() {
        assert!(may_split(cluster(0.3), 1.0));
    }

    #[test]
    fn a_split_that_would_make_a_shorter_edge_is_not_made() {
        // sin 0.05 = 0.049979
        assert!(!may_split(cluster(0.5), 0.025));
        assert!(may_split(cluster(0.5), 0.0249));
    }
}
