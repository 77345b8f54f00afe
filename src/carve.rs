//! Exterior and holes out, regions in.

use std::mem;

use crate::Region;
use crate::corners::{each, next, previous};
use crate::domain::{Domain, OUTSIDE};
use crate::memory::give_back;
use crate::triangulation::initial::Initial;
use crate::triangulation::{Edge, OUTSIDE_THE_REGION, Triangle, Triangulation};

/// The part of the initial triangulation that is meshed (ALGORITHM §7): the triangles of meshed
/// faces. Their region is 0, or `i + 1` for the domain's region `i`. Where the domain is refined
/// within the whole hull the others stay, [`OUTSIDE_THE_REGION`].
#[must_use]
pub fn carve(initial: Initial, domain: &Domain) -> Triangulation {
    if is_meshed_alike(&initial, domain) {
        return Triangulation::new(initial.points, initial.triangles, Vec::new());
    }
    let region = |face: u32| match domain.faces.region(face) {
        _ if !domain.faces.is_meshed(face) => OUTSIDE_THE_REGION,
        None => 0,
        Some(region) => region + 1,
    };
    let mut regions = faces_of_triangles(&initial, domain);
    regions.iter_mut().for_each(|of_triangle| *of_triangle = region(*of_triangle));
    if domain.region == Region::Global {
        return Triangulation::new(initial.points, initial.triangles, regions);
    }
    meshed(initial.points, initial.triangles, regions)
}

/// Whether every triangle is meshed, and in no region: then no face need be known. (With a segment
/// along every edge of the hull, all that is outside is outside of the hull.)
fn is_meshed_alike(initial: &Initial, domain: &Domain) -> bool {
    initial.open.is_empty() && domain.faces.all_are_meshed() && domain.faces.none_has_a_region()
}

/// Takes out what is not meshed.
#[must_use]
pub fn without_the_outside(whole: Triangulation) -> Triangulation {
    meshed(whole.points, whole.triangles, whole.regions)
}

fn meshed(
    points: Vec<[f64; 2]>,
    mut triangles: Vec<Triangle>,
    mut regions: Vec<u32>,
) -> Triangulation {
    if regions.contains(&OUTSIDE_THE_REGION) {
        keep(&mut triangles, |slot| regions[slot] != OUTSIDE_THE_REGION);
        regions.retain(|&region| region != OUTSIDE_THE_REGION);
    }
    if regions.iter().all(|&region| region == 0) {
        give_back(mem::take(&mut regions));
    }
    Triangulation::new(points, triangles, regions)
}

/// The face of the domain that each triangle lies in: floods from the sides of every segment and
/// from the open edges of the hull.
pub fn faces_of_triangles(initial: &Initial, domain: &Domain) -> Vec<u32> {
    let mut flood = Flood::over(&initial.triangles);
    for &slot in &initial.open {
        flood.from(slot, OUTSIDE);
    }
    for (slot, triangle) in (0..).zip(&initial.triangles) {
        if flood.has_reached(slot) {
            continue;
        }
        let constrained = (0..3).filter(|&i| triangle.neighbors[i].is_constrained());
        for i in constrained {
            let ends = [next(i), previous(i)].map(|j| triangle.vertices[j]);
            if let Some(face) = face_to_the_left(domain, ends) {
                flood.from(slot, face);
            }
        }
    }
    flood.faces.iter_mut().filter(|face| **face == UNKNOWN).for_each(|face| *face = OUTSIDE);
    flood.faces
}

/// The face to the left of the segment from one vertex to another; `None` if there is none.
fn face_to_the_left(domain: &Domain, [a, b]: [u32; 2]) -> Option<u32> {
    // The corners of the box around are none of the domain's points.
    if a.max(b) as usize >= domain.input_points.len() {
        return None;
    }
    let fewer = if domain.adjoining(a).len() <= domain.adjoining(b).len() { a } else { b };
    domain.adjoining(fewer).iter().find_map(|&segment| {
        let [left, right] = domain.faces.sides(segment);
        match domain.segments[segment as usize] {
            forward if forward == [a, b] => Some(left),
            backward if backward == [b, a] => Some(right),
            _ => None,
        }
    })
}

/// A face that is not known yet.
const UNKNOWN: u32 = u32::MAX;

/// Gives faces to triangles that are reached without crossing a segment.
struct Flood<'a> {
    triangles: &'a [Triangle],
    faces: Vec<u32>,
    stack: Vec<u32>,
}

impl<'a> Flood<'a> {
    fn over(triangles: &'a [Triangle]) -> Self {
        Self { triangles, faces: vec![UNKNOWN; triangles.len()], stack: Vec::new() }
    }

    fn has_reached(&self, slot: u32) -> bool {
        self.faces[slot as usize] != UNKNOWN
    }

    /// Gives a face to what is reached from `seed` and has none.
    fn from(&mut self, seed: u32, face: u32) {
        if !self.has_reached(seed) {
            self.faces[seed as usize] = face;
            self.stack.push(seed);
        }
        while let Some(slot) = self.stack.pop() {
            let across = self.triangles[slot as usize].neighbors;
            for edge in across.into_iter().filter(|edge| !edge.is_constrained()) {
                if !self.has_reached(edge.triangle()) {
                    self.faces[edge.triangle() as usize] = face;
                    self.stack.push(edge.triangle());
                }
            }
        }
    }
}

/// Keeps some triangles, in their order, with nothing behind their edges to the others.
fn keep(triangles: &mut Vec<Triangle>, is_kept: impl Fn(usize) -> bool) {
    let mut count = 0..;
    let moved = (0..triangles.len()).map(|slot| is_kept(slot).then(|| count.next()).flatten());
    let moved: Vec<u32> = moved.map(|slot| slot.unwrap_or(u32::MAX)).collect();
    let renumber = |edge: Edge| match edge.is_outside() {
        true => edge,
        false => match moved[edge.triangle() as usize] {
            u32::MAX => Edge::OUTSIDE,
            slot => Edge::new(slot, edge.index()).constrained_if(edge.is_constrained()),
        },
    };
    let mut slots = 0..;
    triangles.retain_mut(|triangle| {
        triangle.neighbors = each(triangle.neighbors, renumber);
        slots.next().is_some_and(&is_kept)
    });
}
