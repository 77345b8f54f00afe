//! Where the numbers of a section come from: the words of lines, or bytes.

use std::borrow::Cow;

use super::{end_of_line, item};
use crate::error::SyntaxError;
use crate::text::{Scanner, parse_any_real};

/// The numbers of a section, one after the other.
pub(super) trait Source<'a> {
    /// Begins the numbers of a section, behind a line of text.
    fn begin(&mut self) -> Result<(), SyntaxError>;

    /// Begins an item: the next line, where there are lines.
    fn row(&mut self, what: &str, index: i64, count: i64) -> Result<(), SyntaxError>;

    /// Ends an item, which must hold no more.
    fn end_row(&mut self) -> Result<(), SyntaxError>;

    /// A whole number from `least` to `most`, of 32 bits where it is bytes.
    fn int(&mut self, what: &'static str, least: i64, most: i64) -> Result<i64, SyntaxError>;

    /// A whole number from `least` to `most`, of 64 bits where it is bytes.
    fn size(&mut self, what: &'static str, least: i64, most: i64) -> Result<i64, SyntaxError>;

    /// A number, finite or not.
    fn any_real(&mut self, what: &'static str) -> Result<f64, SyntaxError>;

    /// A finite number.
    fn real(&mut self, what: &'static str) -> Result<f64, SyntaxError>;

    /// The error that the number read last is not what it should be.
    fn wrong(&self, expected: impl Into<Cow<'static, str>>) -> SyntaxError;

    /// The place of the number read last.
    fn place(&self) -> usize;

    /// What reads the lines of text.
    fn scanner(&mut self) -> &mut Scanner<'a>;
}

/// Numbers that are words.
pub(super) struct Text<'s, 'a> {
    scanner: &'s mut Scanner<'a>,
    /// Where the last number stands.
    last: usize,
}

impl<'s, 'a> Text<'s, 'a> {
    pub fn new(scanner: &'s mut Scanner<'a>) -> Self {
        Self { scanner, last: 0 }
    }
}

impl<'a> Source<'a> for Text<'_, 'a> {
    fn begin(&mut self) -> Result<(), SyntaxError> {
        end_of_line(self.scanner)
    }

    fn row(&mut self, what: &str, index: i64, count: i64) -> Result<(), SyntaxError> {
        item(self.scanner, what, index, count)
    }

    fn end_row(&mut self) -> Result<(), SyntaxError> {
        end_of_line(self.scanner)
    }

    fn int(&mut self, what: &'static str, least: i64, most: i64) -> Result<i64, SyntaxError> {
        self.size(what, least, most)
    }

    fn size(&mut self, what: &'static str, least: i64, most: i64) -> Result<i64, SyntaxError> {
        self.last = self.scanner.next_place();
        self.scanner.integer(what, least, most)
    }

    fn any_real(&mut self, what: &'static str) -> Result<f64, SyntaxError> {
        self.last = self.scanner.next_place();
        let Some(word) = self.scanner.word() else { return Err(self.scanner.missing(what)) };
        parse_any_real(word.bytes).ok_or_else(|| self.scanner.unexpected(word, what))
    }

    fn real(&mut self, what: &'static str) -> Result<f64, SyntaxError> {
        self.last = self.scanner.next_place();
        self.scanner.real(what)
    }

    fn wrong(&self, expected: impl Into<Cow<'static, str>>) -> SyntaxError {
        self.scanner.unexpected_at(self.last, expected)
    }

    fn place(&self) -> usize {
        self.last
    }

    fn scanner(&mut self) -> &mut Scanner<'a> {
        self.scanner
    }
}

/// Numbers that are bytes.
pub(super) struct Binary<'s, 'a> {
    scanner: &'s mut Scanner<'a>,
    is_big_endian: bool,
    /// Where the last number stands, and what it is.
    last: (usize, Number),
}

#[derive(Clone, Copy)]
enum Number {
    Whole(i64),
    Real(f64),
}

impl<'s, 'a> Binary<'s, 'a> {
    pub fn new(scanner: &'s mut Scanner<'a>, is_big_endian: bool) -> Self {
        Self { scanner, is_big_endian, last: (0, Number::Whole(0)) }
    }

    /// The next bytes, the lowest one first.
    fn bytes<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], SyntaxError> {
        self.last.0 = self.scanner.offset();
        let Some(mut bytes) = self.scanner.bytes() else {
            return Err(self.scanner.too_short(what));
        };
        if self.is_big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn whole(
        &mut self,
        value: i64,
        what: &'static str,
        least: i64,
        most: i64,
    ) -> Result<i64, SyntaxError> {
        self.last.1 = Number::Whole(value);
        if (least..=most).contains(&value) { Ok(value) } else { Err(self.wrong(what)) }
    }
}

impl<'a> Source<'a> for Binary<'_, 'a> {
    fn begin(&mut self) -> Result<(), SyntaxError> {
        match self.scanner.enter_bytes() {
            true => Ok(()),
            // Something else stands in the line, or it is the last one.
            false => end_of_line(self.scanner),
        }
    }

    fn row(&mut self, _: &str, _: i64, _: i64) -> Result<(), SyntaxError> {
        Ok(())
    }

    fn end_row(&mut self) -> Result<(), SyntaxError> {
        Ok(())
    }

    fn int(&mut self, what: &'static str, least: i64, most: i64) -> Result<i64, SyntaxError> {
        let value = i32::from_le_bytes(self.bytes(what)?);
        self.whole(value.into(), what, least, most)
    }

    fn size(&mut self, what: &'static str, least: i64, most: i64) -> Result<i64, SyntaxError> {
        let value = u64::from_le_bytes(self.bytes(what)?);
        // A larger number than any that is wanted stays one.
        self.whole(i64::try_from(value).unwrap_or(i64::MAX), what, least, most)
    }

    fn any_real(&mut self, what: &'static str) -> Result<f64, SyntaxError> {
        let value = f64::from_le_bytes(self.bytes(what)?);
        self.last.1 = Number::Real(value);
        Ok(value)
    }

    fn real(&mut self, what: &'static str) -> Result<f64, SyntaxError> {
        let value = self.any_real(what)?;
        if value.is_finite() { Ok(value) } else { Err(self.wrong(what)) }
    }

    fn wrong(&self, expected: impl Into<Cow<'static, str>>) -> SyntaxError {
        let (place, number) = self.last;
        match number {
            Number::Whole(value) => self.scanner.unexpected_number(place, expected, value),
            Number::Real(value) => {
                self.scanner.unexpected_number(place, expected, format!("{value:?}"))
            }
        }
    }

    fn place(&self) -> usize {
        self.last.0
    }

    fn scanner(&mut self) -> &mut Scanner<'a> {
        self.scanner
    }
}
