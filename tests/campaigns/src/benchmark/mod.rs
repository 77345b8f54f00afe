//! meshwright beside other programs: the same outlines, one run after the other.
//!
//! - [`cases`]: what is meshed, made from seeds.
//! - [`programs`]: who meshes it, and how each is asked.
//! - [`process`]: what a run of a program took.
//! - [`table`]: all of it side by side.

pub mod cases;
pub mod process;
pub mod programs;
pub mod table;
