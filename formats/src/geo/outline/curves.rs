//! The curves that surfaces use, as chains of straight pieces.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::{Along, Chain, Measured, doubled_area};
use super::path::Path;
use super::plane::{Asked, Plane};
use super::sizes::Sizes;
use crate::geo::error::Problem;
use crate::geo::evaluate::Options;
use crate::geo::model::{Model, Surface, unknown};
use crate::geo::sources::{Answer, Sources};

/// Chords may take no more than this part of a surface's area away.
const LOST_AREA: f64 = 0.009;

/// How often curves are made finer for that.
const ROUNDS: usize = 4;

/// Places on a curve for the box around it.
const BOX_SAMPLES: u32 = 32;

/// What the geometry becomes in its plane.
pub(super) struct Linework<'a> {
    pub model: &'a Model,
    pub plane: Plane,
    /// The points that are used, in the plane.
    pub points: BTreeMap<i32, [f64; 2]>,
    /// The size at each of them.
    pub sizes: BTreeMap<i32, f64>,
    /// The chains of the curves that are used.
    pub chains: BTreeMap<i32, Chain>,
}

impl<'a> Linework<'a> {
    /// Lays the curves of all surfaces into the plane and divides them.
    pub(super) fn new(model: &'a Model, options: &Options, sources: &Sources) -> Answer<Self> {
        let curves = used_curves(model)?;
        let plane = plane(model, &curves, sources)?;
        let points = used_points(model, &curves, plane);
        let paths = paths(model, &curves, plane)?;
        let diagonal = diagonal(&points, &paths);
        let divided = Divider { model, sizes: Sizes { options, diagonal }, paths }.divide()?;
        let sizes = divided.point_sizes(&points);
        Ok(Self { model, plane, points, sizes, chains: divided.chains })
    }

    /// The places of a curve from its first point up to, but without, its last one.
    pub(super) fn places(&self, curve: i32) -> Vec<[f64; 2]> {
        let Some(known) = self.model.curves.get(&curve.abs()) else { return Vec::new() };
        let [first, last] = known.ends();
        let inner = &self.chains[&curve.abs()].inner;
        if curve < 0 {
            std::iter::once(self.points[&last]).chain(inner.iter().rev().copied()).collect()
        } else {
            std::iter::once(self.points[&first]).chain(inner.iter().copied()).collect()
        }
    }
}

/// The curves that bound a surface or are embedded in one.
fn used_curves(model: &Model) -> Answer<BTreeSet<i32>> {
    let mut used = BTreeSet::new();
    for surface in model.surfaces.values() {
        for curve in surface.curves().chain(surface.embedded_curves.iter().copied()) {
            if !model.curves.contains_key(&curve.abs()) {
                return Err(unknown("curve", curve).at(surface.place));
            }
            used.insert(curve.abs());
        }
    }
    Ok(used)
}

/// The plane that the used curves and the embedded points lie in.
fn plane(model: &Model, curves: &BTreeSet<i32>, sources: &Sources) -> Answer<Plane> {
    let of_curves = curves.iter().flat_map(|tag| model.curves[tag].points.iter().copied());
    let embedded = model.surfaces.values().flat_map(|s| s.embedded_points.iter().copied());
    let tags: BTreeSet<i32> = of_curves.chain(embedded).collect();
    let asked: Vec<Asked> = tags
        .iter()
        .filter_map(|tag| Some((*tag, model.points.get(tag)?)))
        .map(|(tag, point)| (tag, point.place, point.at))
        .collect();
    Plane::of(&asked).map_err(|(problem, place, first)| match problem {
        Problem::OffPlane { point, plane, .. } => {
            Problem::OffPlane { point, plane, line: sources.line(first) }.at(place)
        }
        problem => problem.at(place),
    })
}

/// The points that become vertices: the ends of curves and the embedded points.
fn used_points(model: &Model, curves: &BTreeSet<i32>, plane: Plane) -> BTreeMap<i32, [f64; 2]> {
    let ends = curves.iter().flat_map(|tag| model.curves[tag].ends());
    let embedded = model.surfaces.values().flat_map(|s| s.embedded_points.iter().copied());
    ends.chain(embedded)
        .filter_map(|tag| Some((tag, plane.project(model.points.get(&tag)?.at))))
        .collect()
}

fn paths(model: &Model, curves: &BTreeSet<i32>, plane: Plane) -> Answer<BTreeMap<i32, Path>> {
    let mut paths = BTreeMap::new();
    for &tag in curves {
        let curve = &model.curves[&tag];
        let mut places = Vec::with_capacity(curve.points.len());
        for &point in &curve.points {
            let point = model.point(point).map_err(|problem| problem.at(curve.place))?;
            places.push(plane.project(point.at));
        }
        let path = Path::of(tag, curve, places, |at| plane.project(at));
        paths.insert(tag, path.map_err(|problem| problem.at(curve.place))?);
    }
    Ok(paths)
}

/// The diagonal of the box around the points and the curves.
fn diagonal(points: &BTreeMap<i32, [f64; 2]>, paths: &BTreeMap<i32, Path>) -> f64 {
    let on_curves = paths
        .values()
        .filter(|path| !path.is_straight())
        .flat_map(|path| (0..=BOX_SAMPLES).map(|i| path.at(f64::from(i) / f64::from(BOX_SAMPLES))));
    let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points.values().copied().chain(on_curves) {
        for i in 0..2 {
            least[i] = least[i].min(p[i]);
            most[i] = most[i].max(p[i]);
        }
    }
    libm::hypot((most[0] - least[0]).max(0.0), (most[1] - least[1]).max(0.0))
}

/// Divides curves.
struct Divider<'a> {
    model: &'a Model,
    sizes: Sizes<'a>,
    paths: BTreeMap<i32, Path>,
}

/// Divided curves.
struct Divided<'a> {
    model: &'a Model,
    sizes: Sizes<'a>,
    chains: BTreeMap<i32, Chain>,
    /// The lengths that the first and the last piece of a curve should have; none of a straight one
    /// without points of its own.
    at_ends: BTreeMap<i32, [f64; 2]>,
}

impl<'a> Divider<'a> {
    /// As the sizes ask; then finer where chords would cut too much area off a surface.
    fn divide(self) -> Answer<Divided<'a>> {
        let (mut chains, mut at_ends) = (BTreeMap::new(), BTreeMap::new());
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
        Ok(Divided { model: self.model, sizes: self.sizes, chains, at_ends })
    }

    /// How many pieces each curve has by its sizes or its own number of points.
    fn pieces(&self) -> Answer<BTreeMap<i32, u32>> {
        let mut pieces = BTreeMap::new();
        for (&tag, path) in &self.paths {
            let curve = &self.model.curves[&tag];
            let count = match curve.spread {
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
        let factor = if self.model.curves[&tag].spread.is_some() { factor.ceil() } else { factor };
        (f64::from(count) * factor).ceil() as u32
    }

    /// A curve in so many pieces, of which `asked` would do for its sizes, and the sizes at its
    /// ends where those are the curve's own.
    fn chain(&self, tag: i32, count: u32, asked: u32) -> (Chain, Option<[f64; 2]>) {
        let path = &self.paths[&tag];
        match self.model.curves[&tag].spread {
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
        let curve = &self.model.curves[&tag];
        let given = curve.ends().map(|point| self.model.points.get(&point).and_then(|p| p.size));
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
            let path = &self.paths[&tag.abs()];
            let (a, b) = (path.at(0.0), path.at(1.0));
            let chord = a[0] * b[1] - a[1] * b[0];
            let own = chord + Measured::new(path).doubled_area();
            doubled += if *tag < 0 { -own } else { own };
        }
        0.5 * doubled
    }
}

impl Divided<'_> {
    /// The size at each point: the mean of what its curves ask for.
    fn point_sizes(&self, points: &BTreeMap<i32, [f64; 2]>) -> BTreeMap<i32, f64> {
        let mut asked: BTreeMap<i32, (f64, u32)> = BTreeMap::new();
        let given = |tag: i32| self.model.points.get(&tag).and_then(|point| point.size);
        let mut alone: BTreeSet<i32> = points.keys().copied().collect();
        for &tag in self.chains.keys() {
            let curve = &self.model.curves[&tag];
            let ends = curve.ends();
            for [this, other] in [ends, [ends[1], ends[0]]] {
                if given(other).is_some() {
                    alone.remove(&this);
                }
            }
        }
        let own = |tag: i32| self.sizes.at_point(given(tag), alone.contains(&tag));
        // A straight curve is yet to be divided: by what is given at its ends.
        let is_straight = |tag: &i32| !self.at_ends.contains_key(tag);
        let ends_of = |tag: &i32| self.model.curves[tag].ends();
        let straight: BTreeSet<i32> =
            self.chains.keys().filter(|tag| is_straight(tag)).flat_map(ends_of).collect();
        for tag in self.chains.keys() {
            let counts = |point: &i32| {
                is_straight(tag)
                    || self.model.curves[tag].spread.is_some()
                    || !straight.contains(point)
            };
            for (i, point) in ends_of(tag).into_iter().enumerate() {
                if counts(&point) {
                    let size = self.at_ends.get(tag).map_or_else(|| own(point), |sizes| sizes[i]);
                    let (sum, count) = asked.entry(point).or_default();
                    *sum += size;
                    *count += 1;
                }
            }
        }
        let size = |tag: i32| match asked.get(&tag) {
            Some(&(sum, count)) => sum / f64::from(count),
            None => own(tag),
        };
        points.keys().map(|&tag| (tag, size(tag))).collect()
    }
}
