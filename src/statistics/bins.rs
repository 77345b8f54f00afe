//! How many angles lie in each of 36 bins of 5°, told by their cotangents.

use crate::order::{greater, lesser};

/// Bins of 5°: a cotangent is looked up in a table of narrow cells, in each of which at most one bin
/// ends.
pub(super) struct Bins {
    /// From the largest cotangents down; behind those that are needed there are more like the last one.
    cells: [Cell; 1 << CELL_BITS],
}

#[derive(Clone, Copy)]
struct Cell {
    /// How many bins end above it.
    above: usize,
    /// Where one ends within it (NaN: nowhere).
    end: f64,
}

const CELL_BITS: u32 = 9;
/// Cells for a difference of 1 in the cotangent: the bins beside 90° are 0.087 wide.
const CELLS: f64 = 16.0;
/// In the middle of the first cell: above cot 5°.
const TOP: f64 = 11.5;

impl Bins {
    /// The bins [0°, 5°), [5°, 10°), … [175°, 180°].
    pub fn of_five_degrees() -> Self {
        let mut cells = [Cell { above: 0, end: f64::NAN }; 1 << CELL_BITS];
        for end in (1..36).map(|i| 1.0 / libm::tan(f64::from(5 * i).to_radians())) {
            let at = cell(end);
            cells[at].end = end;
            cells[at + 1..].iter_mut().for_each(|cell| cell.above += 1);
        }
        Self { cells }
    }

    /// The bin of the angle with this cotangent; the first one for no number.
    #[inline(always)]
    pub fn of(&self, cotangent: f64) -> usize {
        let Cell { above, end } = self.cells[cell(cotangent)];
        above + usize::from(cotangent <= end)
    }
}

/// The cell of a cotangent.
#[inline(always)]
fn cell(cotangent: f64) -> usize {
    const LAST: usize = (1 << CELL_BITS) - 1;
    let down = lesser(greater((TOP - cotangent) * CELLS, 0.0), LAST as f64);
    // Among doubles so large the next is one more: the sum is rounded to a whole number, which its last
    // bits are. (A cast looks for what no whole number can be.)
    const WHOLE: f64 = (1_u64 << 52) as f64;
    (down + WHOLE).to_bits() as usize & LAST
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

    #[test]
    fn no_two_bins_end_in_a_cell() {
        let ends = Bins::of_five_degrees().cells.map(|cell| cell.end);
        assert_eq!(ends.iter().filter(|end| !end.is_nan()).count(), 35);
    }
}
