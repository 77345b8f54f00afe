//! Reading `.vtu`: grids of lines and triangles by any program, in every encoding but those of
//! other compressors than zlib.

#[cfg(test)]
mod tests;

use std::io::{Cursor, Read, Seek};

use super::coded::Arrays;
use super::header::{Description, Header, Section};
use super::source::Source;
use super::{Fault, ReadError};
use crate::arrays::Block;
use crate::error::{Notice, Warning};
use crate::grid::{Column, Grid, Numbers, Part, Points, Wrong};
use crate::mesh::Mesh;
use crate::wholes::Wholes;

/// Reads a `.vtu` file into the mesh in it.
///
/// `file` is the name that messages use. Where there is no array `tag`, the numbers of
/// `gmsh:physical` are the tags; without that, those of `medit:ref` or `CellEntityIds`. Names that
/// were only stated ([`stated_tag`](crate::groups::stated_tag)) are left out. All points lie in one
/// plane z = constant. Of curved lines and triangles the corners are taken, with a warning.
///
/// # Errors
/// What is wrong with the file.
pub fn read(bytes: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), ReadError> {
    read_from(Cursor::new(bytes), file)
}

/// Reads as [`read`] does, from a file in which it goes back and forth: appended arrays are read
/// block by block, so that they need no memory beside the mesh.
///
/// # Errors
/// What is wrong with the file, or [`Fault::Io`].
pub fn read_from(source: impl Read + Seek, file: &str) -> Result<(Mesh, Vec<Warning>), ReadError> {
    parse(source, file).map_err(|fault| ReadError { file: file.to_owned(), fault })
}

fn parse(source: impl Read + Seek, file: &str) -> Result<(Mesh, Vec<Warning>), Fault> {
    let mut source = Source::open(source)?;
    let header = Header::read(&source.xml)?;
    let mut grid = grid(&mut Arrays::new(&header, &mut source))?;
    drop(source);
    let (mesh, mut warnings) = grid.take_mesh(file).map_err(|wrong| fault(&header, wrong))?;
    if !header.texts.is_empty() {
        let statements = header.texts.iter().map(|name| (format!("array `{name}` of texts"), 1));
        let notice = Notice::SkippedStatements { statements: statements.collect() };
        warnings.push(Warning { file: file.to_owned(), line: 0, notice });
    }
    Ok((mesh, warnings))
}

fn grid(arrays: &mut Arrays<impl Read + Seek>) -> Result<Grid, Fault> {
    let header = arrays.header;
    let mut grid = Grid { points: points(arrays)?, ..Grid::default() };
    let count = header.cells.ok_or_else(|| Fault::Missing { what: "NumberOfCells".to_owned() })?;
    grid.cells.kinds = whole(arrays, need(header, Section::Cells, "types")?, Some(count))?;
    grid.cells.ends = whole(arrays, need(header, Section::Cells, "offsets")?, Some(count))?;
    nodes(arrays, need(header, Section::Cells, "connectivity")?, &mut grid)?;
    grid.point_data = all(arrays, Section::Point, Some(grid.points.len() as u64))?;
    grid.cell_data = all(arrays, Section::Cell, Some(count))?;
    grid.field = all(arrays, Section::Field, None)?;
    Ok(grid)
}

/// Indices are 32-bit numbers, and the largest means "none".
const MOST_POINTS: u64 = u32::MAX as u64 - 1;

fn points(arrays: &mut Arrays<impl Read + Seek>) -> Result<Points, Fault> {
    let missing = |what: &str| Fault::Missing { what: what.to_owned() };
    let count = arrays.header.points.ok_or_else(|| missing("NumberOfPoints"))?;
    let array = of(arrays.header, Section::Points).next();
    let array = array.ok_or_else(|| missing("the array of points"))?;
    let coordinates = count.saturating_mul(3);
    let mut points = Points::with_capacity(arrays.room(array, coordinates) / 3);
    arrays.each(array, Some(coordinates), &mut |block| {
        if let Block::Real(coordinates) = block {
            points.extend(coordinates);
        }
    })?;
    if !array.is_real() {
        return Err(wrong_type(array, "Float64"));
    }
    if count > MOST_POINTS {
        let array = array.name.clone();
        return Err(Fault::Length { array, expected: MOST_POINTS, found: count });
    }
    Ok(points)
}

/// Reads the nodes of the cells, of which kinds and ends are known.
fn nodes(
    arrays: &mut Arrays<impl Read + Seek>,
    array: &Description,
    grid: &mut Grid,
) -> Result<(), Fault> {
    let count = grid.cells.ends.last().map_or(0, |end| end.max(0) as u64);
    grid.cells.begin(grid.points.len(), usize::try_from(count).unwrap_or(usize::MAX));
    arrays.each(array, Some(count), &mut |block| {
        if let Block::Whole(nodes) = block {
            grid.cells.take(nodes);
        }
    })?;
    if array.is_real() { Err(wrong_type(array, WHOLE)) } else { Ok(()) }
}

/// The arrays of a section, with so many tuples of numbers each.
fn all(
    arrays: &mut Arrays<impl Read + Seek>,
    section: Section,
    count: Option<u64>,
) -> Result<Vec<Column>, Fault> {
    let header = arrays.header;
    let column = |array: &Description| {
        let expected = count.map(|count| count.saturating_mul(array.components));
        let numbers = arrays.numbers(array, expected)?;
        let components = array.components as usize;
        Ok(Column { name: array.name.clone(), components, numbers })
    };
    of(header, section).map(column).collect()
}

fn of(header: &Header, section: Section) -> impl Iterator<Item = &Description> {
    header.arrays.iter().filter(move |array| array.section == section)
}

fn need<'a>(header: &'a Header, section: Section, name: &str) -> Result<&'a Description, Fault> {
    let missing = || Fault::Missing { what: format!("array `{name}`") };
    of(header, section).find(|array| array.name == name).ok_or_else(missing)
}

fn whole(
    arrays: &mut Arrays<impl Read + Seek>,
    array: &Description,
    expected: Option<u64>,
) -> Result<Wholes, Fault> {
    match arrays.numbers(array, expected)? {
        Numbers::Whole(numbers) => Ok(numbers),
        Numbers::Real(_) => Err(wrong_type(array, WHOLE)),
    }
}

const WHOLE: &str = "a type of whole numbers";

fn wrong_type(array: &Description, expected: &'static str) -> Fault {
    Fault::Unsupported { attribute: "type", expected, found: array.kind.clone() }
}

/// The fault that a number of the grid is.
fn fault(header: &Header, Wrong { part, index, expected, found }: Wrong) -> Fault {
    let in_section = |section, nth: usize| {
        of(header, section).nth(nth).map_or_else(String::new, |array| array.name.clone())
    };
    let array = match part {
        Part::Points => in_section(Section::Points, 0),
        Part::Kinds => "types".to_owned(),
        Part::Ends => "offsets".to_owned(),
        Part::Nodes => "connectivity".to_owned(),
        Part::PointData(nth) => in_section(Section::Point, nth),
        Part::CellData(nth) => in_section(Section::Cell, nth),
    };
    Fault::Value { array, index, expected, found }
}
