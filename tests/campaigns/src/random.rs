//! A small generator of random numbers: the same numbers on every platform, for ever.
//!
//! `SplitMix64` (Steele, Lea and Flood, *Fast Splittable Pseudorandom Number Generators*, 2014):
//! the state walks in steps of the golden ratio, an avalanche function makes the output. It passes
//! the usual test batteries, and ten lines define it, so an outline named by its seed can be made
//! again by anybody. Logarithms and exponentials come from `libm`, not from the platform.

/// A stream of random numbers.
///
/// ```
/// use meshwright_campaigns::Random;
/// assert_eq!(Random::new(0).bits(), 0xe220_a839_7b1d_cdaf);
/// assert_eq!(Random::new(7).unit(), Random::new(7).unit());
/// ```
#[derive(Debug, Clone)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The stream with this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// The stream number `index` of the seed `seed`: streams of different indices have nothing in
    /// common that a campaign could notice.
    #[must_use]
    pub fn stream(seed: u64, index: u64) -> Self {
        let mut root = Self::new(seed);
        let first = root.bits();
        Self::new(first ^ Self::new(index.wrapping_mul(0xd134_2543_de82_ef95)).bits())
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number of [0, 1), a multiple of 2⁻⁵³.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (1.0 / (1_u64 << 53) as f64)
    }

    /// A number between two bounds.
    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A number between two positive bounds, its logarithm evenly spread.
    pub fn log_range(&mut self, low: f64, high: f64) -> f64 {
        libm::exp(self.range(libm::log(low), libm::log(high)))
    }

    /// A whole number of `low..=high`.
    pub fn whole(&mut self, low: usize, high: usize) -> usize {
        let count = (high - low + 1) as u64;
        // The bias of the remainder is count / 2⁶⁴: of no account here.
        low + (self.bits() % count) as usize
    }

    /// Whether something that happens with this probability happens.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// One of several things.
    ///
    /// # Panics
    /// When there is nothing to choose from.
    pub fn pick<'a, T>(&mut self, things: &'a [T]) -> &'a T {
        &things[self.whole(0, things.len() - 1)]
    }

    /// A direction: an angle of [0, 2π), in radians.
    pub fn direction(&mut self) -> f64 {
        self.range(0.0, std::f64::consts::TAU)
    }

    /// Brings a slice into random order.
    pub fn shuffle<T>(&mut self, things: &mut [T]) {
        for last in (1..things.len()).rev() {
            things.swap(last, self.whole(0, last));
        }
    }
}
