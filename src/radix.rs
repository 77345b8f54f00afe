//! Sorting numbers whose upper half is a key and whose lower half an index: without comparisons.

use crate::memory::give_back;

/// Bits of the key that are looked at in one pass.
const DIGIT: u32 = 11;
const PASSES: usize = 3;
/// Fewer numbers are compared.
const FEW: usize = 1 << 12;

/// Sorts numbers by their upper 32 bits; equals stay in their order.
pub fn sort_by_upper_half(numbers: &mut Vec<u64>) {
    if numbers.len() < FEW {
        numbers.sort_by_key(|number| number >> 32);
        return;
    }
    let digit = |number: u64, pass: usize| {
        (number >> (32 + DIGIT * pass as u32)) as usize & ((1 << DIGIT) - 1)
    };
    let mut starts = [[0_u32; 1 << DIGIT]; PASSES];
    for &number in numbers.iter() {
        for (pass, counts) in starts.iter_mut().enumerate() {
            counts[digit(number, pass)] += 1;
        }
    }
    let mut sorted = vec![0; numbers.len()];
    for (pass, starts) in starts.iter_mut().enumerate() {
        let mut before = 0;
        for start in starts.iter_mut() {
            (before, *start) = (before + *start, before);
        }
        for &number in numbers.iter() {
            let place = &mut starts[digit(number, pass)];
            sorted[*place as usize] = number;
            *place += 1;
        }
        std::mem::swap(numbers, &mut sorted);
    }
    give_back(sorted);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn many_numbers_are_sorted_as_few_are() {
        let mut random = Random::default();
        // Keys that differ in each digit, and are often the same.
        let key = |bits: u64| bits & 0xe01c_0303_0000_0000;
        let mut numbers: Vec<u64> =
            (0..3 * FEW as u64).map(|index| key(random.bits()) | index).collect();
        let mut expected = numbers.clone();
        expected.sort_by_key(|number| number >> 32);
        sort_by_upper_half(&mut numbers);
        assert_eq!(numbers, expected);
    }
}
