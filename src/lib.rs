//! Guaranteed-quality, certified triangle meshes of planar straight-line graphs.
//!
//! [`mesh()`] takes an outline (a [`Pslg`]) and gives an [`Outcome`]: a conforming Delaunay [`Mesh`]
//! with the outline's tags, and the [`Certificate`](certify::Certificate) of a judge who shares no
//! code with the refinement.
//!
//! ```
//! use meshwright::{Parameters, formats, mesh};
//! let text = b"4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 6\n3 3 4 5\n4 4 1 6\n0\n";
//! let (outline, _) = formats::poly::read(text, "plate.poly", |name| std::fs::read(name))?;
//! let outcome = mesh(&outline, &Parameters { max_area: Some(0.05), ..Parameters::default() })?;
//! assert!(outcome.certificate.holds());
//! let mut file = Vec::new();
//! formats::vtu::write(&outcome.mesh, &mut file)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The way through
//!
//! The algorithm is the Adaptive Delaunay Refinement Algorithm of Miller, Pav & Walkington, *When
//! and Why Delaunay Refinement Algorithms Work*. Data flows one way:
//!
//! | step | from | to | where |
//! |---|---|---|---|
//! | read | a file's text | [`Pslg`] | [`formats`] |
//! | check Assumption 1 | [`Pslg`] | [`Domain`](domain::Domain) | [`domain`] |
//! | triangulate | [`Domain`](domain::Domain) | [`Initial`](triangulation::initial::Initial) | [`triangulation::initial`] |
//! | carve exterior and holes out | [`Initial`](triangulation::initial::Initial) | [`Triangulation`](triangulation::Triangulation) | `carve` |
//! | refine (§3) | [`Triangulation`](triangulation::Triangulation) | the same, refined | [`refine`] |
//! | assemble | [`Triangulation`](triangulation::Triangulation) | [`Mesh`] | `assemble`, `attributes` |
//! | judge Assumption 2, Lemma 7, Corollary 3 | [`Pslg`] and [`Mesh`] | [`Certificate`](certify::Certificate) | [`certify`] |
//! | write | [`Mesh`] | a file | [`formats`] |
//!
//! Questions go to [`predicates`], which are exact; coordinates come from [`constructions`], which
//! are rounded. [`draw`] makes pictures, [`statistics`] counts. Angles are in radians, areas and
//! lengths in the units of the outline; every index is zero-based.

pub use meshwright_formats as formats;
pub use meshwright_formats::{Mesh, Pslg};

mod assemble;
mod attributes;
mod boxes;
mod carve;
pub mod certify;
mod columns;
pub mod constructions;
mod corners;
pub mod domain;
mod double_double;
pub mod draw;
mod hilbert;
pub mod memory;
mod order;
mod outline_of;
mod parameters;
pub mod predicates;
mod radix;
mod random;
mod ranked_set;
pub mod refine;
mod run;
mod seeds;
pub mod statistics;
pub mod triangulation;
mod vector;

pub use outline_of::{OutlineOfError, boundary_of, outline_of};
pub use parameters::{
    Excuse, MinAngle, MinAngleError, Parameters, Region, Rule, Splitting, Steiner, Thinning,
};
pub use run::{Error, InputAngle, Missed, Outcome, Warning, mesh, mesh_with, trace};
pub use seeds::{SeedsError, meshed_alike, told_by_seeds};
