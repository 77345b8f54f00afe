//! Where the numbers of a grid stand in a legacy `.vtk` file, for messages.

use super::numbers::{Kind, Numbers};
use crate::error::SyntaxError;
use crate::grid::{Grid, Part, Wrong};
use crate::text::Scanner;

/// Where the arrays of a grid begin.
pub(super) struct Places {
    numbers: Numbers,
    arrays: Vec<Array>,
}

struct Array {
    part: Part,
    /// The index of its first number among those of the part.
    first: usize,
    /// Where the file has it.
    start: usize,
    kind: Kind,
    layout: Layout,
}

/// Which numbers of the file an array's are.
#[derive(Clone, Copy)]
pub(super) enum Layout {
    /// All.
    Plain,
    /// All but the first.
    BehindFirst,
    /// All but those that count the nodes of each cell, from this cell on.
    Counted { first_cell: usize },
}

impl Places {
    pub fn new(numbers: Numbers) -> Self {
        Self { numbers, arrays: Vec::new() }
    }

    /// Begins numbers, behind a line of text.
    pub fn begin(&mut self, scanner: &mut Scanner) -> Result<usize, SyntaxError> {
        if self.numbers == Numbers::Binary && !scanner.enter_bytes() {
            return Err(scanner.unexpected_here("the end of the line"));
        }
        Ok(scanner.offset())
    }

    /// Keeps where an array begins whose first number has this index among those of the part.
    pub fn keep(&mut self, part: Part, start: usize, kind: Kind, first: usize, layout: Layout) {
        self.arrays.push(Array { part, first, start, kind, layout });
    }

    /// The error that a number of the grid means nothing.
    pub fn error(&self, scanner: &Scanner, grid: &Grid, wrong: &Wrong) -> SyntaxError {
        let mut arrays = self.arrays.iter().rev();
        let of_part = arrays.find(|a| a.part == wrong.part && a.first <= wrong.index);
        let (part, index) = match (of_part, wrong.part) {
            // Polygons have no kinds of cells: their nodes are what is wrong.
            (None, Part::Kinds) => {
                let before = wrong.index.checked_sub(1).map(|cell| grid.cells.ends.at(cell));
                (Part::Nodes, before.map_or(0, |end| end.max(0) as usize))
            }
            (_, part) => (part, wrong.index),
        };
        let mut arrays = self.arrays.iter().rev();
        let Some(array) = arrays.find(|array| array.part == part && array.first <= index) else {
            return scanner.missing(wrong.expected);
        };
        let nth = index - array.first
            + match array.layout {
                Layout::Plain => 0,
                Layout::BehindFirst => 1,
                Layout::Counted { first_cell } => {
                    let cell = grid.cells.ends.partition_point(|end| end <= index as i64);
                    cell.saturating_sub(first_cell) + 1
                }
            };
        let place = match self.numbers {
            Numbers::Text => scanner.place_of_word(array.start, nth),
            Numbers::Binary => array.start + nth * array.kind.size,
        };
        let mut error = scanner.unexpected_number(place, wrong.expected, &wrong.found);
        if wrong.part == Part::Kinds {
            error.help = Some(format!("this is a cell of kind {}", wrong.found).into());
        }
        error
    }
}
