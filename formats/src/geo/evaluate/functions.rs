//! The functions of numbers, lists and texts.

use super::format::sprintf;
use super::value::{Value, whole};
use crate::geo::error::Problem;
use crate::geo::syntax::{Function, Operator};

/// The longest list that a function makes.
const MOST_ELEMENTS: f64 = 1e7;

/// The value of a function.
pub(super) fn call(function: Function, arguments: Vec<Value>) -> Result<Value, Problem> {
    use Function::{
        Atan2, Hypot, LinSpace, LogSpace, LowerCase, Max, Min, Modulo, Sprintf, Str, StrCat,
        StrCmp, StrFind, StrLen, StrPrefix, StrReplace, StrSub, Unique, UpperCase,
    };
    match function {
        Atan2 => two(function, &arguments, libm::atan2),
        Hypot => two(function, &arguments, libm::hypot),
        Modulo => two(function, &arguments, libm::fmod),
        Max => extreme(function, arguments, f64::max),
        Min => extreme(function, arguments, f64::min),
        Unique => unique(arguments),
        LinSpace => spaced(&arguments, |x| x),
        LogSpace => spaced(&arguments, |x| libm::pow(10.0, x)),
        Str => Ok(match <[String; 1]>::try_from(texts(arguments)?) {
            Ok([text]) => Value::Text(text),
            Err(texts) => Value::Texts(texts),
        }),
        StrCat => Ok(Value::Text(texts(arguments)?.concat())),
        Sprintf => sprintf(arguments).map(Value::Text),
        StrPrefix | UpperCase | LowerCase | StrLen => {
            let [text] = strings(arguments, "one text")?;
            Ok(match function {
                StrPrefix => Value::Text(text.rsplit_once('.').map_or(&*text, |(a, _)| a).into()),
                UpperCase => Value::Text(text.to_ascii_uppercase()),
                LowerCase => Value::Text(text.to_ascii_lowercase()),
                _ => Value::Number(text.len() as f64),
            })
        }
        StrFind => {
            let [text, part] = strings(arguments, "two texts")?;
            Ok(Value::Number(f64::from(u8::from(text.contains(&part)))))
        }
        StrCmp => {
            let [a, b] = strings(arguments, "two texts")?;
            Ok(Value::Number(f64::from(a.cmp(&b) as i8)))
        }
        StrReplace => {
            let [text, from, to] = strings(arguments, "three texts")?;
            Ok(Value::Text(text.replace(&from, &to)))
        }
        StrSub => part(arguments),
        _ => one(function, &arguments),
    }
}

/// A function of one number; a list is taken element by element.
fn one(function: Function, arguments: &[Value]) -> Result<Value, Problem> {
    let [argument] = arguments else {
        return Err(count("a function", "one number", arguments.len()));
    };
    let apply = |x: f64| finite(of_one(function, x), || format!("{function:?}({x})"));
    match argument {
        Value::List(list) => {
            list.iter().map(|&x| apply(x)).collect::<Result<_, _>>().map(Value::List)
        }
        other => apply(other.number()?).map(Value::Number),
    }
}

fn of_one(function: Function, x: f64) -> f64 {
    match function {
        Function::Exp => libm::exp(x),
        Function::Log => libm::log(x),
        Function::Log10 => libm::log10(x),
        Function::Sqrt => x.sqrt(),
        Function::Sin => libm::sin(x),
        Function::Asin => libm::asin(x),
        Function::Cos => libm::cos(x),
        Function::Acos => libm::acos(x),
        Function::Tan => libm::tan(x),
        Function::Atan => libm::atan(x),
        Function::Sinh => libm::sinh(x),
        Function::Cosh => libm::cosh(x),
        Function::Tanh => libm::tanh(x),
        Function::Abs => x.abs(),
        Function::Floor => x.floor(),
        Function::Ceil => x.ceil(),
        Function::Round => (x + 0.5).floor(),
        Function::Sign if x == 0.0 => 0.0,
        Function::Sign => x.signum(),
        Function::Step => f64::from(u8::from(x >= 0.0)),
        _ => f64::NAN,
    }
}

fn two(function: Function, arguments: &[Value], of: fn(f64, f64) -> f64) -> Result<Value, Problem> {
    let [a, b] = arguments else {
        return Err(count("a function", "two numbers", arguments.len()));
    };
    let (a, b) = (a.number()?, b.number()?);
    finite(of(a, b), || format!("{function:?}({a}, {b})")).map(Value::Number)
}

fn extreme(
    function: Function,
    arguments: Vec<Value>,
    of: fn(f64, f64) -> f64,
) -> Result<Value, Problem> {
    let numbers = all_numbers(arguments)?;
    let found = numbers.into_iter().reduce(of);
    found.map(Value::Number).ok_or_else(|| match function {
        Function::Max => count("Max", "at least one number", 0),
        _ => count("Min", "at least one number", 0),
    })
}

/// The elements that differ, sorted.
fn unique(arguments: Vec<Value>) -> Result<Value, Problem> {
    let mut numbers = all_numbers(arguments)?;
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    Ok(Value::List(numbers))
}

/// `LinSpace[first, last, count]`
fn spaced(arguments: &[Value], of: fn(f64) -> f64) -> Result<Value, Problem> {
    let [first, last, n] = arguments else {
        return Err(count("LinSpace", "three numbers", arguments.len()));
    };
    let (first, last, n) = (first.number()?, last.number()?, n.number()?);
    if !(0.0..=MOST_ELEMENTS).contains(&n) {
        return Err(Problem::Limit { what: "a list has more than 10 million elements" });
    }
    let at = |i: u32| match n {
        1.0 => first,
        n => first + (last - first) * f64::from(i) / (n.floor() - 1.0),
    };
    let number = |i| finite(of(at(i)), || format!("10^{}", at(i)));
    (0..n as u32).map(number).collect::<Result<_, _>>().map(Value::List)
}

/// `StrSub(text, first, length)`
fn part(arguments: Vec<Value>) -> Result<Value, Problem> {
    let [text, first, rest @ ..] = &arguments[..] else {
        return Err(count("StrSub", "a text and one or two numbers", arguments.len()));
    };
    let first = whole(first.number()?, "the first character")?.max(0) as usize;
    let length = match rest {
        [length] => whole(length.number()?, "the number of characters")?.max(0) as usize,
        _ => usize::MAX,
    };
    Ok(Value::Text(text.clone().text()?.chars().skip(first).take(length).collect()))
}

fn all_numbers(arguments: Vec<Value>) -> Result<Vec<f64>, Problem> {
    let mut numbers = Vec::new();
    for argument in arguments {
        numbers.extend(argument.numbers()?);
    }
    Ok(numbers)
}

fn texts(arguments: Vec<Value>) -> Result<Vec<String>, Problem> {
    let mut all = Vec::new();
    for argument in arguments {
        match argument {
            Value::Texts(texts) => all.extend(texts),
            other => all.push(other.text()?),
        }
    }
    Ok(all)
}

fn strings<const N: usize>(
    arguments: Vec<Value>,
    expected: &'static str,
) -> Result<[String; N], Problem> {
    let found = arguments.len();
    texts(arguments)?.try_into().map_err(|_| count("a function", expected, found))
}

fn count(what: &'static str, expected: &'static str, found: usize) -> Problem {
    Problem::Count { what, expected, found }
}

/// A number that is finite.
pub(super) fn finite(value: f64, operation: impl FnOnce() -> String) -> Result<f64, Problem> {
    if value.is_finite() { Ok(value) } else { Err(Problem::NotFinite { operation: operation() }) }
}

/// The value of a binary operation; lists are taken element by element.
pub(super) fn binary(operator: Operator, a: Value, b: Value) -> Result<Value, Problem> {
    let apply =
        |a: f64, b: f64| finite(of_two(operator, a, b), || format!("{a} {} {b}", symbol(operator)));
    match (&a, &b) {
        (Value::List(left), Value::List(right)) if left.len() == right.len() => {
            let pairs = left.iter().zip(right);
            pairs.map(|(&a, &b)| apply(a, b)).collect::<Result<_, _>>().map(Value::List)
        }
        (Value::List(list), Value::Number(b)) => {
            list.iter().map(|&a| apply(a, *b)).collect::<Result<_, _>>().map(Value::List)
        }
        (Value::Number(a), Value::List(list)) => {
            list.iter().map(|&b| apply(*a, b)).collect::<Result<_, _>>().map(Value::List)
        }
        _ => apply(a.number()?, b.number()?).map(Value::Number),
    }
}

fn of_two(operator: Operator, a: f64, b: f64) -> f64 {
    let truth = |is: bool| f64::from(u8::from(is));
    match operator {
        Operator::Or => truth(a != 0.0 || b != 0.0),
        Operator::And => truth(a != 0.0 && b != 0.0),
        Operator::Equal => truth(a == b),
        Operator::NotEqual => truth(a != b),
        Operator::Less => truth(a < b),
        Operator::LessOrEqual => truth(a <= b),
        Operator::Greater => truth(a > b),
        Operator::GreaterOrEqual => truth(a >= b),
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => a * b,
        Operator::Divide => a / b,
        // Of the whole parts, as in C.
        Operator::Remainder => libm::fmod(a.trunc(), b.trunc()),
        Operator::Power => libm::pow(a, b),
    }
}

fn symbol(operator: Operator) -> &'static str {
    match operator {
        Operator::Or => "||",
        Operator::And => "&&",
        Operator::Equal => "==",
        Operator::NotEqual => "!=",
        Operator::Less => "<",
        Operator::LessOrEqual => "<=",
        Operator::Greater => ">",
        Operator::GreaterOrEqual => ">=",
        Operator::Add => "+",
        Operator::Subtract => "-",
        Operator::Multiply => "*",
        Operator::Divide => "/",
        Operator::Remainder => "%",
        Operator::Power => "^",
    }
}
