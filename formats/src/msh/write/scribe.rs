//! Numbers as text or as bytes, by one set of calls.

use std::io::{self, Write};

use super::Version;
use crate::rows::Rows;

/// A `.msh` file that is being written.
///
/// Whole numbers have 32 bits in a binary file where they are called `int`, 64 where they are
/// called `size`; in text both are digits.
pub(super) struct Scribe<'a, W> {
    rows: Rows<'a, W>,
    binary: bool,
}

impl<'a, W: Write> Scribe<'a, W> {
    pub fn new(out: &'a mut W, binary: bool) -> Self {
        Self { rows: Rows::new(out), binary }
    }

    /// The section that says what follows. The number 1 after it tells the order of bytes.
    pub fn format(&mut self, version: Version) -> io::Result<()> {
        let version = match version {
            Version::V2_2 => "2.2",
            Version::V4_1 => "4.1",
        };
        if !self.binary {
            return self.text(&format!("$MeshFormat\n{version} 0 8\n$EndMeshFormat\n"));
        }
        self.text(&format!("$MeshFormat\n{version} 1 8\n"))?;
        self.int(1);
        self.text("\n$EndMeshFormat\n")
    }

    /// Whole lines, also in a binary file.
    pub fn text(&mut self, lines: &str) -> io::Result<()> {
        self.rows.text(lines)
    }

    pub fn int(&mut self, value: i32) {
        if self.binary {
            self.rows.bytes(&value.to_le_bytes());
        } else {
            self.rows.integer(value);
        }
    }

    pub fn size(&mut self, value: usize) {
        if self.binary {
            self.rows.bytes(&(value as u64).to_le_bytes());
        } else {
            self.rows.integer(value as i64);
        }
    }

    /// The number of a node or an element, one-based, where a binary file has 32 bits for it.
    pub fn number(&mut self, value: usize) {
        if self.binary {
            self.rows.bytes(&(value as u32).to_le_bytes());
        } else {
            self.rows.integer(value as i64);
        }
    }

    pub fn real(&mut self, value: f64) {
        if self.binary {
            self.rows.bytes(&value.to_le_bytes());
        } else {
            self.rows.real(value);
        }
    }

    /// A whole number that stands for a real one.
    pub fn whole(&mut self, value: i64) {
        if self.binary {
            self.rows.bytes(&(value as f64).to_le_bytes());
        } else {
            self.rows.integer(value);
        }
    }

    /// Ends a row, which holds a number.
    pub fn end(&mut self) -> io::Result<()> {
        if self.binary { self.rows.hand_on() } else { self.rows.end() }
    }

    /// Ends a section.
    pub fn close(&mut self, name: &str) -> io::Result<()> {
        let line = if self.binary { "\n" } else { "" };
        self.text(&format!("{line}$End{name}\n"))
    }

    /// Refuses a count that 32 bits cannot number, where they have to.
    pub fn check(&self, count: usize) -> io::Result<()> {
        match i32::try_from(count) {
            Err(_) if self.binary => Err(io::ErrorKind::FileTooLarge.into()),
            _ => Ok(()),
        }
    }

    /// Whether numbers are bytes.
    pub fn is_binary(&self) -> bool {
        self.binary
    }

    pub fn finish(self) -> io::Result<()> {
        self.rows.finish()
    }
}
