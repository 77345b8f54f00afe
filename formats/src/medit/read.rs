//! Reading `.mesh`.
//!
//! ```text
//! file  := "MeshVersionFormatted" <1 to 4> part* "End"
//! part  := "Dimension" <2 or 3>
//!        | "Vertices" <count> (<x> <y> [<z>] <number>)*
//!        | ("Edges" | "EdgesP2") <count> (<vertex>* <number>)*
//!        | ("Triangles" | "TrianglesP2") <count> (<vertex>* <number>)*
//!        | <word> number*, passed over with a warning
//! ```
//!
//! Words and numbers stand in any lines; `#` starts a comment. Vertices are counted from one. Other
//! cells than edges and triangles are refused.

use crate::assembly::{Assembly, Shape};
use crate::error::{Notice, SyntaxError, Warning};
use crate::mesh::Mesh;
use crate::node::{MOST, reserved, trailing_text};
use crate::pslg::Tag;
use crate::text::Scanner;

/// Reads the text of a `.mesh` file.
///
/// `file` is the name that messages use. The numbers of edges and triangles are their tags, those of
/// vertices markers, where one is not 0. All vertices lie in one plane z = constant.
///
/// # Errors
/// The first word that cannot be read.
///
/// ```
/// use meshwright_formats::medit;
/// let text = "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0  1 0 0  0 1 0\n\
///             Triangles 1\n1 2 3 7\nEnd\n";
/// let (mesh, warnings) = medit::read(text.as_bytes(), "one.mesh")?;
/// assert_eq!((mesh.triangles, mesh.triangle_tags), (vec![[0, 1, 2]], vec![7]));
/// assert!(warnings.is_empty());
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(text: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::new(text, file, Some(b'#'));
    let mut reader = Reader::default();
    let what = "MeshVersionFormatted";
    scanner.next_line();
    match scanner.word() {
        Some(word) if word.bytes == what.as_bytes() => {}
        Some(word) => {
            let mut error = scanner.unexpected(word, what);
            error.help.get_or_insert("only Medit's text is read, not its binary `.meshb`".into());
            return Err(error);
        }
        None => return Err(scanner.missing(what)),
    }
    integer(&mut scanner, "the version (1 to 4)", 1, 4)?;
    while reader.part(&mut scanner)? {}
    if reader.vertices.is_none() {
        return Err(scanner.unexpected(scanner.first_word_of_line(), "Vertices before the end"));
    }
    if !reader.skipped.is_empty() {
        let notice = Notice::SkippedStatements { statements: reader.skipped };
        reader.assembly.warn(file, 0, notice);
    }
    trailing_text(&mut scanner, &mut reader.assembly.warnings);
    Ok(reader.assembly.finish(file))
}

#[derive(Default)]
struct Reader {
    assembly: Assembly,
    dimension: Option<i64>,
    /// How many vertices there are.
    vertices: Option<u32>,
    skipped: Vec<(String, u32)>,
}

impl Reader {
    /// Reads a part; false at the end of the mesh.
    fn part(&mut self, scanner: &mut Scanner) -> Result<bool, SyntaxError> {
        scanner.next_line();
        let Some(word) = scanner.word() else { return Err(scanner.missing("End")) };
        match (word.bytes, self.vertices) {
            (b"End", _) => return Ok(false),
            (b"Dimension", None) => {
                self.dimension = Some(integer(scanner, "the dimension (2 or 3)", 2, 3)?);
            }
            (b"Vertices", None) => match self.dimension {
                Some(dimension) => self.vertices(scanner, dimension == 3)?,
                None => return Err(scanner.unexpected(word, "Dimension before the vertices")),
            },
            (b"Vertices" | b"Dimension", Some(_)) => {
                return Err(scanner.unexpected(word, "one list of vertices"));
            }
            (b"Edges" | b"EdgesP2" | b"Triangles" | b"TrianglesP2", None) => {
                return Err(scanner.unexpected(word, "Vertices before the cells"));
            }
            (b"Edges", Some(count)) => self.cells(scanner, Shape::Edge, 2, count)?,
            (b"EdgesP2", Some(count)) => self.cells(scanner, Shape::Edge, 3, count)?,
            (b"Triangles", Some(count)) => self.cells(scanner, Shape::Triangle, 3, count)?,
            (b"TrianglesP2", Some(count)) => self.cells(scanner, Shape::Triangle, 6, count)?,
            (name, _) if OTHER_CELLS.iter().any(|other| name.starts_with(other)) => {
                let count = integer(scanner, "their number", 0, MOST)?;
                if count > 0 {
                    let mut error = scanner.unexpected(word, "Edges or Triangles");
                    error.help = Some("other cells are not read".into());
                    return Err(error);
                }
            }
            (name @ [b'A'..=b'Z' | b'a'..=b'z', ..], _) => {
                let name = String::from_utf8_lossy(name).into_owned();
                pass_numbers(scanner)?;
                self.skipped.push((name, 1));
            }
            _ => return Err(scanner.unexpected(word, "a keyword: Vertices, Triangles, End …")),
        }
        Ok(true)
    }

    fn vertices(&mut self, scanner: &mut Scanner, has_z: bool) -> Result<(), SyntaxError> {
        let count = integer(scanner, "the number of vertices", 0, MOST)?;
        let mesh = &mut self.assembly.mesh;
        // The shortest vertex, `0 0 0` and a blank, has six bytes.
        mesh.points.reserve(reserved(count, scanner.left(), 6));
        let mut first = 0;
        for index in 0..count {
            if !scanner.next_line() {
                return Err(scanner.missing(format!("vertex {} of {count}", index + 1)));
            }
            if index == 0 {
                first = scanner.line();
            }
            let x = scanner.real("an x coordinate")?;
            scanner.next_line();
            let y = scanner.real("a y coordinate")?;
            if has_z {
                scanner.next_line();
                let place = scanner.next_place();
                let z = scanner.real("a z coordinate")?;
                if let Err(first) = self.assembly.same_plane(z) {
                    let expected = format!("z = {first}, as in the first vertex");
                    return Err(scanner.unexpected_at(place, expected));
                }
            }
            let marker = tag(scanner, "the number of the vertex")?;
            self.assembly.mesh.points.push([x, y]);
            self.assembly.mesh.point_markers.push(marker);
        }
        self.assembly.warn_of_plane(scanner.file(), first);
        let markers = &mut self.assembly.mesh.point_markers;
        if markers.iter().all(|&marker| marker == 0) {
            markers.clear();
        }
        self.vertices = Some(count as u32);
        Ok(())
    }

    fn cells(
        &mut self,
        scanner: &mut Scanner,
        shape: Shape,
        nodes: usize,
        vertices: u32,
    ) -> Result<(), SyntaxError> {
        let count = integer(scanner, "the number of cells", 0, MOST)?;
        let mut cell = Vec::new();
        for index in 0..count {
            if !scanner.next_line() {
                return Err(scanner.missing(format!("cell {} of {count}", index + 1)));
            }
            cell.clear();
            for _ in 0..nodes {
                let node = integer(scanner, "the number of a vertex", 1, vertices.into())?;
                cell.push(node as u32 - 1);
            }
            let tag = tag(scanner, "the number of the cell")?;
            self.assembly.push(shape, &cell, tag);
        }
        Ok(())
    }
}

/// Keywords of cells that have no place in a mesh of triangles.
const OTHER_CELLS: [&[u8]; 5] = [b"Quadrilaterals", b"Tetrahedra", b"Hexa", b"Prisms", b"Pyramids"];

/// Passes over numbers, up to the next keyword.
fn pass_numbers(scanner: &mut Scanner) -> Result<(), SyntaxError> {
    while !scanner.next_begins(|byte| byte.is_ascii_alphabetic()) {
        scanner.real("a number or a keyword")?;
    }
    Ok(())
}

fn integer(
    scanner: &mut Scanner,
    what: &'static str,
    least: i64,
    most: i64,
) -> Result<i64, SyntaxError> {
    scanner.next_line();
    scanner.integer(what, least, most)
}

fn tag(scanner: &mut Scanner, what: &'static str) -> Result<Tag, SyntaxError> {
    Ok(integer(scanner, what, Tag::MIN.into(), Tag::MAX.into())? as Tag)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: &str = "MeshVersionFormatted\n2\nDimension 3\nVertices\n4\n0 0 1 0\n1 0 1 4\n1 1 1 0\n\
                        0 1 1 0\nEdges 1\n1 2 5\nTriangles\n2\n1 2 3 7\n1 3 4 -8\nCorners 1\n3\nEnd\n";

    fn error(text: &str) -> String {
        let message = read(text.as_bytes(), "a.mesh").expect_err("this is wrong").to_string();
        message.lines().next().unwrap_or_default().to_owned()
    }

    #[test]
    fn numbers_are_tags_and_markers() {
        let (mesh, warnings) = read(MESH.as_bytes(), "a.mesh").expect("it is good");
        assert_eq!((mesh.points.len(), mesh.point_markers), (4, vec![0, 4, 0, 0]));
        assert_eq!((mesh.edges, mesh.edge_tags), (vec![[0, 1]], vec![5]));
        assert_eq!((mesh.triangles[1], mesh.triangle_tags), ([0, 2, 3], vec![7, -8]));
        let said: Vec<String> = warnings.iter().map(Warning::to_string).collect();
        let expected = [
            "a.mesh:6: all nodes have z = 1; it is dropped",
            "a.mesh: 1 statement without effect on this mesh: Corners",
        ];
        assert_eq!(said, expected);
    }

    /// Found by fuzzing: the keyword stands in a line before the number that was read last.
    #[test]
    fn other_cells_are_named_by_their_keyword() {
        let text = "MeshVersionFormatted 2\nTetrahedra\n\n1\n1 2 3 4 0\nEnd\n";
        assert_eq!(error(text), "a.mesh:2:1: expected Edges or Triangles, found `Tetrahedra`");
    }

    #[test]
    fn every_shorter_file_is_refused() {
        for length in 0..MESH.trim_end().len() {
            let message = error(&MESH[..length]);
            assert!(message.starts_with("a.mesh:"), "{length}: {message}");
        }
    }

    #[test]
    fn errors_name_their_word() {
        let cases = [
            ("\n2\n", "\n5\n", "2:1: expected the version (1 to 4), found `5`"),
            ("Dimension 3\n", "", "3:1: expected Dimension before the vertices, found `Vertices`"),
            ("\n4\n", "\n4000000000\n", "10:1: expected an x coordinate, found `Edges`"),
            ("1 0 1 4", "1 0 2 4", "7:5: expected z = 1, as in the first vertex, found `2`"),
            ("1 0 1 4", "nan 0 1 4", "7:1: expected an x coordinate, found `nan`"),
            ("1 2 3 7", "1 2 5 7", "14:5: expected the number of a vertex, found `5`"),
            ("1 2 3 7", "0 2 3 7", "14:1: expected the number of a vertex, found `0`"),
            (
                "Edges",
                "Quadrilaterals",
                "10:1: expected Edges or Triangles, found `Quadrilaterals`",
            ),
            ("Corners", "Vertices", "16:1: expected one list of vertices, found `Vertices`"),
            ("Corners", "17", "16:1: expected a keyword: Vertices, Triangles, End …, found `17`"),
        ];
        for (part, by, message) in cases {
            assert_eq!(error(&MESH.replacen(part, by, 1)), format!("a.mesh:{message}"));
        }
        let binary = read(b"\x01\0\0\0\x02\0\0\0", "a.mesh").expect_err("it is no text");
        assert!(binary.to_string().starts_with("a.mesh:1:1: expected MeshVersionFormatted, found"));
    }
}
