//! Thinning a finished mesh (ALGORITHM §5): a few Steiner points out, as few as possible in.
//!
//! A try takes a random Steiner point and up to two of its neighbours out, and puts points in
//! again until no bad triangle is left, by look-ahead's rule. It is kept where no more points came
//! in than went out; else it is taken back. Tries that change nothing in number are kept too: they
//! are the moves that lead to the others. Points on segments stay.
//!
//! Between two tries the mesh is a complete one that every promise holds for: a removal makes no
//! edge shorter, and what comes in obeys the rule of every Steiner point. Tries are counted, never
//! timed, and the random numbers are the same each time: one input, one mesh.
//!
//! A try costs its neighbourhood alone ([`Journal`]), and tries go through the mesh tile by tile:
//! so a million points take minutes.

mod attempt;
#[cfg(test)]
mod tests;

use std::ops::ControlFlow;

use super::queue::Entry;
use super::survey::Survey;
use super::{Progress, Refinement};
use crate::parameters::Thinning;
use crate::random::Random;
use crate::triangulation::{Journal, Star};
use attempt::Found;

/// How many tries there are for each Steiner point with [`Thinning::Auto`].
const TRIES_PER_POINT: u64 = 20;
/// Tries are made tile by tile, this many slots each: a tile stays in the cache.
const TILE: usize = 1 << 12;
/// Progress is told after this many tries.
const PROGRESS_STEP: u64 = 1 << 10;
/// So often a triangle is drawn for a Steiner point; then the try is over.
const DRAWS: usize = 64;

/// What thinning did.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Thinned {
    /// How many tries there were.
    pub tries: u64,
    /// How many of them were kept.
    pub kept: u64,
    /// How many points the mesh has less.
    pub saved: u64,
    /// Whether the progress callback stopped it, before all tries were made.
    pub stopped: bool,
}

/// How far thinning has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tried {
    /// How many tries there were.
    pub tries: u64,
    /// How many there will be.
    pub of: u64,
    /// How many points the mesh has less.
    pub saved: u64,
}

/// Thins a finished mesh, as its parameters ask. The callback may stop it; what it has done by then
/// stays. `None` where it is not asked for, or where no point can go.
pub fn thin(
    refinement: &mut Refinement,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Option<Thinned> {
    let tries = match refinement.parameters.thinning {
        Thinning::None => return None,
        Thinning::Tries(tries) => tries,
        Thinning::Auto => TRIES_PER_POINT * refinement.steiner_points(),
    };
    refinement.forget_what_was_refused_and_is_gone();
    let mut thinner = Thinner::of(refinement);
    let stopped = refinement.make_tries(tries, &mut thinner, progress).is_break();
    refinement.close_gaps(&mut thinner);
    Some(Thinned { stopped, ..thinner.done })
}

/// What thinning keeps from one try to the next.
#[derive(Debug)]
struct Thinner {
    random: Random,
    done: Thinned,
    /// Points that are out of the mesh, but not yet out of the numbering.
    gone: Vec<u32>,
    /// Slots of triangles that were refused a Steiner point, in order: they stay as they are.
    frozen: Vec<u32>,
    star: Star,
    journal: Journal,
    /// The triangles that a try makes; some of them are gone again.
    made: Vec<u32>,
    /// Of these, the bad ones.
    bad: Vec<Found>,
    /// Of these, the ones with an angle that misses the soft target.
    missed: Vec<Found>,
    survey: Survey,
    /// The points that a try takes out.
    out: Vec<u32>,
}

impl Thinner {
    fn of(refinement: &Refinement) -> Self {
        let mut thinner = Self {
            random: Random::default(),
            done: Thinned::default(),
            gone: Vec::new(),
            frozen: Vec::new(),
            star: Star::default(),
            journal: Journal::default(),
            made: Vec::new(),
            bad: Vec::new(),
            missed: Vec::new(),
            survey: Survey::default(),
            out: Vec::new(),
        };
        thinner.freeze(refinement);
        thinner
    }

    /// Leaves alone what was refused.
    fn freeze(&mut self, refinement: &Refinement) {
        self.frozen = refinement.refused.triangles.iter().map(|entry| entry.slot()).collect();
        self.frozen.sort_unstable();
    }

    fn touches_frozen(&self, slots: &[u32]) -> bool {
        !self.frozen.is_empty() && slots.iter().any(|slot| self.frozen.binary_search(slot).is_ok())
    }
}

impl Refinement<'_> {
    /// How many Steiner points lie inside, on no segment.
    fn steiner_points(&self) -> u64 {
        let vertices = 0..self.mesh.points.len() as u32;
        vertices.filter(|&v| self.provenances.is_steiner_point(v)).count() as u64
    }

    fn forget_what_was_refused_and_is_gone(&mut self) {
        let mut refused = std::mem::take(&mut self.refused.triangles);
        refused.retain(|&entry| self.is_still_there(entry));
        self.refused.triangles = refused;
    }

    /// So many tries, in rounds of one for each Steiner point.
    fn make_tries(
        &mut self,
        tries: u64,
        thinner: &mut Thinner,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.tell_tries(tries, thinner, progress)?;
        while thinner.done.tries < tries {
            let round = self.steiner_points().min(tries - thinner.done.tries);
            if round == 0 {
                break;
            }
            let slots = self.mesh.triangles.len();
            let tiles = slots.div_ceil(TILE) as u64;
            let end_of = |part: u64, whole: usize| {
                (u128::from(part) * whole as u128 / u128::from(tiles)) as u64
            };
            for tile in 0..tiles {
                let slots = end_of(tile, slots)..end_of(tile + 1, slots);
                for _ in end_of(tile, round as usize)..end_of(tile + 1, round as usize) {
                    self.make_try(slots.clone(), thinner);
                    if thinner.done.tries.is_multiple_of(PROGRESS_STEP) {
                        self.tell_tries(tries, thinner, progress)?;
                    }
                }
            }
            self.close_gaps(thinner);
        }
        ControlFlow::Continue(())
    }

    fn tell_tries(
        &self,
        of: u64,
        thinner: &Thinner,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let Thinned { tries, saved, .. } = thinner.done;
        progress(Progress {
            points: self.mesh.points.len() - thinner.gone.len(),
            triangles: self.mesh.triangles.len(),
            waiting: 0,
            thinning: Some(Tried { tries, of, saved }),
        })
    }

    /// One try at a random Steiner point of these slots.
    fn make_try(&mut self, slots: std::ops::Range<u64>, thinner: &mut Thinner) {
        thinner.done.tries += 1;
        let Some((vertex, slot)) = self.draw(slots, &mut thinner.random) else { return };
        thinner.journal.begin(&self.mesh);
        match self.attempt(vertex, slot, thinner) {
            Some(saved) => {
                thinner.done.kept += 1;
                thinner.done.saved += saved;
                thinner.gone.append(&mut thinner.out);
            }
            None => self.take_back(thinner),
        }
    }

    /// A random Steiner point with a triangle in one of these slots.
    fn draw(&self, slots: std::ops::Range<u64>, random: &mut Random) -> Option<(u32, u32)> {
        let count = slots.end - slots.start;
        (0..DRAWS).find_map(|_| {
            let slot = (slots.start + random.below(count)) as u32;
            let vertex = self.mesh.triangles[slot as usize].vertices[random.below(3) as usize];
            self.provenances.is_steiner_point(vertex).then_some((vertex, slot))
        })
    }

    fn take_back(&mut self, thinner: &mut Thinner) {
        self.mesh.undo(&mut thinner.journal);
        let points = self.mesh.points.len();
        self.provenances.truncate(points);
        if let Some(sizes) = &mut self.sizes {
            sizes.truncate(points);
        }
    }

    /// Takes the points that are gone out of the numbering.
    fn close_gaps(&mut self, thinner: &mut Thinner) {
        let new = self.mesh.renumber(&thinner.gone);
        thinner.gone.clear();
        self.provenances.retain(|v| new.keeps(v));
        if let Some(sizes) = &mut self.sizes {
            sizes.retain(|v| new.keeps(v));
        }
        let refused = std::mem::take(&mut self.refused.subsegments);
        self.refused.subsegments =
            refused.into_iter().map(|ends| ends.map(|v| new.vertex(v))).collect();
        for entry in &mut self.refused.triangles {
            let (slot, newest) = (new.slot(entry.slot()), new.vertex(entry.newest));
            *entry = Entry::new(slot, newest, entry.reason());
        }
        thinner.freeze(self);
    }
}
