//! The vocabulary of meshwright and the files that hold it.
//!
//! [`Pslg`] is what every outline reader makes, [`Mesh`] what every mesh writer takes. This crate
//! knows files and flat arrays; it knows no geometry.
//!
//! Outlines: [`poly`], [`node`], [`obj`], [`geo`]. Meshes: [`msh`], [`vtu`], [`vtk`], [`medit`],
//! [`su2`], [`inp`]; Triangle's files, each of which holds a part: [`node`] and [`ele`], with the
//! edges in [`poly`]; [`area`] (read only). Written only: [`vtp`], [`gltf`], [`xdmf`], [`stl`],
//! [`obj`] of a mesh, [`edge`] and [`neigh`].
//!
//! A reader takes bytes and a name for its messages; it returns what it read and what it passed over
//! ([`Warning`]). A writer takes a [`std::io::Write`] and returns what became of the tags
//! ([`groups::Note`]). [`selection`] takes parts of a mesh.

pub mod area;
mod arrays;
mod assembly;
mod attributes;
mod blocks;
mod digits;
pub mod edge;
pub mod ele;
mod error;
mod file_error;
pub mod geo;
pub mod gltf;
mod grid;
pub mod groups;
pub mod inp;
pub mod medit;
mod mesh;
pub mod msh;
pub mod neigh;
pub mod node;
mod nodes;
mod numbering;
pub mod obj;
pub mod poly;
mod pslg;
mod rows;
pub mod selection;
pub mod stl;
pub mod su2;
mod tags;
mod text;
pub mod vtk;
mod vtk_xml;
pub mod vtp;
pub mod vtu;
mod wholes;
pub mod xdmf;

pub use error::{Found, Notice, SyntaxError, Warning};
pub use file_error::{ByteError, FileError};
pub use mesh::{Data, Mesh, Provenance, Values};
pub use nodes::Order;
pub use pslg::{Attribute, Enclosed, Group, LocalArea, Membership, Pslg, Region, Source, Tag};
