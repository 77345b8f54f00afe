//! Nodes and elements as version 2.2 has them: an element carries its tags.

use std::io::{self, Write};

use super::kinds;
use super::scribe::Scribe;
use crate::groups::Table;
use crate::nodes::Nodes;

/// Writes nodes and elements; returns how many elements there are.
pub(super) fn write(
    scribe: &mut Scribe<impl Write>,
    nodes: &Nodes,
    table: &Table,
) -> io::Result<usize> {
    let mesh = nodes.mesh;
    let count = table.memberships.len() + mesh.edges.len() + mesh.triangles.len();
    scribe.check(nodes.len().max(count))?;
    write_nodes(scribe, nodes)?;
    scribe.text(&format!("$Elements\n{count}\n"))?;
    let [point, line, triangle] = kinds(nodes.order);
    let mut elements = Elements { scribe, written: 0 };
    elements.block(line, mesh.edges.len())?;
    for (edge, &group) in table.edges.iter().enumerate() {
        elements.add(line, table.entries[group as usize].number, nodes.edge(edge))?;
    }
    // As Gmsh writes them: an element for each group that a point or an edge is in.
    for (membership, &group) in mesh.memberships.iter().zip(&table.memberships) {
        let number = table.entries[group as usize].number;
        if membership.dim == 0 {
            elements.block(point, 1)?;
            elements.add(point, number, std::iter::once(membership.item))?;
        } else {
            elements.block(line, 1)?;
            elements.add(line, number, nodes.edge(membership.item as usize))?;
        }
    }
    elements.block(triangle, mesh.triangles.len())?;
    let mut last = None; // neighbours in the file mostly share their region
    for index in 0..mesh.triangles.len() {
        let tag = mesh.triangle_tag(index);
        let number = match last {
            Some((same, number)) if same == tag => number,
            _ => table.entries[table.region(tag)].number,
        };
        last = Some((tag, number));
        elements.add(triangle, number, nodes.triangle(index))?;
    }
    scribe.close("Elements")?;
    Ok(count)
}

fn write_nodes(scribe: &mut Scribe<impl Write>, nodes: &Nodes) -> io::Result<()> {
    scribe.text(&format!("$Nodes\n{}\n", nodes.len()))?;
    for (number, [x, y]) in (1..).zip(nodes.points()) {
        scribe.number(number);
        scribe.real(x);
        scribe.real(y);
        scribe.whole(0);
        scribe.end()?;
    }
    scribe.close("Nodes")
}

struct Elements<'s, 'a, W> {
    scribe: &'s mut Scribe<'a, W>,
    written: usize,
}

impl<W: Write> Elements<'_, '_, W> {
    /// Announces elements of one kind, as a binary file does once for all of them.
    fn block(&mut self, kind: i32, count: usize) -> io::Result<()> {
        if !self.scribe.is_binary() || count == 0 {
            return Ok(());
        }
        self.scribe.int(kind);
        self.scribe.number(count);
        self.scribe.int(TAGS);
        self.scribe.end()
    }

    fn add(&mut self, kind: i32, group: i32, nodes: impl Iterator<Item = u32>) -> io::Result<()> {
        self.written += 1;
        self.scribe.number(self.written);
        if !self.scribe.is_binary() {
            self.scribe.int(kind);
            self.scribe.int(TAGS);
        }
        self.scribe.int(group);
        self.scribe.int(group);
        nodes.for_each(|node| self.scribe.number(node as usize + 1));
        self.scribe.end()
    }
}

/// The physical and the elementary one.
const TAGS: i32 = 2;
