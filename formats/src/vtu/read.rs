//! Reading `.vtu`: grids of lines and triangles by any program, in every encoding but those of
//! other compressors than zlib.

#[cfg(test)]
mod tests;

use super::coded::Arrays;
use super::header::{Description, Header, Section};
use super::{Fault, ReadError};
use crate::error::{Notice, Warning};
use crate::grid::{Grid, Part, Wrong};
use crate::mesh::{Data, Mesh, Values};

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
    parse(bytes, file).map_err(|fault| ReadError { file: file.to_owned(), fault })
}

fn parse(bytes: &[u8], file: &str) -> Result<(Mesh, Vec<Warning>), Fault> {
    let (xml, data) = split(bytes)?;
    let header = Header::read(xml)?;
    let arrays = Arrays { header: &header, xml, data };
    let mut grid = grid(&arrays)?;
    let (mesh, mut warnings) = grid.take_mesh(file).map_err(|wrong| fault(&header, wrong))?;
    if !header.texts.is_empty() {
        let statements = header.texts.iter().map(|name| (format!("array `{name}` of texts"), 1));
        let notice = Notice::SkippedStatements { statements: statements.collect() };
        warnings.push(Warning { file: file.to_owned(), line: 0, notice });
    }
    Ok((mesh, warnings))
}

/// The XML, as far as there are tags of arrays, and the appended data after their `_`.
fn split(bytes: &[u8]) -> Result<(&[u8], &[u8]), Fault> {
    let missing = |what: &str| Fault::Missing { what: what.to_owned() };
    if find(bytes, b"<VTKFile").is_none() {
        return Err(Fault::NotVtu);
    }
    if !bytes.trim_ascii_end().ends_with(b"</VTKFile>") {
        return Err(missing("the end of the file, </VTKFile>,"));
    }
    let Some(start) = find(bytes, b"<AppendedData") else { return Ok((bytes, b"")) };
    let close = start + find(&bytes[start..], b">").ok_or_else(|| missing("<AppendedData>"))?;
    let white = bytes[close + 1..].iter().take_while(|b| b.is_ascii_whitespace()).count();
    let data = close + 1 + white;
    if bytes.get(data) != Some(&b'_') {
        return Err(missing("the `_` before the appended data"));
    }
    Ok((&bytes[..=close], &bytes[data + 1..]))
}

fn find(bytes: &[u8], part: &[u8]) -> Option<usize> {
    bytes.windows(part.len()).position(|window| window == part)
}

fn grid(arrays: &Arrays) -> Result<Grid, Fault> {
    let mut grid = Grid { points: points(arrays)?, ..Grid::default() };
    let count =
        arrays.header.cells.ok_or_else(|| Fault::Missing { what: "NumberOfCells".to_owned() })?;
    grid.kinds = whole(arrays, need(arrays, Section::Cells, "types")?, Some(count))?;
    grid.ends = whole(arrays, need(arrays, Section::Cells, "offsets")?, Some(count))?;
    let total = grid.ends.last().map_or(0, |&end| end.max(0) as u64);
    grid.nodes = whole(arrays, need(arrays, Section::Cells, "connectivity")?, Some(total))?;
    grid.point_data = all(arrays, Section::Point, Some(grid.points.len() as u64 / 3))?;
    grid.cell_data = all(arrays, Section::Cell, Some(count))?;
    grid.field = all(arrays, Section::Field, None)?;
    Ok(grid)
}

/// Indices are 32-bit numbers, and the largest means "none".
const MOST_POINTS: u64 = u32::MAX as u64 - 1;

fn points(arrays: &Arrays) -> Result<Vec<f64>, Fault> {
    let missing = |what: &str| Fault::Missing { what: what.to_owned() };
    let count = arrays.header.points.ok_or_else(|| missing("NumberOfPoints"))?;
    let array = of(arrays, Section::Points).next();
    let array = array.ok_or_else(|| missing("the array of points"))?;
    let Values::Real(numbers) = arrays.values(array, Some(count.saturating_mul(3)))? else {
        return Err(wrong_type(array, "Float64"));
    };
    if count > MOST_POINTS {
        let array = array.name.clone();
        return Err(Fault::Length { array, expected: MOST_POINTS, found: count });
    }
    Ok(numbers)
}

/// The arrays of a section, with so many tuples of numbers each.
fn all(arrays: &Arrays, section: Section, count: Option<u64>) -> Result<Vec<Data>, Fault> {
    let data = |array: &Description| {
        let expected = count.map(|count| count.saturating_mul(array.components));
        let values = arrays.values(array, expected)?;
        let components = array.components as usize;
        Ok(Data { name: array.name.clone(), components, values })
    };
    of(arrays, section).map(data).collect()
}

fn of<'a>(arrays: &Arrays<'a>, section: Section) -> impl Iterator<Item = &'a Description> {
    arrays.header.arrays.iter().filter(move |array| array.section == section)
}

fn need<'a>(arrays: &Arrays<'a>, section: Section, name: &str) -> Result<&'a Description, Fault> {
    let missing = || Fault::Missing { what: format!("array `{name}`") };
    of(arrays, section).find(|array| array.name == name).ok_or_else(missing)
}

fn whole(arrays: &Arrays, array: &Description, expected: Option<u64>) -> Result<Vec<i64>, Fault> {
    match arrays.values(array, expected)? {
        Values::Integer(values) => Ok(values),
        Values::Real(_) => Err(wrong_type(array, "a type of whole numbers")),
    }
}

fn wrong_type(array: &Description, expected: &'static str) -> Fault {
    Fault::Unsupported { attribute: "type", expected, found: array.kind.clone() }
}

/// The fault that a number of the grid is.
fn fault(header: &Header, Wrong { part, index, expected, found }: Wrong) -> Fault {
    let in_section = |section, nth: usize| {
        let mut arrays = header.arrays.iter().filter(|array| array.section == section);
        arrays.nth(nth).map_or_else(String::new, |array| array.name.clone())
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
