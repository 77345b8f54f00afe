//! Exterior and holes out, regions in.

use crate::domain::Domain;
use crate::triangulation::initial::Initial;
use crate::triangulation::{Edge, Triangle, Triangulation};

/// The part of the initial triangulation that is meshed (ALGORITHM §7): what no flood from the
/// outside or from a hole seed reaches without crossing a segment. Region `i + 1` is what a flood
/// from region seed `i` reaches; where two seeds stand in one face the first wins.
#[must_use]
pub fn carve(initial: Initial, domain: &Domain) -> Triangulation {
    let mut gone = vec![false; initial.triangles.len()];
    if !domain.hull {
        let seeds = initial.open.iter().chain(initial.holes.iter().flatten());
        for &seed in seeds {
            flood(&initial.triangles, seed, &mut gone, |gone| !std::mem::replace(gone, true));
        }
    }
    let mut regions = vec![0; initial.triangles.len()];
    for (i, seed) in initial.regions.iter().enumerate() {
        if let Some(seed) = *seed {
            let number = i as u32 + 1;
            flood(&initial.triangles, seed, &mut regions, |region| {
                *region == 0 && std::mem::replace(region, number) == 0
            });
        }
    }
    keep(initial, &gone, &regions)
}

/// Visits everything that is reached from `seed` without crossing a subsegment and that `enter`
/// is true of.
fn flood<T>(
    triangles: &[Triangle],
    seed: u32,
    marks: &mut [T],
    mut enter: impl FnMut(&mut T) -> bool,
) {
    let mut stack = vec![seed];
    while let Some(slot) = stack.pop() {
        if enter(&mut marks[slot as usize]) {
            let across = triangles[slot as usize].neighbors.iter();
            stack.extend(across.filter(|edge| !edge.is_constrained()).map(|edge| edge.triangle()));
        }
    }
}

fn keep(initial: Initial, gone: &[bool], regions: &[u32]) -> Triangulation {
    let kept: Vec<usize> = (0..gone.len()).filter(|&slot| !gone[slot]).collect();
    let mut moved = vec![u32::MAX; gone.len()];
    for (new, &old) in kept.iter().enumerate() {
        moved[old] = new as u32;
    }
    let renumber = |edge: Edge| {
        if edge.is_outside() || gone[edge.triangle() as usize] {
            return Edge::OUTSIDE;
        }
        Edge::new(moved[edge.triangle() as usize], edge.index())
            .constrained_if(edge.is_constrained())
    };
    let triangles = kept.iter().map(|&slot| {
        let Triangle { vertices, neighbors } = initial.triangles[slot];
        Triangle { vertices, neighbors: neighbors.map(renumber) }
    });
    let triangles = triangles.collect();
    let any_region = kept.iter().any(|&slot| regions[slot] != 0);
    let regions = kept.iter().filter(|_| any_region).map(|&slot| regions[slot]).collect();
    Triangulation::new(initial.points, triangles, regions)
}
