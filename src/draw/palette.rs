//! The colours: soft ones for regions, strong ones for what has a boundary tag.

pub const PAPER: &str = "#ffffff";
pub const TEXT: &str = "#33414d";
/// Segments and edges without a tag.
pub const UNTAGGED: &str = "#33414d";
/// The edges between triangles, over any region's colour.
pub const INNER_EDGE: &str = "#5b7387";
/// Regions without a tag, where others have one.
pub const NO_REGION: &str = "#eceff1";
pub const HOLE: &str = "#8a97a3";
pub const EXCUSED: &str = "#f0a63a";
pub const LIMITED: &str = "#b07cc6";
pub const FAULT: &str = "#d3273e";
/// The triangles of a point that was just committed.
pub const MADE: &str = "#bfe3c0";
/// That point.
pub const NEW: &str = "#1f8a3b";
pub const ENCROACHED: &str = "#e07b00";

const BOUNDARIES: [&str; 8] =
    ["#14507e", "#c2502e", "#1d7f6e", "#8a5fa8", "#b8860b", "#5d8a2c", "#b03a6f", "#7b5138"];

const REGIONS: [&str; 8] =
    ["#d9e8f3", "#f2e8d3", "#dcebdc", "#f3dfda", "#e5dff0", "#d5ecea", "#f0efcf", "#eadfd4"];

/// The colour of the `rank`-th boundary tag (they come round again after the last).
pub fn boundary(rank: usize) -> &'static str {
    BOUNDARIES[rank % BOUNDARIES.len()]
}

/// The colour of the `rank`-th region tag.
pub fn region(rank: usize) -> &'static str {
    REGIONS[rank % REGIONS.len()]
}

/// The colour of a point of this kind, and the kind's name.
pub fn point_kind(kind: meshwright_formats::Provenance) -> (&'static str, &'static str) {
    use meshwright_formats::Provenance::{Circumcenter, Input, Midpoint, Shell};
    match kind {
        Input => ("#1b2733", "input point"),
        Shell => ("#c2502e", "shell point"),
        Midpoint => ("#1d7f6e", "midpoint"),
        Circumcenter => ("#6f9cc0", "circumcenter"),
    }
}
