//! VTK's datasets of cells, as the readers of its files hold them, and the mesh in them.
//!
//! Edges, triangles and points are taken; of curved cells and polylines the corners and pieces. See
//! [`vtu`](crate::vtu) for the arrays that have a meaning.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::assembly::{Assembly, Shape};
use crate::error::Warning;
use crate::groups::stated_tag;
use crate::mesh::{Data, Mesh, Provenance, Values};
use crate::pslg::{Group, Tag};
use crate::vtu::{MARKER, PHYSICAL, PROVENANCE, SEGMENT, TAG};

/// Points, cells and arrays, as they stand in a file.
#[derive(Default)]
pub(crate) struct Grid {
    /// Three coordinates for each point.
    pub points: Vec<f64>,
    /// VTK's kind of each cell.
    pub kinds: Vec<i64>,
    /// Where the nodes of each cell end among all.
    pub ends: Vec<i64>,
    /// The nodes of all cells.
    pub nodes: Vec<i64>,
    /// Arrays of points, with the right number of values.
    pub point_data: Vec<Data>,
    /// Arrays of cells, with the right number of values.
    pub cell_data: Vec<Data>,
    /// Arrays of the whole.
    pub field: Vec<Data>,
}

/// An array of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    Points,
    Kinds,
    Ends,
    Nodes,
    PointData(usize),
    CellData(usize),
}

/// A number in a grid that means nothing.
#[derive(Debug)]
pub(crate) struct Wrong {
    pub part: Part,
    /// Its place in the array, from zero.
    pub index: usize,
    pub expected: &'static str,
    pub found: String,
}

fn wrong(part: Part, index: usize, expected: &'static str, found: impl ToString) -> Wrong {
    Wrong { part, index, expected, found: found.to_string() }
}

/// Which cell each edge and each triangle of the mesh is.
#[derive(Default)]
struct Cells {
    edges: Vec<usize>,
    triangles: Vec<usize>,
    /// Points that are cells, and which.
    points: Vec<(u32, usize)>,
}

impl Grid {
    /// The mesh, and what was left out of it.
    pub fn take_mesh(&mut self, file: &str) -> Result<(Mesh, Vec<Warning>), Wrong> {
        let mut assembly = Assembly::default();
        self.take_points(&mut assembly)?;
        assembly.warn_of_plane(file, 0);
        let tags = self.tags()?;
        let cells = self.take_cells(&mut assembly, &tags)?;
        self.take_segments(&mut assembly.mesh, &cells)?;
        let meaning = self.meaning(&cells, &tags);
        self.take_groups(&meaning, &mut assembly.mesh);
        self.take_markers(&mut assembly.mesh)?;
        self.check_provenance()?;
        self.take_data(&mut assembly.mesh, &cells);
        let (mut mesh, warnings) = assembly.finish(file);
        take_provenance(&mut mesh);
        Ok((mesh, warnings))
    }

    fn take_points(&self, assembly: &mut Assembly) -> Result<(), Wrong> {
        for (point, xyz) in self.points.chunks_exact(3).enumerate() {
            if let Some(k) = xyz.iter().position(|x| !x.is_finite()) {
                let index = 3 * point + k;
                return Err(wrong(Part::Points, index, "a finite number", xyz[k]));
            }
            if assembly.same_plane(xyz[2]).is_err() {
                let expected = "the same z for all points";
                return Err(wrong(Part::Points, 3 * point + 2, expected, xyz[2]));
            }
            assembly.mesh.points.push([xyz[0], xyz[1]]);
        }
        Ok(())
    }

    /// The tag of each cell: the first array that has a meaning, 0 without one.
    fn tags(&self) -> Result<Vec<Tag>, Wrong> {
        let known = [TAG, PHYSICAL, "medit:ref", "CellEntityIds"];
        let of_cells = known.into_iter().find_map(|name| whole(&self.cell_data, name));
        let Some((array, numbers)) = of_cells else { return Ok(vec![0; self.kinds.len()]) };
        tags(numbers, Part::CellData(array))
    }

    fn take_cells(&self, assembly: &mut Assembly, tags: &[Tag]) -> Result<Cells, Wrong> {
        let mut cells = Cells::default();
        let mut start = 0;
        let mut nodes = Vec::new();
        for (cell, (&kind, &end)) in self.kinds.iter().zip(&self.ends).enumerate() {
            let range = usize::try_from(end).ok().filter(|&end| start <= end);
            let range = range.filter(|&end| end <= self.nodes.len()).map(|end| start..end);
            let expected = "the number of nodes so far";
            let range = range.ok_or_else(|| wrong(Part::Ends, cell, expected, end))?;
            start = range.end;
            self.nodes_of(range.clone(), assembly.mesh.points.len(), &mut nodes)?;
            let pieces = pieces(kind, range.len()).ok_or_else(|| {
                let found = format!("{kind} ({}) of {} nodes", kind_name(kind), range.len());
                wrong(Part::Kinds, cell, "3 (line), 5 (triangle) or 1 (vertex)", found)
            })?;
            match pieces {
                Pieces::Points => {
                    for &node in &nodes {
                        cells.points.push((node, cell));
                        assembly.push(Shape::Point, &[node], tags[cell]);
                    }
                }
                Pieces::Chain => {
                    for pair in nodes.windows(2) {
                        cells.edges.push(cell);
                        assembly.push(Shape::Edge, pair, tags[cell]);
                    }
                }
                Pieces::One(shape) => {
                    assembly.push(shape, &nodes, tags[cell]);
                    let of_shape =
                        if shape == Shape::Edge { &mut cells.edges } else { &mut cells.triangles };
                    of_shape.push(cell);
                }
            }
        }
        Ok(cells)
    }

    fn nodes_of(
        &self,
        range: Range<usize>,
        points: usize,
        nodes: &mut Vec<u32>,
    ) -> Result<(), Wrong> {
        nodes.clear();
        for index in range {
            let node = self.nodes[index];
            match u32::try_from(node) {
                Ok(point) if (point as usize) < points => nodes.push(point),
                _ => return Err(wrong(Part::Nodes, index, "a point", node)),
            }
        }
        Ok(())
    }

    fn take_segments(&self, mesh: &mut Mesh, cells: &Cells) -> Result<(), Wrong> {
        let Some((array, numbers)) = whole(&self.cell_data, SEGMENT) else { return Ok(()) };
        let segment = |&cell: &usize| {
            let number = numbers[cell];
            let segment = if number == -1 { Some(u32::MAX) } else { u32::try_from(number).ok() };
            let expected = "a segment's number or -1";
            segment.ok_or_else(|| wrong(Part::CellData(array), cell, expected, number))
        };
        mesh.edge_segments = cells.edges.iter().map(segment).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// Which tag the number of a group stands for, by dimension and number.
    fn meaning(&self, cells: &Cells, tags: &[Tag]) -> BTreeMap<(u8, i64), Tag> {
        let physical = whole(&self.cell_data, PHYSICAL).map(|(_, numbers)| numbers);
        let mut meaning = BTreeMap::new();
        let mut add = |dim, cell: usize| {
            let number = physical.map_or(i64::from(tags[cell]), |numbers| numbers[cell]);
            meaning.entry((dim, number)).or_insert(tags[cell]);
        };
        cells.points.iter().for_each(|&(_, cell)| add(0, cell));
        cells.edges.iter().for_each(|&cell| add(1, cell));
        cells.triangles.iter().for_each(|&cell| add(2, cell));
        meaning
    }

    /// The user's names: those of field arrays that hold pairs, less the stated ones.
    fn take_groups(&self, meaning: &BTreeMap<(u8, i64), Tag>, mesh: &mut Mesh) {
        for Data { name, values, .. } in &self.field {
            let Values::Integer(numbers) = values else { continue };
            let pairs = numbers.chunks_exact(2);
            if !pairs.remainder().is_empty() {
                continue;
            }
            for pair in pairs {
                let (Ok(number), Ok(dim @ 0..=2)) = (Tag::try_from(pair[0]), u8::try_from(pair[1]))
                else {
                    continue;
                };
                let tag = meaning.get(&(dim, pair[0])).copied().unwrap_or(number);
                if stated_tag(dim, name) != Some(tag) {
                    mesh.groups.push(Group { dim, tag, name: name.clone() });
                }
            }
        }
        mesh.groups.sort();
    }

    fn take_markers(&self, mesh: &mut Mesh) -> Result<(), Wrong> {
        if let Some((array, numbers)) = whole(&self.point_data, MARKER) {
            mesh.point_markers = tags(numbers, Part::PointData(array))?;
        }
        Ok(())
    }

    fn check_provenance(&self) -> Result<(), Wrong> {
        let Some((array, numbers)) = whole(&self.point_data, PROVENANCE) else { return Ok(()) };
        match numbers.iter().position(|number| !(-1..=3).contains(number)) {
            None => Ok(()),
            Some(index) => {
                let expected = "0 (input), 1 (shell), 2 (midpoint) or 3 (circumcenter)";
                Err(wrong(Part::PointData(array), index, expected, numbers[index]))
            }
        }
    }

    /// The data that have no other meaning; provenance stays among those of points for now.
    fn take_data(&mut self, mesh: &mut Mesh, cells: &Cells) {
        let is_meant =
            |data: &Data, names: &[&str]| names.contains(&data.name.as_str()) && is_whole(data);
        mesh.point_data = std::mem::take(&mut self.point_data);
        mesh.point_data.retain(|data| !is_meant(data, &[MARKER]));
        let all = std::mem::take(&mut self.cell_data).into_iter();
        let kept = all.filter(|data| !is_meant(data, &[PHYSICAL, TAG, SEGMENT]));
        mesh.triangle_data = kept.map(|data| of_triangles(data, &cells.triangles)).collect();
    }
}

/// What a cell is to a mesh.
enum Pieces {
    /// A point for each node.
    Points,
    /// An edge from each node to the next.
    Chain,
    One(Shape),
}

fn pieces(kind: i64, nodes: usize) -> Option<Pieces> {
    Some(match (kind, nodes) {
        (1, 1) | (2, _) => Pieces::Points,
        (3, 2) => Pieces::One(Shape::Edge),
        (4, 2..) => Pieces::Chain,
        (21, 3) | (35, 4) | (68, 2..) => Pieces::One(Shape::Edge),
        (5 | 7, 3) | (22, 6) | (34, 7) | (69, 3..) => Pieces::One(Shape::Triangle),
        _ => return None,
    })
}

/// VTK's name of a kind of cells.
fn kind_name(kind: i64) -> &'static str {
    match kind {
        1 => "vertex",
        3 => "line",
        4 => "polyline",
        5 => "triangle",
        6 => "triangle strip",
        7 => "polygon",
        8 => "pixel",
        9 => "quadrilateral",
        10 => "tetrahedron",
        11 => "voxel",
        12 => "hexahedron",
        13 => "wedge",
        14 => "pyramid",
        21 => "quadratic edge",
        22 => "quadratic triangle",
        23 => "quadratic quadrilateral",
        24 => "quadratic tetrahedron",
        _ => "another kind",
    }
}

fn is_whole(data: &Data) -> bool {
    data.components == 1 && matches!(data.values, Values::Integer(_))
}

/// An array of one whole number each, by its name: its index and its numbers.
fn whole<'a>(all: &'a [Data], name: &str) -> Option<(usize, &'a [i64])> {
    let index = all.iter().position(|data| data.name == name && is_whole(data))?;
    match &all[index].values {
        Values::Integer(values) => Some((index, values)),
        Values::Real(_) => None,
    }
}

fn tags(numbers: &[i64], part: Part) -> Result<Vec<Tag>, Wrong> {
    let tag = |(index, &number): (usize, &i64)| {
        let expected = "a whole number of 32 bits";
        Tag::try_from(number).map_err(|_| wrong(part, index, expected, number))
    };
    numbers.iter().enumerate().map(tag).collect()
}

fn of_triangles(data: Data, cells: &[usize]) -> Data {
    fn pick<T: Copy>(values: &[T], components: usize, cells: &[usize]) -> Vec<T> {
        let tuple = |&cell: &usize| &values[cell * components..(cell + 1) * components];
        cells.iter().flat_map(tuple).copied().collect()
    }
    let components = data.components;
    let values = match &data.values {
        Values::Real(values) => Values::Real(pick(values, components, cells)),
        Values::Integer(values) => Values::Integer(pick(values, components, cells)),
    };
    Data { values, ..data }
}

/// Takes provenance out of the data of points; nodes between corners, which have none, are gone.
fn take_provenance(mesh: &mut Mesh) {
    let Some((array, numbers)) = whole(&mesh.point_data, PROVENANCE) else { return };
    use Provenance::{Circumcenter, Input, Midpoint, Shell};
    let kinds = [Input, Shell, Midpoint, Circumcenter];
    let kind = |&number: &i64| kinds.into_iter().find(|&kind| kind as i64 == number);
    let known: Option<Vec<Provenance>> = numbers.iter().map(kind).collect();
    mesh.provenance = known.unwrap_or_default();
    mesh.point_data.remove(array);
}
