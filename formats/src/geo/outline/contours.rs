//! The boundary of a surface as closed contours, and how they lie in one another.

use super::places::first_place;

/// A closed line of curves, each with its sign.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Contour {
    /// The loop of the surface that it comes from, as an index.
    pub of_loop: usize,
    pub curves: Vec<i32>,
}

/// Puts the curves of a loop together; the signs they are given with do not matter.
///
/// `ends` tells the first and the last point of a curve. A curve that is given twice bounds
/// nothing: it is left out.
///
/// # Errors
/// The point at which only one curve ends.
pub(super) fn contours(
    of_loop: usize,
    curves: &[i32],
    ends: impl Fn(i32) -> [u32; 2],
) -> Result<Vec<Contour>, u32> {
    let once = once(curves);
    let mut ending = Ending::at(&once, &ends)?;
    let mut used = vec![false; once.len()];
    let mut contours = Vec::new();
    for start in 0..once.len() {
        if used[start] {
            continue;
        }
        used[start] = true;
        let [begin, mut here] = ends(once[start]);
        let mut found = vec![once[start]];
        while here != begin {
            // Every point has an even number of ends, so one is left.
            let Some(next) = ending.next(here, &used) else { return Err(here) };
            used[next] = true;
            let [first, last] = ends(once[next]);
            let forward = first == here;
            found.push(if forward { once[next] } else { -once[next] });
            here = if forward { last } else { first };
        }
        contours.push(Contour { of_loop, curves: found });
    }
    Ok(contours)
}

/// The curves, without signs, that stand in a loop an odd number of times.
fn once(curves: &[i32]) -> Vec<i32> {
    let mut sorted: Vec<i32> = curves.iter().map(|curve| curve.abs()).collect();
    sorted.sort_unstable();
    let even = sorted.chunk_by(|a, b| a == b).filter(|equal| equal.len() % 2 == 0);
    let even: Vec<i32> = even.map(|equal| equal[0]).collect();
    let is_odd = |curve: &i32| even.binary_search(curve).is_err();
    curves.iter().map(|curve| curve.abs()).filter(is_odd).collect()
}

/// Which curves end at each point.
struct Ending {
    /// Points and curves (as places in a list), sorted.
    ends: Vec<(u32, u32)>,
    /// The points, and up to where among the ends theirs are yet to be taken.
    left: Vec<(u32, u32)>,
}

impl Ending {
    /// # Errors
    /// A point at which an odd number of curves end.
    fn at(curves: &[i32], ends_of: impl Fn(i32) -> [u32; 2]) -> Result<Self, u32> {
        let of_curve = |(i, &curve): (u32, &i32)| ends_of(curve).map(|point| (point, i));
        let mut ends: Vec<(u32, u32)> = (0..).zip(curves).flat_map(of_curve).collect();
        ends.sort_unstable();
        let mut left = Vec::with_capacity(curves.len());
        let mut count = 0;
        for at_point in ends.chunk_by(|(a, _), (b, _)| a == b) {
            let (point, _) = at_point[0];
            if at_point.len() % 2 == 1 {
                return Err(point);
            }
            count += at_point.len() as u32;
            left.push((point, count));
        }
        Ok(Self { ends, left })
    }

    /// The last curve at a point that is not used yet.
    fn next(&mut self, point: u32, used: &[bool]) -> Option<usize> {
        let place = first_place(&self.left, |&(point, _)| i64::from(point), i64::from(point));
        let (_, left) = self.left.get_mut(place)?;
        while let Some(before) = left.checked_sub(1) {
            let (at, curve) = self.ends[before as usize];
            if at != point {
                return None;
            }
            *left = before;
            if !used[curve as usize] {
                return Some(curve as usize);
            }
        }
        None
    }
}

/// A polygon that a contour becomes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Polygon {
    pub points: Vec<[f64; 2]>,
    /// Its smallest and its largest coordinates.
    pub least: [f64; 2],
    pub most: [f64; 2],
    pub area: f64,
}

impl Polygon {
    pub(super) fn new(points: Vec<[f64; 2]>) -> Self {
        let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in &points {
            for i in 0..2 {
                least[i] = least[i].min(p[i]);
                most[i] = most[i].max(p[i]);
            }
        }
        let area = 0.5 * super::chain::doubled_area(&points).abs();
        Self { points, least, most, area }
    }

    /// Its sides.
    pub(super) fn sides(&self) -> impl Iterator<Item = [[f64; 2]; 2]> + '_ {
        let next = self.points.iter().cycle().skip(1);
        self.points.iter().zip(next).map(|(&a, &b)| [a, b])
    }

    /// Whether a place that is not on it lies inside.
    pub(super) fn holds(&self, p: [f64; 2]) -> bool {
        let in_box = (0..2).all(|i| self.least[i] <= p[i] && p[i] <= self.most[i]);
        in_box && self.sides().filter(|&side| crosses_right_of(side, p)).count() % 2 == 1
    }
}

impl Polygon {
    /// Whether a side of this one meets a side of the other, or all but does.
    pub(super) fn meets(&self, other: &Self) -> bool {
        let boxes = |i: usize| self.least[i] <= other.most[i] && other.least[i] <= self.most[i];
        let near: Vec<[[f64; 2]; 2]> = match boxes(0) && boxes(1) {
            true => other.sides().filter(|side| reaches(*side, [self.least, self.most])).collect(),
            false => return false,
        };
        self.sides().any(|a| near.iter().any(|&b| reaches(a, b) && !is_apart(a, b)))
    }
}

/// Whether the boxes of two segments meet.
fn reaches([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    (0..2).all(|i| a[i].min(b[i]) <= c[i].max(d[i]) && c[i].min(d[i]) <= a[i].max(b[i]))
}

/// Whether one of two segments lies clearly on one side of the other.
fn is_apart(s: [[f64; 2]; 2], t: [[f64; 2]; 2]) -> bool {
    let beside = |[a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]| {
        let (c, d) = (side(a, b, c), side(a, b, d));
        c * d > 0.0
    };
    beside(s, t) || beside(t, s)
}

/// −1, 0 or 1: right of the line from `a` to `b`, near it, left of it.
fn side(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let (left, right) = (u[0] * v[1], u[1] * v[0]);
    let doubt = 1e-12 * (left.abs() + right.abs());
    if (left - right).abs() <= doubt { 0.0 } else { (left - right).signum() }
}

/// Whether a side crosses the ray from a place to the right.
fn crosses_right_of([a, b]: [[f64; 2]; 2], p: [f64; 2]) -> bool {
    (a[1] > p[1]) != (b[1] > p[1]) && p[0] < abscissa([a, b], p[1])
}

/// Where a side that is not level meets the height `y`.
pub(super) fn abscissa([a, b]: [[f64; 2]; 2], y: f64) -> f64 {
    a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
}
