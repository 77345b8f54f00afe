//! Reading `.vtu`: what [`write`](super::write) writes, and the like of other programs (raw
//! appended, little endian, 64-bit headers, not compressed; lines and triangles).

use std::collections::BTreeMap;
use std::ops::Range;

use super::header::{Description, Header, Section};
use super::{Fault, LINE, MARKER, PHYSICAL, PROVENANCE, ReadError, SEGMENT, TAG, TRIANGLE};
use crate::groups::stated_tag;
use crate::mesh::{Data, Mesh, Provenance, Values};
use crate::pslg::{Group, Tag};

/// Reads a `.vtu` file into the mesh that it was written from.
///
/// `file` is the name that messages use. Where there is no array `tag`, the numbers of
/// `gmsh:physical` are the tags. Names that were only stated ([`stated_tag`]) are left out.
///
/// # Errors
/// What is wrong with the file.
pub fn read(bytes: &[u8], file: &str) -> Result<Mesh, ReadError> {
    parse(bytes).map_err(|fault| ReadError { file: file.to_owned(), fault })
}

fn parse(bytes: &[u8]) -> Result<Mesh, Fault> {
    let (header, data) = split(bytes)?;
    let file = Header::read(header)?;
    let reader = Arrays { data, header: &file };
    let mut mesh = Mesh { points: points(&reader)?, ..Mesh::default() };
    let cells = cells(&reader, &mut mesh)?;
    point_data(&reader, &mut mesh)?;
    let physical = cell_data(&reader, &cells, &mut mesh)?;
    groups(&reader, &physical, &mut mesh)?;
    Ok(mesh)
}

/// The XML before the appended data, and the bytes after its `_`.
fn split(bytes: &[u8]) -> Result<(&[u8], &[u8]), Fault> {
    let missing = || Fault::Missing { what: "<AppendedData encoding=\"raw\">".to_owned() };
    if find(bytes, b"<VTKFile").is_none() {
        return Err(Fault::NotVtu);
    }
    let start = find(bytes, b"<AppendedData").ok_or_else(missing)?;
    let close = start + find(&bytes[start..], b">").ok_or_else(missing)?;
    let white = bytes[close + 1..].iter().take_while(|b| b.is_ascii_whitespace()).count();
    let data = close + 1 + white;
    if bytes.get(data) != Some(&b'_') {
        return Err(Fault::Missing { what: "the `_` before the appended data".to_owned() });
    }
    Ok((&bytes[..=close], &bytes[data + 1..]))
}

fn find(bytes: &[u8], part: &[u8]) -> Option<usize> {
    bytes.windows(part.len()).position(|window| window == part)
}

/// The numbers of arrays.
struct Arrays<'a> {
    header: &'a Header,
    data: &'a [u8],
}

impl<'a> Arrays<'a> {
    fn of(&self, section: Section) -> impl Iterator<Item = &'a Description> + use<'a> {
        self.header.arrays.iter().filter(move |array| array.section == section)
    }

    fn find(&self, section: Section, name: &str) -> Option<&'a Description> {
        self.of(section).find(|array| array.name == name)
    }

    fn need(&self, section: Section, name: &str) -> Result<&'a Description, Fault> {
        let missing = || Fault::Missing { what: format!("array `{name}`") };
        self.find(section, name).ok_or_else(missing)
    }

    /// The numbers of an array; `expected` of them, where that is known.
    fn values(&self, array: &Description, expected: Option<u64>) -> Result<Values, Fault> {
        let bytes = self.bytes(array)?;
        let values = match array.kind.as_str() {
            "Float64" => Values::Real(decode(bytes, f64::from_le_bytes)),
            "Float32" => Values::Real(decode(bytes, |b| f64::from(f32::from_le_bytes(b)))),
            "Int64" => Values::Integer(decode(bytes, i64::from_le_bytes)),
            "Int32" => Values::Integer(decode(bytes, |b| i64::from(i32::from_le_bytes(b)))),
            "UInt32" => Values::Integer(decode(bytes, |b| i64::from(u32::from_le_bytes(b)))),
            "Int16" => Values::Integer(decode(bytes, |b| i64::from(i16::from_le_bytes(b)))),
            "UInt16" => Values::Integer(decode(bytes, |b| i64::from(u16::from_le_bytes(b)))),
            "Int8" => Values::Integer(decode(bytes, |b| i64::from(i8::from_le_bytes(b)))),
            "UInt8" => Values::Integer(decode(bytes, |[b]: [u8; 1]| i64::from(b))),
            _ => {
                let (attribute, expected) = ("type", "Float64, Int64 or a smaller type");
                let found = array.kind.clone();
                return Err(Fault::Unsupported { attribute, expected, found });
            }
        };
        let found = match &values {
            Values::Real(values) => values.len() as u64,
            Values::Integer(values) => values.len() as u64,
        };
        match expected {
            Some(expected) if expected != found => {
                Err(Fault::Length { array: array.name.clone(), expected, found })
            }
            _ => Ok(values),
        }
    }

    /// The bytes of an array, after the eight that count them.
    fn bytes(&self, array: &Description) -> Result<&'a [u8], Fault> {
        let available = self.data.len() as u64;
        let truncated = |end| Fault::Truncated { array: array.name.clone(), end, available };
        let at = |start: u64, length: u64| {
            let end = start.saturating_add(length);
            if end > available {
                return Err(truncated(end));
            }
            Ok(&self.data[start as usize..end as usize])
        };
        let header = at(array.offset, 8)?;
        let length = header.try_into().map_or(u64::MAX, u64::from_le_bytes);
        at(array.offset + 8, length)
    }

    fn whole(&self, array: &Description, expected: Option<u64>) -> Result<Vec<i64>, Fault> {
        match self.values(array, expected)? {
            Values::Integer(values) => Ok(values),
            Values::Real(_) => Err(self.wrong_type(array, "a type of whole numbers")),
        }
    }

    fn wrong_type(&self, array: &Description, expected: &'static str) -> Fault {
        Fault::Unsupported { attribute: "type", expected, found: array.kind.clone() }
    }
}

fn decode<const N: usize, T>(bytes: &[u8], number: impl Fn([u8; N]) -> T) -> Vec<T> {
    bytes.chunks_exact(N).filter_map(|chunk| chunk.try_into().ok()).map(number).collect()
}

fn value(array: &str, index: usize, expected: &'static str, found: impl ToString) -> Fault {
    Fault::Value { array: array.to_owned(), index, expected, found: found.to_string() }
}

fn points(arrays: &Arrays) -> Result<Vec<[f64; 2]>, Fault> {
    let missing = |what: &str| Fault::Missing { what: what.to_owned() };
    let count = arrays.header.points.ok_or_else(|| missing("NumberOfPoints"))?;
    let array = arrays.of(Section::Points).next().ok_or_else(|| missing("the array of points"))?;
    let Values::Real(numbers) = arrays.values(array, Some(count.saturating_mul(3)))? else {
        return Err(arrays.wrong_type(array, "Float64"));
    };
    if count >= u64::from(u32::MAX) {
        return Err(Fault::Length {
            array: array.name.clone(),
            expected: MOST_POINTS,
            found: count,
        });
    }
    let infinite = numbers.iter().position(|number| !number.is_finite());
    if let Some(index) = infinite {
        return Err(value(&array.name, index, "a finite number", numbers[index]));
    }
    let plane = numbers.get(2).copied().unwrap_or(0.0);
    let off = numbers.chunks_exact(3).position(|point| point[2] != plane);
    if let Some(point) = off {
        let expected = "the same z for all points";
        return Err(value(&array.name, 3 * point + 2, expected, numbers[3 * point + 2]));
    }
    Ok(numbers.chunks_exact(3).map(|point| [point[0], point[1]]).collect())
}

/// Indices are 32-bit numbers, and the largest means "none".
const MOST_POINTS: u64 = u32::MAX as u64 - 1;

/// The cells that are edges and those that are triangles, in the order of the file.
struct Cells {
    edges: Vec<usize>,
    triangles: Vec<usize>,
    count: usize,
}

fn cells(arrays: &Arrays, mesh: &mut Mesh) -> Result<Cells, Fault> {
    let missing = || Fault::Missing { what: "NumberOfCells".to_owned() };
    let count = arrays.header.cells.ok_or_else(missing)?;
    let types = arrays.whole(arrays.need(Section::Cells, "types")?, Some(count))?;
    let offsets = arrays.whole(arrays.need(Section::Cells, "offsets")?, Some(count))?;
    let total = offsets.last().map_or(0, |&end| end.max(0) as u64);
    let corners = arrays.whole(arrays.need(Section::Cells, "connectivity")?, Some(total))?;
    let mut cells = Cells { edges: Vec::new(), triangles: Vec::new(), count: types.len() };
    let mut start = 0;
    for (cell, (&kind, &offset)) in types.iter().zip(&offsets).enumerate() {
        let length = match u8::try_from(kind) {
            Ok(LINE) => 2,
            Ok(TRIANGLE) => 3,
            _ => return Err(value("types", cell, "3 (line) or 5 (triangle)", kind)),
        };
        let end = start + length;
        if offset != end as i64 || end > corners.len() {
            return Err(value("offsets", cell, "the number of corners so far", offset));
        }
        if length == 2 {
            cells.edges.push(cell);
            mesh.edges.push(corners_of(&corners, start..end, mesh.points.len())?);
        } else {
            cells.triangles.push(cell);
            mesh.triangles.push(corners_of(&corners, start..end, mesh.points.len())?);
        }
        start = end;
    }
    Ok(cells)
}

fn corners_of<const N: usize>(
    corners: &[i64],
    range: Range<usize>,
    points: usize,
) -> Result<[u32; N], Fault> {
    let mut cell = [0; N];
    for (corner, index) in cell.iter_mut().zip(range) {
        *corner = match u32::try_from(corners[index]) {
            Ok(point) if (point as usize) < points => point,
            _ => return Err(value("connectivity", index, "a point", corners[index])),
        };
    }
    Ok(cell)
}

fn point_data(arrays: &Arrays, mesh: &mut Mesh) -> Result<(), Fault> {
    let count = mesh.points.len() as u64;
    for array in arrays.of(Section::Point) {
        match array.name.as_str() {
            PROVENANCE => {
                let numbers = arrays.whole(array, Some(count))?;
                let kinds = numbers.iter().enumerate().map(|(i, &number)| {
                    let expected = "0 (input), 1 (shell), 2 (midpoint) or 3 (circumcenter)";
                    provenance(number).ok_or_else(|| value(PROVENANCE, i, expected, number))
                });
                mesh.provenance = kinds.collect::<Result<_, _>>()?;
            }
            MARKER => mesh.point_markers = tags(&arrays.whole(array, Some(count))?, MARKER)?,
            _ => {
                let values = arrays.values(array, Some(count.saturating_mul(array.components)))?;
                mesh.point_data.push(data(array, values));
            }
        }
    }
    Ok(())
}

fn provenance(number: i64) -> Option<Provenance> {
    use Provenance::{Circumcenter, Input, Midpoint, Shell};
    [Input, Shell, Midpoint, Circumcenter].into_iter().find(|&kind| kind as i64 == number)
}

fn tags(numbers: &[i64], name: &str) -> Result<Vec<Tag>, Fault> {
    let tag = |(index, &number): (usize, &i64)| {
        let wrong = |_| value(name, index, "a whole number of 32 bits", number);
        Tag::try_from(number).map_err(wrong)
    };
    numbers.iter().enumerate().map(tag).collect()
}

fn data(array: &Description, values: Values) -> Data {
    Data { name: array.name.clone(), components: array.components as usize, values }
}

/// Tags, input segments and the data of triangles; answers which tag a group's number stands for,
/// by dimension and number.
fn cell_data(
    arrays: &Arrays,
    cells: &Cells,
    mesh: &mut Mesh,
) -> Result<BTreeMap<(u8, i64), Tag>, Fault> {
    let count = Some(cells.count as u64);
    let whole = |name| match arrays.find(Section::Cell, name) {
        Some(array) => arrays.whole(array, count).map(Some),
        None => Ok(None),
    };
    let physical = whole(PHYSICAL)?;
    let numbers = match whole(TAG)? {
        Some(tag) => tags(&tag, TAG)?,
        None => tags(physical.as_deref().unwrap_or(&vec![0; cells.count]), PHYSICAL)?,
    };
    mesh.edge_tags = cells.edges.iter().map(|&cell| numbers[cell]).collect();
    mesh.triangle_tags = cells.triangles.iter().map(|&cell| numbers[cell]).collect();
    if let Some(segments) = whole(SEGMENT)? {
        mesh.edge_segments = cells
            .edges
            .iter()
            .map(|&cell| {
                segment(segments[cell])
                    .ok_or_else(|| value(SEGMENT, cell, "a segment's number or -1", segments[cell]))
            })
            .collect::<Result<_, _>>()?;
    }
    for array in arrays.of(Section::Cell) {
        if ![PHYSICAL, TAG, SEGMENT].contains(&array.name.as_str()) {
            let total = Some((cells.count as u64).saturating_mul(array.components));
            let values = of_triangles(arrays.values(array, total)?, array, cells);
            mesh.triangle_data.push(data(array, values));
        }
    }
    let mut meaning = BTreeMap::new();
    for (dim, cells) in [(1, &cells.edges), (2, &cells.triangles)] {
        for &cell in cells {
            let number = physical.as_ref().map_or(i64::from(numbers[cell]), |all| all[cell]);
            meaning.entry((dim, number)).or_insert(numbers[cell]);
        }
    }
    Ok(meaning)
}

fn segment(number: i64) -> Option<u32> {
    if number == -1 { Some(u32::MAX) } else { u32::try_from(number).ok() }
}

fn of_triangles(values: Values, array: &Description, cells: &Cells) -> Values {
    fn pick<T: Copy>(values: &[T], components: usize, cells: &[usize]) -> Vec<T> {
        let tuple = |&cell: &usize| &values[cell * components..(cell + 1) * components];
        cells.iter().flat_map(tuple).copied().collect()
    }
    let components = array.components as usize;
    match values {
        Values::Real(values) => Values::Real(pick(&values, components, &cells.triangles)),
        Values::Integer(values) => Values::Integer(pick(&values, components, &cells.triangles)),
    }
}

/// The user's names: those of field arrays that hold pairs, less the stated ones.
fn groups(
    arrays: &Arrays,
    meaning: &BTreeMap<(u8, i64), Tag>,
    mesh: &mut Mesh,
) -> Result<(), Fault> {
    for array in arrays.of(Section::Field) {
        let Values::Integer(numbers) = arrays.values(array, None)? else { continue };
        let pairs = numbers.chunks_exact(2);
        if !pairs.remainder().is_empty() {
            continue;
        }
        for pair in pairs {
            let (Ok(number), Ok(dim @ (1 | 2))) = (Tag::try_from(pair[0]), u8::try_from(pair[1]))
            else {
                continue;
            };
            let tag = meaning.get(&(dim, pair[0])).copied().unwrap_or(number);
            if stated_tag(dim, &array.name) != Some(tag) {
                mesh.groups.push(Group { dim, tag, name: array.name.clone() });
            }
        }
    }
    mesh.groups.sort();
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file() -> Vec<u8> {
        let mesh = Mesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            point_markers: vec![1, 2, 3],
            provenance: vec![Provenance::Input; 3],
            triangles: vec![[0, 1, 2]],
            triangle_tags: vec![7],
            edges: vec![[0, 1]],
            edge_tags: vec![5],
            ..Mesh::default()
        };
        let mut bytes = Vec::new();
        crate::vtu::write(&mesh, &mut bytes).unwrap();
        bytes
    }

    /// The message for a file with one piece of its header changed.
    fn error(from: &str, to: &str) -> String {
        let bytes = file();
        let place = find(&bytes, from.as_bytes()).expect("this is in the header");
        let changed = [&bytes[..place], to.as_bytes(), &bytes[place + from.len()..]].concat();
        read(&changed, "a.vtu").expect_err("this is wrong").to_string()
    }

    #[test]
    fn other_kinds_of_vtu_are_refused_by_their_attribute() {
        let other = error("type=\"UnstructuredGrid\"", "type=\"PolyData\"");
        assert_eq!(other, "a.vtu: expected type=\"UnstructuredGrid\", found \"PolyData\"");
        let other = error(" header_type=\"UInt64\"", "");
        assert_eq!(other, "a.vtu: expected header_type=\"UInt64\", found \"UInt32\"");
        let other = error("encoding=\"raw\"", "encoding=\"base64\"");
        assert_eq!(other, "a.vtu: expected encoding=\"raw\", found \"base64\"");
        assert_eq!(
            error("<VTKFile", "<File"),
            "a.vtu: this is no .vtu file: it holds no <VTKFile>"
        );
    }

    #[test]
    fn wrong_counts_and_offsets_name_the_array() {
        let other = error("NumberOfPoints=\"3\"", "NumberOfPoints=\"4\"");
        assert_eq!(other, "a.vtu: array `Points` holds 9 numbers, expected 12");
        let other = error("NumberOfCells=\"2\"", "NumberOfCells=\"18446744073709551615\"");
        assert_eq!(other, "a.vtu: array `types` holds 2 numbers, expected 18446744073709551615");
        let other = error("NumberOfCells=\"2\"", "NumberOfCells=\"-2\"");
        assert_eq!(other, "a.vtu: line 9: expected a number in NumberOfCells, found `-2`");
        let many = "NumberOfComponents=\"18446744073709551615\"";
        let other = error("Name=\"marker\"", &format!("Name=\"depth\" {many}"));
        assert_eq!(other, "a.vtu: array `depth` holds 3 numbers, expected 18446744073709551615");
        let other = error("Name=\"connectivity\"", "Name=\"corners\"");
        assert_eq!(other, "a.vtu: array `connectivity` is missing");
        let other = error("offset=\"0\"", "offset=\"18446744073709551615\"");
        assert!(other.starts_with("a.vtu: array `meshwright` ends at byte 18446744073709551615"));
    }

    #[test]
    fn broken_xml_names_its_line() {
        let other = error("</Piece>", "</Peace>");
        assert!(other.starts_with("a.vtu: line 26: "), "{other}");
    }

    #[test]
    fn corners_out_of_range_name_their_place() {
        let mut bytes = file();
        let wrong = 3_i64.to_le_bytes();
        let tail = b"\n  </AppendedData>\n</VTKFile>\n".len();
        // Before the tail: two types and two offsets with their eight bytes each, one corner.
        let end = bytes.len() - tail - (8 + 2) - (8 + 16);
        bytes[end - 8..end].copy_from_slice(&wrong);
        let message = read(&bytes, "a.vtu").unwrap_err().to_string();
        let expected = "a.vtu: array `connectivity`, number 4 (from 0): expected a point, found 3";
        assert_eq!(message, expected);
    }
}
