//! The greater and the lesser of two numbers, for inner loops: `f64::max` and `f64::min` look for what
//! is no number in both.

/// The greater of two; the second where they cannot be compared.
#[inline(always)]
pub fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The lesser of two; the second where they cannot be compared.
#[inline(always)]
pub fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
