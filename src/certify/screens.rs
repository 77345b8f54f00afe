//! What hides vertices where doubles end.
//!
//! A vertex in the diametral disc of a piece of a segment may be hidden behind another piece. If the
//! other one has no end in that disc, what the disc has beyond it lies in its own disc: the vertex is
//! in both. Where doubles end the other one may be too short to be split: it stays encroached then, and
//! so does the first one, however long that is.

use std::cmp::Ordering;
use std::ops::ControlFlow;

use super::complex::Complex;
use super::conformity::Chains;
use super::exact;
use super::precision::Floor;
use crate::boxes::{Boxes, Rectangle};

/// The pieces of segments that have an end where doubles end.
pub(super) struct Screens {
    pieces: Vec<[u32; 2]>,
    tree: Boxes,
}

impl Screens {
    /// Those of a mesh.
    pub(super) fn new(complex: &Complex, chains: &Chains, floor: &Floor) -> Self {
        let subsegments = chains.bound().filter(|&h| chains.is_subsegment(h));
        let pieces = subsegments.map(|h| complex.edge(h)).filter(|ends| floor.covers(ends));
        let (pieces, boxes): (Vec<_>, Vec<_>) = pieces
            .map(|ends @ [p, q]| (ends, Rectangle::around(complex.at(p), complex.at(q))))
            .unzip();
        Self { pieces, tree: Boxes::new(&boxes) }
    }

    /// Whether one of them hides a vertex from an end of the piece `edge`, and has it in its disc.
    pub(super) fn hide(&self, complex: &Complex, edge: [u32; 2], vertex: u32) -> bool {
        let v = complex.at(vertex);
        edge.into_iter().any(|end| {
            let from = complex.at(end);
            let hides = |piece: u32| {
                let [p, q] = self.pieces[piece as usize].map(|w| complex.at(w));
                let is_hidden =
                    stands_between([p, q], from, v) && exact::diametral(p, q, v) == Ordering::Less;
                if is_hidden { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            self.tree.overlapping(&Rectangle::around(from, v), hides).is_break()
        })
    }
}

/// Whether the segment p q meets the line of sight from one point to another, which lie on either
/// side of it.
fn stands_between([p, q]: [[f64; 2]; 2], from: [f64; 2], to: [f64; 2]) -> bool {
    let sides = |a, b, ends: [[f64; 2]; 2]| ends.map(|end| exact::orientation(a, b, end));
    let [of_from, of_to] = sides(p, q, [from, to]);
    let [of_p, of_q] = sides(from, to, [p, q]);
    of_from != Ordering::Equal && of_from == of_to.reverse() && of_p != of_q
}
