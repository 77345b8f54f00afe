//! From sets and surfaces to the groups of a mesh.

use std::collections::BTreeSet;

use super::read::{Cell, Reader};
use super::sets::{Members, Set};
use crate::assembly::{Assembly, Shape};
use crate::error::{Notice, SyntaxError};
use crate::pslg::{Membership, Tag};
use crate::tags::{self, Named};
use crate::text::Scanner;

/// A surface: its name, and the ends of each side.
type Sides<'a> = (&'a str, Vec<[u32; 2]>);

/// Sets of all, which CalculiX's users and writers of meshes name so: they are no group.
const ALL: [&str; 2] = ["EALL", "NALL"];

/// The groups of triangles, of edges and of points, each with its members.
pub(super) struct Groups<'a> {
    /// Triangles and edges as indices of cells; those that are meant first come first.
    triangles: Vec<(&'a str, Vec<u32>)>,
    lines: Vec<(&'a str, Vec<u32>)>,
    /// Edges as their ends.
    surfaces: Vec<Sides<'a>>,
    points: Vec<(&'a str, Vec<u32>)>,
}

impl<'a> Groups<'a> {
    pub fn of(
        reader: &'a Reader,
        corners: &[u32],
        scanner: &'a Scanner<'a>,
    ) -> Result<Self, SyntaxError> {
        let what = "the number of an element";
        let mut elements = Members::new(&reader.elements, what, scanner);
        let sets = || reader.own_sets.iter().chain(&reader.element_sets);
        sets().try_for_each(|set| elements.add(set))?;
        let surfaces = surfaces(reader, corners, &mut elements, scanner)?;
        let of_shape = |shape| {
            let mut groups = Vec::new();
            let mut is_in_one = vec![false; reader.cells.len()];
            let asked = names(reader.element_sets.iter()).into_iter().map(|name| (name, true));
            let own = names(reader.own_sets.iter()).into_iter().map(|name| (name, false));
            for (name, is_asked) in asked.chain(own) {
                // The set of `*ELEMENT` counts where no other one does.
                let mut members = elements.named(name).to_vec();
                members.retain(|&cell| {
                    let is_free = is_asked || !is_in_one[cell as usize];
                    is_free && reader.cells[cell as usize].shape == shape
                });
                members.iter().for_each(|&cell| is_in_one[cell as usize] = true);
                if !members.is_empty() {
                    groups.push((name, members));
                }
            }
            groups
        };
        let (triangles, lines) = (of_shape(Shape::Triangle), of_shape(Shape::Edge));
        let mut nodes = Members::new(&reader.nodes, "the number of a node", scanner);
        reader.node_sets.iter().try_for_each(|set| nodes.add(set))?;
        // The nodes of a boundary are told by its edges.
        let told = lines.iter().map(|(name, _)| name).chain(surfaces.iter().map(|(name, _)| name));
        let told: BTreeSet<String> = told.map(|name| name.to_ascii_uppercase()).collect();
        let of_points = names(reader.node_sets.iter())
            .into_iter()
            .filter(|name| !told.contains(&name.to_ascii_uppercase()));
        let points = of_points.map(|name| (name, nodes.named(name).to_vec())).collect();
        Ok(Self { triangles, lines, surfaces, points })
    }

    /// Hands all cells on, with their tags.
    pub fn assemble(&self, cells: &[Cell], corners: &[u32], assembly: &mut Assembly, file: &str) {
        let first = |groups: &[(&'a str, _)]| groups.iter().map(|(name, _)| *name).collect();
        let of_edges = self.lines.iter().map(|(name, _)| *name);
        let of_edges = of_edges.chain(self.surfaces.iter().map(|(name, _)| *name)).collect();
        let named = [
            Named { dim: 2, names: first(&self.triangles) },
            Named { dim: 1, names: of_edges },
            Named { dim: 0, names: first(&self.points) },
        ];
        let tags = tags::of_names(&named, &mut assembly.mesh.groups);
        let (of_lines, of_surfaces) = tags[1].split_at(self.lines.len());

        let (triangle_tags, further) = first_of(&self.triangles, &tags[0], cells.len());
        if !further.is_empty() {
            let mut triangles: Vec<u32> = further.iter().map(|&(cell, _)| cell).collect();
            triangles.dedup();
            assembly.warn(file, 0, Notice::FurtherSets { triangles: triangles.len() });
        }
        let (line_tags, further) = first_of(&self.lines, of_lines, cells.len());
        let mut edges = vec![0; cells.len()];
        let mut start = 0;
        for (index, cell) in cells.iter().enumerate() {
            edges[index] = assembly.mesh.edges.len() as u32;
            let all = if cell.shape == Shape::Edge { &line_tags } else { &triangle_tags };
            assembly.push(cell.shape, &corners[start..cell.end], all[index].unwrap_or(0));
            start = cell.end;
        }
        let further = further.into_iter().map(|(cell, tag)| (edges[cell as usize], tag));
        let membership = |(item, tag)| Membership { dim: 1, item, tag };
        assembly.mesh.memberships.extend(further.map(membership));
        for ((_, sides), &tag) in self.surfaces.iter().zip(of_surfaces) {
            sides.iter().for_each(|side| assembly.push(Shape::Edge, side, tag));
        }
        for ((_, points), &tag) in self.points.iter().zip(&tags[2]) {
            points.iter().for_each(|&point| assembly.push(Shape::Point, &[point], tag));
        }
    }
}

/// The names of sets, each once, but those of sets of all.
fn names<'a>(sets: impl Iterator<Item = &'a Set>) -> Vec<&'a str> {
    let mut known: BTreeSet<String> = ALL.into_iter().map(str::to_owned).collect();
    let is_new = |set: &&Set| known.insert(set.name.to_ascii_uppercase());
    sets.filter(is_new).map(|set| set.name.as_str()).collect()
}

/// The tag of the first group that each cell is in, and the others with their cells.
fn first_of(
    groups: &[(&str, Vec<u32>)],
    tags: &[Tag],
    cells: usize,
) -> (Vec<Option<Tag>>, Vec<(u32, Tag)>) {
    let mut first = vec![None; cells];
    let mut further = Vec::new();
    for ((_, members), &tag) in groups.iter().zip(tags) {
        for &cell in members {
            match first[cell as usize] {
                None => first[cell as usize] = Some(tag),
                Some(known) if known != tag => further.push((cell, tag)),
                Some(_) => {}
            }
        }
    }
    further.sort_unstable();
    (first, further)
}

/// The ends of the sides in each surface.
fn surfaces<'a>(
    reader: &'a Reader,
    corners: &[u32],
    elements: &mut Members,
    scanner: &Scanner,
) -> Result<Vec<Sides<'a>>, SyntaxError> {
    let mut surfaces = Vec::new();
    for surface in &reader.surfaces {
        let mut edges = Vec::new();
        for (set, side) in &surface.sides {
            for cell in elements.of(set)? {
                let start = cell.checked_sub(1).map_or(0, |cell| reader.cells[cell as usize].end);
                let Cell { shape: Shape::Triangle, .. } = reader.cells[cell as usize] else {
                    return Err(scanner.unexpected_at(set.place(), "a triangle"));
                };
                let corner = |k: usize| corners[start + k % 3];
                edges.push([corner(*side), corner(side + 1)]);
            }
        }
        surfaces.push((surface.name.as_str(), edges));
    }
    Ok(surfaces)
}
