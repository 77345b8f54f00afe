//! The input files of Abaqus and CalculiX, `.inp`: the mesh with its sets.
//!
//! ```text
//! file := "*NODE" (<node>, <x>, <y>, 0)*
//!         "*ELEMENT, TYPE=CPS3, ELSET=EALL" (<element>, <node>, <node>, <node>)*
//!         ("*ELSET, ELSET=" <region> numbers)*
//!         ("*NSET, NSET=" <boundary> numbers "*SURFACE, NAME=" <boundary> (<element>, S<side>)*)*
//! ```
//!
//! Everything is counted from one. Elements are in plane stress, CPS3 or CPS6; replace the word for
//! another kind. Side 1 leads from the first corner to the second. An edge between two triangles is
//! the side of the first. Names are words of at most 80 letters. There are no numbers of groups.
//! (*CalculiX CrunchiX User's Manual*, sections *NODE, *ELEMENT, *ELSET, *NSET, *SURFACE.)

mod elements;
mod groups;
mod read;
mod sets;
#[cfg(test)]
mod tests;
mod write;

pub use read::read;
pub use write::write_with;
