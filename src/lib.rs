//! Guaranteed-quality, certified triangle meshes of planar straight-line graphs.

pub use meshwright_formats as formats;
pub use meshwright_formats::{Mesh, Pslg};

pub mod certify;
pub mod domain;
pub mod draw;
mod parameters;
pub mod predicates;
pub mod statistics;

pub use parameters::{
    Excuse, MinAngle, MinAngleError, Parameters, Region, Rule, Splitting, Steiner,
};
