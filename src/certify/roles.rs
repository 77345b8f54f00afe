//! What the half-edges of a mesh are parts of: few of them are of anything.

/// A listed edge that is no part of a segment known so far.
const LISTED: u32 = 0;

/// The half-edges that are a part of a segment, or at least listed.
pub(super) struct Roles {
    /// A half-edge in the high half of each number; in the low half [`LISTED`], or the half-edge of
    /// the outline plus one. In order, when settled.
    known: Vec<u64>,
    /// By half-edge one bit: whether it is among them.
    is_bound: Vec<u64>,
    /// How many of them come before each 64 half-edges, when settled.
    before: Vec<u32>,
}

impl Roles {
    /// No half-edge below `count` has a role; those of so many edges will have one.
    pub(super) fn new(count: u32, edges: usize) -> Self {
        Self {
            known: Vec::with_capacity(2 * edges),
            is_bound: vec![0; count.div_ceil(64) as usize],
            before: Vec::new(),
        }
    }

    /// Makes a half-edge one that is listed.
    pub(super) fn list(&mut self, h: u32) {
        self.set(h, LISTED);
    }

    /// Makes a half-edge a part of a half-edge of the outline, whatever it was.
    pub(super) fn claim(&mut self, h: u32, outline_half: u32) {
        self.set(h, outline_half + 1);
    }

    fn set(&mut self, h: u32, role: u32) {
        self.known.push(u64::from(h) << 32 | u64::from(role));
        self.is_bound[h as usize / 64] |= 1 << (h % 64);
    }

    /// Ends the list: of several roles of one half-edge the last counts.
    pub(super) fn settle(&mut self) {
        // (The segments claim in order, so the last one is the largest.)
        self.known.sort_unstable_by_key(|&known| std::cmp::Reverse(known));
        self.known.dedup_by_key(|known| *known >> 32);
        self.known.reverse();
        self.known.shrink_to_fit();
        let mut so_far = 0;
        let counts = self.is_bound.iter().map(|bits| {
            so_far += bits.count_ones();
            so_far - bits.count_ones()
        });
        self.before = counts.collect();
    }

    /// Those half-edges, in order.
    pub(super) fn halves(&self) -> impl Iterator<Item = u32> + '_ {
        self.known.iter().map(|known| (known >> 32) as u32)
    }

    /// Whether a half-edge is among them.
    pub(super) fn is_bound(&self, h: u32) -> bool {
        self.is_bound[h as usize / 64] >> (h % 64) & 1 == 1
    }

    /// The half-edge of the outline that a half-edge is a part of, once that is settled.
    pub(super) fn outline_half(&self, h: u32) -> Option<u32> {
        if !self.is_bound(h) {
            return None;
        }
        let (word, bit) = (h as usize / 64, h % 64);
        let below = (self.is_bound[word] & ((1 << bit) - 1)).count_ones();
        let known = self.known[(self.before[word] + below) as usize];
        (known as u32).checked_sub(1)
    }
}
