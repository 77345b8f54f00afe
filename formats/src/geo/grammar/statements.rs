//! The grammar of statements.
//!
//! ```text
//! script      := statement*
//! statement   := assignment ';' | option ';' | define ';' | entity ';' | physical ';' | size ';'
//!              | transfinite ';' | embed ';' | command [';'] | delete [';'] | 'Coherence' ';'
//!              | 'SetFactory' '(' item ')' ';' | if | for | macro | 'Call' item ';'
//!              | ('Include' | 'Merge') item [';'] | fail ';' | 'Exit' ';' | skipped | ';'
//! assignment  := target ('=' | '+=' | '-=' | '*=' | '/=') item | target ('++' | '--')
//! target      := name ['[' [item] ']' | '(' [item] ')']
//! option      := ('Mesh' | 'Geometry') ('.' word)+ '=' item
//! define      := 'DefineConstant' '[' [constant ([','] constant)*] ']'
//! constant    := target ['=' ('{' item options '}' | item)]
//! entity      := kind '(' item ')' '=' item
//! physical    := 'Physical' dimension '(' item [',' item] ')' ('=' | '+=' | '-=') item
//! size        := ('MeshSize' | 'Characteristic' 'Length') all-or-list '=' item
//! transfinite := 'Transfinite' ('Curve' | 'Line') all-or-list '=' item ['Using' word item]
//! embed       := dimension list 'In' 'Surface' list
//! delete      := ['Recursive'] 'Delete' shapes | 'Delete' 'Physicals'
//! if          := 'If' '(' item ')' statement* ('ElseIf' '(' item ')' statement*)*
//!                ['Else' statement*] 'EndIf'
//! for         := 'For' (word 'In' '{' range '}' | '(' range ')') statement* 'EndFor'
//! macro       := ('Macro' | 'Function') word statement* 'Return'
//! fail        := 'Error' '(' items ')' | 'Abort'
//! ```
//!
//! Statements about display, fields, structured meshes, periodicity and files have no effect on a
//! plane mesh; they are passed over up to their `;` or closing brace. So is a statement that is
//! not known: it becomes an error only where the script reaches it.

use super::assignments::{assignment_or_unknown, define, option, option_name};
use super::commands::command;
use super::control::{call, fail, for_statement, if_statement, include, macro_statement};
use super::entities::{
    coherence, delete, embed, entity, entity_kind, factory, physical, recursive, size, transfinite,
};
use super::expressions::dimension;
use super::input::{Parsed, Text};
use super::skipping::{is_skipped, is_solid, title};
use super::tokens::{Until, blank, keyword, must, passed_over, symbol, word};
use crate::geo::syntax::{Action, Statement};

/// The next statement; nothing at the end of the script.
pub(crate) fn next_statement(input: Text) -> Parsed<Option<Statement>> {
    let begin = blank(input)?;
    if begin.rest.is_empty() {
        return Ok((begin, None));
    }
    let (rest, statement) = statement(begin)?;
    Ok((rest, Some(statement)))
}

pub(super) fn statement(input: Text) -> Parsed<Statement> {
    let begin = blank(input)?;
    let (rest, action) = action(begin)?;
    Ok((rest, Statement { place: begin.place(), action }))
}

fn action(input: Text) -> Parsed<Action> {
    if let Ok((rest, ())) = symbol(";")(input) {
        return Ok((rest, Action::Skipped(";".to_owned())));
    }
    let Ok((rest, first)) = word(input) else {
        return input.must("a statement");
    };
    match first {
        "If" => if_statement(input),
        "For" => for_statement(input),
        "Macro" | "Function" => macro_statement(input),
        "Return" | "Else" | "ElseIf" | "EndIf" | "EndFor" => {
            input.must("a statement (nothing is open that this would end)")
        }
        "Call" => ended(call, rest),
        "Include" | "Merge" => include(rest, first == "Merge"),
        "Exit" => ended(|rest| Ok((rest, Action::Exit)), rest),
        "Abort" => ended(|rest| Ok((rest, Action::Fail(None))), rest),
        "Error" => ended(fail, rest),
        "Coherence" => coherence(rest),
        "SetFactory" => ended(factory, rest),
        "DefineConstant" => ended(define, rest),
        "Physical" => ended(physical, rest),
        "MeshSize" => ended(size, rest),
        "Characteristic" => {
            let (rest, ()) = keyword("Length")(rest).or_else(|_| rest.must("`Length`"))?;
            ended(size, rest)
        }
        "Transfinite" => transfinite(rest),
        "Recursive" => recursive(rest),
        "Delete" => delete(rest, false),
        "Translate"
        | "Rotate"
        | "Symmetry"
        | "Dilate"
        | "Extrude"
        | "Duplicata"
        | "Boundary"
        | "CombinedBoundary"
        | "PointsOf"
        | "BooleanDifference"
        | "BooleanUnion"
        | "BooleanIntersection"
        | "BooleanFragments"
        | "Affine"
        | "Split"
        | "Intersect" => {
            let (rest, command) = command(input)?;
            let rest = symbol(";")(rest).map_or(rest, |(rest, ())| rest);
            Ok((rest, Action::Command(command)))
        }
        _ => entity_or_other(input, first),
    }
}

/// What a parser reads, and the `;` after it.
fn ended<'a>(
    parser: impl FnOnce(Text<'a>) -> Parsed<'a, Action>,
    input: Text<'a>,
) -> Parsed<'a, Action> {
    let (rest, action) = parser(input)?;
    let (rest, ()) = must(";")(rest)?;
    Ok((rest, action))
}

/// Statements that begin with a kind of entity, or with a word of their own.
fn entity_or_other<'a>(input: Text<'a>, first: &str) -> Parsed<'a, Action> {
    if let Ok((rest, kind)) = entity_kind(input)
        && symbol("(")(rest).is_ok()
    {
        return ended(|rest| entity(rest, kind), rest);
    }
    if let Ok((rest, dim)) = dimension(input)
        && symbol("{")(rest).is_ok()
    {
        return ended(|rest| embed(rest, dim), rest);
    }
    // `Compound Curve {1, 2};` is about the mesh, `Compound Line(3) = {1, 2};` makes a curve.
    if first == "Compound"
        && let Ok((rest, _)) = word(input).and_then(|(rest, _)| word(rest))
        && symbol("{")(rest).is_ok()
    {
        let (rest, ()) = passed_over(input, Until::Semicolon)?;
        return Ok((rest, Action::Skipped(title(input))));
    }
    if is_solid(first) {
        let (rest, ()) = passed_over(input, Until::Semicolon)?;
        return Ok((rest, Action::Unsupported(title(input))));
    }
    if let Some(until) = is_skipped(input, first) {
        let (rest, ()) = passed_over(input, until)?;
        return Ok((rest, Action::Skipped(title(input))));
    }
    if let Ok((rest, name)) = option_name(input) {
        return option(input, rest, name);
    }
    assignment_or_unknown(input)
}
