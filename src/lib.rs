//! Guaranteed-quality, certified triangle meshes of planar straight-line graphs.

pub use meshwright_formats as formats;
pub use meshwright_formats::{Mesh, Pslg};

mod assemble;
mod attributes;
mod carve;
pub mod certify;
pub mod constructions;
mod corners;
pub mod domain;
mod double_double;
pub mod draw;
mod parameters;
pub mod predicates;
pub mod refine;
mod run;
pub mod statistics;
pub mod triangulation;

pub use parameters::{
    Excuse, MinAngle, MinAngleError, Parameters, Region, Rule, Splitting, Steiner,
};
pub use run::{Error, InputAngle, Outcome, Warning, mesh, mesh_with};

/// The README's example runs as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
