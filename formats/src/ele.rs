//! Triangles in Triangle's `.ele` files.
//!
//! ```text
//! ele      := <number of triangles> [<nodes per triangle: 3> [<number of attributes>]] triangle*
//! triangle := <number> <corner> <corner> <corner> <attribute>*
//! ```
//!
//! One line each; `#` starts a comment (<https://www.cs.cmu.edu/~quake/triangle.ele.html>). Triangles
//! of six nodes are refused.

use crate::error::{Notice, SyntaxError, Warning};
use crate::mesh::{Data, Mesh, Values};
use crate::node::{Lines, MOST, optional, reserved, trailing_text};
use crate::poly::{point, whole};
use crate::pslg::{Group, Pslg};
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
    for index in 0..count {
        if !scanner.next_line() {
            return Err(scanner.missing(format!("triangle {} of {count}", index + 1)));
        }
        scanner.integer("the number of a triangle", i64::MIN, i64::MAX)?;
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
        let (name, values) = (format!("attribute_{}", index + 1), Values::Real(values));
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
