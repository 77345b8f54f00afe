//! Whole numbers in as few bytes each as the largest of them asks for.

/// Whole numbers, of 64 bits where some need them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Wholes {
    Bits8(Vec<i8>),
    Bits32(Vec<i32>),
    Bits64(Vec<i64>),
}

impl Default for Wholes {
    fn default() -> Self {
        Self::Bits8(Vec::new())
    }
}

impl Wholes {
    /// Room for so many numbers.
    pub fn with_capacity(count: usize) -> Self {
        Self::Bits8(Vec::with_capacity(count))
    }

    pub fn len(&self) -> usize {
        match self {
            Self::Bits8(numbers) => numbers.len(),
            Self::Bits32(numbers) => numbers.len(),
            Self::Bits64(numbers) => numbers.len(),
        }
    }

    /// The number at an index, which is below [`Wholes::len`].
    pub fn at(&self, index: usize) -> i64 {
        match self {
            Self::Bits8(numbers) => numbers[index].into(),
            Self::Bits32(numbers) => numbers[index].into(),
            Self::Bits64(numbers) => numbers[index],
        }
    }

    pub fn last(&self) -> Option<i64> {
        self.len().checked_sub(1).map(|last| self.at(last))
    }

    pub fn iter(&self) -> impl ExactSizeIterator<Item = i64> + '_ {
        (0..self.len()).map(|index| self.at(index))
    }

    /// Hands on all numbers, block by block.
    pub fn blocks(&self, mut take: impl FnMut(&[i64])) {
        const BLOCK: usize = 1 << 12;
        let mut block = Vec::with_capacity(BLOCK.min(self.len()));
        for start in (0..self.len()).step_by(BLOCK) {
            block.clear();
            block.extend((start..self.len().min(start + BLOCK)).map(|index| self.at(index)));
            take(&block);
        }
    }

    /// How many numbers there are before the first one that fails a test, which none behind it
    /// passes.
    pub fn partition_point(&self, passes: impl Fn(i64) -> bool) -> usize {
        let (mut low, mut high) = (0, self.len());
        while low < high {
            let middle = low.midpoint(high);
            if passes(self.at(middle)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    }

    /// Appends numbers.
    pub fn extend(&mut self, numbers: &[i64]) {
        let (least, most) = numbers
            .iter()
            .fold((0, 0), |(least, most), &number| (number.min(least), number.max(most)));
        let fits = |least_held: i64, most_held: i64| least_held <= least && most <= most_held;
        if fits(i8::MIN.into(), i8::MAX.into()) {
        } else if fits(i32::MIN.into(), i32::MAX.into()) {
            self.widen_to_32();
        } else {
            self.widen_to_64();
        }
        match self {
            Self::Bits8(held) => held.extend(numbers.iter().map(|&number| number as i8)),
            Self::Bits32(held) => held.extend(numbers.iter().map(|&number| number as i32)),
            Self::Bits64(held) => held.extend_from_slice(numbers),
        }
    }

    fn widen_to_32(&mut self) {
        if let Self::Bits8(narrow) = self {
            let mut wide = Vec::with_capacity(narrow.capacity());
            wide.extend(narrow.iter().map(|&number| i32::from(number)));
            *self = Self::Bits32(wide);
        }
    }

    fn widen_to_64(&mut self) {
        let capacity = match self {
            Self::Bits8(narrow) => narrow.capacity(),
            Self::Bits32(narrow) => narrow.capacity(),
            Self::Bits64(_) => return,
        };
        let mut wide = Vec::with_capacity(capacity);
        wide.extend(self.iter());
        *self = Self::Bits64(wide);
    }

    /// The numbers with 64 bits each.
    pub fn into_vec(self) -> Vec<i64> {
        match self {
            Self::Bits64(numbers) => numbers,
            narrow => narrow.iter().collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_held_in_as_few_bytes_as_the_largest_needs() {
        let mut wholes = Wholes::default();
        let mut expected = Vec::new();
        for (numbers, bits) in [
            (&[-128, 127][..], 8),
            (&[], 8),
            (&[128], 32),
            (&[1, -129, i64::from(i32::MIN), i64::from(i32::MAX)], 32),
            (&[i64::from(i32::MIN) - 1], 64),
            (&[5, i64::MIN, i64::MAX], 64),
        ] {
            wholes.extend(numbers);
            expected.extend_from_slice(numbers);
            let found = match &wholes {
                Wholes::Bits8(_) => 8,
                Wholes::Bits32(_) => 32,
                Wholes::Bits64(_) => 64,
            };
            assert_eq!((found, wholes.iter().collect::<Vec<_>>()), (bits, expected.clone()));
            assert_eq!(wholes.last(), expected.last().copied());
            assert_eq!(wholes.clone().into_vec(), expected);
        }
    }

    #[test]
    fn the_first_number_that_fails_is_found() {
        let mut wholes = Wholes::default();
        wholes.extend(&[0, 3, 3, 900]);
        let below = |limit| wholes.partition_point(|number| number < limit);
        assert_eq!([below(0), below(3), below(4), below(901)], [0, 1, 3, 4]);
    }
}
