//! G2 and G3: what the circles are empty of, exactly. And what a solver has of it: G10.

use std::cmp::Ordering;
use std::ops::ControlFlow;

use super::complex::{Complex, NONE};
use super::conformity::Chains;
use super::exact;
use super::fault::{Fault, FaultKind};
use super::outline::Outline;
use super::precision::Floor;
use super::screens::Screens;
use super::verdict::Judgement;
use crate::boxes::{Boxes, Rectangle};

/// G2: an edge that is no piece of a segment is locally Delaunay: the apex on one side is not
/// strictly inside the circle of the triangle on the other.
///
/// Three points of one segment count as collinear (ALGORITHM §2): where doubles end, their rounding
/// alone may have put one of them into the circle through the other two.
pub(super) fn judge_edges(
    outline: Option<&Outline>,
    complex: &Complex,
    chains: &Chains,
    floor: &Floor,
    g2: &mut Judgement,
) {
    for &[h, twin] in complex.not_delaunay.iter().filter(|[h, _]| !chains.is_subsegment(*h)) {
        let [a, b] = complex.edge(h);
        let (c, d) = (complex.apex(h), complex.apex(twin));
        let fault = Fault::at_edge(complex.mesh, FaultKind::NotDelaunay, [a, b]);
        let is_limited = (floor.covers(&[a, b, c]) || floor.covers(&[b, a, d]))
            && outline.is_some_and(|outline| three_on_a_segment(outline, chains, [a, b, c, d]));
        g2.add_unless(is_limited, fault.of_triangle(complex.number(h)).of_point(d));
    }
}

/// Whether three of the points lie on one segment of the outline.
fn three_on_a_segment(outline: &Outline, chains: &Chains, points: [u32; 4]) -> bool {
    points.iter().map(|&v| chains.inside(v)).filter(|&s| s != NONE).any(|s| {
        let ends = outline.segments[s as usize].ends;
        let is_on = |&&v: &&u32| {
            let input = chains.input(v);
            chains.inside(v) == s || (input != NONE && ends.contains(&input))
        };
        points.iter().filter(is_on).count() >= 3
    })
}

/// G3: no apex is strictly inside the diametral disc of the piece of a segment opposite it.
pub(super) fn judge_discs(
    outline: Option<&Outline>,
    complex: &Complex,
    chains: &Chains,
    floor: &Floor,
    g3: &mut Judgement,
) {
    for h in chains.bound().filter(|&h| chains.is_subsegment(h)) {
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

/// G3 where the mesh is Delaunay with respect to all its vertices (§7, `global`): none of them, seen
/// or not, is strictly inside the diametral disc of a piece of a segment. With G2 the triangles'
/// circles are empty of all vertices then. Limited by precision are what has a point where doubles
/// end, and what is hidden by a piece that has one.
pub(super) fn judge_discs_of_all(
    outline: Option<&Outline>,
    complex: &Complex,
    chains: &Chains,
    floor: &Floor,
    g3: &mut Judgement,
) {
    let used = (0..complex.points.len() as u32).filter(|&v| complex.used[v as usize]);
    let (vertices, boxes): (Vec<u32>, Vec<Rectangle>) =
        used.map(|v| (v, Rectangle::around(complex.at(v), complex.at(v)))).unzip();
    let tree = Boxes::new(&boxes);
    let screens = Screens::new(complex, chains, floor);
    for h in chains.bound().filter(|&h| chains.is_subsegment(h)) {
        let twin = complex.twin(h);
        if twin != NONE && h > twin {
            continue;
        }
        let [a, b] = complex.edge(h);
        let [p, q] = [complex.at(a), complex.at(b)];
        let seen = [h, twin].map(|half| if half == NONE { NONE } else { complex.apex(half) });
        let _ = tree.overlapping(&around_disc(p, q), |found| {
            let v = vertices[found as usize];
            if seen.contains(&v) || exact::diametral(p, q, complex.at(v)) != Ordering::Less {
                return ControlFlow::<()>::Continue(());
            }
            let mut fault = Fault::at_edge(complex.mesh, FaultKind::Encroached, [a, b]).of_point(v);
            if let (Some(outline), Some(s)) = (outline, chains.segment(h)) {
                fault = fault.of_segment(outline.segment_name(s));
            }
            let is_limited = floor.covers(&[a, b, v]) || screens.hide(complex, [a, b], v);
            g3.add_unless(is_limited, fault);
            ControlFlow::Continue(())
        });
    }
}

/// A rectangle around the diametral disc of an edge, a little larger.
fn around_disc([px, py]: [f64; 2], [qx, qy]: [f64; 2]) -> Rectangle {
    let radius = 0.5 * libm::hypot(qx - px, qy - py) * (1.0 + 1e-9);
    let middle = [0.5 * px + 0.5 * qx, 0.5 * py + 0.5 * qy];
    Rectangle { low: middle.map(|c| c - radius), high: middle.map(|c| c + radius) }
}

/// G10: the P1 stiffness matrix of −∇·(k∇u), k > 0 constant in each region, is an M-matrix, and the
/// circumcenters make an admissible finite-volume mesh: none lies across a segment.
///
/// The entry of an edge inside a region is −k/2·(cot α + cot β), α and β its opposite angles; its
/// sign is that of the in-circle determinant, which G2 has decided exactly. At a piece of a segment
/// k may differ from side to side, so that each side's cotangent must not be negative by itself: no
/// apex strictly inside the diametral disc, which is G3. And a triangle's circumcenter lies across a
/// segment only if an angle opposite some piece of one is obtuse, for a Delaunay mesh.
pub(super) fn conclude_matrix(g2: &Judgement, g3: &Judgement, g10: &mut Judgement) {
    let of = |fault: &Fault| Fault { kind: FaultKind::PositiveCoupling, ..fault.clone() };
    g10.first = g2.first.iter().chain(&g3.first).map(of).collect();
    g10.faults = g2.faults + g3.faults;
    g10.first_limited = g2.first_limited.iter().chain(&g3.first_limited).map(of).collect();
    g10.limited = g2.limited + g3.limited;
}
