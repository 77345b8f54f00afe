//! The number range of §1: coordinates whose products neither over- nor underflow.

use super::error::{Error, Item, Kind};
use crate::Pslg;

/// No scaling while the exponent of the largest coordinate stays within ±this.
const UNSCALED: i32 = 100;

/// A scaled coordinate other than zero is no smaller than 2^this. Differences of coordinates are
/// then multiples of 2^−252, and the products of four of them, which the incircle test sums, of
/// 2^−1008: above the 2^−1074 at which doubles lose bits.
const SMALLEST: i32 = -200;

/// The exponent `e` such that coordinates × 2^−e lie in the range in which predicates are exact:
/// zero for all usual outlines.
///
/// # Errors
/// A coordinate is no finite number, or too small beside the largest one.
pub fn scale_exponent(pslg: &Pslg) -> Result<i32, Error> {
    let mut largest = 0.0_f64;
    for (index, point) in (0..).zip(&pslg.points) {
        if !point.iter().all(|c| c.is_finite()) {
            return Err(Error::NotFinite { item: Item::new(pslg, Kind::Point, index) });
        }
        largest = largest.max(point[0].abs()).max(point[1].abs());
    }
    let exponent = exponent(largest);
    let scale = if exponent.abs() > UNSCALED { exponent } else { 0 };
    let smallest = smallest(scale);
    for (index, point) in (0..).zip(&pslg.points) {
        if let Some(&coordinate) = point.iter().find(|&&c| c != 0.0 && c.abs() < smallest) {
            let item = Item::new(pslg, Kind::Point, index);
            return Err(Error::TooSmall { item: Box::new(item), coordinate, largest });
        }
    }
    Ok(scale)
}

/// Whether a coordinate × 2^−`scale` is too close to zero for exact arithmetic.
pub fn is_too_small(coordinate: f64, scale: i32) -> bool {
    coordinate != 0.0 && coordinate.abs() < smallest(scale)
}

/// The smallest coordinate that is not.
fn smallest(scale: i32) -> f64 {
    libm::scalbn(1.0, SMALLEST + scale)
}

/// `point` × 2^−`exponent`. Exact for points of the outline; a seed far outside of it may
/// become infinite or zero.
pub fn scaled([x, y]: [f64; 2], exponent: i32) -> [f64; 2] {
    match exponent {
        0 => [x, y],
        _ => [libm::scalbn(x, -exponent), libm::scalbn(y, -exponent)],
    }
}

/// The exponent `e` of `|x|` = m·2^e, 1 ≤ m < 2; 0 for zero.
fn exponent(x: f64) -> i32 {
    if x == 0.0 { 0 } else { libm::ilogb(x) }
}
