//! Splitting on concentric circular shells: §10 of the paper, after Ruppert.
//!
//! The first split of a segment is its midpoint. The first split of each half is at the power of
//! two nearest to its middle, counted from the half's own end. Every later split is a midpoint.
//! Only those last ones are midpoints to the analysis: the first three count as input.

use super::piece::{PieceEnd, Split, power_of_two_below};
use super::provenance::{Kind, Origin};

/// The split of a piece of a half segment.
#[must_use]
pub fn split(near: PieceEnd, far: PieceEnd) -> Split {
    if near.distance == 0.0 && far.ends_part {
        let distance = nearest_power_of_two(0.5 * far.distance);
        return Split { distance, kind: Kind::Shell, origin: Origin::Rung };
    }
    Split::at_middle(near, far, Kind::Midpoint, Origin::Rung)
}

/// The power of two nearest to `middle`, the smaller of two.
///
/// Choice: nearest by difference, not ratio, so a half is split in its middle third (§10).
fn nearest_power_of_two(middle: f64) -> f64 {
    let below = power_of_two_below(middle);
    if 2.0 * below - middle < middle - below { 2.0 * below } else { below }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn end(distance: f64, ends_part: bool) -> PieceEnd {
        PieceEnd { distance, exact: true, bisected: false, ends_part }
    }

    #[test]
    fn the_first_split_of_a_half_is_on_a_shell_in_its_middle_third() {
        for i in 1..=4096 {
            let half = f64::from(i) / 64.0;
            let Split { distance, kind, .. } = split(end(0.0, false), end(half, true));
            assert_eq!(kind, Kind::Shell);
            assert_eq!(distance, power_of_two_below(distance));
            assert!(half / 3.0 <= distance && distance <= 2.0 * half / 3.0, "{distance} of {half}");
        }
    }

    #[test]
    fn of_two_equally_near_shells_the_smaller_is_taken() {
        assert_eq!(split(end(0.0, false), end(3.0, true)).distance, 1.0);
    }

    #[test]
    fn every_later_split_is_a_midpoint() {
        let later = split(end(0.0, false), end(0.25, false));
        assert_eq!((later.distance, later.kind), (0.125, Kind::Midpoint));
        assert_eq!(split(end(0.25, false), end(0.7, true)).kind, Kind::Midpoint);
    }
}
