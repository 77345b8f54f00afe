//! Numbers as text: the shortest that reads back the same.

/// The numbers 00 to 99: digits are made two by two.
const PAIRS: [[u8; 2]; 100] = {
    let mut pairs = [[0; 2]; 100];
    let mut number = 0;
    while number < 100 {
        pairs[number] = [b'0' + number as u8 / 10, b'0' + number as u8 % 10];
        number += 1;
    }
    pairs
};

/// Appends a whole number.
pub(crate) fn push_integer(out: &mut Vec<u8>, value: impl Into<i64>) {
    let value = value.into();
    let mut digits = [0; 20];
    let mut start = digits.len();
    let mut rest = value.unsigned_abs();
    while rest >= 100 {
        start -= 2;
        digits[start..start + 2].copy_from_slice(&PAIRS[(rest % 100) as usize]);
        rest /= 100;
    }
    let pair = PAIRS[rest as usize];
    let first = usize::from(rest < 10);
    start -= 2 - first;
    digits[start..start + 2 - first].copy_from_slice(&pair[first..]);
    if value < 0 {
        out.push(b'-');
    }
    out.extend_from_slice(&digits[start..]);
}

/// Appends a number; whole ones without their `.0`.
pub(crate) fn push_real(out: &mut Vec<u8>, value: f64) {
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format(value);
    out.extend_from_slice(text.strip_suffix(".0").unwrap_or(text).as_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integer(value: i64) -> String {
        let mut out = Vec::new();
        push_integer(&mut out, value);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn whole_numbers_are_written_to_their_ends() {
        for value in [0, 7, 10, 99, 100, 101, 1_234, 56_780, -1, i64::MIN, i64::MAX] {
            assert_eq!(integer(value), value.to_string());
        }
    }

    #[test]
    fn numbers_read_back_bit_for_bit() {
        for value in [0.0, -0.0, 1.0, 0.1, 1e300, 5e-324, -1.0 / 3.0, 123_456_789.125] {
            let mut out = Vec::new();
            push_real(&mut out, value);
            let read = crate::text::parse_real(&out).map(f64::to_bits);
            assert_eq!(read, Some(value.to_bits()), "{}", String::from_utf8_lossy(&out));
        }
    }
}
