//! Any bytes are a `.ele` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::{Pslg, ele};

fuzz_target!(|bytes: &[u8]| {
    let outline = Pslg { points: vec![[0.0; 2]; 12], ..Pslg::default() };
    if let Ok((mesh, _)) = ele::read(bytes, "any.ele", &outline) {
        assert!(mesh.triangles.iter().flatten().all(|&corner| corner < 12));
        assert_eq!(mesh.triangle_tags.len(), mesh.triangles.len());
    }
    // The files beside are the same bytes once more.
    let _ = ele::read_with_companions(bytes, "any.ele", |_| Ok(bytes.to_vec()));
});
