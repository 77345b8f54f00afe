//! `BooleanDifference` of OpenCASCADE, where the tools lie inside the object: they become holes.
//!
//! Whether they do lie inside is seen when curves have become polygons.

use super::{Curve, Model, Surface};
use crate::geo::error::Problem;
use crate::geo::syntax::Place;

/// A surface less others.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Difference<'a> {
    pub place: Place,
    /// The number that the script gives to the result.
    pub tag: Option<i32>,
    pub object: i32,
    /// Whether the object goes.
    pub delete_object: bool,
    pub tools: &'a [i32],
    /// Whether the tools go.
    pub delete_tools: bool,
}

impl Model {
    /// Makes the difference; its tag.
    ///
    /// Curves of tools keep their numbers. Those of an object that goes get new ones, of which
    /// Gmsh gives only a single one in an order that is known here: the others are
    /// [unsure](Model::unsure_curves).
    pub(super) fn subtract(&mut self, how: &Difference) -> Result<i32, Problem> {
        let object = self.surface(how.object)?.clone();
        let mut loops = object.loops.clone();
        let mut tools = object.tools.clone();
        for &tool in how.tools {
            tools.push(loops.len());
            loops.extend(self.surface(tool)?.loops.clone());
        }
        if how.delete_tools {
            how.tools.iter().for_each(|tool| {
                self.surfaces.remove(tool);
            });
        }
        if how.delete_object {
            self.surfaces.remove(&how.object);
            for (_, curves) in &mut loops[..object.loops.len()] {
                self.renumber(curves, &object)?;
            }
        }
        self.tags.surface = self.surfaces.last_key_value().map_or(0, |(&tag, _)| tag);
        let kept = how.delete_object.then_some(how.object);
        let tag = how.tag.or(kept).unwrap_or_else(|| self.tags.surface.saturating_add(1));
        self.insert_surface(how.place, tag, loops)?;
        if let Some(surface) = self.surfaces.get_mut(&tag) {
            surface.tools = tools;
        }
        Ok(tag)
    }

    /// Gives new numbers to curves that only the object had.
    fn renumber(&mut self, curves: &mut [i32], object: &Surface) -> Result<(), Problem> {
        let is_used = |tag: i32, surface: &Surface| surface.curves().any(|c| c.abs() == tag.abs());
        let mut freed: Vec<(usize, Curve)> = Vec::new();
        for (i, curve) in curves.iter().enumerate() {
            if !self.surfaces.values().any(|surface| is_used(*curve, surface)) {
                freed.extend(self.curves.remove(curve.abs()).map(|known| (i, known)));
            }
        }
        self.tags.curve = self.curves.last_tag();
        let is_known = object.curves().count() == 1;
        for (i, curve) in freed {
            let tag = self.tags.curve.saturating_add(1);
            self.add_curve(tag, curve)?;
            curves[i] = tag * curves[i].signum();
            if !is_known {
                self.unsure_curves.insert(tag);
            }
        }
        Ok(())
    }

    /// A curve whose number the script gives.
    pub(in crate::geo) fn is_sure(&self, curve: i32) -> Result<(), Problem> {
        if self.unsure_curves.contains(&curve.abs()) {
            return Err(Problem::Unsure { curve: curve.abs() });
        }
        Ok(())
    }
}
