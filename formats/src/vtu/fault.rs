//! What can be wrong with a `.vtu` file.

/// A `.vtu` file that could not be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {fault}")]
pub struct ReadError {
    /// The file, as the user named it.
    pub file: String,
    /// What is wrong with it.
    pub fault: Fault,
}

/// What is wrong with a `.vtu` file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// Something else than VTK's XML.
    #[error("this is no .vtu file: it holds no <VTKFile>")]
    NotVtu,
    /// XML that cannot be read.
    #[error("line {line}: {message}")]
    Xml {
        /// The line, counted from one.
        line: usize,
        /// What the XML reader says.
        message: String,
    },
    /// A kind of `.vtu` that is not read here.
    #[error("expected {attribute}=\"{expected}\", found \"{found}\"")]
    Unsupported {
        /// The attribute.
        attribute: &'static str,
        /// What is read here.
        expected: &'static str,
        /// What the file has.
        found: String,
    },
    /// A part that every `.vtu` file has.
    #[error("{what} is missing")]
    Missing {
        /// The part.
        what: String,
    },
    /// The file ends, or the next part begins, before an array does.
    #[error("array `{array}` ends at byte {end} of its data, which have {available}")]
    Truncated {
        /// The array's name.
        array: String,
        /// Where it would end.
        end: u64,
        /// How many bytes there are.
        available: u64,
    },
    /// An array with more or fewer numbers than it must have.
    #[error("array `{array}` holds {found} numbers, expected {expected}")]
    Length {
        /// The array's name.
        array: String,
        /// How many it must have.
        expected: u64,
        /// How many it has.
        found: u64,
    },
    /// Bytes that cannot be decoded.
    #[error("array `{array}`: expected {expected}, found {found}")]
    Coded {
        /// The array's name.
        array: String,
        /// What should be there.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// A number that means nothing.
    #[error("array `{array}`, number {index} (from 0): expected {expected}, found {found}")]
    Value {
        /// The array's name.
        array: String,
        /// Its place, from zero.
        index: usize,
        /// What it may be.
        expected: &'static str,
        /// What it is.
        found: String,
    },
    /// The file could not be read on.
    #[error("{message}")]
    Io {
        /// What happened.
        kind: std::io::ErrorKind,
        /// What the system says.
        message: String,
    },
}

impl From<std::io::Error> for Fault {
    fn from(error: std::io::Error) -> Self {
        Self::Io { kind: error.kind(), message: error.to_string() }
    }
}
