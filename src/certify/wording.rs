//! How numbers are written in a report.

use std::fmt;

/// An angle in degrees, as a person writes it.
pub(super) fn degrees(radians: f64) -> String {
    let degrees = radians.to_degrees();
    if degrees >= 100.0 {
        format!("{degrees:.1}°")
    } else if degrees >= 0.1 || degrees == 0.0 {
        format!("{degrees:.2}°")
    } else {
        format!("{:.3}°", Significant(degrees))
    }
}

/// A count with its thousands apart.
pub(super) fn grouped(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// A number with at most `precision` significant digits.
pub(super) struct Significant(pub(super) f64);

impl fmt::Display for Significant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f.precision().unwrap_or(6);
        let scientific = format!("{:.*e}", digits.saturating_sub(1), self.0);
        let exponent = scientific.split_once('e').and_then(|(_, e)| e.parse::<i32>().ok());
        match exponent {
            Some(e) if (-4..digits.max(6) as i32).contains(&e) => {
                let places = (digits as i32 - 1 - e).max(0) as usize;
                let text = format!("{:.*}", places, self.0);
                let text = if text.contains('.') {
                    text.trim_end_matches('0').trim_end_matches('.')
                } else {
                    &text
                };
                f.write_str(text)
            }
            _ => f.write_str(&scientific),
        }
    }
}
