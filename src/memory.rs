//! Giving large arrays back, so that a run's peak of memory is what it holds.

/// Frees an array that was large by way of a small one.
///
/// Of a large block that is freed, glibc learns that blocks as large will come again: from then on it
/// takes them out of its heap, where what is freed stays with the process as long as anything beyond
/// it is in use (mallopt(3), `M_MMAP_THRESHOLD`). What shrinks first goes back page by page and
/// teaches nothing.
///
/// ```
/// let numbers: Vec<u32> = (0..1_000_000).collect();
/// let sum: u64 = numbers.iter().map(|&number| u64::from(number)).sum();
/// meshwright::memory::give_back(numbers);
/// assert_eq!(sum, 499_999_500_000);
/// ```
pub fn give_back<T>(mut array: Vec<T>) {
    array.truncate(1);
    array.shrink_to(1);
}
