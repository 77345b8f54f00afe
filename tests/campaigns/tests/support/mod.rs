//! What the test files share.

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// So many cases from a fixed seed, so that a red run is red again. `PROPTEST_RNG_SEED` and
/// `PROPTEST_CASES` ask for others; a failure prints its (shrunk) input.
pub fn cases(count: u32) -> ProptestConfig {
    let mut config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = count;
    }
    if config.rng_seed == RngSeed::Random {
        config.rng_seed = RngSeed::Fixed(1);
    }
    config
}
