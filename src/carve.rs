//! Exterior and holes out, regions in.

use crate::Region;
use crate::corners::{each, next, previous};
use crate::domain::{Domain, OUTSIDE};
use crate::triangulation::initial::Initial;
use crate::triangulation::{Edge, OUTSIDE_THE_REGION, Triangle, Triangulation};

/// The part of the initial triangulation that is meshed (ALGORITHM §7): the triangles of meshed
/// faces. Their region is 0, or `i + 1` for the domain's region `i`. Where the domain is refined
/// within the whole hull the others stay, [`OUTSIDE_THE_REGION`].
#[must_use]
pub fn carve(initial: Initial, domain: &Domain) -> Triangulation {
    let faces = faces_of_triangles(&initial, domain);
    let region = |&face: &u32| match domain.faces.region(face) {
        _ if !domain.faces.is_meshed(face) => OUTSIDE_THE_REGION,
        None => 0,
        Some(region) => region + 1,
    };
    let regions = faces.iter().map(region).collect();
    if domain.region == Region::Global {
        return Triangulation::new(initial.points, initial.triangles, regions);
    }
    meshed(initial.points, &initial.triangles, &regions)
}

/// Takes out what is not meshed.
#[must_use]
pub fn without_the_outside(whole: Triangulation) -> Triangulation {
    meshed(whole.points, &whole.triangles, &whole.regions)
}

fn meshed(points: Vec<[f64; 2]>, triangles: &[Triangle], regions: &[u32]) -> Triangulation {
    let is_kept = |&slot: &usize| regions[slot] != OUTSIDE_THE_REGION;
    let kept: Vec<usize> = (0..triangles.len()).filter(is_kept).collect();
    let regions: Vec<u32> = kept.iter().map(|&slot| regions[slot]).collect();
    let any_region = regions.iter().any(|&region| region != 0);
    let regions = if any_region { regions } else { Vec::new() };
    Triangulation::new(points, renumbered(triangles, &kept), regions)
}

/// The face of the domain that each triangle lies in: floods from the sides of every segment and
/// from the open edges of the hull.
pub fn faces_of_triangles(initial: &Initial, domain: &Domain) -> Vec<u32> {
    let mut faces = vec![None; initial.triangles.len()];
    for &slot in &initial.open {
        flood(&initial.triangles, slot, OUTSIDE, &mut faces);
    }
    for (slot, triangle) in initial.triangles.iter().enumerate() {
        let constrained = (0..3).filter(|&i| triangle.neighbors[i].is_constrained());
        for i in constrained {
            let ends = [next(i), previous(i)].map(|j| triangle.vertices[j]);
            if let Some(face) = face_to_the_left(domain, initial, ends) {
                flood(&initial.triangles, slot as u32, face, &mut faces);
            }
        }
    }
    faces.into_iter().map(|face| face.unwrap_or(OUTSIDE)).collect()
}

/// The face to the left of the segment from one vertex to another; `None` if there is none.
fn face_to_the_left(domain: &Domain, initial: &Initial, ends: [u32; 2]) -> Option<u32> {
    // The corners of the box around are none of the domain's points.
    let [Some(&a), Some(&b)] = ends.map(|v| initial.domain_points.get(v as usize)) else {
        return None;
    };
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

/// Gives a face to every triangle that is reached from `seed` without crossing a segment.
fn flood(triangles: &[Triangle], seed: u32, face: u32, faces: &mut [Option<u32>]) {
    let mut stack = vec![seed];
    while let Some(slot) = stack.pop() {
        if faces[slot as usize].is_none() {
            faces[slot as usize] = Some(face);
            let across = triangles[slot as usize].neighbors.iter();
            stack.extend(across.filter(|edge| !edge.is_constrained()).map(|edge| edge.triangle()));
        }
    }
}

/// The triangles in the slots that are `kept`, with nothing behind those that are not.
fn renumbered(triangles: &[Triangle], kept: &[usize]) -> Vec<Triangle> {
    let mut moved = vec![None; triangles.len()];
    for (new, &old) in kept.iter().enumerate() {
        moved[old] = Some(new as u32);
    }
    let renumber = |edge: Edge| {
        let slot = if edge.is_outside() { None } else { moved[edge.triangle() as usize] };
        slot.map_or(Edge::OUTSIDE, |slot| {
            Edge::new(slot, edge.index()).constrained_if(edge.is_constrained())
        })
    };
    kept.iter()
        .map(|&slot| {
            let Triangle { vertices, neighbors } = triangles[slot];
            Triangle { vertices, neighbors: each(neighbors, renumber) }
        })
        .collect()
}
