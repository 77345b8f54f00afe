//! The geometry that a script makes: points, curves, surfaces and groups, by their tags.
//!
//! Everything stands in space as the script says; whether it is plane is asked at the end.

mod boolean;
mod coherence;
mod copies;
mod curve;
mod difference;
mod extrude;
mod motion;
mod queries;
mod shapes;
mod table;
mod tags;

use std::collections::{BTreeMap, BTreeSet};

use super::error::Problem;
use super::syntax::{Law, Place};

pub(super) use boolean::Boolean;
pub(super) use curve::{Arc, Curve, CurveKind, Points, RADIUS_TOLERANCE};
use difference::Difference;
pub(super) use extrude::{Extrusion, Sweep};
pub(super) use motion::Motion;
pub(super) use table::Table;
pub(super) use tags::Tags;

/// A point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point {
    pub place: Place,
    pub at: [f64; 3],
    /// The target size there; `None` where the script gives none.
    pub size: Option<f64>,
}

/// How many points a curve is given, and how they are spread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spread {
    /// The number of points, ends included; at least 2.
    pub points: u32,
    /// A law and its coefficient; evenly without one.
    pub law: Option<(Law, f64)>,
}

impl Spread {
    /// The same points and as many in between as make so many pieces, a multiple of those here.
    pub(super) fn in_pieces(self, pieces: u32) -> Self {
        let parts = f64::from(pieces) / f64::from(self.points.max(2) - 1);
        let law = self.law.map(|(law, coefficient)| match law {
            Law::Progression => (law, libm::pow(coefficient, 1.0 / parts)),
            Law::Bump => (law, coefficient),
        });
        Self { points: pieces + 1, law }
    }
}

/// A surface: what lies between its curves.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Surface {
    pub place: Place,
    /// Its loops, each with its tag (0 if it has none) and its curves, negative where reversed.
    pub loops: Vec<(i32, Vec<i32>)>,
    /// Where among the loops those of each tool begin that was cut out of it.
    pub tools: Vec<usize>,
    /// Curves that its mesh must keep.
    pub embedded_curves: Vec<i32>,
    /// Points that its mesh must keep.
    pub embedded_points: Vec<i32>,
}

impl Surface {
    /// The tool that a loop belongs to, counted from 1; 0 for a loop of its own.
    pub(super) fn tool_of(&self, of_loop: usize) -> usize {
        self.tools.partition_point(|&begin| begin <= of_loop)
    }

    /// The curves of all loops, negative where reversed.
    pub(super) fn curves(&self) -> impl Iterator<Item = i32> + '_ {
        self.loops.iter().flat_map(|(_, curves)| curves.iter().copied())
    }
}

/// A physical group.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PhysicalGroup {
    pub place: Place,
    pub name: Option<String>,
    /// Tags of points, curves or surfaces.
    pub members: Vec<i32>,
}

/// The geometry so far.
#[derive(Debug, Default)]
pub(super) struct Model {
    pub points: Table<Point>,
    pub curves: Table<Curve>,
    /// Curve loops: their curves, negative where reversed.
    pub loops: BTreeMap<i32, Vec<i32>>,
    pub surfaces: BTreeMap<i32, Surface>,
    /// By dimension and tag.
    pub groups: BTreeMap<(u8, i32), PhysicalGroup>,
    pub tags: Tags,
    /// Whether the script has asked for the OpenCASCADE kernel.
    pub is_occ: bool,
    /// Curves that have other numbers in Gmsh, after boolean operations.
    pub unsure_curves: BTreeSet<i32>,
}

/// What a shape is: its dimension and its tag, negative where a curve is reversed.
pub(super) type Shape = (u8, i32);

impl Model {
    /// Makes a point; its tag must be free.
    pub(super) fn add_point(&mut self, tag: i32, point: Point) -> Result<(), Problem> {
        self.tags.use_point(tag);
        match self.points.insert(tag, point) {
            None => Ok(()),
            Some(_) => Err(exhausted()),
        }
    }

    /// Makes a curve between points that are there; its tag must be free.
    pub(super) fn add_curve(&mut self, tag: i32, curve: Curve) -> Result<(), Problem> {
        if let Some(&missing) = curve.points.iter().find(|&&point| !self.points.contains(point)) {
            return Err(unknown("point", missing));
        }
        self.tags.use_curve(tag);
        match self.curves.insert(tag, curve) {
            None => Ok(()),
            Some(_) => Err(exhausted()),
        }
    }

    /// Makes a curve loop of curves that are there.
    pub(super) fn add_loop(&mut self, tag: i32, curves: Vec<i32>) -> Result<(), Problem> {
        if let Some(&missing) = curves.iter().find(|&curve| !self.curves.contains(curve.abs())) {
            return Err(unknown("curve", missing));
        }
        let curves = self.in_order(curves);
        self.tags.use_loop(tag);
        // Gmsh keeps the first one, and says so; scripts that make a loop twice make it the same.
        self.loops.entry(tag).or_insert(curves);
        Ok(())
    }

    /// The curves of a loop, each after the one that ends where it begins; as Gmsh sorts them,
    /// which the numbers of copies depend on. What does not fit keeps its place.
    fn in_order(&self, curves: Vec<i32>) -> Vec<i32> {
        let ends: Vec<[i32; 2]> = curves
            .iter()
            .map(|&tag| {
                let [first, last] = self.curves[tag.abs()].ends();
                if tag < 0 { [last, first] } else { [first, last] }
            })
            .collect();
        if ends.windows(2).all(|pair| pair[0][1] == pair[1][0]) {
            return curves;
        }
        let mut beginning: BTreeMap<i32, BTreeSet<usize>> = BTreeMap::new();
        for (i, [first, _]) in ends.iter().enumerate() {
            beginning.entry(*first).or_default().insert(i);
        }
        let mut left: BTreeSet<usize> = (0..curves.len()).collect();
        let mut sorted = Vec::with_capacity(curves.len());
        let mut next = left.first().copied();
        while let Some(i) = next.or_else(|| left.first().copied()) {
            left.remove(&i);
            sorted.push(curves[i]);
            let [first, last] = ends[i];
            if let Some(others) = beginning.get_mut(&first) {
                others.remove(&i);
            }
            next = beginning.get(&last).and_then(BTreeSet::first).copied();
        }
        sorted
    }

    /// Makes a surface of loops that are there; its tag must be free.
    pub(super) fn add_surface(
        &mut self,
        place: Place,
        tag: i32,
        loops: &[i32],
    ) -> Result<(), Problem> {
        let loop_of = |&tag: &i32| match self.loops.get(&tag.abs()) {
            Some(curves) => Ok((tag.abs(), curves.clone())),
            None => Err(unknown("curve loop", tag)),
        };
        let loops = loops.iter().map(loop_of).collect::<Result<Vec<_>, _>>()?;
        self.insert_surface(place, tag, loops)
    }

    pub(super) fn insert_surface(
        &mut self,
        place: Place,
        tag: i32,
        loops: Vec<(i32, Vec<i32>)>,
    ) -> Result<(), Problem> {
        self.tags.use_surface(tag);
        let (tools, embedded_curves, embedded_points) = (Vec::new(), Vec::new(), Vec::new());
        let surface = Surface { place, loops, tools, embedded_curves, embedded_points };
        match self.surfaces.insert(tag, surface) {
            None => Ok(()),
            Some(_) => Err(exhausted()),
        }
    }

    /// The point with this tag.
    pub(super) fn point(&self, tag: i32) -> Result<&Point, Problem> {
        self.points.get(tag).ok_or_else(|| unknown("point", tag))
    }

    /// The curve with this tag, whatever its sign.
    pub(super) fn curve(&self, tag: i32) -> Result<&Curve, Problem> {
        self.curves.get(tag.abs()).ok_or_else(|| unknown("curve", tag))
    }

    /// The surface with this tag, whatever its sign.
    pub(super) fn surface(&self, tag: i32) -> Result<&Surface, Problem> {
        self.surfaces.get(&tag.abs()).ok_or_else(|| unknown("surface", tag))
    }

    /// How many things it has: the work of going through all of them.
    pub(super) fn size(&self) -> u64 {
        (self.points.len() + self.curves.len() + self.surfaces.len()) as u64
    }
}

/// Something that does not exist.
pub(super) fn unknown(what: &'static str, tag: i32) -> Problem {
    Problem::Unknown { what, name: tag.to_string() }
}

/// Every number up to the largest is in use.
fn exhausted() -> Problem {
    Problem::Limit { what: "its numbers go beyond 2147483647" }
}
