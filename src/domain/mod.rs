//! Assumption 1: from an outline to a domain that may be refined.

mod adjoining;
mod along_curve;
mod angles;
mod closest;
mod conflicts;
mod error;
mod faces;
mod feature_size;
mod hull;
mod item;
mod merge;
mod meshed;
mod nesting;
mod open_ends;
mod precision;
mod range;
mod repair;
mod status;
mod sweep;
#[cfg(test)]
mod tests;

use std::sync::OnceLock;

pub(crate) use along_curve::{coarse_points, extent};
pub use angles::Angle;
pub use closest::{ClosestPair, Feature};
pub use conflicts::{Conflict, ConflictKind, Conflicts};
pub use error::{Error, Item, Kind, LimitedApex, Warning};
pub use faces::{Faces, OUTSIDE};
pub use open_ends::{OpenEnd, OpenEnds};
pub use precision::PrecisionLimit;
pub use repair::{Repair, RepairKind, Repaired, Report, repair};

use crate::boxes::Rectangle;
use crate::columns::in_columns;
use crate::formats::LocalArea;
use crate::vector::Vector;
use crate::{Pslg, Region};
use conflicts::Dirty;
use meshed::{Clean, Meshed};
use sweep::Linework;

/// A PSLG for which Assumption 1 holds exactly, in the coordinates that the refinement works in.
///
/// Every array is zero-based and in the order of the outline, but for the points'
/// [along a curve](Domain::along_hilbert_curve); "input" indices are those of the [`Pslg`] it was
/// made from.
#[derive(Debug, Clone)]
pub struct Domain {
    /// Distinct points, scaled by 2^−[`scale_exponent`](Domain::scale_exponent).
    pub points: Vec<[f64; 2]>,
    /// The input point that each point is (the first of those that were merged).
    pub input_points: Vec<u32>,
    /// The target size at each point, scaled (infinite: none); empty where the outline has none.
    pub point_sizes: Vec<f64>,
    /// Distinct segments as indices into [`Domain::points`]; then, where the convex hull is
    /// meshed, the hull edges that are not segments yet.
    pub segments: Vec<[u32; 2]>,
    /// The input segment that each segment is; `u32::MAX` for a hull edge that the outline lacks.
    pub input_segments: Vec<u32>,
    /// Boundary tag of each segment (0: untagged).
    pub segment_tags: Vec<i32>,
    /// The faces between the segments: which are meshed, and their regions.
    pub faces: Faces,
    /// Whether each point lies in a meshed face or on the boundary of one; the others do not
    /// belong to the mesh.
    pub meshed_points: Vec<bool>,
    /// The hole seeds that take a face out, scaled.
    pub holes: Vec<[f64; 2]>,
    /// The region seeds that count, one for each meshed face that has any, scaled (areas too).
    pub regions: Vec<crate::formats::Region>,
    /// Bounds on the area of triangles that depend on the place, scaled.
    pub local_areas: Vec<LocalArea>,
    /// Input coordinates = these coordinates × 2^`scale_exponent`; 0 unless the outline's
    /// largest coordinate has an exponent outside ±100.
    pub scale_exponent: i32,
    /// ulp(M): the distance between doubles at M, the largest coordinate of what is meshed in
    /// magnitude; scaled.
    pub ulp: f64,
    /// What is meshed: the whole convex hull where that is asked for, or there is no segment at
    /// all.
    pub region: Region,
    /// For each point, the segments that end there, counter-clockwise from straight down: those
    /// of point `p` are `adjoining[adjoining_start[p]..adjoining_start[p + 1]]`.
    pub adjoining_start: Vec<u32>,
    /// See [`Domain::adjoining_start`].
    pub adjoining: Vec<u32>,
    /// The index behind [`Domain::lfs`], once it is asked for.
    features: OnceLock<feature_size::Features>,
}

impl Domain {
    /// The domain that an outline describes. Duplicate points are merged, duplicate segments and
    /// those of length zero dropped, each with a warning.
    ///
    /// ```
    /// use meshwright::domain::Domain;
    /// use meshwright::{Pslg, Region};
    /// let triangle = Pslg {
    ///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
    ///     segments: vec![[0, 1], [1, 2], [2, 0]],
    ///     segment_tags: vec![0; 3],
    ///     ..Pslg::default()
    /// };
    /// let (domain, warnings) = Domain::new(&triangle, Region::Domain)?;
    /// assert_eq!(domain.adjoining(1), [1, 0]);
    /// assert!(warnings.is_empty());
    /// # Ok::<(), meshwright::domain::Error>(())
    /// ```
    ///
    /// # Errors
    /// What keeps Assumption 1 from holding, with the culprits' numbers and lines.
    pub fn new(pslg: &Pslg, region: Region) -> Result<(Self, Vec<Warning>), Error> {
        let mut warnings = Vec::new();
        let scale_exponent = range::scale_exponent(pslg)?;
        let scaled = |place| range::scaled(place, scale_exponent);

        let scaled_points = pslg.points.iter().copied().map(scaled).collect();
        let merge::Points { points, input: input_points, distinct, mut order } =
            merge::points(pslg, scaled_points, &mut warnings);
        let merge::Segments { mut segments, input: mut input_segments, tags: mut segment_tags } =
            merge::segments(pslg, &distinct, &mut warnings);

        if points.len() < 3 {
            return Err(Error::TooFewPoints { points: points.len() });
        }
        if hull::is_on_a_line(&points) {
            return Err(Error::Collinear { points: points.len() });
        }
        if segments.is_empty() {
            warnings.push(Warning::NoSegments);
        }
        let has_segments = !segments.is_empty();
        let region = if has_segments { region } else { Region::Hull };
        if region == Region::Hull {
            let closest = 2.0 * precision::floor(&points);
            let core = Rectangle::within_hull(points.iter().copied());
            let outer = hull::outer(&points, core, 2.0 * closest);
            let hull_edges = hull::hull_edges(&points, &outer);
            if hull::is_line(&hull_edges, &points, closest) {
                return Err(Error::Collinear { points: points.len() });
            }
            let mut on_hull = vec![false; points.len()];
            hull_edges.iter().for_each(|&[start, _]| on_hull[start as usize] = true);
            let missing = hull::missing(hull_edges, &segments);
            let bent = hull::through_near_points(&missing, &points, &outer, &on_hull, closest);
            let is_bent = bent.len() > missing.len();
            let is_crossed = is_bent && hull::is_crossed(&bent, &points, &segments);
            let chain = if is_crossed { missing } else { bent };
            segments.extend(hull::missing(chain, &segments));
            input_segments.resize(segments.len(), u32::MAX);
            segment_tags.resize(segments.len(), 0);
            if !has_segments {
                order = outer; // the others are too far within to meet a hull edge
            }
        }

        let (adjoining_start, adjoining) = adjoining::adjoining(&points, &segments);
        let linework = Linework {
            points: &points,
            segments: &segments,
            order: &order,
            adjoining_start: &adjoining_start,
            adjoining: &adjoining,
        };
        let region_seeds = pslg.regions.iter().map(|region| region.seed);
        let seeds: Vec<_> = pslg.holes.iter().copied().chain(region_seeds).map(scaled).collect();
        let located = sweep::sweep(&linework, &seeds).map_err(|violation| {
            let dirty = Dirty {
                pslg,
                linework,
                input_points: &input_points,
                input_segments: &input_segments,
                scale_exponent,
            };
            Error::Conflicts(Box::new(dirty.conflicts(violation)))
        })?;
        let clean = Clean {
            pslg,
            linework,
            located,
            input_points: &input_points,
            input_segments: &input_segments,
            region,
        };
        let Meshed { faces, holes, regions, points: meshed_points } =
            clean.meshed(&mut warnings)?;

        let holes = holes.iter().map(|&hole| seeds[hole as usize]).collect();
        let regions = regions.iter().map(|&region| {
            let region = &pslg.regions[region as usize];
            crate::formats::Region {
                seed: scaled(region.seed),
                max_area: region.max_area.map(|area| libm::scalbn(area, -2 * scale_exponent)),
                ..*region
            }
        });
        let regions = regions.collect();
        let local_areas = pslg.local_areas.iter().map(|area| LocalArea {
            corners: area.corners.map(scaled),
            max_area: libm::scalbn(area.max_area, -2 * scale_exponent),
        });
        let local_areas = local_areas.collect();
        let ulp = match region {
            // What is not meshed takes part in the refinement.
            Region::Global => precision::ulp(&points, &vec![true; points.len()]),
            _ => precision::ulp(&points, &meshed_points),
        };
        let domain = Self {
            point_sizes: merge::sizes(pslg, &distinct, points.len(), scale_exponent),
            points,
            input_points,
            segments,
            input_segments,
            segment_tags,
            faces,
            meshed_points,
            holes,
            regions,
            local_areas,
            scale_exponent,
            ulp,
            region,
            adjoining_start,
            adjoining,
            features: OnceLock::new(),
        };
        warnings.extend(domain.preflight(pslg));
        Ok((domain, warnings))
    }

    /// The warning that names the apexes at which doubles are too coarse, if there are any.
    fn preflight(&self, pslg: &Pslg) -> Option<Warning> {
        let limits = self.precision_limits();
        let named = |limit: &PrecisionLimit| LimitedApex {
            point: Item::new(pslg, Kind::Point, self.input_points[limit.angle.apex as usize]),
            segments: limit.angle.segments.map(|segment| {
                let input = self.input_segments[segment as usize];
                (input != u32::MAX).then(|| Item::new(pslg, Kind::Segment, input))
            }),
            radians: limit.angle.radians,
            reach: limit.reach,
        };
        let first = limits.iter().take(conflicts::IN_FULL).map(named).collect();
        (!limits.is_empty()).then_some(Warning::LimitedByPrecision { count: limits.len(), first })
    }

    /// The area of what is meshed, in the squared units of the outline (infinite where that is
    /// beyond doubles).
    #[must_use]
    pub fn area(&self) -> f64 {
        let origin = self.points[0];
        let from_origin = |end: u32| Vector::between(origin, self.points[end as usize]);
        let twice_area = sum((0..).zip(&self.segments).map(|(segment, &[a, b])| {
            let [left, right] = self.faces.sides(segment).map(|face| self.faces.is_meshed(face));
            if left == right {
                0.0
            } else {
                from_origin(a).cross(from_origin(b)) * if left { 1.0 } else { -1.0 }
            }
        }));
        libm::scalbn(0.5 * twice_area, 2 * self.scale_exponent)
    }

    /// A length in the units of the outline.
    #[must_use]
    pub fn unscaled(&self, length: f64) -> f64 {
        libm::scalbn(length, self.scale_exponent)
    }

    /// The segments that end at a point, counter-clockwise.
    #[must_use]
    pub fn adjoining(&self, point: u32) -> &[u32] {
        let point = point as usize;
        &self.adjoining
            [self.adjoining_start[point] as usize..self.adjoining_start[point + 1] as usize]
    }
}

/// The points' indices, sorted by x, then by y, then by index.
fn lexicographic_order(points: &[[f64; 2]]) -> Vec<u32> {
    in_columns(points, 0..points.len() as u32).into_iter().map(|placed| placed as u32).collect()
}

/// A sum whose rounding errors are summed too (Neumaier).
fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let (sum, error) = terms.fold((0.0_f64, 0.0), |(sum, error), term| {
        let next = sum + term;
        let (larger, smaller) = if sum.abs() >= term.abs() { (sum, term) } else { (term, sum) };
        (next, error + ((larger - next) + smaller))
    });
    sum + error
}
