//! Questions: what bounds what, what lies in a box.

use std::collections::BTreeMap;

use super::{Model, Shape};
use crate::geo::error::Problem;

impl Model {
    /// The tags of all shapes of a dimension.
    pub(in crate::geo) fn all(&self, dim: u8) -> Vec<i32> {
        match dim {
            0 => self.points.tags().collect(),
            1 => self.curves.tags().collect(),
            2 => self.surfaces.keys().copied().collect(),
            _ => Vec::new(),
        }
    }

    /// What bounds shapes: curves bound surfaces, points bound curves. `combined`: without what
    /// two of them share.
    pub(in crate::geo) fn boundary(
        &self,
        shapes: &[Shape],
        combined: bool,
    ) -> Result<Vec<Shape>, Problem> {
        let mut found: Vec<Shape> = Vec::new();
        for &(dim, tag) in shapes {
            match dim {
                0 => {}
                1 => {
                    let ends = self.curve(tag)?.signed(tag).ends();
                    found.extend(ends.map(|point| (0, point)));
                }
                _ => found.extend(self.surface(tag)?.curves().map(|curve| (1, curve))),
            }
        }
        if combined {
            let mut times: BTreeMap<Shape, u32> = BTreeMap::new();
            for &(dim, tag) in &found {
                *times.entry((dim, tag.abs())).or_default() += 1;
            }
            found.retain(|&(dim, tag)| times[&(dim, tag.abs())] == 1);
            found.sort_by_key(|&(dim, tag)| (dim, tag.abs()));
        }
        Ok(found)
    }

    /// The points of the boundary of shapes, each once.
    pub(in crate::geo) fn points_of(&self, shapes: &[Shape]) -> Result<Vec<Shape>, Problem> {
        let mut points = Vec::new();
        for &(dim, tag) in shapes {
            match dim {
                0 => points.push(tag),
                1 => points.extend(self.curve(tag)?.ends()),
                _ => {
                    for curve in self.surface(tag)?.curves() {
                        points.extend(self.curve(curve)?.ends());
                    }
                }
            }
        }
        points.sort_unstable();
        points.dedup();
        Ok(points.into_iter().map(|point| (0, point)).collect())
    }

    /// The shapes of a dimension that lie in a box, by their points.
    pub(in crate::geo) fn in_box(&self, dim: u8, least: [f64; 3], most: [f64; 3]) -> Vec<i32> {
        let is_in = |&point: &i32| {
            let at = self.points.get(point).map(|point| point.at);
            at.is_some_and(|at| (0..3).all(|i| least[i] <= at[i] && at[i] <= most[i]))
        };
        let curve_is_in = |curve: &i32| {
            self.curves.get(curve.abs()).is_some_and(|curve| curve.points.iter().all(is_in))
        };
        match dim {
            0 => self.points.tags().filter(is_in).collect(),
            1 => self.curves.tags().filter(curve_is_in).collect(),
            2 => {
                let surfaces = self.surfaces.iter();
                let inside = surfaces.filter(|(_, s)| s.curves().all(|curve| curve_is_in(&curve)));
                inside.map(|(&tag, _)| tag).collect()
            }
            _ => Vec::new(),
        }
    }
}
