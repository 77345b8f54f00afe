//! Any bytes are a `.inp` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::inp;

mod whole;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((mesh, _)) = inp::read(bytes, "any.inp") {
        whole::check(&mesh);
    }
});
