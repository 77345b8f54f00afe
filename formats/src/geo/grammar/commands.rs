//! The grammar of operations on shapes: transformations, extrusions, boundaries.
//!
//! ```text
//! command  := 'Translate' vector shapes | 'Rotate' '{' item ',' item ',' item '}' shapes
//!           | 'Symmetry' list shapes | 'Dilate' '{' item ',' item '}' shapes
//!           | 'Extrude' (list | '{' item ',' item ',' item '}') shapes
//!           | ('Duplicata' | 'Boundary' | 'CombinedBoundary' | 'PointsOf') shapes
//!           | boolean ['(' item ')' '='] shapes shapes
//! boolean  := 'BooleanUnion' | 'BooleanIntersection' | 'BooleanDifference' | 'BooleanFragments'
//! shapes   := '{' (shape [';'])* '}'
//! shape    := ['Physical'] dimension (list | '{' ':' '}') | command
//!           | 'Delete' | 'Recursive' 'Delete' | 'Layers' … | 'Recombine' … | 'Using' …
//! ```
//!
//! Of what tells how an extrusion is meshed, `Layers` alone is kept.

use nom::combinator::opt;
use nom::{Err, Parser};

use super::expressions::{all, dimension, list, must_item};
use super::input::{Parsed, Text};
use super::tokens::{Until, blank, keyword, must, passed_over, symbol, word};
use crate::geo::syntax::{BooleanKind, Command, Expression, Operation, Shape, Shapes, Term};

/// An operation on shapes.
pub(super) fn command(input: Text) -> Parsed<Command> {
    let begin = blank(input)?;
    let (rest, operation) = operation(begin)?;
    if let Operation::Unsupported(_) = operation {
        let shapes = Shapes::default();
        return Ok((rest, Command { place: begin.place(), operation, shapes }));
    }
    let (rest, shapes) = shapes(rest)?;
    let (rest, operation) = match operation {
        Operation::Boolean { kind, tag, .. } => {
            let (rest, tools) = self::shapes(rest)?;
            (rest, Operation::Boolean { kind, tag, tools })
        }
        operation => (rest, operation),
    };
    Ok((rest, Command { place: begin.place(), operation, shapes }))
}

fn operation(input: Text) -> Parsed<Operation> {
    let (rest, name) = word(input)?;
    match name {
        "Translate" => must_item(rest).map(|(rest, by)| (rest, Operation::Translate(by))),
        "Rotate" => {
            let (rest, [axis, centre, angle]) = parts(rest)?;
            Ok((rest, Operation::Rotate(axis, centre, angle)))
        }
        "Symmetry" => must_item(rest).map(|(rest, plane)| (rest, Operation::Symmetry(plane))),
        "Dilate" => {
            let (rest, [centre, factor]) = parts(rest)?;
            Ok((rest, Operation::Dilate(centre, factor)))
        }
        "Extrude" => extrusion(rest),
        "Duplicata" => Ok((rest, Operation::Duplicata)),
        "Boundary" => Ok((rest, Operation::Boundary { combined: false })),
        "CombinedBoundary" => Ok((rest, Operation::Boundary { combined: true })),
        "PointsOf" => Ok((rest, Operation::PointsOf)),
        "BooleanUnion" => boolean(rest, BooleanKind::Union),
        "BooleanIntersection" => boolean(rest, BooleanKind::Intersection),
        "BooleanDifference" => boolean(rest, BooleanKind::Difference),
        "BooleanFragments" => boolean(rest, BooleanKind::Fragments),
        "Affine" | "Split" | "Intersect" => {
            let (rest, ()) = passed_over(rest, Until::BeforeSemicolon)?;
            Ok((rest, Operation::Unsupported(name.to_owned())))
        }
        _ => input.no("an operation on shapes"),
    }
}

/// A boolean operation up to its shapes.
fn boolean(input: Text, kind: BooleanKind) -> Parsed<Operation> {
    let tag = symbol("(").and(must_item).and(must(")")).and(must("="));
    let (rest, tag) = opt(tag).parse(input)?;
    let tag = tag.map(|((((), tag), ()), ())| tag);
    Ok((rest, Operation::Boolean { kind, tag, tools: Shapes::default() }))
}

/// A list of so many items.
fn parts<const N: usize>(input: Text) -> Parsed<[Expression; N]> {
    let begin = blank(input)?;
    let (rest, items) = list(begin).or_else(|error| match error {
        Err::Error(_) => begin.must("`{`"),
        error => Err(error),
    })?;
    match <[Expression; N]>::try_from(items) {
        Ok(items) => Ok((rest, items)),
        Err(_) => begin.must(format!("a list of {N} parts")),
    }
}

/// `{x, y, z}` or `{{axis}, {point}, angle}`; an extrusion that also turns as it moves leaves the
/// plane.
fn extrusion(input: Text) -> Parsed<Operation> {
    let begin = blank(input)?;
    let (rest, items) =
        list(begin).or_else(|_| begin.must("`{x, y, z}` or `{{axis}, {point}, angle}`"))?;
    let turns = items.iter().any(|item| matches!(item.term, Term::List(_)));
    if !turns {
        let place = begin.place();
        let by = Expression { place, term: Term::List(items) };
        return Ok((rest, Operation::ExtrudeAlong(by)));
    }
    match <[Expression; 3]>::try_from(items) {
        Ok([axis, point, angle]) => Ok((rest, Operation::ExtrudeAround(axis, point, angle))),
        Err(_) => begin.must("`{x, y, z}` or `{{axis}, {point}, angle}`"),
    }
}

/// Shapes in braces.
pub(super) fn shapes(input: Text) -> Parsed<Shapes> {
    let (mut rest, ()) = must("{")(input.deeper()?)?;
    let mut shapes = Shapes::default();
    loop {
        if let Ok((after, ())) = symbol("}")(rest) {
            return Ok((after.as_deep_as(input), shapes));
        }
        if let Ok((after, ())) = keyword("Layers")(rest) {
            let (after, layers) = list(after).or_else(|_| after.must("`{`"))?;
            shapes.layers = layers;
            rest = symbol(";")(after).map_or(after, |(after, ())| after);
            continue;
        }
        rest = match mesh_option(rest) {
            Ok((after, ())) => after,
            Err(Err::Error(_)) => {
                if let Ok((after, ())) = keyword("Recursive")(rest) {
                    rest = after;
                }
                if let Ok((after, ())) = keyword("Delete")(rest) {
                    shapes.delete = true;
                    after
                } else {
                    let (after, shape) = shape(rest)?;
                    shapes.items.push(shape);
                    after
                }
            }
            Err(error) => return Err(error),
        };
        if let Ok((after, ())) = symbol(";")(rest) {
            rest = after;
        }
    }
}

/// How an extrusion is meshed: `Recombine;`.
fn mesh_option(input: Text) -> Parsed<()> {
    match word(input)? {
        (
            rest,
            "Recombine" | "ScaleLastLayer" | "QuadTriAddVerts" | "QuadTriNoNewVerts" | "Using"
            | "Hole",
        ) => passed_over(rest, Until::BeforeSemicolon),
        _ => input.no("an option of an extrusion"),
    }
}

fn shape(input: Text) -> Parsed<Shape> {
    if let Ok((rest, ())) = keyword("Physical")(input) {
        let (rest, dim) = dimension(rest)?;
        let (rest, tags) = must_item(rest)?;
        return Ok((rest, Shape::Group { dim, tags }));
    }
    if let Ok((rest, dim)) = dimension(input) {
        let begin = blank(rest)?;
        if let Ok((rest, ())) = all(begin) {
            let tags = Expression { place: begin.place(), term: Term::All(dim) };
            return Ok((rest, Shape::Entities { dim, tags }));
        }
        let (rest, tags) = must_item(begin)?;
        return Ok((rest, Shape::Entities { dim, tags }));
    }
    match command(input) {
        Err(Err::Error(_)) => blank(input)?.must("a shape, such as `Curve{1};`"),
        answer => answer.map(|(rest, command)| (rest, Shape::Made(Box::new(command)))),
    }
}
