//! VTK's XML format for unstructured grids, `.vtu`. With raw appended data, which is the default,
//! a file is:
//!
//! ```text
//! file     := <VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"
//!             header_type="UInt64"> grid appended </VTKFile>
//! grid     := FieldData? Piece(PointData CellData Points Cells)
//! appended := <AppendedData encoding="raw"> white space `_` array* newline </AppendedData>
//! array    := <number of bytes: u64> <bytes>
//! ```
//!
//! Base64, text and compressed arrays are written too ([`Options`]). Cells are the edges (VTK's type
//! 3), then the triangles (type 5); of second order types 21 and 22. Arrays:
//!
//! | array | where | holds |
//! |---|---|---|
//! | `gmsh:physical` | cells | the number of the group: the tag, or a positive number where that is 0 |
//! | `tag` | cells | the user's tag, 0 for none |
//! | `segment` | edges | the (zero-based) input segment, −1 for none and for triangles |
//! | `provenance` | points | 0 input, 1 shell, 2 midpoint, 3 circumcenter ([`Provenance`]); −1 in the middle of a side |
//! | `marker` | points | the marker |
//! | `meshwright` | field | 0, the version of this table |
//! | a group's name | field | `[number, dimension]`, one pair for each group of the name |
//!
//! Further arrays are the mesh's own data; edges have NaN, or 0 where numbers are whole, in those
//! of triangles. (<https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>)
//!
//! [`Provenance`]: crate::Provenance

mod coded;
mod fault;
mod header;
mod numbers;
mod read;
mod source;
#[cfg(test)]
mod tests;
mod write;

pub use fault::{Fault, ReadError};
pub use read::{read, read_from};
pub use write::{write, write_with};

pub use crate::vtk_xml::{Encoding, Options};

/// VTK's numbers of the kinds of cells.
pub(crate) const LINE: u8 = 3;
pub(crate) const TRIANGLE: u8 = 5;
pub(crate) const LINE_3: u8 = 21;
pub(crate) const TRIANGLE_6: u8 = 22;

/// Names of arrays that have a meaning here.
pub(crate) const PHYSICAL: &str = "gmsh:physical";
pub(crate) const TAG: &str = "tag";
pub(crate) const SEGMENT: &str = "segment";
pub(crate) const PROVENANCE: &str = "provenance";
pub(crate) const MARKER: &str = "marker";
pub(crate) const VERSION: &str = "meshwright";
