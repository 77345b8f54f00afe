//! Splitting segments where they cross, touch or overlap, until none does.
//!
//! A rounded crossing moves its segments a little, so they may meet others: what changed is judged
//! again, round by round. Predicates are exact; that it ends see [`chain`](super::chain).

use std::ops::ControlFlow;

use super::super::conflicts::is_strictly_between;
use super::super::error::Error;
use super::super::precision;
use super::chain::Chain;
use super::draft::{Draft, Strand};
use super::grid::Grid;
use super::report::Repair;
use crate::boxes::{Boxes, Rectangle};
use crate::constructions::crossing;
use crate::predicates::{Side, side};
use crate::vector::Vector;

/// A crossing nearer than this to a point, in units of ulp(M), is at that point: rounding could
/// hardly tell them apart.
const REACH: f64 = 4.0;

/// The search ends after this many pairs of segments with overlapping boxes.
const MOST_PAIRS: usize = 100_000_000;

/// No more than this many meetings are mended.
const MOST_MEETINGS: usize = 8_000_000;

/// Splits segments at each other until Assumption 1 (ii) and (iii) hold.
///
/// # Errors
/// There is more to do than bounded time and memory allow.
pub fn untangle(draft: &mut Draft) -> Result<(), Error> {
    let mut tangle = Tangle::new(draft);
    let mut meetings = match tangle.all_meetings() {
        // A sweep can tell of a clean outline that it is.
        Err(_) if tangle.draft.is_clean() => return Ok(()),
        found => found?,
    };
    while !meetings.is_empty() {
        let changed = tangle.split(meetings);
        meetings = tangle.meetings_of(&changed)?;
    }
    let strands = tangle.strands();
    draft.set_strands(strands);
    Ok(())
}

/// A piece of a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Piece {
    /// The segment's chain.
    chain: u32,
    ends: [u32; 2],
}

/// A point inside a piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Touch {
    /// The chain that is split.
    chain: u32,
    /// The point.
    point: u32,
    /// The chain that the point belongs to; `u32::MAX` where no segment ends there.
    of: u32,
    /// Whether the two overlap.
    is_overlap: bool,
}

/// Where pieces meet elsewhere than at common ends.
#[derive(Debug, Default)]
struct Meetings {
    touches: Vec<Touch>,
    crossings: Vec<[Piece; 2]>,
}

impl Meetings {
    fn count(&self) -> usize {
        self.touches.len() + self.crossings.len()
    }

    fn is_empty(&self) -> bool {
        self.count() == 0
    }
}

/// Segments that may cross.
struct Tangle<'a, 'b> {
    draft: &'a mut Draft<'b>,
    /// The segments, in the order of the draft.
    chains: Vec<Chain>,
    /// The points at which no segment ends.
    loose: Vec<u32>,
    /// The chains, then the loose points.
    boxes: Boxes,
    /// The points made here.
    made: Grid,
    /// See [`REACH`].
    reach: f64,
    /// Pairs that were looked at.
    pairs: usize,
    /// Meetings that were mended.
    meetings: usize,
}

impl<'a, 'b> Tangle<'a, 'b> {
    fn new(draft: &'a mut Draft<'b>) -> Self {
        let chains: Vec<Chain> = draft.strands.iter().map(|s| Chain::new(s.ends)).collect();
        let degrees = draft.degrees();
        let is_loose = |&point: &u32| draft.is_kept[point as usize] && degrees[point as usize] == 0;
        let loose: Vec<u32> = (0..draft.points.len() as u32).filter(is_loose).collect();
        let of_chains = chains.iter().map(|chain| around(draft, chain.ends));
        let of_loose = loose.iter().map(|&point| around(draft, [point, point]));
        let boxes = Boxes::new(&of_chains.chain(of_loose).collect::<Vec<_>>());
        let reach = REACH * precision::ulp(&draft.points, &draft.is_kept);
        let made = Grid::new(reach);
        Self { draft, chains, loose, boxes, made, reach, pairs: 0, meetings: 0 }
    }

    /// What is left of each segment, piece by piece.
    fn strands(&self) -> Vec<Strand> {
        let inputs = self.draft.strands.iter().map(|strand| strand.input);
        let chains = self.chains.iter().zip(inputs);
        chains
            .flat_map(|(chain, input)| chain.pieces().map(move |ends| Strand { ends, input }))
            .collect()
    }

    /// Where segments meet each other and loose points.
    fn all_meetings(&mut self) -> Result<Meetings, Error> {
        let mut found = Meetings::default();
        let mut pairs = 0;
        let whole = |chain: u32| Piece { chain, ends: self.chains[chain as usize].ends };
        let is_loose = |item: u32| item as usize >= self.chains.len();
        let search = self.boxes.overlapping_pairs(|[first, second]| {
            let (low, high) = (first.min(second), first.max(second));
            match (is_loose(low), is_loose(high)) {
                (false, false) => self.judge_pieces(whole(low), whole(high), &mut found),
                (false, true) => self.judge_point(high, whole(low), &mut found),
                (true, _) => {}
            }
            pairs += 1;
            self.within_budget(pairs, &found)
        });
        self.finish_search(search, pairs, found)
    }

    /// Where changed pieces meet any others.
    fn meetings_of(&mut self, changed: &[Piece]) -> Result<Meetings, Error> {
        let mut found = Meetings::default();
        let mut pairs = self.pairs;
        let search = changed.iter().try_for_each(|&piece| {
            let rectangle = around(self.draft, piece.ends);
            self.boxes.overlapping(&rectangle, |item| {
                match self.chains.get(item as usize) {
                    None => self.judge_point(item, piece, &mut found),
                    // Pieces of one chain have nothing but ends in common.
                    Some(_) if item == piece.chain => {}
                    Some(chain) => {
                        for ends in chain.pieces_in(&self.draft.points, &rectangle) {
                            self.judge_pieces(piece, Piece { chain: item, ends }, &mut found);
                        }
                    }
                }
                pairs += 1;
                self.within_budget(pairs, &found)
            })
        });
        self.finish_search(search, pairs, found)
    }

    fn within_budget(&self, pairs: usize, found: &Meetings) -> ControlFlow<Error> {
        let meetings = self.meetings + found.count();
        if pairs > MOST_PAIRS || meetings > MOST_MEETINGS {
            return ControlFlow::Break(Error::TooTangled { pairs, meetings });
        }
        ControlFlow::Continue(())
    }

    /// What was found, in a fixed order, each meeting once.
    fn finish_search(
        &mut self,
        search: ControlFlow<Error>,
        pairs: usize,
        mut found: Meetings,
    ) -> Result<Meetings, Error> {
        if let ControlFlow::Break(error) = search {
            return Err(error);
        }
        found.touches.sort_unstable();
        found.touches.dedup();
        found.crossings.sort_unstable();
        found.crossings.dedup();
        self.pairs = pairs;
        self.meetings += found.count();
        Ok(found)
    }

    /// Finds out whether the loose point that is an item of the tree lies inside a piece.
    fn judge_point(&self, item: u32, piece: Piece, found: &mut Meetings) {
        let point = self.loose[item as usize - self.chains.len()];
        if self.is_inside(point, piece) {
            let Piece { chain, .. } = piece;
            found.touches.push(Touch { chain, point, of: u32::MAX, is_overlap: false });
        }
    }

    /// Finds out how two pieces meet.
    fn judge_pieces(&self, first: Piece, second: Piece, found: &mut Meetings) {
        let [[a, b], [c, d]] = [first, second].map(|piece| self.places(piece));
        let of_second = [side(a, b, c), side(a, b, d)];
        if of_second[0] == of_second[1] && of_second[0] != Side::On {
            return;
        }
        let of_first = [side(c, d, a), side(c, d, b)];
        if of_first[0] == of_first[1] && of_first[0] != Side::On {
            return;
        }
        if !of_first.contains(&Side::On) && !of_second.contains(&Side::On) {
            found.crossings.push([first.min(second), first.max(second)]);
            return;
        }
        let is_overlap = of_second == [Side::On; 2];
        for (from, onto) in [(first, second), (second, first)] {
            for point in from.ends {
                if self.is_inside(point, onto) {
                    let (chain, of) = (onto.chain, from.chain);
                    found.touches.push(Touch { chain, point, of, is_overlap });
                }
            }
        }
    }

    /// Splits the chains where they meet; returns the pieces of what changed.
    fn split(&mut self, meetings: Meetings) -> Vec<Piece> {
        self.report_touches(&meetings.touches);
        let touches = meetings.touches.iter().map(|touch| [touch.chain, touch.point]);
        let mut splits: Vec<[u32; 2]> = touches.collect();
        let mut crossed = Vec::new();
        for pair in meetings.crossings {
            let point = self.point_of(pair);
            splits.extend(splits_of(pair, point));
            crossed.push((pair, point));
        }
        let (changed, refused) = self.insert(splits);
        for (pair, point) in crossed {
            // What was refused is a meeting of other pieces now, which the next round finds.
            if splits_of(pair, point).any(|split| refused.binary_search(&split).is_err()) {
                let segments = pair.map(|piece| self.input(piece.chain));
                self.draft.repairs.push(Repair::Crossing { segments, point });
            }
        }
        changed
    }

    /// Inserts points into chains, given as pairs of a chain and a point. Returns the pieces of
    /// what changed, and, sorted, the pairs that were refused.
    fn insert(&mut self, mut splits: Vec<[u32; 2]>) -> (Vec<Piece>, Vec<[u32; 2]>) {
        let (chains, points) = (&mut self.chains, &self.draft.points);
        splits.sort_unstable_by(|[s, p], [t, q]| {
            s.cmp(t).then_with(|| chains[*s as usize].order(points, *p, *q))
        });
        splits.dedup();
        let (mut changed, mut refused) = (Vec::new(), Vec::new());
        for of_chain in splits.chunk_by(|[s, _], [t, _]| s == t) {
            let chain = of_chain[0][0];
            let new: Vec<u32> = of_chain.iter().map(|&[_, point]| point).collect();
            let done = chains[chain as usize].insert(points, &new);
            changed.extend(done.pieces.into_iter().map(|ends| Piece { chain, ends }));
            refused.extend(done.refused.into_iter().map(|point| [chain, point]));
        }
        refused.sort_unstable();
        (changed, refused)
    }

    /// Reports points inside segments; those of an overlap as that alone.
    fn report_touches(&mut self, touches: &[Touch]) {
        let overlapping = touches.iter().filter(|touch| touch.is_overlap);
        let mut within: Vec<[u32; 2]> =
            overlapping.clone().map(|touch| [touch.chain, touch.point]).collect();
        within.dedup(); // sorted as the touches are
        for touch in overlapping {
            let [s, t] = [touch.chain.min(touch.of), touch.chain.max(touch.of)];
            self.draft.overlaps.push([s, t].map(|chain| self.draft.strands[chain as usize].input));
        }
        for same in touches.chunk_by(|a, b| (a.chain, a.point) == (b.chain, b.point)) {
            let Touch { chain, point, of, .. } = same[0];
            if within.binary_search(&[chain, point]).is_err() {
                let segment = self.input(chain);
                self.draft.repairs.push(if of == u32::MAX {
                    Repair::PointOnSegment { point, segment }
                } else {
                    Repair::TJunction { point, segment }
                });
            }
        }
    }

    /// The point at which two pieces that cross are split: an end of one that is hardly off the
    /// other, a point that is there already, or a new one.
    fn point_of(&mut self, pair: [Piece; 2]) -> u32 {
        if let Some(end) = self.end_on_the_other(pair) {
            return end;
        }
        let [first, second] = pair.map(|piece| self.places(piece));
        let [s, t] = pair.map(|piece| around(self.draft, piece.ends));
        let within = s.intersection(&t);
        let exact = crossing(first, second);
        let clamped = [0, 1].map(|k| exact[k].clamp(within.low[k], within.high[k]));
        let place = self.draft.representable(clamped);
        if let Some(point) = self.nearest(place, &within) {
            return point;
        }
        let point = self.draft.make_point(place, self.input(pair[0].chain));
        self.made.add(point, place);
        point
    }

    /// Of the ends of two pieces that cross the one that is least off the other piece, if that is
    /// within reach. (Rounded crossings would let pieces that nearly overlap cross for ever.)
    fn end_on_the_other(&self, [first, second]: [Piece; 2]) -> Option<u32> {
        let mut nearest: Option<(f64, u32)> = None;
        for (from, onto) in [(first, second), (second, first)] {
            let [a, b] = self.places(onto);
            let along = Vector::between(a, b);
            let around = Rectangle::around(a, b);
            for end in from.ends {
                let place = self.draft.place(end);
                let off = along.cross(Vector::between(a, place)).abs() / along.length();
                let is_nearer = nearest.is_none_or(|least| (off, end) < least);
                if off <= self.reach && around.contains(place) && is_nearer {
                    nearest = Some((off, end));
                }
            }
        }
        nearest.map(|(_, end)| end)
    }

    /// The nearest point to a place among those in a rectangle, if one is within reach.
    fn nearest(&self, place: [f64; 2], within: &Rectangle) -> Option<u32> {
        let mut nearest: Option<(f64, u32)> = None;
        let mut compare = |point: u32| {
            let found = self.draft.place(point);
            let [dx, dy] = [found[0] - place[0], found[1] - place[1]];
            let squared = dx * dx + dy * dy;
            let is_nearer = nearest.is_none_or(|least| (squared, point) < least);
            if squared <= self.reach * self.reach && within.contains(found) && is_nearer {
                nearest = Some((squared, point));
            }
        };
        self.made.near(place).for_each(&mut compare);
        let nearby =
            Rectangle { low: place.map(|c| c - self.reach), high: place.map(|c| c + self.reach) };
        let search: ControlFlow<()> = self.boxes.overlapping(&nearby, |item| {
            match self.chains.get(item as usize) {
                Some(chain) => chain.ends.into_iter().for_each(&mut compare),
                None => compare(self.loose[item as usize - self.chains.len()]),
            }
            ControlFlow::Continue(())
        });
        debug_assert!(search.is_continue());
        nearest.map(|(_, point)| point)
    }

    fn is_inside(&self, point: u32, piece: Piece) -> bool {
        is_strictly_between(self.places(piece), self.draft.place(point))
    }

    fn input(&self, chain: u32) -> u32 {
        self.draft.strands[chain as usize].input
    }

    fn places(&self, piece: Piece) -> [[f64; 2]; 2] {
        piece.ends.map(|end| self.draft.place(end))
    }
}

/// Which of two pieces that cross are split at a point: pairs of a chain and the point.
fn splits_of(pair: [Piece; 2], point: u32) -> impl Iterator<Item = [u32; 2]> {
    let split = pair.into_iter().filter(move |piece| !piece.ends.contains(&point));
    split.map(move |piece| [piece.chain, point])
}

fn around(draft: &Draft, ends: [u32; 2]) -> Rectangle {
    let [a, b] = ends.map(|end| draft.place(end));
    Rectangle::around(a, b)
}
