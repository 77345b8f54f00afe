//! Entities, nodes and elements as version 4.1 has them: groups belong to entities, and all else
//! stands in blocks, one for each entity.
//!
//! There is an entity for each point, and for each set of groups of an edge or a triangle. What
//! bounds what is not said.

use std::io::{self, Write};

use super::entities::Entities;
use super::kinds;
use super::scribe::Scribe;
use crate::blocks::Blocks;
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
    let blocks = blocks(&entities.of_nodes, entities);
    scribe.text("$Nodes\n")?;
    let (blocks_in_use, count) = (blocks.in_use().count(), nodes.len());
    [blocks_in_use, count, count.min(1), count].into_iter().for_each(|size| scribe.size(size));
    scribe.end()?;
    for (entity, items) in blocks.in_use() {
        let entity = &entities.all[entity];
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
    let [points_of, edges_of, triangles_of] =
        [&of_points, of_edges, of_triangles].map(|of| blocks(of, entities));
    let blocks = || points_of.in_use().chain(edges_of.in_use()).chain(triangles_of.in_use());
    let before = [of_edges.len(), 0, of_edges.len() + points.len()];
    let count = before[2] + of_triangles.len();
    scribe.text("$Elements\n")?;
    [blocks().count(), count, count.min(1), count].into_iter().for_each(|size| scribe.size(size));
    scribe.end()?;
    for (entity, items) in blocks() {
        let entity = &all[entity];
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

/// Items by their entities.
fn blocks(of: &[u32], entities: &Entities) -> Blocks {
    Blocks::new(of.iter().map(|&entity| entity as usize), entities.all.len())
}
