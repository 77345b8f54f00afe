//! `Sprintf`: numbers as texts.

use super::value::Value;
use crate::geo::error::Problem;

/// No number is written wider than this.
const WIDEST: usize = 1000;

/// The text that a format and numbers make.
pub(super) fn sprintf(arguments: Vec<Value>) -> Result<String, Problem> {
    let mut arguments = arguments.into_iter();
    let format = arguments.next().map_or(Ok(String::new()), Value::text)?;
    let mut numbers = Vec::new();
    for argument in arguments {
        numbers.extend(argument.numbers()?);
    }
    let mut numbers = numbers.into_iter();
    let mut out = String::new();
    let mut rest = format.as_str();
    while let Some(start) = rest.find('%') {
        out.push_str(&rest[..start]);
        rest = &rest[start + 1..];
        if let Some(after) = rest.strip_prefix('%') {
            out.push('%');
            rest = after;
            continue;
        }
        let Some((conversion, after)) = Conversion::read(rest) else {
            out.push('%');
            continue;
        };
        rest = after;
        match numbers.next() {
            Some(number) => out.push_str(&conversion.write(number)),
            None => {
                return Err(Problem::Kind {
                    expected: "a number for each `%` of the format".into(),
                    found: "fewer",
                });
            }
        }
    }
    out.push_str(rest);
    Ok(out)
}

/// `%-05.3g`
struct Conversion {
    left: bool,
    plus: bool,
    space: bool,
    zero: bool,
    width: usize,
    precision: Option<usize>,
    letter: char,
}

impl Conversion {
    /// Reads what stands after a `%`.
    fn read(text: &str) -> Option<(Self, &str)> {
        let flags = text.len() - text.trim_start_matches(['-', '+', ' ', '0', '#']).len();
        let (flags, rest) = text.split_at(flags);
        let (width, rest) = digits(rest);
        let (precision, rest) = match rest.strip_prefix('.') {
            Some(rest) => {
                let (precision, rest) = digits(rest);
                (Some(precision.unwrap_or(0)), rest)
            }
            None => (None, rest),
        };
        let rest = rest.trim_start_matches(['l', 'h']);
        let letter = rest.chars().next().filter(|c| "gGfFeEdiu".contains(*c))?;
        let has = |flag| flags.contains(flag);
        let conversion = Self {
            left: has('-'),
            plus: has('+'),
            space: has(' '),
            zero: has('0'),
            width: width.unwrap_or(0).min(WIDEST),
            precision: precision.map(|precision| precision.min(WIDEST)),
            letter: letter.to_ascii_lowercase(),
        };
        Some((conversion, &rest[letter.len_utf8()..]))
    }

    fn write(&self, number: f64) -> String {
        let precision = self.precision.unwrap_or(6);
        let magnitude = number.abs();
        let digits = match self.letter {
            'f' => format!("{magnitude:.precision$}"),
            'e' => scientific(magnitude, precision),
            'g' => general(magnitude, precision.max(1)),
            _ => format!("{:.0}", magnitude.trunc()),
        };
        let sign = match number.is_sign_negative() {
            true if digits.bytes().any(|b| matches!(b, b'1'..=b'9')) => "-",
            _ if self.plus => "+",
            _ if self.space => " ",
            _ => "",
        };
        let padding = self.width.saturating_sub(sign.len() + digits.len());
        match (self.left, self.zero) {
            (true, _) => format!("{sign}{digits}{}", " ".repeat(padding)),
            (false, true) => format!("{sign}{}{digits}", "0".repeat(padding)),
            (false, false) => format!("{}{sign}{digits}", " ".repeat(padding)),
        }
    }
}

fn digits(text: &str) -> (Option<usize>, &str) {
    let length = text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let (digits, rest) = text.split_at(length);
    (digits.parse().ok(), rest)
}

/// `1.500000e+03`
fn scientific(number: f64, precision: usize) -> String {
    let text = format!("{number:.precision$e}");
    let (mantissa, exponent) = text.split_once('e').expect("`{:e}` writes an e");
    let (sign, exponent) = match exponent.strip_prefix('-') {
        Some(exponent) => ('-', exponent),
        None => ('+', exponent),
    };
    format!("{mantissa}e{sign}{exponent:0>2}")
}

/// The shorter of both notations, without zeros at the end.
fn general(number: f64, precision: usize) -> String {
    let scientific = scientific(number, precision - 1);
    let (mantissa, exponent) = scientific.split_once('e').expect("written above");
    let exponent: i64 = exponent.parse().expect("written above");
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    if exponent < -4 || exponent >= precision as i64 {
        return format!("{}e{}", trimmed(mantissa), &scientific[mantissa.len() + 1..]);
    }
    let decimals = (precision as i64 - 1 - exponent).max(0) as usize;
    trimmed(&format!("{number:.decimals$}"))
}
