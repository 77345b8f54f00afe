//! Which triangles are bad, and which of their angles triggers.

use crate::constructions::Angle;
use crate::corners::{each, next, previous};
use crate::order::greater;
use crate::parameters::MinAngle;
use crate::predicates::Relative;

/// A quick look at the triangle of the point that `a` and `b` are seen from: whether its smallest
/// angle may be below κ̂. Rounded, and only a filter: [`trigger`] decides.
#[inline]
#[must_use]
pub fn may_be_small(a: Relative, b: Relative, kappa: MinAngle) -> bool {
    let (cross, dot) = (a.cross(b), a.dot(b));
    // |·||·|cos of the three angles: all have the same |·||·|sin, so the largest is the smallest
    // angle's.
    let largest = greater(dot, greater(a.squared - dot, b.squared - dot));
    may_be_below(cross, largest, kappa)
}

/// Whether an angle may be below κ̂, by its rounded sine and cosine up to a common factor.
#[inline]
fn may_be_below(cross: f64, dot: f64, kappa: MinAngle) -> bool {
    (dot > 0.0)
        & (kappa.denominator * (cross * cross) <= (kappa.numerator * 1.000_000_1) * (dot * dot))
}

/// What a quick look at a triangle tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Look {
    /// Nothing is bad about it.
    Fine,
    /// The angle opposite its shortest edge is too small.
    Small {
        /// That edge: 0, 1 or 2.
        edge: usize,
        /// Its squared length.
        squared: f64,
        /// Whether no other edge is as short, whatever rounding did.
        is_clear: bool,
    },
    /// The angle is too close to κ̂ for rounded numbers.
    Unsure,
}

/// A quick look at the angles of the triangle of the point that `a` and `b` are seen from, which is
/// its corner 0; `cross` is their cross product.
#[inline(always)]
#[must_use]
pub fn look(cross: f64, [a, b]: [Relative; 2], kappa: MinAngle) -> Look {
    let dot = a.dot(b);
    // By |·||·|cos of the three angles as above.
    let cosines @ [_, at_a, at_b] = [dot, a.squared - dot, b.squared - dot];
    let largest = greater(dot, greater(at_a, at_b));
    if !may_be_below(cross, largest, kappa) {
        Look::Fine
    } else if kappa.denominator * (cross * cross)
        < (kappa.numerator * 0.999_999_9) * (largest * largest)
    {
        // The edge opposite the angle that has it.
        let edge = if dot == largest { 0 } else { 2 - usize::from(at_a == largest) };
        // These differ by what the squared lengths of the edges opposite do.
        let near = largest - 1e-12 * (a.squared + b.squared);
        let is_clear = cosines.iter().filter(|&&cosine| cosine > near).count() == 1;
        Look::Small { edge, squared: squared_edges(a, b)[edge], is_clear }
    } else {
        Look::Unsure
    }
}

/// The shortest edge of that triangle, with its squared length.
#[inline]
#[must_use]
pub fn shortest(a: Relative, b: Relative) -> (usize, f64) {
    let [first, second, third] = squared_edges(a, b);
    // Of equals the first.
    let (edge, squared) = if second < first { (1, second) } else { (0, first) };
    if third < squared { (2, third) } else { (edge, squared) }
}

/// The squared lengths of the edges opposite the point that `a` and `b` are seen from, `a` and `b`.
#[inline]
#[must_use]
fn squared_edges(a: Relative, b: Relative) -> [f64; 3] {
    let (x, y) = (a.x - b.x, a.y - b.y);
    [x * x + y * y, b.squared, a.squared]
}

/// The angle for whose sake a triangle is removed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trigger {
    /// The edge opposite the angle: 0, 1 or 2.
    pub edge: usize,
    /// Its squared length.
    pub squared: f64,
    /// The angle.
    pub angle: Angle,
    /// Whether the triangle is only too large: the angle is its smallest one.
    pub only_size: bool,
}

impl Trigger {
    /// The angle of a triangle opposite an edge.
    #[must_use]
    pub fn opposite(corners: [[f64; 2]; 3], edge: usize) -> Self {
        Self::with(Angle::at, corners, edge)
    }

    /// The same of a triangle that is known to be bad: the angle only tells where its Steiner point
    /// goes, and is rounded.
    #[inline]
    #[must_use]
    pub fn known(corners: [[f64; 2]; 3], edge: usize) -> Self {
        Self::with(Angle::rounded, corners, edge)
    }

    #[inline(always)]
    fn with(
        angle_at: impl Fn([f64; 2], [f64; 2], [f64; 2]) -> Angle,
        corners: [[f64; 2]; 3],
        edge: usize,
    ) -> Self {
        let [x, a, b] = [edge, next(edge), previous(edge)].map(|i| corners[i]);
        let (squared, angle) = (Relative::of(a, b).squared, angle_at(x, a, b));
        Self { edge, squared, angle, only_size: false }
    }
}

/// The smallest angle of a counter-clockwise triangle that is below κ̂ and not excused: `excused`
/// is asked with the edge opposite an angle.
///
/// All three angles are looked at: a triangle is left alone only if every small one is excused.
#[must_use]
pub fn trigger(
    corners: [[f64; 2]; 3],
    kappa: MinAngle,
    mut excused: impl FnMut(usize, Angle) -> bool,
) -> Option<Trigger> {
    // The largest angle is at least 60°: it is never small.
    edges_by_length(corners)[..2].iter().find_map(|&(edge, _)| {
        let seen = |i: usize| Relative::of(corners[i], corners[edge]);
        let (p, q) = (seen(next(edge)), seen(previous(edge)));
        if !may_be_below(p.cross(q), p.dot(q), kappa) {
            return None;
        }
        let trigger = Trigger::opposite(corners, edge);
        let bad = trigger.angle.is_below(kappa) && !excused(edge, trigger.angle);
        bad.then_some(trigger)
    })
}

/// The trigger of a triangle that is only too large: its smallest angle.
#[must_use]
pub fn by_size(corners: [[f64; 2]; 3]) -> Trigger {
    let (edge, _) = edges_by_length(corners)[0];
    Trigger { only_size: true, ..Trigger::opposite(corners, edge) }
}

/// The edges of a triangle with their squared lengths, the shortest first.
fn edges_by_length(corners: [[f64; 2]; 3]) -> [(usize, f64); 3] {
    let [mut first, mut second, mut third] = each([0, 1, 2], |edge| {
        (edge, Relative::of(corners[next(edge)], corners[previous(edge)]).squared)
    });
    // Equals stay as they are.
    if second.1 < first.1 {
        (first, second) = (second, first);
    }
    if third.1 < second.1 {
        (second, third) = (third, second);
        if second.1 < first.1 {
            (first, second) = (second, first);
        }
    }
    [first, second, third]
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEEDLE: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.1]];
    const FLAT: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 0.0], [0.9, 0.1]];

    #[test]
    fn the_smallest_angle_triggers() {
        let found = trigger(NEEDLE, MinAngle::default(), |_, _| false).map(|t| t.edge);
        assert_eq!(found, Some(0));
    }

    #[test]
    fn a_needle_with_its_angle_excused_is_left_alone() {
        assert_eq!(trigger(NEEDLE, MinAngle::default(), |edge, _| edge == 0), None);
    }

    #[test]
    fn the_second_angle_of_a_flat_triangle_triggers_when_the_first_is_excused() {
        let smallest = trigger(FLAT, MinAngle::default(), |_, _| false).map(|t| t.edge);
        let second = trigger(FLAT, MinAngle::default(), |edge, _| Some(edge) == smallest);
        assert_eq!((smallest, second.map(|t| t.edge)), (Some(1), Some(0)));
    }

    fn look_at(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> Look {
        let [a, b] = [a, b].map(|v| Relative::of(v, p));
        look(a.cross(b), [a, b], MinAngle::default())
    }

    #[test]
    fn a_look_tells_what_the_trigger_tells_or_that_it_is_unsure() {
        let kappa = MinAngle::default();
        let mut counts = [0; 3];
        for step in 0..4000 {
            let height = f64::from(step) / 2000.0;
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.3 + 0.1 * height, height + 1e-3]];
            let [p, a, b] = corners;
            let looked = look_at(a, b, p);
            let found = trigger(corners, kappa, |_, _| false);
            match (looked, found) {
                (Look::Fine, None) => counts[0] += 1,
                (Look::Small { edge, squared, is_clear }, Some(trigger)) => {
                    assert!(is_clear && edge == trigger.edge);
                    assert!((squared / trigger.squared - 1.0).abs() < 1e-12);
                    counts[1] += 1;
                }
                (Look::Unsure, _) => counts[2] += 1,
                pair => panic!("{corners:?}: {pair:?}"),
            }
        }
        assert!(counts[0] > 500 && counts[1] > 500 && counts[2] < 5, "{counts:?}");
    }

    #[test]
    fn of_two_edges_as_short_a_look_does_not_tell_the_shorter_one() {
        let looked = |y: f64| {
            let [p, a, b] = [[0.0, 0.0], [2.0, 0.0], [1.0, y]];
            look_at(a, [b[0] + 1e-15, b[1]], p)
        };
        assert!(matches!(looked(0.1), Look::Small { is_clear: false, .. }));
    }

    #[test]
    fn the_quick_look_misses_no_bad_triangle() {
        for corners in [NEEDLE, FLAT] {
            for i in 0..3 {
                let [p, a, b] = [corners[i], corners[next(i)], corners[previous(i)]];
                let quick =
                    may_be_small(Relative::of(a, p), Relative::of(b, p), MinAngle::default());
                assert!(quick);
            }
        }
    }
}
