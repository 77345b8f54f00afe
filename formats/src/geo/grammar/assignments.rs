//! The grammar of assignments: to variables, lists and options.

use nom::Err;

use super::expressions::{empty_brackets, list, must_item, name, option_path, options};
use super::input::{Fault, Parsed, Text};
use super::skipping::title;
use super::tokens::{Until, blank, must, passed_over, symbol, word};
use crate::geo::syntax::{Action, Assignment, Constant, Expression, Target, Term};

/// `=`, `+=`, …
pub(super) fn assignment(input: Text) -> Parsed<Assignment> {
    let symbols = [
        ("=", Assignment::Set),
        ("+=", Assignment::Add),
        ("-=", Assignment::Subtract),
        ("*=", Assignment::Multiply),
        ("/=", Assignment::Divide),
    ];
    for (text, assignment) in symbols {
        if let Ok((rest, ())) = symbol(text)(input) {
            return Ok((rest, assignment));
        }
    }
    blank(input)?.must("`=`")
}

pub(super) fn define(input: Text) -> Parsed<Action> {
    let (rest, close) = match symbol("[")(input) {
        Ok((rest, ())) => (rest, "]"),
        Err(_) => (must("(")(input)?.0, ")"),
    };
    let mut rest = rest.deeper()?;
    let mut constants = Vec::new();
    loop {
        if let Ok((after, ())) = symbol(close)(rest) {
            return Ok((after.as_deep_as(input), Action::Define(constants)));
        }
        let (after, constant) = constant(rest)?;
        constants.push(constant);
        rest = symbol(",")(after).map_or(after, |(after, ())| after);
    }
}

fn constant(input: Text) -> Parsed<Constant> {
    let (rest, target) = target(input).or_else(|_| blank(input)?.must("the name of a constant"))?;
    let Ok((rest, ())) = symbol("=")(rest) else {
        return Ok((rest, Constant { target, value: None }));
    };
    let Ok((inner, ())) = symbol("{")(rest) else {
        let (rest, value) = must_item(rest)?;
        return Ok((rest, Constant { target, value: Some(value) }));
    };
    // `{1, Name "x"}` is a value and what a dialog shows; `{1, 2}` is a list.
    if let Ok((after, items)) = list(rest) {
        let place = blank(rest)?.place();
        let value = match <[Expression; 1]>::try_from(items) {
            Ok([value]) if !matches!(target, Target::Whole(_)) => value,
            Ok([value]) => Expression { place, term: Term::List(vec![value]) },
            Err(items) => Expression { place, term: Term::List(items) },
        };
        return Ok((after, Constant { target, value: Some(value) }));
    }
    let (after, value) = must_item(inner.deeper()?)?;
    let (after, ()) = options(after)?;
    let (after, ()) = must("}")(after)?;
    Ok((after.as_deep_as(input), Constant { target, value: Some(value) }))
}

pub(super) fn target(input: Text) -> Parsed<Target> {
    let (rest, name) = name(input)?;
    if let Ok((rest, ())) = empty_brackets(rest) {
        return Ok((rest, Target::Whole(name)));
    }
    let (after, close) = match (symbol("[")(rest), symbol("(")(rest)) {
        (Ok((after, ())), _) => (after, "]"),
        (_, Ok((after, ()))) => (after, ")"),
        _ => return Ok((rest, Target::Variable(name))),
    };
    let (after, index) = must_item(after.deeper()?)?;
    let (after, ()) = must(close)(after)?;
    Ok((after.as_deep_as(input), Target::Elements(name, index)))
}

/// `Mesh.MeshSizeMax`, `Geometry.Tolerance`
pub(super) fn option_name(input: Text) -> Parsed<String> {
    let (rest, head) = word(input)?;
    if matches!(head, "Mesh" | "Geometry") && rest.rest.starts_with(b".") {
        return option_path(rest, head.to_owned());
    }
    input.no("an option")
}

/// An option, if its value can be read; colours and the like are passed over.
pub(super) fn option<'a>(input: Text<'a>, rest: Text<'a>, name: String) -> Parsed<'a, Action> {
    let value = |rest| -> Parsed<'a, Action> {
        let (rest, operator) = assignment(rest)?;
        let (rest, value) = must_item(rest)?;
        let (rest, ()) = must(";")(rest)?;
        Ok((rest, Action::Option { name: name.clone(), operator, value }))
    };
    value(rest).or_else(|_| {
        let (rest, ()) = passed_over(input, Until::Semicolon)?;
        Ok((rest, Action::Skipped(name.clone())))
    })
}

pub(super) fn assignment_or_unknown(input: Text) -> Parsed<Action> {
    let (rest, target) = match target(input) {
        Ok(answer) => answer,
        Err(error) => return unknown(input, error),
    };
    for (text, operator) in [("++", Assignment::Add), ("--", Assignment::Subtract)] {
        if let Ok((after, ())) = symbol(text)(rest) {
            let value = Expression { place: input.place(), term: Term::Number(1.0) };
            let (after, ()) = must(";")(after)?;
            return Ok((after, Action::Assign { target, operator, value }));
        }
    }
    let (rest, operator) = match assignment(rest) {
        Ok(answer) => answer,
        Err(error) => return unknown(input, error),
    };
    let (rest, value) = must_item(rest)?;
    let (rest, ()) = must(";")(rest)?;
    Ok((rest, Action::Assign { target, operator, value }))
}

/// A statement of an unknown kind, if it looks like one: two words, or a word and a bracket.
/// Anything else is no statement at all.
fn unknown(input: Text, error: Err<Fault>) -> Parsed<Action> {
    let (rest, _) = word(input)?;
    let after = blank(rest)?;
    if word(after).is_err() && !matches!(after.rest.first(), Some(b'(' | b'{' | b'"')) {
        return Err(error);
    }
    let (rest, ()) = passed_over(input, Until::Semicolon)?;
    Ok((rest, Action::Unsupported(title(input))))
}
