//! A `.vtu` file that is read part by part: its XML, and behind it the appended data, which are
//! never in memory as a whole.

use std::io::{self, BufReader, Read, Seek, SeekFrom};

use super::Fault;

/// Bytes that are asked for at once.
pub(super) const BLOCK: usize = 1 << 16;

/// A file, of which the XML was read.
pub(super) struct Source<R> {
    /// The XML, as far as there are tags of arrays.
    pub xml: Vec<u8>,
    pub appended: Appended<R>,
}

/// The appended data.
pub(super) struct Appended<R> {
    reader: BufReader<R>,
    /// Where they begin, after their `_`.
    start: u64,
    /// How many bytes the file has from there on.
    pub length: u64,
    /// How many of them there are without the white space at the end.
    pub solid: u64,
}

impl<R: Read + Seek> Source<R> {
    /// Reads the XML.
    pub fn open(reader: R) -> Result<Self, Fault> {
        let missing = |what: &str| Fault::Missing { what: what.to_owned() };
        let mut reader = BufReader::with_capacity(BLOCK, reader);
        let mut xml = Vec::new();
        let tag = read_until(&mut reader, &mut xml, 0, b"<AppendedData")?;
        let close = match tag {
            Some(tag) => read_until(&mut reader, &mut xml, tag, b">")?,
            None => None,
        };
        let behind = close.map_or(xml.len(), |close| close + 1);
        let data = read_white(&mut reader, &mut xml, behind)?;
        if find(&xml, b"<VTKFile").is_none() {
            return Err(Fault::NotVtu);
        }
        let (length, solid) = ends(&mut reader)?;
        if !ends_with(&mut reader, solid, b"</VTKFile>")? {
            return Err(missing("the end of the file, </VTKFile>,"));
        }
        let start = match (tag, close, xml.get(data)) {
            (None, ..) => data,
            (_, None, _) => return Err(missing("<AppendedData>")),
            (_, Some(close), Some(b'_')) => {
                xml.truncate(close + 1);
                data + 1
            }
            _ => return Err(missing("the `_` before the appended data")),
        };
        let start = start as u64;
        let [length, solid] = [length, solid].map(|end| end.saturating_sub(start));
        Ok(Self { xml, appended: Appended { reader, start, length, solid } })
    }
}

impl<R: Read + Seek> Appended<R> {
    /// The bytes from an offset on.
    pub fn at(&mut self, offset: u64) -> Result<&mut BufReader<R>, Fault> {
        self.reader.seek(SeekFrom::Start(self.start.saturating_add(offset)))?;
        Ok(&mut self.reader)
    }
}

/// Reads on until some bytes stand behind a place, and answers where; or to the end of the file.
fn read_until(
    reader: &mut impl Read,
    bytes: &mut Vec<u8>,
    mut place: usize,
    part: &[u8],
) -> io::Result<Option<usize>> {
    loop {
        if let Some(found) = find(&bytes[place..], part) {
            return Ok(Some(place + found));
        }
        place = place.max((bytes.len() + 1).saturating_sub(part.len()));
        if read_more(reader, bytes)? == 0 {
            return Ok(None);
        }
    }
}

/// Reads on until something else than white space stands behind a place, and answers where; or to
/// the end of the file.
fn read_white(reader: &mut impl Read, bytes: &mut Vec<u8>, mut place: usize) -> io::Result<usize> {
    loop {
        place += bytes[place..].iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        if place < bytes.len() || read_more(reader, bytes)? == 0 {
            return Ok(place);
        }
    }
}

/// Appends a block of the file; answers how long it is.
fn read_more(reader: &mut impl Read, bytes: &mut Vec<u8>) -> io::Result<usize> {
    reader.take(BLOCK as u64).read_to_end(bytes)
}

/// Where a part first stands among bytes.
pub(super) fn find(bytes: &[u8], part: &[u8]) -> Option<usize> {
    let mut starts = bytes.iter().enumerate().filter(|(_, byte)| Some(*byte) == part.first());
    starts.find(|&(place, _)| bytes[place..].starts_with(part)).map(|(place, _)| place)
}

/// The length of the file, and its length without the white space at its end.
fn ends(reader: &mut (impl Read + Seek)) -> io::Result<(u64, u64)> {
    let length = reader.seek(SeekFrom::End(0))?;
    let (mut end, mut block) = (length, Vec::new());
    while end > 0 {
        let start = end.saturating_sub(BLOCK as u64);
        read_range(reader, start, end, &mut block)?;
        let solid = block.trim_ascii_end().len() as u64;
        if solid > 0 {
            return Ok((length, start + solid));
        }
        end = start;
    }
    Ok((length, 0))
}

fn ends_with(reader: &mut (impl Read + Seek), end: u64, part: &[u8]) -> io::Result<bool> {
    let mut bytes = Vec::new();
    read_range(reader, end.saturating_sub(part.len() as u64), end, &mut bytes)?;
    Ok(bytes == part)
}

fn read_range(
    reader: &mut (impl Read + Seek),
    start: u64,
    end: u64,
    bytes: &mut Vec<u8>,
) -> io::Result<()> {
    bytes.clear();
    reader.seek(SeekFrom::Start(start))?;
    reader.take(end - start).read_to_end(bytes)?;
    Ok(())
}
