//! What an outline is like: its smallest angle, its nearest features, whether it is clean.

use meshwright::predicates::{Side, side};
use meshwright::{Mesh, Pslg, Region};

use crate::plane::{
    Point, angle, cross, direction, distance, distance_of_segments, distance_to_segment,
    legs_overlap, minus, segments_meet,
};

/// θ* as ALGORITHM defines it before it is cut off at π/3: the smallest angle (radians) between
/// two segments with a common end, `None` where no two segments have one.
#[must_use]
pub fn smallest_angle(outline: &Pslg) -> Option<f64> {
    angles_at_points(outline).into_iter().flatten().min_by(f64::total_cmp)
}

/// The smallest angle between two segments at each point.
fn angles_at_points(outline: &Pslg) -> Vec<Option<f64>> {
    let points = of_size_one(outline);
    let mut legs: Vec<Vec<(f64, Point)>> = vec![Vec::new(); points.len()];
    for &[a, b] in &outline.segments {
        let (p, q) = (points[a as usize], points[b as usize]);
        legs[a as usize].push((direction(p, q), q));
        legs[b as usize].push((direction(q, p), p));
    }
    let smallest = |(x, mut legs): (&Point, Vec<(f64, Point)>)| {
        if legs.len() < 2 {
            return None;
        }
        legs.sort_by(|s, t| s.0.total_cmp(&t.0));
        let next = legs.iter().cycle().skip(1);
        legs.iter().zip(next).map(|(s, t)| angle(s.1, *x, t.1)).min_by(f64::total_cmp)
    };
    points.iter().zip(legs).map(smallest).collect()
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

/// The area of a mesh, from its triangles.
#[must_use]
pub fn area(mesh: &Mesh) -> f64 {
    let corner = |v: u32| mesh.points[v as usize];
    let triangle = |&[a, b, c]: &[u32; 3]| {
        0.5 * cross(minus(corner(b), corner(a)), minus(corner(c), corner(a)))
    };
    mesh.triangles.iter().map(triangle).sum()
}

/// φ = 2¹² ulp(M), in units of ulp(M): no edge is made shorter (ALGORITHM §9).
pub const FLOOR: f64 = 4096.0;

/// ulp(M), M the largest coordinate in magnitude.
#[must_use]
pub fn ulp_of_largest(points: &[Point]) -> f64 {
    let largest = points.iter().flatten().fold(0.0_f64, |m, c| m.max(c.abs()));
    libm::scalbn(1.0, libm::ilogb(largest) - 52)
}

/// Where doubles end (ALGORITHM §9): each point with adjoining segments, and how far from it two of
/// them at an angle θ are no longer told apart: θ²·d < 4·ulp(M) or θ·d < φ, with M the largest
/// output coordinate. The smallest θ at the point reaches farthest.
#[must_use]
pub fn resolution_limits(outline: &Pslg, output: &[Point]) -> Vec<(Point, f64)> {
    let ulp = ulp_of_largest(output);
    let reach = |theta: f64| (4.0 * ulp / theta / theta).max(FLOOR * ulp / theta);
    let apexes = outline.points.iter().zip(angles_at_points(outline));
    apexes.filter_map(|(&x, theta)| Some((x, reach(theta?)))).collect()
}

/// The points that come nearer than `gap` to another point or to a segment that is not theirs.
#[must_use]
pub fn near_touches(outline: &Pslg, gap: f64) -> Vec<Point> {
    let segments = located(outline, &outline.points);
    let touches = |(i, &p): (usize, &Point)| {
        let near_segment =
            |&(_, a, b): &Located| p != a && p != b && distance_to_segment(p, a, b) < gap;
        let near_point = |&q: &Point| p != q && distance(p, q) < gap;
        segments.iter().any(near_segment) || outline.points[..i].iter().any(near_point)
    };
    outline.points.iter().enumerate().filter(|&p| touches(p)).map(|(_, &p)| p).collect()
}

/// The outline with the sides of its convex hull as segments, where that is what is meshed.
#[must_use]
pub fn with_hull(outline: &Pslg, region: Region) -> Pslg {
    let mut whole = outline.clone();
    if region == Region::Hull || outline.segments.is_empty() {
        for side in hull_sides(&outline.points) {
            let known = |&s: &[u32; 2]| s == side || s == [side[1], side[0]];
            if !whole.segments.iter().any(known) {
                whole.segments.push(side);
                whole.segment_tags.push(0);
            }
        }
    }
    whole
}

/// The sides of the convex hull, from each point on it to the next (Andrew's monotone chain).
fn hull_sides(points: &[Point]) -> Vec<[u32; 2]> {
    let at = |v: u32| points[v as usize];
    let mut sorted: Vec<u32> = (0..points.len() as u32).collect();
    sorted.sort_by(|&v, &w| at(v)[0].total_cmp(&at(w)[0]).then(at(v)[1].total_cmp(&at(w)[1])));
    sorted.dedup_by_key(|v| at(*v).map(f64::to_bits));
    let mut sides = Vec::new();
    for _ in 0..2 {
        let mut chain: Vec<u32> = Vec::new();
        for &p in &sorted {
            while let [.., a, b] = chain[..] {
                if side(at(a), at(b), at(p)) != Side::Right {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        sides.extend(chain.windows(2).map(|w| [w[0], w[1]]));
        sorted.reverse();
    }
    sides
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

/// Whether each of some places (seeds, say) keeps clear of all segments. Exact.
#[must_use]
pub fn clear_of_segments(outline: &Pslg, places: &[Point]) -> Vec<bool> {
    let segments = located(outline, &of_size_one(outline));
    let exponent = exponent_of_size(outline);
    let clear = |place: &Point| {
        let x = place.map(|c| libm::scalbn(c, -exponent));
        segments.iter().all(|&(_, p, q)| !segments_meet(x, x, p, q))
    };
    places.iter().map(clear).collect()
}

/// The points, scaled by a power of two so that the largest coordinate is about 1: no product
/// over- or underflows, and no bit changes.
fn of_size_one(outline: &Pslg) -> Vec<Point> {
    let exponent = exponent_of_size(outline);
    outline.points.iter().map(|p| p.map(|c| libm::scalbn(c, -exponent))).collect()
}

/// The exponent of the largest coordinate.
fn exponent_of_size(outline: &Pslg) -> i32 {
    let largest = outline.points.iter().flatten().fold(0.0_f64, |m, c| m.max(c.abs()));
    if largest == 0.0 { 0 } else { libm::ilogb(largest) }
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
