//! The queue of bad triangles: as good as a heap, at the price of an array.

use std::mem;

use super::quality::Trigger;

/// A bad triangle by its slot and its newest vertex: a slot that was reused since has another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Entry {
    /// The slot.
    pub slot: u32,
    /// Vertex 0 of the triangle that was queued.
    pub newest: u32,
}

/// What comes out first. Any order terminates (ALGORITHM §2); they differ in points and time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// The shortest trigger edge: with off-centers.
    ShortestEdge,
    /// The smallest angle: with circumcenters, where shortest first would build stars of
    /// unbounded degree.
    SmallestAngle,
}

impl Order {
    /// The bucket of a trigger: by a factor of 2^(1/16) in the length, or of at most 1.016 in the
    /// squared sine.
    ///
    /// Choice: over 40 turned copies of Lake Superior this gives 963 points in the middle, a
    /// factor of 2^(1/4) gives 965 with a wider spread, 2^(1/2) gives 972.
    #[must_use]
    pub fn bucket(self, trigger: Trigger) -> usize {
        match self {
            Self::ShortestEdge => by_length(trigger.squared),
            Self::SmallestAngle => {
                let sine = trigger.angle.sine();
                by_sine(sine * sine)
            }
        }
    }
}

/// The bucket of a squared length: the exponent and the first three bits of the mantissa.
#[must_use]
pub fn by_length(squared: f64) -> usize {
    (squared.to_bits() >> 49) as usize & (BUCKETS - 1)
}

/// Eight bits of the exponent, from 2^-255, and six of the mantissa.
fn by_sine(squared: f64) -> usize {
    let lowest = (1023 - 255) << 6;
    let bits = (squared.to_bits() >> 46) as i64;
    (bits - lowest).clamp(0, BUCKETS as i64 - 1) as usize
}

const BUCKETS: usize = 1 << 14;
/// So many entries stand in a row.
const ROW: usize = 16;
/// No row, no place.
const NONE: u32 = u32::MAX;

/// Buckets of entries, first in first out: each a list of short rows through one array, so that what
/// is used of it stays in the cache, and an entry hardly takes more than its own memory.
#[derive(Debug)]
pub struct Queue {
    rows: Vec<[Entry; ROW]>,
    /// The row after each one; after a row that is free comes the next free one.
    after: Vec<u32>,
    free: u32,
    /// The places of each bucket's first and last entry. A row's number times [`ROW`] is the place of
    /// its first entry.
    ends: Vec<[u32; 2]>,
    /// One bit per bucket that is not empty.
    filled: [u64; BUCKETS / 64],
    /// No word before this one of `filled` has a bit.
    lowest: usize,
    length: usize,
}

impl Default for Queue {
    fn default() -> Self {
        Self {
            rows: Vec::new(),
            after: Vec::new(),
            free: NONE,
            ends: vec![[NONE; 2]; BUCKETS],
            filled: [0; BUCKETS / 64],
            lowest: 0,
            length: 0,
        }
    }
}

impl Queue {
    /// Puts an entry into a bucket.
    pub fn push(&mut self, bucket: usize, entry: Entry) {
        let [first, last] = self.ends[bucket];
        let place = match last {
            NONE => self.place_in_free_row(),
            last if ends_a_row(last) => {
                let place = self.place_in_free_row();
                self.after[row(last)] = row(place) as u32;
                place
            }
            last => last + 1,
        };
        self.rows[row(place)][place as usize % ROW] = entry;
        self.ends[bucket] = [if first == NONE { place } else { first }, place];
        self.filled[bucket / 64] |= 1 << (bucket % 64);
        self.lowest = self.lowest.min(bucket / 64);
        self.length += 1;
    }

    /// The first place of a row that no bucket has.
    fn place_in_free_row(&mut self) -> u32 {
        let row = self.free;
        if row == NONE {
            self.rows.push([Entry { slot: 0, newest: 0 }; ROW]);
            self.after.push(NONE);
            return ((self.rows.len() - 1) * ROW) as u32;
        }
        self.free = self.after[row as usize];
        row * ROW as u32
    }

    /// Takes the oldest entry of the first bucket that is not empty.
    pub fn pop(&mut self) -> Option<Entry> {
        let words = &self.filled[self.lowest..];
        self.lowest += words.iter().position(|&word| word != 0).unwrap_or(words.len());
        let word = *self.filled.get(self.lowest)?;
        let bucket = self.lowest * 64 + word.trailing_zeros() as usize;
        let [first, last] = self.ends[bucket];
        let entry = self.rows[row(first)][first as usize % ROW];
        let is_done = first == last;
        if is_done || ends_a_row(first) {
            let done = row(first);
            let after = mem::replace(&mut self.after[done], self.free);
            self.free = done as u32;
            self.ends[bucket][0] = after.wrapping_mul(ROW as u32);
        } else {
            self.ends[bucket][0] += 1;
        }
        if is_done {
            self.ends[bucket] = [NONE; 2];
            self.filled[self.lowest] &= word - 1;
        }
        self.length -= 1;
        Some(entry)
    }

    /// How many entries there are, stale ones included.
    #[must_use]
    pub fn len(&self) -> usize {
        self.length
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }
}

fn row(place: u32) -> usize {
    place as usize / ROW
}

fn ends_a_row(place: u32) -> bool {
    place as usize % ROW == ROW - 1
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, VecDeque};

    use super::*;
    use crate::random::Random;

    fn entry(slot: u32) -> Entry {
        Entry { slot, newest: 0 }
    }

    #[test]
    fn the_lowest_bucket_comes_first_and_is_first_in_first_out() {
        let mut queue = Queue::default();
        for (bucket, slot) in [(900, 1), (70, 2), (900, 3), (70, 4)] {
            queue.push(bucket, entry(slot));
        }
        let order: Vec<_> = std::iter::from_fn(|| queue.pop()).map(|e| e.slot).collect();
        assert_eq!(order, [2, 4, 1, 3]);
        assert!(queue.is_empty());
    }

    #[test]
    fn many_entries_come_and_go_as_through_lists() {
        let (mut queue, mut random) = (Queue::default(), Random::default());
        let mut lists: BTreeMap<usize, VecDeque<Entry>> = BTreeMap::new();
        for slot in 0..20_000 {
            let bucket = random.below(6) as usize * 777;
            queue.push(bucket, entry(slot));
            lists.entry(bucket).or_default().push_back(entry(slot));
            for _ in 0..random.below(if slot < 12_000 { 2 } else { 4 }) {
                let expected = lists.values_mut().find_map(VecDeque::pop_front);
                assert_eq!(queue.pop(), expected);
            }
        }
        for expected in lists.into_values().flatten() {
            assert_eq!(queue.pop(), Some(expected));
        }
        assert!(queue.is_empty() && queue.pop().is_none());
        assert!(queue.rows.len() * ROW < 7_000, "free rows are used again");
    }

    #[test]
    fn a_shorter_edge_is_in_no_later_bucket() {
        let mut last = 0;
        for i in -400..400 {
            let bucket = by_length(2f64.powf(f64::from(i) / 4.0));
            assert!(bucket >= last);
            last = bucket;
        }
    }

    #[test]
    fn a_smaller_angle_is_in_no_later_bucket() {
        let mut last = 0;
        for i in -700..=0 {
            let bucket = by_sine(2f64.powf(f64::from(i) / 10.0));
            assert!(bucket >= last);
            last = bucket;
        }
    }
}
