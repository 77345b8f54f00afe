//! How much work a script may be: a hostile one ends in an error.

use crate::geo::error::Problem;

/// Units of work for every script; a statement is [`STATEMENT`] units, an element of a list one.
const WORK: u64 = 200_000_000;

/// Units for every byte of the script, so that a long one without loops always fits.
const WORK_PER_BYTE: u64 = 50;

/// The work of a statement.
pub(super) const STATEMENT: u64 = 10;

/// The work of a point, a curve or a surface, which stay in memory.
pub(in crate::geo) const ENTITY: u64 = 50;

/// Macros and files may call one another this deep.
pub(super) const MOST_CALLS: u32 = 100;

/// The work that is left.
#[derive(Debug)]
pub(in crate::geo) struct Budget {
    left: u64,
}

impl Budget {
    pub(super) fn new(bytes: usize) -> Self {
        Self { left: WORK + WORK_PER_BYTE * bytes as u64 }
    }

    /// Does some work.
    pub(in crate::geo) fn spend(&mut self, work: u64) -> Result<(), Problem> {
        match self.left.checked_sub(work) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(Problem::Limit { what: "its loops make more than 20 million steps" }),
        }
    }
}
