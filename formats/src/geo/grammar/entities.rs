//! The grammar of what makes and groups points, curves and surfaces.

use nom::Parser;
use nom::combinator::opt;

use super::assignments::assignment;
use super::commands::shapes;
use super::expressions::{all_or_list, dimension, expression, must_item};
use super::input::{Parsed, Text};
use super::skipping::title;
use super::tokens::{Until, keyword, must, passed_over, symbol, word};
use crate::geo::syntax::{Action, EntityKind, Law};

/// `Point`, `Line Loop`, `Plane Surface`, …
pub(super) fn entity_kind(input: Text) -> Parsed<EntityKind> {
    let (rest, first) = word(input)?;
    let second = word(rest).ok();
    let kind = match (first, second) {
        ("Line" | "Curve", Some((rest, "Loop"))) => return Ok((rest, EntityKind::CurveLoop)),
        ("Plane", Some((rest, "Surface"))) => return Ok((rest, EntityKind::PlaneSurface)),
        ("Ruled", Some((rest, "Surface"))) => return Ok((rest, EntityKind::Patch)),
        ("Surface", Some((rest, "Filling"))) => return Ok((rest, EntityKind::Patch)),
        ("Point", _) => EntityKind::Point,
        ("Line" | "Curve", _) => EntityKind::Line,
        ("Circle", _) => EntityKind::Circle,
        ("Ellipse" | "Ellipsis", _) => EntityKind::Ellipse,
        ("Spline", _) => EntityKind::Spline,
        ("BSpline", _) => EntityKind::BSpline,
        ("Bezier", _) => EntityKind::Bezier,
        ("Surface", _) => EntityKind::Patch,
        ("Rectangle", _) => EntityKind::Rectangle,
        ("Disk", _) => EntityKind::Disk,
        ("Wire", _) => EntityKind::Wire,
        _ => return input.no("a kind of entity"),
    };
    Ok((rest, kind))
}

pub(super) fn entity(input: Text, kind: EntityKind) -> Parsed<Action> {
    let (rest, ()) = must("(")(input)?;
    let (rest, tag) = must_item(rest.deeper()?)?;
    let (rest, ()) = must(")")(rest)?;
    let (rest, ()) = must("=")(rest.as_deep_as(input))?;
    let (mut rest, value) = must_item(rest)?;
    // `Circle(1) = {1, 2, 3} Plane {0, 0, 1};`, `Surface(1) = {1} In Sphere {1};`, `… Using …`
    if matches!(word(rest), Ok((_, "Plane" | "In" | "Using"))) {
        rest = passed_over(rest, Until::BeforeSemicolon)?.0;
    }
    Ok((rest, Action::Entity { kind, tag, value }))
}

pub(super) fn physical(input: Text) -> Parsed<Action> {
    let (rest, dim) = dimension(input).or_else(|_| input.must("Point, Curve or Surface"))?;
    let (rest, ()) = must("(")(rest)?;
    let (rest, first) = must_item(rest.deeper()?)?;
    let (rest, second) = opt(symbol(",").and(must_item)).parse(rest)?;
    let (rest, ()) = must(")")(rest)?;
    let (name, tag) = match second {
        Some(((), tag)) => (Some(first), Some(tag)),
        // Whether it is a name or a number is known when it has a value.
        None => (Some(first), None),
    };
    let (rest, operator) = assignment(rest.as_deep_as(input))?;
    let (rest, members) = must_item(rest)?;
    Ok((rest, Action::Physical { dim, name, tag, operator, members }))
}

pub(super) fn size(input: Text) -> Parsed<Action> {
    let (rest, points) = all_or_list(input, 0)?;
    let (rest, ()) = must("=")(rest)?;
    let (rest, size) = must_item(rest)?;
    Ok((rest, Action::Size { points, size }))
}

/// A transfinite curve; transfinite surfaces and volumes are passed over.
pub(super) fn transfinite(input: Text) -> Parsed<Action> {
    let (rest, what) = word(input).or_else(|_| input.must("Curve or Surface"))?;
    if !matches!(what, "Curve" | "Line") {
        let (rest, ()) = passed_over(input, Until::Semicolon)?;
        return Ok((rest, Action::Skipped(format!("Transfinite {what}"))));
    }
    let (rest, curves) = all_or_list(rest, 1)?;
    let (rest, ()) = must("=")(rest)?;
    let (mut rest, points) = must_item(rest)?;
    let mut law = None;
    if let Ok((after, ())) = keyword("Using")(rest) {
        let (after, how) = word(after).or_else(|_| after.must("Progression or Bump"))?;
        let (after, coefficient) = expression(after)?;
        rest = after;
        law = match how {
            "Progression" | "Power" => Some((Law::Progression, coefficient)),
            "Bump" => Some((Law::Bump, coefficient)),
            _ => None,
        };
    }
    let (rest, ()) = must(";")(rest)?;
    Ok((rest, Action::Transfinite { curves, points, law }))
}

pub(super) fn embed(input: Text, dim: u8) -> Parsed<Action> {
    let (rest, members) = must_item(input)?;
    let (rest, ()) = keyword("In")(rest).or_else(|_| rest.must("`In`"))?;
    let (after, target) = dimension(rest).or_else(|_| rest.must("`Surface`"))?;
    let (after, surfaces) = must_item(after)?;
    if target != 2 {
        return Ok((after, Action::Unsupported(format!("{} In Volume", title(input)))));
    }
    Ok((after, Action::Embed { dim, members, surfaces }))
}

pub(super) fn coherence(input: Text) -> Parsed<Action> {
    if let Ok((rest, ())) = symbol(";")(input) {
        return Ok((rest, Action::Coherence));
    }
    let (rest, ()) = passed_over(input, Until::Semicolon)?;
    Ok((rest, Action::Skipped("Coherence Mesh".to_owned())))
}

pub(super) fn factory(input: Text) -> Parsed<Action> {
    let (rest, ()) = must("(")(input)?;
    let (rest, name) = must_item(rest)?;
    let (rest, ()) = must(")")(rest)?;
    Ok((rest, Action::Factory(name)))
}

/// `Recursive Delete {…}`; `Recursive Color`, `Recursive Hide` are passed over.
pub(super) fn recursive(input: Text) -> Parsed<Action> {
    match word(input) {
        Ok((rest, "Delete")) => delete(rest, true),
        _ => {
            let (rest, ()) = passed_over(input, Until::Block)?;
            Ok((rest, Action::Skipped(title(input))))
        }
    }
}

pub(super) fn delete(input: Text, recursive: bool) -> Parsed<Action> {
    if symbol("{")(input).is_ok() {
        let (rest, shapes) = shapes(input)?;
        let rest = symbol(";")(rest).map_or(rest, |(rest, ())| rest);
        return Ok((rest, Action::Delete { shapes, recursive }));
    }
    let (rest, ()) = passed_over(input, Until::Semicolon)?;
    Ok((
        rest,
        match word(input) {
            Ok((_, "Physicals")) => Action::DeletePhysicals,
            Ok((_, what)) => Action::Unsupported(format!("Delete {what}")),
            Err(_) => Action::Unsupported("Delete".to_owned()),
        },
    ))
}
