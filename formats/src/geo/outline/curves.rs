//! The division of curves into straight pieces, and the sizes at their ends.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::{Along, Chain, Measured, doubled_area};
use super::linework::{Points, is_one_piece};
use super::path::Path;
use super::plane::Plane;
use super::sizes::Sizes;
use crate::geo::evaluate::Options;
use crate::geo::model::{Model, Surface};
use crate::geo::sources::Answer;

/// Chords may take no more than this part of a surface's area away.
const LOST_AREA: f64 = 0.009;

/// How often curves are made finer for that.
const ROUNDS: usize = 4;

/// Places on a curve for the box around it.
const BOX_SAMPLES: u32 = 32;

/// The diagonal of the box around the points and the curves.
fn diagonal(points: &[[f64; 2]], paths: &BTreeMap<i32, Path>) -> f64 {
    let on_curves = paths
        .values()
        .filter(|path| !path.is_straight())
        .flat_map(|path| (0..=BOX_SAMPLES).map(|i| path.at(f64::from(i) / f64::from(BOX_SAMPLES))));
    let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points.iter().copied().chain(on_curves) {
        for i in 0..2 {
            least[i] = least[i].min(p[i]);
            most[i] = most[i].max(p[i]);
        }
    }
    libm::hypot((most[0] - least[0]).max(0.0), (most[1] - least[1]).max(0.0))
}

/// The paths of the curves that may become more than one straight piece.
fn paths(model: &Model, curves: &[i32], plane: Plane) -> Answer<BTreeMap<i32, Path>> {
    let mut paths = BTreeMap::new();
    for &tag in curves {
        let curve = &model.curves[tag];
        let mut places = Vec::new();
        for &point in curve.points.iter() {
            let point = model.point(point).map_err(|problem| problem.at(curve.place))?;
            places.push(plane.project(point.at));
        }
        if is_one_piece(curve) && places[0] != places[1] {
            continue;
        }
        let path = Path::of(tag, curve, places, |at| plane.project(at));
        paths.insert(tag, path.map_err(|problem| problem.at(curve.place))?);
    }
    Ok(paths)
}

/// Divides curves.
pub(super) struct Divider<'a> {
    model: &'a Model,
    sizes: Sizes<'a>,
    /// The curves that are used.
    curves: &'a [i32],
    points: &'a Points,
    paths: BTreeMap<i32, Path>,
}

impl<'a> Divider<'a> {
    pub(super) fn new(
        model: &'a Model,
        options: &'a Options,
        curves: &'a [i32],
        plane: Plane,
        points: &'a Points,
    ) -> Answer<Self> {
        let paths = paths(model, curves, plane)?;
        let diagonal = diagonal(&points.at, &paths);
        let sizes = Sizes { options, diagonal };
        Ok(Self { model, sizes, curves, points, paths })
    }

    /// The chains of curves that are more than one straight piece, and the size at each point.
    ///
    /// Curves are divided as the sizes ask; then finer where chords would cut too much area off a
    /// surface.
    pub(super) fn divide(self) -> Answer<(BTreeMap<i32, Chain>, Vec<f64>)> {
        // The lengths that the first and the last piece of a curve should have; none of a straight
        // one without points of its own.
        let mut at_ends = BTreeMap::new();
        let mut chains = BTreeMap::new();
        let asked = self.pieces()?;
        let mut pieces = asked.clone();
        for _ in 0..ROUNDS {
            for (&tag, &count) in &pieces {
                let (chain, ends) = self.chain(tag, count, asked[&tag]);
                chains.insert(tag, chain);
                at_ends.extend(ends.map(|ends| (tag, ends)));
            }
            let factors = self.finer(&chains, &pieces);
            pieces.retain(|tag, _| factors.contains_key(tag));
            for (tag, count) in &mut pieces {
                *count = self.multiplied(*tag, *count, factors[tag]);
            }
        }
        let sizes = self.point_sizes(&at_ends);
        Ok((chains, sizes))
    }

    /// How many pieces each curve has by its sizes or its own number of points.
    fn pieces(&self) -> Answer<BTreeMap<i32, u32>> {
        let mut pieces = BTreeMap::new();
        for (&tag, path) in &self.paths {
            let curve = &self.model.curves[tag];
            let count = match &curve.spread {
                Some(spread) => spread.points.max(2) - 1,
                None if path.is_straight() => path.least_pieces(),
                None => Measured::new(path)
                    .pieces(&*self.along(tag))
                    .map_err(|problem| problem.at(curve.place))?,
            };
            let is_closed = curve.ends()[0] == curve.ends()[1];
            pieces.insert(tag, if is_closed { count.max(3) } else { count });
        }
        Ok(pieces)
    }

    /// More pieces; a curve with points of its own keeps them.
    fn multiplied(&self, tag: i32, count: u32, factor: f64) -> u32 {
        let factor = if self.model.curves[tag].spread.is_some() { factor.ceil() } else { factor };
        (f64::from(count) * factor).ceil() as u32
    }

    /// A curve in so many pieces, of which `asked` would do for its sizes, and the sizes at its
    /// ends where those are the curve's own.
    fn chain(&self, tag: i32, count: u32, asked: u32) -> (Chain, Option<[f64; 2]>) {
        let path = &self.paths[&tag];
        match &self.model.curves[tag].spread {
            Some(spread) => {
                let (chain, ends) = Measured::new(path).by_law(spread.in_pieces(count));
                (chain, Some(ends))
            }
            None if path.is_straight() => (self.corners(tag, path), None),
            None => {
                let (chain, ends) = Measured::new(path).by_sizes(count, asked, &*self.along(tag));
                (chain, Some(ends))
            }
        }
    }

    /// The sizes along a curve.
    fn along(&self, tag: i32) -> Box<dyn Along + '_> {
        let curve = &self.model.curves[tag];
        let given = curve.ends().map(|point| self.given(point));
        let turns = self.sizes.options.elements_per_turn;
        let curvature_size = match (&self.paths[&tag], turns > 0.0) {
            (Path::Arc { u, v, .. }, true) => {
                let radius = libm::hypot(u[0], u[1]).min(libm::hypot(v[0], v[1]));
                std::f64::consts::TAU * radius / turns
            }
            _ => f64::INFINITY,
        };
        Box::new(self.sizes.along(given, curvature_size))
    }

    /// The corners between the straight parts of a line.
    fn corners(&self, tag: i32, path: &Path) -> Chain {
        let Path::Straight(points) = path else { return Chain::default() };
        let last = points.len() - 1;
        let along = self.along(tag);
        let sizes = (1..last).map(|i| along.size(i as f64 / last as f64)).collect();
        Chain { inner: points[1..last].to_vec(), sizes }
    }

    /// Curves that must have more pieces, and how many times as many.
    fn finer(
        &self,
        chains: &BTreeMap<i32, Chain>,
        pieces: &BTreeMap<i32, u32>,
    ) -> BTreeMap<i32, f64> {
        let mut lost = BTreeMap::new();
        for &tag in pieces.keys().filter(|tag| !self.paths[*tag].is_straight()) {
            let path = &self.paths[&tag];
            let mut places = vec![path.at(0.0)];
            places.extend(&chains[&tag].inner);
            places.push(path.at(1.0));
            let exact = Measured::new(path).doubled_area();
            lost.insert(tag, 0.5 * (exact - doubled_area(&places)).abs());
        }
        let mut factors = BTreeMap::new();
        for surface in self.model.surfaces.values() {
            let gone: f64 = surface.curves().filter_map(|curve| lost.get(&curve.abs())).sum();
            if gone <= 0.0 {
                continue;
            }
            let allowed = LOST_AREA * self.area(surface);
            if gone <= allowed || allowed <= 0.0 {
                continue;
            }
            // Curves that lose no more than an even share stay as they are.
            let curves: BTreeSet<i32> =
                surface.curves().map(i32::abs).filter(|curve| lost.contains_key(curve)).collect();
            let share = allowed / curves.len() as f64;
            let (few, many): (Vec<i32>, Vec<i32>) =
                curves.into_iter().partition(|curve| lost[curve] <= share);
            let gone_by = |curves: &[i32]| curves.iter().map(|curve| lost[curve]).sum::<f64>();
            // What chords cut off goes with the square of their length.
            let left = (allowed - gone_by(&few)).max(share);
            let factor = (gone_by(&many) / left).sqrt().min(100.0);
            for curve in many {
                let known = factors.entry(curve).or_insert(factor);
                *known = known.max(factor);
            }
        }
        factors
    }

    /// The area of a surface: its largest loop without the others; good enough to compare with.
    fn area(&self, surface: &Surface) -> f64 {
        let areas: Vec<f64> =
            surface.loops.iter().map(|(_, curves)| self.area_in(curves).abs()).collect();
        let (largest, sum) = (areas.iter().copied().fold(0.0, f64::max), areas.iter().sum::<f64>());
        if 2.0 * largest > sum { 2.0 * largest - sum } else { largest }
    }

    /// The area within a loop, by its curves as they turn.
    fn area_in(&self, curves: &[i32]) -> f64 {
        let mut doubled = 0.0;
        for tag in curves {
            let (chord, beside) = match self.paths.get(&tag.abs()) {
                Some(path) => ([path.at(0.0), path.at(1.0)], Measured::new(path).doubled_area()),
                None => (self.model.curves[tag.abs()].ends().map(|point| self.at(point)), 0.0),
            };
            let [a, b] = chord;
            let own = a[0] * b[1] - a[1] * b[0] + beside;
            doubled += if *tag < 0 { -own } else { own };
        }
        0.5 * doubled
    }

    /// The size at each point: the mean of what its curves ask for.
    fn point_sizes(&self, at_ends: &BTreeMap<i32, [f64; 2]>) -> Vec<f64> {
        // Points none of whose neighbours has a size, and points on curves that are yet to be
        // divided: straight ones, by what is given at their ends.
        let mut alone = vec![true; self.points.tags.len()];
        let mut on_straight = vec![false; self.points.tags.len()];
        for &tag in self.curves {
            let ends = self.model.curves[tag].ends();
            let [first, last] = ends.map(|point| self.points.index(point) as usize);
            alone[first] &= self.given(ends[1]).is_none();
            alone[last] &= self.given(ends[0]).is_none();
            if !at_ends.contains_key(&tag) {
                on_straight[first] = true;
                on_straight[last] = true;
            }
        }
        let own = |i: usize| self.sizes.at_point(self.given(self.points.tags[i]), alone[i]);
        let mut sums = vec![0.0; alone.len()];
        let mut counts = vec![0_u32; alone.len()];
        for &tag in self.curves {
            let curve = &self.model.curves[tag];
            let asked = at_ends.get(&tag);
            for (end, point) in curve.ends().into_iter().enumerate() {
                let i = self.points.index(point) as usize;
                if asked.is_none() || curve.spread.is_some() || !on_straight[i] {
                    sums[i] += asked.map_or_else(|| own(i), |sizes| sizes[end]);
                    counts[i] += 1;
                }
            }
        }
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum = if counts[i] == 0 { own(i) } else { *sum / f64::from(counts[i]) };
        }
        sums
    }

    /// The size that the script gives to a point.
    fn given(&self, point: i32) -> Option<f64> {
        self.model.points.get(point)?.size
    }

    /// Where a point lies in the plane.
    fn at(&self, point: i32) -> [f64; 2] {
        self.points.at[self.points.index(point) as usize]
    }
}
