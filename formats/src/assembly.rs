//! What the readers of mesh files share: from cells as a file gives them to a plane mesh of
//! straight edges and triangles.

use crate::error::{Notice, Warning};
use crate::mesh::{Data, Mesh, Values};
use crate::pslg::{Membership, Tag};

/// What a cell of a mesh is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    Point,
    Edge,
    Triangle,
}

impl Shape {
    pub fn dim(self) -> u8 {
        self as u8
    }

    /// How many corners it has; further nodes lie between them.
    pub fn corners(self) -> usize {
        self as usize + 1
    }
}

/// A mesh that grows cell by cell.
#[derive(Default)]
pub(crate) struct Assembly {
    pub mesh: Mesh,
    pub warnings: Vec<Warning>,
    /// The nodes between the corners of cells, again for each cell.
    between: Vec<u32>,
    /// How many cells have such nodes.
    curved: usize,
    /// The z coordinate of all points.
    pub plane: Option<f64>,
}

impl Assembly {
    /// Takes a cell: its corners, then the nodes between them. A point that is in no group is
    /// nothing more than the point.
    pub fn push(&mut self, shape: Shape, nodes: &[u32], tag: Tag) {
        let (corners, between) = nodes.split_at(shape.corners());
        match (shape, corners) {
            (Shape::Triangle, &[a, b, c]) => {
                self.mesh.triangles.push([a, b, c]);
                self.mesh.triangle_tags.push(tag);
            }
            (Shape::Edge, &[a, b]) => {
                self.mesh.edges.push([a, b]);
                self.mesh.edge_tags.push(tag);
            }
            (_, &[item, ..]) if tag != 0 => {
                self.mesh.memberships.push(Membership { dim: 0, item, tag });
            }
            _ => {}
        }
        self.curved += usize::from(!between.is_empty());
        self.between.extend(between);
    }

    /// Takes a z coordinate; where it is not that of the points before, that one is the answer.
    pub fn same_plane(&mut self, z: f64) -> Result<(), f64> {
        let first = *self.plane.get_or_insert(z);
        if z == first { Ok(()) } else { Err(first) }
    }

    pub fn warn(&mut self, file: &str, line: u32, notice: Notice) {
        self.warnings.push(Warning { file: file.to_owned(), line, notice });
    }

    /// Says that a z coordinate other than 0 was dropped; the points begin in this line.
    pub fn warn_of_plane(&mut self, file: &str, line: u32) {
        if let Some(z) = self.plane.filter(|&z| z != 0.0) {
            self.warn(file, line, Notice::Plane { z });
        }
    }

    /// The mesh: each edge once, and no node that lies only between corners.
    pub fn finish(mut self, file: &str) -> (Mesh, Vec<Warning>) {
        if self.curved > 0 {
            let nodes = drop_points(&mut self.mesh, self.between);
            let notice = Notice::HigherOrder { cells: self.curved, nodes };
            self.warnings.push(Warning { file: file.to_owned(), line: 0, notice });
        }
        fold_repeated_edges(&mut self.mesh);
        (self.mesh, self.warnings)
    }
}

/// Leaves each edge once: where it is there again with another tag, that is a further group.
pub(crate) fn fold_repeated_edges(mesh: &mut Mesh) {
    let ends = |edge: &u32| {
        let [a, b] = mesh.edges[*edge as usize];
        [a.min(b), a.max(b)]
    };
    let mut order: Vec<u32> = (0..mesh.edges.len() as u32).collect();
    order.sort_unstable_by_key(|edge| (ends(edge), *edge));
    // The edge that each one is: itself, or the first with the same ends.
    let mut first: Vec<u32> = (0..mesh.edges.len() as u32).collect();
    for same in order.chunk_by(|a, b| ends(a) == ends(b)) {
        same.iter().for_each(|&edge| first[edge as usize] = same[0]);
    }
    let is_kept: Vec<bool> = (0..).zip(&first).map(|(edge, &first)| edge == first).collect();
    if is_kept.iter().all(|&kept| kept) {
        return;
    }
    let (place, _) = places(&is_kept);
    for membership in mesh.memberships.iter_mut().filter(|membership| membership.dim == 1) {
        membership.item = place[first[membership.item as usize] as usize];
    }
    for (edge, &first) in first.iter().enumerate() {
        let tag = mesh.edge_tag(edge);
        if tag != mesh.edge_tag(first as usize) {
            let item = place[first as usize];
            mesh.memberships.push(Membership { dim: 1, item, tag });
        }
    }
    keep(&mut mesh.edges, &is_kept);
    keep(&mut mesh.edge_tags, &is_kept);
    keep(&mut mesh.edge_segments, &is_kept);
}

/// Drops those of these points that are no corner of any cell; answers how many.
fn drop_points(mesh: &mut Mesh, candidates: Vec<u32>) -> usize {
    let mut is_kept = vec![true; mesh.points.len()];
    candidates.into_iter().for_each(|point| is_kept[point as usize] = false);
    let corners = mesh.triangles.iter().flatten().chain(mesh.edges.iter().flatten());
    corners.for_each(|&corner| is_kept[corner as usize] = true);
    let (place, kept) = places(&is_kept);
    let cells = mesh.triangles.iter_mut().flatten().chain(mesh.edges.iter_mut().flatten());
    cells.for_each(|corner| *corner = place[*corner as usize]);
    mesh.memberships.retain(|m| m.dim != 0 || is_kept[m.item as usize]);
    for membership in mesh.memberships.iter_mut().filter(|membership| membership.dim == 0) {
        membership.item = place[membership.item as usize];
    }
    keep(&mut mesh.points, &is_kept);
    keep(&mut mesh.point_markers, &is_kept);
    keep(&mut mesh.provenance, &is_kept);
    for Data { components, values, .. } in &mut mesh.point_data {
        match values {
            Values::Real(values) => keep_tuples(values, *components, &is_kept),
            Values::Integer(values) => keep_tuples(values, *components, &is_kept),
        }
    }
    is_kept.len() - kept as usize
}

/// The index that each item has among those that are kept, and how many these are.
fn places(is_kept: &[bool]) -> (Vec<u32>, u32) {
    let mut kept = 0;
    let place = |&is_kept: &bool| {
        kept += u32::from(is_kept);
        kept - u32::from(is_kept)
    };
    (is_kept.iter().map(place).collect(), kept)
}

/// Keeps the items of an array that may be empty.
fn keep<T>(items: &mut Vec<T>, is_kept: &[bool]) {
    keep_tuples(items, 1, is_kept);
}

fn keep_tuples<T>(items: &mut Vec<T>, components: usize, is_kept: &[bool]) {
    let mut index = 0;
    items.retain(|_| {
        index += 1;
        is_kept.get((index - 1) / components.max(1)).is_some_and(|&kept| kept)
    });
}
