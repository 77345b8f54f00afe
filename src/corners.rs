//! The three corners of a triangle, counted round. (Without a branch: in inner loops any of the three
//! comes, and each wrong guess of the processor shows.)

/// The next of three.
#[inline]
#[must_use]
pub const fn next(i: usize) -> usize {
    1 << i & 3
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
    0b01_00_10 >> (2 * i) & 3
}
