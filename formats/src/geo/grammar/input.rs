//! What the grammar's parsers read: the rest of a script, and how deep they are in it.

use std::borrow::Cow;

use nom::error::{ErrorKind, ParseError};
use nom::{Err, IResult, Input, Needed};

use crate::geo::syntax::Place;

/// Braces, parentheses and blocks may stand in one another this deep.
pub(super) const MOST_DEPTH: u32 = 100;

/// The rest of a script. All copies share the script's end, so what is left tells the place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Text<'a> {
    pub rest: &'a [u8],
    /// The length of the whole script.
    length: u32,
    /// Which of the script's files this is.
    file: u32,
    /// How many braces, parentheses and blocks are open.
    depth: u32,
}

/// What a parser answers: the rest and what it read.
pub(super) type Parsed<'a, T> = IResult<Text<'a>, T, Fault>;

/// Where a script cannot be read, and what should have stood there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Fault {
    pub place: Place,
    pub expected: Cow<'static, str>,
    /// Whether the script ended before a block did.
    pub is_cut_off: bool,
}

impl<'a> Text<'a> {
    /// The whole of a file, which must be shorter than 4 GiB.
    pub fn new(rest: &'a [u8], file: u32) -> Self {
        Self { rest, length: rest.len() as u32, file, depth: 0 }
    }

    /// Where the rest begins.
    pub fn place(&self) -> Place {
        Place { file: self.file, offset: self.length - self.rest.len() as u32 }
    }

    /// The rest after its first `count` bytes.
    pub(in crate::geo) fn after(self, count: usize) -> Self {
        Self { rest: &self.rest[count..], ..self }
    }

    /// The same rest, one brace deeper.
    pub(super) fn deeper(self) -> Result<Self, Err<Fault>> {
        if self.depth == MOST_DEPTH {
            return Err(Err::Failure(self.fault("at most 100 levels of braces and blocks")));
        }
        Ok(Self { depth: self.depth + 1, ..self })
    }

    /// The same rest, as deep as `other`.
    pub(super) fn as_deep_as(self, other: Self) -> Self {
        Self { depth: other.depth, ..self }
    }

    pub(super) fn fault(&self, expected: impl Into<Cow<'static, str>>) -> Fault {
        Fault { place: self.place(), expected: expected.into(), is_cut_off: false }
    }

    /// The answer that something else should stand here; other parsers may still try.
    pub(super) fn no<T>(&self, expected: &'static str) -> Parsed<'a, T> {
        Err(Err::Error(self.fault(expected)))
    }

    /// The answer that something else must stand here.
    pub(super) fn must<T>(&self, expected: impl Into<Cow<'static, str>>) -> Parsed<'a, T> {
        Err(Err::Failure(self.fault(expected)))
    }
}

impl<'a> ParseError<Text<'a>> for Fault {
    fn from_error_kind(input: Text<'a>, _: ErrorKind) -> Self {
        input.fault("something else")
    }

    fn append(_: Text<'a>, _: ErrorKind, other: Self) -> Self {
        other
    }
}

impl<'a> Input for Text<'a> {
    type Item = u8;
    type Iter = std::iter::Copied<std::slice::Iter<'a, u8>>;
    type IterIndices = std::iter::Enumerate<Self::Iter>;

    fn input_len(&self) -> usize {
        self.rest.len()
    }

    fn take(&self, index: usize) -> Self {
        Self { rest: &self.rest[..index], ..*self }
    }

    fn take_from(&self, index: usize) -> Self {
        self.after(index)
    }

    fn take_split(&self, index: usize) -> (Self, Self) {
        (self.after(index), self.take(index))
    }

    fn position<P: Fn(u8) -> bool>(&self, predicate: P) -> Option<usize> {
        self.rest.iter().position(|&byte| predicate(byte))
    }

    fn iter_elements(&self) -> Self::Iter {
        self.rest.iter().copied()
    }

    fn iter_indices(&self) -> Self::IterIndices {
        self.iter_elements().enumerate()
    }

    fn slice_index(&self, count: usize) -> Result<usize, Needed> {
        if self.rest.len() >= count { Ok(count) } else { Err(Needed::new(count - self.rest.len())) }
    }
}
