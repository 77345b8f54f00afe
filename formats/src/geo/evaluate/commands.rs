//! Operations on shapes.

use super::Evaluator;
use super::value::whole;
use crate::geo::error::Problem;
use crate::geo::model::{Boolean, Extrusion, Motion, Shape, Spread, Sweep, unknown};
use crate::geo::sources::Answer;
use crate::geo::syntax::{
    BooleanKind, Command, Expression, Operation, Place, Shape as ShapeSyntax, Shapes,
};

impl Evaluator<'_, '_> {
    /// Does an operation; the shapes that it makes or finds.
    pub(super) fn command(&mut self, command: &Command) -> Answer<Vec<Shape>> {
        let place = command.place;
        let shapes = self.shapes(&command.shapes)?;
        self.spend(super::budget::ENTITY * shapes.len() as u64, place)?;
        match &command.operation {
            Operation::Translate(by) => {
                let by = self.exactly(by, "Translate", "three numbers")?;
                self.transform(place, Motion::translation(by), &shapes)?;
            }
            Operation::Rotate(axis, centre, angle) => {
                let axis = self.axis(axis)?;
                let centre = self.exactly(centre, "the centre of Rotate", "three numbers")?;
                let angle = self.number(angle)?;
                self.transform(place, Motion::rotation(axis, centre, angle), &shapes)?;
            }
            Operation::Symmetry(plane) => {
                let plane = self.exactly(plane, "Symmetry", "four numbers")?;
                self.transform(place, Motion::reflection(plane), &shapes)?;
            }
            Operation::Dilate(centre, factor) => {
                let centre = self.exactly(centre, "the centre of Dilate", "three numbers")?;
                let factors = match self.numbers(factor)?[..] {
                    [factor] => [factor; 3],
                    [x, y, z] => [x, y, z],
                    ref other => {
                        let (what, found) = ("the factor of Dilate", other.len());
                        let expected = "one number or three";
                        return Err(Problem::Count { what, expected, found }.at(factor.place));
                    }
                };
                self.transform(place, Motion::dilation(centre, factors), &shapes)?;
            }
            Operation::Duplicata => {
                let work = self.work_of(&shapes);
                self.spend(work, place)?;
                return self.model.duplicate(place, &shapes).map_err(|problem| problem.at(place));
            }
            Operation::ExtrudeAlong(by) => {
                let by = self.exactly(by, "Extrude", "three numbers")?;
                return self.extrude(place, Sweep::Along(by), &command.shapes, &shapes);
            }
            Operation::ExtrudeAround(axis, point, angle) => {
                let axis = self.axis(axis)?;
                let point = self.exactly(point, "the point of Extrude", "three numbers")?;
                let angle = self.number(angle)?;
                return self.extrude(
                    place,
                    Sweep::Around { axis, point, angle },
                    &command.shapes,
                    &shapes,
                );
            }
            Operation::Boundary { combined } => {
                let work = self.work_of(&shapes);
                self.spend(work, place)?;
                return self
                    .model
                    .boundary(&shapes, *combined)
                    .map_err(|problem| problem.at(place));
            }
            Operation::PointsOf => {
                let work = self.work_of(&shapes);
                self.spend(work, place)?;
                return self.model.points_of(&shapes).map_err(|problem| problem.at(place));
            }
            Operation::Boolean { kind, tag, tools } => {
                return self.combine(command, *kind, &shapes, tag.as_ref(), tools);
            }
            Operation::Unsupported(name) => return Err(super::unsupported(name).at(place)),
        }
        Ok(shapes)
    }

    /// `BooleanDifference{ Surface{1}; Delete; }{ Surface{2}; Delete; }`
    fn combine(
        &mut self,
        command: &Command,
        kind: BooleanKind,
        objects: &[Shape],
        tag: Option<&Expression>,
        tools: &Shapes,
    ) -> Answer<Vec<Shape>> {
        let place = command.place;
        let tag = tag.map(|tag| self.tag(tag, "the number of a surface")).transpose()?;
        let delete_tools = tools.delete;
        let tools = self.shapes(tools)?;
        // Every curve is held against every other one.
        let shapes = [objects, &tools].concat();
        let curves = self.work_of(&shapes) / super::budget::ENTITY;
        self.spend(self.model.size() * shapes.len() as u64 + curves * curves, place)?;
        let how = Boolean {
            place,
            kind,
            tag,
            objects,
            delete_objects: command.shapes.delete,
            tools: &tools,
            delete_tools,
        };
        self.model.combine(&how).map_err(|problem| problem.at(place))
    }

    /// A direction.
    fn axis(&mut self, axis: &Expression) -> Answer<[f64; 3]> {
        let direction: [f64; 3] = self.exactly(axis, "an axis", "three numbers")?;
        if direction == [0.0; 3] {
            let expected = "an axis that has a direction".into();
            return Err(Problem::Kind { expected, found: "{0, 0, 0}" }.at(axis.place));
        }
        Ok(direction)
    }

    fn transform(&mut self, place: Place, motion: Motion, shapes: &[Shape]) -> Answer<()> {
        if !motion.is_finite() {
            let operation = "this transformation".to_owned();
            return Err(Problem::NotFinite { operation }.at(place));
        }
        let work = self.work_of(shapes);
        self.spend(work, place)?;
        self.model.transform(&motion, shapes).map_err(|problem| problem.at(place))?;
        if self.options.auto_coherence && !self.model.is_occ { self.cohere(place) } else { Ok(()) }
    }

    /// Merges what is the same.
    pub(super) fn cohere(&mut self, place: Place) -> Answer<()> {
        let work = 3 * self.model.size();
        self.spend(work, place)?;
        self.model.cohere();
        Ok(())
    }

    fn extrude(
        &mut self,
        place: Place,
        sweep: Sweep,
        syntax: &Shapes,
        shapes: &[Shape],
    ) -> Answer<Vec<Shape>> {
        let coheres = self.options.auto_coherence && !self.model.is_occ;
        let spread = self.layers(&syntax.layers)?;
        let each = self.work_of(shapes)
            + if coheres { 3 * self.model.size() * shapes.len() as u64 } else { 0 };
        self.spend(each, place)?;
        let how = Extrusion { place, sweep, spread, coheres };
        self.model.extrude(&how, shapes).map_err(|problem| problem.at(place))
    }

    /// `Layers{10}`, `Layers{{4, 6}, {0.5, 1}}`: how many elements there are along an extrusion.
    fn layers(&mut self, layers: &[Expression]) -> Answer<Option<Spread>> {
        let Some(first) = layers.first() else { return Ok(None) };
        let numbers: f64 = self.numbers(first)?.iter().sum();
        let count =
            whole(numbers, "the number of layers").map_err(|problem| problem.at(first.place))?;
        let points = u32::try_from(count).ok().filter(|&count| count > 0).map(|count| count + 1);
        Ok(points.map(|points| Spread { points, law: None }))
    }

    /// Takes shapes away.
    pub(super) fn delete(&mut self, place: Place, shapes: &Shapes, recursive: bool) -> Answer<()> {
        let shapes = self.shapes(shapes)?;
        let work = self.model.size() * shapes.len() as u64;
        self.spend(work, place)?;
        self.model.delete(&shapes, recursive);
        Ok(())
    }

    /// The shapes that stand in braces.
    fn shapes(&mut self, syntax: &Shapes) -> Answer<Vec<Shape>> {
        let mut shapes = Vec::new();
        for item in &syntax.items {
            match item {
                ShapeSyntax::Entities { dim, tags } => {
                    let tags_found = self.tags(tags, "the number of a shape")?;
                    if *dim == 3 && !tags_found.is_empty() {
                        return Err(super::unsupported("Volume").at(tags.place));
                    }
                    shapes.extend(tags_found.into_iter().map(|tag| (*dim, tag)));
                }
                ShapeSyntax::Group { dim, tags } => {
                    for tag in self.tags(tags, "the number of a group")? {
                        let Some(group) = self.model.groups.get(&(*dim, tag)) else {
                            return Err(unknown("physical group", tag).at(tags.place));
                        };
                        shapes.extend(group.members.iter().map(|&member| (*dim, member)));
                    }
                }
                ShapeSyntax::Made(command) => shapes.extend(self.command(command)?),
            }
        }
        Ok(shapes)
    }

    /// The work of going through shapes and what they are made of.
    fn work_of(&self, shapes: &[Shape]) -> u64 {
        let curve = |tag: i32| self.model.curve(tag).map_or(1, |curve| curve.points.len() as u64);
        let work = shapes.iter().map(|&(dim, tag)| match dim {
            0 => 1,
            1 => curve(tag),
            _ => self.model.surface(tag).map_or(1, |surface| surface.curves().map(curve).sum()),
        });
        super::budget::ENTITY * (1 + work.sum::<u64>())
    }
}
