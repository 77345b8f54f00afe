//! Nodes and elements of version 2.
//!
//! ```text
//! nodes    := $Nodes <count> node* $EndNodes
//! node     := <number> <x> <y> <z>
//! elements := $Elements <count> element* $EndElements
//! element  := <number> <type> <number of tags> <tag>* <node>*
//! ```
//!
//! Each count in a line of text. In binary files elements of one kind stand together:
//!
//! ```text
//! elements := $Elements <count> block* $EndElements
//! block    := <type> <how many> <number of tags> (<number> <tag>* <node>*)*
//! ```
//!
//! Of the tags the first, the physical number, is taken
//! (<https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format-version-2-_0028Legacy_0029>).

use super::source::Source;
use super::{Elements, Reader, count, shape};
use crate::assembly::Shape;
use crate::error::SyntaxError;
use crate::node::reserved;
use crate::numbering::Numbering;
use crate::pslg::Tag;

pub(super) fn nodes<'a>(
    reader: &mut Reader,
    source: &mut impl Source<'a>,
) -> Result<(), SyntaxError> {
    let count = count(source.scanner(), "the number of nodes")?;
    source.begin()?;
    // The shortest node, `1 0 0 0` and a line end, has eight bytes.
    reader.assembly.mesh.points.reserve(reserved(count, source.scanner().left(), 8));
    let mut nodes = Numbering::default();
    let mut first = 0;
    for index in 0..count {
        source.row("node", index, count)?;
        if index == 0 {
            first = source.scanner().line();
        }
        let number = source.int("the number of a node", 1, i64::MAX)?;
        nodes.push(number, source.place());
        reader.coordinates(source)?;
        source.end_row()?;
    }
    reader.end_nodes(source, nodes, first)
}

pub(super) fn elements<'a>(
    reader: &mut Reader,
    source: &mut impl Source<'a>,
    is_binary: bool,
) -> Result<(), SyntaxError> {
    let count = count(source.scanner(), "the number of elements")?;
    source.begin()?;
    let mut elements = Elements::default();
    let mut nodes = Vec::new();
    let mut done = 0;
    while done < count {
        if is_binary {
            let kind = source.int(KIND, i64::MIN, i64::MAX)?;
            let kind = shape(source, kind)?;
            let block = source.int("how many elements are of this type", 1, count - done)?;
            let tags = source.int(TAGS, 0, MOST_TAGS)?;
            for _ in 0..block {
                let number = source.int(NUMBER, i64::MIN, i64::MAX)?;
                elements.numbers.push(number, source.place());
                element(reader, source, (kind, tags), &mut nodes, &mut elements)?;
            }
            done += block;
        } else {
            source.row("element", done, count)?;
            let number = source.size(NUMBER, i64::MIN, i64::MAX)?;
            elements.numbers.push(number, source.place());
            let kind = source.int(KIND, i64::MIN, i64::MAX)?;
            let kind = shape(source, kind)?;
            let tags = source.int(TAGS, 0, MOST_TAGS)?;
            element(reader, source, (kind, tags), &mut nodes, &mut elements)?;
            source.end_row()?;
            done += 1;
        }
    }
    reader.end_elements(source, elements)
}

const NUMBER: &str = "the number of an element";
const KIND: &str = "an element's type: 1 (line), 2 (triangle) or 15 (point)";
const TAGS: &str = "the number of tags (0 to 1000)";
/// Gmsh adds the partitions to the tags; more than a few are no tags any more.
const MOST_TAGS: i64 = 1000;

/// The tags and the nodes of an element.
fn element<'a>(
    reader: &mut Reader,
    source: &mut impl Source<'a>,
    ((shape, node_count), tags): ((Shape, usize), i64),
    nodes: &mut Vec<u32>,
    elements: &mut Elements,
) -> Result<(), SyntaxError> {
    let mut physical: Tag = 0;
    for index in 0..tags {
        let tag = source.int("a tag", Tag::MIN.into(), Tag::MAX.into())? as Tag;
        if index == 0 {
            physical = tag;
        }
    }
    nodes.clear();
    for _ in 0..node_count {
        let number = source.int("the number of a node", i64::MIN, i64::MAX)?;
        nodes.push(reader.node(number, source)?);
    }
    reader.element(elements, shape, nodes, physical);
    Ok(())
}
