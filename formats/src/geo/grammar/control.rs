//! The grammar of what decides which statements run: branches, loops, macros, other files, ends.

use nom::Err;

use super::expressions::must_item;
use super::input::{Fault, Parsed, Text};
use super::statements::statement;
use super::tokens::{at_end, blank, keyword, must, symbol, text, word};
use crate::geo::syntax::{Action, Block, Expression, Term};

pub(super) fn call(input: Text) -> Parsed<Action> {
    let begin = blank(input)?;
    let (rest, name) = match word(begin) {
        Ok((rest, name)) if symbol(";")(rest).is_ok() => {
            (rest, Expression { place: begin.place(), term: Term::Text(name.to_owned()) })
        }
        _ => must_item(begin)?,
    };
    Ok((rest, Action::Call(name)))
}

pub(super) fn include(input: Text, merge: bool) -> Parsed<Action> {
    let (rest, name) = must_item(input)?;
    let (rest, ()) = match symbol(";")(rest) {
        Ok(answer) => answer,
        Err(_) => (rest, ()),
    };
    Ok((rest, Action::Include { name, merge }))
}

pub(super) fn fail(input: Text) -> Parsed<Action> {
    let (rest, ()) = must("(")(input)?;
    let (rest, first) = must_item(rest.deeper()?)?;
    let mut parts = vec![first];
    let mut rest = rest;
    while let Ok((after, ())) = symbol(",")(rest) {
        let (after, part) = must_item(after)?;
        parts.push(part);
        rest = after;
    }
    let (rest, ()) = must(")")(rest)?;
    Ok((rest.as_deep_as(input), Action::Fail(Some(parts))))
}

pub(super) fn if_statement(input: Text) -> Parsed<Action> {
    let mut branches = Vec::new();
    let mut rest = input;
    loop {
        let (after, _) = word(rest)?; // If, ElseIf
        let (after, ()) = must("(")(after)?;
        let (after, condition) = must_item(after.deeper()?)?;
        let (after, ()) = must(")")(after)?;
        let (after, body) = block(after.as_deep_as(input))?;
        branches.push((condition, body));
        rest = after;
        match word(rest) {
            Ok((_, "ElseIf")) => {}
            Ok((after, "Else")) => {
                let (after, otherwise) = block(after)?;
                return match word(after) {
                    Ok((after, "EndIf")) => Ok((after, Action::If { branches, otherwise })),
                    _ => never_ends(input, after, ["If", "EndIf"]),
                };
            }
            Ok((after, "EndIf")) => {
                return Ok((after, Action::If { branches, otherwise: Block::default() }));
            }
            _ => return never_ends(input, rest, ["If", "EndIf"]),
        }
    }
}

pub(super) fn for_statement(input: Text) -> Parsed<Action> {
    let (rest, ()) = keyword("For")(input)?;
    let (rest, variable, close) = match symbol("(")(rest) {
        Ok((rest, ())) => (rest, None, ")"),
        Err(_) => {
            let (rest, name) = word(rest).or_else(|_| rest.must("a name, or `(`"))?;
            let (rest, ()) = keyword("In")(rest).or_else(|_| rest.must("`In`"))?;
            let (rest, ()) = must("{")(rest)?;
            (rest, Some(name.to_owned()), "}")
        }
    };
    let begin = blank(rest)?;
    let (rest, range) = must_item(begin.deeper()?)?;
    let (rest, ()) = must(close)(rest)?;
    let Term::Range(ends, step) = range.term else {
        return begin.must("a range such as `1:10`");
    };
    let [first, last] = *ends;
    let step = step.map(|step| *step);
    let (rest, body) = block(rest.as_deep_as(input))?;
    match word(rest) {
        Ok((rest, "EndFor")) => Ok((rest, Action::For { variable, first, last, step, body })),
        _ => never_ends(input, rest, ["For", "EndFor"]),
    }
}

pub(super) fn macro_statement(input: Text) -> Parsed<Action> {
    let (rest, _) = word(input)?; // Macro, Function
    let (rest, name) = match text(rest) {
        Ok(answer) => answer,
        Err(_) => {
            let (rest, name) = word(rest).or_else(|_| rest.must("the name of a macro"))?;
            (rest, name.to_owned())
        }
    };
    let (rest, body) = block(rest)?;
    match word(rest) {
        Ok((rest, "Return")) => Ok((rest, Action::Macro { name, body })),
        _ => never_ends(input, rest, ["Macro", "Return"]),
    }
}

/// Statements up to a word that ends them, which is left.
fn block(input: Text) -> Parsed<Block> {
    let mut rest = input.deeper()?;
    let mut statements = Vec::new();
    while !at_end(rest)? {
        if let Ok((_, "EndIf" | "Else" | "ElseIf" | "EndFor" | "Return")) = word(rest) {
            break;
        }
        let (after, statement) = statement(rest)?;
        statements.push(statement);
        rest = after;
    }
    Ok((rest.as_deep_as(input), statements.into()))
}

/// A block that begins at `input` and has not ended where something else stands.
fn never_ends<'a, T>(input: Text<'a>, rest: Text<'a>, [what, end]: [&str; 2]) -> Parsed<'a, T> {
    let expected =
        format!("`{what}` with its `{end}`, which is missing or stands in another block");
    Err(Err::Failure(Fault { is_cut_off: at_end(rest)?, ..input.fault(expected) }))
}
