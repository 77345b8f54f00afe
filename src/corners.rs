//! The three corners of a triangle, counted round.

/// The next of three.
#[inline]
#[must_use]
pub const fn next(i: usize) -> usize {
    if i == 2 { 0 } else { i + 1 }
}

/// What `of` makes of each of three. (The array's own `map` is not always inlined, and a call for each
/// corner shows.)
#[inline(always)]
pub fn each<T, U>([a, b, c]: [T; 3], mut of: impl FnMut(T) -> U) -> [U; 3] {
    [of(a), of(b), of(c)]
}

/// The previous of three.
#[inline]
#[must_use]
pub const fn previous(i: usize) -> usize {
    if i == 0 { 2 } else { i - 1 }
}
