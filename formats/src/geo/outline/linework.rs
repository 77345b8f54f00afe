//! The curves that surfaces use, as chains of straight pieces between points of the plane.

use std::collections::BTreeMap;

use super::chain::Chain;
use super::curves::Divider;
use super::places::first_place;
use super::plane::Plane;
use crate::geo::error::Problem;
use crate::geo::evaluate::Options;
use crate::geo::model::{Curve, CurveKind, Model, Surface, unknown};
use crate::geo::sources::{Answer, Sources};

/// What the geometry becomes in its plane: all that is left of it.
#[derive(Debug)]
pub(super) struct Linework {
    pub plane: Plane,
    pub points: Points,
    pub curves: Curves,
    pub surfaces: BTreeMap<i32, Surface>,
}

/// The points that are used: the ends of curves and the embedded points, by ascending tag.
#[derive(Debug)]
pub(super) struct Points {
    pub tags: Vec<i32>,
    /// The line of the script that makes each of them.
    pub lines: Vec<u32>,
    /// Where they lie in the plane.
    pub at: Vec<[f64; 2]>,
    /// The size at each of them.
    pub sizes: Vec<f64>,
}

/// The curves that are used, by ascending tag.
#[derive(Debug)]
pub(super) struct Curves {
    pub tags: Vec<i32>,
    /// The line of the script that makes each of them.
    pub lines: Vec<u32>,
    /// The first and the last point of each, as indices.
    pub ends: Vec<[u32; 2]>,
    /// The chains of those that are more than one straight piece.
    pub chains: BTreeMap<i32, Chain>,
}

impl Linework {
    /// Lays the curves of all surfaces into the plane and divides them.
    pub(super) fn new(mut model: Model, options: &Options, sources: &Sources) -> Answer<Self> {
        // Surfaces have their curves, the grouping its members: of a large script much is freed.
        model.loops.clear();
        model.groups.clear();
        let tags = used_curves(&model)?;
        let plane = plane(&model, &tags, sources)?;
        let mut points = Points::used(&model, &tags, plane);
        let (chains, sizes) = Divider::new(&model, options, &tags, plane, &points)?.divide()?;
        let ends = tags.iter().map(|&tag| model.curves[tag].ends().map(|p| points.index(p)));
        let ends = ends.collect();
        points.sizes = sizes;
        points.lines = points.tags.iter().map(|&p| sources.line(model.points[p].place)).collect();
        let lines = tags.iter().map(|&tag| sources.line(model.curves[tag].place)).collect();
        let curves = Curves { tags, lines, ends, chains };
        Ok(Self { plane, points, curves, surfaces: model.surfaces })
    }

    /// Adds the places of a curve from its first point up to, but without, its last one.
    pub(super) fn add_places(&self, curve: i32, places: &mut Vec<[f64; 2]>) {
        let [first, last] = self.curves.ends(curve).map(|point| self.points.at[point as usize]);
        let inner = self.curves.chains.get(&curve.abs()).map_or(&[][..], |chain| &chain.inner);
        if curve < 0 {
            places.push(last);
            places.extend(inner.iter().rev());
        } else {
            places.push(first);
            places.extend(inner);
        }
    }
}

impl Points {
    /// The points that become vertices, as yet without sizes.
    fn used(model: &Model, curves: &[i32], plane: Plane) -> Self {
        let ends = curves.iter().flat_map(|&tag| model.curves[tag].ends());
        let known = |&tag: &i32| model.points.contains(tag);
        let tags = sorted(ends.chain(embedded_points(model)).filter(known));
        let at = tags.iter().map(|&tag| plane.project(model.points[tag].at)).collect();
        Self { tags, lines: Vec::new(), at, sizes: Vec::new() }
    }

    /// The index of one of these points.
    pub(super) fn index(&self, tag: i32) -> u32 {
        first_place(&self.tags, |&tag| i64::from(tag), i64::from(tag)) as u32
    }
}

impl Curves {
    /// The first and the last point, as indices, of a curve with either sign.
    pub(super) fn ends(&self, tag: i32) -> [u32; 2] {
        let place = first_place(&self.tags, |&tag| i64::from(tag), i64::from(tag.abs()));
        self.ends[place]
    }
}

/// Whether a curve is one straight piece, whatever the sizes.
pub(super) fn is_one_piece(curve: &Curve) -> bool {
    curve.kind == CurveKind::Line && curve.points.len() == 2 && curve.spread.is_none()
}

/// The curves that bound a surface or are embedded in one.
fn used_curves(model: &Model) -> Answer<Vec<i32>> {
    let mut used = Vec::new();
    for surface in model.surfaces.values() {
        for curve in surface.curves().chain(surface.embedded_curves.iter().copied()) {
            if !model.curves.contains(curve.abs()) {
                return Err(unknown("curve", curve).at(surface.place));
            }
            used.push(curve.abs());
        }
    }
    Ok(sorted(used.into_iter()))
}

fn embedded_points(model: &Model) -> impl Iterator<Item = i32> + '_ {
    model.surfaces.values().flat_map(|surface| surface.embedded_points.iter().copied())
}

/// The plane that the used curves and the embedded points lie in.
fn plane(model: &Model, curves: &[i32], sources: &Sources) -> Answer<Plane> {
    let of_curves = curves.iter().flat_map(|&tag| model.curves[tag].points.iter().copied());
    let tags = sorted(of_curves.chain(embedded_points(model)));
    let asked = tags.iter().filter_map(|&tag| {
        let point = model.points.get(tag)?;
        Some((tag, point.place, point.at))
    });
    Plane::of(asked).map_err(|(problem, place, first)| match problem {
        Problem::OffPlane { point, plane, .. } => {
            Problem::OffPlane { point, plane, line: sources.line(first) }.at(place)
        }
        problem => problem.at(place),
    })
}

/// Each tag once, ascending.
fn sorted(tags: impl Iterator<Item = i32>) -> Vec<i32> {
    let mut tags: Vec<i32> = tags.collect();
    tags.sort_unstable();
    tags.dedup();
    tags
}
