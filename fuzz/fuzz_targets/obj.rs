//! Any bytes are an `.obj` file or are refused; what is read holds together, and is written so
//! that it reads back the same.

#![no_main]

use libfuzzer_sys::fuzz_target;
use meshwright_formats::{Pslg, obj};

fuzz_target!(|bytes: &[u8]| {
    for faces in [false, true] {
        let Ok((pslg, _)) = obj::read_with(bytes, "any.obj", obj::Options { faces }) else {
            continue;
        };
        holds(&pslg);
        let mut text = Vec::new();
        obj::write_outline(&pslg, &mut text).expect("memory takes all");
        let (again, _) = obj::read(&text, "again.obj").expect("what is written is read");
        assert_eq!((again.points, again.segments), (pslg.points, pslg.segments));
        assert_eq!(again.segment_tags, pslg.segment_tags);
    }
});

fn holds(pslg: &Pslg) {
    let count = pslg.points.len();
    assert!(pslg.points.iter().flatten().all(|x| x.is_finite()));
    assert!(pslg.segments.iter().flatten().all(|&point| (point as usize) < count));
    assert_eq!(pslg.segment_tags.len(), pslg.segments.len());
    assert_eq!(pslg.source.point_lines.len(), count);
    assert_eq!(pslg.source.segment_lines.len(), pslg.segments.len());
}
