//! G9: are the points of the kinds that they are said to be?

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::fault::{Fault, FaultKind};
use super::verdict::{Judgement, Kinds};
use crate::formats::Provenance;

/// Why G8 and G9 are not judged.
pub(super) const UNKNOWN: &str = "it needs the kinds of points, which .vtu files hold";

/// Counts the points by kind, and compares the kinds with where the points lie: points of the
/// outline, points inside of segments, others. `None` where the mesh does not say its points' kinds.
pub(super) fn judge(complex: &Complex, chains: &Chains, g9: &mut Judgement) -> Option<Kinds> {
    let provenance = &complex.mesh.provenance;
    if provenance.len() != complex.points.len() || provenance.is_empty() {
        *g9 = Judgement::not_judged(g9.guarantee, UNKNOWN);
        return None;
    }
    let mut kinds = Kinds::default();
    for (v, kind) in (0..).zip(provenance) {
        let is_input = chains.input(v) != NONE;
        let is_inside = chains.inside(v) != NONE;
        let (count, agrees) = match kind {
            Provenance::Input => (&mut kinds.input, is_input),
            Provenance::Shell => (&mut kinds.shell, is_inside),
            Provenance::Midpoint => (&mut kinds.midpoint, is_inside),
            Provenance::Circumcenter => (&mut kinds.circumcenter, !is_input && !is_inside),
        };
        *count += 1;
        if !agrees {
            g9.add(Fault::at_point(complex.mesh, FaultKind::WrongKind, v));
        }
    }
    Some(kinds)
}
