//! What the command says on stderr, and how it writes to stdout.

use std::cell::RefCell;
use std::fmt::Display;
use std::io::{self, IsTerminal, Write};

use super::failure::{Exit, Failure, reason};

/// How much is said on stderr.
#[derive(Debug)]
pub struct Voice {
    /// Nothing but errors.
    pub quiet: bool,
    /// More than the summary.
    pub verbose: bool,
    /// Whether `error:` and `warning:` stand out in colour.
    colour: bool,
    /// What was warned of so far.
    warnings: RefCell<Vec<String>>,
}

impl Voice {
    /// The voice that the user asks for; colour only on a terminal, never with `NO_COLOR`.
    pub fn new(quiet: bool, verbose: bool) -> Self {
        let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let colour = !refused && io::stderr().is_terminal();
        Self { quiet, verbose, colour, warnings: RefCell::default() }
    }

    /// A line of the summary: its label and what it says.
    pub fn say(&self, line: &str) {
        if !self.quiet {
            put(line);
        }
    }

    /// Something that the user should know.
    pub fn warn(&self, warning: impl Display) {
        self.warnings.borrow_mut().push(warning.to_string());
        if !self.quiet {
            put(&format!("{} {warning}", self.painted("warning:", "\x1b[1;33m")));
        }
    }

    /// What was warned of so far.
    pub fn warnings(&self) -> Vec<String> {
        self.warnings.borrow().clone()
    }

    /// What a writer did that the user may want to know.
    pub fn note(&self, note: impl Display) {
        if !self.quiet {
            put(&format!("{} {note}", self.painted("note:", "\x1b[1m")));
        }
    }

    /// Why the command ends.
    pub fn fail(&self, failure: &Failure) {
        put(&format!("{} {}", self.painted("error:", "\x1b[1;31m"), failure.message));
    }

    fn painted(&self, word: &str, paint: &str) -> String {
        if self.colour { format!("{paint}{word}\x1b[0m") } else { word.to_string() }
    }
}

/// A line on stderr. Where stderr is closed nobody can be told.
fn put(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// Writes to stdout. A reader that has seen enough (a closed pipe) is no error.
pub fn print(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure { exit: Exit::Io, message: format!("stdout: {}", reason(&error)) })
        }
        _ => Ok(()),
    }
}
