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

use nom::combinator::opt;
use nom::{Err, Parser};

use super::commands::{command, shapes};
use super::expressions::{
    all_or_list, dimension, empty_brackets, expression, list, must_item, name, option_path, options,
};
use super::input::{Fault, Parsed, Text};
use super::tokens::{Until, at_end, blank, keyword, must, passed_over, symbol, text, word};
use crate::geo::syntax::{
    Action, Assignment, Block, Constant, EntityKind, Expression, Law, Statement, Target, Term,
};

/// The next statement; nothing at the end of the script.
pub(crate) fn next_statement(input: Text) -> Parsed<Option<Statement>> {
    let begin = blank(input)?;
    if begin.rest.is_empty() {
        return Ok((begin, None));
    }
    let (rest, statement) = statement(begin)?;
    Ok((rest, Some(statement)))
}

fn statement(input: Text) -> Parsed<Statement> {
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

/// `Point`, `Line Loop`, `Plane Surface`, …
fn entity_kind(input: Text) -> Parsed<EntityKind> {
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

fn entity(input: Text, kind: EntityKind) -> Parsed<Action> {
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

fn physical(input: Text) -> Parsed<Action> {
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

/// `=`, `+=`, …
fn assignment(input: Text) -> Parsed<Assignment> {
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

fn size(input: Text) -> Parsed<Action> {
    let (rest, points) = all_or_list(input, 0)?;
    let (rest, ()) = must("=")(rest)?;
    let (rest, size) = must_item(rest)?;
    Ok((rest, Action::Size { points, size }))
}

/// A transfinite curve; transfinite surfaces and volumes are passed over.
fn transfinite(input: Text) -> Parsed<Action> {
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

fn embed(input: Text, dim: u8) -> Parsed<Action> {
    let (rest, members) = must_item(input)?;
    let (rest, ()) = keyword("In")(rest).or_else(|_| rest.must("`In`"))?;
    let (after, target) = dimension(rest).or_else(|_| rest.must("`Surface`"))?;
    let (after, surfaces) = must_item(after)?;
    if target != 2 {
        return Ok((after, Action::Unsupported(format!("{} In Volume", title(input)))));
    }
    Ok((after, Action::Embed { dim, members, surfaces }))
}

fn coherence(input: Text) -> Parsed<Action> {
    if let Ok((rest, ())) = symbol(";")(input) {
        return Ok((rest, Action::Coherence));
    }
    let (rest, ()) = passed_over(input, Until::Semicolon)?;
    Ok((rest, Action::Skipped("Coherence Mesh".to_owned())))
}

fn factory(input: Text) -> Parsed<Action> {
    let (rest, ()) = must("(")(input)?;
    let (rest, name) = must_item(rest)?;
    let (rest, ()) = must(")")(rest)?;
    Ok((rest, Action::Factory(name)))
}

/// `Recursive Delete {…}`; `Recursive Color`, `Recursive Hide` are passed over.
fn recursive(input: Text) -> Parsed<Action> {
    match word(input) {
        Ok((rest, "Delete")) => delete(rest, true),
        _ => {
            let (rest, ()) = passed_over(input, Until::Block)?;
            Ok((rest, Action::Skipped(title(input))))
        }
    }
}

fn delete(input: Text, recursive: bool) -> Parsed<Action> {
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

fn call(input: Text) -> Parsed<Action> {
    let begin = blank(input)?;
    let (rest, name) = match word(begin) {
        Ok((rest, name)) if symbol(";")(rest).is_ok() => {
            (rest, Expression { place: begin.place(), term: Term::Text(name.to_owned()) })
        }
        _ => must_item(begin)?,
    };
    Ok((rest, Action::Call(name)))
}

fn include(input: Text, merge: bool) -> Parsed<Action> {
    let (rest, name) = must_item(input)?;
    let (rest, ()) = match symbol(";")(rest) {
        Ok(answer) => answer,
        Err(_) => (rest, ()),
    };
    Ok((rest, Action::Include { name, merge }))
}

fn fail(input: Text) -> Parsed<Action> {
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

fn define(input: Text) -> Parsed<Action> {
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

fn target(input: Text) -> Parsed<Target> {
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
fn option_name(input: Text) -> Parsed<String> {
    let (rest, head) = word(input)?;
    if matches!(head, "Mesh" | "Geometry") && rest.rest.starts_with(b".") {
        return option_path(rest, head.to_owned());
    }
    input.no("an option")
}

/// An option, if its value can be read; colours and the like are passed over.
fn option<'a>(input: Text<'a>, rest: Text<'a>, name: String) -> Parsed<'a, Action> {
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

fn assignment_or_unknown(input: Text) -> Parsed<Action> {
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

fn if_statement(input: Text) -> Parsed<Action> {
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
                    _ => never_ends(input, "If", "EndIf"),
                };
            }
            Ok((after, "EndIf")) => {
                return Ok((after, Action::If { branches, otherwise: Block::default() }));
            }
            _ => return never_ends(input, "If", "EndIf"),
        }
    }
}

fn for_statement(input: Text) -> Parsed<Action> {
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
        _ => never_ends(input, "For", "EndFor"),
    }
}

fn macro_statement(input: Text) -> Parsed<Action> {
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
        _ => never_ends(input, "Macro", "Return"),
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

fn never_ends<'a, T>(input: Text<'a>, what: &str, end: &str) -> Parsed<'a, T> {
    input.must(format!("`{what}` with its `{end}`, which is missing or stands in another block"))
}

/// Whether a statement that begins with this word makes something that no plane has.
fn is_solid(first: &str) -> bool {
    matches!(
        first,
        "Volume"
            | "Box"
            | "Sphere"
            | "Cylinder"
            | "Cone"
            | "Torus"
            | "Wedge"
            | "ThruSections"
            | "Ruled"
            | "Fillet"
            | "Chamfer"
            | "Nurbs"
            | "Surface"
            | "PolarSphere"
            | "ParametricSphere"
            | "Compound"
            | "SystemCall"
            | "NonBlockingSystemCall"
            | "OnelabRun"
            | "CreateTopology"
            | "CreateGeometry"
            | "ClassifySurfaces"
    )
}

/// Where a statement ends that has no effect on a plane mesh; `None` if it is none of those.
fn is_skipped(input: Text, first: &str) -> Option<Until> {
    let (rest, _) = word(input).ok()?;
    let second = word(rest).map_or("", |(_, word)| word);
    Some(match (first, second) {
        ("Color" | "Hide" | "Show" | "View", _) => Until::Block,
        ("Background" | "BoundaryLayer", "Field") => Until::Semicolon,
        // `Mesh 2;`
        ("Mesh", "") if !rest.rest.starts_with(b".") => Until::Semicolon,
        (
            "Field"
            | "Periodic"
            | "Recombine"
            | "Smoother"
            | "MeshAlgorithm"
            | "Reverse"
            | "ReverseMesh"
            | "ReorientMesh"
            | "OptimizeMesh"
            | "RefineMesh"
            | "RecombineMesh"
            | "RenumberMeshNodes"
            | "RenumberMeshElements"
            | "RelocateMesh"
            | "SetOrder"
            | "Save"
            | "Print"
            | "Printf"
            | "Warning"
            | "Draw"
            | "SetChanged"
            | "Sleep"
            | "Plugin"
            | "General"
            | "Solver"
            | "PostProcessing"
            | "Print_"
            | "TransfQuadTri"
            | "MeshSizeFromBoundary"
            | "UndefineConstant"
            | "SetNumber"
            | "SetString"
            | "Parent"
            | "BoundingBox"
            | "NewModel"
            | "Combine"
            | "Homology"
            | "Cohomology",
            _,
        ) => Until::Semicolon,
        _ => return None,
    })
}

/// The words that a statement begins with, for messages: `Color Red`, `Recombine Surface`.
fn title(input: Text) -> String {
    let Ok((mut rest, first)) = word(input) else { return String::new() };
    let mut title = first.to_owned();
    if rest.rest.starts_with(b".") {
        return option_path(rest, title.clone()).map_or(title, |(_, path)| path);
    }
    if matches!(first, "Color" | "Hide" | "Show" | "View" | "Field" | "Printf" | "Print") {
        return title;
    }
    while let Ok((after, next)) = word(rest) {
        title = format!("{title} {next}");
        rest = after;
    }
    title
}
