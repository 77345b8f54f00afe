//! Colours that tell how good a triangle is.

use std::f64::consts::FRAC_PI_3;

/// From the smallest angle 0° to 60°: dark for small ones, bright for large ones, in even steps.
const STEPS: [[u8; 3]; 5] =
    [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// The colour of a triangle by its smallest angle, in radians; grey where it has none.
pub fn of_angle(angle: f64) -> [u8; 4] {
    if angle.is_nan() {
        return [128, 128, 128, 255];
    }
    let place = (angle / FRAC_PI_3).clamp(0.0, 1.0) * (STEPS.len() - 1) as f64;
    let step = (place as usize).min(STEPS.len() - 2);
    let part = place - step as f64;
    let mix = |i: usize| {
        let (from, to) = (f64::from(STEPS[step][i]), f64::from(STEPS[step + 1][i]));
        (from + part * (to - from)).round() as u8
    };
    [mix(0), mix(1), mix(2), 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn larger_angles_are_brighter() {
        assert_eq!(of_angle(0.0), [68, 1, 84, 255]);
        assert_eq!(of_angle(FRAC_PI_3 / 2.0), [33, 145, 140, 255]);
        assert_eq!(of_angle(FRAC_PI_3), [253, 231, 37, 255]);
        assert_eq!(of_angle(f64::NAN), [128, 128, 128, 255]);
    }
}
