//! A file that is cut off ends in an error that names the line at which it ends.

use std::io;

use meshwright_formats::{Pslg, geo, obj, poly};

const STAR: &str = "\
# a square
4 2 0 1
1 0.25 0.5 7
2 1.25 0.5 7
3 1.25 1.5 7
4 0.25 1.5 7
4 1
1 1 2 12
2 2 3 12
3 3 4 12
4 4 1 12
1
1 0.75 0.75
";

const SCRIPT: &str = "\
lc = 0.125;
Point(11) = {0.25, 0.5, 0, lc};
Point(12) = {1.25, 0.5, 0, lc};
Point(13) = {1.25, -1.5e-1, 0, lc};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 11};
For i In {1:2}
  Physical Point(i) = {10 + i};
EndFor
Curve Loop(1) = {11:13};
Plane Surface(21) = {1};
";

const LINES: &str = "\
# a square
v 0.25 0.5 0
v 1.25 0.5 0
v 1.25 1.5 0
v 0.25 1.5 0
o wall
l 1 2 3
l 3 4 1
";

/// The line at which a text ends, an empty one at its end aside.
fn last_line(text: &str) -> usize {
    text.trim_end().lines().count().max(1)
}

/// Cuts a file off behind every byte before `end`: each time the error must name the last line that
/// is left.
fn names_its_last_line(
    whole: &str,
    end: usize,
    read: impl Fn(&str) -> Result<Pslg, (u32, String)>,
) {
    assert!(read(whole).is_ok());
    for length in 0..end {
        let text = &whole[..length];
        let (line, message) = read(text).expect_err(text);
        let last = last_line(text);
        let is_told = message.contains(&format!("line {last} is the last: is the file whole?"));
        assert!(line as usize == last || is_told, "{text}\n{message}");
    }
}

fn no_companion(_: &str) -> io::Result<Vec<u8>> {
    Err(io::ErrorKind::NotFound.into())
}

#[test]
fn a_poly_file_cut_off_anywhere_names_its_last_line() {
    // Up to the ends of the last segment: its marker and the holes may be missing.
    let end = STAR.find("4 4 1").expect("the last segment") + "4 4 ".len();
    names_its_last_line(STAR, end, |text| {
        let read = poly::read(text.as_bytes(), "cut.poly", no_companion);
        read.map(|(outline, _)| outline).map_err(|error| (error.line, error.to_string()))
    });
}

#[test]
fn a_script_cut_off_anywhere_names_its_last_line() {
    names_its_last_line(SCRIPT, SCRIPT.len() - 2, |text| {
        let read = geo::read(text.as_bytes(), "cut.geo", geo::no_includes);
        read.map(|(outline, _)| outline).map_err(|error| (error.line, error.to_string()))
    });
}

#[test]
fn obj_lines_cut_off_anywhere_name_their_last_line_or_tell_it() {
    let read = |text: &str| obj::read(text.as_bytes(), "cut.obj").map(|(outline, _)| outline);
    assert_eq!(read(LINES).expect("it is whole").source.last_line, Some(8));
    for length in 0..LINES.len() {
        let text = &LINES[..length];
        match read(text) {
            // Nothing says how many lines there are: who finds the outline open knows the last.
            Ok(outline) => assert_eq!(outline.source.last_line, Some(last_line(text) as u32)),
            Err(error) => assert_eq!(error.line as usize, last_line(text), "{text}\n{error}"),
        }
    }
}
