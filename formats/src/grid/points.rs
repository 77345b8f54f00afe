//! The points of a grid, made of coordinates that come one after the other.

use super::{Part, Wrong, wrong};

/// Points in the plane, and what is wrong with the first that is none.
#[derive(Default)]
pub(crate) struct Points {
    pub(super) places: Vec<[f64; 2]>,
    /// The z coordinate of all points.
    pub(super) plane: Option<f64>,
    pub(super) wrong: Option<Wrong>,
    /// How many points have come, right or wrong.
    count: usize,
    /// The first coordinates of the next one.
    begun: Vec<f64>,
}

impl Points {
    /// Room for so many points.
    pub fn with_capacity(count: usize) -> Self {
        Self { places: Vec::with_capacity(count), ..Self::default() }
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Takes coordinates, three for each point.
    pub fn extend(&mut self, coordinates: &[f64]) {
        let missing = (3 - self.begun.len()) % 3;
        let (end, coordinates) = coordinates.split_at(missing.min(coordinates.len()));
        self.begun.extend_from_slice(end);
        if let [x, y, z] = self.begun[..] {
            self.push([x, y, z]);
            self.begun.clear();
        }
        let triples = coordinates.chunks_exact(3);
        self.begun.extend_from_slice(triples.remainder());
        for triple in triples {
            self.push([triple[0], triple[1], triple[2]]);
        }
    }

    fn push(&mut self, [x, y, z]: [f64; 3]) {
        self.count += 1;
        let plane = *self.plane.get_or_insert(z);
        if x.is_finite() && y.is_finite() && z == plane && plane.is_finite() {
            self.places.push([x, y]);
        } else if self.wrong.is_none() {
            let first = 3 * (self.count - 1);
            self.wrong = Some(match [x, y, z].iter().position(|x| !x.is_finite()) {
                Some(k) => wrong(Part::Points, first + k, "a finite number", [x, y, z][k]),
                None => wrong(Part::Points, first + 2, "the same z for all points", z),
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_come_in_blocks_of_any_length() {
        let coordinates: Vec<f64> =
            (0..30).map(|i| if i % 3 == 2 { 7.0 } else { i.into() }).collect();
        for length in 1..12 {
            let mut points = Points::default();
            coordinates.chunks(length).for_each(|block| points.extend(block));
            assert_eq!((points.len(), points.plane), (10, Some(7.0)));
            assert_eq!(points.places[9], [27.0, 28.0]);
            assert!(points.wrong.is_none());
        }
    }

    #[test]
    fn the_first_coordinate_that_means_nothing_is_the_one_to_name() {
        let mut points = Points::default();
        points.extend(&[0.0, 0.0, 1.0, 0.0, 0.0, 2.0, f64::NAN, 0.0]);
        points.extend(&[1.0]);
        let wrong = points.wrong.expect("z is not the same");
        assert_eq!((points.count, wrong.index, wrong.found.as_str()), (3, 5, "2"));
    }
}
