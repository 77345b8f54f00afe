//! The bytes and numbers of a `.vtu` file's arrays: raw or Base64, compressed or not, or text.
//!
//! ```text
//! plain      := <number of bytes> <bytes>
//! compressed := <blocks> <bytes of a block> <bytes of the last one, if fewer> <bytes, compressed>*
//!               <compressed block>*
//! ```
//!
//! Counts are of 32 or 64 bits, as the header tells. In Base64 the counts may be padded apart from
//! what follows.

use std::io::Read;

use base64::engine::{GeneralPurpose, GeneralPurposeConfig};
use base64::{DecodeError, Engine, alphabet};
use flate2::read::ZlibDecoder;

use super::Fault;
use super::header::{Content, Description, Header};
use crate::mesh::Values;
use crate::text::{parse_any_real, parse_integer};

/// The file that arrays are read from.
#[derive(Clone, Copy)]
pub(super) struct Arrays<'a> {
    pub header: &'a Header,
    /// The XML, with the arrays between its tags.
    pub xml: &'a [u8],
    /// The appended data, after their `_`.
    pub data: &'a [u8],
}

impl Arrays<'_> {
    /// The numbers of an array; `expected` of them, where that is known.
    pub fn values(&self, array: &Description, expected: Option<u64>) -> Result<Values, Fault> {
        let values = match &array.content {
            Content::Text(range) => words(array, &self.xml[range.clone()])?,
            _ => numbers(array, &self.bytes(array)?, self.header.is_big_endian)?,
        };
        let found = match &values {
            Values::Real(values) => values.len() as u64,
            Values::Integer(values) => values.len() as u64,
        };
        match expected {
            Some(expected) if expected != found => {
                Err(Fault::Length { array: array.name.clone(), expected, found })
            }
            _ => Ok(values),
        }
    }

    fn bytes(&self, array: &Description) -> Result<Vec<u8>, Fault> {
        let available = self.data.len() as u64;
        let mut coded = match &array.content {
            Content::Appended(offset) => {
                let start = usize::try_from(*offset).ok().filter(|&start| start <= self.data.len());
                let Some(start) = start else {
                    let array = array.name.clone();
                    return Err(Fault::Truncated { array, end: *offset, available });
                };
                Coded::new(&array.name, &self.data[start..], self.header.is_base64)
            }
            Content::Text(range) | Content::Base64(range) => {
                Coded::new(&array.name, &self.xml[range.clone()], true)
            }
        };
        if self.header.is_compressed { self.unpacked(&mut coded) } else { self.plain(&mut coded) }
    }

    fn plain(&self, coded: &mut Coded) -> Result<Vec<u8>, Fault> {
        if coded.is_empty() {
            return Ok(Vec::new()); // an array of nothing
        }
        let length = self.count(coded)?;
        coded.take(length)
    }

    fn unpacked(&self, coded: &mut Coded) -> Result<Vec<u8>, Fault> {
        if coded.is_empty() {
            return Ok(Vec::new());
        }
        let blocks = self.count(coded)?;
        if blocks == 0 {
            return Ok(Vec::new());
        }
        let (whole, last) = (self.count(coded)?, self.count(coded)?);
        // Each count takes bytes: there cannot be more of them than are left.
        let mut lengths = Vec::new();
        for _ in 0..blocks {
            lengths.push(self.count(coded)?);
        }
        let mut bytes = Vec::new();
        for (block, length) in lengths.into_iter().enumerate() {
            let is_last = block as u64 + 1 == blocks;
            let size = if is_last && last != 0 { last } else { whole };
            let packed = coded.take(length)?;
            let before = bytes.len() as u64;
            let mut limited = ZlibDecoder::new(packed.as_slice()).take(size.saturating_add(1));
            let read = limited.read_to_end(&mut bytes);
            let found = match read {
                Ok(_) if bytes.len() as u64 - before == size => continue,
                Ok(_) if bytes.len() as u64 - before > size => "more".to_owned(),
                Ok(_) => format!("{} bytes", bytes.len() as u64 - before),
                Err(error) => format!("what zlib cannot read ({error})"),
            };
            let expected = "compressed blocks of the announced size";
            return Err(Fault::Coded { array: coded.array.to_owned(), expected, found });
        }
        Ok(bytes)
    }

    /// A count at the head of an array.
    fn count(&self, coded: &mut Coded) -> Result<u64, Fault> {
        let size = if self.header.is_wide { 8 } else { 4 };
        let mut bytes = coded.take(size)?;
        if self.header.is_big_endian {
            bytes.reverse();
        }
        Ok(bytes.iter().rev().fold(0, |value, &byte| value << 8 | u64::from(byte)))
    }
}

/// What stands behind the last byte does not count: writers differ.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_allow_trailing_bits(true),
);

/// Bytes that stand in a file as they are, or in Base64.
struct Coded<'a> {
    array: &'a str,
    rest: &'a [u8],
    is_base64: bool,
    /// Decoded bytes that were not taken yet.
    waiting: Vec<u8>,
    /// How many were taken.
    taken: u64,
}

impl<'a> Coded<'a> {
    fn new(array: &'a str, rest: &'a [u8], is_base64: bool) -> Self {
        Self { array, rest, is_base64, waiting: Vec::new(), taken: 0 }
    }

    fn is_empty(&self) -> bool {
        self.rest.trim_ascii_start().is_empty()
    }

    /// The next bytes, as many as are wanted.
    fn take(&mut self, count: u64) -> Result<Vec<u8>, Fault> {
        let end = self.taken.saturating_add(count);
        let truncated = |available: usize| Fault::Truncated {
            array: self.array.to_owned(),
            end,
            available: self.taken + available as u64,
        };
        // Base64 is longer than what it stands for.
        let most = self.rest.len() + self.waiting.len();
        let count = usize::try_from(count).ok().filter(|&count| count <= most);
        let count = count.ok_or_else(|| truncated(most))?;
        self.taken = end;
        if !self.is_base64 {
            let (taken, rest) = self.rest.split_at(count);
            self.rest = rest;
            return Ok(taken.to_vec());
        }
        while self.waiting.len() < count {
            if !self.decode_four()? {
                let available = self.taken - count as u64 + self.waiting.len() as u64;
                return Err(Fault::Truncated { array: self.array.to_owned(), end, available });
            }
        }
        let rest = self.waiting.split_off(count);
        Ok(std::mem::replace(&mut self.waiting, rest))
    }

    /// Decodes the next four letters to up to three bytes; false where there are none.
    fn decode_four(&mut self) -> Result<bool, Fault> {
        let mut four = [0; 4];
        let mut letters = 0;
        while letters < 4 {
            let Some((&letter, rest)) = self.rest.split_first() else { break };
            if letter == b'<' {
                break; // the end of the appended data
            }
            self.rest = rest;
            if letter.is_ascii_whitespace() {
                continue;
            }
            four[letters] = letter;
            letters += 1;
        }
        if letters == 0 {
            return Ok(false);
        }
        let letters = &four[..letters];
        BASE64.decode_vec(letters, &mut self.waiting).map_err(|error| match error {
            DecodeError::InvalidByte(_, byte) => self.no_base64(format!("byte {byte}")),
            _ => self.no_base64(format!("`{}`", String::from_utf8_lossy(letters))),
        })?;
        Ok(true)
    }

    fn no_base64(&self, found: String) -> Fault {
        let expected = "Base64, four letters for three bytes";
        Fault::Coded { array: self.array.to_owned(), expected, found }
    }
}

/// The numbers that bytes stand for.
fn numbers(array: &Description, bytes: &[u8], is_big_endian: bool) -> Result<Values, Fault> {
    fn each<const N: usize, T>(
        bytes: &[u8],
        is_big_endian: bool,
        number: impl Fn([u8; N]) -> T,
    ) -> Vec<T> {
        let chunks = bytes.chunks_exact(N).filter_map(|chunk| <[u8; N]>::try_from(chunk).ok());
        let little = chunks.map(|mut chunk| {
            if is_big_endian {
                chunk.reverse();
            }
            chunk
        });
        little.map(number).collect()
    }
    let big = is_big_endian;
    let values = match array.kind.as_str() {
        "Float64" => Values::Real(each(bytes, big, f64::from_le_bytes)),
        "Float32" => Values::Real(each(bytes, big, |b| f64::from(f32::from_le_bytes(b)))),
        "Int64" => Values::Integer(each(bytes, big, i64::from_le_bytes)),
        // What is larger than any index stays so.
        "UInt64" => Values::Integer(each(bytes, big, |b| {
            i64::try_from(u64::from_le_bytes(b)).unwrap_or(i64::MAX)
        })),
        "Int32" => Values::Integer(each(bytes, big, |b| i64::from(i32::from_le_bytes(b)))),
        "UInt32" => Values::Integer(each(bytes, big, |b| i64::from(u32::from_le_bytes(b)))),
        "Int16" => Values::Integer(each(bytes, big, |b| i64::from(i16::from_le_bytes(b)))),
        "UInt16" => Values::Integer(each(bytes, big, |b| i64::from(u16::from_le_bytes(b)))),
        "Int8" => Values::Integer(each(bytes, big, |b| i64::from(i8::from_le_bytes(b)))),
        "UInt8" => Values::Integer(each(bytes, big, |[b]: [u8; 1]| i64::from(b))),
        _ => return Err(other_type(array)),
    };
    Ok(values)
}

/// The numbers that words stand for.
fn words(array: &Description, text: &[u8]) -> Result<Values, Fault> {
    let words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let wrong = |index, expected, word: &[u8]| Fault::Value {
        array: array.name.clone(),
        index,
        expected,
        found: format!("`{}`", String::from_utf8_lossy(&word[..word.len().min(40)])),
    };
    let words = words.enumerate();
    if array.kind.starts_with("Float") {
        let real =
            |(index, word)| parse_any_real(word).ok_or_else(|| wrong(index, "a number", word));
        return words.map(real).collect::<Result<_, _>>().map(Values::Real);
    }
    if !array.kind.contains("Int") {
        return Err(other_type(array));
    }
    let whole = |(index, word)| {
        parse_integer(word).ok_or_else(|| wrong(index, "a whole number of 64 bits", word))
    };
    words.map(whole).collect::<Result<_, _>>().map(Values::Integer)
}

fn other_type(array: &Description) -> Fault {
    let (attribute, expected) = ("type", "Float64, Int64 or a smaller type");
    Fault::Unsupported { attribute, expected, found: array.kind.clone() }
}
