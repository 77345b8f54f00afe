//! Reading `.su2`.
//!
//! ```text
//! file    := part*
//! part    := "NDIME=" 2
//!          | "NELEM=" <count> element*
//!          | "NPOIN=" <count> [<points without ghosts>] (<x> <y> [<number>])*
//!          | "NMARK=" <count>
//!          | "MARKER_TAG=" <name> "MARKER_ELEMS=" <count> element*
//!          | <word> "=" …, and the lines of numbers behind it: passed over with a warning
//! element := <VTK's kind: 3 or 5> <point>* [<number>]
//! ```
//!
//! A line each; `%` starts a comment. Points are counted from zero in the order in which they stand;
//! what follows an element's points or a point's coordinates is not looked at, as in SU2.

use std::collections::BTreeSet;

use crate::assembly::{Assembly, Shape};
use crate::error::{Notice, SyntaxError, Warning};
use crate::mesh::Mesh;
use crate::node::{MOST, reserved};
use crate::pslg::Tag;
use crate::tags::{self, Named};
use crate::text::Scanner;

/// Reads the text of an `.su2` file.
///
/// `file` is the name that messages use. Each marker is a group of edges; its tag is the one that
/// its name states (`boundary_3`), the number that its name is, or else the next that is free.
///
/// # Errors
/// The first word that cannot be read.
///
/// ```
/// use meshwright_formats::su2;
/// let text = "NDIME= 2\nNELEM= 1\n5 0 1 2 0\nNPOIN= 3\n0 0 0\n1 0 1\n0 1 2\nNMARK= 1\n\
///             MARKER_TAG= wall\nMARKER_ELEMS= 1\n3 0 1\n";
/// let (mesh, _) = su2::read(text.as_bytes(), "one.su2")?;
/// assert_eq!((mesh.edges, mesh.groups[0].name.as_str()), (vec![[0, 1]], "wall"));
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(text: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::with_separator(text, file, Some(b'%'), b'=');
    let mut reader = Reader::default();
    while scanner.next_line() {
        reader.part(&mut scanner)?;
    }
    reader.finish(&scanner)
}

#[derive(Default)]
struct Reader {
    has_dimension: bool,
    points: Option<Vec<[f64; 2]>>,
    triangles: Option<Vec<Cell<3>>>,
    /// Edges, each with the index of its marker.
    edges: Vec<(Cell<2>, usize)>,
    markers: Vec<String>,
    names: BTreeSet<String>,
    announced: Option<i64>,
    skipped: Vec<(String, u32)>,
}

/// Points of a cell, and where its line begins.
struct Cell<const N: usize> {
    points: [u32; N],
    place: usize,
}

impl Reader {
    fn part(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let Some(word) = scanner.word() else { return Ok(()) };
        match word.bytes {
            b"NDIME" => {
                scanner.integer("2 dimensions", 2, 2)?;
                self.has_dimension = true;
            }
            b"NZONE" => {
                scanner.integer("one zone", 1, 1)?;
            }
            _ if !self.has_dimension => return Err(scanner.unexpected(word, "NDIME= 2 first")),
            b"NELEM" if self.triangles.is_none() => {
                self.triangles = Some(cells(scanner, Shape::Triangle)?);
            }
            b"NPOIN" if self.points.is_none() => self.points = Some(points(scanner)?),
            b"NMARK" if self.announced.is_none() => {
                self.announced = Some(scanner.integer("the number of markers", 0, MOST)?);
            }
            b"NELEM" | b"NPOIN" | b"NMARK" => {
                return Err(scanner.unexpected(word, "one list of each kind"));
            }
            b"MARKER_TAG" => self.marker(scanner)?,
            [b'A'..=b'Z' | b'a'..=b'z', ..] => {
                self.skipped.push((String::from_utf8_lossy(word.bytes).into_owned(), 1));
                scanner.leave_line();
                while !scanner.next_begins(|byte| byte.is_ascii_alphabetic()) {
                    scanner.leave_line();
                }
                return Ok(());
            }
            _ => return Err(scanner.unexpected(word, "NELEM=, NPOIN=, NMARK= or MARKER_TAG=")),
        }
        scanner.leave_line();
        Ok(())
    }

    fn marker(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let Some(name) = scanner.word() else { return Err(scanner.missing("the marker's name")) };
        let Ok(text) = std::str::from_utf8(name.bytes) else {
            return Err(scanner.unexpected(name, "a name in UTF-8"));
        };
        if !self.names.insert(text.to_owned()) {
            return Err(scanner.unexpected(name, "a marker with a new name"));
        }
        let marker = self.markers.len();
        self.markers.push(text.to_owned());
        scanner.leave_line();
        scanner.next_line();
        match scanner.word() {
            Some(word) if word.bytes == b"MARKER_ELEMS" => {}
            Some(word) => return Err(scanner.unexpected(word, "MARKER_ELEMS=")),
            None => return Err(scanner.missing("MARKER_ELEMS=")),
        }
        let cells = cells(scanner, Shape::Edge)?;
        self.edges.extend(cells.into_iter().map(|cell| (cell, marker)));
        Ok(())
    }

    /// The mesh, once every list is there.
    fn finish(self, scanner: &Scanner) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
        if !self.has_dimension {
            return Err(scanner.missing("NDIME= 2"));
        }
        let Some(points) = self.points else { return Err(scanner.missing("NPOIN=")) };
        let Some(triangles) = self.triangles else { return Err(scanner.missing("NELEM=")) };
        let Some(announced) = self.announced else { return Err(scanner.missing("NMARK=")) };
        let markers = self.markers.len() as i64;
        if announced != markers {
            return Err(scanner.missing(format!("marker {} of {announced}", markers + 1)));
        }
        let mut assembly = Assembly::default();
        let count = points.len();
        assembly.mesh.points = points;
        let names = self.markers.iter().map(String::as_str).collect();
        let tags = tags::of_names(&[Named { dim: 1, names }], &mut assembly.mesh.groups);
        for cell in &triangles {
            assembly.push(Shape::Triangle, cell.in_range(scanner, count)?, 0);
        }
        for (cell, marker) in &self.edges {
            let tag: Tag = tags[0][*marker];
            assembly.push(Shape::Edge, cell.in_range(scanner, count)?, tag);
        }
        if !self.skipped.is_empty() {
            let notice = Notice::SkippedStatements { statements: self.skipped };
            assembly.warn(scanner.file(), 0, notice);
        }
        Ok(assembly.finish(scanner.file()))
    }
}

impl<const N: usize> Cell<N> {
    /// The points, which stand behind the kind of the cell.
    fn in_range(&self, scanner: &Scanner, count: usize) -> Result<&[u32], SyntaxError> {
        match self.points.iter().position(|&point| point as usize >= count) {
            None => Ok(&self.points),
            Some(index) => {
                let place = scanner.place_of_word(self.place, index + 1);
                Err(scanner.unexpected_at(place, format!("a point, 0 to {}", count as i64 - 1)))
            }
        }
    }
}

fn points(scanner: &mut Scanner) -> Result<Vec<[f64; 2]>, SyntaxError> {
    let count = scanner.integer("the number of points", 0, MOST)?;
    // The shortest point, `0 0` and a line end, has four bytes.
    let mut points = Vec::with_capacity(reserved(count, scanner.left(), 4));
    for index in 0..count {
        row(scanner, "point", index, count)?;
        points.push([scanner.real("an x coordinate")?, scanner.real("a y coordinate")?]);
    }
    Ok(points)
}

/// Cells of one shape.
fn cells<const N: usize>(scanner: &mut Scanner, shape: Shape) -> Result<Vec<Cell<N>>, SyntaxError> {
    let count = scanner.integer("the number of elements", 0, MOST)?;
    let (kind, what) = match shape {
        Shape::Edge => (3, "an element's kind, 3 (line)"),
        _ => (5, "an element's kind, 5 (triangle)"),
    };
    let mut cells = Vec::new();
    for index in 0..count {
        row(scanner, "element", index, count)?;
        let place = scanner.next_place();
        scanner.integer(what, kind, kind).map_err(|mut error| {
            error.help.get_or_insert("only triangles and their edges are read".into());
            error
        })?;
        let mut points = [0; N];
        for point in &mut points {
            *point = scanner.integer("a point, counted from 0", 0, MOST)? as u32;
        }
        cells.push(Cell { points, place });
    }
    Ok(cells)
}

/// Goes to the next line of a list.
fn row(scanner: &mut Scanner, what: &str, index: i64, count: i64) -> Result<(), SyntaxError> {
    scanner.leave_line();
    if scanner.next_line() {
        return Ok(());
    }
    Err(scanner.missing(format!("{what} {} of {count}", index + 1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: &str = "% a square\nNDIME = 2\nNELEM= 2\n5 0 1 2 0\n5 0 2 3 1\nNPOIN= 4 4\n0 0 0\n1 0 1\n\
                        1 1 2\n0 1 3\nAOA= 3.5\nNMARK= 2\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n3 0 1\n\
                        MARKER_TAG= boundary_5\nMARKER_ELEMS= 2\n3 1 2\n3 0 1\n";

    fn error(text: &str) -> String {
        let message = read(text.as_bytes(), "a.su2").expect_err("this is wrong").to_string();
        message.lines().next().unwrap_or_default().to_owned()
    }

    #[test]
    fn markers_are_groups() {
        let (mesh, warnings) = read(MESH.as_bytes(), "a.su2").expect("it is good");
        assert_eq!((mesh.triangles, mesh.points.len()), (vec![[0, 1, 2], [0, 2, 3]], 4));
        assert_eq!((mesh.edges, mesh.edge_tags), (vec![[0, 1], [1, 2]], vec![1, 5]));
        assert_eq!((mesh.groups.len(), mesh.groups[0].name.as_str()), (1, "wall"));
        assert_eq!(mesh.memberships.len(), 1, "an edge in two markers");
        let said: Vec<String> = warnings.iter().map(Warning::to_string).collect();
        assert_eq!(said, ["a.su2: 1 statement without effect on this mesh: AOA"]);
    }

    #[test]
    fn every_shorter_file_is_refused() {
        // The last line may lose its end, not its last point.
        for length in 0..MESH.len() - 2 {
            let message = error(&MESH[..length]);
            assert!(message.starts_with("a.su2:"), "{length}: {message}");
        }
    }

    #[test]
    fn errors_name_their_word() {
        let cases = [
            ("NDIME = 2", "NDIME= 3", "2:8: expected 2 dimensions, found `3`"),
            ("NDIME = 2\n", "", "2:1: expected NDIME= 2 first, found `NELEM`"),
            (
                "NELEM= 2",
                "NELEM= 3",
                "6:1: expected an element's kind, 5 (triangle), found `NPOIN`",
            ),
            ("5 0 1 2 0", "9 0 1 2 3", "4:1: expected an element's kind, 5 (triangle), found `9`"),
            ("5 0 2 3 1", "5 0 2 4 1", "5:7: expected a point, 0 to 3, found `4`"),
            ("5 0 2 3 1", "5 -1 2 4 1", "5:3: expected a point, counted from 0, found `-1`"),
            ("NPOIN= 4 4", "NPOIN= 4000000000", "11:1: expected an x coordinate, found `AOA`"),
            ("1 1 2", "1 nan 2", "9:3: expected a y coordinate, found `nan`"),
            ("NMARK= 2", "NMARK= 3", "19:6: expected marker 3 of 3, found the end of the file"),
            ("boundary_5", "wall", "16:13: expected a marker with a new name, found `wall`"),
            ("MARKER_ELEMS= 1", "SEND_RECV= 1", "14:1: expected MARKER_ELEMS=, found `SEND_RECV`"),
            ("NMARK= 2", "NPOIN= 2", "12:1: expected one list of each kind, found `NPOIN`"),
        ];
        for (part, by, message) in cases {
            assert!(MESH.contains(part), "{part}");
            assert_eq!(error(&MESH.replacen(part, by, 1)), format!("a.su2:{message}"));
        }
    }
}
