//! Entities, nodes and elements as version 4.1 has them: groups belong to entities, and all else
//! stands in blocks, one for each entity.
//!
//! There is an entity for each point, and for each set of groups of an edge or a triangle. What
//! bounds what is not said.

use std::io::{self, Write};

use super::entities::{Entities, Entity};
use super::kinds;
use super::scribe::Scribe;
use crate::groups::Table;
use crate::nodes::Nodes;

/// Writes entities, nodes and elements; returns how many elements there are.
pub(super) fn write(
    scribe: &mut Scribe<impl Write>,
    nodes: &Nodes,
    table: &Table,
) -> io::Result<usize> {
    let entities = Entities::new(nodes, table);
    write_entities(scribe, &entities, table)?;
    write_nodes(scribe, nodes, &entities)?;
    write_elements(scribe, nodes, &entities)
}

fn write_entities(
    scribe: &mut Scribe<impl Write>,
    entities: &Entities,
    table: &Table,
) -> io::Result<()> {
    scribe.text("$Entities\n")?;
    let count = |dim| entities.all.iter().filter(|entity| entity.dim == dim).count();
    [count(0), count(1), count(2), 0].into_iter().for_each(|count| scribe.size(count));
    scribe.end()?;
    for entity in &entities.all {
        scribe.int(entity.number);
        let [[x, y], most] = entity.bounds;
        [x, y, 0.0].into_iter().for_each(|x| scribe.real(x));
        if entity.dim > 0 {
            [most[0], most[1], 0.0].into_iter().for_each(|x| scribe.real(x));
        }
        scribe.size(entity.groups.len());
        entity.groups.iter().for_each(|&group| scribe.int(table.entries[group as usize].number));
        if entity.dim > 0 {
            scribe.size(0); // entities that bound it
        }
        scribe.end()?;
    }
    scribe.close("Entities")
}

fn write_nodes(
    scribe: &mut Scribe<impl Write>,
    nodes: &Nodes,
    entities: &Entities,
) -> io::Result<()> {
    let blocks = Blocks::new(&entities.of_nodes, &entities.all);
    scribe.text("$Nodes\n")?;
    let (blocks_in_use, count) = (blocks.in_use().count(), nodes.len());
    [blocks_in_use, count, count.min(1), count].into_iter().for_each(|size| scribe.size(size));
    scribe.end()?;
    for (entity, items) in blocks.in_use() {
        scribe.int(entity.dim.into());
        scribe.int(entity.number);
        scribe.int(0); // no parametric coordinates
        scribe.size(items.len());
        scribe.end()?;
        for &node in items {
            scribe.size(node as usize + 1);
            scribe.end()?;
        }
        for &node in items {
            let [x, y] = nodes.point(node as usize);
            scribe.real(x);
            scribe.real(y);
            scribe.whole(0);
            scribe.end()?;
        }
    }
    scribe.close("Nodes")
}

/// Elements are numbered as they stand in the mesh: edges, points, triangles.
fn write_elements(
    scribe: &mut Scribe<impl Write>,
    nodes: &Nodes,
    entities: &Entities,
) -> io::Result<usize> {
    let Entities { all, points, of_edges, of_triangles, .. } = entities;
    let of_points: Vec<u32> = (0..points.len() as u32).collect();
    let point_blocks = Blocks::new(&of_points, all);
    let edge_blocks = Blocks::new(of_edges, all);
    let triangle_blocks = Blocks::new(of_triangles, all);
    let blocks =
        || point_blocks.in_use().chain(edge_blocks.in_use()).chain(triangle_blocks.in_use());
    let before = [of_edges.len(), 0, of_edges.len() + points.len()];
    let count = before[2] + of_triangles.len();
    scribe.text("$Elements\n")?;
    [blocks().count(), count, count.min(1), count].into_iter().for_each(|size| scribe.size(size));
    scribe.end()?;
    for (entity, items) in blocks() {
        let dim = usize::from(entity.dim);
        scribe.int(entity.dim.into());
        scribe.int(entity.number);
        scribe.int(kinds(nodes.order)[dim]);
        scribe.size(items.len());
        scribe.end()?;
        for &item in items {
            scribe.size(before[dim] + item as usize + 1);
            let mut add = |node: u32| scribe.size(node as usize + 1);
            match dim {
                0 => add(points[item as usize]),
                1 => nodes.edge(item as usize).for_each(add),
                _ => nodes.triangle(item as usize).for_each(add),
            }
            scribe.end()?;
        }
    }
    scribe.close("Elements")?;
    Ok(count)
}

/// Items sorted by their entities.
struct Blocks<'a> {
    entities: &'a [Entity],
    items: Vec<u32>,
    /// Where the block of each entity starts in `items`, and where the last one ends.
    starts: Vec<usize>,
}

impl<'a> Blocks<'a> {
    fn new(of: &[u32], entities: &'a [Entity]) -> Self {
        let mut starts = vec![0; entities.len() + 1];
        of.iter().for_each(|&entity| starts[entity as usize + 1] += 1);
        for entity in 0..entities.len() {
            starts[entity + 1] += starts[entity];
        }
        let mut next = starts.clone();
        let mut items = vec![0; of.len()];
        for (item, &entity) in (0..).zip(of) {
            let place = &mut next[entity as usize];
            items[*place] = item;
            *place += 1;
        }
        Self { entities, items, starts }
    }

    /// The blocks that hold something.
    fn in_use(&self) -> impl Iterator<Item = (&'a Entity, &[u32])> {
        let ranges = self.starts.windows(2).map(|ends| &self.items[ends[0]..ends[1]]);
        self.entities.iter().zip(ranges).filter(|(_, items)| !items.is_empty())
    }
}
