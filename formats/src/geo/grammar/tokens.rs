//! Words, numbers, texts and symbols, and what may stand between them.
//!
//! ```text
//! blank  := (white space | '//' … end of line | '/*' … '*/')*
//! word   := letter (letter | digit)*          letters: A–Z, a–z, _
//! number := digits ['.' [digits]] [exponent] | '.' digits [exponent]
//! text   := '"' … '"' | "'" … "'"             no escapes: a backslash is a backslash
//! ```

use nom::Err;

use super::input::{Fault, Parsed, Text};
use crate::text::parse_real;

/// Goes past white space and comments.
pub(super) fn blank(mut input: Text) -> Result<Text, Err<Fault>> {
    loop {
        let rest = input.rest;
        match rest {
            [b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c, ..] => input = input.after(1),
            [b'/', b'/', ..] => {
                let end = rest.iter().position(|b| matches!(b, b'\n' | b'\r'));
                input = input.after(end.unwrap_or(rest.len()));
            }
            [b'/', b'*', ..] => match rest[2..].windows(2).position(|pair| pair == b"*/") {
                Some(end) => input = input.after(end + 4),
                None => return Err(Err::Failure(input.fault("a comment that ends with `*/`"))),
            },
            _ => return Ok(input),
        }
    }
}

/// Whether everything that is left is blank.
pub(super) fn at_end(input: Text) -> Result<bool, Err<Fault>> {
    Ok(blank(input)?.rest.is_empty())
}

/// A symbol such as `{` or `+=`.
pub(super) fn symbol<'a>(symbol: &'static str) -> impl Fn(Text<'a>) -> Parsed<'a, ()> {
    move |input| {
        let begin = blank(input)?;
        if begin.rest.starts_with(symbol.as_bytes()) {
            return Ok((begin.after(symbol.len()), ()));
        }
        begin.no(symbol)
    }
}

/// A symbol that must come next. Where it is missing, the place is the end of what stands before.
pub(super) fn must<'a>(wanted: &'static str) -> impl Fn(Text<'a>) -> Parsed<'a, ()> {
    move |input| match symbol(wanted)(input) {
        Err(Err::Error(_)) => {
            let begin = blank(input)?;
            let between = &input.rest[..input.rest.len() - begin.rest.len()];
            let place = if between.contains(&b'\n') { input } else { begin };
            place.must(format!("`{wanted}`"))
        }
        answer => answer,
    }
}

/// A word.
pub(super) fn word<'a>(input: Text<'a>) -> Parsed<'a, &'a str> {
    let begin = blank(input)?;
    let is_letter = |b: u8| b.is_ascii_alphabetic() || b == b'_';
    if !begin.rest.first().is_some_and(|&b| is_letter(b)) {
        return begin.no("a name");
    }
    let end = begin.rest.iter().position(|&b| !is_letter(b) && !b.is_ascii_digit());
    let (word, _) = begin.rest.split_at(end.unwrap_or(begin.rest.len()));
    let word = std::str::from_utf8(word).expect("letters and digits are UTF-8");
    Ok((begin.after(word.len()), word))
}

/// This very word.
pub(super) fn keyword<'a>(wanted: &'static str) -> impl Fn(Text<'a>) -> Parsed<'a, ()> {
    move |input| match word(input)? {
        (rest, found) if found == wanted => Ok((rest, ())),
        _ => blank(input)?.no(wanted),
    }
}

/// A number without a sign.
pub(super) fn number(input: Text) -> Parsed<f64> {
    let begin = blank(input)?;
    let length = number_length(begin.rest);
    if length == 0 {
        return begin.no("a number");
    }
    match parse_real(&begin.rest[..length]) {
        Some(value) => Ok((begin.after(length), value)),
        None => begin.must("a finite number (the largest is 1.797e308)"),
    }
}

/// How many bytes at the start make a number; 0 if they make none.
fn number_length(bytes: &[u8]) -> usize {
    let digits = |from: usize| {
        bytes[from..].iter().position(|b| !b.is_ascii_digit()).unwrap_or(bytes.len() - from)
    };
    let whole = digits(0);
    let mut length = whole;
    // `1...3` is a range.
    if bytes.get(length) == Some(&b'.') && bytes.get(length + 1) != Some(&b'.') {
        let fraction = digits(length + 1);
        if whole + fraction == 0 {
            return 0;
        }
        length += 1 + fraction;
    }
    if length > 0 && matches!(bytes.get(length), Some(b'e' | b'E' | b'd' | b'D')) {
        let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
        let exponent = bytes.get(length + 1 + sign).map_or(0, |_| digits(length + 1 + sign));
        if exponent > 0 {
            length += 1 + sign + exponent;
        }
    }
    length
}

/// A text in quotes.
pub(super) fn text(input: Text) -> Parsed<String> {
    let begin = blank(input)?;
    let Some(&quote @ (b'"' | b'\'')) = begin.rest.first() else {
        return begin.no("a text in quotes");
    };
    let Some(length) = begin.rest[1..].iter().position(|&b| b == quote) else {
        return begin.must(format!("a text that ends with `{}`", char::from(quote)));
    };
    let text = String::from_utf8_lossy(&begin.rest[1..=length]).into_owned();
    Ok((begin.after(length + 2), text))
}

/// Where [`passed_over`] ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Until {
    /// After a `;` that no brace encloses.
    Semicolon,
    /// Before a `;` that no brace encloses.
    BeforeSemicolon,
    /// After a `;`, or after the brace that closes the first one.
    Block,
    /// Before the bracket that closes one opened earlier, or before a comma.
    Bracket,
}

/// Goes past whatever stands here, with its braces, brackets, texts and comments.
pub(super) fn passed_over(input: Text, until: Until) -> Parsed<()> {
    let mut depth = 0_u32;
    let mut rest = input;
    loop {
        rest = blank(rest)?;
        match rest.rest.first() {
            None if until == Until::Bracket => return rest.must("`]`"),
            None => return rest.must("`;`"),
            Some(b'"' | b'\'') => {
                rest = text(rest)?.0;
                continue;
            }
            Some(b';') if depth == 0 => match until {
                Until::BeforeSemicolon => return Ok((rest, ())),
                Until::Bracket => return rest.must("`]`"),
                Until::Semicolon | Until::Block => return Ok((rest.after(1), ())),
            },
            Some(b',') if depth == 0 && until == Until::Bracket => return Ok((rest, ())),
            Some(b'{' | b'[' | b'(') => depth += 1,
            Some(b'}' | b']' | b')') if depth == 0 && until == Until::Bracket => {
                return Ok((rest, ()));
            }
            Some(b'}' | b']' | b')') => {
                depth = depth.saturating_sub(1);
                if depth == 0 && until == Until::Block && rest.rest[0] == b'}' {
                    let after = rest.after(1);
                    return Ok((symbol(";")(after).map_or(after, |(after, ())| after), ()));
                }
            }
            Some(_) => {}
        }
        rest = rest.after(1);
    }
}
