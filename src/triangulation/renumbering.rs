//! Closing the gaps that points leave which were taken out.

use super::{Edge, Triangle, Triangulation};

/// The new number of each vertex and of each slot: `u32::MAX` where it is gone. Those that stay
/// keep their order.
#[derive(Debug, Clone, Default)]
pub struct Renumbering {
    /// By the old vertices.
    pub vertices: Vec<u32>,
    /// By the old slots.
    pub slots: Vec<u32>,
}

impl Renumbering {
    /// Whether a vertex stays.
    #[must_use]
    pub fn keeps(&self, vertex: u32) -> bool {
        self.vertices[vertex as usize] != u32::MAX
    }

    /// The new number of a vertex that stays.
    #[must_use]
    pub fn vertex(&self, vertex: u32) -> u32 {
        self.vertices[vertex as usize]
    }

    /// The new number of a slot that stays.
    #[must_use]
    pub fn slot(&self, slot: u32) -> u32 {
        self.slots[slot as usize]
    }
}

/// New numbers for what stays, counted from 0.
fn counted(stays: impl Iterator<Item = bool>) -> Vec<u32> {
    let mut numbers = 0..;
    stays.map(|stays| if stays { numbers.next().unwrap_or(u32::MAX) } else { u32::MAX }).collect()
}

impl Triangulation {
    /// Takes the vertices `gone`, which have no triangle any more, and vacant slots out of the
    /// numbering.
    pub fn renumber(&mut self, gone: &[u32]) -> Renumbering {
        let mut stays = vec![true; self.points.len()];
        gone.iter().for_each(|&v| stays[v as usize] = false);
        let occupied = self.triangles.iter().map(|triangle| *triangle != Triangle::VACANT);
        let new = Renumbering { slots: counted(occupied), vertices: counted(stays.into_iter()) };

        let mut vertices = 0..;
        self.points.retain(|_| vertices.next().is_some_and(|v| new.keeps(v)));
        let mut slots = 0..;
        self.regions.retain(|_| slots.next().is_some_and(|s: u32| new.slot(s) != u32::MAX));
        self.triangles.retain(|triangle| *triangle != Triangle::VACANT);
        for triangle in &mut self.triangles {
            triangle.vertices = triangle.vertices.map(|v| new.vertex(v));
            triangle.neighbors = triangle.neighbors.map(|behind| match behind.is_outside() {
                true => behind,
                false => Edge::new(new.slot(behind.triangle()), behind.index())
                    .constrained_if(behind.is_constrained()),
            });
        }
        self.anchors.renumber(|v| new.keeps(v), |slot| new.slot(slot));
        self.vacant.clear();
        new
    }
}
