//! VTK's XML files: descriptions of arrays, and arrays in one of three encodings, compressed or
//! not. What is in them, [`vtu`](crate::vtu) and [`vtp`](crate::vtp) know.

mod bytes;

use std::io::{self, Write};

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;
use quick_xml::escape::escape;

use crate::arrays::{Array, Block, Kind};
use crate::rows::Rows;
use bytes::{compressed, raw};

/// What may be asked of a VTK file, [`vtu`](crate::vtu) or [`vtp`](crate::vtp).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// How arrays are written.
    pub encoding: Encoding,
    /// Compress arrays with zlib, but those written as text: smaller and slower, and fewer
    /// programs read it.
    pub compress: bool,
    /// How many nodes a cell has.
    pub order: crate::Order,
}

/// How the arrays of a file are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Encoding {
    /// As bytes after the XML: the smallest and fastest, and no XML file by the letter.
    #[default]
    Raw,
    /// As Base64 within the XML: a third larger.
    Base64,
    /// As text within the XML, to be read by eye: two to three times as large. Numbers read back
    /// the same.
    Ascii,
}

/// A file: one piece with its arrays.
pub(crate) struct Document<'a> {
    /// VTK's name of the kind of data.
    pub kind: &'static str,
    /// What is counted in the piece, with the counts.
    pub counts: Vec<(&'static str, usize)>,
    /// The arrays that stand before the piece.
    pub field: Vec<Array<'a>>,
    /// The sections of the piece, with their arrays.
    pub sections: Vec<(&'static str, Vec<Array<'a>>)>,
}

impl Document<'_> {
    pub fn write(&self, options: Options, out: &mut impl Write) -> io::Result<()> {
        let compress = options.compress && options.encoding != Encoding::Ascii;
        let raw = options.encoding == Encoding::Raw;
        // The offsets of compressed arrays are known when they are compressed.
        let packed = if compress && raw { self.compressed()? } else { Vec::new() };
        let mut file = File { rows: Rows::new(out), options, packed: &packed, index: 0, offset: 0 };
        self.header(compress, &mut file)?;
        if raw {
            // White space before the `_`: VTK's parser needs it there.
            file.rows.text("  <AppendedData encoding=\"raw\">\n   _")?;
            self.append(compress, &packed, &mut file.rows)?;
            file.rows.text("\n  </AppendedData>\n")?;
        }
        file.rows.text("</VTKFile>\n")?;
        file.rows.finish()
    }

    /// All arrays, in the order of their bytes.
    fn arrays(&self) -> impl Iterator<Item = &Array<'_>> {
        self.field.iter().chain(self.sections.iter().flat_map(|(_, arrays)| arrays))
    }

    fn compressed(&self) -> io::Result<Vec<[Vec<u8>; 2]>> {
        self.arrays().map(compressed).collect()
    }

    fn header(&self, compress: bool, file: &mut File<impl Write>) -> io::Result<()> {
        let kind = self.kind;
        let compressor = if compress { " compressor=\"vtkZLibDataCompressor\"" } else { "" };
        file.rows.text(&format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" \
             byte_order=\"LittleEndian\" header_type=\"UInt64\"{compressor}>\n  <{kind}>\n"
        ))?;
        file.section("FieldData", &self.field)?;
        let count = |(name, count): &(_, _)| format!(" {name}=\"{count}\"");
        let counts: String = self.counts.iter().map(count).collect();
        file.rows.text(&format!("    <Piece{counts}>\n"))?;
        for (name, arrays) in &self.sections {
            file.section(name, arrays)?;
        }
        file.rows.text(&format!("    </Piece>\n  </{kind}>\n"))
    }

    fn append(
        &self,
        compress: bool,
        packed: &[[Vec<u8>; 2]],
        rows: &mut Rows<impl Write>,
    ) -> io::Result<()> {
        if compress {
            for part in packed.iter().flatten() {
                rows.bytes(part);
                rows.hand_on()?;
            }
            return Ok(());
        }
        for array in self.arrays() {
            raw(array, |bytes| {
                rows.bytes(bytes);
                rows.hand_on()
            })?;
        }
        Ok(())
    }
}

struct File<'p, 'a, W> {
    rows: Rows<'a, W>,
    options: Options,
    packed: &'p [[Vec<u8>; 2]],
    /// The next array of `packed`.
    index: usize,
    /// Where the next array's bytes are, after the `_`.
    offset: u64,
}

impl<W: Write> File<'_, '_, W> {
    fn section(&mut self, name: &str, arrays: &[Array]) -> io::Result<()> {
        self.rows.text(&format!("      <{name}>\n"))?;
        for array in arrays {
            self.array(array, name == "FieldData")?;
        }
        self.rows.text(&format!("      </{name}>\n"))
    }

    fn array(&mut self, array: &Array, field: bool) -> io::Result<()> {
        let (kind, name) = (kind_name(array.kind), escape(&array.name));
        let shape = match (field, array.components) {
            (true, _) => format!(" NumberOfTuples=\"{}\"", array.length),
            (false, 1) => String::new(),
            (false, components) => format!(" NumberOfComponents=\"{components}\""),
        };
        let start = format!("        <DataArray type=\"{kind}\" Name=\"{name}\"{shape} ");
        self.rows.text(&start)?;
        match self.options.encoding {
            Encoding::Raw => {
                self.rows.text(&format!("format=\"appended\" offset=\"{}\"/>\n", self.offset))?;
                self.offset += match self.packed.get(self.index) {
                    Some(parts) => parts.iter().map(|part| part.len() as u64).sum(),
                    None => bytes::HEADER + bytes::length(array),
                };
                self.index += 1;
                Ok(())
            }
            Encoding::Base64 => {
                self.rows.text("format=\"binary\">\n")?;
                self.base64(array)?;
                self.rows.text("\n        </DataArray>\n")
            }
            Encoding::Ascii => {
                self.rows.text("format=\"ascii\">\n")?;
                self.ascii(array)?;
                self.rows.text("        </DataArray>\n")
            }
        }
    }

    fn base64(&mut self, array: &Array) -> io::Result<()> {
        if !self.options.compress {
            let mut text = EncoderWriter::new(&mut self.rows, &STANDARD);
            raw(array, |bytes| text.write_all(bytes))?;
            text.finish()?;
            return Ok(());
        }
        for part in compressed(array)? {
            let mut text = EncoderWriter::new(&mut self.rows, &STANDARD);
            text.write_all(&part)?;
            text.finish()?;
        }
        Ok(())
    }

    /// Some numbers a line, a tuple never split.
    fn ascii(&mut self, array: &Array) -> io::Result<()> {
        let per_line = array.components * (12 / array.components).max(1);
        let mut written = 0;
        let mut number = |rows: &mut Rows<W>, push: &dyn Fn(&mut Rows<W>)| {
            push(rows);
            written += 1;
            if written % per_line == 0 || written == array.length { rows.end() } else { Ok(()) }
        };
        array.blocks(|block| match block {
            Block::Real(values) => values.iter().try_for_each(|&value| {
                number(&mut self.rows, &|rows: &mut Rows<W>| rows.real(value))
            }),
            Block::Whole(values) => values.iter().try_for_each(|&value| {
                number(&mut self.rows, &|rows: &mut Rows<W>| rows.integer(value))
            }),
        })
    }
}

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Float64 => "Float64",
        Kind::Int64 => "Int64",
        Kind::Int32 => "Int32",
        Kind::UInt8 => "UInt8",
    }
}
