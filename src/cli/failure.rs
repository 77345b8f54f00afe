//! Why a command ends without success, and with which exit code.

use std::fmt::Display;
use std::io;
use std::path::Path;

/// The exit codes of the command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// Done, and every promise is kept.
    Done = 0,
    /// The input is wrong: its syntax or its geometry.
    Input = 1,
    /// The command was called wrongly.
    Usage = 2,
    /// A file could not be read or written.
    Io = 3,
    /// A promise is not kept.
    Promise = 4,
    /// Interrupted from the keyboard.
    Interrupted = 130,
}

/// A message for the user (without `error: ` before it) and the exit code that goes with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// How the command ends.
    pub exit: Exit,
    /// What is wrong; several lines, the last ones `help: …` where help is known.
    pub message: String,
}

impl Failure {
    /// The input is wrong.
    pub fn input(message: impl Display) -> Self {
        Self { exit: Exit::Input, message: message.to_string() }
    }

    /// The command was called wrongly.
    pub fn usage(message: impl Display) -> Self {
        Self { exit: Exit::Usage, message: message.to_string() }
    }

    /// A file could not be read or written.
    pub fn io(path: &Path, error: &io::Error) -> Self {
        Self { exit: Exit::Io, message: format!("{}: {}", path.display(), reason(error)) }
    }

    /// A promise is not kept.
    pub fn promise(message: impl Display) -> Self {
        Self { exit: Exit::Promise, message: message.to_string() }
    }

    /// The same failure with a line of help below it.
    pub fn with_help(mut self, help: impl Display) -> Self {
        self.message.push_str("\nhelp: ");
        self.message.push_str(&help.to_string());
        self
    }
}

/// What the system says, without its error number.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or_default();
    let mut characters = text.chars();
    match characters.next() {
        Some(first) => first.to_lowercase().chain(characters).collect(),
        None => text.to_string(),
    }
}
