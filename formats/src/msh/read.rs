//! Reading `.msh`.
//!
//! ```text
//! msh      := format section*
//! format   := $MeshFormat <2, 2.1 or 2.2> <0: text> <size of a double> $EndMeshFormat
//! section  := names | nodes | elements | other
//! names    := $PhysicalNames <count> name* $EndPhysicalNames
//! name     := <dimension> <number> "<name>"
//! nodes    := $Nodes <count> node* $EndNodes
//! node     := <number> <x> <y> <z>
//! elements := $Elements <count> element* $EndElements
//! element  := <number> <type> <number of tags> <tag>* <node>*
//! other    := $<word> … $End<word>, ignored with a warning
//! ```
//!
//! Each on a line of its own. Of the tags the first, the physical number, is taken. Elements are
//! lines, triangles and points; binary files and other elements are refused.

use crate::error::{Notice, SyntaxError, Warning};
use crate::mesh::Mesh;
use crate::node::{MOST, reserved};
use crate::pslg::{Group, Membership, Tag};
use crate::text::{Scanner, parse_integer};

/// Reads the text of a `.msh` file of version 2, written by any program.
///
/// `file` is the name that messages use. Physical numbers become tags, as they stand in the file;
/// triangles keep their orientation. A point in a group, and an edge that is there once more for a
/// second group, become [memberships](crate::Membership). Nodes may be numbered in any way, and lie
/// in one plane z = constant.
///
/// # Errors
/// The first word that cannot be read.
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
pub fn read(text: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::new(text, file, None);
    let mut reader = Reader::default();
    format(&mut scanner)?;
    while scanner.next_line() {
        reader.section(&mut scanner)?;
    }
    if reader.nodes.is_none() {
        return Err(scanner.missing("section $Nodes"));
    }
    if !reader.has_elements {
        return Err(scanner.missing("section $Elements"));
    }
    fold_repeated_edges(&mut reader.mesh);
    Ok((reader.mesh, reader.warnings))
}

/// Leaves each edge once: where it is there again with another number, that is a further group.
fn fold_repeated_edges(mesh: &mut Mesh) {
    let ends = |edge: &u32| {
        let [a, b] = mesh.edges[*edge as usize];
        [a.min(b), a.max(b)]
    };
    let mut order: Vec<u32> = (0..mesh.edges.len() as u32).collect();
    order.sort_unstable_by_key(|edge| (ends(edge), *edge));
    let mut repeated = Vec::new();
    for same in order.chunk_by(|a, b| ends(a) == ends(b)) {
        repeated.extend(same[1..].iter().map(|&again| (again, same[0])));
    }
    if repeated.is_empty() {
        return;
    }
    repeated.sort_unstable();
    for &(again, first) in &repeated {
        let tag = mesh.edge_tags[again as usize];
        if tag != mesh.edge_tags[first as usize] {
            // What lies before it among the edges that go moves it down.
            let item = first - repeated.partition_point(|&(edge, _)| edge < first) as u32;
            mesh.memberships.push(Membership { dim: 1, item, tag });
        }
    }
    let goes = |edge: usize| repeated.binary_search_by_key(&(edge as u32), |&(e, _)| e).is_ok();
    let kept: Vec<usize> = (0..mesh.edges.len()).filter(|&edge| !goes(edge)).collect();
    mesh.edges = kept.iter().map(|&edge| mesh.edges[edge]).collect();
    mesh.edge_tags = kept.iter().map(|&edge| mesh.edge_tags[edge]).collect();
}

#[derive(Default)]
struct Reader {
    mesh: Mesh,
    nodes: Option<Nodes>,
    has_elements: bool,
    warnings: Vec<Warning>,
}

fn format(scanner: &mut Scanner) -> Result<(), SyntaxError> {
    scanner.next_line();
    keyword(scanner, "$MeshFormat").map_err(|mut error| {
        error.help.get_or_insert("only Gmsh's version 2 is read, as text".into());
        error
    })?;
    scanner.next_line();
    let what = "version 2.2";
    let Some(version) = scanner.word() else { return Err(scanner.missing(what)) };
    if !matches!(version.bytes, b"2" | b"2.0" | b"2.1" | b"2.2") {
        let mut error = scanner.unexpected(version, what);
        error.help = Some("`gmsh in.msh -save -format msh22 -o out.msh` converts it".into());
        return Err(error);
    }
    scanner.integer("file type 0 (text)", 0, 0)?;
    scanner.integer("the size of a double, 8", 8, 8)?;
    end_of_line(scanner)?;
    end(scanner, "$EndMeshFormat")
}

impl Reader {
    fn section(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let line = scanner.line();
        let Some(word) = scanner.word() else { return Ok(()) };
        match word.bytes {
            b"$PhysicalNames" => self.names(scanner),
            b"$Nodes" if self.nodes.is_some() => {
                Err(scanner.unexpected(word, "one section $Nodes"))
            }
            b"$Nodes" => self.nodes(scanner),
            b"$Elements" if self.nodes.is_none() => {
                Err(scanner.unexpected(word, "section $Nodes before the elements"))
            }
            b"$Elements" if self.has_elements => {
                Err(scanner.unexpected(word, "one section $Elements"))
            }
            b"$Elements" => self.elements(scanner),
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
            let rest = scanner.rest();
            let quoted = rest.bytes.strip_prefix(b"\"").and_then(|name| name.strip_suffix(b"\""));
            let Some(name) = quoted.and_then(|name| std::str::from_utf8(name).ok()) else {
                return Err(scanner.unexpected(rest, "a name between double quotes"));
            };
            self.mesh.groups.push(Group { dim, tag, name: name.to_owned() });
        }
        end(scanner, "$EndPhysicalNames")
    }

    fn nodes(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let count = count(scanner, "the number of nodes")?;
        // The shortest node, `1 0 0 0` and a line end, has eight bytes.
        self.mesh.points.reserve(reserved(count, scanner.left(), 8));
        let mut nodes = Nodes::default();
        let mut plane = None;
        let mut first = 0;
        for index in 0..count {
            item(scanner, "node", index, count)?;
            if index == 0 {
                first = scanner.line();
            }
            nodes.push(scanner)?;
            let x = scanner.real("an x coordinate")?;
            let y = scanner.real("a y coordinate")?;
            same_plane(scanner, &mut plane)?;
            self.mesh.points.push([x, y]);
            end_of_line(scanner)?;
        }
        nodes.sort(scanner)?;
        if let Some(z) = plane.filter(|&z| z != 0.0) {
            self.warn(scanner, first, Notice::Plane { z });
        }
        self.nodes = Some(nodes);
        end(scanner, "$EndNodes")
    }

    fn elements(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let count = count(scanner, "the number of elements")?;
        for index in 0..count {
            item(scanner, "element", index, count)?;
            self.element(scanner)?;
            end_of_line(scanner)?;
        }
        self.has_elements = true;
        end(scanner, "$EndElements")
    }

    fn element(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        scanner.integer("the number of an element", i64::MIN, i64::MAX)?;
        let what = "an element's type: 1 (line), 2 (triangle) or 15 (point)";
        let Some(kind) = scanner.word() else { return Err(scanner.missing(what)) };
        match kind.bytes {
            b"1" => {
                self.mesh.edge_tags.push(physical(scanner)?);
                self.mesh.edges.push([self.node(scanner)?, self.node(scanner)?]);
            }
            b"2" => {
                self.mesh.triangle_tags.push(physical(scanner)?);
                let corners = [self.node(scanner)?, self.node(scanner)?, self.node(scanner)?];
                self.mesh.triangles.push(corners);
            }
            b"15" => {
                let tag = physical(scanner)?;
                let point = self.node(scanner)?;
                if tag != 0 {
                    self.mesh.memberships.push(Membership { dim: 0, item: point, tag });
                }
            }
            _ => {
                let mut error = scanner.unexpected(kind, what);
                error.help = element_name(kind.bytes);
                return Err(error);
            }
        }
        Ok(())
    }

    /// The (zero-based) index of the node whose number is the next word.
    fn node(&self, scanner: &mut Scanner) -> Result<u32, SyntaxError> {
        let what = "the number of a node";
        let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
        let nodes = self.nodes.as_ref();
        let index = parse_integer(word.bytes).and_then(|number| nodes?.index(number));
        index.ok_or_else(|| scanner.unexpected(word, what))
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
            self.warn(scanner, line, Notice::SkippedSection { name });
        }
        end_of_line(scanner)
    }

    fn warn(&mut self, scanner: &Scanner, line: u32, notice: Notice) {
        self.warnings.push(Warning { file: scanner.file().to_owned(), line, notice });
    }
}

/// From the numbers of the nodes to their indices.
#[derive(Default)]
struct Nodes {
    /// How many nodes there are.
    count: u32,
    /// Number, index and line of each node, by number; empty while they count up from 1.
    table: Vec<(i64, u32, u32)>,
}

impl Nodes {
    fn push(&mut self, scanner: &mut Scanner) -> Result<(), SyntaxError> {
        let number = scanner.integer("the number of a node", 1, i64::MAX)?;
        let line = scanner.line();
        if self.table.is_empty() && number != i64::from(self.count) + 1 {
            // Lines of nodes that counted up need not be known: only a later node can repeat
            // their numbers, and it is the one to name.
            self.table = (0..self.count).map(|i| (i64::from(i) + 1, i, 0)).collect();
            self.table.push((number, self.count, line));
        } else if !self.table.is_empty() {
            self.table.push((number, self.count, line));
        }
        self.count += 1;
        Ok(())
    }

    fn sort(&mut self, scanner: &Scanner) -> Result<(), SyntaxError> {
        self.table.sort_unstable();
        let twice = self.table.windows(2).find(|pair| pair[0].0 == pair[1].0);
        match twice {
            Some(pair) => Err(scanner.unexpected_in_line(pair[1].2, "a node with a new number")),
            None => Ok(()),
        }
    }

    fn index(&self, number: i64) -> Option<u32> {
        if self.table.is_empty() {
            return u32::try_from(number - 1).ok().filter(|&index| index < self.count);
        }
        let place = self.table.binary_search_by_key(&number, |entry| entry.0).ok()?;
        Some(self.table[place].1)
    }
}

/// Reads z, which is the same for all nodes.
fn same_plane(scanner: &mut Scanner, plane: &mut Option<f64>) -> Result<(), SyntaxError> {
    let what = "a z coordinate";
    let Some(word) = scanner.word() else { return Err(scanner.missing(what)) };
    let z = scanner.real_in(word, what)?;
    let first = *plane.get_or_insert(z);
    if z == first {
        return Ok(());
    }
    let mut error = scanner.unexpected(word, format!("z = {first}, as in the first node"));
    error.help = Some("meshes are planar: all nodes have the same z".into());
    Err(error)
}

/// The physical number of an element: the first of its tags, 0 where there is none.
fn physical(scanner: &mut Scanner) -> Result<Tag, SyntaxError> {
    // Gmsh adds the partitions to the tags; more than a few are no tags any more.
    let count = scanner.integer("the number of tags (0 to 1000)", 0, 1000)?;
    let mut physical = 0;
    for index in 0..count {
        let value = tag(scanner, "a tag")?;
        if index == 0 {
            physical = value;
        }
    }
    Ok(physical)
}

fn tag(scanner: &mut Scanner, what: &'static str) -> Result<Tag, SyntaxError> {
    Ok(scanner.integer(what, i64::from(Tag::MIN), i64::from(Tag::MAX))? as Tag)
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

/// What the manual calls an element that has no place in a mesh of straight triangles.
fn element_name(kind: &[u8]) -> Option<std::borrow::Cow<'static, str>> {
    let name = match kind {
        b"3" => "a quadrangle",
        b"4" => "a tetrahedron",
        b"5" => "a hexahedron",
        b"6" => "a prism",
        b"7" => "a pyramid",
        b"8" => "a second order line",
        b"9" => "a second order triangle",
        b"10" | b"16" => "a second order quadrangle",
        b"11" => "a second order tetrahedron",
        _ => return None,
    };
    Some(format!("it is {name}; only straight lines and triangles are read").into())
}
