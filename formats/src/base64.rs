//! Base64: bytes as text.

use std::io::Write;

use crate::rows::Rows;

/// Bytes on their way to Base64 (RFC 4648, section 4): three become four letters.
#[derive(Default)]
pub(crate) struct Base64 {
    /// What waits for the rest of its three bytes.
    waiting: Vec<u8>,
}

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

impl Base64 {
    pub fn push<W: Write>(&mut self, bytes: &[u8], rows: &mut Rows<W>) {
        let needed = (3 - self.waiting.len()) % 3;
        let (first, rest) = bytes.split_at(needed.min(bytes.len()));
        self.waiting.extend_from_slice(first);
        if self.waiting.len() == 3 {
            rows.bytes(&letters(&self.waiting));
            self.waiting.clear();
        }
        let (whole, rest) = rest.split_at(rest.len() / 3 * 3);
        whole.chunks_exact(3).for_each(|three| rows.bytes(&letters(three)));
        self.waiting.extend_from_slice(rest);
    }

    pub fn finish<W: Write>(self, rows: &mut Rows<W>) {
        if !self.waiting.is_empty() {
            let mut four = letters(&self.waiting);
            four[self.waiting.len() + 1..].fill(b'=');
            rows.bytes(&four);
        }
    }
}

/// The letters of up to three bytes.
fn letters(bytes: &[u8]) -> [u8; 4] {
    let bits = (0..3).fold(0, |bits, i| bits << 8 | u32::from(*bytes.get(i).unwrap_or(&0)));
    [18, 12, 6, 0].map(|shift| LETTERS[(bits >> shift) as usize & 63])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text of some bytes, pushed in parts of this size.
    fn base64(bytes: &[u8], part: usize) -> String {
        let mut out = Vec::new();
        let mut rows = Rows::new(&mut out);
        let mut text = Base64::default();
        bytes.chunks(part).for_each(|part| text.push(part, &mut rows));
        text.finish(&mut rows);
        rows.finish().unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn base64_is_that_of_the_standard() {
        // The examples of RFC 4648, section 10.
        let examples = ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"];
        for (length, expected) in examples.into_iter().enumerate() {
            for part in 1..=6 {
                assert_eq!(base64(&b"foobar"[..length], part), expected);
            }
        }
        assert_eq!(base64(&[0xfb, 0xff, 0xbf], 2), "+/+/");
    }
}
