//! SU2's mesh format, `.su2`: text.
//!
//! ```text
//! file   := "NDIME= 2" "NELEM=" <count> element* "NPOIN=" <count> point* "NMARK=" <count> marker*
//! element := 5 <point> <point> <point> <number>        (5: VTK's number of a triangle)
//! point  := <x> <y> <number>
//! marker := "MARKER_TAG=" <name> "MARKER_ELEMS=" <count> (3 <point> <point>)*
//! ```
//!
//! Everything is counted from zero. Boundaries have names, no numbers; regions have neither.
//! (<https://su2code.github.io/docs_v7/Mesh-File/>)

mod read;
mod write;

pub use read::read;
pub use write::write;
