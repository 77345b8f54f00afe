//! Hostile outlines: many nasty things at once, and still clean.
//!
//! An outline starts as a closed *ground* (a frame, a blob, a spiky star, a lattice, a wheel, a
//! comb; now and then several of them) and gets *burdens*: wedges, hairs along other segments,
//! fans, slivers, slits, holes, near misses. [`Sketch`] takes a burden only if the outline stays
//! clean and disjoint features keep their distance; at last the outline is moved about.
//!
//! Two segments are *disjoint* if they have no common end. No two of them come nearer than
//! [`NEAREST`] of the longer one's length. The legs of an angle adjoin, so a wedge may be as thin
//! as 1e-9 rad. Thus the thinnest wedges have legs that end freely, or close with a third side.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use meshwright::Pslg;

use crate::families::boxed;
use crate::measure::{clear_of_segments, clearance, is_clean, smallest_angle};
use crate::motion::Motion;
use crate::plane::{Point, between, direction, distance, polar};
use crate::random::Random;
use crate::sketch::Sketch;

/// Disjoint features keep at least this part of the longer one's length between them.
pub const NEAREST: f64 = 1e-5;

/// How thin the wedges of an outline are.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Thinness {
    low: f64,
    high: f64,
}

impl Thinness {
    /// Of 100 outlines 40 have ordinary angles, 30 some of 1e-3° to 1°, 20 thinner ones down to
    /// 1e-7 rad, 10 still thinner ones.
    fn draw(random: &mut Random) -> Self {
        let (low, high) = match random.whole(0, 99) {
            0..40 => (1_f64.to_radians(), 50_f64.to_radians()),
            40..70 => (1e-3_f64.to_radians(), 1_f64.to_radians()),
            70..90 => (1e-7, 1e-3_f64.to_radians()),
            _ => (1e-9, 1e-7),
        };
        Self { low, high }
    }

    fn angle(self, random: &mut Random) -> f64 {
        random.log_range(self.low, self.high)
    }
}

/// The hostile outline number `index` of a seed: the same on every platform.
///
/// ```
/// use meshwright_campaigns::{hostile::hostile, measure::is_clean};
/// assert!(is_clean(&hostile(1, 0)));
/// assert_eq!(hostile(1, 7), hostile(1, 7));
/// ```
#[must_use]
pub fn hostile(seed: u64, index: u64) -> Pslg {
    let random = &mut Random::stream(seed, index);
    let thinness = Thinness::draw(random);
    let margin = *random.pick(&[0.03, 0.01, 1e-3, 1e-4, 1.1 * NEAREST]);
    let mut sketch = ground(margin, random);
    for _ in 0..random.whole(1, 8) {
        burden(&mut sketch, thinness, random);
    }
    if thinness.low < 1_f64.to_radians() {
        // One burden at least has the angle that the draw asks for.
        let _ = (0..20).any(|_| wedge(&mut sketch, thinness, random));
    }
    without_doubtful_seeds(moved(&sketch.finish(), random))
}

/// What a set of outlines is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Census {
    /// How many there are.
    pub outlines: u64,
    /// How many are not clean.
    pub unclean: u64,
    /// How many have disjoint features nearer than [`NEAREST`].
    pub too_near: u64,
    /// How many have θ* below 1°.
    pub under_a_degree: u64,
    /// How many have θ* below 1e-3°.
    pub under_a_millidegree: u64,
    /// How many have θ* below 1e-7 rad.
    pub under_1e_7: u64,
}

impl Census {
    /// Counts the hostile outlines of a seed with these numbers.
    #[must_use]
    pub fn of(seed: u64, numbers: std::ops::Range<u64>) -> Self {
        let mut census = Self::default();
        for outline in numbers.map(|number| hostile(seed, number)) {
            let theta = smallest_angle(&outline).unwrap_or(PI);
            census.outlines += 1;
            census.unclean += u64::from(!is_clean(&outline));
            census.too_near += u64::from(clearance(&outline) < NEAREST);
            census.under_a_degree += u64::from(theta.to_degrees() < 1.0);
            census.under_a_millidegree += u64::from(theta.to_degrees() < 1e-3);
            census.under_1e_7 += u64::from(theta < 1e-7);
        }
        census
    }

    /// Whether all are clean and keep their distance, and enough of them have small angles: a
    /// fifth below 1°, a twentieth below 1e-3°, a hundredth below 1e-7 rad (of fewer than 200 that is not asked).
    #[must_use]
    pub fn is_hostile_enough(&self) -> bool {
        let sound = self.unclean == 0 && self.too_near == 0;
        let few = self.outlines < 200;
        sound
            && (few
                || self.under_a_degree * 5 >= self.outlines
                    && self.under_a_millidegree * 20 >= self.outlines
                    && self.under_1e_7 * 100 >= self.outlines)
    }
}

impl std::fmt::Display for Census {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let percent = |part: u64| 100.0 * part as f64 / self.outlines.max(1) as f64;
        write!(
            f,
            "{} outlines: {} not clean, {} with disjoint features too near; θ* < 1°: {:.1} %, \
             < 1e-3°: {:.1} %, < 1e-7 rad: {:.1} %",
            self.outlines,
            self.unclean,
            self.too_near,
            percent(self.under_a_degree),
            percent(self.under_a_millidegree),
            percent(self.under_1e_7)
        )
    }
}

// Grounds.

fn ground(margin: f64, random: &mut Random) -> Sketch {
    match random.whole(0, 9) {
        0 | 1 => boxed([-1.0, -1.0], [1.0, 1.0], margin),
        2 | 3 => polygon(&blob([0.0, 0.0], 1.0, random), margin),
        4 => polygon(&spiky_star([0.0, 0.0], 1.0, random), margin),
        5 => lattice(margin, random),
        6 => triangles(margin, random),
        7 => wheel(margin, random),
        8 => polygon(&comb(random), margin),
        _ => archipelago(margin, random),
    }
}

fn polygon(corners: &[Point], margin: f64) -> Sketch {
    let mut sketch = Sketch::new(margin);
    if !sketch.add_polygon(corners, 1) {
        // Its own features came too near to each other.
        return boxed([-1.0, -1.0], [1.0, 1.0], margin);
    }
    sketch
}

/// A star-shaped polygon, corners in counter-clockwise order.
fn blob(centre: Point, radius: f64, random: &mut Random) -> Vec<Point> {
    let count = random.whole(3, 24);
    let step = TAU / count as f64;
    let start = random.direction();
    (0..count)
        .map(|i| {
            let direction = start + step * (i as f64 + random.range(-0.3, 0.3));
            polar(centre, direction, radius * random.range(0.55, 1.0))
        })
        .collect()
}

/// Needles that point outwards, or inwards, at every second corner.
fn spiky_star(centre: Point, radius: f64, random: &mut Random) -> Vec<Point> {
    let spikes = random.whole(3, 16);
    let step = TAU / spikes as f64;
    let outwards = random.chance(0.5);
    (0..spikes)
        .flat_map(|i| {
            let towards = step * i as f64;
            let (tip, foot) = if outwards {
                (random.range(0.7, 1.0), 0.4)
            } else {
                (random.range(0.1, 0.5), 0.9)
            };
            let width = random.log_range(0.003, 0.4) * step;
            [
                polar(centre, towards - width, radius * foot),
                polar(centre, towards, radius * tip),
                polar(centre, towards + width, radius * foot),
            ]
        })
        .collect()
}

/// Squares of a lattice with common sides: angles of exactly 90° and 180°, regions, holes.
fn lattice(margin: f64, random: &mut Random) -> Sketch {
    let (columns, rows) = (random.whole(1, 4) as i32, random.whole(1, 4) as i32);
    let cell = 0.5;
    let mut sketch = Sketch::new(margin);
    let node = |x: i32, y: i32| (y * (columns + 1) + x) as u32;
    let nodes: Vec<Point> = (0..=rows)
        .flat_map(|y| {
            (0..=columns).map(move |x| [f64::from(x) * cell - 1.0, f64::from(y) * cell - 1.0])
        })
        .collect();
    sketch.add(&nodes, &[], 0);
    for y in 0..rows {
        for x in 0..columns {
            let centre = [(f64::from(x) + 0.5) * cell - 1.0, (f64::from(y) + 0.47) * cell - 1.0];
            let first = x == 0 && y == 0;
            if !first && random.chance(0.15) {
                continue;
            }
            for side in [
                [node(x, y), node(x + 1, y)],
                [node(x + 1, y), node(x + 1, y + 1)],
                [node(x + 1, y + 1), node(x, y + 1)],
                [node(x, y + 1), node(x, y)],
            ] {
                if !has_segment(&sketch, side) {
                    sketch.add(&[], &[side], 1 + (x + y) % 3);
                }
            }
            if !first && random.chance(0.15) {
                sketch.hole(centre);
            } else if random.chance(0.4) {
                let area = random.chance(0.5).then(|| random.log_range(0.003, 0.3));
                sketch.region(centre, 10 + 4 * y + x, area);
            }
        }
    }
    sketch
}

fn has_segment(sketch: &Sketch, [a, b]: [u32; 2]) -> bool {
    sketch.outline().segments.iter().any(|&s| s == [a, b] || s == [b, a])
}

/// A strip of equilateral triangles with common sides: angles of 60°, as near as doubles come.
fn triangles(margin: f64, random: &mut Random) -> Sketch {
    let count = random.whole(1, 9) as u32;
    let height = 0.375 * libm::sqrt(3.0);
    let nodes: Vec<Point> = (0..count + 2)
        .map(|i| [f64::from(i) * 0.375 - 1.0, if i % 2 == 0 { 0.0 } else { height }])
        .collect();
    let mut sides = vec![[0, 1]];
    for i in 0..count {
        sides.push([i, i + 2]);
        sides.push([i + 1, i + 2]);
    }
    let mut sketch = Sketch::new(margin);
    sketch.add(&nodes, &sides, 1);
    for i in 0..count {
        if random.chance(0.3) {
            let corner = |k: u32| nodes[(i + k) as usize];
            let centre = between(between(corner(0), corner(1), 0.5), corner(2), 0.35);
            sketch.region(centre, i as i32 + 1, Some(random.log_range(0.002, 0.2)));
        }
    }
    sketch
}

/// A blob whose corners are all joined to its centre.
fn wheel(margin: f64, random: &mut Random) -> Sketch {
    let rim = blob([0.0, 0.0], 1.0, random);
    let mut sketch = polygon(&rim, margin);
    let hub = sketch.next();
    let spokes: Vec<_> = (0..hub).map(|corner| [hub, corner]).collect();
    sketch.add(&[[random.range(-0.1, 0.1), random.range(-0.1, 0.1)]], &spokes, 2);
    sketch
}

/// A bar with pointed teeth.
fn comb(random: &mut Random) -> Vec<Point> {
    let teeth = random.whole(1, 10);
    let pitch = 2.0 / teeth as f64;
    let mut corners = vec![[-1.0, -0.5], [1.0, -0.5], [1.0, 0.0]];
    for tooth in (0..teeth).rev() {
        let left = -1.0 + pitch * (tooth as f64 + 0.1);
        let width = pitch * random.log_range(0.01, 0.7);
        let tip = [left + width * random.range(0.2, 0.8), random.range(0.3, 1.0)];
        corners.extend([[left + width, 0.0], tip, [left, 0.0]]);
    }
    corners.push([-1.0, 0.0]);
    corners
}

/// Two to four islands; the first may have others inside it.
fn archipelago(margin: f64, random: &mut Random) -> Sketch {
    let mut sketch = polygon(&blob([0.0, 0.0], 1.0, random), margin);
    for _ in 0..random.whole(1, 3) {
        let centre = [random.range(-2.0, 2.0), random.range(-2.0, 2.0)];
        let radius = random.log_range(0.05, 0.7);
        let island = if random.chance(0.5) {
            blob(centre, radius, random)
        } else {
            spiky_star(centre, radius, random)
        };
        sketch.add_polygon(&island, 2);
    }
    sketch
}

// Burdens.

fn burden(sketch: &mut Sketch, thinness: Thinness, random: &mut Random) {
    match random.whole(0, 11) {
        0 | 1 => wedge(sketch, thinness, random),
        2 => hair(sketch, thinness, random),
        3 => fan(sketch, thinness, random),
        4 => sliver(sketch, thinness, random),
        5 => tower(sketch, random),
        6 => collinear_chain(sketch, random),
        7 => slits(sketch, random),
        8 => points(sketch, random),
        9 => hole(sketch, random),
        10 => near_miss(sketch, random),
        _ => slit_from_corner(sketch, random),
    };
}

fn somewhere(random: &mut Random) -> Point {
    [random.range(-0.9, 0.9), random.range(-0.9, 0.9)]
}

fn some_corner(sketch: &Sketch, random: &mut Random) -> u32 {
    random.pick(&sketch.outline().segments)[random.whole(0, 1)]
}

/// Two to four legs from a new or an old point, each θ from the one before.
fn wedge(sketch: &mut Sketch, thinness: Thinness, random: &mut Random) -> bool {
    if random.chance(0.3) {
        return hair(sketch, thinness, random);
    }
    let mut points = Vec::new();
    let (apex, place) = if random.chance(0.6) {
        points.push(somewhere(random));
        (sketch.next(), points[0])
    } else {
        let corner = some_corner(sketch, random);
        (corner, sketch.point(corner))
    };
    let length = random.log_range(0.05, 0.8);
    let mut towards = random.direction();
    let mut segments = Vec::new();
    for _ in 0..random.whole(2, 4) {
        segments.push([apex, sketch.next() + points.len() as u32]);
        points.push(polar(place, towards, length * random.range(0.3, 1.0)));
        towards += thinness.angle(random);
    }
    sketch.add(&points, &segments, 3)
}

/// A leg beside an old segment, from the same end, shorter than it, so that the old one may go on
/// where it ends; sometimes a needle triangle.
fn hair(sketch: &mut Sketch, thinness: Thinness, random: &mut Random) -> bool {
    let [a, b] = *random.pick(&sketch.outline().segments);
    let (root, tip) = if random.chance(0.5) { (a, b) } else { (b, a) };
    let (x, y) = (sketch.point(root), sketch.point(tip));
    let side = if random.chance(0.5) { 1.0 } else { -1.0 };
    let theta = side * thinness.angle(random);
    let length = distance(x, y) * random.range(0.2, 0.85);
    let first = polar(x, direction(x, y) + theta, length);
    if random.chance(0.4) {
        let second = polar(
            x,
            direction(x, y) + theta * random.range(1.5, 3.0),
            length * random.range(0.5, 1.1),
        );
        let next = sketch.next();
        return sketch.add(
            &[first, second],
            &[[root, next], [root, next + 1], [next, next + 1]],
            4,
        );
    }
    sketch.add_legs(root, &[first], 4)
}

/// Up to 40 legs around one point.
fn fan(sketch: &mut Sketch, thinness: Thinness, random: &mut Random) -> bool {
    let apex = somewhere(random);
    let count = random.whole(5, 40);
    let length = random.range(0.1, 0.6);
    let mut towards = random.direction();
    let ends: Vec<Point> = (0..count)
        .map(|_| {
            towards += if random.chance(0.7) {
                TAU / count as f64 * random.range(0.3, 1.0)
            } else {
                thinness.angle(random).min(1.0 / count as f64)
            };
            polar(apex, towards, length * random.range(0.3, 1.0))
        })
        .collect();
    sketch.add(&[apex], &[], 0) && sketch.add_legs(sketch.next() - 1, &ends, 5)
}

/// A free triangle with one or two thin angles.
fn sliver(sketch: &mut Sketch, thinness: Thinness, random: &mut Random) -> bool {
    let apex = somewhere(random);
    let (towards, length) = (random.direction(), random.log_range(0.05, 0.8));
    let corners = [
        apex,
        polar(apex, towards, length),
        polar(apex, towards + thinness.angle(random), length * random.range(0.2, 1.0)),
    ];
    sketch.add_polygon(&corners, 6)
}

/// Wedges on wedges: each leg's end is the apex of the next, smaller wedge.
fn tower(sketch: &mut Sketch, random: &mut Random) -> bool {
    let mut length = random.range(0.2, 0.6);
    let mut towards = random.direction();
    let mut apex = sketch.next();
    if !sketch.add(&[somewhere(random)], &[], 0) {
        return false;
    }
    for _ in 0..random.whole(2, 6) {
        let theta = random.log_range(0.01, 0.6);
        let (x, y) = (sketch.point(apex), towards + theta);
        let ends = [polar(x, towards, length), polar(x, y, length * random.range(0.5, 1.2))];
        if !sketch.add_legs(apex, &ends, 7) {
            return false;
        }
        apex = sketch.next() - 1 - random.whole(0, 1) as u32;
        towards += random.range(-0.5, 0.5) + if random.chance(0.2) { FRAC_PI_2 } else { 0.0 };
        length *= random.range(0.2, 0.7);
    }
    true
}

/// A chain of segments on one line: at multiples of 1/64, so that the angles are 180° exactly, or
/// as rounding has it.
fn collinear_chain(sketch: &mut Sketch, random: &mut Random) -> bool {
    let exact = random.chance(0.6);
    let count = random.whole(3, 8);
    let start = somewhere(random).map(|c| if exact { (c * 64.0).round() / 64.0 } else { c });
    let step = if exact {
        [random.whole(0, 8) as f64 / 64.0, (random.whole(1, 8) as f64 - 4.0) / 64.0]
    } else {
        polar([0.0, 0.0], random.direction(), random.log_range(0.01, 0.2))
    };
    let mut at = 0.0;
    let chain: Vec<Point> = (0..count)
        .map(|_| {
            let point = [start[0] + at * step[0], start[1] + at * step[1]];
            at += random.whole(1, 4) as f64;
            point
        })
        .collect();
    sketch.add_chain(&chain, 8)
}

/// Parallel free segments: the gap is a hundredth or more of the length, once in a while less.
fn slits(sketch: &mut Sketch, random: &mut Random) -> bool {
    let (mut a, towards) = (somewhere(random), random.direction());
    let length = random.log_range(0.05, 0.8);
    let gap = length
        * if random.chance(0.1) {
            random.log_range(2e-4, 0.01)
        } else {
            random.log_range(0.01, 0.2)
        };
    let mut any = false;
    for _ in 0..random.whole(2, 5) {
        let shift = length * random.range(-0.2, 0.2);
        let from = polar(a, towards, shift);
        any |= sketch.add_chain(&[from, polar(from, towards, length * random.range(0.4, 1.0))], 10);
        a = polar(a, towards + FRAC_PI_2, gap);
    }
    any
}

/// Isolated points, wide apart or close together.
fn points(sketch: &mut Sketch, random: &mut Random) -> bool {
    let (centre, spread) = (somewhere(random), random.log_range(1e-3, 0.5));
    let mut any = false;
    for _ in 0..random.whole(1, 12) {
        let point = polar(centre, random.direction(), spread * random.unit());
        any |= sketch.add(&[point], &[], 0);
    }
    any
}

/// A small hole, sometimes a needle, sometimes with a corner of the outline as its own.
fn hole(sketch: &mut Sketch, random: &mut Random) -> bool {
    let towards = random.direction();
    let length = random.log_range(0.01, 0.3);
    let width =
        if random.chance(0.5) { random.log_range(1e-4, 0.1) } else { random.range(0.3, 1.0) };
    let old_corner = random.chance(0.25);
    let corner = some_corner(sketch, random);
    let first = if old_corner { sketch.point(corner) } else { somewhere(random) };
    let second = polar(first, towards, length);
    let third = polar(first, towards + width, length * random.range(0.5, 1.0));
    let next = sketch.next();
    let added = if old_corner {
        sketch.add(&[second, third], &[[corner, next], [next, next + 1], [next + 1, corner]], 11)
    } else {
        sketch.add_polygon(&[first, second, third], 11)
    };
    if added {
        sketch.hole(between(between(first, second, 0.5), third, 0.3));
    }
    added
}

/// A point, or the end of a segment, just beside the middle of an old segment.
fn near_miss(sketch: &mut Sketch, random: &mut Random) -> bool {
    let [a, b] = *random.pick(&sketch.outline().segments);
    let (p, q) = (sketch.point(a), sketch.point(b));
    let gap = distance(p, q) * random.log_range(1.2 * NEAREST, 0.05);
    let normal = direction(p, q) + FRAC_PI_2;
    let near = polar(between(p, q, random.range(0.1, 0.9)), normal, gap);
    if random.chance(0.5) {
        return sketch.add(&[near], &[], 0);
    }
    let towards = normal + random.range(-0.45, 0.45) * PI;
    sketch.add_chain(&[near, polar(near, towards, random.log_range(0.02, 0.5))], 12)
}

/// A dangling segment from an old corner, or one that joins two of them.
fn slit_from_corner(sketch: &mut Sketch, random: &mut Random) -> bool {
    let from = some_corner(sketch, random);
    let to = some_corner(sketch, random);
    if random.chance(0.5) && from != to && !has_segment(sketch, [from, to]) {
        return sketch.add(&[], &[[from, to]], 13);
    }
    let end = polar(sketch.point(from), random.direction(), random.log_range(0.02, 0.8));
    sketch.add_legs(from, &[end], 13)
}

/// Leaves out the seeds of holes and regions that lie on a segment: they do not say which side is
/// meant. A burden may have come to lie there after them.
fn without_doubtful_seeds(mut outline: Pslg) -> Pslg {
    let mut clear = clear_of_segments(&outline, &outline.holes).into_iter();
    outline.holes.retain(|_| clear.next() == Some(true));
    let seeds: Vec<Point> = outline.regions.iter().map(|region| region.seed).collect();
    let mut clear = clear_of_segments(&outline, &seeds).into_iter();
    outline.regions.retain(|_| clear.next() == Some(true));
    outline
}

// Motions.

/// The outline somewhere else, turned and of another size; where rounding would close a wedge or
/// bring features together, it stays as it is.
fn moved(outline: &Pslg, random: &mut Random) -> Pslg {
    let mut motion = Motion { mirror: random.chance(0.2), ..Motion::NONE };
    if random.chance(0.5) {
        motion.turn = random.direction();
    }
    match random.whole(0, 9) {
        0 | 1 => motion.scale = random.log_range(1e-6, 1e6),
        2 => motion.scale = *random.pick(&[1e-300, 1e-150, 1e-80, 1e80, 1e150, 1e300]),
        3 => motion.scale = libm::scalbn(1.0, random.whole(0, 60) as i32 - 30),
        4 | 5 => {
            let size = random.log_range(1.0, 1e3);
            motion.offset = [size * random.range(-1.0, 1.0), size * random.range(-1.0, 1.0)];
        }
        6 => {
            // A map's metres.
            motion.scale = random.log_range(10.0, 1e4);
            motion.offset = [random.range(1e5, 9e5), random.range(1e6, 9e6)];
        }
        _ => {}
    }
    let moved = motion.apply(outline);
    if is_clean(&moved) && clearance(&moved) >= NEAREST { moved } else { outline.clone() }
}
