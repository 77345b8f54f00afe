//! Lines, words and numbers of a text file, with their places.
//!
//! A word is a run of bytes between white space; it is taken whole or not at all, so `0,0` is no
//! number. Lines end with `\n`, `\r\n` or `\r`; a byte order mark is skipped. One pass over the
//! bytes, nothing allocated but by errors: a number is parsed where it stands, and only where that
//! fails is its word looked at as a whole.

#[cfg(test)]
mod tests;

use std::borrow::Cow;

use crate::error::{Found, SyntaxError};
use crate::file_error::{ByteError, FileError};

/// A reader's place in a text file.
pub(crate) struct Scanner<'a> {
    file: &'a str,
    text: &'a [u8],
    /// The byte that is read next.
    position: usize,
    /// The line it is in, counted from one.
    line: u32,
    line_start: usize,
    /// What each byte is in this format.
    classes: [Class; 256],
    /// Whether bytes that are no text have begun: lines mean nothing any more.
    is_binary: bool,
}

/// What a byte is to a scanner.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Class {
    /// A part of a word.
    Word,
    /// White space within a line.
    Blank,
    /// The end of a line, or its first byte.
    End,
    /// The start of a comment.
    Comment,
    /// What joins the next line to this one, where this one ends behind it; else a part of a word.
    Joint,
}

/// A whole word.
#[derive(Clone, Copy)]
pub(crate) struct Word<'a> {
    pub bytes: &'a [u8],
    start: usize,
}

impl<'a> Scanner<'a> {
    pub fn new(text: &'a [u8], file: &'a str, comment: Option<u8>) -> Self {
        let start = if text.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
        let mut classes = [Class::Word; 256];
        b" \t\x0b\x0c".iter().for_each(|&byte| classes[usize::from(byte)] = Class::Blank);
        b"\n\r".iter().for_each(|&byte| classes[usize::from(byte)] = Class::End);
        if let Some(byte) = comment {
            classes[usize::from(byte)] = Class::Comment;
        }
        Self { file, text, position: start, line: 1, line_start: start, classes, is_binary: false }
    }

    /// A scanner of a format in which a `\` at the end of a line joins the next one to it.
    pub fn with_continued_lines(text: &'a [u8], file: &'a str, comment: Option<u8>) -> Self {
        let mut scanner = Self::new(text, file, comment);
        scanner.classes[usize::from(b'\\')] = Class::Joint;
        scanner
    }

    /// A scanner of a format in which this byte separates words as a blank does.
    pub fn with_separator(
        text: &'a [u8],
        file: &'a str,
        comment: Option<u8>,
        separator: u8,
    ) -> Self {
        let mut scanner = Self::new(text, file, comment);
        scanner.classes[usize::from(separator)] = Class::Blank;
        scanner
    }

    pub fn file(&self) -> &'a str {
        self.file
    }

    /// The line of the word that is read next, counted from one; 0 where the file is no text.
    pub fn line(&self) -> u32 {
        if self.is_binary { 0 } else { self.line }
    }

    /// Ends a line behind which bytes that are no text begin. False where something else stands in
    /// it.
    pub fn enter_bytes(&mut self) -> bool {
        self.skip_blanks();
        let is_end = self.class_at(self.position) == Some(Class::End);
        if is_end {
            self.end_line();
        }
        self.is_binary |= is_end;
        is_end
    }

    /// The next bytes, white space or not.
    pub fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let bytes = *self.unread().first_chunk()?;
        self.position += N;
        Some(bytes)
    }

    /// The next bytes, as many as are wanted.
    pub fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let bytes = self.unread().get(..count)?;
        self.position += count;
        Some(bytes)
    }

    /// The byte that is read next, counted from zero.
    pub fn offset(&self) -> usize {
        self.position
    }

    /// The place of the next word of this line.
    pub fn next_place(&mut self) -> usize {
        self.skip_blanks();
        self.position
    }

    /// An error as the file's kind has it: by line in text, else by byte.
    pub fn placed(&self, error: SyntaxError) -> FileError {
        if self.is_binary {
            FileError::Binary(ByteError::from(error))
        } else {
            FileError::Text(error)
        }
    }

    /// How many bytes are left: the bound on what an announced count may reserve.
    pub fn left(&self) -> usize {
        self.text.len() - self.position
    }

    /// Goes to the next line that holds a word: past blank lines, comments and what is left of the
    /// line so far. At the start of the file this is its first line. False at the end.
    pub fn next_line(&mut self) -> bool {
        loop {
            self.skip_blanks();
            match self.class_at(self.position) {
                None => return false,
                Some(Class::End) => self.end_line(),
                Some(Class::Comment) => self.skip_to_line_end(),
                Some(_) => return true,
            }
        }
    }

    /// Leaves the rest of the line, and of those joined to it.
    pub fn leave_line(&mut self) {
        self.skip_to_line_end();
        while self.left() > 0
            && self.position.checked_sub(1).is_some_and(|last| self.is_joint(last))
        {
            self.end_line();
            self.skip_to_line_end();
        }
    }

    /// Leaves the rest of the line, and its end.
    pub fn pass_line(&mut self) {
        self.skip_to_line_end();
        if self.left() > 0 {
            self.end_line();
        }
    }

    /// Leaves the rest of the line and all lines after it up to an empty one.
    pub fn leave_paragraph(&mut self) {
        self.pass_line();
        while self.left() > 0 && self.class_at(self.position) != Some(Class::End) {
            self.pass_line();
        }
    }

    /// Whether the next word of the file is this one.
    pub fn comes_next(&self, word: &[u8]) -> bool {
        let mut ahead = Self { ..*self };
        ahead.next_line() && ahead.word().is_some_and(|found| found.bytes == word)
    }

    /// The place of the word so many words behind that at a place, across lines.
    pub fn place_of_word(&self, place: usize, after: usize) -> usize {
        let mut again = self.at(place);
        for _ in 0..after {
            again.next_line();
            again.word();
        }
        again.next_line();
        again.position
    }

    /// The next word of this line.
    pub fn word(&mut self) -> Option<Word<'a>> {
        self.skip_blanks();
        let start = self.position;
        while !self.ends_word(self.position) {
            self.position += 1;
        }
        let bytes = &self.text[start..self.position];
        (!bytes.is_empty()).then_some(Word { bytes, start })
    }

    /// What is left of this line, comment included, without white space at its ends.
    pub fn rest(&mut self) -> Word<'a> {
        self.skip_blanks();
        let start = self.position;
        self.skip_to_line_end();
        Word { bytes: self.text[start..self.position].trim_ascii_end(), start }
    }

    /// The error that the first word of a line read before is not what it should be.
    pub fn unexpected_in_line(&self, line: u32, expected: &'static str) -> SyntaxError {
        let start = self.first_byte();
        let mut again = Self { position: start, line: 1, line_start: start, ..*self };
        while again.line < line && again.next_line() {
            again.leave_line();
            again.next_line();
        }
        let word = again.first_word_of_line();
        again.unexpected(word, expected)
    }

    /// The error that the word at a place that was read before is not what it should be.
    pub fn unexpected_at(
        &self,
        place: usize,
        expected: impl Into<Cow<'static, str>>,
    ) -> SyntaxError {
        let mut again = self.at(place);
        match again.word() {
            Some(word) => again.unexpected(word, expected),
            None => again.missing(expected),
        }
    }

    /// The error that the number that was read at a place is not what it should be.
    pub fn unexpected_number(
        &self,
        place: usize,
        expected: impl Into<Cow<'static, str>>,
        number: impl ToString,
    ) -> SyntaxError {
        if self.is_binary {
            let found = Found::Word(number.to_string());
            return self.error(place, self.line, self.line_start, expected.into(), found);
        }
        self.unexpected_at(place, expected)
    }

    /// This scanner at a place that was read before.
    fn at(&self, place: usize) -> Self {
        let start = self.first_byte();
        if self.is_binary {
            return Self { position: place, ..*self };
        }
        let before = &self.text[start..place];
        let end = before.iter().rposition(|&b| b == b'\n' || b == b'\r');
        let line_start = end.map_or(start, |end| start + end + 1);
        Self { position: place, line: 1 + count_breaks(before), line_start, ..*self }
    }

    /// Whether the next word of the file, which is not taken, passes a test; true at the end.
    pub fn next_begins(&mut self, test: impl FnOnce(u8) -> bool) -> bool {
        !self.next_line() || test(self.text[self.position])
    }

    /// The first word of this line, once more.
    pub fn first_word_of_line(&self) -> Word<'a> {
        let mut again = Self { position: self.line_start, ..*self };
        again.word().unwrap_or(Word { bytes: b"", start: self.line_start })
    }

    /// A finite number; `what` says which, for the message.
    pub fn real(&mut self, what: &'static str) -> Result<f64, SyntaxError> {
        self.skip_blanks();
        if let Ok((value, length)) = fast_float2::parse_partial::<f64, _>(self.unread())
            && value.is_finite()
            && self.ends_word(self.position + length)
        {
            self.position += length;
            return Ok(value);
        }
        let word = self.word().ok_or_else(|| self.missing(what))?;
        self.real_in(word, what)
    }

    /// The finite number that a word is.
    pub fn real_in(&self, word: Word, what: &'static str) -> Result<f64, SyntaxError> {
        parse_real(word.bytes).ok_or_else(|| {
            let mut error = self.unexpected(word, what);
            error.help = number_help(word.bytes, what).or(error.help);
            error
        })
    }

    /// A whole number from `least` to `most`.
    pub fn integer(
        &mut self,
        what: impl Into<Cow<'static, str>>,
        least: i64,
        most: i64,
    ) -> Result<i64, SyntaxError> {
        if let Some(value) = self.plain_integer(|value| (least..=most).contains(&value)) {
            return Ok(value);
        }
        match self.word() {
            Some(word) => self.integer_in(word, what, least, most),
            None => Err(self.missing(what)),
        }
    }

    /// Takes the next word of this line if it is a whole number of few digits without `+`, and is
    /// wanted.
    pub fn plain_integer(&mut self, is_wanted: impl FnOnce(i64) -> bool) -> Option<i64> {
        self.skip_blanks();
        let unread = self.unread();
        let negative = unread.first() == Some(&b'-');
        let digits = &unread[usize::from(negative)..];
        let mut length = 0;
        let mut value = 0_i64;
        while let Some(digit) = digits.get(length).map(|byte| byte.wrapping_sub(b'0'))
            && digit <= 9
            && length < 18
        {
            value = 10 * value + i64::from(digit);
            length += 1;
        }
        let value = if negative { -value } else { value };
        let end = self.position + usize::from(negative) + length;
        let is_whole = length > 0 && self.ends_word(end);
        (is_whole && is_wanted(value)).then(|| {
            self.position = end;
            value
        })
    }

    /// The whole number from `least` to `most` that a word is.
    pub fn integer_in(
        &self,
        word: Word,
        what: impl Into<Cow<'static, str>>,
        least: i64,
        most: i64,
    ) -> Result<i64, SyntaxError> {
        match parse_integer(word.bytes) {
            Some(value) if (least..=most).contains(&value) => Ok(value),
            _ => {
                let mut error = self.unexpected(word, what);
                error.help = number_help(word.bytes, "").or(error.help);
                Err(error)
            }
        }
    }

    /// The error that a word is not what it should be.
    pub fn unexpected(&self, word: Word, expected: impl Into<Cow<'static, str>>) -> SyntaxError {
        if word.start < self.line_start && !self.is_binary {
            return self.unexpected_at(word.start, expected); // it stands in a line before
        }
        let found = Found::Word(String::from_utf8_lossy(word.bytes).into_owned());
        self.error(word.start, self.line, self.line_start, expected.into(), found)
    }

    /// The error that the line, or the file, ends where something should stand.
    pub fn missing(&self, expected: impl Into<Cow<'static, str>>) -> SyntaxError {
        if self.is_binary {
            let end = self.position >= self.text.len();
            let found = if end { Found::EndOfFile } else { Found::EndOfLine };
            return self.error(self.position, 0, 0, expected.into(), found);
        }
        if self.position < self.text.len() {
            let end = trimmed_end(self.text, self.line_start, self.position);
            return self.error(end, self.line, self.line_start, expected.into(), Found::EndOfLine);
        }
        // The place to look at is the end of the last line that holds something, not the empty
        // line after it.
        let body = self.text.trim_ascii_end();
        let end = body.len().max(self.text.len().min(self.first_byte()));
        let start = body.iter().rposition(|&b| b == b'\n' || b == b'\r').map_or(0, |i| i + 1);
        let after = &self.text[end..];
        let breaks = count_breaks(after);
        let line = self.line - breaks;
        self.error(end, line, start.max(self.first_byte()), expected.into(), Found::EndOfFile)
    }

    /// The error that the next word of this line is not what it should be.
    pub fn unexpected_here(&mut self, expected: impl Into<Cow<'static, str>>) -> SyntaxError {
        match self.word() {
            Some(word) => self.unexpected(word, expected),
            None => self.missing(expected),
        }
    }

    /// The error that the file ends within what should stand here.
    pub fn too_short(&self, expected: impl Into<Cow<'static, str>>) -> SyntaxError {
        let place = (self.position, self.line, self.line_start);
        self.error(place.0, place.1, place.2, expected.into(), Found::EndOfFile)
    }

    fn first_byte(&self) -> usize {
        if self.text.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }
    }

    fn error(
        &self,
        at: usize,
        line: u32,
        line_start: usize,
        expected: Cow<'static, str>,
        found: Found,
    ) -> SyntaxError {
        if self.is_binary {
            let (file, text) = (self.file.into(), "".into());
            let (line, column, help) = (0, 0, None);
            return SyntaxError { file, line, column, expected, found, help, text, offset: at };
        }
        let rest = &self.text[line_start..];
        let end = rest.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
        let before = String::from_utf8_lossy(&self.text[line_start..at]);
        SyntaxError {
            file: self.file.into(),
            line,
            column: before.chars().count() as u32 + 1,
            expected,
            found,
            help: binary_help(self.text, &rest[..end]),
            text: String::from_utf8_lossy(&rest[..end]).into(),
            offset: at,
        }
    }

    fn skip_blanks(&mut self) {
        loop {
            match self.class_at(self.position) {
                Some(Class::Blank) => self.position += 1,
                Some(Class::Joint) if self.is_joint(self.position) => {
                    self.position += 1;
                    self.end_line();
                }
                _ => break,
            }
        }
    }

    fn unread(&self) -> &'a [u8] {
        &self.text[self.position..]
    }

    fn class_at(&self, position: usize) -> Option<Class> {
        self.text.get(position).map(|&byte| self.classes[usize::from(byte)])
    }

    /// Whether no word goes on at this position.
    fn ends_word(&self, position: usize) -> bool {
        match self.class_at(position) {
            Some(Class::Word) => false,
            Some(Class::Joint) => self.is_joint(position),
            _ => true,
        }
    }

    /// Whether the byte at this position joins the next line to its own.
    fn is_joint(&self, position: usize) -> bool {
        self.class_at(position) == Some(Class::Joint)
            && self.class_at(position + 1) == Some(Class::End)
    }

    fn skip_to_line_end(&mut self) {
        let rest = &self.text[self.position..];
        self.position += rest.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
    }

    /// Steps over a line end: `\n`, `\r\n` or `\r`.
    fn end_line(&mut self) {
        let pair = self.text[self.position..].starts_with(b"\r\n");
        self.position += if pair { 2 } else { 1 };
        self.line += 1;
        self.line_start = self.position;
    }
}

fn is_white(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c)
}

fn trimmed_end(text: &[u8], start: usize, end: usize) -> usize {
    start + text[start..end].trim_ascii_end().len()
}

fn count_breaks(text: &[u8]) -> u32 {
    let feeds = text.iter().filter(|&&b| b == b'\n').count();
    let returns = text.iter().enumerate();
    let lone = returns.filter(|&(i, &b)| b == b'\r' && text.get(i + 1) != Some(&b'\n')).count();
    (feeds + lone) as u32
}

/// The finite number that a whole word is: decimal, with `e` or Fortran's `d` before the exponent.
pub(crate) fn parse_real(word: &[u8]) -> Option<f64> {
    // `inf`, `nan` and 1e400 are numbers to the parser; no coordinate can be one.
    parse_any_real(word).filter(|value| value.is_finite())
}

/// The number that a whole word is, infinite and no number (`nan`) included.
pub(crate) fn parse_any_real(word: &[u8]) -> Option<f64> {
    match fast_float2::parse::<f64, _>(word) {
        Ok(value) => Some(value),
        Err(_) => parse_fortran(word),
    }
}

fn parse_fortran(word: &[u8]) -> Option<f64> {
    let mut copy = [0; 64];
    let copy = copy.get_mut(..word.len())?;
    copy.copy_from_slice(word);
    let exponent = copy.iter().position(|b| matches!(b, b'd' | b'D'))?;
    copy[exponent] = b'e';
    fast_float2::parse(&*copy).ok()
}

/// The whole number that a whole word is: an optional sign and digits.
pub(crate) fn parse_integer(word: &[u8]) -> Option<i64> {
    let (negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if digits.is_empty() {
        return None;
    }
    digits.iter().try_fold(0_i64, |value, &digit| {
        let digit = i64::from(digit.wrapping_sub(b'0'));
        if digit > 9 {
            return None;
        }
        let value = value.checked_mul(10)?;
        if negative { value.checked_sub(digit) } else { value.checked_add(digit) }
    })
}

fn number_help(word: &[u8], what: &str) -> Option<Cow<'static, str>> {
    if word.contains(&b',') || word.contains(&b';') {
        let coordinate = what.ends_with("coordinate");
        let what = if coordinate { "coordinates" } else { "numbers" };
        return Some(format!("{what} are separated by spaces").into());
    }
    let digits = word.iter().any(u8::is_ascii_digit);
    if digits && fast_float2::parse::<f64, _>(word).is_ok_and(f64::is_infinite) {
        return Some("the largest number is 1.797e308".into());
    }
    None
}

fn binary_help(text: &[u8], line: &[u8]) -> Option<Cow<'static, str>> {
    if text.starts_with(b"\xff\xfe") || text.starts_with(b"\xfe\xff") {
        return Some("the file is UTF-16; save it as UTF-8".into());
    }
    if text.starts_with(b"\x1f\x8b") {
        return Some("the file is compressed with gzip; its name should end in `.gz`".into());
    }
    let control = |b: &u8| b.is_ascii_control() && !is_white(*b);
    line.iter().any(control).then(|| "the file does not look like text".into())
}
