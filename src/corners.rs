//! The three corners of a triangle, counted round.

/// The next of three.
#[inline]
#[must_use]
pub const fn next(i: usize) -> usize {
    if i == 2 { 0 } else { i + 1 }
}

/// The previous of three.
#[inline]
#[must_use]
pub const fn previous(i: usize) -> usize {
    if i == 0 { 2 } else { i - 1 }
}
