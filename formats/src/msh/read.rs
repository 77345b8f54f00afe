//! Reading `.msh`: its format and its sections.
//!
//! ```text
//! msh     := format section*
//! format  := $MeshFormat <version> <0: text, 1: binary> <size of a double> [one] $EndMeshFormat
//! one     := <the number 1 in four bytes: only where binary, tells the order of bytes>
//! section := names | entities | nodes | elements | data | other
//! names   := $PhysicalNames <count> name* $EndPhysicalNames
//! name    := <dimension> <number> "<name>"
//! other   := $<word> … $End<word>, ignored with a warning
//! ```
//!
//! Each on a line of its own. Binary files hold the same sections, their names in text, their
//! numbers in bytes. Nodes, elements and entities: [`version2`], [`version4`]; data: [`data`].

mod data;
mod entities;
mod source;
mod version2;
mod version4;

use self::data::Place;
use self::entities::Entities;
use self::source::{Binary, Source, Text};
use crate::assembly::{Assembly, Shape};
use crate::error::{Notice, SyntaxError, Warning};
use crate::file_error::FileError;
use crate::mesh::Mesh;
use crate::node::MOST;
use crate::numbering::Numbering;
use crate::pslg::{Group, Tag};
use crate::text::Scanner;

/// Reads a `.msh` file of version 2 or 4.1, text or binary, written by any program.
///
/// `file` is the name that messages use. Physical numbers become tags, as they stand in the file;
/// triangles keep their orientation. A point in a group, and a second group of an edge, become
/// [memberships](crate::Membership). Nodes may be numbered in any way, and lie in one plane
/// z = constant. Of curved lines and triangles the corners are taken, with a warning.
///
/// # Errors
/// The first word, or the first bytes, that cannot be read.
///
/// ```
/// use meshwright_formats::{Mesh, msh};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![7],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// msh::write(&mesh, &mut text)?;
/// let (read, warnings) = msh::read(&text, "one.msh")?;
/// assert_eq!(read.triangles, mesh.triangles);
/// assert_eq!(read.groups[0].name, "region_7");
/// assert!(warnings.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(bytes: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), FileError> {
    let mut scanner = Scanner::new(bytes, file, None);
    match parse(&mut scanner) {
        Ok(reader) => Ok(reader.assembly.finish(file)),
        Err(error) => Err(scanner.placed(error)),
    }
}

fn parse(scanner: &mut Scanner) -> Result<Reader, SyntaxError> {
    let format = Format::read(scanner)?;
    let mut reader = Reader::default();
    while scanner.next_line() {
        match format.is_binary {
            false => reader.section(&mut Text::new(scanner), format)?,
            true => reader.section(&mut Binary::new(scanner, format.is_big_endian), format)?,
        }
    }
    if reader.nodes.is_none() {
        return Err(scanner.missing("section $Nodes"));
    }
    if reader.elements.is_none() {
        return Err(scanner.missing("section $Elements"));
    }
    Ok(reader)
}

/// What the section `$MeshFormat` tells.
#[derive(Clone, Copy)]
struct Format {
    /// 2 or 4.
    version: u8,
    is_binary: bool,
    is_big_endian: bool,
}

impl Format {
    fn read(scanner: &mut Scanner) -> Result<Self, SyntaxError> {
        scanner.next_line();
        keyword(scanner, "$MeshFormat")?;
        scanner.next_line();
        let what = "version 2.2 or 4.1";
        let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
        let version = match word.bytes {
            b"2" | b"2.0" | b"2.1" | b"2.2" => 2,
            b"4.1" => 4,
            _ => {
                let mut error = scanner.unexpected(word, what);
                let help = "`gmsh in.msh -save -format msh22 -o out.msh` converts it";
                error.help = Some(help.into());
                return Err(error);
            }
        };
        let is_binary = scanner.integer("file type 0 (text) or 1 (binary)", 0, 1)? == 1;
        scanner.integer("the size of a double, 8", 8, 8)?;
        let is_big_endian = is_binary && is_big_endian(scanner)?;
        if !is_binary {
            end_of_line(scanner)?;
        }
        end(scanner, "$EndMeshFormat")?;
        Ok(Self { version, is_binary, is_big_endian })
    }
}

/// Whether the highest byte of the number 1, which stands in the next line, comes first.
fn is_big_endian(scanner: &mut Scanner) -> Result<bool, SyntaxError> {
    if !scanner.enter_bytes() {
        return end_of_line(scanner).map(|()| false);
    }
    let (what, place) = ("the number 1 in 4 bytes", scanner.offset());
    let Some(bytes) = scanner.bytes::<4>() else { return Err(scanner.too_short(what)) };
    match (i32::from_le_bytes(bytes), i32::from_be_bytes(bytes)) {
        (1, _) => Ok(false),
        (_, 1) => Ok(true),
        (number, _) => Err(scanner.unexpected_number(place, what, number)),
    }
}

#[derive(Default)]
struct Reader {
    assembly: Assembly,
    entities: Option<Entities>,
    nodes: Option<Numbering>,
    elements: Option<Elements>,
}

/// The elements by their numbers.
#[derive(Default)]
struct Elements {
    numbers: Numbering,
    /// The index of the triangle that each element is, or [`Elements::OTHER`].
    triangles: Vec<u32>,
}

impl Elements {
    const OTHER: u32 = u32::MAX;
}

impl Reader {
    fn section<'a>(
        &mut self,
        source: &mut impl Source<'a>,
        format: Format,
    ) -> Result<(), SyntaxError> {
        let scanner = source.scanner();
        let line = scanner.line();
        let Some(word) = scanner.word() else { return Ok(()) };
        match word.bytes {
            b"$PhysicalNames" => self.names(scanner),
            b"$Entities" | b"$PartitionedEntities" if format.version == 4 => {
                let is_partitioned = word.bytes == b"$PartitionedEntities";
                let entities = self.entities.get_or_insert_default();
                entities.read(source, is_partitioned)
            }
            b"$Nodes" if self.nodes.is_some() => {
                Err(scanner.unexpected(word, "one section $Nodes"))
            }
            b"$Nodes" if format.version == 4 => version4::nodes(self, source),
            b"$Nodes" => version2::nodes(self, source),
            b"$Elements" if self.nodes.is_none() => {
                Err(scanner.unexpected(word, "section $Nodes before the elements"))
            }
            b"$Elements" if self.elements.is_some() => {
                Err(scanner.unexpected(word, "one section $Elements"))
            }
            b"$Elements" if format.version == 4 => version4::elements(self, source),
            b"$Elements" => version2::elements(self, source, format.is_binary),
            b"$NodeData" if self.nodes.is_some() => data::read(self, source, Place::Nodes, line),
            b"$ElementData" if self.elements.is_some() => {
                data::read(self, source, Place::Elements, line)
            }
            [b'$', name @ ..] if !name.is_empty() => self.skip(scanner, name, line),
            _ => Err(scanner.unexpected(word, "a section, `$` and its name")),
        }
    }

    fn names(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let count = count(scanner, "the number of names")?;
        for index in 0..count {
            item(scanner, "name", index, count)?;
            let dim = scanner.integer("the dimension of a group (0 to 3)", 0, 3)? as u8;
            let tag = tag(scanner, "the number of a group")?;
            let name = quoted(scanner, "a name between double quotes")?;
            self.assembly.mesh.groups.push(Group { dim, tag, name });
        }
        end(scanner, "$EndPhysicalNames")
    }

    fn skip(&mut self, scanner: &mut Scanner, name: &[u8], line: u32) -> Result<(), SyntaxError> {
        let name = String::from_utf8_lossy(name).into_owned();
        let end = format!("$End{name}");
        loop {
            scanner.leave_line();
            if !scanner.next_line() {
                return Err(scanner.missing(end));
            }
            if scanner.word().is_some_and(|word| word.bytes == end.as_bytes()) {
                break;
            }
        }
        if name != "Comments" {
            let file = scanner.file();
            self.assembly.warn(file, line, Notice::SkippedSection { name });
        }
        end_of_line(scanner)
    }

    /// Reads the coordinates of a node.
    fn coordinates<'a>(&mut self, source: &mut impl Source<'a>) -> Result<(), SyntaxError> {
        let x = source.real("an x coordinate")?;
        let y = source.real("a y coordinate")?;
        let z = source.real("a z coordinate")?;
        if let Err(first) = self.assembly.same_plane(z) {
            let mut error = source.wrong(format!("z = {first}, as in the first node"));
            error.help = Some("meshes are planar: all nodes have the same z".into());
            return Err(error);
        }
        self.assembly.mesh.points.push([x, y]);
        Ok(())
    }

    /// The (zero-based) index of the node whose number is read.
    fn node<'a>(&self, number: i64, source: &impl Source<'a>) -> Result<u32, SyntaxError> {
        let index = self.nodes.as_ref().and_then(|nodes| nodes.index(number));
        index.ok_or_else(|| source.wrong("the number of a node"))
    }

    /// Takes an element of a shape; answers what it is among those of its shape.
    fn element(&mut self, elements: &mut Elements, shape: Shape, nodes: &[u32], tag: Tag) {
        let triangle = self.assembly.mesh.triangles.len() as u32;
        self.assembly.push(shape, nodes, tag);
        let is_triangle = shape == Shape::Triangle;
        elements.triangles.push(if is_triangle { triangle } else { Elements::OTHER });
    }

    fn end_elements<'a>(
        &mut self,
        source: &mut impl Source<'a>,
        mut elements: Elements,
    ) -> Result<(), SyntaxError> {
        let scanner = source.scanner();
        elements.numbers.sort(scanner, "an element with a new number")?;
        self.elements = Some(elements);
        end(scanner, "$EndElements")
    }

    fn end_nodes<'a>(
        &mut self,
        source: &mut impl Source<'a>,
        mut nodes: Numbering,
        line: u32,
    ) -> Result<(), SyntaxError> {
        let scanner = source.scanner();
        nodes.sort(scanner, "a node with a new number")?;
        self.assembly.warn_of_plane(scanner.file(), line);
        self.nodes = Some(nodes);
        end(scanner, "$EndNodes")
    }
}

/// What an element type is: its shape, and how many nodes it has, corners first.
fn shape<'a>(source: &impl Source<'a>, kind: i64) -> Result<(Shape, usize), SyntaxError> {
    Ok(match kind {
        15 => (Shape::Point, 1),
        1 => (Shape::Edge, 2),
        8 => (Shape::Edge, 3),
        26 => (Shape::Edge, 4),
        27 => (Shape::Edge, 5),
        28 => (Shape::Edge, 6),
        2 => (Shape::Triangle, 3),
        9 => (Shape::Triangle, 6),
        20 => (Shape::Triangle, 9),
        21 => (Shape::Triangle, 10),
        22 => (Shape::Triangle, 12),
        23 | 24 => (Shape::Triangle, 15),
        25 => (Shape::Triangle, 21),
        _ => {
            let what = "an element's type: 1 (line), 2 (triangle) or 15 (point)";
            let mut error = source.wrong(what);
            error.help = element_name(kind).map(|name| {
                format!("it is {name}; only points, lines and triangles are read").into()
            });
            return Err(error);
        }
    })
}

/// What the manual calls an element that has no place in a mesh of triangles.
fn element_name(kind: i64) -> Option<&'static str> {
    Some(match kind {
        3 => "a quadrangle",
        4 => "a tetrahedron",
        5 => "a hexahedron",
        6 => "a prism",
        7 => "a pyramid",
        10 | 16 => "a second order quadrangle",
        11 => "a second order tetrahedron",
        12 | 17 => "a second order hexahedron",
        _ => return None,
    })
}

fn tag(scanner: &mut Scanner, what: &'static str) -> Result<Tag, SyntaxError> {
    Ok(scanner.integer(what, i64::from(Tag::MIN), i64::from(Tag::MAX))? as Tag)
}

/// The text between double quotes that is the rest of this line.
fn quoted(scanner: &mut Scanner, what: &'static str) -> Result<String, SyntaxError> {
    let rest = scanner.rest();
    let text = rest.bytes.strip_prefix(b"\"").and_then(|name| name.strip_suffix(b"\""));
    match text.map(std::str::from_utf8) {
        Some(Ok(text)) => Ok(text.to_owned()),
        Some(Err(_)) => {
            let mut error = scanner.unexpected(rest, what);
            error.help = Some("its bytes are no UTF-8".into());
            Err(error)
        }
        None => Err(scanner.unexpected(rest, what)),
    }
}

/// The number of items of a section, alone in its line.
fn count(scanner: &mut Scanner, what: &'static str) -> Result<i64, SyntaxError> {
    end_of_line(scanner)?;
    if !scanner.next_line() {
        return Err(scanner.missing(what));
    }
    let count = scanner.integer(what, 0, MOST)?;
    end_of_line(scanner)?;
    Ok(count)
}

fn item(scanner: &mut Scanner, what: &str, index: i64, count: i64) -> Result<(), SyntaxError> {
    if scanner.next_line() {
        return Ok(());
    }
    Err(scanner.missing(format!("{what} {} of {count}", index + 1)))
}

/// The line that ends a section.
fn end(scanner: &mut Scanner, what: &'static str) -> Result<(), SyntaxError> {
    scanner.next_line();
    keyword(scanner, what)
}

fn keyword(scanner: &mut Scanner, what: &'static str) -> Result<(), SyntaxError> {
    match scanner.word() {
        Some(word) if word.bytes == what.as_bytes() => end_of_line(scanner),
        Some(word) => Err(scanner.unexpected(word, what)),
        None => Err(scanner.missing(what)),
    }
}

fn end_of_line(scanner: &mut Scanner) -> Result<(), SyntaxError> {
    match scanner.word() {
        Some(word) => Err(scanner.unexpected(word, "the end of the line")),
        None => Ok(()),
    }
}
