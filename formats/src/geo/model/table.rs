//! Points and curves by their tags.

use std::collections::BTreeMap;
use std::ops::Index;

/// Values by their tags, in the order of the tags.
///
/// Tags that count up without large gaps, as those of nearly all scripts do, are places in a
/// vector; any other tag is in a map. A script of a million points is as many records in a row.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::geo) struct Table<T> {
    /// By tag, from 0.
    dense: Vec<Option<T>>,
    /// Tags that are negative or beyond the vector's end.
    sparse: BTreeMap<i32, T>,
    count: usize,
}

impl<T> Default for Table<T> {
    fn default() -> Self {
        Self { dense: Vec::new(), sparse: BTreeMap::new(), count: 0 }
    }
}

impl<T> Table<T> {
    pub(in crate::geo) fn len(&self) -> usize {
        self.count
    }

    pub(in crate::geo) fn get(&self, tag: i32) -> Option<&T> {
        match self.place(tag) {
            Some(place) => self.dense[place].as_ref(),
            None => self.sparse.get(&tag),
        }
    }

    pub(in crate::geo) fn get_mut(&mut self, tag: i32) -> Option<&mut T> {
        match self.place(tag) {
            Some(place) => self.dense[place].as_mut(),
            None => self.sparse.get_mut(&tag),
        }
    }

    pub(in crate::geo) fn contains(&self, tag: i32) -> bool {
        self.get(tag).is_some()
    }

    /// Puts a value in; the one that had its tag before.
    pub(in crate::geo) fn insert(&mut self, tag: i32, value: T) -> Option<T> {
        self.reach(tag);
        let old = match self.place(tag) {
            Some(place) => self.dense[place].replace(value),
            None => self.sparse.insert(tag, value),
        };
        self.count += usize::from(old.is_none());
        old
    }

    pub(in crate::geo) fn remove(&mut self, tag: i32) -> Option<T> {
        let old = match self.place(tag) {
            Some(place) => self.dense[place].take(),
            None => self.sparse.remove(&tag),
        };
        self.count -= usize::from(old.is_some());
        self.trim();
        old
    }

    /// Takes out all but those that `keeps` says yes to.
    pub(in crate::geo) fn retain(&mut self, keeps: impl Fn(i32) -> bool) {
        for (tag, value) in (0..).zip(&mut self.dense) {
            if !keeps(tag) {
                *value = None;
            }
        }
        self.sparse.retain(|&tag, _| keeps(tag));
        self.trim();
        self.count = self.dense.iter().flatten().count() + self.sparse.len();
    }

    /// The tags, ascending.
    pub(in crate::geo) fn tags(&self) -> impl Iterator<Item = i32> + '_ {
        self.iter().map(|(tag, _)| tag)
    }

    /// The largest tag; 0 if there is none.
    pub(in crate::geo) fn last_tag(&self) -> i32 {
        match self.sparse.last_key_value() {
            Some((&tag, _)) if tag >= 0 || self.dense.is_empty() => tag,
            _ => self.dense.len().saturating_sub(1) as i32,
        }
    }

    /// Tags and values, by ascending tags.
    pub(in crate::geo) fn iter(&self) -> impl Iterator<Item = (i32, &T)> {
        let dense = (0..).zip(&self.dense).filter_map(|(tag, value)| Some((tag, value.as_ref()?)));
        let sparse = |(&tag, value)| (tag, value);
        let below = self.sparse.range(..0).map(sparse);
        below.chain(dense).chain(self.sparse.range(0..).map(sparse))
    }

    pub(in crate::geo) fn values(&self) -> impl Iterator<Item = &T> {
        self.iter().map(|(_, value)| value)
    }

    /// The values in no particular order.
    pub(in crate::geo) fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.dense.iter_mut().flatten().chain(self.sparse.values_mut())
    }

    /// The place of a tag in the vector.
    fn place(&self, tag: i32) -> Option<usize> {
        usize::try_from(tag).ok().filter(|&place| place < self.dense.len())
    }

    /// Makes the vector longer if a tag lies only a little beyond its end: at least half of it is
    /// to be full.
    fn reach(&mut self, tag: i32) {
        let Ok(place) = usize::try_from(tag) else { return };
        let end = self.dense.len();
        if place < end || place > 2 * self.count + 64 {
            return;
        }
        self.dense.resize_with(place + 1, || None);
        while let Some(first) = self.sparse.range(0..=tag).next().map(|(&tag, _)| tag) {
            self.dense[first as usize] = self.sparse.remove(&first);
        }
    }

    /// Lets the vector end with a value.
    fn trim(&mut self) {
        while self.dense.pop_if(|last| last.is_none()).is_some() {}
    }
}

impl<T> Index<i32> for Table<T> {
    type Output = T;

    fn index(&self, tag: i32) -> &T {
        self.get(tag).expect("the tag is one of this table's")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(tags: &[i32]) -> Table<i64> {
        let mut table = Table::default();
        for &tag in tags {
            assert_eq!(table.insert(tag, 10 * i64::from(tag)), None);
        }
        table
    }

    #[test]
    fn tags_of_any_size_and_order_are_found_in_their_order() {
        let table = table(&[7, 2_000_000_000, -4, 0, 100, 1, 60, 300]);
        let found: Vec<(i32, i64)> = table.iter().map(|(tag, &value)| (tag, value / 10)).collect();
        let tags = [-4, 0, 1, 7, 60, 100, 300, 2_000_000_000];
        assert_eq!(found, tags.map(|tag| (tag, i64::from(tag))));
        assert_eq!((table.len(), table.last_tag()), (8, 2_000_000_000));
        assert!(tags.iter().all(|&tag| table[tag] == 10 * i64::from(tag)));
        assert!([-1, 2, 301, i32::MAX, i32::MIN].iter().all(|&tag| !table.contains(tag)));
    }

    #[test]
    fn a_tag_that_was_beyond_the_vector_is_found_when_the_vector_reaches_it() {
        let mut tags: Vec<i32> = (0..200).collect();
        tags.insert(0, 190);
        tags.remove(191);
        let table = table(&tags);
        assert!(table.sparse.is_empty());
        assert_eq!(table.tags().collect::<Vec<_>>(), (0..200).collect::<Vec<_>>());
    }

    #[test]
    fn what_is_taken_out_is_gone_and_its_tag_is_free() {
        let mut table = table(&[1, 2, 3, 900]);
        assert_eq!(
            [table.remove(3), table.remove(900), table.remove(5)],
            [Some(30), Some(9000), None]
        );
        assert_eq!((table.len(), table.last_tag()), (2, 2));
        table.retain(|tag| tag == 1);
        assert_eq!((table.len(), table.last_tag()), (1, 1));
        assert_eq!(table.insert(3, 4), None);
        assert_eq!(table.insert(3, 5), Some(4));
    }

    #[test]
    fn an_empty_table_ends_with_zero_and_one_of_negative_tags_with_theirs() {
        assert_eq!(table(&[]).last_tag(), 0);
        assert_eq!(table(&[-5, -3]).last_tag(), -3);
    }
}
