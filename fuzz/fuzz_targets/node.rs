//! Any bytes are a `.node` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::node;

fuzz_target!(|bytes: &[u8]| {
    if let Ok((pslg, _)) = node::read(bytes, "any.node") {
        let count = pslg.points.len();
        assert!(pslg.points.iter().flatten().all(|x| x.is_finite()));
        assert!([0, count].contains(&pslg.point_markers.len()));
        assert!(pslg.point_attributes.iter().all(|attribute| attribute.values.len() == count));
    }
});
