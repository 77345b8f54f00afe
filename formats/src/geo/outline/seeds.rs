//! A place strictly inside a surface, far from its boundary.

use super::contours::{Polygon, abscissa};

/// How many heights are looked at.
const HEIGHTS: usize = 16;

/// A level stretch inside a surface, between two of its sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stretch {
    from: f64,
    to: f64,
    y: f64,
    /// How far its middle is from everything, along the axes.
    room: f64,
}

impl Stretch {
    /// The place at a fraction of it.
    pub(super) fn at(&self, fraction: f64) -> [f64; 2] {
        [self.from + fraction * (self.to - self.from), self.y]
    }
}

/// Stretches inside the area between polygons (by even and odd), away from `walls` and from all
/// end points, the roomiest first; none if the polygons enclose nothing.
///
/// Each lies halfway between two neighbouring heights of points, so it goes through none of them.
pub(super) fn stretches(
    polygons: &[&Polygon],
    walls: &[[[f64; 2]; 2]],
    points: &[[f64; 2]],
) -> Vec<Stretch> {
    let corners = polygons.iter().flat_map(|polygon| &polygon.points);
    let others = walls.iter().flatten().chain(points);
    let mut heights: Vec<f64> = corners.chain(others).map(|p| p[1]).collect();
    heights.sort_unstable_by(f64::total_cmp);
    heights.dedup();
    let mut gaps: Vec<[f64; 2]> = heights.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let wider = |a: &[f64; 2], b: &[f64; 2]| {
        (b[1] - b[0]).total_cmp(&(a[1] - a[0])).then(a[0].total_cmp(&b[0]))
    };
    if gaps.len() > HEIGHTS {
        gaps.select_nth_unstable_by(HEIGHTS, wider);
        gaps.truncate(HEIGHTS);
    }
    gaps.sort_unstable_by(wider);
    let mut found = Vec::new();
    for [low, high] in gaps {
        let y = low + 0.5 * (high - low);
        if low < y
            && y < high
            && let Some([from, to]) = widest(polygons, walls, y)
        {
            found.push(Stretch { from, to, y, room: (to - from).min(high - low) });
        }
    }
    found.sort_by(|a, b| b.room.total_cmp(&a.room).then(a.y.total_cmp(&b.y)));
    found
}

/// The widest stretch inside at a height.
fn widest(polygons: &[&Polygon], walls: &[[[f64; 2]; 2]], y: f64) -> Option<[f64; 2]> {
    let meets = |[a, b]: &[[f64; 2]; 2]| (a[1] > y) != (b[1] > y);
    let sides = polygons.iter().filter(|polygon| polygon.least[1] < y && y < polygon.most[1]);
    let sides = sides.flat_map(|polygon| polygon.sides()).filter(meets);
    let mut crossings: Vec<(f64, bool)> = sides.map(|side| (abscissa(side, y), true)).collect();
    crossings
        .extend(walls.iter().filter(|wall| meets(wall)).map(|&wall| (abscissa(wall, y), false)));
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    let mut inside = false;
    let mut best: Option<[f64; 2]> = None;
    for pair in crossings.windows(2) {
        let [(a, is_side), (b, _)] = [pair[0], pair[1]];
        inside ^= is_side;
        if inside && best.is_none_or(|[c, d]| b - a > d - c) {
            best = Some([a, b]);
        }
    }
    best.filter(|[a, b]| b > a)
}
