//! VTK's legacy format, `.vtk`, text and binary: version 3.0 is written, versions 1 to 5 are read.
//!
//! ```text
//! file   := "# vtk DataFile Version 3.0" title ("ASCII" | "BINARY") "DATASET UNSTRUCTURED_GRID"
//!           fields POINTS CELLS CELL_TYPES "CELL_DATA" <count> fields "POINT_DATA" <count> fields
//! fields := "FIELD FieldData" <arrays> (<name> <components> <tuples> <type> number*)*
//! ```
//!
//! Cells and arrays are those of [`vtu`](crate::vtu). In names every byte but letters, digits and
//! marks is written as `%` and two hexadecimal digits, as VTK does it. Binary numbers are big
//! endian. Whole numbers are `int` where 32 bits hold them, else `vtktypeint64`. Version 5 is not
//! written: few programs read it.
//! (<https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html>)

mod numbers;
mod place;
mod read;
#[cfg(test)]
mod tests;
mod write;

pub use read::read;
pub use write::{Options, write_with};
