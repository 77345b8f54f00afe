//! The grammar of expressions: numbers, lists and texts alike.
//!
//! ```text
//! item       := choice [to choice [to choice]]         to is ':' or '...'
//! choice     := operation ['?' choice ':' choice]
//! operation  := unary (operator operation)*            by precedence, see `OPERATORS`
//! unary      := ('-' | '+' | '!') unary | power
//! power      := primary ['^' unary]
//! primary    := number | text | '(' item ')' | list | count | named
//! list       := '{' [item (',' item)*] '}'
//! count      := '#' name ('[' ']' | '(' ')')
//! named      := constant | call | entities | command | variable
//! call       := function arguments                     arguments in (…) or […]
//! variable   := name [suffix]
//! name       := word ('~' '{' item '}')*
//! suffix     := '[' ']' | '(' ')' | '[' item ']' | '(' item ')' | '++' | '--' | '.' word …
//! entities   := ['Physical'] dimension '{' item '}' | dimension ('{' ':' '}' | '"*"')
//!             | dimension 'In' 'BoundingBox' list
//! dimension  := 'Point' | 'Curve' | 'Line' | 'Surface' | 'Volume'
//! ```

use nom::branch::alt;
use nom::combinator::opt;
use nom::multi::{many0, separated_list0};
use nom::{Err, Parser};

use super::commands::command;
use super::input::{Parsed, Text};
use super::tokens::{self, Until, blank, keyword, must, passed_over, symbol, word};
use crate::geo::syntax::{Expression, Fresh, Function, Name, Operator, Term};

/// Binary operators from the weakest to the strongest; longer symbols first.
const OPERATORS: [(&str, Operator, u8); 13] = [
    ("||", Operator::Or, 1),
    ("&&", Operator::And, 2),
    ("==", Operator::Equal, 3),
    ("!=", Operator::NotEqual, 3),
    ("<=", Operator::LessOrEqual, 4),
    (">=", Operator::GreaterOrEqual, 4),
    ("<", Operator::Less, 4),
    (">", Operator::Greater, 4),
    ("+", Operator::Add, 5),
    ("-", Operator::Subtract, 5),
    ("*", Operator::Multiply, 6),
    ("/", Operator::Divide, 6),
    ("%", Operator::Remainder, 6),
];

/// An element of a list: an expression or a range.
pub(super) fn item(input: Text) -> Parsed<Expression> {
    if let Some((rest, number)) = lone_number(input) {
        return Ok((rest, number));
    }
    let (rest, first) = choice(input)?;
    let Ok((rest, ())) = to(rest) else {
        return Ok((rest, first));
    };
    let (rest, last) = expression(rest)?;
    let (rest, step) = match to(rest) {
        Ok((rest, ())) => {
            let (rest, step) = expression(rest)?;
            (rest, Some(Box::new(step)))
        }
        Err(_) => (rest, None),
    };
    let place = first.place;
    Ok((rest, Expression { place, term: Term::Range(Box::new([first, last]), step) }))
}

/// A number, with or without a minus, that is the whole item: what most items are, seen at once.
fn lone_number(input: Text) -> Option<(Text, Expression)> {
    let begin = blank(input).ok()?;
    let is_negative = begin.rest.first() == Some(&b'-');
    let digits = if is_negative { begin.after(1) } else { begin };
    if !matches!(digits.rest.first(), Some(b'0'..=b'9' | b'.')) {
        return None;
    }
    let (rest, number) = tokens::number(digits).ok()?;
    if !matches!(rest.rest.first(), Some(b',' | b'}' | b')' | b';')) {
        return None;
    }
    let number = if is_negative { -number } else { number };
    Some((rest, Expression { place: begin.place(), term: Term::Number(number) }))
}

/// What stands between the ends of a range.
fn to(input: Text) -> Parsed<()> {
    alt((symbol(":"), symbol("..."))).parse(input)
}

/// An expression that must come next.
pub(super) fn expression(input: Text) -> Parsed<Expression> {
    wanted(choice(input), input)
}

/// An item that must come next.
pub(super) fn must_item(input: Text) -> Parsed<Expression> {
    wanted(item(input), input)
}

/// An answer; where it is none, an expression must stand at `input`.
fn wanted<'a>(answer: Parsed<'a, Expression>, input: Text<'a>) -> Parsed<'a, Expression> {
    match answer {
        Err(Err::Error(_)) => blank(input)?.must("an expression"),
        answer => answer,
    }
}

fn choice(input: Text) -> Parsed<Expression> {
    let (rest, condition) = operation(input, 1)?;
    let Ok((rest, ())) = symbol("?")(rest) else {
        return Ok((rest, condition));
    };
    let (rest, yes) = expression(rest.deeper()?)?;
    let (rest, ()) = must(":")(rest)?;
    let (rest, no) = expression(rest)?;
    let place = condition.place;
    let term = Term::Choice(Box::new([condition, yes, no]));
    Ok((rest.as_deep_as(input), Expression { place, term }))
}

/// Operators of at least this precedence.
fn operation(input: Text, least: u8) -> Parsed<Expression> {
    let (mut rest, mut left) = unary(input)?;
    while let Ok((after, (operator, precedence))) = operator(rest) {
        if precedence < least {
            break;
        }
        let (after, right) = wanted(operation(after, precedence + 1), after)?;
        let place = left.place;
        left = Expression { place, term: Term::Binary(operator, Box::new([left, right])) };
        rest = after;
    }
    Ok((rest, left))
}

fn operator(input: Text) -> Parsed<(Operator, u8)> {
    let begin = blank(input)?;
    let found = OPERATORS.iter().find(|(symbol, ..)| begin.rest.starts_with(symbol.as_bytes()));
    match found {
        // `a += 1` and `a++` are no operations.
        Some(("+" | "-" | "*" | "/", ..)) if begin.rest.get(1) == Some(&b'=') => {
            begin.no("an operator")
        }
        Some(&(symbol, operator, precedence)) => {
            Ok((begin.after(symbol.len()), (operator, precedence)))
        }
        None => begin.no("an operator"),
    }
}

fn unary(input: Text) -> Parsed<Expression> {
    let begin = blank(input)?;
    let place = begin.place();
    let wrap: fn(Box<Expression>) -> Term = match begin.rest.first() {
        Some(b'-') => Term::Negative,
        Some(b'!') => Term::Not,
        Some(b'+') => |operand| operand.term,
        _ => return power(begin),
    };
    let inner = begin.after(1).deeper()?;
    let (rest, operand) = wanted(unary(inner), inner)?;
    Ok((rest.as_deep_as(input), Expression { place, term: wrap(Box::new(operand)) }))
}

fn power(input: Text) -> Parsed<Expression> {
    let (rest, base) = primary(input)?;
    let Ok((rest, ())) = symbol("^")(rest) else {
        return Ok((rest, base));
    };
    let inner = rest.deeper()?;
    let (rest, exponent) = wanted(unary(inner), inner)?;
    let place = base.place;
    let term = Term::Binary(Operator::Power, Box::new([base, exponent]));
    Ok((rest.as_deep_as(input), Expression { place, term }))
}

fn primary(input: Text) -> Parsed<Expression> {
    let begin = blank(input)?;
    let place = begin.place();
    let (rest, term) = match begin.rest.first() {
        Some(b'0'..=b'9' | b'.') => {
            let (rest, number) = tokens::number(begin)?;
            (rest, Term::Number(number))
        }
        Some(b'"' | b'\'') => {
            let (rest, text) = tokens::text(begin)?;
            (rest, Term::Text(text))
        }
        Some(b'(') => return enclosed(begin.after(1), ")"),
        Some(b'{') => {
            let (rest, items) = list(begin)?;
            (rest, Term::List(items))
        }
        Some(b'#') => count(begin.after(1))?,
        _ => named(begin)?,
    };
    Ok((rest, Expression { place, term }))
}

/// An item and the bracket that closes it.
fn enclosed<'a>(input: Text<'a>, close: &'static str) -> Parsed<'a, Expression> {
    let (rest, inner) = must_item(input.deeper()?)?;
    let (rest, ()) = must(close)(rest)?;
    Ok((rest.as_deep_as(input), inner))
}

/// `{ item, item }`
pub(super) fn list(input: Text) -> Parsed<Vec<Expression>> {
    let (rest, ()) = symbol("{")(input)?;
    items(rest, "}")
}

/// Items up to a closing bracket, and the bracket.
fn items<'a>(input: Text<'a>, close: &'static str) -> Parsed<'a, Vec<Expression>> {
    let (rest, items) = separated_list0(symbol(","), item).parse(input.deeper()?)?;
    let (rest, ()) = match symbol(close)(rest) {
        Ok(answer) => answer,
        Err(_) => return blank(rest)?.must(format!("`,` or `{close}`")),
    };
    Ok((rest.as_deep_as(input), items))
}

fn count(input: Text) -> Parsed<Term> {
    let (rest, name) = must_name(input)?;
    let (rest, ()) = empty_brackets(rest).or_else(|_| rest.must("`[]`"))?;
    Ok((rest, Term::Count(name)))
}

/// `[]` or `()`
pub(super) fn empty_brackets(input: Text) -> Parsed<()> {
    let square = (symbol("["), symbol("]"));
    let round = (symbol("("), symbol(")"));
    let (rest, _) = alt((square, round)).parse(input)?;
    Ok((rest, ()))
}

/// A variable's name with its computed ends.
pub(super) fn name(input: Text) -> Parsed<Name> {
    let begin = blank(input)?;
    let (rest, base) = word(begin)?;
    let (rest, suffixes) = many0(name_suffix).parse(rest)?;
    Ok((rest, Name { place: begin.place(), base: base.to_owned(), suffixes }))
}

fn must_name(input: Text) -> Parsed<Name> {
    match name(input) {
        Err(Err::Error(_)) => blank(input)?.must("the name of a variable"),
        answer => answer,
    }
}

fn name_suffix(input: Text) -> Parsed<Expression> {
    let (rest, ()) = symbol("~")(input)?;
    let (rest, ()) = must("{")(rest)?;
    enclosed(rest, "}")
}

/// What begins with a word.
fn named(input: Text) -> Parsed<Term> {
    let (rest, first) = word(input)?;
    if let Some(term) = constant(first) {
        return Ok((rest, term));
    }
    match first {
        "DefineNumber" | "DefineString" => return defined(rest, false),
        "GetNumber" | "GetString" | "GetValue" => return defined(rest, true),
        "Exists" => return exists(rest),
        "Physical" => {
            let (rest, dim) = dimension(rest)?;
            let (rest, ()) = must("{")(rest)?;
            let (rest, tags) = enclosed(rest, "}")?;
            return Ok((rest, Term::Members(dim, Box::new(tags))));
        }
        _ => {}
    }
    if let Ok((rest, dim)) = dimension(input) {
        return entities(rest, dim);
    }
    if let Some(function) = function(first)
        && let Ok((rest, arguments)) = arguments(rest)
    {
        return Ok((rest, Term::Call(function, arguments)));
    }
    match command(input) {
        Err(Err::Error(_)) => variable(input),
        answer => answer.map(|(rest, command)| (rest, Term::Command(Box::new(command)))),
    }
}

/// A number that has a name, or a counter.
fn constant(word: &str) -> Option<Term> {
    Some(match word {
        "Pi" => Term::Number(std::f64::consts::PI),
        "MPI_Rank" => Term::Number(0.0),
        "MPI_Size" => Term::Number(1.0),
        // The version whose language is read here.
        "GMSH_MAJOR_VERSION" => Term::Number(4.0),
        "GMSH_MINOR_VERSION" => Term::Number(15.0),
        "GMSH_PATCH_VERSION" => Term::Number(0.0),
        "newp" => Term::Fresh(Fresh::Point),
        "newl" | "newc" => Term::Fresh(Fresh::Curve),
        "newll" | "newcl" => Term::Fresh(Fresh::CurveLoop),
        "news" => Term::Fresh(Fresh::Surface),
        "newsl" | "newv" | "newf" => Term::Fresh(Fresh::Solid),
        "newreg" => Term::Fresh(Fresh::Region),
        _ => return None,
    })
}

/// `DefineNumber[value, Name "…", Min 0]`; `GetNumber["…", value]`.
fn defined(input: Text, is_named: bool) -> Parsed<Term> {
    let (rest, close) = open_bracket(input)?;
    let rest = rest.deeper()?;
    let (mut rest, mut value) = must_item(rest)?;
    if is_named {
        let place = value.place;
        value = Expression { place, term: Term::Number(0.0) };
        if let Ok((after, ())) = symbol(",")(rest) {
            (rest, value) = must_item(after)?;
        }
    }
    let (rest, ()) = options(rest)?;
    let (rest, ()) = must(close)(rest)?;
    Ok((rest.as_deep_as(input), Term::Default(Box::new(value))))
}

/// `, Name "…", Choices {0, 1}`: what only a dialog shows.
pub(super) fn options(mut input: Text) -> Parsed<()> {
    while let Ok((rest, ())) = symbol(",")(input) {
        input = passed_over(rest, Until::Bracket)?.0;
    }
    Ok((input, ()))
}

fn exists(input: Text) -> Parsed<Term> {
    let (rest, close) = open_bracket(input)?;
    let (rest, name) = must_name(rest)?;
    let (rest, _) = opt(empty_brackets).parse(rest)?;
    let (rest, ()) = must(close)(rest)?;
    Ok((rest, Term::Exists(name)))
}

/// `(` or `[`, and what closes it.
fn open_bracket(input: Text) -> Parsed<&'static str> {
    let round = symbol("(").map(|()| ")");
    let square = symbol("[").map(|()| "]");
    alt((round, square)).parse(input)
}

fn arguments(input: Text) -> Parsed<Vec<Expression>> {
    let (rest, close) = open_bracket(input)?;
    items(rest, close)
}

/// The dimension that a word names.
pub(super) fn dimension(input: Text) -> Parsed<u8> {
    let (rest, word) = word(input)?;
    match word {
        "Point" => Ok((rest, 0)),
        "Curve" | "Line" => Ok((rest, 1)),
        "Surface" => Ok((rest, 2)),
        "Volume" => Ok((rest, 3)),
        _ => blank(input)?.no("Point, Curve, Surface or Volume"),
    }
}

/// What stands after a dimension, in an expression.
fn entities(input: Text, dim: u8) -> Parsed<Term> {
    if let Ok((rest, ())) = all(input) {
        return Ok((rest, Term::All(dim)));
    }
    if let Ok((rest, ())) = keyword("In")(input) {
        let (rest, ()) = keyword("BoundingBox")(rest).or_else(|_| rest.must("`BoundingBox`"))?;
        let (rest, corners) = must_item(rest)?;
        return Ok((rest, Term::InBox(dim, Box::new(corners))));
    }
    let (rest, ()) = must("{")(input)?;
    let (rest, tags) = enclosed(rest, "}")?;
    match dim {
        0 => Ok((rest, Term::Coordinates(Box::new(tags)))),
        _ => blank(input)?.must("`{:}`, `\"*\"` or `In BoundingBox`"),
    }
}

/// `{:}` or `"*"`.
pub(super) fn all(input: Text) -> Parsed<()> {
    if let Ok((rest, _)) = (symbol("{"), symbol(":"), symbol("}")).parse(input) {
        return Ok((rest, ()));
    }
    match tokens::text(input)? {
        (rest, text) if text == "*" => Ok((rest, ())),
        _ => input.no("`{:}`"),
    }
}

/// All entities of a dimension, or a list of tags.
pub(super) fn all_or_list(input: Text, dim: u8) -> Parsed<Expression> {
    let begin = blank(input)?;
    match all(begin) {
        Ok((rest, ())) => Ok((rest, Expression { place: begin.place(), term: Term::All(dim) })),
        Err(_) => must_item(begin),
    }
}

fn variable(input: Text) -> Parsed<Term> {
    let (rest, name) = name(input)?;
    if let Ok((rest, ())) = empty_brackets(rest) {
        return Ok((rest, Term::Whole(name)));
    }
    if let Ok((after, close)) = open_bracket(rest) {
        let (rest, index) = enclosed(after, close)?;
        return Ok((rest, Term::Elements(name, Box::new(index))));
    }
    if let Ok((rest, ())) = symbol("++")(rest) {
        return Ok((rest, Term::Increment(name, 1.0)));
    }
    if let Ok((rest, ())) = symbol("--")(rest) {
        return Ok((rest, Term::Increment(name, -1.0)));
    }
    if name.suffixes.is_empty() && rest.rest.starts_with(b".") {
        let (rest, path) = option_path(rest, name.base)?;
        return Ok((rest, Term::Option(path)));
    }
    Ok((rest, Term::Variable(name)))
}

/// The rest of `Mesh.MeshSizeMin`.
pub(super) fn option_path(mut input: Text, mut path: String) -> Parsed<String> {
    while input.rest.starts_with(b".") {
        let (rest, part) = word(input.after(1)).or_else(|_| input.must("the name of an option"))?;
        path = format!("{path}.{part}");
        input = rest;
    }
    Ok((input, path))
}

fn function(word: &str) -> Option<Function> {
    Some(match word {
        "Exp" => Function::Exp,
        "Log" => Function::Log,
        "Log10" => Function::Log10,
        "Sqrt" => Function::Sqrt,
        "Sin" => Function::Sin,
        "Asin" => Function::Asin,
        "Cos" => Function::Cos,
        "Acos" => Function::Acos,
        "Tan" => Function::Tan,
        "Atan" => Function::Atan,
        "Atan2" => Function::Atan2,
        "Sinh" => Function::Sinh,
        "Cosh" => Function::Cosh,
        "Tanh" => Function::Tanh,
        "Abs" | "Fabs" => Function::Abs,
        "Floor" => Function::Floor,
        "Ceil" => Function::Ceil,
        "Round" => Function::Round,
        "Sign" => Function::Sign,
        "Step" => Function::Step,
        "Modulo" | "Fmod" => Function::Modulo,
        "Hypot" => Function::Hypot,
        "Max" => Function::Max,
        "Min" => Function::Min,
        "Unique" => Function::Unique,
        "LinSpace" => Function::LinSpace,
        "LogSpace" => Function::LogSpace,
        "Str" => Function::Str,
        "StrCat" => Function::StrCat,
        "Sprintf" => Function::Sprintf,
        "StrPrefix" => Function::StrPrefix,
        "UpperCase" => Function::UpperCase,
        "LowerCase" => Function::LowerCase,
        "StrFind" => Function::StrFind,
        "StrCmp" => Function::StrCmp,
        "StrLen" => Function::StrLen,
        "StrSub" => Function::StrSub,
        "StrReplace" => Function::StrReplace,
        _ => return None,
    })
}
