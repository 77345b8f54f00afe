//! Any bytes are a `.msh` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::msh;

mod whole;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((mesh, _)) = msh::read(bytes, "any.msh") {
        whole::check(&mesh);
    }
});
