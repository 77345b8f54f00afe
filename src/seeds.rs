//! What is meshed of an outline, told by seeds.

use crate::carve::faces_of_triangles;
use crate::domain::{self, Domain, OUTSIDE};
use crate::formats::Enclosed;
use crate::outline_of::centroid;
use crate::triangulation::initial::{self, triangulate};
use crate::{Pslg, Region};

/// Why what is meshed cannot be told by seeds.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum SeedsError {
    /// The outline is not clean, or encloses nothing.
    #[error(transparent)]
    Domain(#[from] domain::Error),
    /// The kernel cannot hold the outline.
    #[error(transparent)]
    Triangulation(#[from] initial::Error),
    /// A hole has no room for a point inside it.
    #[error("a hole is so thin that no point of doubles lies inside it")]
    Thin,
}

/// The outline with a hole seed in every enclosed face that is not meshed, so that what is meshed
/// needs no other rule: [`Enclosed::All`]. Its own hole seeds give way to these.
///
/// ```
/// use meshwright::{Pslg, formats::Enclosed, told_by_seeds};
/// let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
/// let frame = Pslg {
///     points: [square(0.0, 4.0), square(1.0, 3.0)].concat(),
///     segments: vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]],
///     segment_tags: vec![0; 8],
///     enclosed: Enclosed::EvenOdd,
///     ..Pslg::default()
/// };
/// let told = told_by_seeds(&frame)?;
/// assert_eq!(told.enclosed, Enclosed::All);
/// let [[x, y]] = told.holes[..] else { panic!("one hole") };
/// assert!((1.0..3.0).contains(&x) && (1.0..3.0).contains(&y));
/// # Ok::<(), meshwright::SeedsError>(())
/// ```
///
/// # Errors
/// See [`SeedsError`].
pub fn told_by_seeds(pslg: &Pslg) -> Result<Pslg, SeedsError> {
    let mut told = Pslg { enclosed: Enclosed::All, ..pslg.clone() };
    let (domain, _) = Domain::new(pslg, Region::Domain)?;
    if domain.region == Region::Hull {
        return Ok(told); // there are no segments
    }
    let seeds = (0..).zip(interior_points(domain.clone())?);
    let holes = seeds.filter(|&(face, _)| face != OUTSIDE && !domain.faces.is_meshed(face));
    let unscaled = |seed: [f64; 2]| seed.map(|x| domain.unscaled(x));
    told.holes = holes
        .map(|(_, seed)| seed.map(unscaled).ok_or(SeedsError::Thin))
        .collect::<Result<_, _>>()?;
    told.source.hole_lines.clear();
    Ok(told)
}

/// Whether the same faces of two outlines are meshed, which differ in nothing but seeds and
/// [`Pslg::enclosed`]; `None` where they are not clean.
#[must_use]
pub fn meshed_alike(pslg: &Pslg, other: &Pslg) -> Option<bool> {
    let meshed = |pslg| {
        let (domain, _) = Domain::new(pslg, Region::Domain).ok()?;
        let faces = (0..domain.faces.count()).map(|face| domain.faces.is_meshed(face));
        Some(faces.collect::<Vec<_>>())
    };
    Some(meshed(pslg)? == meshed(other)?)
}

/// A point strictly inside each face: the centroid of the largest triangle that holds its own.
fn interior_points(domain: Domain) -> Result<Vec<Option<[f64; 2]>>, initial::Error> {
    let (domain, initial) = triangulate(domain)?;
    let mut found = vec![(0.0, None); domain.faces.count() as usize];
    for (triangle, face) in initial.triangles.iter().zip(faces_of_triangles(&initial, &domain)) {
        let (area, seed) = centroid(triangle.vertices.map(|v| initial.points[v as usize]));
        let best = &mut found[face as usize];
        if area > best.0 && seed.is_some() {
            *best = (area, seed);
        }
    }
    Ok(found.into_iter().map(|(_, point)| point).collect())
}
