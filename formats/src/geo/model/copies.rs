//! Copies of shapes (`Duplicata`), and shapes taken away (`Delete`).
//!
//! The numbers of copies are those that Gmsh gives: scripts name them.

use super::{Curve, Model, Shape, Surface};
use crate::geo::error::Problem;
use crate::geo::syntax::Place;

impl Model {
    /// Copies shapes with everything that defines them; the copies, in the same order.
    pub(in crate::geo) fn duplicate(
        &mut self,
        place: Place,
        shapes: &[Shape],
    ) -> Result<Vec<Shape>, Problem> {
        let mut copies = Vec::with_capacity(shapes.len());
        for &(dim, tag) in shapes {
            copies.push(match dim {
                0 => (0, self.duplicate_point(place, tag)?),
                1 => (1, self.duplicate_curve(place, tag)?),
                _ => (2, self.duplicate_surface(place, tag)?),
            });
        }
        Ok(copies)
    }

    pub(super) fn duplicate_point(&mut self, place: Place, tag: i32) -> Result<i32, Problem> {
        let point = super::Point { place, ..self.point(tag)?.clone() };
        let copy = self.tags.next_point();
        self.add_point(copy, point)?;
        Ok(copy)
    }

    /// Copies a curve; a reversed one gives a copy that runs the other way.
    pub(super) fn duplicate_curve(&mut self, place: Place, tag: i32) -> Result<i32, Problem> {
        let source = self.curve(tag)?.signed(tag);
        let copy = self.next_shape_curve();
        self.tags.use_curve(copy);
        let ends = source.ends();
        let points: Vec<i32> = if self.is_occ && ends[0] == ends[1] && source.points.len() == 2 {
            let point = self.duplicate_point(place, ends[0])?;
            vec![point, point]
        } else {
            let copies = source.points.iter().map(|&point| self.duplicate_point(place, point));
            copies.collect::<Result<_, _>>()?
        };
        if !self.is_occ {
            // Gmsh copies both ends once more; coherence takes them away, but they count.
            for end in ends {
                self.duplicate_point(place, end)?;
            }
        }
        self.add_curve(copy, Curve { place, points: points.into(), spread: None, ..source })?;
        Ok(copy)
    }

    fn duplicate_surface(&mut self, place: Place, tag: i32) -> Result<i32, Problem> {
        let source: Surface = self.surface(tag)?.clone();
        let copy = if self.is_occ {
            self.tags.surface.saturating_add(1)
        } else {
            self.tags.next_surface()
        };
        self.tags.use_surface(copy);
        let mut loops = Vec::with_capacity(source.loops.len());
        for (_, curves) in source.loops {
            let copies = curves.iter().map(|&curve| self.duplicate_curve(place, curve));
            loops.push((0, copies.collect::<Result<Vec<_>, _>>()?));
        }
        self.insert_surface(place, copy, loops)?;
        Ok(copy)
    }

    /// The number of the next curve that an operation makes.
    pub(super) fn next_shape_curve(&self) -> i32 {
        if self.is_occ { self.tags.curve.saturating_add(1) } else { self.tags.next_curve() }
    }

    /// Takes shapes away, but for those that others are made of. With `recursive` what defined
    /// them goes too.
    pub(in crate::geo) fn delete(&mut self, shapes: &[Shape], recursive: bool) {
        for &(dim, tag) in shapes {
            let tag = tag.abs();
            match dim {
                0 => self.delete_point(tag),
                1 => self.delete_curve(tag, recursive),
                _ => self.delete_surface(tag, recursive),
            }
        }
    }

    fn delete_point(&mut self, tag: i32) {
        if self.curves.values().any(|curve| curve.points.contains(&tag)) {
            return;
        }
        if self.points.remove(tag).is_some() && tag == self.tags.point {
            self.tags.point -= 1;
        }
    }

    fn delete_curve(&mut self, tag: i32, recursive: bool) {
        let is_on = |surface: &Surface| surface.curves().any(|curve| curve.abs() == tag);
        if self.surfaces.values().any(is_on) {
            return;
        }
        let Some(curve) = self.curves.remove(tag) else { return };
        if tag == self.tags.curve {
            self.tags.curve -= 1;
        }
        if recursive {
            curve.points.iter().for_each(|&point| self.delete_point(point));
        }
    }

    fn delete_surface(&mut self, tag: i32, recursive: bool) {
        let Some(surface) = self.surfaces.remove(&tag) else { return };
        if tag == self.tags.surface {
            self.tags.surface -= 1;
        }
        if recursive {
            surface.curves().for_each(|curve| self.delete_curve(curve.abs(), true));
        }
    }
}
