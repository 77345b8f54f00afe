//! Splitting at the rungs of dyadic ladders: ours, the default (ALGORITHM §3).
//!
//! With shells, the pieces farther out on two segments at an angle θ have unrelated lengths, and
//! a small angle costs in proportion to 1/θ. Here each end of a segment that has a neighbour at
//! less than 90° owns a part of it, and a part is split at round dyadic distances from its apex
//! all the way out: two ladders of one apex have the same rungs.

use super::piece::{PieceEnd, Split, power_of_two_below};
use super::provenance::{Kind, Origin};

/// Where a piece is split: rules b and c. `sine` is that of the smallest angle at the piece's
/// apex between its segment and an adjoining one.
#[must_use]
pub fn split(sine: f64, near: PieceEnd, far: PieceEnd) -> Split {
    let length = far.distance - near.distance;
    let stub = far.ends_part && length < 0.25 * far.distance * sine;
    if near.distance > 0.0 && (stub || near.bisected || far.bisected) {
        return Split::at_middle(near, far, Kind::Shell, Origin::Middle);
    }
    let third = length / 3.0;
    let distance = coarsest_dyadic(near.distance + third, far.distance - third);
    let kind = if is_standard(near, far) { Kind::Midpoint } else { Kind::Shell };
    Split { distance, kind, origin: Origin::Rung }
}

/// The number i·2^j with the largest j in the closed interval; there is but one.
///
/// In [L/3, 2L/3] that is §10's shell; in a standard dyadic interval's middle third the midpoint.
fn coarsest_dyadic(low: f64, high: f64) -> f64 {
    let mut unit = power_of_two_below(high);
    loop {
        let candidate = (high / unit).floor() * unit;
        if candidate >= low || unit <= high - low {
            return candidate.max(low);
        }
        unit *= 0.5;
    }
}

/// Whether the piece is a standard dyadic interval [i·2^j, (i + 1)·2^j].
fn is_standard(near: PieceEnd, far: PieceEnd) -> bool {
    let length = far.distance - near.distance;
    near.exact
        && far.exact
        && length == power_of_two_below(length)
        && (near.distance / length).fract() == 0.0
}

/// Where the parts of a segment's two ends meet: rule a.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Border {
    /// The end that it is nearer to.
    pub nearer: usize,
    /// Its distance from that end, of 30 significant bits.
    pub distance: f64,
}

/// The territory point of a segment: where the gaps to the segments adjoining at either end are
/// equal. `gaps[e]` is the gap as a function of the distance from end e; it does not decrease.
/// Where the point would be nearer to an end than `floor`, the border is that end itself: the
/// whole segment belongs to the other.
#[must_use]
pub fn territory_point(length: f64, gaps: [&dyn Fn(f64) -> f64; 2], floor: f64) -> Border {
    let middle = 0.5 * length;
    let nearer = usize::from(gaps[0](middle) < gaps[1](middle));
    let (mut low, mut high) = (0.0, middle);
    // The gap of the nearer end overtakes the other's somewhere in (0, L/2].
    while high - low > libm::ldexp(high, -31) {
        let guess = 0.5 * (low + high);
        if gaps[nearer](guess) < gaps[1 - nearer](length - guess) {
            low = guess;
        } else {
            high = guess;
        }
        if high < floor {
            return Border { nearer, distance: 0.0 };
        }
    }
    let unit = libm::ldexp(power_of_two_below(high), -29);
    Border { nearer, distance: (high / unit).round() * unit }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rung(distance: f64) -> PieceEnd {
        PieceEnd { distance, exact: true, bisected: false, ends_part: false }
    }

    fn part_end(distance: f64, exact: bool) -> PieceEnd {
        PieceEnd { distance, exact, bisected: false, ends_part: true }
    }

    #[test]
    fn the_first_split_from_an_apex_is_the_shell_of_the_paper() {
        for i in 1..=4096 {
            let length = f64::from(i) / 64.0;
            let ours = split(0.1, rung(0.0), part_end(length, false));
            let shell = super::super::shells::split(rung(0.0), part_end(length, false));
            if power_of_two_below(length / 3.0) != length / 3.0 {
                assert_eq!(ours.distance, shell.distance, "{length}");
            }
        }
    }

    #[test]
    fn at_three_times_a_power_of_two_the_coarser_rung_is_taken() {
        assert_eq!(split(0.1, rung(0.0), part_end(3.0, false)).distance, 2.0);
    }

    #[test]
    fn a_standard_dyadic_interval_splits_at_its_midpoint() {
        let made = split(0.1, rung(6.0), rung(8.0));
        assert_eq!((made.distance, made.kind), (7.0, Kind::Midpoint));
        let made = split(0.1, rung(5.0), rung(7.0));
        assert_eq!((made.distance, made.kind), (6.0, Kind::Shell));
    }

    #[test]
    fn an_inexact_far_end_is_no_rung() {
        assert_eq!(split(0.1, rung(0.0), part_end(8.0, false)).kind, Kind::Shell);
        assert_eq!(split(0.1, rung(0.0), part_end(8.0, true)).kind, Kind::Midpoint);
    }

    #[test]
    fn a_short_last_piece_is_bisected_and_so_are_its_halves() {
        let made = split(0.5, rung(8.0), part_end(8.1, false));
        assert_eq!((made.kind, made.origin), (Kind::Shell, Origin::Middle));
        let half = PieceEnd { exact: false, bisected: true, ..rung(made.distance) };
        assert_eq!(split(0.5, rung(8.0), half).origin, Origin::Middle);
    }

    #[test]
    fn the_territory_point_has_equal_gaps() {
        let border = territory_point(1.0, [&|d| 0.1 * d, &|d| 0.4 * d], 1e-9);
        assert_eq!(border.nearer, 1);
        assert!((border.distance - 0.2).abs() < 1e-9);
        let bits = border.distance.to_bits();
        assert_eq!(bits % (1 << 23), 0, "30 significant bits");
    }

    #[test]
    fn a_territory_below_the_floor_is_given_up() {
        let border = territory_point(1.0, [&|d| 1e-9 * d, &|d| d], 1e-6);
        assert_eq!(border, Border { nearer: 1, distance: 0.0 });
    }
}
