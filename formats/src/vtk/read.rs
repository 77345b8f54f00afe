//! Reading legacy `.vtk`: versions 1 to 5, text or binary, of unstructured grids and of polygons.
//!
//! ```text
//! file  := "# vtk DataFile Version" <version> title ("ASCII" | "BINARY") "DATASET" kind part*
//! kind  := "UNSTRUCTURED_GRID" | "POLYDATA"
//! part  := "POINTS" <count> <type> number*
//!        | ("CELLS" | "VERTICES" | "LINES" | "POLYGONS") cells
//!        | "CELL_TYPES" <count> number*
//!        | "FIELD" <name> <arrays> (<name> <components> <tuples> <type> number*)*
//!        | ("POINT_DATA" | "CELL_DATA") <count> attribute*
//! cells := <cells> <numbers> (<how many> <node>*)*                       (before version 5)
//!        | <cells + 1> <nodes> "OFFSETS" <type> number* "CONNECTIVITY" <type> number*
//! ```
//!
//! Title and `METADATA` (up to an empty line) are passed over. Binary numbers are big endian
//! (<https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html>).

use super::numbers::{Kind, Numbers};
use super::place::{Layout, Places};
use crate::arrays::Block;
use crate::error::{Notice, SyntaxError, Warning};
use crate::file_error::FileError;
use crate::grid::{self, Column, Grid, Part, Points};
use crate::mesh::Mesh;
use crate::node::MOST;
use crate::text::{Scanner, Word};
use crate::wholes::Wholes;

/// Reads a `.vtk` file into the mesh in it; arrays mean what they do in [`vtu`](crate::vtu).
///
/// `file` is the name that messages use.
///
/// # Errors
/// The first word, or the first bytes, that cannot be read.
///
/// ```
/// use meshwright_formats::vtk;
/// let text = "# vtk DataFile Version 3.0\none triangle\nASCII\nDATASET UNSTRUCTURED_GRID\n\
///             POINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
/// let (mesh, warnings) = vtk::read(text.as_bytes(), "one.vtk")?;
/// assert_eq!(mesh.triangles, [[0, 1, 2]]);
/// assert!(warnings.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(bytes: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), FileError> {
    let mut scanner = Scanner::new(bytes, file, None);
    parse(&mut scanner).map_err(|error| scanner.placed(error))
}

fn parse(scanner: &mut Scanner) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
    let mut reader = Reader::header(scanner)?;
    while scanner.next_line() {
        reader.part(scanner)?;
    }
    reader.complete(scanner)?;
    let (places, grid) = (&reader.places, &mut reader.grid);
    grid.take_nodes(&std::mem::take(&mut reader.nodes));
    let made = grid.take_mesh(scanner.file());
    let (mesh, mut warnings) = made.map_err(|wrong| places.error(scanner, grid, &wrong))?;
    if !reader.skipped.is_empty() {
        let notice = Notice::SkippedStatements { statements: reader.skipped };
        warnings.push(Warning { file: scanner.file().to_owned(), line: 0, notice });
    }
    Ok((mesh, warnings))
}

/// To what attributes belong.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Points,
    Cells,
}

struct Reader {
    /// The first number of the version.
    version: i64,
    numbers: Numbers,
    is_polydata: bool,
    grid: Grid,
    /// The nodes of all cells, which may stand before their kinds.
    nodes: Wholes,
    places: Places,
    points: Option<usize>,
    has_cells: bool,
    has_kinds: bool,
    /// What attributes belong to, and how many of them there are.
    attributes: Option<(Of, usize)>,
    skipped: Vec<(String, u32)>,
}

impl Reader {
    fn header(scanner: &mut Scanner) -> Result<Self, SyntaxError> {
        scanner.next_line();
        for word in ["#", "vtk", "DataFile", "Version"] {
            keyword(scanner, word, "the line `# vtk DataFile Version 3.0`")?;
        }
        let what = "a version from 1 to 5";
        let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
        let version = match word.bytes {
            [version @ b'1'..=b'5', b'.', ..] => i64::from(version - b'0'),
            _ => return Err(scanner.unexpected(word, what)),
        };
        scanner.pass_line();
        scanner.pass_line(); // the title, which may be empty
        let what = "ASCII or BINARY";
        scanner.next_line();
        let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
        let numbers = match word.bytes.to_ascii_uppercase().as_slice() {
            b"ASCII" => Numbers::Text,
            b"BINARY" => Numbers::Binary,
            _ => return Err(scanner.unexpected(word, what)),
        };
        scanner.next_line();
        keyword(scanner, "DATASET", "DATASET")?;
        let what = "UNSTRUCTURED_GRID or POLYDATA";
        let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
        let is_polydata = match word.bytes.to_ascii_uppercase().as_slice() {
            b"UNSTRUCTURED_GRID" => false,
            b"POLYDATA" => true,
            _ => return Err(scanner.unexpected(word, what)),
        };
        Ok(Self {
            version,
            numbers,
            is_polydata,
            grid: Grid::default(),
            nodes: Wholes::default(),
            places: Places::new(numbers),
            points: None,
            has_cells: false,
            has_kinds: false,
            attributes: None,
            skipped: Vec::new(),
        })
    }

    fn part(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let Some(word) = scanner.word() else { return Ok(()) };
        let name = word.bytes.to_ascii_uppercase();
        match (name.as_slice(), self.attributes) {
            (b"METADATA", _) => {
                scanner.leave_paragraph();
                Ok(())
            }
            (b"POINTS", None) if self.points.is_none() => self.points(scanner),
            (b"CELLS", None) if !self.is_polydata && !self.has_cells => {
                self.has_cells = true;
                self.cells(scanner, None)
            }
            (b"CELL_TYPES", None) if !self.is_polydata && !self.has_kinds => self.kinds(scanner),
            (b"VERTICES", None) if self.is_polydata => self.cells(scanner, Some(2)),
            (b"LINES", None) if self.is_polydata => self.cells(scanner, Some(4)),
            (b"POLYGONS", None) if self.is_polydata => self.cells(scanner, Some(7)),
            (b"TRIANGLE_STRIPS", None) if self.is_polydata => {
                let mut error = scanner.unexpected(word, "POLYGONS");
                error.help = Some(
                    "strips are not read; ParaView's filter Triangulate makes polygons of them"
                        .into(),
                );
                Err(error)
            }
            (b"POINT_DATA", _) => self.begin_attributes(scanner, Of::Points),
            (b"CELL_DATA", _) => self.begin_attributes(scanner, Of::Cells),
            (b"FIELD", of) => self.field(scanner, of),
            (_, Some(of)) => self.attribute(scanner, word, of),
            _ => Err(scanner.unexpected(word, "POINTS, CELLS, CELL_TYPES or data")),
        }
    }

    fn points(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let count = scanner.integer("the number of points", 0, MOST)? as usize;
        let kind = Kind::read(scanner)?;
        let start = self.places.begin(scanner)?;
        self.places.keep(Part::Points, start, kind, 0, Layout::Plain);
        self.grid.points = Points::with_capacity(count.min(scanner.left() / 3));
        self.numbers.reals(scanner, kind, 3 * count, |block| self.grid.points.extend(block))?;
        self.points = Some(count);
        Ok(())
    }

    /// Cells with their nodes; of polygons all of one kind.
    fn cells(&mut self, scanner: &mut Scanner, kind: Option<i64>) -> Result<(), SyntaxError> {
        let cells = scanner.integer("the number of cells", 0, MOST)? as usize;
        let place = scanner.next_place();
        let numbers = scanner.integer("how many numbers follow", 0, MOST)? as usize;
        if self.version >= 5 {
            self.offsets_and_nodes(scanner, cells, numbers)?;
        } else {
            self.counts_and_nodes(scanner, cells, (numbers, place))?;
        }
        if let Some(kind) = kind {
            let more = self.grid.cells.ends.len() - self.grid.cells.kinds.len();
            self.grid.cells.kinds.extend(&vec![kind; more]);
        }
        Ok(())
    }

    fn offsets_and_nodes(
        &mut self,
        scanner: &mut Scanner,
        ends: usize,
        nodes: usize,
    ) -> Result<(), SyntaxError> {
        scanner.next_line();
        keyword(scanner, "OFFSETS", "OFFSETS")?;
        let kind = Kind::read(scanner)?;
        let start = self.places.begin(scanner)?;
        self.places.keep(Part::Ends, start, kind, self.grid.cells.ends.len(), Layout::BehindFirst);
        let before = self.nodes.len() as i64;
        let mut is_first = true;
        self.numbers.wholes(scanner, kind, ends, |offsets| {
            let behind_first = &offsets[usize::from(std::mem::take(&mut is_first))..];
            let moved = behind_first.iter().map(|end| end.saturating_add(before));
            self.grid.cells.ends.extend(&moved.collect::<Vec<_>>());
        })?;
        scanner.next_line();
        keyword(scanner, "CONNECTIVITY", "CONNECTIVITY")?;
        let kind = Kind::read(scanner)?;
        let start = self.places.begin(scanner)?;
        self.places.keep(Part::Nodes, start, kind, self.nodes.len(), Layout::Plain);
        self.numbers.wholes(scanner, kind, nodes, |block| self.nodes.extend(block))
    }

    fn counts_and_nodes(
        &mut self,
        scanner: &mut Scanner,
        cells: usize,
        (numbers, place): (usize, usize),
    ) -> Result<(), SyntaxError> {
        let start = self.places.begin(scanner)?;
        let first = self.nodes.len();
        let layout = Layout::Counted { first_cell: self.grid.cells.ends.len() };
        self.places.keep(Part::Nodes, start, Kind::INT, first, layout);
        let mut counted = Wholes::with_capacity(numbers.min(scanner.left()));
        self.numbers.wholes(scanner, Kind::INT, numbers, |block| counted.extend(block))?;
        let (mut next, mut nodes) = (0, Vec::new());
        for _ in 0..cells {
            let count = (next < numbers).then(|| usize::try_from(counted.at(next)).ok()).flatten();
            let Some(count) = count.filter(|&count| count < numbers - next) else {
                let expected =
                    format!("{cells} cells, each with the number of its nodes before them");
                return Err(scanner.unexpected_number(place, expected, numbers));
            };
            let end = next + 1 + count;
            nodes.clear();
            nodes.extend((next + 1..end).map(|index| counted.at(index)));
            self.nodes.extend(&nodes);
            self.grid.cells.ends.extend(&[self.nodes.len() as i64]);
            next = end;
        }
        if next == numbers {
            return Ok(());
        }
        let expected = format!("{next} numbers for {cells} cells");
        Err(scanner.unexpected_number(place, expected, numbers))
    }

    fn kinds(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let count = scanner.integer("the number of cells", 0, MOST)? as usize;
        let start = self.places.begin(scanner)?;
        self.places.keep(Part::Kinds, start, Kind::INT, 0, Layout::Plain);
        self.grid.cells.kinds = Wholes::with_capacity(count.min(scanner.left()));
        self.numbers
            .wholes(scanner, Kind::INT, count, |block| self.grid.cells.kinds.extend(block))?;
        self.has_kinds = true;
        Ok(())
    }

    fn begin_attributes(&mut self, scanner: &mut Scanner, of: Of) -> Result<(), SyntaxError> {
        let (what, known) = match of {
            Of::Points => ("the number of points", self.grid.points.len()),
            Of::Cells => ("the number of cells", self.grid.cells.ends.len()),
        };
        let known = known as i64;
        let count = scanner.integer(format!("{what}, {known}"), known, known)? as usize;
        self.attributes = Some((of, count));
        Ok(())
    }

    /// A field of arrays, of points, of cells or of the whole.
    fn field(&mut self, scanner: &mut Scanner, of: Option<(Of, usize)>) -> Result<(), SyntaxError> {
        scanner.word();
        let arrays = scanner.integer("the number of arrays", 0, MOST)?;
        for index in 0..arrays {
            let mut is_there = scanner.next_line();
            let mut word = scanner.word();
            // What VTK knows of an array stands behind it.
            while word.is_some_and(|word| word.bytes == b"METADATA") {
                scanner.leave_paragraph();
                is_there = scanner.next_line();
                word = scanner.word();
            }
            let (true, Some(word)) = (is_there, word) else {
                return Err(scanner.missing(format!("array {} of {arrays}", index + 1)));
            };
            let name = decoded(scanner, word)?;
            let components = scanner.integer("the number of components", 0, MOST_COMPONENTS)?;
            let what = "the number of tuples";
            let tuples = match of {
                None => scanner.integer(what, 0, MOST)?,
                Some((_, count)) if components > 0 => {
                    let count = count as i64;
                    scanner.integer(format!("{what}, {count}"), count, count)?
                }
                Some(_) => scanner.integer(what, 0, MOST)?,
            };
            let of = of.map(|(of, _)| of);
            let kind = Kind::read(scanner)?;
            self.array(scanner, kind, name, [components as usize, tuples as usize], of)?;
        }
        Ok(())
    }

    /// The numbers of an array, behind its head.
    fn array(
        &mut self,
        scanner: &mut Scanner,
        kind: Kind,
        name: String,
        [components, tuples]: [usize; 2],
        of: Option<Of>,
    ) -> Result<(), SyntaxError> {
        let start = self.places.begin(scanner)?;
        let (all, part) = match of {
            None => (&mut self.grid.field, None),
            Some(Of::Points) => {
                let index = self.grid.point_data.len();
                (&mut self.grid.point_data, Some(Part::PointData(index)))
            }
            Some(Of::Cells) => {
                let index = self.grid.cell_data.len();
                (&mut self.grid.cell_data, Some(Part::CellData(index)))
            }
        };
        if let Some(part) = part {
            self.places.keep(part, start, kind, 0, Layout::Plain);
        }
        let count = components * tuples;
        let mut numbers = grid::Numbers::with_capacity(kind.is_real(), count.min(scanner.left()));
        if kind.is_real() {
            self.numbers.reals(scanner, kind, count, |b| numbers.extend(Block::Real(b)))?;
        } else {
            self.numbers.wholes(scanner, kind, count, |b| numbers.extend(Block::Whole(b)))?;
        }
        all.push(Column { name, components, numbers });
        Ok(())
    }

    /// An attribute other than a field: `SCALARS name type components`, `VECTORS name type` …
    fn attribute(
        &mut self,
        scanner: &mut Scanner,
        word: Word,
        (of, count): (Of, usize),
    ) -> Result<(), SyntaxError> {
        let keyword = word.bytes.to_ascii_uppercase();
        let what = "the name of an array";
        let Some(name) = scanner.word() else { return Err(scanner.missing(what)) };
        let name = decoded(scanner, name)?;
        let components = match keyword.as_slice() {
            b"SCALARS" => return self.scalars(scanner, name, of, count),
            b"LOOKUP_TABLE" => {
                let size = scanner.integer("the size of the table", 0, MOST)? as usize;
                return self.pass_colours(scanner, "LOOKUP_TABLE", 4 * size);
            }
            b"COLOR_SCALARS" => {
                let components = scanner.integer("the number of components", 1, 4)? as usize;
                return self.pass_colours(scanner, "COLOR_SCALARS", components * count);
            }
            b"VECTORS" | b"NORMALS" => 3,
            b"TENSORS" => 9,
            b"TENSORS6" => 6,
            b"GLOBAL_IDS" | b"PEDIGREE_IDS" | b"EDGE_FLAGS" => 1,
            b"TEXTURE_COORDINATES" => scanner.integer("the number of components", 1, 3)? as usize,
            _ => return Err(scanner.unexpected(word, "SCALARS, VECTORS, FIELD or the like")),
        };
        let kind = Kind::read(scanner)?;
        self.array(scanner, kind, name, [components, count], Some(of))
    }

    /// Behind the type the number of components may stand, and a line `LOOKUP_TABLE name`.
    fn scalars(
        &mut self,
        scanner: &mut Scanner,
        name: String,
        of: Of,
        count: usize,
    ) -> Result<(), SyntaxError> {
        let kind = Kind::read(scanner)?;
        let components = match scanner.word() {
            Some(word) => scanner.integer_in(word, "the number of components", 1, 4)? as usize,
            None => 1,
        };
        if scanner.comes_next(b"LOOKUP_TABLE") {
            scanner.next_line();
            scanner.word();
            scanner.word();
        }
        self.array(scanner, kind, name, [components, count], Some(of))
    }

    /// Passes over numbers for colours: reals in text, else bytes.
    fn pass_colours(
        &mut self,
        scanner: &mut Scanner,
        name: &str,
        count: usize,
    ) -> Result<(), SyntaxError> {
        self.skip(name);
        let kind = if self.numbers == Numbers::Text { Kind::FLOAT } else { Kind::BYTE };
        self.places.begin(scanner)?;
        self.numbers.reals(scanner, kind, count, |_| {})
    }

    fn skip(&mut self, name: &str) {
        match self.skipped.iter_mut().find(|(known, _)| known == name) {
            Some((_, count)) => *count += 1,
            None => self.skipped.push((name.to_owned(), 1)),
        }
    }

    /// Whether every part of a grid is there.
    fn complete(&self, scanner: &Scanner) -> Result<(), SyntaxError> {
        if self.points.is_none() {
            return Err(scanner.missing("POINTS"));
        }
        if !self.is_polydata && !self.has_cells {
            return Err(scanner.missing("CELLS"));
        }
        let (kinds, cells) = (self.grid.cells.kinds.len(), self.grid.cells.ends.len());
        if kinds != cells {
            return Err(scanner.missing(format!("CELL_TYPES of {cells} cells instead of {kinds}")));
        }
        Ok(())
    }
}

/// More components than any array has.
const MOST_COMPONENTS: i64 = 1000;

fn keyword(scanner: &mut Scanner, word: &str, what: &'static str) -> Result<(), SyntaxError> {
    match scanner.word() {
        Some(found) if found.bytes.eq_ignore_ascii_case(word.as_bytes()) => Ok(()),
        Some(found) => Err(scanner.unexpected(found, what)),
        None => Err(scanner.missing(what)),
    }
}

/// A name in which `%` and two hexadecimal digits stand for a byte.
fn decoded(scanner: &Scanner, name: Word) -> Result<String, SyntaxError> {
    let mut bytes = Vec::new();
    let mut rest = name.bytes;
    while let [byte, after @ ..] = rest {
        let coded = match rest {
            [b'%', high, low, ..] => [high, low].map(|&digit| (digit as char).to_digit(16)),
            _ => [None; 2],
        };
        if let [Some(high), Some(low)] = coded {
            bytes.push((16 * high + low) as u8);
            rest = &rest[3..];
        } else {
            bytes.push(*byte);
            rest = after;
        }
    }
    String::from_utf8(bytes).map_err(|_| scanner.unexpected(name, "a name in UTF-8"))
}
