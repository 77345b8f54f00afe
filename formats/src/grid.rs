//! VTK's datasets of cells, as the readers of its files hold them, and the mesh in them.
//!
//! Edges, triangles and points are taken; of curved cells and polylines the corners and pieces. See
//! [`vtu`](crate::vtu) for the arrays that have a meaning.

mod cells;
mod column;
mod points;

use std::collections::BTreeMap;

use crate::error::Warning;
use crate::groups::stated_tag;
use crate::mesh::{Data, Mesh, Provenance, Values};
use crate::pslg::{Group, Tag};
use crate::vtu::{MARKER, PHYSICAL, PROVENANCE, SEGMENT, TAG};
use crate::wholes::Wholes;

pub(crate) use cells::{Cells, Runs};
pub(crate) use column::{Column, Numbers};
pub(crate) use points::Points;

/// Points, cells and arrays, as they stand in a file.
#[derive(Default)]
pub(crate) struct Grid {
    pub points: Points,
    pub cells: Cells,
    /// Arrays of points, with the right number of values.
    pub point_data: Vec<Column>,
    /// Arrays of cells, with the right number of values.
    pub cell_data: Vec<Column>,
    /// Arrays of the whole.
    pub field: Vec<Column>,
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

impl Grid {
    /// Takes the nodes of all cells.
    pub fn take_nodes(&mut self, nodes: &Wholes) {
        self.cells.begin(self.points.len(), nodes.len());
        nodes.blocks(|block| self.cells.take(block));
    }

    /// The mesh, and what was left out of it.
    pub fn take_mesh(&mut self, file: &str) -> Result<(Mesh, Vec<Warning>), Wrong> {
        self.points.wrong.take().map_or(Ok(()), Err)?;
        let tags = tags(&self.cell_data)?;
        self.cells.take(&[]);
        self.cells.wrong.take().map_or(Ok(()), Err)?;
        let mut assembly = self.cells.tagged(&tags);
        assembly.mesh.points = std::mem::take(&mut self.points.places);
        assembly.plane = self.points.plane;
        assembly.warn_of_plane(file, 0);
        let meaning = self.meaning(&tags);
        self.take_segments(&mut assembly.mesh)?;
        self.take_groups(&meaning, &mut assembly.mesh);
        self.take_markers(&mut assembly.mesh)?;
        self.check_provenance()?;
        self.take_data(&mut assembly.mesh);
        let (mut mesh, warnings) = assembly.finish(file);
        if mesh.provenance.is_empty() {
            take_provenance(&mut mesh);
        }
        Ok((mesh, warnings))
    }

    fn take_segments(&self, mesh: &mut Mesh) -> Result<(), Wrong> {
        let Some((array, numbers)) = whole(&self.cell_data, SEGMENT) else { return Ok(()) };
        let segment = |cell: usize| {
            let number = numbers.at(cell);
            let segment = if number == -1 { Some(u32::MAX) } else { u32::try_from(number).ok() };
            let expected = "a segment's number or -1";
            segment.ok_or_else(|| wrong(Part::CellData(array), cell, expected, number))
        };
        mesh.edge_segments = self.cells.edges.iter().map(segment).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// Which tag the number of a group stands for, by dimension and number.
    fn meaning(&self, tags: &Tags) -> BTreeMap<(u8, i64), Tag> {
        let physical = whole(&self.cell_data, PHYSICAL).map(|(_, numbers)| numbers);
        let mut meaning = BTreeMap::new();
        let mut last = None;
        let mut add = |dim, cell: usize| {
            let tag = tags.of(cell);
            let number = physical.map_or(i64::from(tag), |numbers| numbers.at(cell));
            // (Most cells are of the group of the one before.)
            if last.replace((dim, number)) != Some((dim, number)) {
                meaning.entry((dim, number)).or_insert(tag);
            }
        };
        self.cells.points.iter().for_each(|&(_, cell)| add(0, cell));
        self.cells.edges.iter().for_each(|cell| add(1, cell));
        self.cells.triangles.iter().for_each(|cell| add(2, cell));
        meaning
    }

    /// The user's names: those of field arrays that hold pairs, less the stated ones.
    fn take_groups(&self, meaning: &BTreeMap<(u8, i64), Tag>, mesh: &mut Mesh) {
        for Column { name, numbers, .. } in &self.field {
            let Numbers::Whole(numbers) = numbers else { continue };
            if !numbers.len().is_multiple_of(2) {
                continue;
            }
            for pair in 0..numbers.len() / 2 {
                let pair = [numbers.at(2 * pair), numbers.at(2 * pair + 1)];
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
            let markers = Tags::new(numbers, Part::PointData(array))?;
            mesh.point_markers = (0..numbers.len()).map(|point| markers.of(point)).collect();
        }
        Ok(())
    }

    fn check_provenance(&self) -> Result<(), Wrong> {
        let Some((array, numbers)) = whole(&self.point_data, PROVENANCE) else { return Ok(()) };
        match numbers.iter().position(|number| !(-1..=3).contains(&number)) {
            None => Ok(()),
            Some(index) => {
                let expected = "0 (input), 1 (shell), 2 (midpoint) or 3 (circumcenter)";
                Err(wrong(Part::PointData(array), index, expected, numbers.at(index)))
            }
        }
    }

    /// The data that have no other meaning; provenance stays among those of points where some have
    /// none.
    fn take_data(&mut self, mesh: &mut Mesh) {
        let is_meant = |column: &Column, names: &[&str]| {
            names.contains(&column.name.as_str()) && column.wholes().is_some()
        };
        if let Some((array, numbers)) = whole(&self.point_data, PROVENANCE)
            && let Some(provenance) = kinds_of_points(numbers.iter())
        {
            mesh.provenance = provenance;
            self.point_data.remove(array);
        }
        let all = std::mem::take(&mut self.point_data).into_iter();
        let kept = all.filter(|column| !is_meant(column, &[MARKER]));
        mesh.point_data = kept.map(Column::into_data).collect();
        let all = std::mem::take(&mut self.cell_data).into_iter();
        let kept = all.filter(|column| !is_meant(column, &[PHYSICAL, TAG, SEGMENT]));
        mesh.triangle_data =
            kept.map(|column| column.into_data_of(&self.cells.triangles)).collect();
    }
}

/// The tag of each cell: the first array that has a meaning, 0 without one.
fn tags(cell_data: &[Column]) -> Result<Tags<'_>, Wrong> {
    let known = [TAG, PHYSICAL, "medit:ref", "CellEntityIds"];
    match known.into_iter().find_map(|name| whole(cell_data, name)) {
        Some((array, numbers)) => Tags::new(numbers, Part::CellData(array)),
        None => Ok(Tags(None)),
    }
}

/// The tags of cells or points; 0 where there are none.
struct Tags<'a>(Option<&'a Wholes>);

impl<'a> Tags<'a> {
    fn new(numbers: &'a Wholes, part: Part) -> Result<Self, Wrong> {
        match numbers.iter().position(|number| Tag::try_from(number).is_err()) {
            None => Ok(Self(Some(numbers))),
            Some(index) => Err(wrong(part, index, "a whole number of 32 bits", numbers.at(index))),
        }
    }

    fn of(&self, item: usize) -> Tag {
        self.0.map_or(0, |numbers| numbers.at(item) as Tag)
    }
}

/// An array of one whole number each, by its name: its index and its numbers.
fn whole<'a>(all: &'a [Column], name: &str) -> Option<(usize, &'a Wholes)> {
    let mut named = all.iter().enumerate().filter(|(_, column)| column.name == name);
    named.find_map(|(index, column)| Some((index, column.wholes()?)))
}

/// The kinds of points that numbers stand for, if all of them stand for one.
fn kinds_of_points(mut numbers: impl Iterator<Item = i64>) -> Option<Vec<Provenance>> {
    use Provenance::{Circumcenter, Input, Midpoint, Shell};
    let kinds = [Input, Shell, Midpoint, Circumcenter];
    let kind = |number: i64| kinds.get(usize::try_from(number).ok()?).copied();
    let mut all = Vec::with_capacity(numbers.size_hint().0);
    numbers.try_for_each(|number| {
        all.push(kind(number)?);
        Some(())
    })?;
    Some(all)
}

/// Takes provenance out of the data of points; nodes between corners, which have none, are gone.
fn take_provenance(mesh: &mut Mesh) {
    let numbers = |data: &Data| match &data.values {
        Values::Integer(numbers) if data.name == PROVENANCE && data.components == 1 => {
            Some(kinds_of_points(numbers.iter().copied()).unwrap_or_default())
        }
        _ => None,
    };
    let mut arrays = mesh.point_data.iter().map(numbers).enumerate();
    if let Some((array, Some(provenance))) = arrays.find(|(_, provenance)| provenance.is_some()) {
        mesh.provenance = provenance;
        mesh.point_data.remove(array);
    }
}
