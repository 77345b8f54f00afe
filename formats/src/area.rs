//! Largest areas of triangles in Triangle's `.area` files.
//!
//! ```text
//! area  := <number of triangles> bound*
//! bound := <number> <largest area; negative: no bound>
//! ```
//!
//! One line each, in the order of the `.ele` file of the same name; `#` starts a comment
//! (<https://www.cs.cmu.edu/~quake/triangle.area.html>).

use crate::error::{Notice, SyntaxError, Warning};
use crate::node::{Lines, MOST, reserved, trailing_text};
use crate::poly::bound;
use crate::text::Scanner;

/// Reads the text of a `.area` file: for each triangle its largest area, if it has one.
///
/// `file` is the name that messages use.
///
/// # Errors
/// The first word that cannot be read.
///
/// ```
/// use meshwright_formats::area;
/// let (areas, warnings) = area::read(b"2\n1 0.5\n2 -1\n", "a.1.area")?;
/// assert_eq!(areas, [Some(0.5), None]);
/// assert!(warnings.is_empty());
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(text: &[u8], file: &str) -> Result<(Vec<Option<f64>>, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::new(text, file, Some(b'#'));
    let mut warnings = Vec::new();
    scanner.next_line();
    let header = scanner.line();
    let count = scanner.integer("the number of triangles", 0, MOST)?;
    let mut extra = Lines::default();
    extra.ignore_rest(&mut scanner);
    // The shortest bound, `1 1` and a line end, has four bytes.
    let mut areas = Vec::with_capacity(reserved(count, scanner.left(), 4));
    for index in 0..count {
        if !scanner.next_line() {
            return Err(scanner.missing(format!("the area of triangle {} of {count}", index + 1)));
        }
        scanner.integer("the number of a triangle", i64::MIN, i64::MAX)?;
        areas.push(bound(Some(scanner.real("a largest area")?)));
        extra.ignore_rest(&mut scanner);
    }
    extra.warn(&scanner, &mut warnings, |lines| Notice::ExtraColumns { lines, header });
    trailing_text(&mut scanner, &mut warnings);
    Ok((areas, warnings))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        let message = read(text.as_bytes(), "a.area").unwrap_err().to_string();
        message.lines().next().unwrap_or_default().to_owned()
    }

    #[test]
    fn bounds_that_are_not_positive_are_none() {
        let (areas, _) = read(b"# a comment\n3\n0 1e-3\n1 0\n2 -1\n", "a.area").unwrap();
        assert_eq!(areas, [Some(1e-3), None, None]);
    }

    #[test]
    fn what_is_no_area_is_named() {
        assert_eq!(
            error("2\n1 0.1\n2 minus\n"),
            "a.area:3:3: expected a largest area, found `minus`"
        );
        let end = "a.area:2:6: expected the area of triangle 2 of 2, found the end of the file";
        assert_eq!(error("2\n1 0.1\n"), end);
    }

    #[test]
    fn text_that_is_not_read_is_told() {
        let (areas, warnings) = read(b"1\n1 0.1 7\n2 0.1\n", "a.area").unwrap();
        assert_eq!(areas, [Some(0.1)]);
        let warnings: Vec<_> = warnings.iter().map(Warning::to_string).collect();
        assert_eq!(
            warnings,
            [
                "a.area:2: 1 line has more columns than the header (line 1) announces; they are \
                 ignored",
                "a.area:3: the file goes on after its last section; 1 line is ignored",
            ]
        );
    }
}
