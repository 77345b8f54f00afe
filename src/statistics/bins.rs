//! How many angles lie in each of 36 bins of 5°, told by their cotangents.

/// Bins of 5°: a cotangent is looked up in a table of narrow cells, in each of which at most one bin
/// ends.
pub(super) struct Bins {
    /// For each cell, from the largest cotangents down: how many bins end above it, and where one ends
    /// within it (NaN: nowhere).
    cells: Vec<(usize, f64)>,
}

/// Cells for a difference of 1 in the cotangent: the bins beside 90° are 0.087 wide.
const CELLS: f64 = 16.0;
/// Where the first cell begins: above cot 5°.
const TOP: f64 = 11.5;

impl Bins {
    /// The bins [0°, 5°), [5°, 10°), … [175°, 180°].
    pub fn of_five_degrees() -> Self {
        let ends = || (1..36).map(|i| 1.0 / libm::tan(f64::from(5 * i).to_radians()));
        let count = ends().map(cell).max().map_or(0, |last| last + 1);
        let mut cells = vec![(0, f64::NAN); count];
        for end in ends() {
            let at = cell(end);
            cells[at].1 = end;
            cells[at + 1..].iter_mut().for_each(|(above, _)| *above += 1);
        }
        Self { cells }
    }

    /// The bin of the angle with this cotangent; the first one for no number.
    #[inline]
    pub fn of(&self, cotangent: f64) -> usize {
        let (above, end) = self.cells[cell(cotangent).min(self.cells.len() - 1)];
        above + usize::from(cotangent <= end)
    }
}

/// The cell of a cotangent, of as many as are needed.
#[inline]
fn cell(cotangent: f64) -> usize {
    ((TOP - cotangent) * CELLS) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bin_begins_at_its_bound_and_ends_before_the_next() {
        let bins = Bins::of_five_degrees();
        for i in 1..36 {
            let bound = 1.0 / libm::tan(f64::from(5 * i).to_radians());
            let around = [bound.next_up(), bound, bound.next_down()].map(|c| bins.of(c));
            assert_eq!(around, [i as usize - 1, i as usize, i as usize]);
        }
    }

    #[test]
    fn every_number_has_a_bin() {
        let bins = Bins::of_five_degrees();
        let odd = [f64::INFINITY, 1e300, 0.0, -1e300, f64::NEG_INFINITY, f64::NAN];
        assert_eq!(odd.map(|c| bins.of(c)), [0, 0, 18, 35, 35, 0]);
    }
}
