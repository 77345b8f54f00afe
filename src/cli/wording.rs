//! Numbers and nouns as the summaries write them.

/// `1 294`: digits in groups of three.
pub fn grouped(number: impl TryInto<u64>) -> String {
    let number: u64 = number.try_into().unwrap_or(u64::MAX);
    group_digits(&number.to_string())
}

/// `1 point`, `1 294 points`.
pub fn count(number: usize, noun: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{} {noun}{plural}", grouped(number as u64))
}

/// An angle in degrees, with as many digits as tell something: `26.45°`, `126.9°`, `0.042°`,
/// `5.7e-8°`.
pub fn angle(radians: f64) -> String {
    let degrees = radians.to_degrees();
    format!(
        "{}°",
        match degrees {
            d if d >= 100.0 => format!("{d:.1}"),
            d if d >= 0.1 => format!("{d:.2}"),
            _ => significant(degrees, 2),
        }
    )
}

/// A size in bytes: `212 kB`.
pub fn bytes(size: u64) -> String {
    const UNITS: [&str; 5] = ["B", "kB", "MB", "GB", "TB"];
    let mut value = size as f64;
    let mut unit = 0;
    while value >= 999.5 && unit + 1 < UNITS.len() {
        value /= 1000.0;
        unit += 1;
    }
    let digits = usize::from(unit > 1 && value < 99.95);
    format!("{value:.digits$} {}", UNITS[unit])
}

/// A number to so many significant digits, without zeros at its end: `0.003`, `1.2e-9`.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-4..9).contains(&exponent) {
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
    group_number(trimmed(&format!("{value:.decimals$}")))
}

/// Coordinates `(x, y)`, to four digits of the extent they belong to.
pub fn place([x, y]: [f64; 2], extent: f64) -> String {
    format!("({}, {})", coordinate(x, extent), coordinate(y, extent))
}

fn coordinate(value: f64, extent: f64) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    let magnitude = value.abs().max(extent);
    // Decimal exponents: of the number itself, and of the last digit worth showing.
    let exponent =
        |x: f64| format!("{x:e}").split_once('e').map_or(0, |e| e.1.parse().unwrap_or(0));
    let last: i32 = if extent > 0.0 { exponent(extent) - 3 } else { exponent(value.abs()) - 3 };
    if exponent(magnitude) < 9 && last > -9 {
        let decimals = (-last).max(0) as usize;
        let text = group_number(trimmed(&format!("{value:.decimals$}")));
        return if text == "-0" { "0".to_string() } else { text };
    }
    let digits = (exponent(value.abs()) - last).clamp(0, 16) as usize;
    let text = format!("{value:.digits$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}e{exponent}", trimmed(mantissa))
}

/// Without the zeros after a decimal point that say nothing.
fn trimmed(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

fn group_number(number: &str) -> String {
    let (sign, number) = match number.strip_prefix('-') {
        Some(number) => ("-", number),
        None => ("", number),
    };
    let (whole, fraction) = match number.split_once('.') {
        Some((whole, fraction)) => (whole, format!(".{fraction}")),
        None => (number, String::new()),
    };
    format!("{sign}{}{fraction}", group_digits(whole))
}

fn group_digits(digits: &str) -> String {
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_stand_in_groups_of_three() {
        assert_eq!(grouped(7_u64), "7");
        assert_eq!(grouped(1294_u64), "1 294");
        assert_eq!(grouped(12_345_678_u64), "12 345 678");
        assert_eq!(count(1, "point"), "1 point");
    }

    #[test]
    fn angles_have_the_digits_that_tell() {
        let texts =
            [126.93, 26.450_057, 5.85, 0.1, 0.0421, 5.73e-8].map(|d: f64| angle(d.to_radians()));
        assert_eq!(texts, ["126.9°", "26.45°", "5.85°", "0.10°", "0.042°", "5.7e-8°"]);
    }

    #[test]
    fn sizes_have_three_digits() {
        let texts = [999, 1_000, 211_700, 1_234_567, 250_000_000].map(bytes);
        assert_eq!(texts, ["999 B", "1 kB", "212 kB", "1.2 MB", "250 MB"]);
    }

    #[test]
    fn places_are_as_fine_as_the_extent() {
        assert_eq!(place([431_200.5, 5_402_310.24], 787.6), "(431 200.5, 5 402 310.2)");
        assert_eq!(place([0.31, -0.2], 1.0), "(0.31, -0.2)");
        assert_eq!(place([-1e-9, 2.0], 1.0), "(0, 2)");
        assert_eq!(place([1e300, 0.0], 2e300), "(1e300, 0)");
        assert_eq!(place([1.5e-160, 0.0], 2e-160), "(1.5e-160, 0)");
    }
}
