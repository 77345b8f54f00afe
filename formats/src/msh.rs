//! Gmsh's mesh format: versions 2 and 4.1 are read, text or binary; version 2.2 is written, as text.
//!
//! Every reader tried takes version 2.2; 4.1 fails in several. Gmsh's manual calls it legacy and
//! describes it under "MSH file format version 2 (Legacy)"
//! (<https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format-version-2-_0028Legacy_0029>).

mod read;
#[cfg(test)]
mod tests;
mod write;

pub use read::read;
pub use write::{Options, write, write_with};
