//! The numbers of a `.vtu` file's arrays: bytes, or words.

use super::Fault;
use super::header::{Content, Description};
use crate::arrays::Block;
use crate::text::{parse_any_real, parse_integer};

/// A type of numbers: of how many bytes they are, and how these are decoded, the lowest one first.
#[derive(Clone, Copy)]
enum Type {
    Real(usize, fn(&[u8], &mut Vec<f64>)),
    Whole(usize, fn(&[u8], &mut Vec<i64>)),
}

impl Type {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "Float64" => Self::Real(8, |bytes, out| each(bytes, out, f64::from_le_bytes)),
            "Float32" => {
                Self::Real(4, |bytes, out| each(bytes, out, |b| f32::from_le_bytes(b).into()))
            }
            "Int64" => Self::Whole(8, |bytes, out| each(bytes, out, i64::from_le_bytes)),
            // What is larger than any index stays so.
            "UInt64" => Self::Whole(8, |bytes, out| {
                each(bytes, out, |b| i64::try_from(u64::from_le_bytes(b)).unwrap_or(i64::MAX));
            }),
            "Int32" => {
                Self::Whole(4, |bytes, out| each(bytes, out, |b| i32::from_le_bytes(b).into()))
            }
            "UInt32" => {
                Self::Whole(4, |bytes, out| each(bytes, out, |b| u32::from_le_bytes(b).into()))
            }
            "Int16" => {
                Self::Whole(2, |bytes, out| each(bytes, out, |b| i16::from_le_bytes(b).into()))
            }
            "UInt16" => {
                Self::Whole(2, |bytes, out| each(bytes, out, |b| u16::from_le_bytes(b).into()))
            }
            "Int8" => {
                Self::Whole(1, |bytes, out| each(bytes, out, |b| i8::from_le_bytes(b).into()))
            }
            "UInt8" => {
                Self::Whole(1, |bytes, out| each(bytes, out, |b| u8::from_le_bytes(b).into()))
            }
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::Real(size, _) | Self::Whole(size, _) => size,
        }
    }
}

impl Description {
    /// How many bytes a number takes at least.
    pub fn shortest(&self) -> u64 {
        match (&self.content, Type::named(&self.kind)) {
            (Content::Text(_), _) | (_, None) => 2, // a digit and a space
            (_, Some(of)) => of.size() as u64,
        }
    }
}

fn each<const N: usize, T>(bytes: &[u8], out: &mut Vec<T>, number: impl Fn([u8; N]) -> T) {
    let (chunks, _) = bytes.as_chunks::<N>();
    out.clear();
    out.extend(chunks.iter().map(|&chunk| number(chunk)));
}

/// Makes numbers of bytes that come part by part.
pub(super) struct Decoder<'t> {
    /// Nothing for a type that is not known: then the bytes are passed over.
    of: Option<Type>,
    is_big_endian: bool,
    take: &'t mut dyn FnMut(Block),
    /// How many numbers there were.
    found: u64,
    /// Bytes that are not decoded yet.
    waiting: Vec<u8>,
    reals: Vec<f64>,
    wholes: Vec<i64>,
}

impl<'t> Decoder<'t> {
    pub fn new(array: &Description, is_big_endian: bool, take: &'t mut dyn FnMut(Block)) -> Self {
        Self {
            of: Type::named(&array.kind),
            is_big_endian,
            take,
            found: 0,
            waiting: Vec::new(),
            reals: Vec::new(),
            wholes: Vec::new(),
        }
    }

    /// Takes a part of an array.
    pub fn push(&mut self, part: &[u8]) {
        let Some(of) = self.of else { return };
        if self.waiting.is_empty() && part.len().is_multiple_of(of.size()) && !self.is_big_endian {
            return self.decode(of, part);
        }
        let mut bytes = std::mem::take(&mut self.waiting);
        bytes.extend_from_slice(part);
        let whole = bytes.len() / of.size() * of.size();
        if self.is_big_endian {
            bytes[..whole].chunks_exact_mut(of.size()).for_each(<[u8]>::reverse);
        }
        self.decode(of, &bytes[..whole]);
        bytes.drain(..whole);
        self.waiting = bytes;
    }

    /// Hands on the numbers of bytes, the lowest one first.
    fn decode(&mut self, of: Type, bytes: &[u8]) {
        self.found += (bytes.len() / of.size()) as u64;
        match of {
            Type::Real(_, decode) => {
                decode(bytes, &mut self.reals);
                (self.take)(Block::Real(&self.reals));
            }
            Type::Whole(_, decode) => {
                decode(bytes, &mut self.wholes);
                (self.take)(Block::Whole(&self.wholes));
            }
        }
    }

    /// Ends the array: how many numbers there were; bytes that make no number do not count.
    pub fn finish(self, array: &Description) -> Result<u64, Fault> {
        if self.of.is_some() { Ok(self.found) } else { Err(other_type(array)) }
    }
}

/// Words that are parsed before their numbers are handed on.
const WORDS: usize = 1 << 12;

/// Hands on the numbers that words stand for; answers how many there are.
pub(super) fn words(
    array: &Description,
    text: &[u8],
    take: &mut dyn FnMut(Block),
) -> Result<u64, Fault> {
    if array.is_real() {
        return parsed(array, text, ("a number", parse_any_real), |numbers| {
            take(Block::Real(numbers));
        });
    }
    if !array.kind.contains("Int") {
        return Err(other_type(array));
    }
    parsed(array, text, ("a whole number of 64 bits", parse_integer), |numbers| {
        take(Block::Whole(numbers));
    })
}

fn parsed<T>(
    array: &Description,
    text: &[u8],
    (expected, parse): (&'static str, impl Fn(&[u8]) -> Option<T>),
    mut take: impl FnMut(&[T]),
) -> Result<u64, Fault> {
    let words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let (mut found, mut numbers) = (0, Vec::with_capacity(WORDS));
    for (index, word) in words.enumerate() {
        let number = parse(word).ok_or_else(|| Fault::Value {
            array: array.name.clone(),
            index,
            expected,
            found: format!("`{}`", String::from_utf8_lossy(&word[..word.len().min(40)])),
        })?;
        numbers.push(number);
        found += 1;
        if numbers.len() == WORDS {
            take(&numbers);
            numbers.clear();
        }
    }
    take(&numbers);
    Ok(found)
}

fn other_type(array: &Description) -> Fault {
    let (attribute, expected) = ("type", "Float64, Int64 or a smaller type");
    Fault::Unsupported { attribute, expected, found: array.kind.clone() }
}
