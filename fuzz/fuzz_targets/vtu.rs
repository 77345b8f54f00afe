//! Any bytes are a `.vtu` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::vtu;

mod whole;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((mesh, _)) = vtu::read(bytes, "any.vtu") {
        whole::check(&mesh);
    }
});
