//! A set of numbers in a third of a byte each, with what is kept for its members alone.

/// Which of the numbers 0, 1, 2 … are members; numbers come at the end. Each member has a rank: how
/// many members are less. So what only members have stands in an array by ranks.
#[derive(Debug, Clone, Default)]
pub struct RankedSet {
    words: Vec<Word>,
    numbers: u32,
}

/// Thirty-two numbers.
#[derive(Debug, Clone, Copy, Default)]
struct Word {
    /// One bit for each.
    members: u32,
    /// How many members come before these numbers.
    before: u32,
}

/// How many numbers a word holds.
const NUMBERS: u32 = u32::BITS;

impl RankedSet {
    /// The first `numbers` numbers, none of which is a member.
    pub fn of_none(numbers: usize) -> Self {
        let words = vec![Word::default(); numbers.div_ceil(NUMBERS as usize)];
        Self { words, numbers: numbers as u32 }
    }

    /// How many members there are.
    pub fn members(&self) -> usize {
        self.words.last().map_or(0, |word| word.before + word.members.count_ones()) as usize
    }

    /// The next number, a member or not.
    #[inline]
    pub fn push(&mut self, is_member: bool) {
        let bit = self.numbers % NUMBERS;
        if bit == 0 {
            self.words.push(Word { members: 0, before: self.members() as u32 });
        }
        if let Some(word) = self.words.last_mut() {
            word.members |= u32::from(is_member) << bit;
        }
        self.numbers += 1;
    }

    /// The rank of a member; `None` for a number that is none.
    #[inline]
    pub fn rank(&self, number: u32) -> Option<usize> {
        let word = self.words.get((number / NUMBERS) as usize)?;
        let bit = 1 << (number % NUMBERS);
        let less = word.members & (bit - 1);
        (word.members & bit != 0).then(|| (word.before + less.count_ones()) as usize)
    }

    /// Whether a number is a member.
    #[inline]
    pub fn contains(&self, number: u32) -> bool {
        let word = self.words.get((number / NUMBERS) as usize);
        word.is_some_and(|word| word.members >> (number % NUMBERS) & 1 != 0)
    }

    /// Whether there is such a number, a member or not.
    #[inline]
    pub fn has(&self, number: u32) -> bool {
        number < self.numbers
    }

    /// Forgets all numbers but the first `numbers`.
    pub fn truncate(&mut self, numbers: usize) {
        if numbers >= self.numbers as usize {
            return;
        }
        self.numbers = numbers as u32;
        self.words.truncate(numbers.div_ceil(NUMBERS as usize));
        let used = self.numbers % NUMBERS;
        if let Some(word) = self.words.last_mut().filter(|_| used != 0) {
            word.members &= (1 << used) - 1;
        }
    }

    /// Forgets the numbers that do not stay; the others are counted from 0 again, in their order.
    pub fn retain(&mut self, stays: impl Fn(u32) -> bool) {
        *self = (0..self.numbers).filter(|&n| stays(n)).map(|n| self.rank(n).is_some()).collect();
    }
}

impl FromIterator<bool> for RankedSet {
    fn from_iter<I: IntoIterator<Item = bool>>(are_members: I) -> Self {
        let mut made = Self::default();
        are_members.into_iter().for_each(|is_member| made.push(is_member));
        made
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_member(number: u32) -> bool {
        number.is_multiple_of(3) || number.is_power_of_two()
    }

    fn ranks(set: &RankedSet, numbers: u32) -> Vec<Option<usize>> {
        (0..numbers).map(|number| set.rank(number)).collect()
    }

    /// The ranks by counting.
    fn counted(members: impl Iterator<Item = bool>) -> Vec<Option<usize>> {
        let mut ranks = 0..;
        members.map(|is_member| if is_member { ranks.next() } else { None }).collect()
    }

    #[test]
    fn a_rank_is_how_many_members_are_less() {
        let set: RankedSet = (0..200).map(is_member).collect();
        assert_eq!(ranks(&set, 200), counted((0..200).map(is_member)));
        assert!((0..200).all(|number| set.contains(number) == is_member(number)));
        assert!(!set.contains(200) && !set.contains(100_000));
        assert_eq!(set.members(), (0..200).filter(|&n| is_member(n)).count());
        assert_eq!((set.rank(200), set.rank(100_000)), (None, None));
        assert!(set.has(199) && !set.has(200));
    }

    #[test]
    fn what_is_forgotten_leaves_no_member_behind() {
        for kept in [0, 1, 31, 32, 33, 64, 96, 199, 200, 300] {
            let mut set: RankedSet = (0..200).map(is_member).collect();
            set.truncate(kept);
            set.push(false);
            set.push(true);
            let members = (0..200).map(is_member).take(kept).chain([false, true]);
            assert_eq!(ranks(&set, 202), {
                let mut expected = counted(members);
                expected.resize(202, None);
                expected
            });
        }
    }

    #[test]
    fn those_that_stay_keep_their_order() {
        let mut set: RankedSet = (0..200).map(is_member).collect();
        let stays = |number: u32| number % 5 != 1;
        set.retain(stays);
        let expected = counted((0..200).filter(|&n| stays(n)).map(is_member));
        assert_eq!(ranks(&set, expected.len() as u32), expected);
    }

    #[test]
    fn a_set_of_none_takes_members_behind_its_numbers() {
        for numbers in [0, 5, 32, 40] {
            let mut set = RankedSet::of_none(numbers);
            set.push(true);
            assert_eq!(set.rank(numbers as u32), Some(0));
            assert_eq!(set.members(), 1);
        }
    }
}
