//! Any bytes are a `.poly` file or are refused; what is read holds together.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::poly;

fuzz_target!(|bytes: &[u8]| {
    // The points beside are the same bytes once more.
    if let Ok((pslg, _)) = poly::read(bytes, "any.poly", |_| Ok(bytes.to_vec())) {
        let count = pslg.points.len();
        assert!(pslg.points.iter().flatten().all(|x| x.is_finite()));
        assert!(pslg.segments.iter().flatten().all(|&point| (point as usize) < count));
        assert_eq!(pslg.segment_tags.len(), pslg.segments.len());
        assert!(pslg.holes.iter().flatten().all(|x| x.is_finite()));
        assert!(pslg.regions.iter().all(|region| region.max_area.is_none_or(|area| area > 0.0)));
    }
});
