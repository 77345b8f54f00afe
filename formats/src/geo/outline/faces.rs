//! The faces that embedded curves divide a surface into: a seed in each.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::doubled_area;
use super::contours::Polygon;
use super::seeds::stretches;
use super::surfaces::encloses;

type Side = [[f64; 2]; 2];

/// A place inside each face between the polygons of a surface's part and the walls in it, away from
/// the embedded points.
///
/// Where the linework crosses itself without a common point its faces are not known: what is found
/// is inside the part all the same.
pub(super) fn seeds(polygons: &[&Polygon], walls: &[Side], points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sides: Vec<Side> = polygons.iter().flat_map(|polygon| polygon.sides()).collect();
    sides.extend(walls);
    let cycles = Linework::new(&sides).cycles();
    // A face lies to the left of its cycle; the other cycles go around what lies in a face.
    let (faces, islands): (Vec<_>, Vec<_>) =
        cycles.into_iter().partition(|places| doubled_area(places) > 0.0);
    let [faces, islands] =
        [faces, islands].map(|cycles| cycles.into_iter().map(Polygon::new).collect::<Vec<_>>());
    let inside = |p: [f64; 2]| polygons.iter().filter(|polygon| polygon.holds(p)).count() % 2 == 1;
    let seed = |face: &Polygon| {
        let mut around = vec![face];
        around.extend(outermost(islands.iter().filter(|island| encloses(face, island)).collect()));
        let found = stretches(&around, &sides, points);
        found.iter().map(|stretch| stretch.at(0.5)).find(|&p| inside(p))
    };
    faces.iter().filter_map(seed).collect()
}

/// Those of some islands that lie in no other.
fn outermost(islands: Vec<&Polygon>) -> Vec<&Polygon> {
    let is_free = |island: &&Polygon| !islands.iter().any(|other| encloses(other, island));
    islands.iter().copied().filter(is_free).collect()
}

/// Straight sides between numbered places, each side as two directed edges: 2i and 2i + 1.
struct Linework {
    places: Vec<[f64; 2]>,
    /// Where each directed edge ends.
    heads: Vec<usize>,
    /// For each place the edges that leave it, counter-clockwise.
    leaving: Vec<Vec<usize>>,
    /// The place of each edge among those.
    ranks: Vec<usize>,
}

impl Linework {
    fn new(sides: &[Side]) -> Self {
        let mut places = Vec::new();
        let mut numbers: BTreeMap<[u64; 2], usize> = BTreeMap::new();
        let mut number = |p: [f64; 2]| {
            // 0.0 and −0.0 are one place.
            *numbers.entry(p.map(|c| (c + 0.0).to_bits())).or_insert_with(|| {
                places.push(p);
                places.len() - 1
            })
        };
        let ends: BTreeSet<[usize; 2]> = sides
            .iter()
            .map(|side| side.map(&mut number))
            .filter(|[a, b]| a != b)
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let heads: Vec<usize> = ends.iter().flat_map(|&[a, b]| [b, a]).collect();
        let mut leaving = vec![Vec::new(); places.len()];
        for edge in 0..heads.len() {
            leaving[heads[edge ^ 1]].push(edge);
        }
        let mut ranks = vec![0; heads.len()];
        for (&from, edges) in places.iter().zip(&mut leaving) {
            let angle = |edge: &usize| {
                let to = places[heads[*edge]];
                libm::atan2(to[1] - from[1], to[0] - from[0])
            };
            edges.sort_by(|a, b| angle(a).total_cmp(&angle(b)).then(a.cmp(b)));
            edges.iter().enumerate().for_each(|(rank, &edge)| ranks[edge] = rank);
        }
        Self { places, heads, leaving, ranks }
    }

    /// The closed ways along the edges that always turn left as far as they can.
    fn cycles(&self) -> Vec<Vec<[f64; 2]>> {
        let mut used = vec![false; self.heads.len()];
        let mut cycles = Vec::new();
        for start in 0..self.heads.len() {
            let mut cycle = Vec::new();
            let mut edge = start;
            while !std::mem::replace(&mut used[edge], true) {
                cycle.push(self.places[self.heads[edge]]);
                edge = self.next(edge);
            }
            if !cycle.is_empty() {
                cycles.push(cycle);
            }
        }
        cycles
    }

    /// The edge that leaves where one arrives, the next one clockwise from the way back.
    fn next(&self, edge: usize) -> usize {
        let around = &self.leaving[self.heads[edge]];
        around[(self.ranks[edge ^ 1] + around.len() - 1) % around.len()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(a: f64, b: f64) -> Vec<[f64; 2]> {
        vec![[a, a], [b, a], [b, b], [a, b]]
    }

    fn walls(places: &[[f64; 2]]) -> Vec<Side> {
        Polygon::new(places.to_vec()).sides().collect()
    }

    fn seeds_in(polygons: &[Vec<[f64; 2]>], walls: &[Side]) -> Vec<[f64; 2]> {
        let polygons: Vec<Polygon> = polygons.iter().cloned().map(Polygon::new).collect();
        seeds(&polygons.iter().collect::<Vec<_>>(), walls, &[])
    }

    #[test]
    fn a_ring_within_a_square_makes_two_faces() {
        let found = seeds_in(&[ring(0.0, 9.0)], &walls(&ring(3.0, 6.0)));
        let in_ring = |p: &[f64; 2]| p.iter().all(|c| (3.0..6.0).contains(c));
        assert_eq!(found.len(), 2);
        assert_eq!(found.iter().filter(|p| in_ring(p)).count(), 1, "{found:?}");
    }

    #[test]
    fn rings_within_rings_have_a_seed_each() {
        let within = [walls(&ring(1.0, 8.0)), walls(&ring(2.0, 7.0)), walls(&ring(3.0, 6.0))];
        let found = seeds_in(&[ring(0.0, 9.0)], &within.concat());
        let depth = |p: &[f64; 2]| p.iter().map(|c| c.min(9.0 - c)).fold(9.0, f64::min) as usize;
        let mut depths: Vec<usize> = found.iter().map(depth).collect();
        depths.sort_unstable();
        assert_eq!(depths.len(), 4);
        assert_eq!(depths[..3], [0, 1, 2], "{found:?}");
    }

    #[test]
    fn a_wall_from_side_to_side_makes_two_faces_and_a_dangling_one_none() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 4.0], [0.0, 4.0]];
        let square = [[&square[..1], &[[2.0, 0.0]], &square[1..]].concat()];
        assert_eq!(seeds_in(&square, &[[[2.0, 0.0], [2.0, 4.0]]]).len(), 2);
        assert_eq!(seeds_in(&square, &[[[2.0, 0.0], [2.0, 3.0]]]).len(), 1);
    }

    #[test]
    fn a_hole_has_no_seed() {
        let found = seeds_in(&[ring(0.0, 9.0), ring(3.0, 6.0)], &walls(&ring(1.0, 2.0)));
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|p| !p.iter().all(|c| (3.0..6.0).contains(c))), "{found:?}");
    }
}
