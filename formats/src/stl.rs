//! STL: the triangles of a mesh as facets in the plane z = 0, text and binary; written.
//!
//! ```text
//! text   := ("solid" <region> facet* "endsolid" <region>)*
//! facet  := "facet normal 0 0 1" "outer loop" ("vertex" <x> <y> <z>)×3 "endloop" "endfacet"
//! binary := 80 bytes, <number of facets: u32> (12 × f32, 2 bytes)*        little endian
//! ```
//!
//! A facet has its corners to itself: what triangles share is lost. Text has a solid for each
//! region, with its name; a binary file has neither, and coordinates in single precision.
//! (<https://www.loc.gov/preservation/digital/formats/fdd/fdd000505.shtml>)

mod write;

pub use write::write_with;
