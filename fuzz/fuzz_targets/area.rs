//! Any bytes are an `.area` file or are refused; a bound that is read is positive.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::area;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((areas, _)) = area::read(bytes, "any.area") {
        assert!(areas.iter().flatten().all(|&area| area > 0.0 && area.is_finite()));
    }
});
