//! Any bytes are a Medit `.mesh` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::medit;

mod whole;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((mesh, _)) = medit::read(bytes, "any.mesh") {
        whole::check(&mesh);
    }
});
