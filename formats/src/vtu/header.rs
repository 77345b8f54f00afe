//! The XML of a `.vtu` file: which arrays there are, and where.

use std::collections::BTreeMap;
use std::ops::Range;

use quick_xml::events::{BytesStart, Event};

use super::Fault;

/// The description of an array.
pub(super) struct Description {
    pub section: Section,
    pub name: String,
    pub kind: String,
    pub components: u64,
    pub content: Content,
}

impl Description {
    /// Whether its numbers are real.
    pub fn is_real(&self) -> bool {
        self.kind.starts_with("Float")
    }
}

/// Where the numbers of an array stand, and how.
#[derive(Clone)]
pub(super) enum Content {
    /// As text between the tags: a range of the XML.
    Text(Range<usize>),
    /// In Base64 between the tags: a range of the XML.
    Base64(Range<usize>),
    /// From this byte of the appended data.
    Appended(u64),
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
    pub is_big_endian: bool,
    /// Whether lengths have 64 bits.
    pub is_wide: bool,
    pub is_compressed: bool,
    /// Whether the appended data are Base64.
    pub is_base64: bool,
    /// Whether the last tag began an array.
    is_open: bool,
    /// Arrays that hold no numbers.
    pub texts: Vec<String>,
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
            let end = reader.buffer_position() as usize;
            let before = xml.as_bytes().get(..end).unwrap_or_default();
            let fault = |message: String| Fault::Xml { line: line(before), message };
            match event.map_err(|error| fault(error.to_string()))? {
                Event::Start(tag) | Event::Empty(tag) => {
                    header.element(&tag, &mut section, end, fault)?;
                }
                Event::Text(_) => header.extend_content(end),
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
        end: usize,
        fault: impl Fn(String) -> Fault + Copy,
    ) -> Result<(), Fault> {
        let attributes = attributes(tag, fault)?;
        self.is_open = tag.name().as_ref() == "DataArray";
        let get = |name: &str| attributes.get(name).cloned();
        let number = |name: &str| match get(name) {
            None => Ok(None),
            Some(value) => match value.trim().parse::<u64>() {
                Ok(number) => Ok(Some(number)),
                Err(_) => Err(fault(format!("expected a number in {name}, found `{value}`"))),
            },
        };
        let one_of = |attribute, expected: &'static str, default: &str| {
            let found = get(attribute).unwrap_or_else(|| default.to_owned());
            match expected.split(" or ").position(|value| value == found) {
                Some(place) => Ok(place),
                None => Err(Fault::Unsupported { attribute, expected, found }),
            }
        };
        match tag.name().as_ref() {
            "VTKFile" => {
                one_of("type", "UnstructuredGrid", "")?;
                one_of("version", "0.1 or 1.0 or 2.0 or 2.1 or 2.2 or 2.3", "0.1")?;
                let orders = "LittleEndian or BigEndian";
                self.is_big_endian = one_of("byte_order", orders, "LittleEndian")? == 1;
                self.is_wide = one_of("header_type", "UInt32 or UInt64", "UInt32")? == 1;
                self.is_compressed = match get("compressor").unwrap_or_default() {
                    none if none.is_empty() => false,
                    _ => one_of("compressor", "vtkZLibDataCompressor", "")? == 0,
                };
            }
            "Piece" => {
                if self.points.is_some() {
                    return Err(fault("a second <Piece>; only one is read".to_owned()));
                }
                self.points = number("NumberOfPoints")?;
                self.cells = number("NumberOfCells")?;
            }
            "DataArray" => {
                let name = get("Name").unwrap_or_default();
                let missing = |what| Fault::Missing { what: format!("{what} of array `{name}`") };
                let kind = get("type").ok_or_else(|| missing("the type"))?;
                if kind == "String" {
                    self.texts.push(name);
                    self.is_open = false;
                    return Ok(());
                }
                let content = match one_of("format", "ascii or binary or appended", "ascii")? {
                    0 => Content::Text(end..end),
                    1 => Content::Base64(end..end),
                    _ => Content::Appended(number("offset")?.ok_or_else(|| missing("the offset"))?),
                };
                let components = number("NumberOfComponents")?.unwrap_or(1);
                let section = *section;
                self.arrays.push(Description { section, name, kind, components, content });
            }
            "Array" => self.texts.push(get("Name").unwrap_or_default()),
            "AppendedData" => self.is_base64 = one_of("encoding", "raw or base64", "")? == 1,
            name => {
                if let Some(entered) = section_of(name) {
                    *section = entered;
                }
            }
        }
        Ok(())
    }

    /// Text between tags: the numbers of the array whose tag ends where the text begins.
    fn extend_content(&mut self, end: usize) {
        if let Some(Description { content: Content::Text(range) | Content::Base64(range), .. }) =
            self.arrays.last_mut()
            && range.start == range.end
            && self.is_open
        {
            range.end = end;
        }
        self.is_open = false;
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
