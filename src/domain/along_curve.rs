//! The domain's points in the order in which they are triangulated.

use std::mem;
use std::sync::OnceLock;

use super::{Domain, hull};
use crate::hilbert::Curve;
use crate::memory::give_back;
use crate::radix;

impl Domain {
    /// The same domain with its points along a Hilbert curve, so that what is near in the plane is
    /// near in memory; but of many points a few come first, spread along it, and the first three are on
    /// no line. Segments and faces keep their numbers;
    /// [`Domain::input_points`] tells which point each one is.
    #[must_use]
    pub fn along_hilbert_curve(self) -> Self {
        let mut order = coarse_first(along_hilbert_curve(&self.points));
        begin_with_a_triangle(&mut order, &self.points);
        let sorted = self.in_order(&order);
        give_back(order);
        sorted
    }

    /// Gives the memory of the points back where nothing asks for them, or for
    /// [`lfs`](Domain::lfs), any more.
    pub fn forget_points(&mut self) {
        give_back(mem::take(&mut self.points));
    }

    /// The same domain with its points in another order.
    fn in_order(mut self, order: &[u32]) -> Self {
        let mut places = vec![0; order.len()];
        (0..).zip(order).for_each(|(place, &point)| places[point as usize] = place);
        self.segments.iter_mut().flatten().for_each(|end| *end = places[*end as usize]);
        give_back(places);
        let mut adjoining_start = Vec::with_capacity(order.len() + 1);
        let mut adjoining = Vec::with_capacity(self.adjoining.len());
        adjoining_start.push(0);
        for &point in order {
            adjoining.extend_from_slice(self.adjoining(point));
            adjoining_start.push(adjoining.len() as u32);
        }
        give_back(mem::replace(&mut self.adjoining_start, adjoining_start));
        give_back(mem::replace(&mut self.adjoining, adjoining));
        sort(&mut self.points, order);
        sort(&mut self.input_points, order);
        sort(&mut self.point_sizes, order);
        sort(&mut self.meshed_points, order);
        self.features = OnceLock::new();
        self
    }
}

/// Up to so many points simply follow the curve.
const FEW: usize = 10_000;
/// Of more, every so many-th comes first, and of these again.
const STRIDE: usize = 64;

/// How many of so many points come first, spread along the curve; none where all just follow it.
#[must_use]
pub fn coarse_points(count: usize) -> usize {
    if count > FEW { count.div_ceil(STRIDE) } else { 0 }
}

/// Puts points that are spread along the curve before all others. Two rows of points that see each
/// other would else be triangulated anew with each further point: sides of a box, the arms of a
/// cross. Between those that came first a point only sees a few.
fn coarse_first(order: Vec<u32>) -> Vec<u32> {
    let mut strides = vec![1];
    while order.len() / strides[strides.len() - 1] > FEW {
        strides.push(strides[strides.len() - 1] * STRIDE);
    }
    let Some(coarsest) = strides.pop().filter(|&stride| stride > 1) else { return order };
    let mut sorted = Vec::with_capacity(order.len());
    sorted.extend(order.iter().step_by(coarsest));
    for stride in strides.into_iter().rev() {
        let points = order.iter().step_by(stride).enumerate();
        sorted.extend(points.filter(|(i, _)| i % STRIDE != 0).map(|(_, &point)| point));
    }
    give_back(order);
    sorted
}

/// Makes the first point that is on no line with the first two the third.
fn begin_with_a_triangle(order: &mut [u32], points: &[[f64; 2]]) {
    let [first, second, others @ ..] = order else { return };
    let on_a_line = |third: &u32| {
        hull::is_on_a_line(&[*first, *second, *third].map(|point| points[point as usize]))
    };
    if let Some(third) = others.iter().position(|third| !on_a_line(third)) {
        others[..=third].rotate_right(1);
    }
}

/// Puts what there is for each point, if anything, in another order.
fn sort<T: Copy>(of_points: &mut Vec<T>, order: &[u32]) {
    if !of_points.is_empty() {
        let sorted = order.iter().map(|&point| of_points[point as usize]).collect();
        give_back(mem::replace(of_points, sorted));
    }
}

/// The least and the largest coordinates.
pub fn extent(points: impl Iterator<Item = [f64; 2]>) -> ([f64; 2], [f64; 2]) {
    let empty = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    points.fold(empty, |(low, high), point| {
        ([0, 1].map(|i| low[i].min(point[i])), [0, 1].map(|i| high[i].max(point[i])))
    })
}

/// The indices of the points in their order along a Hilbert curve through their bounding square.
/// Scaling by a power of two changes nothing.
fn along_hilbert_curve(points: &[[f64; 2]]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    sort_along_hilbert_curve(points, &mut order);
    order
}

/// So many points may share a cell of the curve; more get a curve of their own, or the walks
/// through a cluster would be long.
const CLUSTER: usize = 64;

fn sort_along_hilbert_curve(points: &[[f64; 2]], indices: &mut [u32]) {
    let (low, high) = extent(indices.iter().map(|&i| points[i as usize]));
    let curve = Curve::new(low, high);
    let placed = indices.iter().map(|&i| (points[i as usize], u64::from(i)));
    let mut placed: Vec<u64> = placed.map(|(p, i)| u64::from(curve.place(p)) << 32 | i).collect();
    radix::sort(&mut placed);
    indices.iter_mut().zip(&placed).for_each(|(i, &placed)| *i = placed as u32);
    let mut rest = indices;
    for cell in placed.chunk_by(|a, b| a >> 32 == b >> 32) {
        let (own, others) = rest.split_at_mut(cell.len());
        if cell.len() > CLUSTER && cell.len() < placed.len() {
            sort_along_hilbert_curve(points, own);
        }
        rest = others;
    }
    give_back(placed);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_few_points_none_comes_before_its_turn() {
        let order: Vec<u32> = (0..FEW as u32).rev().collect();
        assert_eq!(coarse_first(order.clone()), order);
        assert_eq!(coarse_points(order.len()), 0);
    }

    #[test]
    fn the_points_that_come_first_are_spread_along_the_curve_and_none_is_lost() {
        let count = 700_000;
        let sorted = coarse_first((0..count).collect());
        let coarsest = (0..count).step_by(STRIDE * STRIDE);
        assert!(sorted.iter().copied().take(coarsest.len()).eq(coarsest.clone()));
        let is_coarsest = |i: &u32| i.is_multiple_of((STRIDE * STRIDE) as u32);
        let next = (0..count).step_by(STRIDE).filter(|i| !is_coarsest(i));
        let behind = sorted.iter().copied().skip(coarsest.len());
        assert!(behind.take(next.clone().count()).eq(next));
        assert_eq!(coarse_points(sorted.len()), (0..count).step_by(STRIDE).len());
        let mut all = sorted;
        all.sort_unstable();
        assert!(all.into_iter().eq(0..count));
    }
}
