//! Outlines that are anything but clean: segments that cross, overlap and touch, in any number.

use meshwright::Pslg;

use crate::Random;

/// A kind of tangled outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tangle {
    /// Short segments anywhere in the unit square.
    Soup,
    /// Two sets of parallel lines across the unit square.
    Hatch,
    /// Diameters of a circle: all cross at its center but for rounding.
    Star,
    /// Parallel lines that nothing but one other crosses: all their rectangles overlap.
    Fence,
    /// Stretches of a few lines, turned: on one line but for rounding, or beside each other.
    Stretches,
}

impl Tangle {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Soup, Self::Hatch, Self::Star, Self::Fence, Self::Stretches];

    /// The kind's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Soup => "soup",
            Self::Hatch => "hatch",
            Self::Star => "star",
            Self::Fence => "fence",
            Self::Stretches => "stretches",
        }
    }

    /// An outline of about so many segments; a soup has about so many crossings as well.
    #[must_use]
    pub fn outline(self, segments: usize, crossings: usize, random: &mut Random) -> Pslg {
        let mut points = Vec::with_capacity(2 * segments);
        match self {
            Self::Soup => {
                // Segments of length l at random: n²l²/π pairs cross.
                let count = segments as f64;
                let length = (crossings as f64 * std::f64::consts::PI).sqrt() / count;
                for _ in 0..segments {
                    let (start, turn) = ([random.unit(), random.unit()], random.direction());
                    points.extend([start, from(start, length, turn)]);
                }
            }
            Self::Hatch => {
                let at = |i: usize| (i as f64 + 0.37) / (segments / 2) as f64;
                for i in 0..segments / 2 {
                    points.extend([[at(i), -0.3], [at(i) + 0.11, 1.2]]);
                    points.extend([[-0.3, at(i)], [1.2, at(i) + 0.07]]);
                }
            }
            Self::Star => {
                for i in 0..segments {
                    let turn = std::f64::consts::PI * (i as f64 + 0.5) / segments as f64;
                    points.extend([from([0.3, 0.7], 1.0, turn), from([0.3, 0.7], -1.0, turn)]);
                }
            }
            Self::Fence => {
                for i in 1..segments {
                    let along = i as f64 / segments as f64;
                    points.extend([[along, 0.0], [along + 1.0, 1.0]]);
                }
                points.extend([[0.0, 0.5], [2.0, 0.503]]);
            }
            Self::Stretches => {
                for _ in 0..segments {
                    let (start, length) = (random.unit(), 0.1 * random.unit());
                    let offset = random.whole(0, 9) as f64 * f64::EPSILON / 8.0;
                    points.extend([start, start + length].map(|x| [x, x / 3.0 + offset]));
                }
            }
        }
        let count = points.len() as u32 / 2;
        Pslg {
            points,
            segments: (0..count).map(|i| [2 * i, 2 * i + 1]).collect(),
            segment_tags: vec![0; count as usize],
            ..Pslg::default()
        }
    }
}

/// The place at a distance from another one, in a direction (radians).
fn from([x, y]: [f64; 2], distance: f64, turn: f64) -> [f64; 2] {
    [x + distance * libm::cos(turn), y + distance * libm::sin(turn)]
}
