//! What an outline is like: its smallest angle, its nearest features, whether it is clean.

use meshwright::Pslg;

use crate::plane::{
    Point, angle, direction, distance_of_segments, distance_to_segment, legs_overlap, segments_meet,
};

/// θ* as ALGORITHM defines it before it is cut off at π/3: the smallest angle (radians) between
/// two segments with a common end, `None` where no two segments have one.
#[must_use]
pub fn smallest_angle(outline: &Pslg) -> Option<f64> {
    let points = of_size_one(outline);
    let mut legs: Vec<Vec<(f64, Point)>> = vec![Vec::new(); points.len()];
    for &[a, b] in &outline.segments {
        let (p, q) = (points[a as usize], points[b as usize]);
        legs[a as usize].push((direction(p, q), q));
        legs[b as usize].push((direction(q, p), p));
    }
    let mut smallest = None::<f64>;
    for (x, legs) in points.iter().zip(&mut legs).filter(|(_, legs)| legs.len() > 1) {
        legs.sort_by(|s, t| s.0.total_cmp(&t.0));
        for (i, leg) in legs.iter().enumerate() {
            let between = angle(leg.1, *x, legs[(i + 1) % legs.len()].1);
            smallest = Some(smallest.map_or(between, |s| s.min(between)));
        }
    }
    smallest
}

/// How near two disjoint features come: the least of (distance of two features) / (length of the
/// longer), over all pairs of segments without a common end, and of segments and points that end
/// no segment. `f64::INFINITY` where there is no such pair.
///
/// The legs of one angle adjoin: however thin their wedge is, it does not count.
#[must_use]
pub fn clearance(outline: &Pslg) -> f64 {
    let mut least = f64::INFINITY;
    let points = of_size_one(outline);
    let segments = located(outline, &points);
    for (i, &([a, b], p, q)) in segments.iter().enumerate() {
        for &([c, d], r, s) in &segments[..i] {
            if a != c && a != d && b != c && b != d {
                let length = libm::hypot(q[0] - p[0], q[1] - p[1])
                    .max(libm::hypot(s[0] - r[0], s[1] - r[1]));
                least = least.min(distance_of_segments(p, q, r, s) / length);
            }
        }
    }
    for point in isolated(outline) {
        for &(_, p, q) in &segments {
            let length = libm::hypot(q[0] - p[0], q[1] - p[1]);
            least = least.min(distance_to_segment(points[point], p, q) / length);
        }
    }
    least
}

/// Whether Assumption 1 (i)–(iii) holds, decided exactly, by looking at all pairs.
#[must_use]
pub fn is_clean(outline: &Pslg) -> bool {
    let mut points = of_size_one(outline);
    let segments = located(outline, &points);
    let crossing = segments
        .iter()
        .enumerate()
        .any(|(i, &s)| s.0[0] == s.0[1] || segments[..i].iter().any(|&t| in_conflict(s, t)));
    let on_segment = isolated(outline).iter().any(|&point| {
        let x = points[point];
        segments.iter().any(|&(_, p, q)| segments_meet(x, x, p, q))
    });
    points.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
    let double = points.windows(2).any(|w| w[0] == w[1]);
    !crossing && !double && !on_segment
}

/// A segment: its points' numbers, then their places.
pub(crate) type Located = ([u32; 2], Point, Point);

/// Whether two segments meet where they should not.
pub(crate) fn in_conflict(([a, b], p, q): Located, ([c, d], r, s): Located) -> bool {
    match (a == c, a == d, b == c, b == d) {
        (false, false, false, false) => segments_meet(p, q, r, s),
        (true, false, false, false) => legs_overlap(p, q, s),
        (false, true, false, false) => legs_overlap(p, q, r),
        (false, false, true, false) => legs_overlap(q, p, s),
        (false, false, false, true) => legs_overlap(q, p, r),
        _ => true, // the same segment twice
    }
}

/// The points, scaled by a power of two so that the largest coordinate is about 1: no product
/// over- or underflows, and no bit changes.
fn of_size_one(outline: &Pslg) -> Vec<Point> {
    let largest = outline.points.iter().flatten().fold(0.0_f64, |m, c| m.max(c.abs()));
    let exponent = if largest == 0.0 { 0 } else { libm::ilogb(largest) };
    outline.points.iter().map(|p| p.map(|c| libm::scalbn(c, -exponent))).collect()
}

fn located(outline: &Pslg, points: &[Point]) -> Vec<Located> {
    let place = |i: u32| points[i as usize];
    outline.segments.iter().map(|&[a, b]| ([a, b], place(a), place(b))).collect()
}

/// The points that end no segment.
fn isolated(outline: &Pslg) -> Vec<usize> {
    let mut used = vec![false; outline.points.len()];
    for &[a, b] in &outline.segments {
        used[a as usize] = true;
        used[b as usize] = true;
    }
    (0..used.len()).filter(|&i| !used[i]).collect()
}
