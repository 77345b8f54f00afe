//! Rows of numbers: what the writers of text files make.

use std::io::{self, Write};

use crate::digits::{push_integer, push_real};

/// Bytes that are gathered before they are handed on.
const BLOCK: usize = 1 << 16;

/// A text file that is written row by row, spaces between the words of a row.
pub(crate) struct Rows<'a, W> {
    buffer: Vec<u8>,
    out: &'a mut W,
}

impl<'a, W: Write> Rows<'a, W> {
    pub fn new(out: &'a mut W) -> Self {
        Self { buffer: Vec::with_capacity(2 * BLOCK), out }
    }

    /// Adds a whole number to the row.
    pub fn integer(&mut self, value: impl Into<i64>) {
        push_integer(&mut self.buffer, value);
        self.buffer.push(b' ');
    }

    /// Adds a number to the row.
    pub fn real(&mut self, value: f64) {
        push_real(&mut self.buffer, value);
        self.buffer.push(b' ');
    }

    /// Puts a comma after the last word.
    pub fn comma(&mut self) {
        if let Some(last) = self.buffer.last_mut() {
            *last = b',';
        }
        self.buffer.push(b' ');
    }

    /// Ends the row, which holds a word.
    pub fn end(&mut self) -> io::Result<()> {
        if let Some(last) = self.buffer.last_mut() {
            *last = b'\n';
        }
        self.hand_on()
    }

    /// A whole row.
    pub fn integers(&mut self, numbers: &[i64]) -> io::Result<()> {
        for &number in numbers {
            self.integer(number);
        }
        self.end()
    }

    /// Whole lines, with their ends.
    pub fn text(&mut self, lines: &str) -> io::Result<()> {
        self.buffer.extend(lines.bytes());
        self.hand_on()
    }

    /// Bytes as they are: numbers of a binary file.
    pub fn bytes(&mut self, bytes: &[u8]) {
        self.buffer.extend_from_slice(bytes);
    }

    /// Hands the rest on.
    pub fn finish(self) -> io::Result<()> {
        self.out.write_all(&self.buffer)
    }

    /// Hands bytes on, if there are enough of them.
    pub fn hand_on(&mut self) -> io::Result<()> {
        if self.buffer.len() >= BLOCK {
            self.out.write_all(&self.buffer)?;
            self.buffer.clear();
        }
        Ok(())
    }
}

/// Bytes of a file within the file: as Base64.
impl<W: Write> Write for Rows<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.bytes(bytes);
        self.hand_on()?;
        Ok(bytes.len())
    }

    /// Does nothing: bytes are handed on block by block.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The number by which a file counts an item from one.
pub(crate) fn one_based(index: u32) -> i64 {
    i64::from(index) + 1
}
