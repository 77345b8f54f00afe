//! A piece of a segment (a subsegment) as the splitting rules see it: two numbers along it.

use super::provenance::{Kind, Origin};

/// An end of a piece, by its distance from the apex that the piece belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PieceEnd {
    /// The distance.
    pub distance: f64,
    /// Whether that number is exact, so that it may be a rung.
    pub exact: bool,
    /// Whether a bisection made it, where no rung was good: then all pieces at it are bisected.
    pub bisected: bool,
    /// Whether the apex's part of the segment ends here.
    pub ends_part: bool,
}

/// Where a piece is split.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Split {
    /// The distance from the apex that the piece belongs to.
    pub distance: f64,
    /// `Shell` or `Midpoint`.
    pub kind: Kind,
    /// How the distance came about.
    pub origin: Origin,
}

impl Split {
    /// A split at the middle of a piece.
    #[must_use]
    pub fn at_middle(near: PieceEnd, far: PieceEnd, kind: Kind, origin: Origin) -> Self {
        Self { distance: 0.5 * (near.distance + far.distance), kind, origin }
    }
}

/// The largest power of two that is not above a positive, normal number: its exponent alone.
#[must_use]
pub fn power_of_two_below(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & (0x7ff << 52))
}
