//! Nodes and elements of version 4.1.
//!
//! ```text
//! nodes    := $Nodes <blocks> <nodes> <least number> <largest number> block* $EndNodes
//! block    := <dimension> <entity> <1: parametric> <how many> <number>* (<x> <y> <z> <u, v, w>*)*
//! elements := $Elements <blocks> <elements> <least number> <largest number> block* $EndElements
//! block    := <dimension> <entity> <type> <how many> (<number> <node>*)*
//! ```
//!
//! What stands in parentheses, each number of a node and the heads of blocks have lines of their
//! own in text. The groups of elements are those of their entity ([`super::entities`])
//! (<https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format>).

use super::source::Source;
use super::{Elements, Reader, shape};
use crate::assembly::Shape;
use crate::error::{Notice, SyntaxError};
use crate::node::{MOST, reserved};
use crate::numbering::Numbering;
use crate::pslg::{Membership, Tag};

pub(super) fn nodes<'a>(
    reader: &mut Reader,
    source: &mut impl Source<'a>,
) -> Result<(), SyntaxError> {
    let [blocks, count] = head(source, "the number of nodes")?;
    // The shortest node, `1`, `0 0 0` and their line ends, has eight bytes.
    reader.assembly.mesh.points.reserve(reserved(count, source.scanner().left(), 8));
    let mut nodes = Numbering::default();
    let mut first = 0;
    for index in 0..blocks {
        source.row("block of nodes", index, blocks)?;
        let dim = source.int("the dimension of an entity (0 to 3)", 0, 3)?;
        source.int("the tag of an entity", i64::MIN, i64::MAX)?;
        let is_parametric = source.int("0, or 1 where nodes have parameters", 0, 1)? == 1;
        let left = count - i64::from(nodes.count());
        let block = source.size("how many nodes are in this block, of those announced", 0, left)?;
        source.end_row()?;
        for index in 0..block {
            source.row("node", index, block)?;
            let number = source.size("the number of a node", 1, i64::MAX)?;
            nodes.push(number, source.place());
            source.end_row()?;
        }
        for index in 0..block {
            source.row("the coordinates of node", index, block)?;
            if first == 0 {
                first = source.scanner().line();
            }
            reader.coordinates(source)?;
            for _ in 0..if is_parametric { dim } else { 0 } {
                source.any_real("a parameter")?;
            }
            source.end_row()?;
        }
    }
    all_there(source, nodes.count(), count, "nodes")?;
    reader.end_nodes(source, nodes, first)
}

pub(super) fn elements<'a>(
    reader: &mut Reader,
    source: &mut impl Source<'a>,
) -> Result<(), SyntaxError> {
    let [blocks, count] = head(source, "the number of elements")?;
    let mut elements = Elements::default();
    let mut nodes = Vec::new();
    for index in 0..blocks {
        source.row("block of elements", index, blocks)?;
        let line = source.scanner().line();
        let dim = source.int("the dimension of an entity (0 to 3)", 0, 3)? as u8;
        let entity = source.int("the tag of an entity", Tag::MIN.into(), Tag::MAX.into())? as Tag;
        let groups = groups(reader, source, dim, entity)?;
        let kind = source.int("an element's type", i64::MIN, i64::MAX)?;
        let (shape, node_count) = shape(source, kind)?;
        if shape.dim() != dim {
            return Err(source.wrong(format!("an element's type of dimension {dim}")));
        }
        let left = count - i64::from(elements.numbers.count());
        let what = "how many elements are in this block, of those announced";
        let block = source.size(what, 0, left)?;
        source.end_row()?;
        for index in 0..block {
            source.row("element", index, block)?;
            let number = source.size("the number of an element", i64::MIN, i64::MAX)?;
            elements.numbers.push(number, source.place());
            nodes.clear();
            for _ in 0..node_count {
                let number = source.size("the number of a node", i64::MIN, i64::MAX)?;
                nodes.push(reader.node(number, source)?);
            }
            reader.element(&mut elements, shape, &nodes, groups.first().copied().unwrap_or(0));
            join_further(reader, shape, &nodes, &groups);
            source.end_row()?;
        }
        if let (Shape::Triangle, &[kept, dropped, ..]) = (shape, &groups[..])
            && block > 0
        {
            let file = source.scanner().file();
            let notice = Notice::SecondGroup { surface: entity, kept, dropped };
            reader.assembly.warn(file, line, notice);
        }
    }
    all_there(source, elements.numbers.count(), count, "elements")?;
    reader.end_elements(source, elements)
}

/// The numbers of blocks and of items.
fn head<'a>(source: &mut impl Source<'a>, what: &'static str) -> Result<[i64; 2], SyntaxError> {
    source.begin()?;
    source.row("the number of blocks", 0, 1)?;
    let head = [source.size("the number of blocks", 0, MOST)?, source.size(what, 0, MOST)?];
    source.size("the least number", i64::MIN, i64::MAX)?;
    source.size("the largest number", i64::MIN, i64::MAX)?;
    source.end_row()?;
    Ok(head)
}

fn all_there<'a>(
    source: &mut impl Source<'a>,
    found: u32,
    announced: i64,
    what: &str,
) -> Result<(), SyntaxError> {
    if i64::from(found) == announced {
        return Ok(());
    }
    let scanner = source.scanner();
    scanner.next_line();
    let expected = format!("a block with more {what}: {found} are here, of {announced} announced");
    Err(scanner.unexpected_here(expected))
}

/// The physical groups of an entity; without entities in the file there are none.
fn groups<'a>(
    reader: &Reader,
    source: &impl Source<'a>,
    dim: u8,
    entity: Tag,
) -> Result<Vec<Tag>, SyntaxError> {
    let Some(entities) = &reader.entities else { return Ok(Vec::new()) };
    let groups = entities.groups(dim, entity.into()).map(<[Tag]>::to_vec);
    groups.ok_or_else(|| source.wrong(format!("an entity of dimension {dim} in $Entities")))
}

/// The groups of an element after its first.
fn join_further(reader: &mut Reader, shape: Shape, nodes: &[u32], groups: &[Tag]) {
    let mesh = &mut reader.assembly.mesh;
    let item = match shape {
        Shape::Point => nodes[0],
        Shape::Edge => mesh.edges.len() as u32 - 1,
        Shape::Triangle => return,
    };
    let further = groups.iter().skip(1);
    let dim = shape.dim();
    mesh.memberships.extend(further.map(|&tag| Membership { dim, item, tag }));
}
