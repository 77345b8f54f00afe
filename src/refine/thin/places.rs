//! Where thinning tries a point: at random, a little farther from its trigger edge than it must be.
//!
//! Choice (points of Superior, boxed, 100 000 random ones after 20 000, 20 000 and 300 000 tries, and
//! the time of a try): with these 730, 1 002, 178 700; with look-ahead's 36 places and 28 anywhere in the
//! circumdisc 736, 1 012, 179 400 in 1.4 times the time. It is the neighbourhood of the edge that
//! counts: random places in the circumdisc alone, 64 of them, are worth 740, 1 025, 181 500.

use super::super::look_ahead::{Demand, Place};

/// So many places are surveyed for a point.
pub(super) const DRAWN: usize = 24;

/// How far to the side places are, in lengths of the trigger edge, and how much farther up than the
/// rule asks for.
const SPREAD: [f64; 2] = [1.1, 0.9];
/// The same where there is a soft target: fewer places are good for it.
const SPREAD_WITH_TARGET: [f64; 2] = [0.8, 0.6];

/// What random numbers are made places with.
pub(super) struct Places<'d> {
    demand: &'d Demand,
    nearest: f64,
    spread: [f64; 2],
}

impl<'d> Places<'d> {
    pub fn of(demand: &'d Demand) -> Self {
        let spread = if demand.has_target() { SPREAD_WITH_TARGET } else { SPREAD };
        Self { demand, nearest: demand.relative_nearest(), spread }
    }

    /// The place that a point of the unit square stands for.
    pub fn at(&self, drawn: [f64; 2]) -> [f64; 2] {
        self.demand.at(self.over_edge(drawn))
    }

    /// Places near to the arcs around the ends of the edge that none may be within are the likelier.
    fn over_edge(&self, [x, y]: [f64; 2]) -> Place {
        let [sideways, upwards] = self.spread;
        let shift = sideways * (2.0 * x - 1.0);
        let from_end = shift.abs() - 0.5;
        let least = (self.nearest - from_end * from_end).max(0.0).sqrt();
        [least + upwards * y * y, shift]
    }
}
