//! What changes, so that it can be taken back: a move that does not pay costs its neighbourhood,
//! not a copy of the mesh.

use super::subsegments::Anchored;
use super::{Cavity, Star, Triangle, Triangulation};

/// One change, with what was there before.
#[derive(Debug, Clone, Copy)]
enum Change {
    /// A slot gets another triangle, or its triangle another neighbour.
    Triangle { slot: u32, was: Triangle, region: u32 },
    /// A constrained edge gets another triangle.
    Anchors(Anchored),
    /// The last slot of those that are vacant is taken.
    Occupied(u32),
    /// A slot is vacant from now on.
    Vacated,
}

/// The changes since [`Journal::begin`].
#[derive(Debug, Clone, Default)]
pub struct Journal {
    changes: Vec<Change>,
    points: usize,
    triangles: usize,
}

impl Journal {
    /// Forgets everything: what is now can be restored later.
    pub fn begin(&mut self, mesh: &Triangulation) {
        self.changes.clear();
        self.points = mesh.points.len();
        self.triangles = mesh.triangles.len();
    }

    /// How many points there were.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// Notes what the commit of a Steiner point with this cavity is about to change.
    pub fn note_commit(&mut self, mesh: &Triangulation, cavity: &Cavity) {
        self.note_slots(mesh, &cavity.star);
        let more = cavity.size().saturating_sub(cavity.star.len());
        let taken = mesh.vacant.iter().rev().take(more);
        self.changes.extend(taken.map(|&slot| Change::Occupied(slot)));
        for side in cavity.sides() {
            if !side.behind.is_outside() {
                self.note_slots(mesh, &[side.behind.triangle()]);
            }
            if side.behind.is_constrained() {
                self.changes.push(Change::Anchors(mesh.anchors.now(side.ends)));
            }
        }
    }

    /// Notes what [`Triangulation::remove`] is about to change.
    pub fn note_removal(&mut self, mesh: &Triangulation, star: &Star) {
        self.note_slots(mesh, star.slots());
        for (ends, behind) in star.link() {
            if !behind.is_outside() {
                self.note_slots(mesh, &[behind.triangle()]);
            }
            if behind.is_constrained() {
                self.changes.push(Change::Anchors(mesh.anchors.now(ends)));
            }
        }
        self.changes.extend([Change::Vacated; 2]);
    }

    fn note_slots(&mut self, mesh: &Triangulation, slots: &[u32]) {
        self.changes.extend(slots.iter().map(|&slot| Change::Triangle {
            slot,
            was: mesh.triangles[slot as usize],
            region: mesh.region(slot),
        }));
    }
}

impl Triangulation {
    /// Takes back all that was noted, the latest change first.
    pub fn undo(&mut self, journal: &mut Journal) {
        while let Some(change) = journal.changes.pop() {
            match change {
                Change::Triangle { slot, was, region } => self.set_slot(slot, was, region),
                Change::Anchors(was) => self.anchors.restore(was),
                Change::Occupied(slot) => {
                    self.set_slot(slot, Triangle::VACANT, 0);
                    self.vacant.push(slot);
                }
                Change::Vacated => {
                    self.vacant.pop();
                }
            }
        }
        self.points.truncate(journal.points);
        self.anchors.truncate(journal.points);
        self.triangles.truncate(journal.triangles);
        self.regions.truncate(journal.triangles);
    }

    /// Puts a triangle into a slot.
    pub(super) fn set_slot(&mut self, slot: u32, triangle: Triangle, region: u32) {
        self.triangles[slot as usize] = triangle;
        if let Some(of_slot) = self.regions.get_mut(slot as usize) {
            *of_slot = region;
        }
    }
}
