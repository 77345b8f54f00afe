//! Outlines in Wavefront `.obj` files: polylines, or the outlines of faces. Meshes are written.
//!
//! ```text
//! obj       := statement*
//! statement := v <x> <y> [<z> [<weight or colours>]]     a vertex
//!            | l <vertex> <vertex>+                      a polyline
//!            | p <vertex>+                               free points
//!            | f <vertex> <vertex> <vertex>+             a face
//!            | o [<name>] | g [<name>]                   the group of what follows
//!            | usemtl [<name>]                           its material
//!            | <what has no effect on an outline>
//! vertex    := <number>[/[<texture>][/[<normal>]]]       from 1 in order, from −1 backwards
//! ```
//!
//! One line each, in any order; `\` at the end of a line joins the next one to it; `#` starts a
//! comment. A name is the whole rest of its line. Texture coordinates, normals, smoothing and the
//! display are passed over; so are free-form curves and surfaces, with a warning.
//!
//! Each step of a polyline is a segment. The loops say what is meshed: one within another is its
//! hole ([`Enclosed::EvenOdd`]). The vertices that a segment or `p` uses must lie in one plane, to
//! 1e-5 of their extent; the others are left out.

mod groups;
mod mesh;
mod outline;
mod plane;
mod write;

use std::borrow::Cow;

use crate::error::{Notice, SyntaxError, Warning};
use crate::node::MOST;
use crate::pslg::{Enclosed, Pslg, Source};
use crate::text::{Scanner, Word, parse_integer};

use groups::Groups;
use outline::Faces;

pub use mesh::write;
pub use write::write_outline;

/// How a file is read.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Options {
    /// Take the outlines of faces too: the edges that belong to one face alone. Else faces are
    /// passed over, with a warning.
    pub faces: bool,
}

/// Reads the polylines of an `.obj` file.
///
/// `file` is the name that messages use.
///
/// # Errors
/// The first word that cannot be read; a file without any polyline; a vertex off the plane of the
/// others.
///
/// ```
/// use meshwright_formats::{Enclosed, obj};
/// let text = b"g inlet\nv 0 0 0\nv 1 0 0\nl 1 2\ng wall\nv 0 1 0\nl 2 3 1\n";
/// let (outline, warnings) = obj::read(text, "corner.obj")?;
/// assert_eq!(outline.segments, [[0, 1], [1, 2], [2, 0]]);
/// assert_eq!(outline.segment_tags, [1, 2, 2]);
/// assert_eq!(outline.groups[1].name, "wall");
/// assert_eq!(outline.enclosed, Enclosed::EvenOdd);
/// assert!(warnings.is_empty());
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(text: &[u8], file: &str) -> Result<(Pslg, Vec<Warning>), SyntaxError> {
    read_with(text, file, Options::default())
}

/// Reads an `.obj` file as [`read`] does, with options.
///
/// # Errors
/// Those of [`read`].
pub fn read_with(
    text: &[u8],
    file: &str,
    options: Options,
) -> Result<(Pslg, Vec<Warning>), SyntaxError> {
    let mut reader = Reader::new(text, file, options, MOST);
    reader.statements()?;
    let vertices = reader.vertices.len() as i64;
    if reader.largest_vertex > vertices {
        // A vertex was named before it came, and never came: the second pass knows where.
        reader = Reader::new(text, file, options, vertices);
        reader.statements()?;
    }
    reader.outline()
}

/// What a file holds, as far as it is read.
struct Reader<'a> {
    scanner: Scanner<'a>,
    options: Options,
    /// x and y of each vertex, and z.
    vertices: Vec<[f64; 2]>,
    heights: Vec<f64>,
    vertex_lines: Vec<u32>,
    /// The greatest number that a vertex may have.
    most_vertices: i64,
    /// The greatest that was named.
    largest_vertex: i64,
    segments: Vec<[u32; 2]>,
    segment_lines: Vec<u32>,
    /// The group of each segment.
    segment_groups: Vec<u32>,
    free_points: Vec<u32>,
    faces: Faces,
    groups: Groups,
    /// The first line and the number of statements that were passed over.
    skipped_faces: Option<(u32, u32)>,
    skipped_curves: Option<(u32, u32)>,
}

impl<'a> Reader<'a> {
    fn new(text: &'a [u8], file: &'a str, options: Options, most_vertices: i64) -> Self {
        Self {
            scanner: Scanner::with_continued_lines(text, file, Some(b'#')),
            options,
            vertices: Vec::new(),
            heights: Vec::new(),
            vertex_lines: Vec::new(),
            most_vertices,
            largest_vertex: 0,
            segments: Vec::new(),
            segment_lines: Vec::new(),
            segment_groups: Vec::new(),
            free_points: Vec::new(),
            faces: Faces::default(),
            groups: Groups::default(),
            skipped_faces: None,
            skipped_curves: None,
        }
    }

    fn statements(&mut self) -> Result<(), SyntaxError> {
        while self.scanner.next_line() {
            let Some(word) = self.scanner.word() else { continue };
            match word.bytes {
                b"v" => self.vertex()?,
                b"l" => self.polyline()?,
                b"p" => self.points()?,
                b"f" if self.options.faces => self.face()?,
                b"f" => self.pass_over(|reader| &mut reader.skipped_faces),
                b"o" | b"g" => self.groups.begin_group(&self.scanner.rest()),
                b"usemtl" => self.groups.begin_material(&self.scanner.rest()),
                word if WITHOUT_EFFECT.contains(&word) => self.scanner.leave_line(),
                word if FREE_FORM.contains(&word) => {
                    self.pass_over(|reader| &mut reader.skipped_curves);
                }
                _ => {
                    let mut error = self.scanner.unexpected(word, "an OBJ statement");
                    let help = "an outline is made of `v` and `l`, or of `v` and `f`";
                    error.help.get_or_insert(help.into());
                    return Err(error);
                }
            }
        }
        Ok(())
    }

    /// `v <x> <y> [<z> [<weight or colours>]]`
    fn vertex(&mut self) -> Result<(), SyntaxError> {
        let line = self.scanner.line();
        let x = self.scanner.real("an x coordinate")?;
        let y = self.scanner.real("a y coordinate")?;
        let z = match self.scanner.word() {
            Some(word) => self.scanner.real_in(word, "a z coordinate")?,
            None => 0.0,
        };
        while let Some(word) = self.scanner.word() {
            self.scanner.real_in(word, "a weight or a colour")?;
        }
        if self.vertices.len() as i64 >= MOST {
            let word = self.scanner.first_word_of_line();
            return Err(self.scanner.unexpected(word, format!("at most {MOST} vertices")));
        }
        self.vertices.push([x, y]);
        self.heights.push(z);
        self.vertex_lines.push(line);
        Ok(())
    }

    /// `l <vertex> <vertex>+`
    fn polyline(&mut self) -> Result<(), SyntaxError> {
        let group = self.groups.current();
        let mut from = self.wanted_vertex("the first vertex of a line")?;
        let mut to = self.wanted_vertex("the second vertex of a line")?;
        loop {
            if self.segments.len() as i64 >= MOST {
                let word = self.scanner.first_word_of_line();
                return Err(self.scanner.unexpected(word, format!("at most {MOST} segments")));
            }
            self.segments.push([from, to]);
            self.segment_lines.push(self.scanner.line());
            self.segment_groups.push(group);
            from = to;
            to = match self.next_vertex()? {
                Some(to) => to,
                None => return Ok(()),
            };
        }
    }

    /// `p <vertex>+`
    fn points(&mut self) -> Result<(), SyntaxError> {
        let first = self.wanted_vertex("a vertex")?;
        self.free_points.push(first);
        while let Some(point) = self.next_vertex()? {
            self.free_points.push(point);
        }
        Ok(())
    }

    /// `f <vertex> <vertex> <vertex>+`
    fn face(&mut self) -> Result<(), SyntaxError> {
        let (group, line) = (self.groups.current(), self.scanner.line());
        let first = self.wanted_vertex("the first vertex of a face")?;
        let mut from = self.wanted_vertex("the second vertex of a face")?;
        self.faces.edge([first, from], group, line);
        let mut to = self.wanted_vertex("the third vertex of a face")?;
        loop {
            self.faces.edge([from, to], group, line);
            from = to;
            to = match self.next_vertex()? {
                Some(to) => to,
                None => break,
            };
        }
        self.faces.edge([from, first], group, line);
        Ok(())
    }

    fn wanted_vertex(&mut self, what: &'static str) -> Result<u32, SyntaxError> {
        self.next_vertex()?.ok_or_else(|| self.scanner.missing(what))
    }

    /// The (zero-based) index of the vertex that the next word of the line names.
    fn next_vertex(&mut self) -> Result<Option<u32>, SyntaxError> {
        let (known, most) = (self.vertices.len() as i64, self.most_vertices);
        let found = self.scanner.plain_integer(|number| counted(number, known, most).is_some());
        let number = match found {
            Some(number) => counted(number, known, most),
            None => match self.scanner.word() {
                Some(word) => Some(self.reference(word)?),
                None => None,
            },
        };
        self.largest_vertex = self.largest_vertex.max(number.unwrap_or_default());
        Ok(number.map(|number| (number - 1) as u32))
    }

    /// The number of the vertex that a word names, counted from one.
    fn reference(&self, word: Word) -> Result<i64, SyntaxError> {
        let known = self.vertices.len() as i64;
        let mut parts = word.bytes.split(|&byte| byte == b'/');
        let number = parts.next().and_then(parse_integer);
        // Texture and normal: `7/7`, `7/7/7`, `7//7`, and `7/` where exporters forget them.
        let is_number = |part: &[u8]| part.is_empty() || parse_integer(part).is_some();
        let is_reference = parts.by_ref().take(2).all(is_number) && parts.next().is_none();
        number
            .filter(|_| is_reference)
            .and_then(|number| counted(number, known, self.most_vertices))
            .ok_or_else(|| self.no_vertex(word, known))
    }

    fn no_vertex(&self, word: Word, known: i64) -> SyntaxError {
        let most = self.most_vertices;
        let expected: Cow<str> = match known {
            _ if most != MOST => format!("the number of a vertex (1 to {most})").into(),
            0 => "the number of a vertex".into(),
            known => format!("the number of a vertex (1 to {known}, or -1 to -{known})").into(),
        };
        let mut error = self.scanner.unexpected(word, expected);
        if parse_integer(word.bytes) == Some(0) {
            error.help = Some("vertices count from 1, or from -1 backwards".into());
        }
        error
    }

    fn pass_over(&mut self, count: impl Fn(&mut Self) -> &mut Option<(u32, u32)>) {
        let line = self.scanner.line();
        count(self).get_or_insert((line, 0)).1 += 1;
        self.scanner.leave_line();
    }

    /// What was read, as an outline.
    fn outline(mut self) -> Result<(Pslg, Vec<Warning>), SyntaxError> {
        self.take_outlines_of_faces();
        if self.segments.is_empty() && self.free_points.is_empty() {
            return Err(self.nothing());
        }
        let last_line = self.vertex_lines.iter().chain(&self.segment_lines).max().copied();
        let mut warnings = self.passed_over();
        let numbers = self.leave_unused_out(&mut warnings);
        plane::flatten(&mut self, &numbers, &mut warnings)?;
        let (segment_tags, groups) = self.groups.tags(&self.segment_groups);
        let pslg = Pslg {
            points: self.vertices,
            segments: self.segments,
            segment_tags,
            enclosed: Enclosed::EvenOdd,
            groups,
            source: Source {
                file: self.scanner.file().to_owned(),
                first_number: 1,
                point_lines: self.vertex_lines,
                segment_lines: self.segment_lines,
                point_numbers: numbers,
                last_line,
                ..Source::default()
            },
            ..Pslg::default()
        };
        Ok((pslg, warnings))
    }

    fn take_outlines_of_faces(&mut self) {
        let faces = std::mem::take(&mut self.faces);
        for edge in faces.outline(&self.vertices, &self.heights) {
            self.segments.push(edge.ends);
            self.segment_lines.push(edge.line);
            self.segment_groups.push(edge.group);
        }
    }

    /// The error that there is no outline.
    fn nothing(&self) -> SyntaxError {
        let mut error = self.scanner.missing("a polyline (`l`)");
        if let Some((line, count)) = self.skipped_faces {
            let faces = if count == 1 { "a face" } else { "faces" };
            let help =
                format!("there are {faces} (`f`, line {line}); --faces takes their outlines");
            error.help = Some(help.replace("are a", "is a").into());
        } else if self.options.faces {
            error.expected = "a polyline (`l`), or an edge that belongs to one face (`f`)".into();
        }
        error
    }

    fn warning(&self, line: u32, notice: Notice) -> Warning {
        Warning { file: self.scanner.file().to_owned(), line, notice }
    }

    fn passed_over(&self) -> Vec<Warning> {
        let faces = self.skipped_faces.map(|(line, faces)| (line, Notice::SkippedFaces { faces }));
        let curves = self
            .skipped_curves
            .map(|(line, statements)| (line, Notice::SkippedCurves { statements }));
        let notices = faces.into_iter().chain(curves);
        notices.map(|(line, notice)| self.warning(line, notice)).collect()
    }

    /// Leaves the vertices out that no segment and no `p` uses. The numbers of the others in the
    /// file, or nothing where none is left out.
    fn leave_unused_out(&mut self, warnings: &mut Vec<Warning>) -> Vec<i64> {
        let mut is_used = vec![false; self.vertices.len()];
        for &vertex in self.segments.iter().flatten().chain(&self.free_points) {
            is_used[vertex as usize] = true;
        }
        let Some(first) = is_used.iter().position(|&is_used| !is_used) else {
            return Vec::new();
        };
        let line = self.vertex_lines[first];
        let mut index = vec![0; is_used.len()];
        let mut numbers = Vec::new();
        for vertex in (0..is_used.len()).filter(|&vertex| is_used[vertex]) {
            let new = numbers.len();
            index[vertex] = new as u32;
            self.vertices[new] = self.vertices[vertex];
            self.heights[new] = self.heights[vertex];
            self.vertex_lines[new] = self.vertex_lines[vertex];
            numbers.push(vertex as i64 + 1);
        }
        let vertices = (is_used.len() - numbers.len()) as u32;
        warnings.push(self.warning(line, Notice::UnusedVertices { vertices }));
        self.vertices.truncate(numbers.len());
        self.heights.truncate(numbers.len());
        self.vertex_lines.truncate(numbers.len());
        self.segments.iter_mut().flatten().for_each(|end| *end = index[*end as usize]);
        self.free_points.clear();
        numbers
    }
}

/// The number of a vertex counted from one, where `known` vertices stand before it and there are
/// `most`; `None` if there is no such vertex.
fn counted(number: i64, known: i64, most: i64) -> Option<i64> {
    let number = if number < 0 { known + 1 + number } else { number };
    (1..=most).contains(&number).then_some(number)
}

/// Statements that have no effect on an outline.
const WITHOUT_EFFECT: [&[u8]; 15] = [
    b"vt",
    b"vn",
    b"vp",
    b"s",
    b"mg",
    b"mtllib",
    b"usemap",
    b"maplib",
    b"bevel",
    b"lod",
    b"c_interp",
    b"d_interp",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
];

/// Statements of free-form curves and surfaces, and those that would read or run another file.
const FREE_FORM: [&[u8]; 18] = [
    b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim", b"hole",
    b"scrv", b"sp", b"end", b"con", b"stech", b"cdc", b"call", b"csh",
];

#[cfg(test)]
mod tests;
