//! Files that are written whole or not at all.
//!
//! A regular file is written beside its place and renamed when everything went well; what is
//! special (a device, a pipe, a link) is written to directly. Files that are half-written are
//! removed on every way out, an interrupt included.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use super::failure::{Exit, Failure};

/// The name that stands for stdin and stdout.
pub const STDOUT: &str = "-";

/// Files that are being written, to be removed if the process is interrupted.
static HALF_WRITTEN: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes what is half-written and ends the process, while no file is put in its place.
pub fn remove_half_written_and_exit(exit: Exit) -> ! {
    // A lock that is held during a rename is waited for; one that a panic left is taken.
    let files = HALF_WRITTEN.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    for file in files.iter() {
        let _ = fs::remove_file(file);
    }
    std::process::exit(exit as i32)
}

/// Refuses outputs that would overwrite an input or each other, or whose folder is missing, so
/// that a long run does not end in vain.
pub fn check_places(outputs: &[PathBuf], inputs: &[PathBuf]) -> Result<(), Failure> {
    for (i, output) in outputs.iter().enumerate() {
        if output == Path::new(STDOUT) {
            continue;
        }
        if let Some(input) = inputs.iter().find(|input| same_file(input, output)) {
            return Err(Failure::usage(format!(
                "the output {} is the input {}: it would be overwritten",
                output.display(),
                input.display()
            )));
        }
        if let Some(other) = outputs[..i].iter().find(|other| same_file(other, output)) {
            return Err(Failure::usage(format!(
                "two outputs have one place: {} and {}",
                other.display(),
                output.display()
            )));
        }
        let folder = folder_of(output);
        let found = fs::metadata(&folder).map_err(|error| Failure::io(&folder, &error))?;
        if !found.is_dir() {
            return Err(Failure::io(&folder, &io::Error::from(io::ErrorKind::NotADirectory)));
        }
        if output.is_dir() {
            return Err(Failure::io(output, &io::Error::from(io::ErrorKind::IsADirectory)));
        }
    }
    Ok(())
}

fn same_file(a: &Path, b: &Path) -> bool {
    if !is_regular_or_new(b) && !fs::metadata(b).is_ok_and(|found| found.is_file()) {
        return false; // a device or a pipe may serve twice
    }
    match (fs::metadata(a), fs::metadata(b)) {
        (Ok(a_found), Ok(b_found)) if same_inode(&a_found, &b_found) => true,
        _ => matches!((real_place(a), real_place(b)), (Some(a), Some(b)) if a == b),
    }
}

#[cfg(unix)]
fn same_inode(a: &fs::Metadata, b: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn same_inode(_: &fs::Metadata, _: &fs::Metadata) -> bool {
    false
}

/// Where a file really is, or will be.
fn real_place(path: &Path) -> Option<PathBuf> {
    fs::canonicalize(path)
        .or_else(|_| {
            fs::canonicalize(folder_of(path)).map(|f| f.join(path.file_name().unwrap_or_default()))
        })
        .ok()
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
        _ => PathBuf::from("."),
    }
}

/// A file that is written but not yet in its place.
pub struct Pending {
    place: PathBuf,
    /// Where the bytes are until then; `None` for a special file.
    beside: Option<PathBuf>,
    size: u64,
}

impl Pending {
    /// Writes a file beside its place (or into a special file).
    pub fn write<T>(
        place: &Path,
        content: impl FnOnce(&mut dyn Write) -> io::Result<T>,
    ) -> Result<(Self, T), Failure> {
        let begun = Self::begin(place).map_err(|error| Failure::io(place, &error));
        let (mut pending, file) = begun?;
        let special = pending.beside.is_none();
        let file = BufWriter::with_capacity(1 << 16, Sink { file, special });
        let mut out = Counted { inner: file, size: 0 };
        let written = content(&mut out).and_then(|value| out.flush().map(|()| value));
        pending.size = out.size;
        match written {
            Ok(value) => Ok((pending, value)),
            Err(error) => Err(Failure::io(place, &error)), // dropped, so removed
        }
    }

    fn begin(place: &Path) -> io::Result<(Self, Box<dyn Write>)> {
        if place == Path::new(STDOUT) || !is_regular_or_new(place) {
            let file: Box<dyn Write> = match place == Path::new(STDOUT) {
                true => Box::new(io::stdout().lock()),
                false => Box::new(File::create(place)?),
            };
            return Ok((Self { place: place.to_path_buf(), beside: None, size: 0 }, file));
        }
        let name = place.file_name().ok_or(io::ErrorKind::InvalidInput)?.to_string_lossy();
        let mut files = half_written();
        for attempt in 0..100 {
            let name = format!(".{name}.{}-{attempt}.part", std::process::id());
            let beside = folder_of(place).join(name);
            match OpenOptions::new().write(true).create_new(true).open(&beside) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
                Ok(file) => {
                    files.push(beside.clone());
                    let pending =
                        Self { place: place.to_path_buf(), beside: Some(beside), size: 0 };
                    return Ok((pending, Box::new(file)));
                }
            }
        }
        Err(io::ErrorKind::AlreadyExists.into())
    }

    /// Puts the file in its place.
    pub fn finish(mut self) -> Result<Written, Failure> {
        if let Some(beside) = self.beside.take() {
            let mut files = half_written();
            if let Ok(old) = fs::metadata(&self.place) {
                let _ = fs::set_permissions(&beside, old.permissions());
            }
            let renamed = fs::rename(&beside, &self.place);
            if renamed.is_err() {
                let _ = fs::remove_file(&beside);
            }
            files.retain(|file| *file != beside);
            renamed.map_err(|error| Failure::io(&self.place, &error))?;
        }
        Ok(Written { place: std::mem::take(&mut self.place), size: self.size })
    }
}

impl Drop for Pending {
    fn drop(&mut self) {
        if let Some(beside) = self.beside.take() {
            let mut files = half_written();
            let _ = fs::remove_file(&beside);
            files.retain(|file| *file != beside);
        }
    }
}

/// A file in its place.
#[derive(Debug, Clone)]
pub struct Written {
    /// Where.
    pub place: PathBuf,
    /// How many bytes.
    pub size: u64,
}

fn half_written() -> std::sync::MutexGuard<'static, Vec<PathBuf>> {
    HALF_WRITTEN.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// Whether a file is to be replaced by renaming: a regular file of one name, or none yet.
fn is_regular_or_new(path: &Path) -> bool {
    match fs::symlink_metadata(path) {
        Ok(found) => found.is_file() && has_one_name(&found),
        Err(_) => true,
    }
}

#[cfg(unix)]
fn has_one_name(found: &fs::Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(found) == 1
}

#[cfg(not(unix))]
fn has_one_name(_: &fs::Metadata) -> bool {
    true
}

/// Where the bytes go. A pipe whose reader has seen enough swallows the rest.
struct Sink {
    file: Box<dyn Write>,
    special: bool,
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.file.write(bytes) {
            Err(e) if self.special && e.kind() == io::ErrorKind::BrokenPipe => Ok(bytes.len()),
            written => written,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.file.flush() {
            Err(e) if self.special && e.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            flushed => flushed,
        }
    }
}

struct Counted<W> {
    inner: W,
    size: u64,
}

impl<W: Write> Write for Counted<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.inner.write(bytes)?;
        self.size += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}
