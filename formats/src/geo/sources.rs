//! The files of a script, and the lines that places in them stand on.

use std::rc::Rc;

use super::error::{Error, Problem};
use super::grammar::Fault;
use super::syntax::Place;
use crate::error::Found;

/// Something wrong at a place; [`Sources::error`] makes it a message.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Trouble {
    pub place: Place,
    pub problem: Box<Problem>,
}

/// The answer of what may find trouble.
pub(super) type Answer<T> = Result<T, Trouble>;

impl Problem {
    /// This problem, at a place.
    pub(super) fn at(self, place: Place) -> Trouble {
        Trouble { place, problem: Box::new(self) }
    }
}

/// The text of a file: borrowed for the script itself, owned for what it includes.
#[derive(Debug, Clone)]
pub(super) enum SourceText<'a> {
    Script(&'a [u8]),
    Included(Rc<[u8]>),
}

impl SourceText<'_> {
    pub(super) fn bytes(&self) -> &[u8] {
        match self {
            Self::Script(bytes) => bytes,
            Self::Included(bytes) => bytes,
        }
    }
}

/// A file of a script.
#[derive(Debug)]
struct Source<'a> {
    name: String,
    text: SourceText<'a>,
    /// Where each line begins.
    line_starts: Vec<u32>,
}

/// All files that a script has read so far.
#[derive(Debug, Default)]
pub(super) struct Sources<'a> {
    files: Vec<Source<'a>>,
}

impl<'a> Sources<'a> {
    /// Takes a file in, and tells its number.
    pub(super) fn add(&mut self, name: String, text: SourceText<'a>) -> u32 {
        let line_starts = line_starts(text.bytes());
        self.files.push(Source { name, text, line_starts });
        self.files.len() as u32 - 1
    }

    pub(super) fn name(&self, file: u32) -> &str {
        &self.files[file as usize].name
    }

    /// The line of a place, counted from one.
    pub(super) fn line(&self, place: Place) -> u32 {
        let starts = &self.files[place.file as usize].line_starts;
        starts.partition_point(|&start| start <= place.offset) as u32
    }

    /// The message about a problem.
    pub(super) fn error(&self, Trouble { place, problem }: Trouble) -> Error {
        let source = &self.files[place.file as usize];
        let line = self.line(place);
        let start = source.line_starts[line as usize - 1] as usize;
        let text = &source.text.bytes()[start..];
        let before = String::from_utf8_lossy(&text[..place.offset as usize - start]);
        Error {
            file: source.name.as_str().into(),
            line,
            column: before.chars().count() as u32 + 1,
            problem,
            text: String::from_utf8_lossy(line_of(text)).into(),
        }
    }

    /// The trouble that something else should stand where the grammar stopped.
    pub(super) fn syntax(&self, fault: Fault) -> Trouble {
        let Fault { place, expected, is_cut_off } = fault;
        let text = self.files[place.file as usize].text.bytes();
        let last = Place { offset: text.trim_ascii_end().len() as u32, ..place };
        let help = is_cut_off
            .then(|| format!("line {} is the last: is the file whole?", self.line(last)).into());
        let rest = &text[place.offset as usize..];
        let found = match line_of(rest).trim_ascii() {
            [] if rest.trim_ascii().is_empty() => Found::EndOfFile,
            [] => Found::EndOfLine,
            line => Found::Word(String::from_utf8_lossy(first_word(line)).into_owned()),
        };
        Problem::Syntax { expected, found, help }.at(place)
    }
}

fn line_starts(text: &[u8]) -> Vec<u32> {
    let mut starts = vec![0];
    for (i, &byte) in text.iter().enumerate() {
        if byte == b'\n' || (byte == b'\r' && text.get(i + 1) != Some(&b'\n')) {
            starts.push(i as u32 + 1);
        }
    }
    starts
}

/// The bytes before the end of the line.
fn line_of(text: &[u8]) -> &[u8] {
    let end = text.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(text.len());
    &text[..end]
}

/// A run of letters and digits, or a single symbol.
fn first_word(line: &[u8]) -> &[u8] {
    let is_letter = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.') || *b >= 0x80;
    let length = line.iter().position(|b| !is_letter(b)).unwrap_or(line.len());
    &line[..length.max(1)]
}
