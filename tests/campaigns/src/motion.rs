//! Moving an outline about: what a mesher must not mind.

use meshwright::Pslg;

use crate::plane::Point;
use crate::random::Random;

/// A similarity of the plane: mirror at the x axis or not, turn, scale, then offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Whether y changes its sign first.
    pub mirror: bool,
    /// The angle to turn by, in radians.
    pub turn: f64,
    /// The factor of all lengths.
    pub scale: f64,
    /// What is added at last.
    pub offset: Point,
}

impl Motion {
    /// Everything stays where it is.
    pub const NONE: Self = Self { mirror: false, turn: 0.0, scale: 1.0, offset: [0.0, 0.0] };

    /// A turn by an angle in radians.
    #[must_use]
    pub fn turn(turn: f64) -> Self {
        Self { turn, ..Self::NONE }
    }

    /// A change of scale.
    #[must_use]
    pub fn scale(scale: f64) -> Self {
        Self { scale, ..Self::NONE }
    }

    /// A translation.
    #[must_use]
    pub fn offset(offset: Point) -> Self {
        Self { offset, ..Self::NONE }
    }

    /// A reflection at the x axis.
    #[must_use]
    pub fn mirror() -> Self {
        Self { mirror: true, ..Self::NONE }
    }

    /// The outline moved; every coordinate is rounded, so that thin wedges may close.
    #[must_use]
    pub fn apply(&self, outline: &Pslg) -> Pslg {
        let (sin, cos) = (libm::sin(self.turn), libm::cos(self.turn));
        let mut moved = outline.clone();
        let seeds = moved.regions.iter_mut().map(|region| &mut region.seed);
        for point in moved.points.iter_mut().chain(&mut moved.holes).chain(seeds) {
            let [x, y] = [point[0], if self.mirror { -point[1] } else { point[1] }];
            // A turn by nothing leaves the bits alone.
            let turned =
                if self.turn == 0.0 { [x, y] } else { [cos * x - sin * y, sin * x + cos * y] };
            *point =
                [turned[0] * self.scale + self.offset[0], turned[1] * self.scale + self.offset[1]];
        }
        for region in &mut moved.regions {
            let scaled = |area: f64| area * self.scale * self.scale;
            // At 1e±300 an area is no double any more: no bound then.
            region.max_area = region.max_area.map(scaled).filter(|a| a.is_normal());
        }
        moved
    }
}

/// The same outline with its points and segments in random order, and its segments turned about at
/// random.
#[must_use]
pub fn renumbered(outline: &Pslg, random: &mut Random) -> Pslg {
    let mut old_points: Vec<u32> = (0..outline.points.len() as u32).collect();
    random.shuffle(&mut old_points);
    let mut new_numbers = vec![0; old_points.len()];
    for (new, &old) in old_points.iter().enumerate() {
        new_numbers[old as usize] = new as u32;
    }
    let mut order: Vec<usize> = (0..outline.segments.len()).collect();
    random.shuffle(&mut order);
    let mut renumbered = outline.clone();
    renumbered.points = old_points.iter().map(|&old| outline.points[old as usize]).collect();
    renumbered.segment_tags = order.iter().map(|&i| outline.segment_tags[i]).collect();
    renumbered.segments = order
        .iter()
        .map(|&i| {
            let [a, b] = outline.segments[i].map(|point| new_numbers[point as usize]);
            if random.chance(0.5) { [b, a] } else { [a, b] }
        })
        .collect();
    renumbered
}
