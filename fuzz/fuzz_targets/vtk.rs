//! Any bytes are a legacy `.vtk` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::vtk;

mod whole;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((mesh, _)) = vtk::read(bytes, "any.vtk") {
        whole::check(&mesh);
    }
});
