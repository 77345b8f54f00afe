//! Outlines and meshes from files, compressed files and stdin.

use std::fs::{self, File};
use std::io::{self, Cursor, Read, Seek};
use std::mem;
use std::ops::Deref;
use std::path::{Path, PathBuf};

use flate2::read::MultiGzDecoder;
use meshwright::formats::{
    Mesh, Pslg, Warning, area, ele, geo, inp, medit, msh, node, obj, poly, su2, vtk, vtu,
};
use meshwright::memory::give_back;

use super::failure::{Exit, Failure, reason};
use super::format::{Format, listed};
use super::options::ReadOptions;
use super::refined;
use super::voice::Voice;

/// What a file holds, and every file that was read for it.
pub struct Input {
    /// The outline or the mesh.
    pub content: Content,
    /// Its format.
    pub format: Format,
    /// The name that messages use.
    pub name: String,
    /// The files that must not be overwritten.
    pub files: Vec<PathBuf>,
}

impl Input {
    /// What the file holds, which is nothing from now on.
    pub fn take(&mut self) -> Content {
        std::mem::replace(&mut self.content, Content::Mesh(Mesh::default()))
    }
}

/// What a file holds.
pub enum Content {
    /// An outline.
    Outline(Pslg),
    /// A mesh.
    Mesh(Mesh),
}

/// Reads an outline.
pub fn outline(
    path: &Path,
    from: Option<Format>,
    options: ReadOptions,
    voice: &Voice,
) -> Result<(Pslg, Input), Failure> {
    let mut input = any(path, from, options, voice)?;
    match input.take() {
        Content::Outline(pslg) => Ok((pslg, input)),
        Content::Mesh(_) => Err(Failure::usage(format!(
            "{} holds a mesh, where an outline is wanted ({})",
            input.name,
            listed(Format::holds_outlines)
        ))
        .with_help("--refine takes a mesh as the outline that it is")),
    }
}

/// Reads an outline or a mesh, whichever the file's format holds.
pub fn any(
    path: &Path,
    from: Option<Format>,
    options: ReadOptions,
    voice: &Voice,
) -> Result<Input, Failure> {
    let format = format_of(path, from)?;
    let stdin = path == Path::new("-");
    let name = path.display().to_string();
    let mut files = if stdin { Vec::new() } else { vec![path.to_path_buf()] };
    let bytes = || if stdin { read_stdin() } else { read_file(path) };
    let mut companion = |beside: &str| {
        if stdin {
            return Err(io::Error::other("stdin has no file beside it"));
        }
        files.push(PathBuf::from(beside));
        uncompressed(fs::read(beside)?)
    };
    let told = |warnings: Vec<Warning>| warnings.iter().for_each(|warning| voice.warn(warning));
    let outline = |(mut pslg, warnings)| {
        told(warnings);
        options.apply(&mut pslg, voice);
        Content::Outline(pslg)
    };
    let mesh = |(mesh, warnings)| {
        told(warnings);
        Content::Mesh(mesh)
    };
    let content = match format {
        Format::Poly => {
            outline(poly::read(&bytes()?, &name, &mut companion).map_err(Failure::input)?)
        }
        Format::Node => outline(node::read(&bytes()?, &name).map_err(Failure::input)?),
        Format::Obj => {
            let faces = obj::Options { faces: options.faces };
            outline(obj::read_with(&bytes()?, &name, faces).map_err(Failure::input)?)
        }
        Format::Geo => {
            outline(geo::read(&bytes()?, &name, &mut companion).map_err(Failure::input)?)
        }
        Format::Msh => mesh(msh::read(&bytes()?, &name).map_err(Failure::input)?),
        Format::Ele => mesh(
            ele::read_with_companions(&bytes()?, &name, &mut companion).map_err(Failure::input)?,
        ),
        Format::Area => {
            let areas = area::read(&bytes()?, &name).map_err(Failure::input)?;
            outline(refined::beside_areas(areas, &name, &mut companion)?)
        }
        Format::Vtu => mesh(read_vtu(path, &name, bytes)?),
        Format::Vtk => mesh(vtk::read(&bytes()?, &name).map_err(Failure::input)?),
        Format::Medit => mesh(medit::read(&bytes()?, &name).map_err(Failure::input)?),
        Format::Su2 => mesh(su2::read(&bytes()?, &name).map_err(Failure::input)?),
        Format::Inp => mesh(inp::read(&bytes()?, &name).map_err(Failure::input)?),
        _ => {
            unreachable!("`format_of` refuses formats that are not read")
        }
    };
    let content = match content {
        Content::Mesh(mesh) if options.refine => {
            let (areas, warnings) = match format {
                Format::Ele => refined::areas_beside(&name, &mut companion)?,
                _ => Default::default(),
            };
            outline((refined::outline(&mesh, &areas, &name)?, warnings))
        }
        content => content,
    };
    Ok(Input { content, format, name, files })
}

/// Reads a `.vtu` file: not as a whole, where it is one that can be read back and forth.
fn read_vtu(
    path: &Path,
    name: &str,
    bytes: impl FnOnce() -> Result<Bytes, Failure>,
) -> Result<(Mesh, Vec<Warning>), Failure> {
    let read = match plain_file(path).map_err(|error| Failure::io(path, &error))? {
        Some(file) => vtu::read_from(file, name),
        None => vtu::read_from(Cursor::new(&*bytes()?), name),
    };
    read.map_err(|error| match error.fault {
        vtu::Fault::Io { .. } => Failure { exit: Exit::Io, message: error.to_string() },
        _ => Failure::input(error),
    })
}

/// A file that is neither stdin nor compressed, nor anything but a file.
fn plain_file(path: &Path) -> io::Result<Option<File>> {
    // (What comes through a pipe must not be opened twice.)
    if path == Path::new("-") || !fs::metadata(path)?.is_file() {
        return Ok(None);
    }
    let mut file = File::open(path)?;
    let mut start = Vec::new();
    (&mut file).take(GZIP.len() as u64).read_to_end(&mut start)?;
    file.rewind()?;
    Ok((start != GZIP).then_some(file))
}

/// A file's bytes, which are large and not needed for long.
struct Bytes(Vec<u8>);

impl Deref for Bytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.0
    }
}

impl Drop for Bytes {
    fn drop(&mut self) {
        give_back(mem::take(&mut self.0));
    }
}

fn format_of(path: &Path, from: Option<Format>) -> Result<Format, Failure> {
    match from.or_else(|| Format::of(path)) {
        Some(format) if format.is_read() => Ok(format),
        Some(format) => Err(not_read(&path.display().to_string(), format.extension())),
        None if path == Path::new("-") => {
            let known = listed(|f| f.holds_outlines() || f.meshes_are_read()).replace('.', "");
            Err(Failure::usage("stdin has no name that tells its format")
                .with_help(format!("--from FORMAT says it: {known}")))
        }
        None => {
            let end = path.extension().unwrap_or_default().to_string_lossy().into_owned();
            Err(not_read(&path.display().to_string(), &end))
        }
    }
}

fn not_read(name: &str, end: &str) -> Failure {
    let what = match end {
        "" => "its name does not tell its format".to_string(),
        end => format!("files that end in .{end} are not read"),
    };
    Failure::usage(format!("{name}: {what}")).with_help(format!(
        "outlines are read from {}, meshes from {}; --from FORMAT overrides the name",
        listed(Format::holds_outlines),
        listed(Format::meshes_are_read)
    ))
}

fn read_file(path: &Path) -> Result<Bytes, Failure> {
    let bytes = fs::read(path).map_err(|error| Failure::io(path, &error))?;
    uncompressed(bytes).map(Bytes).map_err(|error| {
        Failure::input(format!(
            "{}: this is no whole gzip file: {}",
            path.display(),
            reason(&error)
        ))
    })
}

fn read_stdin() -> Result<Bytes, Failure> {
    let mut bytes = Vec::new();
    let read = io::stdin().lock().read_to_end(&mut bytes);
    let failed = |error: io::Error| Failure {
        exit: Exit::Io,
        message: format!("stdin: {}", reason(&error)),
    };
    read.map_err(failed)?;
    uncompressed(bytes).map(Bytes).map_err(|error| {
        Failure::input(format!("stdin: this is no whole gzip file: {}", reason(&error)))
    })
}

/// How gzip files begin.
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// The bytes of a file, unpacked where they begin as a gzip file does.
fn uncompressed(bytes: Vec<u8>) -> io::Result<Vec<u8>> {
    if !bytes.starts_with(&GZIP) {
        return Ok(bytes);
    }
    let mut unpacked = Vec::new();
    MultiGzDecoder::new(bytes.as_slice()).read_to_end(&mut unpacked)?;
    Ok(unpacked)
}
