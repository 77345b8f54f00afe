//! The bytes of a `.vtu` file's arrays, block by block: raw or Base64, compressed or not.
//!
//! ```text
//! plain      := <number of bytes> <bytes>
//! compressed := <blocks> <bytes of a block> <bytes of the last one, if fewer> <bytes, compressed>*
//!               <compressed block>*
//! ```
//!
//! Counts are of 32 or 64 bits, as the header tells. In Base64 the counts may be padded apart from
//! what follows.

use std::io::{BufRead, Read, Seek};

use base64::engine::{GeneralPurpose, GeneralPurposeConfig};
use base64::{DecodeError, Engine, alphabet};
use flate2::read::ZlibDecoder;

use super::Fault;
use super::header::{Content, Description, Header};
use super::numbers::{Decoder, words};
use super::source::{Appended, BLOCK, Source};
use crate::arrays::Block;
use crate::grid::Numbers;

/// The file that arrays are read from.
pub(super) struct Arrays<'a, R> {
    pub header: &'a Header,
    /// The XML, with the arrays between its tags.
    xml: &'a [u8],
    appended: &'a mut Appended<R>,
}

impl<'a, R: Read + Seek> Arrays<'a, R> {
    pub fn new(header: &'a Header, source: &'a mut Source<R>) -> Self {
        Self { header, xml: &source.xml, appended: &mut source.appended }
    }

    /// The numbers of an array; `expected` of them, where that is known.
    pub fn numbers(
        &mut self,
        array: &Description,
        expected: Option<u64>,
    ) -> Result<Numbers, Fault> {
        let room = self.room(array, expected.unwrap_or(0));
        let mut numbers = Numbers::with_capacity(array.is_real(), room);
        self.each(array, expected, &mut |block| numbers.extend(block))?;
        Ok(numbers)
    }

    /// For how many of the announced numbers to make room: no more than the file can hold, if it is
    /// not compressed.
    pub fn room(&self, array: &Description, announced: u64) -> usize {
        let bytes = self.xml.len() as u64 + self.appended.length;
        announced.min(bytes / array.shortest()) as usize
    }

    /// Hands on the numbers of an array; there must be `expected` of them, where that is known.
    pub fn each(
        &mut self,
        array: &Description,
        expected: Option<u64>,
        take: &mut dyn FnMut(Block),
    ) -> Result<(), Fault> {
        let found = match &array.content {
            Content::Text(range) => words(array, &self.xml[range.clone()], take)?,
            _ => {
                let mut decoder = Decoder::new(array, self.header.is_big_endian, take);
                self.bytes(array, &mut decoder)?;
                decoder.finish(array)?
            }
        };
        match expected {
            Some(expected) if expected != found => {
                Err(Fault::Length { array: array.name.clone(), expected, found })
            }
            _ => Ok(()),
        }
    }

    fn bytes(&mut self, array: &Description, decoder: &mut Decoder) -> Result<(), Fault> {
        let header = self.header;
        match &array.content {
            Content::Appended(offset) => {
                let available = self.appended.length;
                if *offset > available {
                    let array = array.name.clone();
                    return Err(Fault::Truncated { array, end: *offset, available });
                }
                if *offset >= self.appended.solid {
                    return Ok(()); // an array of nothing
                }
                let rest = self.appended.at(*offset)?;
                let left = available - offset;
                Coded::new(&array.name, (rest, left), header.is_base64).read(header, decoder)
            }
            Content::Text(range) | Content::Base64(range) => {
                let mut rest = &self.xml[range.clone()];
                if rest.trim_ascii_start().is_empty() {
                    return Ok(());
                }
                let left = rest.len() as u64;
                Coded::new(&array.name, (&mut rest, left), true).read(header, decoder)
            }
        }
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
    rest: &'a mut dyn BufRead,
    /// How many bytes of the file are left.
    left: u64,
    is_base64: bool,
    /// Decoded bytes that were not taken yet.
    waiting: Vec<u8>,
    /// How many were taken.
    taken: u64,
    /// How many will have been taken of what is announced.
    end: u64,
}

impl<'a> Coded<'a> {
    fn new(array: &'a str, (rest, left): (&'a mut dyn BufRead, u64), is_base64: bool) -> Self {
        Self { array, rest, left, is_base64, waiting: Vec::new(), taken: 0, end: 0 }
    }

    /// Reads all that belongs to the array.
    fn read(&mut self, header: &Header, decoder: &mut Decoder) -> Result<(), Fault> {
        if header.is_compressed { self.unpack(header, decoder) } else { self.copy(header, decoder) }
    }

    fn copy(&mut self, header: &Header, decoder: &mut Decoder) -> Result<(), Fault> {
        let length = self.count(header)?;
        self.announce(length)?;
        let mut bytes = Vec::new();
        while self.taken < self.end {
            let missing = self.end - self.taken;
            if self.is_base64 {
                self.fill(missing.min(BLOCK as u64) as usize, &mut bytes)?;
                decoder.push(&bytes);
                continue;
            }
            let block = self.rest.fill_buf()?;
            let count = missing.min(block.len() as u64) as usize;
            if count == 0 {
                return Err(self.truncated(0)); // the file was cut off after its length was asked for
            }
            decoder.push(&block[..count]);
            self.rest.consume(count);
            self.left -= count as u64;
            self.taken += count as u64;
        }
        Ok(())
    }

    fn unpack(&mut self, header: &Header, decoder: &mut Decoder) -> Result<(), Fault> {
        let blocks = self.count(header)?;
        if blocks == 0 {
            return Ok(());
        }
        let (whole, last) = (self.count(header)?, self.count(header)?);
        // Each count takes bytes: there cannot be more of them than are left.
        let mut lengths = Vec::new();
        for _ in 0..blocks {
            lengths.push(self.count(header)?);
        }
        let (mut packed, mut bytes) = (Vec::new(), vec![0; BLOCK]);
        for (block, length) in lengths.into_iter().enumerate() {
            let is_last = block as u64 + 1 == blocks;
            let size = if is_last && last != 0 { last } else { whole };
            self.announce(length)?;
            self.fill(length as usize, &mut packed)?;
            let mut unpacked = ZlibDecoder::new(packed.as_slice()).take(size.saturating_add(1));
            let mut length = 0;
            let end = loop {
                match unpacked.read(&mut bytes) {
                    Ok(0) => break Ok(()),
                    Ok(read) => {
                        decoder.push(&bytes[..read]);
                        length += read as u64;
                    }
                    Err(error) => break Err(error),
                }
            };
            let found = match end {
                Ok(()) if length == size => continue,
                Ok(()) if length > size => "more".to_owned(),
                Ok(()) => format!("{length} bytes"),
                Err(error) => format!("what zlib cannot read ({error})"),
            };
            let expected = "compressed blocks of the announced size";
            return Err(Fault::Coded { array: self.array.to_owned(), expected, found });
        }
        Ok(())
    }

    /// A count at the head of an array.
    fn count(&mut self, header: &Header) -> Result<u64, Fault> {
        let size = if header.is_wide { 8 } else { 4 };
        let mut bytes = Vec::new();
        self.announce(size)?;
        self.fill(size as usize, &mut bytes)?;
        if header.is_big_endian {
            bytes.reverse();
        }
        Ok(bytes.iter().rev().fold(0, |value, &byte| value << 8 | u64::from(byte)))
    }

    /// Begins so many bytes, which may be all that are left and no more.
    fn announce(&mut self, count: u64) -> Result<(), Fault> {
        self.end = self.taken.saturating_add(count);
        // Base64 is longer than what it stands for.
        let most = self.left + self.waiting.len() as u64;
        if count <= most { Ok(()) } else { Err(self.truncated(most)) }
    }

    /// Reads the next bytes of those that were announced.
    fn fill(&mut self, count: usize, bytes: &mut Vec<u8>) -> Result<(), Fault> {
        if self.is_base64 {
            while self.waiting.len() < count {
                if !self.decode(count - self.waiting.len())? {
                    return Err(self.truncated(self.waiting.len() as u64));
                }
            }
            bytes.clear();
            bytes.extend(self.waiting.drain(..count));
        } else {
            bytes.resize(count, 0);
            self.rest.read_exact(bytes)?;
            self.left -= count as u64;
        }
        self.taken += count as u64;
        Ok(())
    }

    fn truncated(&self, more: u64) -> Fault {
        let available = self.taken + more;
        Fault::Truncated { array: self.array.to_owned(), end: self.end, available }
    }

    /// Decodes as many letters as make so many bytes, or fewer; false where there are none.
    fn decode(&mut self, count: usize) -> Result<bool, Fault> {
        let letters = self.letters(4 * count.div_ceil(3))?;
        if letters.is_empty() {
            return Ok(false);
        }
        let before = self.waiting.len();
        if BASE64.decode_vec(&letters, &mut self.waiting).is_ok() {
            return Ok(true);
        }
        // What is padded in between is decoded piece by piece, until something is wrong.
        self.waiting.truncate(before);
        for letters in letters.chunks(4) {
            BASE64.decode_vec(letters, &mut self.waiting).map_err(|error| match error {
                DecodeError::InvalidByte(_, byte) => self.no_base64(format!("byte {byte}")),
                _ => self.no_base64(format!("`{}`", String::from_utf8_lossy(letters))),
            })?;
        }
        Ok(true)
    }

    /// The next letters, without white space, as far as there are so many.
    fn letters(&mut self, count: usize) -> Result<Vec<u8>, Fault> {
        let mut letters = Vec::with_capacity(count.min(BLOCK));
        while letters.len() < count {
            let block = self.rest.fill_buf()?;
            let wanted = count - letters.len();
            let mut seen = 0;
            for &letter in block.iter().take_while(|&&letter| letter != b'<').take(wanted) {
                seen += 1;
                if !letter.is_ascii_whitespace() {
                    letters.push(letter);
                }
            }
            if seen == 0 {
                break; // the end of the appended data
            }
            self.rest.consume(seen);
            self.left -= seen as u64;
        }
        Ok(letters)
    }

    fn no_base64(&self, found: String) -> Fault {
        let expected = "Base64, four letters for three bytes";
        Fault::Coded { array: self.array.to_owned(), expected, found }
    }
}
