//! How triangles are glued: which two of them share an edge.
//!
//! The triangles stand in the order of their smallest points. So each edge can be found at the
//! smaller of its two points: it is an edge of a triangle that begins there, or the edge across from
//! where its triangle begins. Only the latter are listed.

use std::collections::BTreeMap;

use super::complex::NONE;
use crate::corners::{next, previous};

/// At a point with more half-edges than this they are kept in order.
const HUB: usize = 64;

/// The half-edges by the smaller of their points.
///
/// Half-edge 3t + k runs from corner k of triangle t to the next corner, t on its left.
#[derive(Default)]
pub(super) struct Edges {
    /// The triangles whose smallest point is v: from `first[v]` to `first[v + 1]`.
    first: Vec<u32>,
    /// The half-edges across from the smallest points of their triangles, by their own smaller
    /// points; `start` delimits them.
    across: Vec<u32>,
    start: Vec<u32>,
    /// All half-edges at points that have very many, in order.
    hubs: BTreeMap<u32, Vec<Spoke>>,
    /// The half-edges that have no opposite one, in order.
    pub(super) one_sided: Vec<u32>,
    /// Those that run along an edge in the same direction as another one.
    pub(super) overlaps: Vec<u32>,
    /// How many edges there are.
    pub(super) count: usize,
}

/// A half-edge at the smaller of its points: its larger point in the high half, its own number in
/// the low one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Spoke(u64);

impl Spoke {
    fn new(larger: u32, half: u32) -> Self {
        Self(u64::from(larger) << 32 | u64::from(half))
    }

    fn larger(self) -> u32 {
        (self.0 >> 32) as u32
    }

    fn half(self) -> u32 {
        self.0 as u32
    }
}

impl Edges {
    /// Glues triangles that stand in the order of their smallest points, which are below `points`;
    /// `see` is shown the two half-edges of each edge inside.
    pub(super) fn new(
        triangles: &[[u32; 3]],
        points: usize,
        mut see: impl FnMut([u32; 2]),
    ) -> Self {
        let across = (0..).zip(triangles).map(|(t, corners)| {
            let k = next(smallest(corners));
            (corners[k].min(corners[next(k)]), 3 * t + k as u32)
        });
        let (start, across) = super::grouped(points, across);
        let first = first_by_point(triangles, points);
        let mut edges = Self { first, across, start, ..Self::default() };
        let mut spokes = Vec::new();
        for v in 0..points as u32 {
            spokes.clear();
            edges.spokes(triangles, v, |spoke| spokes.push(spoke));
            spokes.sort_unstable();
            for edge in spokes.chunk_by(|x, y| x.larger() == y.larger()) {
                edges.glue(triangles, v, edge, &mut see);
            }
            if spokes.len() > HUB {
                edges.hubs.insert(v, spokes.clone());
            }
        }
        edges.one_sided.sort_unstable();
        edges
    }

    /// Glues the half-edges along one edge, of which `smaller` is the smaller point.
    fn glue(
        &mut self,
        triangles: &[[u32; 3]],
        smaller: u32,
        edge: &[Spoke],
        see: &mut impl FnMut([u32; 2]),
    ) {
        let way = |half: u32| usize::from(origin(triangles, half) == smaller);
        if let [g, h] = edge
            && way(g.half()) != way(h.half())
        {
            self.count += 1;
            see([g.half(), h.half()]);
            return;
        }
        let mut ways = [NONE; 2];
        for half in edge.iter().map(|spoke| spoke.half()) {
            if ways[way(half)] == NONE {
                ways[way(half)] = half;
            } else {
                self.overlaps.push(half);
            }
        }
        self.count += edge.len();
        if !ways.contains(&NONE) {
            self.count -= 1;
            see([ways[0].min(ways[1]), ways[0].max(ways[1])]);
        }
        let is_alone = |&half: &u32| ways.contains(&NONE) || !ways.contains(&half);
        self.one_sided.extend(edge.iter().map(|spoke| spoke.half()).filter(is_alone));
    }

    /// Hands on the half-edges of which `v` is the smaller point.
    #[inline(always)]
    fn spokes(&self, triangles: &[[u32; 3]], v: u32, mut take: impl FnMut(Spoke)) {
        for t in self.first[v as usize]..self.first[v as usize + 1] {
            let corners = &triangles[t as usize];
            let k = smallest(corners);
            let last = previous(k);
            take(Spoke::new(corners[next(k)], 3 * t + k as u32));
            take(Spoke::new(corners[last], 3 * t + last as u32));
        }
        for &half in self.across_at(v) {
            take(Spoke::new(origin(triangles, half).max(target(triangles, half)), half));
        }
    }

    fn across_at(&self, v: u32) -> &[u32] {
        &self.across[self.start[v as usize] as usize..self.start[v as usize + 1] as usize]
    }

    /// The half-edges from `v` to `w` and from `w` to `v`, each [`NONE`] where there is none; of
    /// several the first.
    pub(super) fn find(&self, triangles: &[[u32; 3]], v: u32, w: u32) -> [u32; 2] {
        let (smaller, larger) = (v.min(w), v.max(w));
        let mut found = [NONE; 2];
        let mut take = |half: u32| {
            let way = usize::from(origin(triangles, half) != v);
            found[way] = found[way].min(half);
        };
        if smaller as usize + 1 >= self.first.len() {
            return found;
        }
        if let Some(spokes) = self.hub(smaller) {
            let from = spokes.partition_point(|spoke| spoke.larger() < larger);
            let along = spokes[from..].iter().take_while(|spoke| spoke.larger() == larger);
            along.for_each(|spoke| take(spoke.half()));
        } else {
            self.spokes(triangles, smaller, |spoke| {
                if spoke.larger() == larger {
                    take(spoke.half());
                }
            });
        }
        found
    }

    fn hub(&self, v: u32) -> Option<&[Spoke]> {
        if self.hubs.is_empty() { None } else { self.hubs.get(&v).map(Vec::as_slice) }
    }
}

/// The place of the smallest corner.
fn smallest(&[a, b, c]: &[u32; 3]) -> usize {
    match (b < a, c < a.min(b)) {
        (_, true) => 2,
        (true, false) => 1,
        (false, false) => 0,
    }
}

/// The first triangle of each point, and where those of the last one end.
fn first_by_point(triangles: &[[u32; 3]], points: usize) -> Vec<u32> {
    let mut first = Vec::with_capacity(points + 1);
    for (t, corners) in (0..).zip(triangles) {
        while first.len() <= corners[smallest(corners)] as usize {
            first.push(t);
        }
    }
    first.resize(points + 1, triangles.len() as u32);
    first
}

/// The point where a half-edge begins.
pub(super) fn origin(triangles: &[[u32; 3]], h: u32) -> u32 {
    triangles[h as usize / 3][h as usize % 3]
}

/// The point where a half-edge ends.
pub(super) fn target(triangles: &[[u32; 3]], h: u32) -> u32 {
    triangles[h as usize / 3][next(h as usize % 3)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wheel of `n` triangles around point 0.
    fn wheel(n: u32) -> Vec<[u32; 3]> {
        (0..n).map(|i| [0, 1 + i, 1 + (i + 1) % n]).collect()
    }

    #[test]
    fn every_edge_of_a_wheel_is_found_however_many_meet_at_its_hub() {
        for n in [3, 10, 1000] {
            let triangles = wheel(n);
            let mut inside = 0;
            let edges = Edges::new(&triangles, n as usize + 1, |[g, h]| {
                inside += 1;
                assert_eq!(origin(&triangles, g), target(&triangles, h));
            });
            assert_eq!((inside, edges.count), (n, 2 * n as usize));
            assert_eq!(edges.one_sided, (0..n).map(|t| 3 * t + 1).collect::<Vec<_>>());
            for (t, &[hub, a, b]) in (0..).zip(&triangles) {
                assert_eq!(edges.find(&triangles, hub, a)[0], 3 * t);
                assert_eq!(edges.find(&triangles, hub, b)[1], 3 * t + 2);
                assert_eq!(edges.find(&triangles, b, a), [NONE, 3 * t + 1]);
            }
            assert_eq!(edges.find(&triangles, 1, n + 1), [NONE; 2]);
        }
    }

    #[test]
    fn what_runs_along_an_edge_beside_another_triangle_is_an_overlap() {
        let triangles = [[0, 1, 2], [0, 1, 3], [0, 4, 1]];
        let edges = Edges::new(&triangles, 5, |halves| assert_eq!(halves, [0, 8]));
        assert_eq!(edges.overlaps, [3]);
        assert_eq!(edges.one_sided, [1, 2, 3, 4, 5, 6, 7]);
        assert_eq!(edges.find(&triangles, 0, 1), [0, 8]);
    }
}
