//! The paper's numbered statements, each by its name: *When and Why Delaunay Refinement
//! Algorithms Work* (Miller, Pav and Walkington), with the corrections of ALGORITHM §11.
//!
//! - [`certificates`]: what the certificate says of whole meshes, G8 to G10.
//! - [`geometry`]: what holds for points, rays and circles.
//! - [`subsegments`]: what holds for pieces of segments that are split at their midpoints.
//! - [`sequences`]: circumcenter sequences (Definition 2).
//! - [`meshes`]: what holds for whole meshes.
//! - [`grooming`]: what points put on segments beforehand do (§9).
//! - [`figures`]: what the paper's pictures show.
//! - [`corrections`]: where the text says something else than its proofs.

mod certificates;
mod corrections;
mod figures;
mod geometry;
mod grooming;
mod meshes;
mod sequences;
mod subsegments;

/// κ̂ of the paper: arcsin 2^(−7/6), in radians.
fn kappa_hat() -> f64 {
    libm::asin(libm::exp2(-7.0 / 6.0))
}

/// f(θ) = arctan(sin θ / (2 − cos θ)) of Lemmas 6 and 7.
fn f(theta: f64) -> f64 {
    libm::atan2(libm::sin(theta), 2.0 - libm::cos(theta))
}

/// Rounding of a handful of operations on numbers about 1.
const ROUNDING: f64 = 1e-12;
