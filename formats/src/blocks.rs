//! Items sorted by the block that they stand in.

/// Items in the order of their blocks, and where each block starts.
pub(crate) struct Blocks {
    items: Vec<u32>,
    starts: Vec<usize>,
}

impl Blocks {
    /// Sorts items, each of which names its block; within a block they keep their order.
    pub fn new(of: impl Iterator<Item = usize> + Clone, blocks: usize) -> Self {
        let mut starts = vec![0; blocks + 1];
        of.clone().for_each(|block| starts[block + 1] += 1);
        for block in 0..blocks {
            starts[block + 1] += starts[block];
        }
        let mut next = starts.clone();
        let mut items = vec![0; starts[blocks]];
        for (item, block) in (0..).zip(of) {
            items[next[block]] = item;
            next[block] += 1;
        }
        Self { items, starts }
    }

    /// The items of each block.
    pub fn all(&self) -> impl Iterator<Item = &[u32]> {
        self.starts.windows(2).map(|ends| &self.items[ends[0]..ends[1]])
    }

    /// The blocks that hold something, by their numbers.
    pub fn in_use(&self) -> impl Iterator<Item = (usize, &[u32])> {
        self.all().enumerate().filter(|(_, items)| !items.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_keep_their_order_within_a_block() {
        let blocks = Blocks::new([2, 0, 2, 2, 0].into_iter(), 4);
        let all: Vec<_> = blocks.all().collect();
        assert_eq!(all, [&[1, 4][..], &[], &[0, 2, 3], &[]]);
        assert_eq!(blocks.in_use().map(|(block, _)| block).collect::<Vec<_>>(), [0, 2]);
    }
}
