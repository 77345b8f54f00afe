//! Gmsh's mesh format: versions 2 and 4.1, read and written, text or binary.
//!
//! Every reader tried takes 2.2 as text; 4.1 fails in several. Gmsh's manual calls 2.2 legacy and
//! describes it under "MSH file format version 2 (Legacy)", 4.1 under "MSH file format"
//! (<https://gmsh.info/doc/texinfo/gmsh.html#Gmsh-file-formats>).

mod read;
#[cfg(test)]
mod tests;
mod write;

pub use read::read;
pub use write::{Options, Version, write, write_layer, write_with};
