//! The order of a plane sweep: by x, then by y.
//!
//! It holds no judgement, only an order: so the domain and the judge, who share nothing else but
//! [`boxes`](crate::boxes) and [`hilbert`](crate::hilbert), may both sort by it.

use std::cmp::Ordering;

use crate::radix;

/// By x, then by y; −0 equals 0. Coordinates are finite.
pub fn lexicographic([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> Ordering {
    // (`total_cmp` would tell −0 from 0.)
    let order = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    order(ax, bx).then(order(ay, by))
}

/// Those of the points in lexicographic order, equals by their indices: the index in the low half of
/// each number, in the high half the column of the plane in which the point lies. Equals share it.
///
/// Columns are sorted as whole numbers; only within a column is the price of a comparison paid.
/// The indices count up.
pub fn in_columns(points: &[[f64; 2]], indices: impl Iterator<Item = u32> + Clone) -> Vec<u64> {
    let at = |index: u32| points[index as usize];
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for [x, _] in indices.clone().map(at) {
        (low, high) = (low.min(x), high.max(x));
    }
    let columns = f64::from(u32::MAX) / (high - low);
    // Rounded, but never the wrong way round: each step keeps the order.
    let column = |[x, _]: [f64; 2]| u64::from(((x - low) * columns) as u32);
    let mut placed: Vec<u64> = indices.map(|i| column(at(i)) << 32 | u64::from(i)).collect();
    radix::sort(&mut placed);
    for same in placed.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|same| same.len() > 1) {
        let at = |placed: u64| points[placed as u32 as usize];
        same.sort_unstable_by(|&a, &b| lexicographic(at(a), at(b)).then(a.cmp(&b)));
    }
    placed
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        let whole = (-4_i8..5).prop_map(f64::from);
        let close = (0_u64..4).prop_map(|steps| f64::from_bits(1.0_f64.to_bits() + steps));
        prop_oneof![whole, close, Just(-0.0), Just(1e300), Just(-1e-300), -9.0..9.0_f64]
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn the_order_is_that_of_comparisons(
            points in proptest::collection::vec([coordinate(), coordinate()], 0..60),
        ) {
            let all = 0..points.len() as u32;
            let mut expected: Vec<u32> = all.clone().collect();
            expected.sort_by(|&a, &b| lexicographic(points[a as usize], points[b as usize]));
            let found = in_columns(&points, all);
            let indices: Vec<u32> = found.iter().map(|&placed| placed as u32).collect();
            prop_assert_eq!(&indices, &expected);
            for pair in found.windows(2) {
                let [p, q] = [pair[0], pair[1]].map(|placed| points[placed as u32 as usize]);
                prop_assert!(p != q || pair[0] >> 32 == pair[1] >> 32);
            }
        }
    }
}
