//! Triangles in Triangle's `.ele` files.
//!
//! ```text
//! ele      := <number of triangles> [<nodes per triangle: 3> [<number of attributes>]] triangle*
//! triangle := <number> <corner> <corner> <corner> <attribute>*
//! ```
//!
//! One line each; `#` starts a comment (<https://www.cs.cmu.edu/~quake/triangle.ele.html>). Triangles
//! of six nodes are refused. The points stand in the `.node` or `.poly` file of the same name, the
//! edges in the `.poly` file.

use std::io::{self, Write};

use crate::attributes;
use crate::error::{Notice, SyntaxError, Warning};
use crate::groups::{Note, numbers_only};
use crate::mesh::{Data, Mesh, Values};
use crate::node::{self, Lines, MOST, optional, reserved, trailing_text};
use crate::poly::{self, beside, point, whole};
use crate::pslg::{Group, Pslg};
use crate::rows::{Rows, one_based};
use crate::text::Scanner;

/// Reads the text of a `.ele` file, whose corners are the points of `outline`.
///
/// `outline` is what Triangle wrote beside: the `.poly` file, whose segments become the edges, or
/// the `.node` file alone. The first attribute becomes the region tag where it is a whole number
/// in every triangle; all others are data `attribute_1`, …
///
/// # Errors
/// The first word that cannot be read.
///
/// ```
/// use meshwright_formats::{ele, node};
/// let (points, _) = node::read(b"3 2\n1 0 0\n2 1 0\n3 0 1\n", "a.1.node")?;
/// let (mesh, warnings) = ele::read(b"1 3 1\n1 1 2 3 7\n", "a.1.ele", &points)?;
/// assert_eq!(mesh.triangles, [[0, 1, 2]]);
/// assert_eq!(mesh.triangle_tags, [7]);
/// # Ok::<(), meshwright_formats::SyntaxError>(())
/// ```
pub fn read(text: &[u8], file: &str, outline: &Pslg) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
    let mut scanner = Scanner::new(text, file, Some(b'#'));
    let mut warnings = Vec::new();
    let mut mesh = of_outline(outline);
    triangles(&mut scanner, outline, &mut mesh, &mut warnings)?;
    trailing_text(&mut scanner, &mut warnings);
    Ok((mesh, warnings))
}

/// Reads the text of a `.ele` file and the files beside it, which `companion` is asked for by name.
///
/// Of `dir/lake.1.ele` the points stand in `dir/lake.1.node`, or else in `dir/lake.1.poly`, whose
/// segments become the edges. A `.poly` file with points of its own that are not those of the
/// `.node` file is another outline: it is passed over, with a warning.
///
/// # Errors
/// The first word that cannot be read, in any of the files; companions that cannot be had.
pub fn read_with_companions(
    text: &[u8],
    file: &str,
    mut companion: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<(Mesh, Vec<Warning>), SyntaxError> {
    let [node, poly] = [".node", ".poly"].map(|end| beside(file, ".ele", end));
    let mut ask = |name: &str| match companion(name) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(no_points(text, file, &node, format!("{name}: {error}"))),
    };
    let (node_text, poly_text) = (ask(&node)?, ask(&poly)?);
    let (outline, mut warnings) = match (node_text, poly_text) {
        (None, None) => {
            let help = format!("there is no {node} and no {poly}");
            return Err(no_points(text, file, &node, help));
        }
        (None, Some(text)) => poly::read(&text, &poly, |_| Err(io::ErrorKind::NotFound.into()))?,
        (Some(text), None) => node::read(&text, &node)?,
        (Some(node_text), Some(poly_text)) => {
            let points = node::read(&node_text, &node)?;
            let segments = poly::read(&poly_text, &poly, |_| Ok(node_text))?;
            joined(points, segments)
        }
    };
    let (mesh, more) = read(text, file, &outline)?;
    warnings.extend(more);
    Ok((mesh, warnings))
}

/// The error that the points of a `.ele` file cannot be had.
fn no_points(text: &[u8], file: &str, node: &str, help: String) -> SyntaxError {
    let mut scanner = Scanner::new(text, file, Some(b'#'));
    scanner.next_line();
    let expected = format!("points beside, in `{node}`");
    let mut error = scanner.unexpected(scanner.first_word_of_line(), expected);
    error.help = Some(help.into());
    error
}

/// What is read, and what was passed over.
type Read = (Pslg, Vec<Warning>);

/// The points of a `.node` file with the segments of a `.poly` file that has no others.
fn joined((mut points, mut warnings): Read, (segments, more): Read) -> Read {
    if segments.source.point_file.is_some() {
        return (segments, more);
    }
    if segments.points != points.points {
        let line = segments.source.point_lines.first().copied().unwrap_or(1);
        let notice = Notice::OtherPoints { node: points.source.file.clone() };
        warnings.push(Warning { file: segments.source.file, line, notice });
        return (points, warnings);
    }
    points.segments = segments.segments;
    points.segment_tags = segments.segment_tags;
    warnings.extend(more);
    (points, warnings)
}

/// Writes the triangles of a mesh with their region tags and their data as attributes.
///
/// The first attribute is the region tag, as in Triangle's files (`-A`), zero and negative ones
/// included; there is none where all are untagged and nothing follows. The others are the arrays
/// of [`Mesh::triangle_data`] with one real number for each triangle. Names are not written, which
/// notes say.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, ele};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![-7],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// ele::write(&mesh, &mut text)?;
/// assert_eq!(text, b"1 3 1\n1 1 2 3 -7\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let mut notes: Vec<Note> = numbers_only(&mesh.groups, 2).into_iter().collect();
    let attributes = attributes::columns(&mesh.triangle_data, 1, &mut notes);
    let tagged = !attributes.is_empty() || mesh.triangle_tags.iter().any(|&tag| tag != 0);
    let mut rows = Rows::new(out);
    let columns = i64::from(tagged) + attributes.len() as i64;
    rows.integers(&[mesh.triangles.len() as i64, 3, columns])?;
    for (index, corners) in mesh.triangles.iter().enumerate() {
        rows.integer(index as i64 + 1);
        for &corner in corners {
            rows.integer(one_based(corner));
        }
        if tagged {
            rows.integer(mesh.triangle_tag(index));
        }
        for attribute in &attributes {
            rows.real(attribute.get(index).copied().unwrap_or(0.0));
        }
        rows.end()?;
    }
    rows.finish()?;
    Ok(notes)
}

/// The mesh that has the outline's points and edges, and no triangle yet.
fn of_outline(outline: &Pslg) -> Mesh {
    let attributes = outline.point_attributes.iter().map(|attribute| Data {
        name: attribute.name.clone(),
        components: 1,
        values: Values::Real(attribute.values.clone()),
    });
    let groups = outline.groups.iter().filter(|Group { dim, .. }| *dim != 0);
    Mesh {
        points: outline.points.clone(),
        point_markers: outline.point_markers.clone(),
        edges: outline.segments.clone(),
        edge_tags: outline.segment_tags.clone(),
        groups: groups.cloned().collect(),
        point_data: attributes.collect(),
        ..Mesh::default()
    }
}

/// More attributes than any file has.
const MOST_ATTRIBUTES: i64 = 1000;

fn triangles(
    scanner: &mut Scanner,
    outline: &Pslg,
    mesh: &mut Mesh,
    warnings: &mut Vec<Warning>,
) -> Result<(), SyntaxError> {
    scanner.next_line();
    let header = scanner.line();
    let count = scanner.integer("the number of triangles", 0, MOST)?;
    if let Some(word) = scanner.word() {
        scanner.integer_in(word, "3 nodes per triangle", 3, 3)?;
    }
    let attributes = optional(scanner, "the number of attributes", 0, MOST_ATTRIBUTES)?;
    let mut extra = Lines::default();
    extra.ignore_rest(scanner);
    // The shortest triangle, `1 1 2 3` and a line end, has eight bytes.
    mesh.triangles.reserve(reserved(count, scanner.left(), 8));
    let mut values = vec![Vec::new(); attributes as usize];
    let mut first = None;
    for index in 0..count {
        if !scanner.next_line() {
            return Err(scanner.missing(format!("triangle {} of {count}", index + 1)));
        }
        let place = scanner.next_place();
        let number = scanner.integer("the number of a triangle", i64::MIN, i64::MAX)?;
        let next = first.map_or(Some(number), |first: i64| first.checked_add(index));
        match next {
            Some(next) if next == number => first = first.or(Some(number)),
            _ => {
                let expected =
                    format!("triangle {} of {count}, counted up from the first", index + 1);
                return Err(scanner.unexpected_at(place, expected));
            }
        }
        let corners =
            [point(scanner, outline)?, point(scanner, outline)?, point(scanner, outline)?];
        mesh.triangles.push(corners);
        for attribute in &mut values {
            attribute.push(scanner.real("an attribute")?);
        }
        extra.ignore_rest(scanner);
    }
    extra.warn(scanner, warnings, |lines| Notice::ExtraColumns { lines, header });
    attach(mesh, values);
    Ok(())
}

/// The first attribute as region tags, if it can be; the others as data.
fn attach(mesh: &mut Mesh, values: Vec<Vec<f64>>) {
    let tags = values.first().and_then(|first| first.iter().map(|&value| whole(value)).collect());
    let skipped = usize::from(tags.is_some());
    mesh.triangle_tags = tags.unwrap_or_else(|| vec![0; mesh.triangles.len()]);
    for (index, values) in values.into_iter().enumerate().skip(skipped) {
        let (name, values) = (attributes::name(index + 1), Values::Real(values));
        mesh.triangle_data.push(Data { name, components: 1, values });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline() -> Pslg {
        let text = b"4 2 1 1\n0 0 0 .5 1\n1 1 0 .5 1\n2 1 1 .5 1\n3 0 1 .5 1\n1 1\n0 0 1 9\n";
        crate::poly::read(text, "a.poly", |_| unreachable!("the points are there")).unwrap().0
    }

    fn error(text: &[u8]) -> String {
        let message = read(text, "a.ele", &outline()).unwrap_err().to_string();
        message.lines().next().unwrap_or_default().to_owned()
    }

    #[test]
    fn points_and_edges_are_those_of_the_outline() {
        let (mesh, warnings) = read(b"2 3\n0 0 1 2\n1 0 2 3\n", "a.ele", &outline()).unwrap();
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(mesh.triangle_tags, [0, 0]);
        assert_eq!(mesh.edges, [[0, 1]]);
        assert_eq!(mesh.edge_tags, [9]);
        assert_eq!(mesh.point_markers, [1; 4]);
        assert_eq!(mesh.point_data[0].values, Values::Real(vec![0.5; 4]));
        assert_eq!(warnings, []);
    }

    #[test]
    fn an_attribute_that_is_no_tag_is_data() {
        let (mesh, _) = read(b"1 3 2\n0 0 1 2 .5 7\n", "a.ele", &outline()).unwrap();
        assert_eq!(mesh.triangle_tags, [0]);
        let names: Vec<_> = mesh.triangle_data.iter().map(|data| data.name.as_str()).collect();
        assert_eq!(names, ["attribute_1", "attribute_2"]);
    }

    /// Reads one triangle beside files of these texts, as points, edges and warnings.
    fn beside(node: Option<&str>, poly: Option<&str>) -> Result<(usize, usize, String), String> {
        let companion = |name: &str| {
            let text = if name == "dir/a.1.node" { node } else { poly };
            assert!(["dir/a.1.node", "dir/a.1.poly"].contains(&name), "{name}");
            text.map(Into::into).ok_or(io::ErrorKind::NotFound.into())
        };
        let read = read_with_companions(b"1 3\n1 1 2 3\n", "dir/a.1.ele.gz", companion);
        let (mesh, warnings) = read.map_err(|error| error.to_string())?;
        assert_eq!(mesh.triangles, [[0, 1, 2]]);
        let warnings: Vec<_> = warnings.iter().map(Warning::to_string).collect();
        Ok((mesh.points.len(), mesh.edges.len(), warnings.join("\n")))
    }

    const NODE: &str = "3 2\n1 0 0\n2 1 0\n3 0 1\n";

    #[test]
    fn points_stand_beside_in_either_file_or_both() {
        let segments = "1\n1 1 2\n0\n";
        let whole = NODE.to_owned() + segments;
        let without_points = "0 2\n".to_owned() + segments;
        let fine = |points, edges| Ok((points, edges, String::new()));
        assert_eq!(beside(Some(NODE), None), fine(3, 0));
        assert_eq!(beside(None, Some(&whole)), fine(3, 1));
        assert_eq!(beside(Some(NODE), Some(&without_points)), fine(3, 1));
        assert_eq!(beside(Some(NODE), Some(&whole)), fine(3, 1));
    }

    #[test]
    fn the_outline_of_the_same_name_is_not_taken_for_the_edges() {
        let outline = "2 2\n1 0 0\n2 9 0\n1\n1 1 2\n0\n";
        let warning = "dir/a.1.poly:2: these are not the points of `dir/a.1.node`: the file is \
                       passed over, and the mesh has no edges";
        assert_eq!(beside(Some(NODE), Some(outline)), Ok((3, 0, warning.to_owned())));
    }

    #[test]
    fn triangles_without_points_are_an_error() {
        let error = beside(None, None).unwrap_err();
        let first = "dir/a.1.ele.gz:1:1: expected points beside, in `dir/a.1.node`, found `1`";
        assert!(error.starts_with(first), "{error}");
        assert!(error.ends_with("help: there is no dir/a.1.node and no dir/a.1.poly"), "{error}");
        let error = beside(None, Some("0 2\n0\n0\n")).unwrap_err();
        assert!(error.starts_with("dir/a.1.poly:1:1: expected points"), "{error}");
    }

    #[test]
    fn data_come_after_the_tag_even_where_there_is_none() {
        let data = |name: &str, values| Data { name: name.into(), components: 1, values };
        let mesh = Mesh {
            triangles: vec![[0, 1, 2]],
            triangle_tags: vec![0],
            triangle_data: vec![
                data("load", Values::Real(vec![3.0])),
                data("rank", Values::Integer(vec![4])),
            ],
            ..Mesh::default()
        };
        let mut text = Vec::new();
        let notes = write(&mesh, &mut text).expect("memory takes all");
        assert_eq!(text, b"1 3 2\n1 1 2 3 0 3\n");
        let notes: Vec<_> = notes.iter().map(Note::to_string).collect();
        let dropped = "the data `rank` are not written: an attribute is one real number";
        assert_eq!(notes, ["the data `load` are attribute 2", dropped]);
    }

    #[test]
    fn errors_name_their_word() {
        let six = "a.ele:1:3: expected 3 nodes per triangle, found `6`";
        assert_eq!(error(b"1 6\n"), six);
        let out = "a.ele:2:7: expected the number of a point (0 to 3), found `4`";
        assert_eq!(error(b"1 3\n0 0 1 4\n"), out);
        let end = "a.ele:2:8: expected triangle 2 of 2, found the end of the file";
        assert_eq!(error(b"2 3\n0 0 1 2\n"), end);
    }
}
