//! The numbers of what an operation makes, as Gmsh gives them.
//!
//! A shape that the operation does not change keeps its number, and so does one that becomes a
//! single other one; what goes frees its numbers, with those of its curves and points that nothing
//! else has. Then each face, curve and point without a number gets one more than the largest: face
//! by face, and in each face curve by curve.

use std::collections::BTreeSet;

use super::arrangement::Side;
use super::{Argument, Boolean, Cut, Face};
use crate::geo::error::Problem;
use crate::geo::model::{Curve, CurveKind, Model, Point, Shape};
use crate::geo::syntax::BooleanKind;

pub(super) struct Numbering<'a> {
    model: &'a mut Model,
    how: &'a Boolean<'a>,
    cut: &'a Cut,
    /// The faces that stay.
    chosen: &'a [usize],
    /// The plane z = `height`.
    height: f64,
    /// The size at each vertex.
    sizes: Vec<Option<f64>>,
    /// By face: its number.
    surfaces: Vec<Option<i32>>,
    /// Faces whose surface is the argument itself, as it was.
    kept: BTreeSet<usize>,
    /// Curves that keep their numbers, whatever goes.
    kept_curves: BTreeSet<i32>,
    /// The numbers of pieces and vertices.
    curves: Vec<Option<i32>>,
    points: Vec<Option<i32>>,
}

impl<'a> Numbering<'a> {
    pub(super) fn new(
        model: &'a mut Model,
        how: &'a Boolean,
        cut: &'a Cut,
        chosen: &'a [usize],
        height: f64,
    ) -> Self {
        let size = |point: &Option<i32>| model.points.get((*point)?)?.size;
        let sizes = cut.arrangement.points.iter().map(size).collect();
        Self {
            model,
            how,
            cut,
            chosen,
            height,
            sizes,
            surfaces: vec![None; cut.faces.len()],
            kept: BTreeSet::new(),
            kept_curves: BTreeSet::new(),
            curves: Vec::new(),
            points: Vec::new(),
        }
    }

    /// Numbers everything; the shapes that are made.
    pub(super) fn number(mut self) -> Result<Vec<Shape>, Problem> {
        match self.how.tag {
            Some(tag) => {
                let &[face] = self.chosen else {
                    let statement = "a boolean operation with one number for several surfaces";
                    return Err(Problem::Unsupported { statement: statement.to_owned() });
                };
                for i in 0..self.cut.arguments.len() {
                    self.release(i);
                }
                self.surfaces[face] = Some(tag);
                self.find_what_is_left();
                self.bind_face(face)?;
            }
            None => {
                self.keep();
                self.find_what_is_left();
                for &face in self.chosen {
                    if self.surfaces[face].is_none() {
                        self.surfaces[face] = Some(self.model.tags.surface.saturating_add(1));
                        self.bind_face(face)?;
                    }
                }
            }
        }
        let mut made: Vec<Shape> = Vec::new();
        for &face in self.chosen {
            if let Some(tag) = self.surfaces[face] {
                if !self.kept.contains(&face) && !self.model.surfaces.contains_key(&tag) {
                    self.bind_face(face)?;
                }
                made.push((2, tag));
            }
        }
        for argument in self.cut.arguments.iter().filter(|argument| argument.shape.0 == 1) {
            for &side in self.cut.arrangement.sides(argument.shape.1.abs()) {
                let tag = self.bind_curve(side.piece)?;
                if !made.contains(&(1, tag)) {
                    made.push((1, tag));
                }
            }
        }
        Ok(made)
    }

    /// What stays of each argument keeps its number; the rest goes.
    fn keep(&mut self) {
        let mut order: Vec<usize> = (0..self.cut.arguments.len()).collect();
        order.sort_by_key(|&i| std::cmp::Reverse(self.cut.arguments[i].shape.0));
        for &i in &order {
            if self.is_unchanged(i) {
                let (dim, tag) = self.cut.arguments[i].shape;
                if dim == 1 {
                    self.kept_curves.insert(tag.abs());
                } else if let [face] = self.left_of(i)[..] {
                    self.surfaces[face] = Some(tag);
                    self.kept.insert(face);
                }
            }
        }
        for i in order {
            if self.is_unchanged(i) || !self.cut.arguments[i].goes {
                continue;
            }
            self.release(i);
            if let ((2, tag), [face]) = (self.cut.arguments[i].shape, &self.left_of(i)[..])
                && self.surfaces[*face].is_none()
            {
                self.surfaces[*face] = Some(tag);
            }
        }
    }

    /// The faces of an argument that stay.
    fn left_of(&self, argument: usize) -> Vec<usize> {
        let faces = self.cut.arguments[argument].faces.iter().copied();
        faces.filter(|face| self.chosen.contains(face)).collect()
    }

    /// Whether an argument is in the result as it was.
    fn is_unchanged(&self, argument: usize) -> bool {
        let arrangement = &self.cut.arrangement;
        let (dim, tag) = self.cut.arguments[argument].shape;
        if dim == 1 {
            let is_whole = |side: &Side| arrangement.pieces[side.piece].whole == Some(tag.abs());
            return arrangement.sides(tag.abs()).iter().all(is_whole);
        }
        let [left] = self.left_of(argument)[..] else { return false };
        // A face of several arguments is a new one, unless it is all that is left of them.
        let has = |argument: &&Argument| argument.faces.contains(&left);
        let is_shared = self.cut.arguments.iter().filter(has).count() > 1;
        if is_shared && self.how.kind != BooleanKind::Intersection {
            return false;
        }
        let Ok(surface) = self.model.surface(tag) else { return false };
        let own: BTreeSet<i32> = surface.curves().map(i32::abs).collect();
        let (face, _) = &self.cut.faces[left];
        let whole = |side: &Side| arrangement.pieces[side.piece].whole;
        let is_own = |side: &Side| whole(side).is_some_and(|curve| own.contains(&curve));
        face.inner.is_empty() && face.loops.iter().flatten().all(is_own)
    }

    /// Takes an argument out, if it goes.
    fn release(&mut self, argument: usize) {
        let argument = &self.cut.arguments[argument];
        if !argument.goes {
            return;
        }
        let (dim, tag) = argument.shape;
        if dim == 1 {
            self.release_curve(tag.abs());
        } else if let Some(surface) = self.model.surfaces.remove(&tag) {
            surface.curves().for_each(|curve| self.release_curve(curve.abs()));
        }
    }

    /// Takes a curve out that no surface has, and its points that no other curve has.
    fn release_curve(&mut self, tag: i32) {
        let is_of = |surface: &crate::geo::model::Surface| surface.curves().any(|c| c.abs() == tag);
        let is_of_face = |(face, number): (&(Face, usize), &Option<i32>)| {
            let mut sides = face.0.loops.iter().flatten();
            number.is_some()
                && sides.any(|side| self.cut.arrangement.pieces[side.piece].whole == Some(tag))
        };
        if self.kept_curves.contains(&tag)
            || self.model.surfaces.values().any(is_of)
            || self.cut.faces.iter().zip(&self.surfaces).any(is_of_face)
        {
            return;
        }
        let Some(curve) = self.model.curves.remove(tag) else { return };
        for &point in curve.points.iter() {
            if !self.model.curves.values().any(|curve| curve.points.contains(&point)) {
                self.model.points.remove(point);
            }
        }
    }

    /// Which pieces and vertices still have numbers, and the largest numbers.
    fn find_what_is_left(&mut self) {
        let (arrangement, model) = (&self.cut.arrangement, &mut *self.model);
        let pieces = arrangement.pieces.iter();
        self.curves = pieces.map(|p| p.whole.filter(|&tag| model.curves.contains(tag))).collect();
        let points = arrangement.points.iter().zip(&arrangement.merged);
        let left = |(point, merged): (&Option<i32>, &bool)| {
            point.filter(|&tag| !merged && model.points.contains(tag))
        };
        self.points = points.map(left).collect();
        model.tags.point = model.points.last_tag();
        model.tags.curve = model.curves.last_tag();
        let numbered = self.surfaces.iter().flatten().copied();
        let largest = model.surfaces.last_key_value().map(|(&tag, _)| tag);
        model.tags.surface = numbered.chain(largest).max().unwrap_or(0);
    }

    fn bind_face(&mut self, face: usize) -> Result<(), Problem> {
        let Some(tag) = self.surfaces[face] else { return Ok(()) };
        let (face, _) = &self.cut.faces[face];
        let mut loops = Vec::with_capacity(face.loops.len());
        for sides in &face.loops {
            let mut curves = Vec::with_capacity(sides.len());
            for side in sides {
                let curve = self.bind_curve(side.piece)?;
                curves.push(if side.forward { curve } else { -curve });
            }
            loops.push((0, curves));
        }
        let inner = face.inner.iter().map(|&piece| self.bind_curve(piece));
        let inner = inner.collect::<Result<Vec<i32>, _>>()?;
        self.model.insert_surface(self.how.place, tag, loops)?;
        if let Some(surface) = self.model.surfaces.get_mut(&tag) {
            surface.embedded_curves = inner;
        }
        Ok(())
    }

    /// The number of a piece, perhaps a new one.
    fn bind_curve(&mut self, piece: usize) -> Result<i32, Problem> {
        if let Some(tag) = self.curves[piece] {
            return Ok(tag);
        }
        let tag = self.model.tags.curve.saturating_add(1);
        let piece_of = &self.cut.arrangement.pieces[piece];
        let ends = piece_of.ends;
        let points = vec![self.bind_point(ends[0])?, self.bind_point(ends[1])?];
        let kind: CurveKind = piece_of.track.kind(self.height);
        let curve = Curve { place: self.how.place, kind, points: points.into(), spread: None };
        self.model.add_curve(tag, curve)?;
        if self.how.kind == BooleanKind::Union {
            self.model.unsure_curves.insert(tag);
        }
        self.curves[piece] = Some(tag);
        Ok(tag)
    }

    fn bind_point(&mut self, vertex: usize) -> Result<i32, Problem> {
        if let Some(tag) = self.points[vertex] {
            return Ok(tag);
        }
        let tag = self.model.tags.next_point();
        let [x, y] = self.cut.arrangement.vertices[vertex];
        let (place, at) = (self.how.place, [x, y, self.height]);
        self.model.add_point(tag, Point { place, at, size: self.sizes[vertex] })?;
        self.points[vertex] = Some(tag);
        Ok(tag)
    }
}
