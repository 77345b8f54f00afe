//! The soft angle target (ALGORITHM §6): what people mean who ask for more than the theorem gives.
//!
//! An angle in [κ̂, κ_t) is attacked only where that is safe: where the circumradius is at least a
//! tenth of the local feature size at the circumcenter. So every insertion radius keeps a positive
//! floor, and the run ends. What is not attacked is missed, and listed.

use super::quality::Trigger;
use crate::constructions::on_bisector;
use crate::corners::{next, previous};
use crate::domain::Domain;

/// c: a soft angle is attacked where R ≥ c·lfs(z). Larger misses more, smaller costs more points.
const LEAST_RADIUS: f64 = 0.1;

/// Whether an angle of a triangle that is only below the soft target may be attacked.
#[must_use]
pub fn may_attack(domain: &Domain, corners: [[f64; 2]; 3], trigger: Trigger) -> bool {
    let [a, b] = [corners[next(trigger.edge)], corners[previous(trigger.edge)]];
    let circumcenter = on_bisector(a, b, 0.5 * trigger.angle.dot / trigger.angle.cross);
    let radius = 0.5 * trigger.squared.sqrt() / trigger.angle.sine();
    may_stand(domain, circumcenter, radius)
}

/// Whether a Steiner point for the sake of the soft target may stand at a place: two features are
/// near, by the circumradius of the triangle that it removes.
#[must_use]
pub fn may_stand(domain: &Domain, place: [f64; 2], radius: f64) -> bool {
    domain.has_two_features_within(place, radius / LEAST_RADIUS)
}

#[cfg(test)]
mod tests {
    use super::super::quality::trigger;
    use super::*;
    use crate::{MinAngle, Pslg, Region};

    #[test]
    fn a_small_triangle_far_from_every_feature_is_not_attacked() {
        let square = Pslg {
            points: vec![[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]],
            segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
            segment_tags: vec![0; 4],
            ..Pslg::default()
        };
        let (domain, _) = Domain::new(&square, Region::Domain).expect("a square is clean");
        let asked = |size: f64| {
            let corners = [[50.0, 50.0], [50.0 + size, 50.0], [50.0, 50.0 + 0.5 * size]];
            let bad = trigger(corners, MinAngle::soft_from_degrees(30.0).unwrap(), |_, _| false);
            may_attack(&domain, corners, bad.expect("it has an angle of 26.57°"))
        };
        // lfs is 50 in the middle; the circumradius is 0.559 of the size.
        assert!(asked(10.0));
        assert!(!asked(8.0));
    }
}
