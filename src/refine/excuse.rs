//! When an angle smaller than κ̂ is left alone: it lies across a small input angle.

use super::provenance::{End, Kind, SegmentPoint};
use crate::constructions::Angle;
use crate::parameters::Excuse;

/// An edge between interior points of two distinct input segments that share the input endpoint x.
#[derive(Debug, Clone, Copy)]
pub struct Across {
    /// Its ends.
    pub points: [SegmentPoint; 2],
    /// Which end of each point's segment x is.
    pub shared: [End; 2],
    /// The angle θ between the two segments.
    pub theta: Angle,
}

impl Across {
    /// Whether the `angle` opposite the edge is excused.
    ///
    /// Choice: θ = π/3 itself is excused, since (Quality′) acts only on "> π/3"; it is moot while
    /// κ̂ < 30°.
    #[must_use]
    pub fn excuses(&self, excuse: Excuse, angle: Angle) -> bool {
        self.theta.is_at_most_sixty_degrees()
            && match excuse {
                Excuse::Midpoints => self.joins_midpoints(),
                Excuse::Measured => {
                    self.joins_rungs_of_x() || is_at_least_lemma_7(angle, self.theta)
                }
            }
    }

    /// (Quality′) of §3: both ends are midpoints. Shell points count as input.
    fn joins_midpoints(&self) -> bool {
        self.points.iter().all(|point| point.kind == Kind::Midpoint)
    }

    /// Both ends are midpoints of ladders that stand on x. Any two points of ladders would not do:
    /// that breaks Lemma 7.
    fn joins_rungs_of_x(&self) -> bool {
        let ends = self.points.iter().zip(self.shared);
        self.joins_midpoints() && ends.into_iter().all(|(point, end)| point.apex == end)
    }
}

/// Whether the angle is at least f(θ) = arctan(sin θ / (2 − cos θ)) (Lemma 7), but for a relative
/// slack of 1e-7: equality occurs.
#[must_use]
pub fn is_at_least_lemma_7(angle: Angle, theta: Angle) -> bool {
    // tan f(θ) = |u||v|sin θ / (2|u||v| − |u||v|cos θ)
    let bound = Angle { cross: theta.cross, dot: 2.0 * theta.size() - theta.dot };
    angle.dot <= 0.0 || angle.cross * bound.dot >= bound.cross * angle.dot * (1.0 - 1e-7)
}

#[cfg(test)]
mod tests {
    use super::super::provenance::Origin;
    use super::*;

    fn angle(degrees: f64) -> Angle {
        let radians = degrees.to_radians();
        Angle { cross: libm::sin(radians), dot: libm::cos(radians) }
    }

    fn on_segment(segment: u32, apex: End, kind: Kind) -> SegmentPoint {
        SegmentPoint { segment, distance: 0.5, apex, kind, origin: Origin::Rung }
    }

    fn across(kinds: [Kind; 2], apexes: [End; 2], theta: f64) -> Across {
        Across {
            points: [0, 1].map(|i| on_segment(i as u32, apexes[i], kinds[i])),
            shared: [0, 0],
            theta: angle(theta),
        }
    }

    #[test]
    fn two_midpoints_across_a_small_angle_are_excused() {
        let edge = across([Kind::Midpoint; 2], [0, 0], 5.0);
        assert!(edge.excuses(Excuse::Midpoints, angle(0.1)));
        assert!(edge.excuses(Excuse::Measured, angle(0.1)));
    }

    #[test]
    fn a_shell_point_counts_as_input() {
        let edge = across([Kind::Midpoint, Kind::Shell], [0, 0], 5.0);
        assert!(!edge.excuses(Excuse::Midpoints, angle(4.97)));
        assert!(!edge.excuses(Excuse::Measured, angle(0.1)));
        assert!(edge.excuses(Excuse::Measured, angle(4.97)));
    }

    #[test]
    fn a_rung_of_another_apex_is_excused_by_its_angle_only() {
        let edge = across([Kind::Midpoint; 2], [0, 1], 5.0);
        assert!(!edge.excuses(Excuse::Measured, angle(0.1)));
        assert!(edge.excuses(Excuse::Measured, angle(4.97)));
    }

    #[test]
    fn more_than_sixty_degrees_excuse_nothing() {
        let edge = across([Kind::Midpoint; 2], [0, 0], 60.001);
        assert!(!edge.excuses(Excuse::Midpoints, angle(20.0)));
        assert!(!edge.excuses(Excuse::Measured, angle(20.0)));
    }

    #[test]
    fn the_bound_of_lemma_7_is_met_with_equality_at_lake_superior() {
        assert!(is_at_least_lemma_7(angle(14.0714), angle(15.0237)));
        assert!(!is_at_least_lemma_7(angle(14.0712), angle(15.0237)));
    }
}
