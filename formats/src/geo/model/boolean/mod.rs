//! Boolean operations of OpenCASCADE on plane surfaces and curves.
//!
//! All curves are cut where they meet ([`arrangement`]); the pieces divide each surface into faces
//! ([`faces`]); the operation says which faces stay. What stays is numbered as Gmsh numbers it,
//! because scripts name the numbers.

mod arrangement;
mod faces;
mod numbering;
mod track;
mod union;

use std::collections::BTreeMap;

use super::{Model, Shape};
use crate::geo::error::Problem;
use crate::geo::syntax::{BooleanKind, Place};
use arrangement::{Arrangement, Side};
use faces::{Face, divide, doubled_area, holds};
use numbering::Numbering;

/// Vertices nearer than this part of the model's size are one.
const TOLERANCE: f64 = 1e-8;

/// A boolean operation.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::geo) struct Boolean<'a> {
    pub place: Place,
    pub kind: BooleanKind,
    /// The number that the script gives to the result.
    pub tag: Option<i32>,
    pub objects: &'a [Shape],
    /// Whether the objects go.
    pub delete_objects: bool,
    pub tools: &'a [Shape],
    /// Whether the tools go.
    pub delete_tools: bool,
}

/// A shape that an operation is made of, and what the pieces of all divide it into.
struct Argument {
    shape: Shape,
    /// Whether it goes.
    goes: bool,
    /// Its faces, as indices into [`Cut::faces`]; of a curve none.
    faces: Vec<usize>,
}

/// The arguments of an operation, cut.
struct Cut {
    arrangement: Arrangement,
    arguments: Vec<Argument>,
    /// Each face once, with the argument whose face it is (the first of several).
    faces: Vec<(Face, usize)>,
    /// How many of the arguments are objects.
    objects: usize,
}

impl Model {
    /// Does a boolean operation; the shapes that it makes.
    pub(in crate::geo) fn combine(&mut self, how: &Boolean) -> Result<Vec<Shape>, Problem> {
        let curves_may_be_cut = how.kind == BooleanKind::Fragments;
        let shapes = || how.objects.iter().chain(how.tools);
        let is_known = |&&(dim, _): &&Shape| dim == 2 || (dim == 1 && curves_may_be_cut);
        if how.objects.is_empty() || shapes().any(|shape| !is_known(&shape)) {
            return Err(unsupported(how.kind, "anything but surfaces"));
        }
        let curves = self.curves_of(shapes())?;
        let height = self.height(how.kind, &curves)?;
        let arrangement = Arrangement::new(self, &curves, TOLERANCE * self.extent());
        // Tools of any curves that only lie inside an object need no cuts.
        if let (Err(_), BooleanKind::Difference, &[(_, object)]) =
            (&arrangement, how.kind, how.objects)
        {
            let tools: Vec<i32> = how.tools.iter().map(|&(_, tool)| tool).collect();
            let made = self.subtract(&super::Difference {
                place: how.place,
                tag: how.tag,
                object,
                delete_object: how.delete_objects,
                tools: &tools,
                delete_tools: how.delete_tools,
            })?;
            return Ok(vec![(2, made)]);
        }
        let mut cut = Cut::new(self, how, arrangement?)?;
        let mut chosen = cut.chosen(how.kind);
        if how.kind == BooleanKind::Union {
            chosen = cut.unite(&chosen);
        }
        Numbering::new(self, how, &cut, &chosen, height).number()
    }

    /// The curves of shapes, each once, in the order of the shapes.
    fn curves_of<'s>(&self, shapes: impl Iterator<Item = &'s Shape>) -> Result<Vec<i32>, Problem> {
        let mut curves: Vec<i32> = Vec::new();
        for &(dim, tag) in shapes {
            match dim {
                2 => curves.extend(self.surface(tag)?.curves().map(i32::abs)),
                _ => {
                    self.curve(tag)?;
                    curves.push(tag.abs());
                }
            }
        }
        let mut known = std::collections::BTreeSet::new();
        curves.retain(|&curve| known.insert(curve));
        Ok(curves)
    }

    /// The plane z = c that the curves lie in.
    fn height(&self, kind: BooleanKind, curves: &[i32]) -> Result<f64, Problem> {
        let mut heights = Vec::new();
        for &curve in curves {
            for &point in self.curve(curve)?.points.iter() {
                heights.push(self.point(point)?.at[2]);
            }
        }
        let first = heights.first().copied().unwrap_or_default();
        let tolerance = TOLERANCE * self.extent();
        match heights.iter().all(|height| (height - first).abs() <= tolerance) {
            true => Ok(first),
            false => Err(unsupported(kind, "shapes that lie in no plane z = c")),
        }
    }
}

impl Cut {
    fn new(model: &Model, how: &Boolean, arrangement: Arrangement) -> Result<Self, Problem> {
        let mut cut = Self {
            arrangement,
            arguments: Vec::new(),
            faces: Vec::new(),
            objects: how.objects.len(),
        };
        let mut known: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
        let objects = how.objects.iter().map(|&shape| (shape, how.delete_objects));
        for (shape, goes) in objects.chain(how.tools.iter().map(|&shape| (shape, how.delete_tools)))
        {
            let mut argument = Argument { shape, goes, faces: Vec::new() };
            if shape.0 == 2 {
                for face in cut.divided(model, how.kind, shape.1)? {
                    let index = *known.entry(face.key()).or_insert(cut.faces.len());
                    if index == cut.faces.len() {
                        cut.faces.push((face, cut.arguments.len()));
                    }
                    argument.faces.push(index);
                }
            }
            cut.arguments.push(argument);
        }
        Ok(cut)
    }

    /// The faces of a surface.
    fn divided(&self, model: &Model, kind: BooleanKind, tag: i32) -> Result<Vec<Face>, Problem> {
        let arrangement = &self.arrangement;
        let mut loops = Vec::new();
        for (_, curves) in &model.surface(tag)?.loops {
            let sides = oriented(arrangement, curves);
            loops.push(sides.ok_or_else(|| unsupported(kind, "a surface that is open"))?);
        }
        if loops.is_empty() {
            return Err(Problem::Empty { surface: tag });
        }
        let area = |sides: &Vec<Side>| doubled_area(arrangement, sides);
        let largest = loops.iter().map(area).max_by(|a, b| a.abs().total_cmp(&b.abs()));
        let largest = largest.unwrap_or_default();
        for sides in &mut loops {
            let area = doubled_area(arrangement, sides);
            if area != largest && (area < 0.0) == (largest < 0.0) {
                *sides = sides.iter().map(|side| side.reversed()).collect();
            }
        }
        let outer = loops.iter().position(|sides| doubled_area(arrangement, sides) == largest);
        if let Some(outer) = outer {
            loops[..=outer].rotate_right(1);
        }
        let boundary: Vec<Side> = loops.concat();
        let is_inner = |&piece: &usize| {
            let is_on = boundary.iter().any(|side| side.piece == piece);
            !is_on && holds(arrangement, &loops, arrangement.pieces[piece].track.at(0.5))
        };
        let inner: Vec<usize> = (0..arrangement.pieces.len()).filter(is_inner).collect();
        Ok(divide(arrangement, loops, &inner, largest < 0.0))
    }

    /// The faces that stay.
    fn chosen(&self, kind: BooleanKind) -> Vec<usize> {
        let (objects, tools) = self.arguments.split_at(self.objects);
        let of = |arguments: &[Argument], face: usize| {
            arguments.iter().any(|argument| argument.faces.contains(&face))
        };
        let stays = |&face: &usize| match kind {
            BooleanKind::Union | BooleanKind::Fragments => true,
            BooleanKind::Intersection => of(objects, face) && of(tools, face),
            BooleanKind::Difference => of(objects, face) && !of(tools, face),
        };
        (0..self.faces.len()).filter(stays).collect()
    }
}

/// The sides of a loop, each curve run along from where the one before it ends; `None` if they do
/// not close.
fn oriented(arrangement: &Arrangement, curves: &[i32]) -> Option<Vec<Side>> {
    let sides_of = |&curve: &i32| {
        let sides = arrangement.sides(curve.abs()).iter().copied();
        let sides: Vec<Side> =
            if curve < 0 { sides.map(Side::reversed).collect() } else { sides.collect() };
        sides
    };
    let mut all: Vec<Vec<Side>> = curves.iter().map(sides_of).collect();
    let is_closed = |all: &[Vec<Side>]| {
        let mut balance = vec![0_i32; arrangement.vertices.len()];
        for &side in all.iter().flatten() {
            let [from, to] = arrangement.ends(side);
            balance[from] -= 1;
            balance[to] += 1;
        }
        balance.iter().all(|&count| count == 0)
    };
    if !is_closed(&all) {
        // Signs that are wrong: one after the other, turned to begin where the last one ends.
        let ends = |sides: &[Side]| {
            let mut balance: BTreeMap<usize, i32> = BTreeMap::new();
            for &side in sides {
                let [from, to] = arrangement.ends(side);
                *balance.entry(from).or_default() -= 1;
                *balance.entry(to).or_default() += 1;
            }
            let find =
                |sign: i32| balance.iter().find(|(_, count)| **count == sign).map(|(v, _)| *v);
            Some([find(-1)?, find(1)?])
        };
        let begin = ends(all.first()?)?;
        let (mut here, mut left) = (begin[1], (1..all.len()).collect::<Vec<_>>());
        while !left.is_empty() {
            let fits = |&i: &usize| ends(&all[i]).is_some_and(|ends| ends.contains(&here));
            let next = left.remove(left.iter().position(fits)?);
            let [from, to] = ends(&all[next])?;
            if from == here {
                here = to;
            } else {
                all[next] = all[next].iter().map(|side| side.reversed()).collect();
                here = from;
            }
        }
    }
    is_closed(&all).then(|| all.concat())
}

/// An operation on what it does not take.
fn unsupported(kind: BooleanKind, of: &str) -> Problem {
    Problem::Unsupported { statement: format!("Boolean{kind:?} of {of}") }
}
