//! Many places for one Steiner point, looked at together.
//!
//! What the cavity of each would be, and which bad triangles it would remove and make, is found for
//! all of them in one walk over the triangles around: a set of places is the bits of a word, and the
//! walk goes on wherever the cavity of one of them does. All is rounded, for it only proposes: the
//! cavity of the place that is chosen is found exactly.

use super::quality;
use crate::corners::{each, next, previous};
use crate::parameters::MinAngle;
use crate::predicates::Relative;
use crate::triangulation::{Edge, Triangulation};

/// So many places are looked at together.
const MOST_PLACES: usize = Set::BITS as usize;
/// After so many edges the walk gives up, and no place is proposed: around a vertex of such a degree
/// no choice would be worth it.
const MOST_EDGES: usize = 1 << 12;

/// Places are laid out in groups of so many: then loops over them that are made into vectors have
/// nothing left over.
const LANES: usize = 8;
/// So many places are asked one by one.
const FEW: u32 = 4;
/// So many circumdiscs are compared.
const MOST_DISCS: usize = 31;

/// A set of places: bit i stands for the i-th.
type Set = u64;

/// The sets of one place each. (Loops that take them from here are made into vectors.)
const BITS: [Set; MOST_PLACES] = {
    let mut bits = [1; MOST_PLACES];
    let mut i = 1;
    while i < MOST_PLACES {
        bits[i] = 1 << i;
        i += 1;
    }
    bits
};

/// What a survey asks about triangles.
pub(super) trait Look {
    /// Whether the triangle in a slot is to stay.
    fn must_stay(&self, slot: u32) -> bool;
    /// Whether it is bad.
    fn is_bad(&self, slot: u32) -> bool;
    /// The angle below which a triangle of a star counts as bad.
    fn target(&self) -> MinAngle;
    /// Whether a triangle of a star may be bad for its size: an edge is seen from the new point.
    /// Where sizes do not count, there is nothing to ask.
    fn may_be_too_large(&self) -> Option<impl Fn([Relative; 2]) -> bool>;
    /// A place that makes more bad triangles than this is not allowed.
    fn most_made(&self) -> u32;
}

/// What would come of a place.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Prospect {
    /// How many triangles of its star would be bad.
    pub made: u32,
    /// How many bad triangles would be gone.
    pub removed: u32,
}

/// A disc, rounded.
#[derive(Debug, Clone, Copy)]
struct Disc {
    center: [f64; 2],
    squared_radius: f64,
}

impl Disc {
    fn around([p, a, b]: [[f64; 2]; 3]) -> Self {
        let (a, b) = (Relative::of(a, p), Relative::of(b, p));
        let half = 0.5 / a.cross(b);
        let x = (a.squared * b.y - b.squared * a.y) * half;
        let y = (b.squared * a.x - a.squared * b.x) * half;
        Self { center: [p[0] + x, p[1] + y], squared_radius: x * x + y * y }
    }

    fn holds(&self, point: [f64; 2]) -> bool {
        Relative::of(self.center, point).squared < self.squared_radius
    }
}

/// An edge with the cavities of some places on its left.
#[derive(Debug, Clone, Copy)]
struct Side {
    ends: [[f64; 2]; 2],
    behind: Edge,
    places: Set,
}

/// Places for a Steiner point. Coordinates count from a corner of the triangle that is to go.
#[derive(Debug, Clone, Default)]
pub(super) struct Survey {
    root: u32,
    origin: [f64; 2],
    /// The least squared distance from every vertex.
    nearest: f64,
    /// Behind the last place there may be others, which no set has.
    x: Vec<f64>,
    y: Vec<f64>,
    prospects: Vec<Prospect>,
    /// The places that keep the rule, as far as has been seen.
    allowed: Set,
    sides: Vec<Side>,
}

impl Survey {
    /// Begins with places for a Steiner point that is to remove the triangle in slot `root`, with
    /// `nearest` as the least squared distance from every vertex. Allowed are those in its circumdisc
    /// that keep away from its corners. Those beyond [`MOST_PLACES`] are left out.
    pub(super) fn begin(
        &mut self,
        mesh: &Triangulation,
        (root, nearest): (u32, f64),
        places: impl Iterator<Item = [f64; 2]>,
    ) {
        self.root = root;
        self.nearest = nearest;
        self.origin = mesh.corners(root)[0];
        let mut count = 0;
        self.x.resize(MOST_PLACES, 0.0);
        self.y.resize(MOST_PLACES, 0.0);
        places.take(MOST_PLACES).for_each(|place| {
            [self.x[count], self.y[count]] = self.relative(place);
            count += 1;
        });
        self.end_after(count);
        let corners = self.corners(mesh, root);
        self.allowed = self.within(first(count), Disc::around(corners));
        for corner in corners {
            self.allowed &= !self.near(self.allowed, corner);
        }
    }

    /// Keeps the places that the most of these triangles' circumdiscs hold, and those that one disc
    /// less holds, and so on until it is `at_least` so many; or only places that all of them hold.
    pub(super) fn keep_in_most_discs(
        &mut self,
        mesh: &Triangulation,
        slots: impl Iterator<Item = u32>,
        at_least: Option<u32>,
    ) {
        // Set n: the places that are in n discs at least.
        let mut in_discs = [0; MOST_DISCS + 1];
        in_discs[0] = self.allowed;
        let mut count = 0;
        for slot in slots.take(MOST_DISCS) {
            let within = self.within(self.allowed, Disc::around(self.corners(mesh, slot)));
            for n in (0..=count).rev() {
                in_discs[n + 1] |= in_discs[n] & within;
            }
            count += 1;
        }
        self.allowed = match at_least {
            None => in_discs[count],
            Some(at_least) => {
                let enough = |set: &&Set| set.count_ones() >= at_least;
                let sets = in_discs[..=count].iter().rev();
                *sets.clone().find(enough).unwrap_or(&in_discs[0])
            }
        };
    }

    /// Finds what would come of each place. Allowed are in the end those that encroach nothing, see
    /// their whole star and have no vertex nearer than was said.
    pub(super) fn look_around(&mut self, mesh: &Triangulation, look: &impl Look) {
        self.close_ranks();
        self.sides.clear();
        if look.must_stay(self.root) {
            self.allowed = 0;
        }
        let corners = self.corners(mesh, self.root);
        let edges = [0, 1, 2].map(|i| (i, [corners[next(i)], corners[previous(i)]]));
        self.take_in(mesh, self.root, self.allowed, edges, look);
        for _ in 0..MOST_EDGES {
            let Some(side) = self.sides.pop() else { return };
            self.look_across(mesh, side, look);
        }
        self.allowed = 0;
    }

    /// The allowed place with the least `cost`, the first of several; none that has no cost.
    pub(super) fn best<C: Ord>(&self, cost: impl Fn(Prospect) -> Option<C>) -> Option<usize> {
        let allowed = members(self.allowed);
        let with_cost = allowed.filter_map(|i| cost(self.prospects[i]).map(|cost| (i, cost)));
        with_cost.min_by(|(_, a), (_, b)| a.cmp(b)).map(|(i, _)| i)
    }

    /// Where place `i` is.
    pub(super) fn place(&self, i: usize) -> [f64; 2] {
        [self.origin[0] + self.x[i], self.origin[1] + self.y[i]]
    }

    /// Takes place `i` out.
    pub(super) fn forbid(&mut self, i: usize) {
        self.allowed &= !(1 << i);
    }

    /// Forgets the places that are not allowed.
    fn close_ranks(&mut self) {
        let mut count = 0;
        for i in members(self.allowed) {
            (self.x[count], self.y[count]) = (self.x[i], self.y[i]);
            count += 1;
        }
        self.end_after(count);
        self.prospects.clear();
        self.prospects.resize(count, Prospect::default());
        self.allowed = first(count);
    }

    /// Leaves the first `count` places, and what fills up their last lanes.
    fn end_after(&mut self, count: usize) {
        self.x.truncate(count.next_multiple_of(LANES));
        self.y.truncate(count.next_multiple_of(LANES));
    }

    fn relative(&self, point: [f64; 2]) -> [f64; 2] {
        [point[0] - self.origin[0], point[1] - self.origin[1]]
    }

    fn corners(&self, mesh: &Triangulation, slot: u32) -> [[f64; 2]; 3] {
        each(mesh.corners(slot), |corner| self.relative(corner))
    }

    /// The triangle in a slot is in the cavities of `places`: what lies across these edges of it is
    /// to be looked at.
    fn take_in<const N: usize>(
        &mut self,
        mesh: &Triangulation,
        slot: u32,
        places: Set,
        edges: [(usize, [[f64; 2]; 2]); N],
        look: &impl Look,
    ) {
        if places == 0 {
            return;
        }
        if look.is_bad(slot) {
            members(places).for_each(|i| self.prospects[i].removed += 1);
        }
        let neighbors = mesh.triangles[slot as usize].neighbors;
        self.sides.extend(edges.map(|(i, ends)| Side { ends, behind: neighbors[i], places }));
    }

    /// Takes the triangle behind an edge into the cavities that it belongs to. For the others the edge
    /// is one of the star.
    fn look_across(&mut self, mesh: &Triangulation, side: Side, look: &impl Look) {
        let places = side.places & self.allowed;
        if places == 0 {
            return;
        }
        if side.behind.is_constrained() {
            self.join(Side { places, ..side }, look);
            return;
        }
        let (slot, i) = (side.behind.triangle(), side.behind.index());
        let apex = mesh.points[mesh.triangles[slot as usize].vertices[i] as usize];
        let apex = self.relative(apex);
        let [a, b] = side.ends;
        let goes_with = self.within(places, Disc::around([apex, b, a]));
        self.join(Side { places: places & !goes_with, ..side }, look);
        if goes_with == 0 {
            return;
        }
        let forbidden = if look.must_stay(slot) { goes_with } else { self.near(goes_with, apex) };
        self.allowed &= !forbidden;
        let edges = [(next(i), [a, apex]), (previous(i), [apex, b])];
        self.take_in(mesh, slot, goes_with & !forbidden, edges, look);
    }

    /// Makes an edge one of the stars of its places.
    fn join(&mut self, side: Side, look: &impl Look) {
        let places = side.places & self.allowed;
        if places == 0 {
            return;
        }
        let target = look.target();
        let [bad, unseen] = self.those(places, side.ends, |[a, b]| {
            [quality::may_be_small(a, b, target), a.cross(b) <= 0.0]
        });
        self.allowed &= !unseen;
        if side.behind.is_constrained() {
            let [encroaching] = self.those(places, side.ends, |[a, b]| [a.dot(b) < 0.0]);
            self.allowed &= !encroaching;
        }
        let too_large = look.may_be_too_large();
        let [too_large] =
            too_large.map_or([0], |is_so| self.those(places, side.ends, |ends| [is_so(ends)]));
        let bad = bad | too_large;
        for i in members(bad & places & self.allowed) {
            self.prospects[i].made += 1;
            if self.prospects[i].made > look.most_made() {
                self.forbid(i);
            }
        }
    }

    /// Those of some places for which each of some things holds of an edge's ends, as seen from there.
    #[inline(always)]
    fn those<const N: usize>(
        &self,
        places: Set,
        ends: [[f64; 2]; 2],
        hold: impl Fn([Relative; 2]) -> [bool; N],
    ) -> [Set; N] {
        self.of(places, |place| hold(ends.map(|end| Relative::of(end, place))))
    }

    /// Those of some places to which a vertex is too near.
    fn near(&self, places: Set, vertex: [f64; 2]) -> Set {
        self.within(places, Disc { center: vertex, squared_radius: self.nearest })
    }

    /// Those of some places that are in a disc.
    fn within(&self, places: Set, disc: Disc) -> Set {
        let [within] = self.of(places, |place| [disc.holds(place)]);
        within
    }

    /// Those of some places for which each of some things holds: few are asked one by one, many all at
    /// once.
    #[inline(always)]
    fn of<const N: usize>(&self, places: Set, hold: impl Fn([f64; 2]) -> [bool; N]) -> [Set; N] {
        let mut sets = [0; N];
        if places.count_ones() <= FEW {
            for i in members(places) {
                let hold = hold([self.x[i], self.y[i]]);
                (0..N).for_each(|n| sets[n] |= Set::from(hold[n]) << i);
            }
            return sets;
        }
        for ((&x, &y), bit) in self.x.iter().zip(&self.y).zip(&BITS) {
            let hold = hold([x, y]);
            (0..N).for_each(|n| sets[n] |= if hold[n] { *bit } else { 0 });
        }
        sets.map(|set| set & places)
    }
}

/// The first places.
fn first(count: usize) -> Set {
    Set::MAX.checked_shr((MOST_PLACES - count) as u32).unwrap_or(0)
}

/// The places of a set, in their order.
fn members(mut set: Set) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let first = (set != 0).then(|| set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        first
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::carve::carve;
    use crate::domain::Domain;
    use crate::random::Random;
    use crate::triangulation::Cavity;
    use crate::triangulation::initial::triangulate;
    use crate::{Pslg, Region};

    /// A place from -1 to 1 each way.
    fn somewhere(random: &mut Random) -> [f64; 2] {
        random.in_square().map(|x| 2.0 * x - 1.0)
    }

    /// Random points in a square with a slit.
    fn mesh(random: &mut Random) -> Triangulation {
        let mut points = vec![[-1.2, -1.2], [1.2, -1.2], [1.2, 1.2], [-1.2, 1.2]];
        points.extend([[-0.9, 0.1], [0.8, 0.3]]);
        points.extend((0..80).map(|_| somewhere(random)));
        let segments = vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]];
        let segment_tags = vec![0; segments.len()];
        let pslg = Pslg { points, segments, segment_tags, ..Pslg::default() };
        let (domain, _) = Domain::new(&pslg, Region::Domain).expect("it is clean");
        let (domain, initial) = triangulate(domain).expect("it can be triangulated");
        carve(initial, &domain)
    }

    /// Every third slot is bad, every 29th stays.
    struct Some29th {
        most_made: u32,
    }

    impl Look for Some29th {
        fn must_stay(&self, slot: u32) -> bool {
            slot.is_multiple_of(29)
        }

        fn is_bad(&self, slot: u32) -> bool {
            slot.is_multiple_of(3)
        }

        fn target(&self) -> MinAngle {
            MinAngle::default()
        }

        fn may_be_too_large(&self) -> Option<impl Fn([Relative; 2]) -> bool> {
            Some(|[a, b]: [Relative; 2]| a.cross(b) > 0.06)
        }

        fn most_made(&self) -> u32 {
            self.most_made
        }
    }

    /// The same for one place, by its cavity.
    fn prospect(
        mesh: &Triangulation,
        (root, nearest): (u32, f64),
        place: [f64; 2],
        look: &Some29th,
    ) -> Option<Prospect> {
        let mut cavity = Cavity::default();
        cavity.of_steiner_point(mesh, place, root).ok()?;
        cavity.expect_visible(mesh).ok()?;
        let is_bad = |[a, b]: [Relative; 2]| {
            let too_large = look.may_be_too_large().is_some_and(|is_so| is_so([a, b]));
            quality::may_be_small(a, b, look.target()) || too_large
        };
        let made = cavity.sides().filter(|side| is_bad(side.seen)).count() as u32;
        let removed = cavity.star.iter().filter(|&&slot| look.is_bad(slot)).count() as u32;
        let is_allowed = cavity.nearest_squared() >= nearest
            && cavity.encroached(mesh).next().is_none()
            && !cavity.star.iter().any(|&slot| look.must_stay(slot))
            && made <= look.most_made;
        is_allowed.then_some(Prospect { made, removed })
    }

    #[test]
    fn a_survey_finds_for_each_place_what_its_cavity_tells() {
        let random = &mut Random::default();
        let (mut allowed, mut forbidden) = (0, 0);
        for most_made in [u32::MAX, 2] {
            let (mesh, look) = (mesh(random), Some29th { most_made });
            for root in 0..mesh.triangles.len() as u32 {
                let corners = mesh.corners(root);
                let places: Vec<_> = (0..MOST_PLACES)
                    .map(|_| somewhere(random))
                    .map(|[x, y]| [corners[0][0] + 0.4 * x, corners[0][1] + 0.4 * y])
                    .collect();
                let nearest = 1e-4;
                let mut survey = Survey::default();
                survey.begin(&mesh, (root, nearest), places.iter().copied());
                survey.look_around(&mesh, &look);
                let mut found = members(survey.allowed).map(|i| survey.prospects[i]);
                for place in places {
                    match prospect(&mesh, (root, nearest), place, &look) {
                        Some(expected) => {
                            assert_eq!(found.next(), Some(expected), "{place:?} for {corners:?}");
                            allowed += 1;
                        }
                        None => forbidden += 1,
                    }
                }
                assert_eq!(found.next(), None);
            }
        }
        assert!(allowed > 500 && forbidden > 500, "{allowed} allowed, {forbidden} not");
    }

    #[test]
    fn the_places_in_most_discs_are_kept() {
        let random = &mut Random::default();
        let mesh = mesh(random);
        for root in 0..mesh.triangles.len() as u32 {
            let [x, y] = mesh.corners(root)[0];
            let places: Vec<_> = (0..MOST_PLACES)
                .map(|_| somewhere(random))
                .map(|place| [x + 0.2 * place[0], y + 0.2 * place[1]])
                .collect();
            let others = mesh.triangles[root as usize].neighbors;
            let others = others.iter().filter(|edge| !edge.is_outside()).map(|e| e.triangle());
            let discs: Vec<_> = others.clone().map(|t| Disc::around(mesh.corners(t))).collect();
            let in_discs = |p: [f64; 2]| discs.iter().filter(|disc| disc.holds(p)).count();
            let mut survey = Survey::default();
            survey.begin(&mesh, (root, 0.0), places.iter().copied());
            let all: Vec<_> = members(survey.allowed).map(|i| in_discs(places[i])).collect();
            for at_least in [None, Some(1), Some(8)] {
                let mut survey = survey.clone();
                survey.keep_in_most_discs(&mesh, others.clone(), at_least);
                let kept: Vec<_> = members(survey.allowed).map(|i| in_discs(places[i])).collect();
                let enough = |n: &usize| {
                    let so_many = all.iter().filter(|&m| m >= n).count();
                    at_least.map_or(*n == discs.len(), |at_least| so_many >= at_least as usize)
                };
                let least = (0..=discs.len()).rev().find(enough).unwrap_or(0);
                let expected: Vec<_> = all.iter().copied().filter(|&n| n >= least).collect();
                assert_eq!(kept, expected);
            }
        }
    }
}
