//! How good each triangle is.

use meshwright_formats::{Data, Mesh, Values};

use super::{Angles, angle, area_and_dots};
use crate::corners::each;

/// Measures of each triangle, in the order of the mesh; NaN where a corner does not exist.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Quality {
    /// The smallest angle, in radians.
    pub smallest_angle: Vec<f64>,
    /// The largest angle, in radians.
    pub largest_angle: Vec<f64>,
    /// The radius of the circumcircle over the shortest edge: 1/√3 for an equilateral triangle.
    pub radius_edge: Vec<f64>,
    /// The area, in squared units of the coordinates; negative for a clockwise triangle.
    pub area: Vec<f64>,
}

impl Quality {
    /// Measures a mesh.
    ///
    /// ```
    /// use meshwright::{Mesh, statistics::Quality};
    /// let points = vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    /// let mesh = Mesh { points, triangles: vec![[0, 1, 2]], ..Mesh::default() };
    /// let quality = Quality::of(&mesh);
    /// assert_eq!(quality.smallest_angle[0].to_degrees(), 45.0);
    /// assert_eq!(quality.area, [2.0]);
    /// ```
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        let angles = Angles::new(&mesh.points);
        let mut quality = Self::default();
        for &triangle in &mesh.triangles {
            let measured = match angles.corners(triangle) {
                Some(corners) => measures(corners, angles.exponent),
                None => [f64::NAN; 4],
            };
            let [smallest, largest, radius_edge, area] = measured;
            quality.smallest_angle.push(smallest);
            quality.largest_angle.push(largest);
            quality.radius_edge.push(radius_edge);
            quality.area.push(area);
        }
        quality
    }

    /// The measures as data of triangles, angles in degrees: `min_angle`, `max_angle`,
    /// `radius_edge` and `area`.
    #[must_use]
    pub fn into_data(self) -> [Data; 4] {
        let degrees = |angles: Vec<f64>| angles.into_iter().map(f64::to_degrees).collect();
        let data = |name: &str, values| Data {
            name: name.to_owned(),
            components: 1,
            values: Values::Real(values),
        };
        [
            data("min_angle", degrees(self.smallest_angle)),
            data("max_angle", degrees(self.largest_angle)),
            data("radius_edge", self.radius_edge),
            data("area", self.area),
        ]
    }
}

/// Smallest and largest angle, radius over edge, area of corners that were multiplied by 2 to this
/// power.
fn measures(corners: [[f64; 2]; 3], exponent: i32) -> [f64; 4] {
    let (twice_area, dots) = area_and_dots(corners);
    let [at_a, at_b, at_c] = each(dots, |dot| dot / twice_area.abs());
    let (steepest, flattest) = (at_a.max(at_b).max(at_c), at_a.min(at_b).min(at_c));
    // The shortest edge is 2R·sin of the smallest angle, and 1/sin = √(1 + cot²).
    let radius_edge = libm::hypot(1.0, steepest) / 2.0;
    let area = twice_area / 2.0;
    [angle(steepest), angle(flattest), radius_edge, libm::scalbn(area, -2 * exponent)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(points: [[f64; 2]; 3]) -> [f64; 4] {
        let mesh = Mesh { points: points.into(), triangles: vec![[0, 1, 2]], ..Mesh::default() };
        let [smallest, largest, radius_edge, area] = Quality::of(&mesh).into_data();
        [smallest, largest, radius_edge, area].map(|data| match data.values {
            Values::Real(values) => values[0],
            Values::Integer(_) => panic!("measures are real numbers"),
        })
    }

    fn assert_close(found: [f64; 4], expected: [f64; 4]) {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-14 * expected.abs(), "{found} {expected}");
        }
    }

    #[test]
    fn the_right_triangle_of_sides_3_4_5() {
        let smallest = 36.869_897_645_844_02;
        let right = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
        assert_close(of(right), [smallest, 90.0, 2.5 / 3.0, 6.0]);
        let [a, b, c] = right;
        assert_close(of([a, c, b]), [smallest, 90.0, 2.5 / 3.0, -6.0]);
    }

    #[test]
    fn size_changes_the_area_alone() {
        let size = libm::scalbn(1.0, 400);
        let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
        let [smallest, largest, radius_edge, _] = of(triangle);
        let large = of(triangle.map(|point| point.map(|x| x * size)));
        assert_eq!(large, [smallest, largest, radius_edge, 6.0 * size * size]);
    }

    #[test]
    fn a_flat_triangle_has_no_angle_and_no_bound() {
        let [smallest, largest, radius_edge, area] = of([[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]]);
        assert_eq!((smallest, radius_edge, area), (0.0, f64::INFINITY, 0.0));
        assert!(largest == 0.0 || largest == 180.0);
    }

    #[test]
    fn what_has_no_corners_has_no_measure() {
        let mesh = Mesh { triangles: vec![[0, 1, 2]], ..Mesh::default() };
        assert!(Quality::of(&mesh).area[0].is_nan());
    }
}
