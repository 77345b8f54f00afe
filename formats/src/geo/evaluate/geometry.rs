//! Statements that make points, curves, surfaces and groups, and what is asked of their mesh.

use std::f64::consts::TAU;

use super::Evaluator;
use super::budget::ENTITY;
use super::value::{Value, whole};
use crate::geo::error::{CurveFault, Problem};
use crate::geo::model::{
    Curve, CurveKind, PhysicalGroup, Point, RADIUS_TOLERANCE, Spread, unknown,
};
use crate::geo::sources::Answer;
use crate::geo::syntax::{Assignment, EntityKind, Expression, Law, Place};

impl Evaluator<'_, '_> {
    /// `Point(1) = {0, 0, 0};` and its like.
    pub(super) fn make_entity(
        &mut self,
        place: Place,
        kind: EntityKind,
        tag: &Expression,
        value: &Expression,
    ) -> Answer<()> {
        let number = self.tag(tag, "the number of an entity")?;
        self.spend(ENTITY, place)?;
        self.is_free(place, kind, number)?;
        match kind {
            EntityKind::Point => self.make_point(place, number, value),
            EntityKind::Circle | EntityKind::Ellipse => self.make_arc(place, kind, number, value),
            EntityKind::Line => self.make_curve(place, CurveKind::Line, number, value),
            EntityKind::Spline => self.make_curve(place, CurveKind::Spline, number, value),
            EntityKind::BSpline => self.make_curve(place, CurveKind::BSpline, number, value),
            EntityKind::Bezier => self.make_curve(place, CurveKind::Bezier, number, value),
            EntityKind::CurveLoop | EntityKind::Wire => {
                let curves = self.tags(value, "the number of a curve")?;
                self.model.add_loop(number, curves).map_err(|problem| problem.at(place))
            }
            EntityKind::PlaneSurface | EntityKind::Patch => {
                let loops = self.tags(value, "the number of a curve loop")?;
                self.model.add_surface(place, number, &loops).map_err(|problem| problem.at(place))
            }
            EntityKind::Rectangle => {
                let (corner, size, radius) = match self.numbers(value)?[..] {
                    [x, y, z, w, h] => ([x, y, z], [w, h], 0.0),
                    [x, y, z, w, h, radius] => ([x, y, z], [w, h], radius),
                    ref other => {
                        return Err(count("Rectangle", "five or six numbers", other).at(place));
                    }
                };
                let made = self.model.add_rectangle(place, number, corner, size, radius);
                made.map_err(|problem| problem.at(place))
            }
            EntityKind::Disk => {
                let (centre, radii) = match self.numbers(value)?[..] {
                    [x, y, z, radius] => ([x, y, z], [radius; 2]),
                    [x, y, z, first, second] => ([x, y, z], [first, second]),
                    ref other => return Err(count("Disk", "four or five numbers", other).at(place)),
                };
                let made = self.model.add_disk(place, number, centre, radii);
                made.map_err(|problem| problem.at(place))
            }
        }
    }

    /// Whether nothing has this number yet.
    fn is_free(&self, place: Place, kind: EntityKind, tag: i32) -> Answer<()> {
        let (what, first) = match kind {
            EntityKind::Point => ("point", self.model.points.get(tag).map(|point| point.place)),
            EntityKind::CurveLoop | EntityKind::Wire => return Ok(()),
            EntityKind::PlaneSurface
            | EntityKind::Patch
            | EntityKind::Rectangle
            | EntityKind::Disk => {
                ("surface", self.model.surfaces.get(&tag).map(|surface| surface.place))
            }
            _ => ("curve", self.model.curves.get(tag.abs()).map(|curve| curve.place)),
        };
        match first {
            Some(first) => {
                Err(Problem::Twice { what, tag, line: self.sources.line(first) }.at(place))
            }
            None => Ok(()),
        }
    }

    fn make_point(&mut self, place: Place, tag: i32, value: &Expression) -> Answer<()> {
        let (at, size) = match self.numbers(value)?[..] {
            [x, y] => ([x, y, 0.0], None),
            [x, y, z] => ([x, y, z], None),
            [x, y, z, size, ..] => ([x, y, z], Some(size)),
            ref other => return Err(count("Point", "three or four numbers", other).at(place)),
        };
        // No size, or none that can be reached, is no size.
        let size = size.filter(|&size| size > 0.0 && size < 1e22);
        self.model.add_point(tag, Point { place, at, size }).map_err(|problem| problem.at(place))
    }

    fn make_curve(
        &mut self,
        place: Place,
        kind: CurveKind,
        tag: i32,
        value: &Expression,
    ) -> Answer<()> {
        let points = self.tags(value, "the number of a point")?;
        self.spend(points.len() as u64, place)?;
        if points.len() < 2 {
            return Err(Problem::Count {
                what: "a curve",
                expected: "two points or more",
                found: points.len(),
            }
            .at(place));
        }
        let curve = Curve { place, kind, points: points.into(), spread: None };
        self.model.add_curve(tag, curve).map_err(|problem| problem.at(place))
    }

    /// An arc between points, or, of OpenCASCADE, one about a centre.
    fn make_arc(
        &mut self,
        place: Place,
        kind: EntityKind,
        tag: i32,
        value: &Expression,
    ) -> Answer<()> {
        let numbers = self.numbers(value)?;
        let about = match (kind, &numbers[..]) {
            (EntityKind::Circle, &[x, y, z, radius]) => Some((x, y, z, [radius; 2], [0.0, TAU])),
            (EntityKind::Circle, &[x, y, z, radius, to]) => Some((x, y, z, [radius; 2], [0.0, to])),
            (EntityKind::Circle, &[x, y, z, radius, from, to, ..]) => {
                Some((x, y, z, [radius; 2], [from, to]))
            }
            (EntityKind::Ellipse, &[x, y, z, a, b]) => Some((x, y, z, [a, b], [0.0, TAU])),
            (EntityKind::Ellipse, &[x, y, z, a, b, to]) => Some((x, y, z, [a, b], [0.0, to])),
            (EntityKind::Ellipse, &[x, y, z, a, b, from, to, ..]) => {
                Some((x, y, z, [a, b], [from, to]))
            }
            _ => None,
        };
        if let Some((x, y, z, radii, angles)) = about {
            let made = self.model.add_ellipse(place, tag, [x, y, z], radii, angles);
            return made.map_err(|problem| problem.at(place));
        }
        let points: Result<Vec<i32>, _> =
            numbers.iter().map(|&number| whole(number, "the number of a point")).collect();
        let points = points.map_err(|problem| problem.at(value.place))?;
        let (kind, points) = match (kind, &points[..]) {
            (EntityKind::Circle, [_, _, _]) => (CurveKind::Circle { reversed: false }, points),
            (EntityKind::Ellipse, [_, _, _, _]) => (CurveKind::Ellipse { reversed: false }, points),
            // Three points: the first end is a point of the major axis.
            (EntityKind::Ellipse, &[first, centre, last]) => {
                (CurveKind::Ellipse { reversed: false }, vec![first, centre, first, last])
            }
            (EntityKind::Circle, _) => {
                return Err(
                    count("Circle", "two ends and the centre between them", &numbers).at(place)
                );
            }
            _ => {
                let expected = "an end, the centre, a point of the major axis and an end";
                return Err(count("Ellipse", expected, &numbers).at(place));
            }
        };
        let curve = Curve { place, kind, points: points.into(), spread: None };
        self.model.add_curve(tag, curve).map_err(|problem| problem.at(place))?;
        self.check_arc(tag).map_err(|problem| problem.at(place))
    }

    /// Whether the ends of an arc are away from its centre, those of a circle equally far.
    fn check_arc(&self, tag: i32) -> Result<(), Problem> {
        let curve = self.model.curve(tag)?;
        let centre = self.model.point(curve.points[1])?.at;
        let distance = |point: i32| {
            let at = self.model.point(point)?.at;
            let [x, y, z] = [0, 1, 2].map(|i| at[i] - centre[i]);
            Ok(libm::hypot(libm::hypot(x, y), z))
        };
        let [first, last] = curve.ends();
        let (first, last) = (distance(first)?, distance(last)?);
        let fault = if first == 0.0 || last == 0.0 {
            CurveFault::EndInCentre
        } else if matches!(curve.kind, CurveKind::Circle { .. })
            && (first - last).abs() > RADIUS_TOLERANCE * (first + last)
        {
            CurveFault::Radii(first, last)
        } else {
            return Ok(());
        };
        Err(Problem::Curve { tag, fault })
    }

    /// `Physical Curve("rim", 1) = {1, 2};`
    pub(super) fn make_group(
        &mut self,
        place: Place,
        dim: u8,
        [first, second]: [Option<&Expression>; 2],
        operator: Assignment,
        members: &Expression,
    ) -> Answer<()> {
        let (mut name, mut tag) = (None, None);
        for part in [first, second].into_iter().flatten() {
            match self.value(part)? {
                text @ (Value::Text(_) | Value::Texts(_)) => {
                    name = Some(text.text().map_err(|problem| problem.at(part.place))?);
                }
                number => {
                    let number = number.number().map_err(|problem| problem.at(part.place))?;
                    let whole = whole(number, "the number of a group");
                    tag = Some(whole.map_err(|problem| problem.at(part.place))?);
                }
            }
        }
        let members = self.tags(members, "the number of an entity")?;
        self.spend(ENTITY + members.len() as u64, place)?;
        if dim == 1 {
            let sure = members.iter().try_for_each(|&curve| self.model.is_sure(curve));
            sure.map_err(|problem| problem.at(place))?;
        }
        if dim == 3 {
            self.skip("Physical Volume", place);
            return Ok(());
        }
        let tag = tag.unwrap_or_else(|| self.group_named(dim, name.as_deref()));
        self.model.tags.group = self.model.tags.group.max(tag);
        let members = members.into_iter().map(i32::abs);
        let known = self.model.groups.get_mut(&(dim, tag));
        match (known, operator) {
            (Some(group), Assignment::Set) => {
                let (what, line) = ("physical group", self.sources.line(group.place));
                return Err(Problem::Twice { what, tag, line }.at(place));
            }
            (Some(group), Assignment::Add) => group.members.extend(members),
            (Some(group), Assignment::Subtract) => {
                let gone: Vec<i32> = members.collect();
                group.members.retain(|member| !gone.contains(member));
            }
            (None, Assignment::Set | Assignment::Add) => {
                let members = members.collect();
                self.model.groups.insert((dim, tag), PhysicalGroup { place, name, members });
            }
            (None, Assignment::Subtract) => return Err(unknown("physical group", tag).at(place)),
            (_, Assignment::Multiply | Assignment::Divide) => {
                let expected = "`=`, `+=` or `-=`".into();
                return Err(Problem::Kind { expected, found: "another operator" }.at(place));
            }
        }
        Ok(())
    }

    /// The number of a group that is given by name alone: its own, or the next one. Either way that
    /// number is used up, as in Gmsh.
    fn group_named(&mut self, dim: u8, name: Option<&str>) -> i32 {
        let next = self.model.tags.next_group();
        self.model.tags.group = next;
        let mut groups = self.model.groups.iter();
        let known = groups.find(|((of, _), group)| *of == dim && group.name.as_deref() == name);
        known.map_or(next, |(&(_, tag), _)| tag)
    }

    /// `MeshSize {1, 2} = 0.1;`
    pub(super) fn set_sizes(&mut self, points: &Expression, size: &Expression) -> Answer<()> {
        let tags = self.tags(points, "the number of a point")?;
        let value = self.number(size)?;
        for tag in tags {
            // Gmsh passes over points that are not there; ranges of numbers have such gaps.
            if let Some(point) = self.model.points.get_mut(tag) {
                point.size = Some(value).filter(|&size| size > 0.0 && size < 1e22);
            }
        }
        Ok(())
    }

    /// `Transfinite Curve {1, -2} = 10 Using Progression 1.2;`
    pub(super) fn set_spread(
        &mut self,
        place: Place,
        curves: &Expression,
        points: &Expression,
        law: Option<&(Law, Expression)>,
    ) -> Answer<()> {
        let tags = self.tags(curves, "the number of a curve")?;
        let count = self.number(points)?;
        if !(1.0..=1e7).contains(&count) {
            let expected = "a number of points from 2 to 10 million".into();
            return Err(Problem::Kind { expected, found: "another one" }.at(points.place));
        }
        let law = match law {
            Some((law, coefficient)) => Some((*law, self.number(coefficient)?)),
            None => None,
        };
        let points = (count as u32).max(2);
        for tag in tags {
            self.model.is_sure(tag).map_err(|problem| problem.at(place))?;
            let Some(curve) = self.model.curves.get_mut(tag.abs()) else {
                return Err(unknown("curve", tag).at(place));
            };
            let law = law.map(|(law, coefficient)| match law {
                // From the other end the steps grow the other way.
                Law::Progression if tag < 0 => (law, 1.0 / coefficient),
                law => (law, coefficient),
            });
            let law = law.filter(|&(_, coefficient)| coefficient > 0.0 && coefficient.is_finite());
            curve.spread = Some(Box::new(Spread { points, law }));
        }
        Ok(())
    }

    /// `Curve {5, 6} In Surface {1};`
    pub(super) fn embed(
        &mut self,
        place: Place,
        dim: u8,
        members: &Expression,
        surfaces: &Expression,
    ) -> Answer<()> {
        let members = self.tags(members, "the number of an entity")?;
        for tag in self.tags(surfaces, "the number of a surface")? {
            for &member in &members {
                let known = match dim {
                    0 => self.model.point(member).map(|_| ()),
                    1 => self.model.is_sure(member).and(self.model.curve(member).map(|_| ())),
                    _ => Err(super::unsupported("Surface In Surface")),
                };
                known.map_err(|problem| problem.at(place))?;
            }
            self.spend(members.len() as u64, place)?;
            let Some(surface) = self.model.surfaces.get_mut(&tag.abs()) else {
                return Err(unknown("surface", tag).at(place));
            };
            match dim {
                0 => surface.embedded_points.extend(&members),
                _ => surface.embedded_curves.extend(members.iter().map(|tag| tag.abs())),
            }
        }
        Ok(())
    }
}

fn count(what: &'static str, expected: &'static str, numbers: &[f64]) -> Problem {
    Problem::Count { what, expected, found: numbers.len() }
}
