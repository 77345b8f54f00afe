//! The queue of bad triangles: as good as a heap, at the price of a list.

use super::quality::Trigger;

/// A bad triangle by its slot and its newest vertex: a slot that was reused since has another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Entry {
    /// The slot, and below it in three bits the reason.
    slot_and_reason: u32,
    /// Vertex 0 of the triangle that was queued.
    pub newest: u32,
}

/// What the look that queued a triangle told of why it is bad.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// The angle opposite this edge, its shortest, is too small, and not excused.
    SmallAngle(usize),
    /// It is too large. This edge is its shortest.
    TooLarge(usize),
    /// Still to be found out.
    Unknown,
}

const UNKNOWN: u32 = 3;
const LARGE: u32 = 4;

impl Entry {
    /// The triangle in a slot.
    #[inline]
    #[must_use]
    pub fn new(slot: u32, newest: u32, reason: Reason) -> Self {
        let reason = match reason {
            Reason::SmallAngle(edge) => edge as u32,
            Reason::TooLarge(edge) => LARGE | edge as u32,
            Reason::Unknown => UNKNOWN,
        };
        Self { slot_and_reason: slot << 3 | reason, newest }
    }

    /// The slot.
    #[inline]
    #[must_use]
    pub fn slot(self) -> u32 {
        self.slot_and_reason >> 3
    }

    /// Why it is bad.
    #[inline]
    #[must_use]
    pub fn reason(self) -> Reason {
        let edge = (self.slot_and_reason & 3) as usize;
        match self.slot_and_reason & 7 {
            UNKNOWN => Reason::Unknown,
            LARGE.. => Reason::TooLarge(edge),
            _ => Reason::SmallAngle(edge),
        }
    }
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
/// No place.
const NONE: u32 = u32::MAX;

/// Buckets of entries, first in first out: lists through one array, whose places are used again, the
/// last one first, so that what is used of it stays in the cache.
#[derive(Debug)]
pub struct Queue {
    links: Vec<Link>,
    /// The first of the places that are free, a list too.
    free: u32,
    /// The places of each bucket's first and last entry.
    ends: Box<[[u32; 2]; BUCKETS]>,
    /// One bit per bucket that is not empty.
    filled: [u64; BUCKETS / 64],
    /// No word before this one of `filled` has a bit.
    lowest: usize,
    length: usize,
}

#[derive(Debug, Clone, Copy)]
struct Link {
    entry: Entry,
    /// The place of the next one in the list.
    next: u32,
}

impl Default for Queue {
    fn default() -> Self {
        Self {
            links: Vec::new(),
            free: NONE,
            ends: Box::new([[NONE; 2]; BUCKETS]),
            filled: [0; BUCKETS / 64],
            lowest: 0,
            length: 0,
        }
    }
}

impl Queue {
    /// Puts an entry into a bucket.
    #[inline]
    pub fn push(&mut self, bucket: usize, entry: Entry) {
        let bucket = bucket % BUCKETS;
        let place = self.place_for(Link { entry, next: NONE });
        let [first, last] = &mut self.ends[bucket];
        match self.links.get_mut(*last as usize) {
            Some(last) => last.next = place,
            None => *first = place,
        }
        *last = place;
        self.filled[bucket / 64] |= 1 << (bucket % 64);
        self.lowest = self.lowest.min(bucket / 64);
        self.length += 1;
    }

    #[inline]
    fn place_for(&mut self, link: Link) -> u32 {
        let place = self.free;
        match self.links.get_mut(place as usize) {
            Some(free) => {
                self.free = free.next;
                *free = link;
                place
            }
            None => {
                self.links.push(link);
                self.links.len() as u32 - 1
            }
        }
    }

    /// Takes the oldest entry of the first bucket that is not empty, and tells which bucket that is.
    #[inline]
    pub fn pop(&mut self) -> Option<(usize, Entry)> {
        while *self.filled.get(self.lowest)? == 0 {
            self.lowest += 1;
        }
        let word = &mut self.filled[self.lowest];
        let bucket = (self.lowest * 64 + word.trailing_zeros() as usize) % BUCKETS;
        let [first, last] = &mut self.ends[bucket];
        let (place, link) = (*first, &mut self.links[*first as usize]);
        *first = link.next;
        if link.next == NONE {
            *last = NONE;
            *word &= *word - 1;
        }
        let entry = link.entry;
        link.next = self.free;
        self.free = place;
        self.length -= 1;
        if self.length == 0 {
            self.close_ranks();
        }
        Some((bucket, entry))
    }

    /// Begins with the first place again: what many entries left free lies far apart.
    fn close_ranks(&mut self) {
        self.links.clear();
        self.free = NONE;
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

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, VecDeque};

    use super::*;
    use crate::random::Random;

    fn entry(slot: u32) -> Entry {
        Entry::new(slot, 0, Reason::Unknown)
    }

    #[test]
    fn an_entry_keeps_its_slot_and_its_reason() {
        for edge in 0..3 {
            for reason in [Reason::SmallAngle(edge), Reason::TooLarge(edge), Reason::Unknown] {
                let entry = Entry::new((1 << 29) - 1, 7, reason);
                assert_eq!((entry.slot(), entry.reason()), ((1 << 29) - 1, reason));
            }
        }
    }

    #[test]
    fn the_lowest_bucket_comes_first_and_is_first_in_first_out() {
        let mut queue = Queue::default();
        for (bucket, slot) in [(900, 1), (70, 2), (900, 3), (70, 4)] {
            queue.push(bucket, entry(slot));
        }
        let order: Vec<_> = std::iter::from_fn(|| queue.pop()).map(|(_, e)| e.slot()).collect();
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
                let lists = lists.iter_mut();
                let expected = lists.filter_map(|(&b, list)| Some((b, list.pop_front()?))).next();
                assert_eq!(queue.pop(), expected);
            }
        }
        for (bucket, list) in lists {
            list.into_iter().for_each(|entry| assert_eq!(queue.pop(), Some((bucket, entry))));
        }
        assert!(queue.is_empty() && queue.pop().is_none());
        assert!(queue.links.len() < 7_000, "free places are used again");
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
