//! The XML of a `.vtu` file: which arrays there are, and where.

use std::collections::BTreeMap;

use quick_xml::events::{BytesStart, Event};

use super::Fault;

/// The description of an array.
pub(super) struct Description {
    pub section: Section,
    pub name: String,
    pub kind: String,
    pub components: u64,
    pub offset: u64,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Section {
    None,
    Field,
    Point,
    Cell,
    Points,
    Cells,
}

#[derive(Default)]
pub(super) struct Header {
    pub arrays: Vec<Description>,
    pub points: Option<u64>,
    pub cells: Option<u64>,
}

impl Header {
    pub fn read(xml: &[u8]) -> Result<Self, Fault> {
        let xml = std::str::from_utf8(xml).map_err(|error| Fault::Xml {
            line: line(&xml[..error.valid_up_to()]),
            message: "the header is not UTF-8".to_owned(),
        })?;
        let mut reader = quick_xml::Reader::from_str(xml);
        let mut header = Self::default();
        let mut section = Section::None;
        loop {
            let event = reader.read_event();
            let line =
                line(xml.as_bytes().get(..reader.buffer_position() as usize).unwrap_or_default());
            let fault = |message: String| Fault::Xml { line, message };
            match event.map_err(|error| fault(error.to_string()))? {
                Event::Start(tag) | Event::Empty(tag) => {
                    header.element(&tag, &mut section, fault)?;
                }
                Event::End(tag) if section_of(tag.name().as_ref()).is_some() => {
                    section = Section::None;
                }
                Event::Eof => return Ok(header),
                _ => {}
            }
        }
    }

    fn element(
        &mut self,
        tag: &BytesStart,
        section: &mut Section,
        fault: impl Fn(String) -> Fault + Copy,
    ) -> Result<(), Fault> {
        let attributes = attributes(tag, fault)?;
        let get = |name: &str| attributes.get(name).cloned();
        let number = |name: &str| match get(name) {
            None => Ok(None),
            Some(value) => match value.trim().parse::<u64>() {
                Ok(number) => Ok(Some(number)),
                Err(_) => Err(fault(format!("expected a number in {name}, found `{value}`"))),
            },
        };
        let must = |attribute, expected, default: &str| {
            let found = get(attribute).unwrap_or_else(|| default.to_owned());
            let same = found == expected;
            if same { Ok(()) } else { Err(Fault::Unsupported { attribute, expected, found }) }
        };
        match tag.name().as_ref() {
            "VTKFile" => {
                must("type", "UnstructuredGrid", "")?;
                must("byte_order", "LittleEndian", "LittleEndian")?;
                must("header_type", "UInt64", "UInt32")?;
                must("compressor", "", "")?;
            }
            "Piece" => {
                if self.points.is_some() {
                    return Err(fault("a second <Piece>; only one is read".to_owned()));
                }
                self.points = number("NumberOfPoints")?;
                self.cells = number("NumberOfCells")?;
            }
            "DataArray" => {
                must("format", "appended", "ascii")?;
                let name = get("Name").unwrap_or_default();
                let missing = |what| Fault::Missing { what: format!("{what} of array `{name}`") };
                let offset = number("offset")?.ok_or_else(|| missing("the offset"))?;
                let kind = get("type").ok_or_else(|| missing("the type"))?;
                let components = number("NumberOfComponents")?.unwrap_or(1);
                let section = *section;
                self.arrays.push(Description { section, name, kind, components, offset });
            }
            "AppendedData" => must("encoding", "raw", "")?,
            name => {
                if let Some(entered) = section_of(name) {
                    *section = entered;
                }
            }
        }
        Ok(())
    }
}

/// The line that begins or goes on after these bytes.
fn line(before: &[u8]) -> usize {
    1 + before.iter().filter(|&&byte| byte == b'\n').count()
}

fn section_of(name: &str) -> Option<Section> {
    Some(match name {
        "FieldData" => Section::Field,
        "PointData" => Section::Point,
        "CellData" => Section::Cell,
        "Points" => Section::Points,
        "Cells" => Section::Cells,
        _ => return None,
    })
}

fn attributes(
    tag: &BytesStart,
    fault: impl Fn(String) -> Fault,
) -> Result<BTreeMap<String, String>, Fault> {
    let mut all = BTreeMap::new();
    for attribute in tag.attributes() {
        let attribute = attribute.map_err(|error| fault(error.to_string()))?;
        let value = quick_xml::escape::unescape(&attribute.value);
        let value = value.map_err(|error| fault(error.to_string()))?;
        all.insert(attribute.key.as_ref().to_owned(), value.into_owned());
    }
    Ok(all)
}
