//! G2 and G3: what the circles are empty of, exactly.

use std::cmp::Ordering;

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::exact;
use super::outline::Outline;
use super::precision::Floor;
use super::verdict::{Fault, FaultKind, Judgement};

/// G2: an edge that is no piece of a segment is locally Delaunay: the apex on one side is not
/// strictly inside the circle of the triangle on the other.
pub(super) fn judge_edges(complex: &Complex, chains: &Chains, g2: &mut Judgement) {
    for h in 0..complex.twin.len() as u32 {
        let twin = complex.twin[h as usize];
        if twin == NONE || h > twin || chains.is_subsegment(h) {
            continue;
        }
        let [a, b] = complex.edge(h);
        let (c, d) = (complex.apex(h), complex.apex(twin));
        let [p, q, r, s] = [a, b, c, d].map(|v| complex.at(v));
        if exact::in_circle(p, q, r, s) == Ordering::Greater {
            let fault = Fault::at_edge(complex.mesh, FaultKind::NotDelaunay, [a, b]);
            g2.add(fault.of_triangle(complex.number(h)).of_point(d));
        }
    }
}

/// G3: no apex is strictly inside the diametral disc of the piece of a segment opposite it.
pub(super) fn judge_discs(
    outline: Option<&Outline>,
    complex: &Complex,
    chains: &Chains,
    floor: &Floor,
    g3: &mut Judgement,
) {
    for h in (0..complex.twin.len() as u32).filter(|&h| chains.is_subsegment(h)) {
        let [a, b] = complex.edge(h);
        let apex = complex.apex(h);
        if exact::diametral(complex.at(a), complex.at(b), complex.at(apex)) != Ordering::Less {
            continue;
        }
        let mut fault = Fault::at_edge(complex.mesh, FaultKind::Encroached, [a, b])
            .of_triangle(complex.number(h))
            .of_point(apex);
        if let (Some(outline), Some(s)) = (outline, chains.segment(h)) {
            fault = fault.of_segment(outline.segment_name(s));
        }
        g3.add_unless(floor.covers(&complex.triangles[h as usize / 3]), fault);
    }
}
