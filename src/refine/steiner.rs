//! Where the Steiner point of a bad triangle goes (ALGORITHM §5).

use super::quality::Trigger;
use crate::constructions::on_bisector;
use crate::corners::{next, previous};
use crate::parameters::{MinAngle, Parameters, Steiner};

/// Where Steiner points go.
#[derive(Debug, Clone, Copy)]
pub struct Placement {
    /// No farther out than the circumcenter and, for the sake of an angle below `kappa`, this height.
    highest: f64,
    kappa: MinAngle,
}

impl Placement {
    /// Where the parameters put them.
    #[must_use]
    pub fn new(parameters: &Parameters) -> Self {
        let kappa = parameters.min_angle;
        let highest = match parameters.steiner {
            Steiner::OffCenter | Steiner::LookAhead => {
                off_center(parameters.soft_angle.unwrap_or(kappa))
            }
            Steiner::Circumcenter => f64::INFINITY,
        };
        Self { highest, kappa }
    }

    /// The point that removes a triangle: rounded to the coordinates of the output, and only then
    /// tested and committed.
    #[must_use]
    pub fn point(&self, corners: [[f64; 2]; 3], trigger: Trigger) -> [f64; 2] {
        let [a, b] = [corners[next(trigger.edge)], corners[previous(trigger.edge)]];
        // The circumcenter sees ab under twice the angle opposite.
        let circumcenter = trigger.angle.dot / (2.0 * trigger.angle.cross);
        let by_angle = trigger.angle.is_below(self.kappa);
        on_bisector(a, b, if by_angle { circumcenter.min(self.highest) } else { circumcenter })
    }
}

/// The point that removes a triangle which is only too large for the size there: over its shortest
/// edge so high that the new triangle has the circumradius of an equilateral one of that size, as
/// where a front advances; never beyond the circumcenter.
///
/// No vertex is nearer than the size over √3, or than the circumcenter's height: a floor.
#[must_use]
pub fn at_size(corners: [[f64; 2]; 3], trigger: Trigger, size: f64) -> [f64; 2] {
    let [a, b] = [corners[next(trigger.edge)], corners[previous(trigger.edge)]];
    let circumcenter = trigger.angle.dot / (2.0 * trigger.angle.cross);
    // In lengths of the edge, which is a chord of that circle.
    let radius = (size / (3.0 * trigger.squared).sqrt()).max(0.5);
    let height = radius + (radius * radius - 0.25).sqrt();
    on_bisector(a, b, height.min(circumcenter))
}

/// λ = 0.475·cot(κ̂/2): the height of Üngör's off-center over the trigger edge, in its lengths.
/// There the new triangle's angle opposite is a little above κ̂. With a soft target that takes κ̂'s
/// place here.
fn off_center(kappa: MinAngle) -> f64 {
    let tangent = (kappa.numerator / kappa.denominator).sqrt();
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    0.475 * (1.0 + cosine) / sine
}

#[cfg(test)]
mod tests {
    use super::super::quality::trigger;
    use super::*;

    const THIN: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.5, 8.0]];

    fn steiner_point(steiner: Steiner) -> [f64; 2] {
        let parameters = Parameters { steiner, ..Parameters::default() };
        let bad = trigger(THIN, parameters.min_angle, |_, _| false).expect("it is thin");
        Placement::new(&parameters).point(THIN, bad)
    }

    #[test]
    fn the_circumcenter_is_equally_far_from_all_corners() {
        let [x, y] = steiner_point(Steiner::Circumcenter);
        assert_eq!(x, 0.5);
        assert!(((0.25 + y * y).sqrt() - (8.0 - y)).abs() < 1e-12);
    }

    #[test]
    fn a_large_triangle_gets_an_equilateral_one_on_its_edge() {
        let large = super::super::quality::by_size(THIN);
        let height = |size| at_size(THIN, large, size)[1];
        assert!((height(1.0) - 0.75_f64.sqrt()).abs() < 1e-12, "{}", height(1.0));
        assert!((height(0.1) - 0.5).abs() < 1e-12, "no lower than a right angle");
        assert_eq!(height(100.0), height(1000.0), "no higher than the circumcenter");
    }

    #[test]
    fn the_off_center_of_a_thin_triangle_is_two_edges_above_its_edge() {
        let [x, y] = steiner_point(Steiner::OffCenter);
        assert_eq!(x, 0.5);
        assert!((y - 2.0213).abs() < 1e-4, "{y}");
    }
}
