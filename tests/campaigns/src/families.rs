//! Families of random outlines, each nasty in one way.

use std::f64::consts::{PI, TAU};

use meshwright::Pslg;

use crate::figures::corners;
use crate::plane::{Point, between, polar};
use crate::random::Random;
use crate::sketch::Sketch;

/// A family of random outlines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Random points in a box, random segments between them that cross nothing.
    RandomPslg,
    /// Needle triangles in a box.
    Needles,
    /// Fans of many legs, hundredths of a degree to degrees apart.
    Fan,
    /// A star-shaped polygon whose radii jump between far and near.
    Star,
    /// A comb of thin teeth.
    Comb,
    /// Slits beside slits, each shorter and nearer than the one before.
    NestedSlits,
    /// A closed polygon that is one long thin wedge, with wedges inside.
    LongThinWedge,
    /// Squares of a lattice that share their sides, with holes, regions and dangling segments.
    Lattice,
}

impl Family {
    /// Every family.
    pub const ALL: [Self; 8] = [
        Self::RandomPslg,
        Self::Needles,
        Self::Fan,
        Self::Star,
        Self::Comb,
        Self::NestedSlits,
        Self::LongThinWedge,
        Self::Lattice,
    ];

    /// An outline of this family: of about `size` parts, its smallest angles about `theta`
    /// (radians) where the family has a say in them.
    #[must_use]
    pub fn outline(self, size: usize, theta: f64, seed: u64) -> Pslg {
        let random = &mut Random::new(seed);
        match self {
            Self::RandomPslg => random_pslg(size, random),
            Self::Needles => needles(size, theta, random),
            Self::Fan => fan(size, theta, random),
            Self::Star => star(size, theta, random),
            Self::Comb => comb(size, theta, random),
            Self::NestedSlits => nested_slits(size, random),
            Self::LongThinWedge => long_thin_wedge(size, theta, random),
            Self::Lattice => lattice(size, random),
        }
    }
}

/// Random points in the unit box and up to one and a half times as many segments between them; no
/// point is nearer than 1e-3 of a segment's length to it.
fn random_pslg(size: usize, random: &mut Random) -> Pslg {
    let mut sketch = boxed([0.0, 0.0], [1.0, 1.0], 1e-3);
    let first = sketch.next();
    for _ in 0..size {
        sketch.add(&[[random.unit(), random.unit()]], &[], 0);
    }
    let last = sketch.next() - 1;
    for _ in 0..size + size / 2 {
        if last > first {
            let ends = [
                random.whole(first as usize, last as usize) as u32,
                random.whole(first as usize, last as usize) as u32,
            ];
            sketch.add(&[], &[ends], 1);
        }
    }
    sketch.finish()
}

/// Triangles with one angle of about θ, anywhere in the box [−1, 2]².
fn needles(size: usize, theta: f64, random: &mut Random) -> Pslg {
    let mut sketch = boxed([-1.0, -1.0], [2.0, 2.0], 1e-3);
    for _ in 0..size {
        let apex = [random.range(-0.8, 1.8), random.range(-0.8, 1.8)];
        let (direction, length) = (random.direction(), random.range(0.2, 1.0));
        let angle = theta * random.range(0.5, 2.0);
        let other = length * random.range(0.6, 1.0);
        sketch.add_polygon(
            &[apex, polar(apex, direction, length), polar(apex, direction + angle, other)],
            1,
        );
    }
    sketch.finish()
}

/// One apex with many legs of random lengths, neighbours θ/2 to 2θ apart.
fn fan(size: usize, theta: f64, random: &mut Random) -> Pslg {
    let mut sketch = boxed([-1.0, -1.0], [2.0, 2.0], 1e-3);
    let apex = [random.range(-0.1, 0.3), random.range(-0.1, 0.3)];
    sketch.add(&[apex], &[], 0);
    let apex = sketch.next() - 1;
    let mut direction = random.direction();
    let start = direction;
    for _ in 0..size {
        let end = polar(sketch.point(apex), direction, random.range(0.1, 0.85));
        sketch.add_legs(apex, &[end], 1);
        direction += theta * random.range(0.5, 2.0);
        if direction > start + TAU - theta {
            break;
        }
    }
    sketch.finish()
}

/// A polygon whose corners lie by turns far from and near to the centre: spikes of about θ or
/// wider, as the number of corners has room for.
fn star(size: usize, theta: f64, random: &mut Random) -> Pslg {
    let spikes = size.clamp(3, 60);
    let step = TAU / (2 * spikes) as f64;
    // A spike's half angle at a tip of radius 1 above a base corner of radius r, `step` beside it,
    // is atan(r sin(step) / (1 − r cos(step))).
    let base = theta / 2.0;
    let smallest = libm::tan(base) / (libm::sin(step) + libm::tan(base) * libm::cos(step));
    let inner = smallest.clamp(1e-3, 0.8);
    let mut corners = Vec::new();
    for spike in 0..2 * spikes {
        let radius =
            if spike % 2 == 0 { random.range(0.7, 1.0) } else { inner * random.range(1.0, 1.2) };
        corners.push(polar([0.0, 0.0], step * (spike as f64 + random.range(-0.1, 0.1)), radius));
    }
    let mut sketch = Sketch::new(1e-5);
    sketch.add_polygon(&corners, 1);
    sketch.finish()
}

/// A bar with teeth that end in a point of about θ.
fn comb(size: usize, theta: f64, random: &mut Random) -> Pslg {
    let teeth = size.max(1);
    let mut corners: Vec<Point> = vec![[0.0, -1.0], [teeth as f64, -1.0]];
    for tooth in (0..teeth).rev() {
        let length = random.range(0.5, 2.0);
        let width = (2.0 * length * libm::tan(theta.min(1.0) / 2.0)).clamp(0.01, 0.9);
        let left = tooth as f64 + (1.0 - width) * random.range(0.2, 0.8);
        corners.extend([
            [left + width, 0.0],
            [left + width * random.range(0.4, 0.6), length],
            [left, 0.0],
        ]);
    }
    let mut sketch = Sketch::new(1e-4);
    sketch.add_polygon(&corners, 1);
    sketch.finish()
}

/// Parallel free segments in a box: each is a part of the one before, moved aside by a fraction of
/// its length.
fn nested_slits(size: usize, random: &mut Random) -> Pslg {
    let mut sketch = boxed([-1.0, -1.0], [2.0, 2.0], 1e-3);
    let (mut a, mut b) = ([-0.6, 0.1], [1.5, 0.1 + random.range(-0.2, 0.2)]);
    for _ in 0..size {
        sketch.add_chain(&[a, b], 1);
        let (p, q) =
            (between(a, b, random.range(0.02, 0.2)), between(a, b, random.range(0.8, 0.98)));
        let aside = random.range(0.02, 0.1) * crate::plane::distance(p, q);
        let normal = crate::plane::direction(a, b) + PI / 2.0;
        (a, b) = (polar(p, normal, aside), polar(q, normal, aside));
    }
    sketch.finish()
}

/// A triangle of length 1 with the angle θ, and wedges that stand on each other inside it.
fn long_thin_wedge(size: usize, theta: f64, random: &mut Random) -> Pslg {
    let apex = [0.0, 0.0];
    let turn = random.direction();
    let mut sketch = Sketch::new(1e-9);
    sketch.add_polygon(
        &[apex, polar(apex, turn, 1.0), polar(apex, turn + theta, random.range(0.9, 1.1))],
        1,
    );
    let (mut low, mut high) = (0.0, theta);
    for _ in 0..size.min(6) {
        let middle = low + (high - low) * random.range(0.3, 0.7);
        sketch.add_legs(0, &[polar(apex, turn + middle, random.range(0.1, 0.8))], 2);
        if random.chance(0.5) {
            low = middle;
        } else {
            high = middle;
        }
    }
    sketch.finish()
}

/// Squares of a lattice, each there with probability 0.8; some are holes, some are regions with
/// an area, some hold a diagonal dangling segment or a point.
fn lattice(size: usize, random: &mut Random) -> Pslg {
    let side = (size / 4).clamp(2, 8) as i32;
    let mut sketch = Sketch::new(1e-2);
    let node = |x: i32, y: i32| (y * (side + 1) + x) as u32;
    let nodes: Vec<Point> =
        (0..=side).flat_map(|y| (0..=side).map(move |x| [f64::from(x), f64::from(y)])).collect();
    sketch.add(&nodes, &[], 0);
    for y in 0..side {
        for x in 0..side {
            if (x > 0 || y > 0) && random.chance(0.2) {
                continue;
            }
            for (a, b) in [
                (node(x, y), node(x + 1, y)),
                (node(x + 1, y), node(x + 1, y + 1)),
                (node(x + 1, y + 1), node(x, y + 1)),
                (node(x, y + 1), node(x, y)),
            ] {
                let there = sketch.outline().segments.iter().any(|&s| s == [a, b] || s == [b, a]);
                if !there {
                    sketch.add(&[], &[[a, b]], 1 + (x + y) % 3);
                }
            }
            let centre = [f64::from(x) + 0.5, f64::from(y) + 0.5];
            match random.whole(0, 5) {
                0 if x + y > 0 => sketch.hole(centre),
                1 => sketch.region(
                    [centre[0], centre[1] + 0.2],
                    10 + x,
                    Some(random.log_range(0.01, 1.0)),
                ),
                2 => {
                    sketch.add_legs(
                        node(x, y),
                        &[[centre[0], centre[1] + random.range(-0.3, 0.3)]],
                        7,
                    );
                }
                3 => {
                    sketch.add(&[[centre[0] + random.range(-0.3, 0.3), centre[1]]], &[], 0);
                }
                _ => {}
            }
        }
    }
    sketch.finish()
}

/// A sketch that holds a box.
#[must_use]
pub fn boxed(low: Point, high: Point, margin: f64) -> Sketch {
    let mut sketch = Sketch::new(margin);
    sketch.add_polygon(&corners(low, high), 9);
    sketch
}
