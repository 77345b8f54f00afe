use proptest::prelude::*;

use super::*;

/// An untagged outline without a file.
fn outline(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Pslg {
    Pslg {
        points: points.to_vec(),
        segments: segments.to_vec(),
        segment_tags: vec![0; segments.len()],
        ..Pslg::default()
    }
}

fn domain(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Result<Domain, Error> {
    Domain::new(&outline(points, segments), Region::Domain).map(|(domain, _)| domain)
}

/// The sign of the area of a triangle of small whole numbers.
fn turn(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
}

/// Whether `p` lies on the segment (ends included).
fn lies_on(p: [i64; 2], [a, b]: [[i64; 2]; 2]) -> bool {
    turn(a, b, p) == 0 && (0..2).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k]))
}

/// Assumption 1 (ii) and (iii), pair by pair: the oracle.
fn is_clean(points: &[[i64; 2]], segments: &[[u32; 2]]) -> bool {
    let place = |s: [u32; 2]| s.map(|end| points[end as usize]);
    for &s in segments {
        if points.iter().any(|&p| !place(s).contains(&p) && lies_on(p, place(s))) {
            return false;
        }
    }
    for (i, &s) in segments.iter().enumerate() {
        for &t in &segments[..i] {
            let ([a, b], [c, d]) = (place(s), place(t));
            if turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0 {
                return false;
            }
        }
    }
    true
}

/// Points of a small grid and segments between them: crossings, touches and overlaps abound.
fn soups() -> impl Strategy<Value = (Vec<[i64; 2]>, Vec<[u32; 2]>)> {
    (3_usize..12, 2_i64..40).prop_flat_map(|(count, size)| {
        let point = [0..size, 0..size];
        let end = 0..count as u32;
        (prop::collection::vec(point, count), prop::collection::vec([end.clone(), end], 0..8))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn a_soup_is_accepted_exactly_if_assumption_1_holds((points, segments) in soups()) {
        let places: Vec<[f64; 2]> = points.iter().map(|p| p.map(|c| c as f64)).collect();
        match domain(&places, &segments) {
            Ok(_) => prop_assert!(is_clean(&points, &segments)),
            Err(Error::Conflicts(_)) => prop_assert!(!is_clean(&points, &segments)),
            Err(_) => {}
        }
    }
}
