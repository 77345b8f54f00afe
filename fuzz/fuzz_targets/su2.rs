//! Any bytes are a `.su2` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::su2;

mod whole;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((mesh, _)) = su2::read(bytes, "any.su2") {
        whole::check(&mesh);
    }
});
