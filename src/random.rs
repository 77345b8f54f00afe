//! Random numbers, the same ones every time: one input, one mesh.

/// `SplitMix64` (Steele, Lea and Flood, *Fast Splittable Pseudorandom Number Generators*, 2014).
#[derive(Debug, Clone, Default)]
pub(crate) struct Random {
    state: u64,
}

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `count`, which is far below 2⁶⁴; 0 where that is 0.
    pub fn below(&mut self, count: u64) -> u64 {
        ((u128::from(self.bits()) * u128::from(count)) >> 64) as u64
    }

    /// A point of the unit square, without its upper and right sides.
    pub fn in_square(&mut self) -> [f64; 2] {
        const UNIT: f64 = 1.0 / (1_u64 << 32) as f64;
        let bits = self.bits();
        [bits >> 32, bits & 0xffff_ffff].map(|half| half as f64 * UNIT)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_those_of_split_mix() {
        assert_eq!(Random::default().bits(), 0xe220_a839_7b1d_cdaf);
    }

    #[test]
    fn random_places_fill_the_square() {
        let random = &mut Random::default();
        let mut quarters = [0; 4];
        for _ in 0..1000 {
            let [x, y] = random.in_square();
            assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y));
            quarters[usize::from(x < 0.5) * 2 + usize::from(y < 0.5)] += 1;
        }
        assert!(quarters.iter().all(|&count| count > 200), "{quarters:?}");
    }

    #[test]
    fn numbers_below_a_bound_are_below_it() {
        let random = &mut Random::default();
        assert!((0..1000).all(|_| random.below(7) < 7));
        assert_eq!(random.below(0), 0);
    }
}
