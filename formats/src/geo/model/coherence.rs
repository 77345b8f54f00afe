//! Coherence: points in one place become one, then curves and surfaces that are the same.

use std::collections::BTreeMap;

use super::{CurveKind, Model, Points};

/// Points nearer than this part of the model's size are one (`Geometry.Tolerance`).
const TOLERANCE: f64 = 1e-8;

impl Model {
    /// Merges what is the same; of equal things the one with the smallest tag stays.
    ///
    /// Tags for the [changes](Merged) that the caller wants to follow.
    pub(in crate::geo) fn cohere(&mut self) -> Merged {
        let points = self.merge_points();
        let curves = self.merge_curves();
        let surfaces = self.merge_surfaces();
        Merged { points, curves, surfaces }
    }

    fn merge_points(&mut self) -> BTreeMap<i32, i32> {
        let mut replaced = BTreeMap::new();
        let tolerance = TOLERANCE * self.extent();
        let mut grid: BTreeMap<[i64; 3], Vec<i32>> = BTreeMap::new();
        for (tag, point) in self.points.iter() {
            let same = neighbours(point.at, tolerance).find_map(|cell| {
                let near = grid.get(&cell)?;
                near.iter().copied().find(|other| {
                    let other = self.points[*other].at;
                    (0..3).all(|i| (other[i] - point.at[i]).abs() <= tolerance)
                })
            });
            match same {
                Some(first) => {
                    replaced.insert(tag, first);
                }
                None => grid.entry(cell(point.at, tolerance)).or_default().push(tag),
            }
        }
        if replaced.is_empty() {
            return replaced;
        }
        self.points.retain(|tag| !replaced.contains_key(&tag));
        if self.tags.together {
            self.tags.point = self.points.last_tag();
        }
        let renamed = |tag: &mut i32| *tag = replaced.get(tag).copied().unwrap_or(*tag);
        self.curves.values_mut().flat_map(|curve| curve.points.iter_mut()).for_each(renamed);
        self.surfaces.values_mut().flat_map(|s| &mut s.embedded_points).for_each(renamed);
        self.rename_members(0, &replaced);
        replaced
    }

    fn merge_curves(&mut self) -> BTreeMap<i32, i32> {
        let mut replaced = BTreeMap::new();
        let mut known: BTreeMap<(u8, Points), i32> = BTreeMap::new();
        for (tag, curve) in self.curves.iter() {
            let Some(kind) = comparable(&curve.kind) else { continue };
            let key = (kind, curve.points.clone());
            match known.get(&key) {
                Some(&first) => {
                    replaced.insert(tag, first);
                }
                None => {
                    known.insert(key, tag);
                    known.entry((kind, curve.reversed().points)).or_insert(-tag);
                }
            }
        }
        if replaced.is_empty() {
            return replaced;
        }
        self.curves.retain(|tag| !replaced.contains_key(&tag));
        if self.tags.together {
            self.tags.curve = self.curves.last_tag();
        }
        let renamed = |tag: &mut i32| {
            if let Some(&first) = replaced.get(&tag.abs()) {
                *tag = first * tag.signum();
            }
        };
        self.loops.values_mut().flatten().for_each(renamed);
        for surface in self.surfaces.values_mut() {
            surface.loops.iter_mut().flat_map(|(_, curves)| curves).for_each(renamed);
            surface.embedded_curves.iter_mut().for_each(renamed);
        }
        self.rename_members(1, &replaced);
        replaced
    }

    fn merge_surfaces(&mut self) -> BTreeMap<i32, i32> {
        let mut replaced = BTreeMap::new();
        let mut known: BTreeMap<Vec<i32>, i32> = BTreeMap::new();
        for (&tag, surface) in &self.surfaces {
            let mut curves: Vec<i32> = surface.curves().map(i32::abs).collect();
            curves.sort_unstable();
            let first = *known.entry(curves).or_insert(tag);
            if first != tag {
                replaced.insert(tag, first);
            }
        }
        if !replaced.is_empty() {
            self.surfaces.retain(|tag, _| !replaced.contains_key(tag));
            if self.tags.together {
                self.tags.surface = self.surfaces.last_key_value().map_or(0, |(&tag, _)| tag);
            }
            self.rename_members(2, &replaced);
        }
        replaced
    }

    fn rename_members(&mut self, dim: u8, replaced: &BTreeMap<i32, i32>) {
        let groups = self.groups.iter_mut().filter(|((of, _), _)| *of == dim);
        for tag in groups.flat_map(|(_, group)| &mut group.members) {
            *tag = replaced.get(&tag.abs()).copied().unwrap_or(*tag).abs();
        }
    }

    /// The length of the diagonal of the box around all points.
    pub(in crate::geo) fn extent(&self) -> f64 {
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in self.points.values() {
            for i in 0..3 {
                least[i] = least[i].min(point.at[i]);
                most[i] = most[i].max(point.at[i]);
            }
        }
        let [x, y, z] = [0, 1, 2].map(|i| (most[i] - least[i]).max(0.0));
        libm::hypot(libm::hypot(x, y), z)
    }
}

/// What coherence put in place of what.
#[derive(Debug, Default)]
pub(in crate::geo) struct Merged {
    pub points: BTreeMap<i32, i32>,
    /// Negative where the curve that stays runs the other way.
    pub curves: BTreeMap<i32, i32>,
    pub surfaces: BTreeMap<i32, i32>,
}

/// Curves of one kind with the same points are the same; `None` for what is never merged.
fn comparable(kind: &CurveKind) -> Option<u8> {
    Some(match kind {
        CurveKind::Line => 0,
        CurveKind::Circle { .. } => 1,
        CurveKind::Ellipse { .. } => 2,
        CurveKind::Spline => 3,
        CurveKind::BSpline => 4,
        CurveKind::Bezier => 5,
        CurveKind::Arc(_) => return None,
    })
}

/// The cell of a grid twice as wide as the tolerance.
fn cell(at: [f64; 3], tolerance: f64) -> [i64; 3] {
    at.map(|x| if tolerance > 0.0 { (x / (2.0 * tolerance)).floor() as i64 } else { 0 })
}

/// The cells in which a point within the tolerance can lie.
fn neighbours(at: [f64; 3], tolerance: f64) -> impl Iterator<Item = [i64; 3]> {
    let corner = move |signs: u8| {
        let shifted =
            |i: usize| if signs >> i & 1 == 0 { at[i] - tolerance } else { at[i] + tolerance };
        cell([0, 1, 2].map(shifted), tolerance)
    };
    (0..8).map(corner)
}
