//! An array of a grid: its numbers as they are read, and as data of a mesh.

use super::Runs;
use crate::arrays::Block;
use crate::mesh::{Data, Values};
use crate::wholes::Wholes;

/// A named array of points, of cells or of the whole.
pub(crate) struct Column {
    pub name: String,
    pub components: usize,
    pub numbers: Numbers,
}

/// The numbers of an array.
pub(crate) enum Numbers {
    Real(Vec<f64>),
    Whole(Wholes),
}

impl Numbers {
    /// Room for so many numbers, real or whole.
    pub fn with_capacity(are_real: bool, count: usize) -> Self {
        match are_real {
            true => Self::Real(Vec::with_capacity(count)),
            false => Self::Whole(Wholes::with_capacity(count)),
        }
    }

    /// Appends numbers of the same kind.
    pub fn extend(&mut self, block: Block) {
        match (self, block) {
            (Self::Real(held), Block::Real(numbers)) => held.extend_from_slice(numbers),
            (Self::Whole(held), Block::Whole(numbers)) => held.extend(numbers),
            _ => {}
        }
    }
}

impl Column {
    /// The numbers, if they are whole and one stands for each item.
    pub fn wholes(&self) -> Option<&Wholes> {
        match &self.numbers {
            Numbers::Whole(numbers) if self.components == 1 => Some(numbers),
            _ => None,
        }
    }

    pub fn into_data(self) -> Data {
        let values = match self.numbers {
            Numbers::Real(numbers) => Values::Real(numbers),
            Numbers::Whole(numbers) => Values::Integer(numbers.into_vec()),
        };
        Data { name: self.name, components: self.components, values }
    }

    /// The numbers of some cells.
    pub fn into_data_of(self, cells: &Runs) -> Data {
        let tuples = cells.runs().map(|run| run.start * self.components..run.end * self.components);
        let values = match &self.numbers {
            Numbers::Real(numbers) => {
                Values::Real(tuples.flat_map(|tuple| &numbers[tuple]).copied().collect())
            }
            Numbers::Whole(numbers) => {
                Values::Integer(tuples.flatten().map(|index| numbers.at(index)).collect())
            }
        };
        Data { name: self.name, components: self.components, values }
    }
}
