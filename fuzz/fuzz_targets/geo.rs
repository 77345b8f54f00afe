//! Any bytes are a `.geo` script or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::geo;

fuzz_target!(|bytes: &[u8]| {
    // A file that a script includes is the script once more.
    match geo::read(bytes, "any.geo", |_| Ok(bytes.to_vec())) {
        Err(error) => {
            assert!(error.line >= 1 && error.column >= 1, "{error}");
            assert!(error.column as usize <= error.text.chars().count() + 1, "{error}");
        }
        Ok((pslg, _)) => {
            let count = pslg.points.len();
            assert!(pslg.points.iter().flatten().all(|x| x.is_finite()));
            assert!(pslg.segments.iter().flatten().all(|&point| (point as usize) < count));
            assert_eq!(pslg.segment_tags.len(), pslg.segments.len());
            assert_eq!(pslg.point_sizes.len(), count);
            assert!(pslg.point_sizes.iter().all(|&size| size > 0.0));
            assert!(pslg.regions.iter().all(|region| region.seed.iter().all(|x| x.is_finite())));
        }
    }
});
