//! From curves to chains of straight pieces, as short as the sizes ask.

use super::path::{Path, difference};
use crate::geo::error::Problem;
use crate::geo::model::Spread;
use crate::geo::syntax::Law;

/// Samples of each smooth piece of a curve, for its length.
const SAMPLES: usize = 64;

/// The longest chain.
const MOST_PIECES: f64 = 1e7;

/// What a curve becomes: the points between its ends, each with a target size.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Chain {
    pub inner: Vec<[f64; 2]>,
    pub sizes: Vec<f64>,
}

/// Target sizes along a curve by its parameter; see [`super::sizes`].
pub(super) trait Along {
    /// The size at a parameter from 0 to 1.
    fn size(&self, t: f64) -> f64;
}

/// A curve, measured: places at evenly spaced parameters.
#[derive(Debug)]
pub(super) struct Measured<'a> {
    path: &'a Path,
    places: Vec<[f64; 2]>,
}

impl<'a> Measured<'a> {
    pub(super) fn new(path: &'a Path) -> Self {
        let count = SAMPLES * path.pieces().max(1);
        let places = (0..=count).map(|i| path.at(i as f64 / count as f64)).collect();
        Self { path, places }
    }

    /// How many pieces the sizes ask for.
    pub(super) fn pieces(&self, sizes: &dyn Along) -> Result<u32, Problem> {
        let total = self.density(sizes).last().copied().unwrap_or_default();
        if total.is_nan() || total > MOST_PIECES {
            return Err(Problem::Limit {
                what: "a curve has more than 10 million pieces at its size",
            });
        }
        Ok((total + 0.99) as u32).map(|pieces| pieces.max(self.path.least_pieces()))
    }

    /// The chain of so many pieces, spread as the sizes ask, and the sizes at its two ends. All
    /// sizes are what pieces would be as long as if there were `asked` of them.
    pub(super) fn by_sizes(&self, pieces: u32, asked: u32, sizes: &dyn Along) -> (Chain, [f64; 2]) {
        let density = self.density(sizes);
        let total = density.last().copied().unwrap_or_default();
        let parameters =
            (1..pieces).map(|i| self.parameter(&density, total * f64::from(i) / f64::from(pieces)));
        let parameters: Vec<f64> = parameters.collect();
        let inner = parameters.iter().map(|&t| self.path.at(t)).collect();
        let step = |t: f64| sizes.size(t) * (total / f64::from(asked)).min(1.0);
        let chain = Chain { inner, sizes: parameters.iter().map(|&t| step(t)).collect() };
        (chain, [step(0.0), step(1.0)])
    }

    /// The chain through so many points by a law; each one's size is the mean of the pieces
    /// beside it. Also the sizes of the two ends.
    pub(super) fn by_law(&self, spread: Spread) -> (Chain, [f64; 2]) {
        let lengths = self.density(&Unit);
        let total = lengths.last().copied().unwrap_or_default();
        let fractions = fractions(spread);
        let inner: Vec<f64> = fractions[1..fractions.len() - 1].to_vec();
        let inner =
            inner.iter().map(|&s| self.path.at(self.parameter(&lengths, s * total))).collect();
        let steps: Vec<f64> =
            fractions.windows(2).map(|pair| (pair[1] - pair[0]) * total).collect();
        let sizes = steps.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        (Chain { inner, sizes }, [steps[0], steps[steps.len() - 1]])
    }

    /// How many pieces lie before each sample: the integral of 1/size along the curve.
    fn density(&self, sizes: &dyn Along) -> Vec<f64> {
        let count = self.places.len() - 1;
        let mut sum = 0.0;
        let mut density = Vec::with_capacity(count + 1);
        density.push(0.0);
        for (i, pair) in self.places.windows(2).enumerate() {
            let d = difference(pair[1], pair[0]);
            let middle = (i as f64 + 0.5) / count as f64;
            sum += libm::hypot(d[0], d[1]) / sizes.size(middle);
            density.push(sum);
        }
        density
    }

    /// The parameter at which a running sum reaches a value.
    fn parameter(&self, sums: &[f64], value: f64) -> f64 {
        let count = sums.len() - 1;
        let after = sums.partition_point(|&sum| sum < value).clamp(1, count);
        let (low, high) = (sums[after - 1], sums[after]);
        let within = if high > low { ((value - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
        (after as f64 - 1.0 + within) / count as f64
    }

    /// Twice the area between the curve and the chord of its ends, positive to the right.
    ///
    /// Of the samples and of every other one, so that what both lack drops out to second order.
    pub(super) fn doubled_area(&self) -> f64 {
        let every_other: Vec<[f64; 2]> = self.places.iter().copied().step_by(2).collect();
        let fine = doubled_area(&self.places);
        fine + (fine - doubled_area(&every_other)) / 3.0
    }
}

/// The size 1 everywhere: pieces are lengths.
struct Unit;

impl Along for Unit {
    fn size(&self, _: f64) -> f64 {
        1.0
    }
}

/// Twice the area that a chain encloses with the chord of its ends.
pub(super) fn doubled_area(places: &[[f64; 2]]) -> f64 {
    let Some(&origin) = places.first() else { return 0.0 };
    let cross = |pair: &[[f64; 2]]| {
        let (a, b) = (difference(pair[0], origin), difference(pair[1], origin));
        a[0] * b[1] - a[1] * b[0]
    };
    places.windows(2).map(cross).sum()
}

/// Where the points of a spread lie, as fractions of the length.
fn fractions(spread: Spread) -> Vec<f64> {
    let pieces = spread.points.max(2) - 1;
    let even = |i: u32| f64::from(i) / f64::from(pieces);
    let mut found: Vec<f64> = match spread.law {
        None => (0..=pieces).map(even).collect(),
        // Steps grow by the factor r: (rⁱ − 1)/(rⁿ − 1), also where rⁿ is no double.
        Some((Law::Progression, r)) => {
            let log = libm::log(r);
            let whole = libm::expm1(log * f64::from(pieces));
            let at = |i: u32| libm::expm1(log * f64::from(i)) / whole;
            (0..=pieces).map(|i| if at(i).is_finite() { at(i) } else { even(i) }).collect()
        }
        Some((Law::Bump, coefficient)) => {
            (0..=pieces).map(|i| bump(even(i), coefficient)).collect()
        }
    };
    found[0] = 0.0;
    found[pieces as usize] = 1.0;
    let is_sorted = found.windows(2).all(|pair| pair[0] < pair[1]);
    if is_sorted { found } else { (0..=pieces).map(even).collect() }
}

/// Where a fraction of the points lies if their density at x from −½ to ½ goes as
/// 1/|x² + 1/(4(c − 1))|: towards the ends for c < 1, towards the middle for c > 1.
fn bump(fraction: f64, c: f64) -> f64 {
    let y = 2.0 * fraction - 1.0;
    if (c - 1.0).abs() < 1e-9 {
        return fraction;
    }
    let root = (c - 1.0).abs().sqrt();
    let x = if c > 1.0 {
        libm::tan(y * libm::atan(root)) / root
    } else {
        libm::tanh(y * libm::atanh(root.min(1.0 - 1e-12))) / root
    };
    0.5 + 0.5 * x
}
