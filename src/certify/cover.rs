//! G1, second half: the triangles cover the domain, and nothing else.
//!
//! All triangles are counter-clockwise, an edge inside has one on either side, a piece of a
//! segment has one exactly where the domain lies: then every place of the domain is covered once,
//! and no other place is. Euler characteristic and area are compared on top of that.

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::fault::{Fault, FaultKind};
use super::outline::Outline;
use super::verdict::Judgement;

/// Judges what the triangles cover.
pub(super) fn judge(outline: &Outline, complex: &Complex, chains: &Chains, g1: &mut Judgement) {
    judge_gaps(complex, chains, g1);
    judge_sides(outline, complex, chains, g1);
    if g1.faults == 0 {
        // Else these only say again what is said with its place above.
        judge_totals(outline, complex, g1);
    }
}

/// An edge with one triangle must be a boundary.
pub(super) fn judge_gaps(complex: &Complex, chains: &Chains, g1: &mut Judgement) {
    for &h in complex.one_sided() {
        // Of two triangles on one side of an edge only one has the twin; that is reported.
        let [_, other] = complex.find(complex.origin(h), complex.target(h));
        if !chains.is_bound(h) && other == NONE {
            let fault = Fault::at_edge(complex.mesh, FaultKind::Gap, complex.edge(h));
            g1.add(fault.of_triangle(complex.number(h)));
        }
    }
}

/// A piece of a segment has a triangle on each side where the domain lies, and on no other.
fn judge_sides(outline: &Outline, complex: &Complex, chains: &Chains, g1: &mut Judgement) {
    for s in 0..outline.segments.len() as u32 {
        let sides = outline.sides(s);
        for [v, w] in chains.pieces(s) {
            let halves = complex.find(v, w);
            let inside = sides.iter().all(|face| face.meshed);
            if inside && halves == [NONE; 2] {
                continue; // no edge at all: G4
            }
            for (face, h) in sides.into_iter().zip(halves) {
                if face.meshed && h == NONE {
                    let fault = Fault::at_edge(complex.mesh, FaultKind::Unmeshed, [v, w]);
                    g1.add(fault.of_segment(outline.segment_name(s)));
                }
                if !face.meshed && h != NONE {
                    let fault = Fault::at_edge(complex.mesh, FaultKind::Overmeshed, [v, w]);
                    g1.add(
                        fault.of_segment(outline.segment_name(s)).of_triangle(complex.number(h)),
                    );
                }
            }
        }
    }
}

fn judge_totals(outline: &Outline, complex: &Complex, g1: &mut Judgement) {
    let place = complex.mesh.points.first().copied().unwrap_or_default();
    let (found, expected) = (complex.euler_characteristic(), outline.euler_characteristic());
    if found != expected {
        g1.add(Fault::of_mesh(FaultKind::Euler { found, expected }, place));
    }
    let (area, perimeter) = outline.area_and_perimeter();
    let tolerance = complex.points.len() as f64 * complex.frame.ulp * perimeter;
    let found = complex.area;
    let holds = (found - area).abs() <= tolerance; // false for NaN
    if !holds {
        let [found, expected] = [found, area].map(|area| complex.frame.area_outside(area));
        g1.add(Fault::of_mesh(FaultKind::Area { found, expected }, place));
    }
}
