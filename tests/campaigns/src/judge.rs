//! Meshing an outline and judging how it went.

use meshwright::certify::{Certificate, Fault, Guarantee};
use meshwright::{Mesh, Parameters, Pslg};

use crate::measure::{FLOOR, near_touches, resolution_limits, ulp_of_largest, with_hull};
use crate::plane::{Point, distance};

/// How a run ended that had to end well.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// Every promise is kept.
    Kept,
    /// Every promise is kept but near apexes that doubles cannot resolve, as §9 of ALGORITHM says.
    Limited,
    /// Something is wrong; each line says what.
    Failed(Vec<String>),
}

/// A run and its verdict.
#[derive(Debug)]
pub struct Judged {
    /// The verdict.
    pub verdict: Verdict,
    /// What the run made, if it made anything.
    pub made: Option<Made>,
}

/// A mesh and what the judge says about it.
#[derive(Debug)]
pub struct Made {
    /// The mesh.
    pub mesh: Mesh,
    /// The certificate.
    pub certificate: Certificate,
}

impl Judged {
    /// The number of points of the mesh, 0 without one.
    #[must_use]
    pub fn points(&self) -> usize {
        self.made.as_ref().map_or(0, |made| made.mesh.points.len())
    }

    /// What the run made.
    ///
    /// # Panics
    /// When the run failed: with the reasons.
    #[must_use]
    pub fn well(self) -> Made {
        match (self.verdict, self.made) {
            (Verdict::Failed(reasons), _) => panic!("{}", reasons.join("\n")),
            (_, Some(made)) => made,
            (_, None) => unreachable!("a run without a mesh has failed"),
        }
    }
}

/// Meshes an outline that must mesh, and judges the result.
#[must_use]
pub fn judge(outline: &Pslg, parameters: &Parameters) -> Judged {
    match meshwright::mesh(outline, parameters) {
        Err(error) => Judged { verdict: Verdict::Failed(vec![error.to_string()]), made: None },
        Ok(outcome) => {
            let made = Made { mesh: outcome.mesh, certificate: outcome.certificate };
            Judged { verdict: verdict(outline, &made), made: Some(made) }
        }
    }
}

fn verdict(outline: &Pslg, made: &Made) -> Verdict {
    let mut reasons = faults(&made.certificate);
    reasons.extend(beyond_the_limit(outline, made));
    if !reasons.is_empty() {
        Verdict::Failed(reasons)
    } else if made.certificate.limited() {
        Verdict::Limited
    } else {
        Verdict::Kept
    }
}

/// The guarantees that fail, each with its first fault.
fn faults(certificate: &Certificate) -> Vec<String> {
    let failing = certificate.judgements.iter().filter(|judgement| judgement.faults > 0);
    failing
        .map(|judgement| {
            let code = judgement.guarantee.code();
            let first = judgement.first.first().map_or_else(String::new, ToString::to_string);
            format!("{code}: {} faults; first: {first}", judgement.faults)
        })
        .collect()
}

/// What the certificate calls limited by precision where §9's bound, computed here from the
/// outline alone, says nothing of the kind.
fn beyond_the_limit(outline: &Pslg, made: &Made) -> Vec<String> {
    if !made.certificate.limited() {
        return Vec::new();
    }
    let outline = &with_hull(outline, made.certificate.promise.region);
    let limits = resolution_limits(outline, &made.mesh.points);
    // Around two features that nearly touch edges are refused, as far as some floors reach.
    let ulp = ulp_of_largest(&made.mesh.points);
    let touches = near_touches(outline, 2.0 * FLOOR * ulp);
    let excused = |place: Point| {
        let near_an_apex =
            |&(apex, reach): &(Point, f64)| distance(place, apex) <= reach * (1.0 + 1e-9);
        let near_a_touch = |&touch: &Point| distance(place, touch) <= 5.0 * FLOOR * ulp;
        limits.iter().any(near_an_apex) || touches.iter().any(near_a_touch)
    };
    Guarantee::ALL
        .iter()
        .flat_map(|&guarantee| &made.certificate.judgement(guarantee).first_limited)
        .filter(|fault| !witness(&made.mesh, fault).into_iter().any(excused))
        .map(|fault| format!("not within the limit of any apex: {fault}"))
        .collect()
}

/// The points that a fault speaks of.
fn witness(mesh: &Mesh, fault: &Fault) -> Vec<Point> {
    let triangle = fault.triangle.into_iter().flat_map(|t| mesh.triangles[t as usize]);
    let edge = fault.edge.into_iter().flatten();
    let corners = triangle.chain(edge).chain(fault.point);
    corners.map(|v| mesh.points[v as usize]).chain([fault.place]).collect()
}
