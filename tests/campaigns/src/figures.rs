//! Outlines with a name: those that a figure is known for.

use meshwright::Pslg;

use crate::motion::Motion;
use crate::plane::{Point, polar};
use crate::random::Random;

/// An outline of untagged segments.
#[must_use]
pub fn outline(points: Vec<Point>, segments: Vec<[u32; 2]>) -> Pslg {
    let segment_tags = vec![0; segments.len()];
    Pslg { points, segments, segment_tags, ..Pslg::default() }
}

/// The corners of a box, counter-clockwise.
#[must_use]
pub fn corners(low: Point, high: Point) -> [Point; 4] {
    [low, [high[0], low[1]], high, [low[0], high[1]]]
}

/// An outline without its holes in the middle of a box that is larger by its size on every side: the
/// box is the convex hull, as Assumption 1 (iv) of the paper wants it.
#[must_use]
pub fn in_a_box(inner: &Pslg) -> Pslg {
    let bound = |axis: usize, pick: fn(f64, f64) -> f64| {
        inner.points.iter().map(|p| p[axis]).reduce(pick).unwrap_or(0.0)
    };
    let low = [0, 1].map(|axis| bound(axis, f64::min));
    let high = [0, 1].map(|axis| bound(axis, f64::max));
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let mut boxed = Pslg { holes: Vec::new(), ..inner.clone() };
    let first = boxed.points.len() as u32;
    boxed.points.extend(corners(low.map(|c| c - size), high.map(|c| c + size)));
    boxed.segments.extend((0..4).map(|i| [first + i, first + (i + 1) % 4]));
    boxed.segment_tags.extend([0; 4]);
    boxed
}

/// One wedge: two segments that make `theta` (radians) at the origin, of lengths 1 and 0.83, the
/// first at 0.3 rad from the x axis, in the box [−1, 2]².
#[must_use]
pub fn wedge(theta: f64) -> Pslg {
    let mut points = corners([-1.0, -1.0], [2.0, 2.0]).to_vec();
    points.extend([[0.0, 0.0], polar([0.0, 0.0], 0.3, 1.0), polar([0.0, 0.0], 0.3 + theta, 0.83)]);
    outline(points, vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [4, 6]])
}

/// The paper's input of Figures 11 and 12: 20 segments from the middle of the unit box in random
/// directions, of lengths 1/4 to 3/8.
#[must_use]
pub fn spokes(count: usize, random: &mut Random) -> Pslg {
    let centre = [0.5, 0.5];
    let mut points = corners([0.0, 0.0], [1.0, 1.0]).to_vec();
    points.push(centre);
    let mut segments = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    for _ in 0..count {
        segments.push([4, points.len() as u32]);
        let direction = random.direction();
        points.push(polar(centre, direction, random.range(0.25, 0.375)));
    }
    outline(points, segments)
}

/// 20 spokes whose closest pair makes 0.85–1.0°, as the paper's does (0.92°): of the draws of this
/// seed's stream the first that has it.
#[must_use]
pub fn spokes20(seed: u64) -> Pslg {
    let mut random = Random::new(seed);
    loop {
        let drawn = spokes(20, &mut random);
        let smallest = crate::measure::smallest_angle(&drawn).unwrap_or(0.0).to_degrees();
        if (0.85..=1.0).contains(&smallest) {
            return drawn;
        }
    }
}

/// A square of `cells × cells` unit squares, all sides segments, turned by `turn` radians.
#[must_use]
pub fn grid(cells: u32, turn: f64) -> Pslg {
    let side = cells + 1;
    let mut points = Vec::new();
    let mut segments = Vec::new();
    for y in 0..side {
        for x in 0..side {
            points.push([f64::from(x), f64::from(y)]);
            let here = y * side + x;
            if x > 0 {
                segments.push([here - 1, here]);
            }
            if y > 0 {
                segments.push([here - side, here]);
            }
        }
    }
    Motion::turn(turn).apply(&outline(points, segments))
}

/// The points of [`grid`], with the boundary alone as segments.
#[must_use]
pub fn grid_points(cells: u32, turn: f64) -> Pslg {
    let mut grid = grid(cells, turn);
    let edge = |i: u32| i == 0 || i == cells;
    let side = cells + 1;
    grid.segments.retain(|&[a, b]| {
        let (ax, ay, bx, by) = (a % side, a / side, b % side, b / side);
        (ax == bx && edge(ax)) || (ay == by && edge(ay))
    });
    grid.segment_tags.truncate(grid.segments.len());
    grid
}

/// A plate of 4 × 3 with details of a thousandth at coordinates of five million, as drawings in
/// millimetres within a map's metres have: slots, a comb of teeth, bolt holes, a notch of 2°.
#[must_use]
pub fn millimetres_at_five_million() -> Pslg {
    let mut points = corners([0.0, 0.0], [4.0, 3.0]).to_vec();
    let mut segments = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    let mut holes = Vec::new();
    for i in 0..4 {
        let (x, y) = (0.5 + f64::from(i), 0.5 + 0.5 * f64::from(i));
        let first = points.len() as u32;
        points.extend(corners([x, y], [x + 0.25, y + 0.001])); // a slot
        holes.push([x + 0.125, y + 0.0005]);
        segments.extend((0..4).map(|k| [first + k, first + (k + 1) % 4]));
        let first = points.len() as u32;
        points.extend((0..12).map(|k| {
            polar([x, y + 0.3], std::f64::consts::TAU * f64::from(k) / 12.0, 0.002) // a bolt hole
        }));
        holes.push([x, y + 0.3]);
        segments.extend((0..12).map(|k| [first + k, first + (k + 1) % 12]));
    }
    let first = points.len() as u32;
    for tooth in 0..20 {
        let x = 1.0 + 0.002 * f64::from(tooth);
        points.extend([[x, 2.5], [x + 0.001, 2.503]]);
    }
    segments.extend((first + 1..points.len() as u32).map(|k| [k - 1, k]));
    let first = points.len() as u32;
    points.extend([[3.0, 0.25], [3.004, 0.25], polar([3.0, 0.25], 2.0_f64.to_radians(), 0.003)]);
    segments.extend([[first, first + 1], [first, first + 2]]);
    let plate = Pslg { holes, ..outline(points, segments) };
    Motion::offset([5e6, 5e6]).apply(&plate)
}
