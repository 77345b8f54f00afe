//! Medit's mesh format, `.mesh`, as FreeFEM and Mmg read it: text.
//!
//! ```text
//! file := "MeshVersionFormatted 2" "Dimension 2"
//!         "Vertices" <count> (<x> <y> <number>)*
//!         "Edges" <count> (<vertex> <vertex> <number>)*
//!         "Triangles" <count> (<vertex> <vertex> <vertex> <number>)* "End"
//!       | the same with "EdgesP2" and "TrianglesP2", of 3 and 6 vertices
//! ```
//!
//! A list that is empty is left out. Vertices are counted from one. Groups have numbers, no names; 0 is for what has no tag. (P. Frey,
//! *MEDIT: an interactive mesh visualization software*, INRIA RT-0253, section 7.2.)

mod read;
mod write;

pub use read::read;
pub use write::{write, write_with};
