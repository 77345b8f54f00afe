//! Extrusions within the plane: points become curves, curves become surfaces.
//!
//! The numbers of what is made are those that Gmsh gives: scripts name them.

use super::{Curve, CurveKind, Model, Motion, Shape, Spread};
use crate::geo::error::Problem;
use crate::geo::syntax::Place;

/// How far, or how much around what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::geo) enum Sweep {
    Along([f64; 3]),
    Around { axis: [f64; 3], point: [f64; 3], angle: f64 },
}

/// An extrusion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::geo) struct Extrusion {
    pub place: Place,
    pub sweep: Sweep,
    /// How the curves that points leave are divided.
    pub spread: Option<Spread>,
    /// Whether what is the same is merged afterwards.
    pub coheres: bool,
}

impl Sweep {
    fn motion(self) -> Motion {
        match self {
            Self::Along(by) => Motion::translation(by),
            Self::Around { axis, point, angle } => Motion::rotation(axis, point, angle),
        }
    }

    /// The point of the axis that is nearest to a place.
    fn centre(self, at: [f64; 3]) -> [f64; 3] {
        let Self::Around { axis, point, .. } = self else { return at };
        let squared: f64 = axis.iter().map(|x| x * x).sum();
        let along: f64 = (0..3).map(|i| (at[i] - point[i]) * axis[i]).sum::<f64>() / squared;
        [0, 1, 2].map(|i| point[i] + along * axis[i])
    }
}

impl Model {
    /// Extrudes shapes. For each: what it becomes at the far end, what it leaves on the way, and
    /// the curves beside that.
    pub(in crate::geo) fn extrude(
        &mut self,
        how: &Extrusion,
        shapes: &[Shape],
    ) -> Result<Vec<Shape>, Problem> {
        let mut made = Vec::new();
        for &(dim, tag) in shapes {
            let mut new = match dim {
                0 => self.extrude_point(how, tag).map(|(top, curve)| {
                    std::iter::once((0, top)).chain(curve.map(|curve| (1, curve))).collect()
                })?,
                1 if self.is_occ => self.extrude_curve_occ(how, tag)?,
                1 => self.extrude_curve(how, tag)?,
                _ => {
                    return Err(Problem::Unsupported {
                        statement: "Extrude of a surface".to_owned(),
                    });
                }
            };
            if how.coheres {
                let merged = self.cohere();
                for (dim, tag) in &mut new {
                    let replaced = match dim {
                        0 => merged.points.get(tag),
                        1 => merged.curves.get(&tag.abs()),
                        _ => merged.surfaces.get(tag),
                    };
                    if let Some(&first) = replaced {
                        *tag = first * tag.signum();
                    }
                }
            }
            made.append(&mut new);
        }
        Ok(made)
    }

    /// The point at the far end and the curve to it; no curve where the point does not move.
    fn extrude_point(&mut self, how: &Extrusion, tag: i32) -> Result<(i32, Option<i32>), Problem> {
        let from = self.point(tag)?.at;
        let to = how.sweep.motion().apply(from);
        if to.iter().any(|x| !x.is_finite()) {
            return Err(Problem::NotFinite { operation: format!("extruding point {tag}") });
        }
        let top = self.duplicate_point(how.place, tag)?;
        let tolerance = 1e-8 * self.extent();
        if (0..3).all(|i| (from[i] - to[i]).abs() <= tolerance) {
            return Ok((tag, None));
        }
        self.move_point(top, to);
        let curve = self.next_shape_curve();
        let place = how.place;
        let (kind, points) = match how.sweep {
            Sweep::Along(_) => (CurveKind::Line, vec![tag, top]),
            Sweep::Around { .. } if self.is_occ => {
                (CurveKind::Arc(Box::new(self.arc_about(how.sweep, from))), vec![tag, top])
            }
            Sweep::Around { .. } => {
                let centre = self.duplicate_point(place, tag)?;
                self.move_point(centre, how.sweep.centre(from));
                (CurveKind::Circle { reversed: false }, vec![tag, centre, top])
            }
        };
        self.add_curve(
            curve,
            Curve { place, kind, points: points.into(), spread: how.spread.map(Box::new) },
        )?;
        Ok((top, Some(curve)))
    }

    fn arc_about(&self, sweep: Sweep, from: [f64; 3]) -> super::Arc {
        let centre = sweep.centre(from);
        let u = [0, 1, 2].map(|i| from[i] - centre[i]);
        let (v, to) = match sweep {
            Sweep::Along(_) => (u, 0.0),
            Sweep::Around { axis, angle, .. } => {
                let quarter = Motion::rotation(axis, [0.0; 3], std::f64::consts::FRAC_PI_2);
                (quarter.apply(u), angle)
            }
        };
        super::Arc { centre, u, v, from: 0.0, to }
    }

    fn move_point(&mut self, tag: i32, at: [f64; 3]) {
        if let Some(point) = self.points.get_mut(tag) {
            point.at = at;
        }
    }

    fn extrude_curve(&mut self, how: &Extrusion, tag: i32) -> Result<Vec<Shape>, Problem> {
        let [begin, end] = self.curve(tag)?.signed(tag).ends();
        let top = self.duplicate_curve(how.place, tag)?;
        self.transform(&how.sweep.motion(), &[(1, top)])?;
        let (_, at_begin) = self.extrude_point(how, begin)?;
        let (_, at_end) = self.extrude_point(how, end)?;
        let sides: Vec<i32> = at_end.into_iter().chain(at_begin.map(|curve| -curve)).collect();
        if sides.is_empty() {
            return Ok(vec![(1, tag)]);
        }
        let surface = self.tags.next_surface();
        self.insert_swept(how, surface, [tag, top], [at_begin, at_end])?;
        let mut made = vec![(1, top), (2, surface)];
        made.extend(sides.into_iter().map(|side| (1, side)));
        Ok(made)
    }

    /// The surface between a curve and its copy `top`, and the curves that its ends ran along.
    fn insert_swept(
        &mut self,
        how: &Extrusion,
        surface: i32,
        [tag, top]: [i32; 2],
        [at_begin, at_end]: [Option<i32>; 2],
    ) -> Result<(), Problem> {
        let mut curves = vec![tag];
        curves.extend(at_end);
        curves.push(-top);
        curves.extend(at_begin.map(|curve| -curve));
        self.insert_surface(how.place, surface, vec![(0, curves)])
    }

    /// As OpenCASCADE counts: the curves at both ends, then the far one.
    fn extrude_curve_occ(&mut self, how: &Extrusion, tag: i32) -> Result<Vec<Shape>, Problem> {
        let source = self.curve(tag)?.clone();
        let [begin, end] = source.ends();
        let (first, at_begin) = self.extrude_point(how, begin)?;
        let (last, at_end) = self.extrude_point(how, end)?;
        let motion = how.sweep.motion();
        let mut points = Vec::with_capacity(source.points.len());
        for &point in source.points.iter() {
            points.push(match point {
                point if point == begin => first,
                point if point == end => last,
                point => {
                    let to = motion.apply(self.point(point)?.at);
                    let copy = self.duplicate_point(how.place, point)?;
                    self.move_point(copy, to);
                    copy
                }
            });
        }
        let kind = match source.kind {
            CurveKind::Arc(arc) => CurveKind::Arc(Box::new(arc.moved(&motion))),
            kind => kind,
        };
        let top = self.next_shape_curve();
        self.add_curve(
            top,
            Curve { place: how.place, kind, points: points.into(), spread: source.spread },
        )?;
        let surface = self.tags.surface.saturating_add(1);
        self.insert_swept(how, surface, [tag, top], [at_begin, at_end])?;
        let mut made = vec![(1, top), (2, surface)];
        made.extend(at_begin.into_iter().chain(at_end).map(|side| (1, side)));
        Ok(made)
    }
}
