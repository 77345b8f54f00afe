//! What a run did, counted: a measure of work that is the same on every machine.

/// Counts of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counters {
    /// Bad triangles taken from the queue.
    pub popped: usize,
    /// Those of them that were gone by then.
    pub stale: usize,
    /// Points committed: Steiner points and points that split subsegments.
    pub committed: usize,
    /// The triangles that those points replaced.
    pub replaced: usize,
    /// Questions that only exact arithmetic could answer, those of the initial triangulation
    /// included.
    pub exact: u64,
}

impl Counters {
    /// How many triangles a point replaced in the mean; 0 without points.
    #[must_use]
    pub fn mean_cavity(&self) -> f64 {
        self.replaced as f64 / self.committed.max(1) as f64
    }
}
