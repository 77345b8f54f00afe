//! Sorting numbers whose upper half is a key and whose lower half an index: digit by digit, where that
//! is faster than comparisons.

use crate::memory::give_back;

/// Bits of the key that are looked at in one pass.
const DIGIT: u32 = 11;
const PASSES: usize = 3;
/// Fewer numbers are compared.
const FEW: usize = 1 << 12;
/// From here on numbers are compared, too: a pass puts each one somewhere else in more memory than the
/// cache holds, and needs as much again.
const MANY: usize = 1 << 19;

/// Sorts numbers, the upper half of which is a key, and the lower an index that counts up.
pub fn sort(numbers: &mut Vec<u64>) {
    if !(FEW..MANY).contains(&numbers.len()) {
        numbers.sort_unstable();
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
        if starts[digit(numbers[0], pass)] as usize == numbers.len() {
            continue; // that digit is the same in all
        }
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
    fn numbers_are_sorted_however_many_there_are() {
        let mut random = Random::default();
        // Keys that differ in each digit or only in one, and are often the same.
        for mask in [0xe01c_0303_u64, 0x0000_0303] {
            for count in [FEW - 1, 3 * FEW, MANY] {
                let key = |bits: u64| bits & mask << 32;
                let mut numbers: Vec<u64> =
                    (0..count as u64).map(|index| key(random.bits()) | index).collect();
                let mut expected = numbers.clone();
                expected.sort_by_key(|number| number >> 32);
                sort(&mut numbers);
                assert!(numbers == expected, "{count} numbers");
            }
        }
    }
}
