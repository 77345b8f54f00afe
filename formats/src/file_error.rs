//! What is wrong with a file that may be text or binary, and where.

use std::borrow::Cow;

use crate::error::{Found, SyntaxError};

/// What is wrong with a file, and where: by line and column in text, by byte in what is no text.
///
/// ```
/// use meshwright_formats::msh;
/// let error = msh::read(b"$MeshFormat\n2.2 1 8\n\x01\0", "a.msh").unwrap_err();
/// let message = "a.msh: byte 20: expected the number 1 in 4 bytes, found the end of the file";
/// assert_eq!(error.to_string(), message);
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// In text.
    #[error(transparent)]
    Text(#[from] SyntaxError),
    /// Behind the first byte that is no text.
    #[error(transparent)]
    Binary(#[from] ByteError),
}

/// A place in a binary file that could not be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{file}: byte {offset}: expected {expected}, found {found}{}",
        help.as_ref().map_or(String::new(), |help| format!("\nhelp: {help}")))]
pub struct ByteError {
    /// The file, as the user named it.
    pub file: Box<str>,
    /// The byte, counted from zero.
    pub offset: usize,
    /// What should have stood there.
    pub expected: Cow<'static, str>,
    /// What stands there.
    pub found: Found,
    /// What to do about it, where that is known.
    pub help: Option<Cow<'static, str>>,
}

impl From<SyntaxError> for ByteError {
    /// The same error, by its byte.
    fn from(SyntaxError { file, expected, found, help, offset, .. }: SyntaxError) -> Self {
        Self { file, offset, expected, found, help }
    }
}
