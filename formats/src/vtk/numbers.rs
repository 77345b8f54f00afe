//! The numbers of a legacy `.vtk` file: words, or bytes of which the highest comes first.

use crate::error::SyntaxError;
use crate::text::{Scanner, parse_any_real, parse_integer};

/// How numbers stand in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Numbers {
    Text,
    Binary,
}

/// A type of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Kind {
    /// In bytes.
    pub size: usize,
    class: Class,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Class {
    Real,
    Signed,
    Unsigned,
}

impl Kind {
    pub const INT: Self = Self { size: 4, class: Class::Signed };
    pub const FLOAT: Self = Self { size: 4, class: Class::Real };
    pub const BYTE: Self = Self { size: 1, class: Class::Unsigned };

    /// The type that the next word names.
    pub fn read(scanner: &mut Scanner) -> Result<Self, SyntaxError> {
        let what = "a type of numbers: double, float, int, vtktypeint64 …";
        let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
        let (size, class) = match word.bytes.to_ascii_lowercase().as_slice() {
            b"double" => (8, Class::Real),
            b"float" => (4, Class::Real),
            b"vtktypeint64" | b"long" | b"long_long" => (8, Class::Signed),
            b"vtktypeuint64" | b"unsigned_long" | b"unsigned_long_long" => (8, Class::Unsigned),
            b"int" | b"vtkidtype" | b"vtktypeint32" => (4, Class::Signed),
            b"unsigned_int" | b"vtktypeuint32" => (4, Class::Unsigned),
            b"short" | b"vtktypeint16" => (2, Class::Signed),
            b"unsigned_short" | b"vtktypeuint16" => (2, Class::Unsigned),
            b"char" | b"signed_char" | b"vtktypeint8" => (1, Class::Signed),
            b"unsigned_char" | b"vtktypeuint8" => (1, Class::Unsigned),
            _ => return Err(scanner.unexpected(word, what)),
        };
        Ok(Self { size, class })
    }

    pub fn is_real(self) -> bool {
        self.class == Class::Real
    }

    /// The whole number that bytes stand for; one that is too large for 64 bits with a sign is the
    /// largest.
    fn whole(self, bytes: &[u8]) -> i64 {
        let is_negative = self.class == Class::Signed && bytes.first().is_some_and(|b| b >> 7 == 1);
        let start = if is_negative { u64::MAX } else { 0 };
        let bits = bytes.iter().fold(start, |bits, &byte| bits << 8 | u64::from(byte));
        match self.class {
            Class::Unsigned => i64::try_from(bits).unwrap_or(i64::MAX),
            _ => bits as i64,
        }
    }

    fn real(self, bytes: &[u8]) -> f64 {
        match (self.class, bytes) {
            (Class::Real, &[a, b, c, d]) => f32::from_be_bytes([a, b, c, d]).into(),
            (Class::Real, &[a, b, c, d, e, f, g, h]) => {
                f64::from_be_bytes([a, b, c, d, e, f, g, h])
            }
            _ => self.whole(bytes) as f64,
        }
    }
}

/// Numbers that are handed on at once.
const BLOCK: usize = 1 << 12;

impl Numbers {
    /// Hands on so many numbers, finite or not, block by block.
    pub fn reals(
        self,
        scanner: &mut Scanner,
        kind: Kind,
        count: usize,
        take: impl FnMut(&[f64]),
    ) -> Result<(), SyntaxError> {
        self.read(scanner, (kind, count), "a number", (parse_any_real, Kind::real), take)
    }

    /// Hands on so many whole numbers, block by block.
    pub fn wholes(
        self,
        scanner: &mut Scanner,
        kind: Kind,
        count: usize,
        take: impl FnMut(&[i64]),
    ) -> Result<(), SyntaxError> {
        self.read(scanner, (kind, count), "a whole number", (parse_integer, Kind::whole), take)
    }

    fn read<T>(
        self,
        scanner: &mut Scanner,
        (kind, count): (Kind, usize),
        what: &'static str,
        (parse, decode): (impl Fn(&[u8]) -> Option<T>, impl Fn(Kind, &[u8]) -> T),
        mut take: impl FnMut(&[T]),
    ) -> Result<(), SyntaxError> {
        let mut numbers = Vec::with_capacity(BLOCK.min(count));
        if self == Self::Binary {
            let bytes = count.checked_mul(kind.size).and_then(|size| scanner.take(size));
            let Some(bytes) = bytes else {
                return Err(scanner.too_short(format!("{count} numbers of {} bytes", kind.size)));
            };
            for block in bytes.chunks(BLOCK * kind.size) {
                numbers.clear();
                numbers.extend(block.chunks_exact(kind.size).map(|bytes| decode(kind, bytes)));
                take(&numbers);
            }
            return Ok(());
        }
        for index in 0..count {
            scanner.next_line();
            let Some(word) = scanner.word() else {
                return Err(scanner.missing(format!("number {} of {count}", index + 1)));
            };
            match parse(word.bytes) {
                Some(number) => numbers.push(number),
                None => return Err(scanner.unexpected(word, what)),
            }
            if numbers.len() == BLOCK {
                take(&numbers);
                numbers.clear();
            }
        }
        take(&numbers);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_numbers_with_the_highest_first() {
        assert_eq!(Kind::INT.whole(&[0xff, 0xff, 0xff, 0xfe]), -2);
        assert_eq!(Kind::INT.whole(&[0, 0, 1, 2]), 258);
        assert_eq!(Kind::BYTE.whole(&[0xff]), 255);
        let unsigned = Kind { size: 8, class: Class::Unsigned };
        assert_eq!(unsigned.whole(&[0xff; 8]), i64::MAX);
        assert_eq!(Kind::FLOAT.real(&1.5_f32.to_be_bytes()), 1.5);
        let double = Kind { size: 8, class: Class::Real };
        assert_eq!(double.real(&(-0.1_f64).to_be_bytes()), -0.1);
    }
}
