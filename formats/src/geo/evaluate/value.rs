//! What variables hold and expressions give.

use crate::geo::error::Problem;

/// A number, a text, or a list of them.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::geo) enum Value {
    Number(f64),
    List(Vec<f64>),
    Text(String),
    Texts(Vec<String>),
}

impl Value {
    /// What it is, for messages.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Self::Number(_) => "a number",
            Self::List(_) => "a list of numbers",
            Self::Text(_) => "a text",
            Self::Texts(_) => "a list of texts",
        }
    }

    /// The one number that it is.
    pub(super) fn number(&self) -> Result<f64, Problem> {
        match self {
            Self::Number(number) => Ok(*number),
            Self::List(list) if list.len() == 1 => Ok(list[0]),
            other => Err(Problem::Kind { expected: "a number".into(), found: other.kind() }),
        }
    }

    /// The numbers that it is.
    pub(super) fn numbers(self) -> Result<Vec<f64>, Problem> {
        match self {
            Self::Number(number) => Ok(vec![number]),
            Self::List(list) => Ok(list),
            other => Err(Problem::Kind { expected: "numbers".into(), found: other.kind() }),
        }
    }

    /// The one text that it is.
    pub(super) fn text(self) -> Result<String, Problem> {
        match self {
            Self::Text(text) => Ok(text),
            Self::Texts(mut texts) if texts.len() == 1 => Ok(texts.remove(0)),
            other => Err(Problem::Kind { expected: "a text".into(), found: other.kind() }),
        }
    }

    /// The first of what it holds, which is what a list's name alone stands for.
    pub(super) fn first(&self) -> Option<Value> {
        match self {
            Self::List(list) => list.first().map(|&number| Self::Number(number)),
            Self::Texts(texts) => texts.first().map(|text| Self::Text(text.clone())),
            one => Some(one.clone()),
        }
    }

    /// How much it holds: elements, and bytes of texts.
    pub(super) fn size(&self) -> u64 {
        match self {
            Self::Number(_) => 1,
            Self::List(list) => list.len() as u64,
            Self::Text(text) => text.len() as u64,
            Self::Texts(texts) => texts.iter().map(|text| text.len() as u64 + 1).sum(),
        }
    }
}

/// The whole number that a number is; `what` says of what.
pub(in crate::geo) fn whole(value: f64, what: &'static str) -> Result<i32, Problem> {
    let number = value as i32;
    if f64::from(number) == value { Ok(number) } else { Err(Problem::NotWhole { what, value }) }
}
