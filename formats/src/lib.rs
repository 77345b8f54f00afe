//! The vocabulary of meshwright and the files that hold it.
//!
//! [`Pslg`] is what every outline reader makes, [`Mesh`] what every mesh writer takes. This crate
//! knows files and flat arrays; it knows no geometry.

mod mesh;
mod pslg;

pub use mesh::{Data, Mesh, Provenance, Values};
pub use pslg::{Attribute, Group, Pslg, Region, Source, Tag};
