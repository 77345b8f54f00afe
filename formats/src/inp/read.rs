//! Reading `.inp`.
//!
//! ```text
//! file    := (keyword line data line*)*
//! keyword := "*" <words> ("," <word> ["=" <word>])*
//! ```
//!
//! | keyword | lines |
//! |---|---|
//! | `*NODE` | number, x, y, z |
//! | `*ELEMENT, TYPE=…, ELSET=…` | number, nodes; triangles and lines |
//! | `*ELSET, ELSET=…`, `*NSET, NSET=…` | numbers or names of sets above; first, last, step with `GENERATE` |
//! | `*SURFACE, NAME=…` | element or set, side `S1` to `S3`: edges of triangles |
//!
//! `**` starts a comment. Keywords and names may be in small letters. Other keywords are passed over
//! with a warning.

use std::collections::BTreeMap;

use super::elements::shape;
use super::groups::Groups;
use super::sets::Set;
use crate::assembly::{Assembly, Shape};
use crate::error::{Notice, SyntaxError, Warning};
use crate::mesh::Mesh;
use crate::numbering::Numbering;
use crate::text::Scanner;

/// Reads the text of an `.inp` file.
///
/// `file` is the name that messages use. The region of a triangle is the first set of elements that
/// it is in; where there are none but sets of all (`EALL`), the `ELSET` of its `*ELEMENT`. Edges are
/// elements that are lines, and the sides in surfaces; a set of nodes that is not named like their
/// groups is a group of points. The tag of a name is the one that it states (`region_3`), the number
/// that it is, or else the next that is free. All nodes lie in one plane z = constant.
///
/// # Errors
/// The first word that cannot be read.
///
/// ```
/// use meshwright_formats::inp;
/// let text = "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n*ELEMENT, TYPE=CPS3, ELSET=steel\n1, 1, 2, 3\n\
///             *SURFACE, NAME=wall\n1, S3\n";
/// let (mesh, _) = inp::read(text.as_bytes(), "one.inp")?;
/// assert_eq!((mesh.triangles, mesh.edges), (vec![[0, 1, 2]], vec![[2, 0]]));
/// assert_eq!(mesh.groups[0].name, "steel");
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(text: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::with_separator(text, file, None, b',');
    let mut reader = Reader::default();
    loop {
        match Line::of(&mut scanner) {
            Line::Keyword => reader.statement(&mut scanner)?,
            Line::End => return reader.finish(&scanner),
            Line::Data => {
                let word = scanner.first_word_of_line();
                return Err(scanner.unexpected(word, "a keyword: *NODE, *ELEMENT …"));
            }
        }
    }
}

/// What the next line that is no comment is.
#[derive(PartialEq)]
pub(super) enum Line {
    Keyword,
    Data,
    End,
}

impl Line {
    /// Goes there.
    pub fn of(scanner: &mut Scanner) -> Self {
        while scanner.next_line() {
            match scanner.first_word_of_line().bytes {
                [b'*', b'*', ..] => scanner.leave_line(),
                [b'*', ..] => return Self::Keyword,
                _ => return Self::Data,
            }
        }
        Self::End
    }
}

#[derive(Default)]
pub(super) struct Reader {
    assembly: Assembly,
    pub nodes: Numbering,
    pub elements: Numbering,
    pub cells: Vec<Cell>,
    /// The numbers of the nodes of all cells.
    cell_nodes: Vec<i64>,
    /// The sets that `*ELEMENT` names, and those of `*ELSET`.
    pub own_sets: Vec<Set>,
    pub element_sets: Vec<Set>,
    pub node_sets: Vec<Set>,
    pub surfaces: Vec<Surface>,
    /// The line of the first node.
    first: u32,
    skipped: BTreeMap<String, u32>,
}

pub(super) struct Cell {
    pub shape: Shape,
    /// Where its nodes end among those of all.
    pub end: usize,
    /// Where its line begins.
    place: usize,
}

pub(super) struct Surface {
    pub name: String,
    /// Elements, one or a set, and which side of them, from 0.
    pub sides: Vec<(Set, usize)>,
}

/// A keyword line.
struct Statement {
    keyword: String,
    options: BTreeMap<String, String>,
}

impl Statement {
    fn read(scanner: &mut Scanner) -> Result<Self, SyntaxError> {
        let line = scanner.rest();
        let Ok(text) = std::str::from_utf8(line.bytes) else {
            return Err(scanner.unexpected(line, "a keyword line in UTF-8"));
        };
        let mut parts = text.split(',').map(str::trim);
        let keyword = parts.next().unwrap_or_default();
        let words: Vec<&str> = keyword.split_whitespace().collect();
        let options = parts.map(|part| match part.split_once('=') {
            Some((key, value)) => (key.trim().to_ascii_uppercase(), value.trim().to_owned()),
            None => (part.to_ascii_uppercase(), String::new()),
        });
        Ok(Self { keyword: words.join(" ").to_ascii_uppercase(), options: options.collect() })
    }

    fn get(&self, option: &str) -> Option<String> {
        self.options.get(option).filter(|value| !value.is_empty()).cloned()
    }
}

impl Reader {
    fn statement(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let first = scanner.first_word_of_line();
        let statement = Statement::read(scanner)?;
        let missing = |option: &str| scanner.unexpected(first, format!("a keyword with {option}="));
        match statement.keyword.as_str() {
            "*NODE" => {
                let set = statement.get("NSET").map(Set::new);
                return self.read_nodes(scanner, set);
            }
            "*ELEMENT" => {
                let kind = statement.get("TYPE").ok_or_else(|| missing("TYPE"))?;
                let Some(kind) = shape(&kind.to_ascii_uppercase()) else {
                    let mut error = scanner.unexpected(first, "triangles or lines");
                    let help = format!("{kind} is none: CPS3, CPE3, CAX3, S3 … are triangles");
                    error.help = Some(help.into());
                    return Err(error);
                };
                return self.read_elements(scanner, kind, statement.get("ELSET"));
            }
            "*ELSET" | "*NSET" => {
                let is_elements = statement.keyword == "*ELSET";
                let option = if is_elements { "ELSET" } else { "NSET" };
                let name = statement.get(option).ok_or_else(|| missing(option))?;
                let mut set = Set::new(name);
                set.read(scanner, statement.options.contains_key("GENERATE"))?;
                let sets = if is_elements { &mut self.element_sets } else { &mut self.node_sets };
                sets.push(set);
                return Ok(());
            }
            "*SURFACE"
                if statement.get("TYPE").is_none_or(|t| t.eq_ignore_ascii_case("ELEMENT")) =>
            {
                let name = statement.get("NAME").ok_or_else(|| missing("NAME"))?;
                return self.read_surface(scanner, name);
            }
            _ => {}
        }
        *self.skipped.entry(statement.keyword).or_insert(0) += 1;
        while Line::of(scanner) == Line::Data {
            scanner.leave_line();
        }
        Ok(())
    }

    fn read_nodes(
        &mut self,
        scanner: &mut Scanner,
        mut set: Option<Set>,
    ) -> Result<(), SyntaxError> {
        while Line::of(scanner) == Line::Data {
            if self.first == 0 {
                self.first = scanner.line();
            }
            let place = scanner.next_place();
            let number = scanner.integer("the number of a node, 1 or more", 1, i64::MAX)?;
            self.nodes.push(number, place);
            if let Some(set) = &mut set {
                set.push(number, place);
            }
            let point = [scanner.real("an x coordinate")?, scanner.real("a y coordinate")?];
            if let Some(word) = scanner.word() {
                let z = scanner.real_in(word, "a z coordinate")?;
                if let Err(first) = self.assembly.same_plane(z) {
                    let expected = format!("z = {first}, as in the first node");
                    return Err(scanner.unexpected(word, expected));
                }
            }
            self.assembly.mesh.points.push(point);
            scanner.leave_line();
        }
        self.node_sets.extend(set);
        Ok(())
    }

    fn read_elements(
        &mut self,
        scanner: &mut Scanner,
        (shape, nodes): (Shape, usize),
        set: Option<String>,
    ) -> Result<(), SyntaxError> {
        let mut set = set.map(Set::new);
        while Line::of(scanner) == Line::Data {
            let place = scanner.next_place();
            let number = scanner.integer("the number of an element, 1 or more", 1, i64::MAX)?;
            self.elements.push(number, place);
            for _ in 0..nodes {
                let node = scanner.integer("the number of a node", i64::MIN, i64::MAX)?;
                self.cell_nodes.push(node);
            }
            if let Some(word) = scanner.word() {
                let expected = format!("the end of the line behind {nodes} nodes");
                return Err(scanner.unexpected(word, expected));
            }
            if let Some(set) = &mut set {
                set.push(number, place);
            }
            self.cells.push(Cell { shape, end: self.cell_nodes.len(), place });
        }
        self.own_sets.extend(set);
        Ok(())
    }

    fn read_surface(&mut self, scanner: &mut Scanner, name: String) -> Result<(), SyntaxError> {
        let mut sides = Vec::new();
        while Line::of(scanner) == Line::Data {
            let place = scanner.next_place();
            let mut set = Set::new(String::new());
            let what = "an element or a set of elements";
            let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
            set.push_word(word.bytes, place);
            let what = "a side of triangles: S1, S2 or S3";
            let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
            let side = match word.bytes {
                [b'S' | b's', side @ b'1'..=b'3'] => usize::from(side - b'1'),
                _ => return Err(scanner.unexpected(word, what)),
            };
            sides.push((set, side));
            scanner.leave_line();
        }
        self.surfaces.push(Surface { name, sides });
        Ok(())
    }

    /// The mesh, once every statement is read.
    fn finish(mut self, scanner: &Scanner) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
        if self.nodes.count() == 0 {
            return Err(scanner.missing("*NODE"));
        }
        self.nodes.sort(scanner, "a node with a new number")?;
        self.elements.sort(scanner, "an element with a new number")?;
        self.assembly.warn_of_plane(scanner.file(), self.first);
        let corners = self.corners(scanner)?;
        let mut assembly = std::mem::take(&mut self.assembly);
        let groups = Groups::of(&self, &corners, scanner)?;
        groups.assemble(&self.cells, &corners, &mut assembly, scanner.file());
        if !self.skipped.is_empty() {
            let notice =
                Notice::SkippedStatements { statements: self.skipped.into_iter().collect() };
            assembly.warn(scanner.file(), 0, notice);
        }
        Ok(assembly.finish(scanner.file()))
    }

    /// The nodes of all cells, by index, corners first.
    fn corners(&self, scanner: &Scanner) -> Result<Vec<u32>, SyntaxError> {
        let mut corners = Vec::with_capacity(self.cell_nodes.len());
        let mut start = 0;
        for cell in &self.cells {
            for (nth, &number) in self.cell_nodes[start..cell.end].iter().enumerate() {
                let index = self.nodes.index(number);
                corners.push(index.ok_or_else(|| {
                    let place = scanner.place_of_word(cell.place, nth + 1);
                    scanner.unexpected_at(place, "the number of a node")
                })?);
            }
            if cell.shape == Shape::Edge && cell.end - start == 3 {
                corners.swap(start + 1, start + 2); // the middle node stands between the ends
            }
            start = cell.end;
        }
        Ok(corners)
    }
}
