//! Outlines to be feared, and the campaigns that run meshwright over them.
//!
//! - [`Random`]: numbers that are the same everywhere.
//! - [`figures`]: outlines that a figure is known for: one wedge, 20 spokes, a turned grid.
//! - [`families`]: random outlines, each family nasty in one way.
//! - [`hostile`]: everything at once, clean by construction.
//! - [`profiles`]: ways of meshing, drawn at random.
//! - [`tangle`]: outlines that are to be repaired.
//! - [`sketch`], [`plane`], [`measure`], [`motion`], [`poly`]: what those are made with.
//! - [`corpus`]: the large collection of outlines, and what is known of each.
//! - [`survey`]: tables over that collection.
//! - [`experiments`]: the tables and pictures of the paper, made again.
//! - [`benchmark`]: meshwright beside other programs.
//! - [`book`]: the index of the book of the paper.
//! - [`judge`], [`run`], [`shrink`]: meshing, judging, doing so two thousand times, and making small
//!   what fails.

pub mod benchmark;
pub mod book;
pub mod corpus;
pub mod experiments;
pub mod families;
pub mod figures;
pub mod hostile;
pub mod judge;
pub mod measure;
pub mod motion;
pub mod plane;
pub mod poly;
pub mod profiles;
mod random;
pub mod run;
pub mod shrink;
pub mod sketch;
pub mod survey;
pub mod tangle;

pub use families::Family;
pub use random::Random;
