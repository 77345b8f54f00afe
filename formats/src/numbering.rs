//! From the numbers that a file gives to its nodes or elements to indices that count up from 0.

use crate::error::SyntaxError;
use crate::text::Scanner;

/// The numbers of nodes or elements, which may be any that are not used twice.
#[derive(Default)]
pub(crate) struct Numbering {
    /// How many there are.
    count: u32,
    /// Number, index and place in the file of each, by number; empty while they count up from 1.
    table: Vec<(i64, u32, usize)>,
}

impl Numbering {
    /// Takes the number of the next one, which stands at a place in the file.
    pub fn push(&mut self, number: i64, place: usize) {
        if self.table.is_empty() && number != i64::from(self.count) + 1 {
            // Places of those that counted up need not be known: only a later one can repeat
            // their numbers, and it is the one to name.
            self.table = (0..self.count).map(|i| (i64::from(i) + 1, i, 0)).collect();
            self.table.push((number, self.count, place));
        } else if !self.table.is_empty() {
            self.table.push((number, self.count, place));
        }
        self.count += 1;
    }

    /// How many there are.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Makes the numbers ready to be looked up.
    ///
    /// # Errors
    /// A number that is there twice; `expected` is what should be instead.
    pub fn sort(&mut self, scanner: &Scanner, expected: &'static str) -> Result<(), SyntaxError> {
        self.table.sort_unstable();
        match self.table.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            Some(pair) => Err(scanner.unexpected_number(pair[1].2, expected, pair[1].0)),
            None => Ok(()),
        }
    }

    /// The index of the one with this number.
    pub fn index(&self, number: i64) -> Option<u32> {
        if self.table.is_empty() {
            let index = u32::try_from(number.checked_sub(1)?).ok()?;
            return (index < self.count).then_some(index);
        }
        let place = self.table.binary_search_by_key(&number, |entry| entry.0).ok()?;
        Some(self.table[place].1)
    }

    /// The indices of those whose numbers are in a range, in the order of their numbers.
    pub fn between(&self, first: i64, last: i64) -> Vec<(i64, u32)> {
        if self.table.is_empty() {
            let last = last.min(self.count.into());
            return (first.max(1)..=last).map(|number| (number, (number - 1) as u32)).collect();
        }
        let start = self.table.partition_point(|entry| entry.0 < first);
        let inside = self.table[start..].iter().take_while(|entry| entry.0 <= last);
        inside.map(|&(number, index, _)| (number, index)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_a_range_are_found_whether_they_count_up_or_not() {
        let mut plain = Numbering::default();
        (1..=4).for_each(|number| plain.push(number, 0));
        assert_eq!(plain.between(-7, 2), [(1, 0), (2, 1)]);
        assert_eq!(plain.between(4, i64::MAX), [(4, 3)]);
        let mut mixed = Numbering::default();
        [1, 70, 9].into_iter().for_each(|number| mixed.push(number, 0));
        mixed.sort(&Scanner::new(b"", "file", None), "a new number").unwrap();
        assert_eq!(mixed.between(2, 70), [(9, 2), (70, 1)]);
        assert_eq!((mixed.index(70), mixed.index(2)), (Some(1), None));
        assert_eq!(mixed.index(i64::MIN), None);
    }
}
