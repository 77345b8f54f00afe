//! Many short sequences, end to end in one list.

use std::collections::BTreeMap;

/// Sequences of numbers, one for each of 0, 1, …; none of those that were never begun.
#[derive(Default)]
pub(super) struct Sequences {
    all: Vec<u32>,
    /// Where each begins; the last one ends with the list.
    start: Vec<u32>,
    /// Those that stand for what is in the list.
    replaced: BTreeMap<u32, Vec<u32>>,
}

impl Sequences {
    /// Room for so many sequences of `steps` steps in all.
    pub(super) fn with_capacity(count: usize, steps: usize) -> Self {
        let (all, start) = (Vec::with_capacity(count + steps), Vec::with_capacity(count));
        Self { all, start, replaced: BTreeMap::new() }
    }

    /// Begins the next sequence.
    pub(super) fn begin(&mut self) {
        self.start.push(self.all.len() as u32);
    }

    /// Appends to the sequence that was begun last.
    pub(super) fn extend(&mut self, items: &[u32]) {
        self.all.extend_from_slice(items);
    }

    /// Puts another sequence in the place of one.
    pub(super) fn replace(&mut self, i: u32, items: Vec<u32>) {
        self.replaced.insert(i, items);
    }

    /// The sequence of number `i`.
    pub(super) fn of(&self, i: u32) -> &[u32] {
        if let Some(items) = self.replaced.get(&i) {
            return items;
        }
        let from = self.start.get(i as usize).map_or(self.all.len(), |&start| start as usize);
        let to = self.start.get(i as usize + 1).map_or(self.all.len(), |&start| start as usize);
        &self.all[from..to]
    }
}
