use super::super::refine;
use super::super::segments::Segments;
use super::super::sizes::Sizes;
use super::super::sizing::Sizing;
use super::*;
use crate::carve::carve;
use crate::domain::Domain;
use crate::predicates::{Relative, Side, in_circle, side};
use crate::triangulation::initial::triangulate;
use crate::triangulation::{Edge, Triangle, Triangulation};
use crate::{MinAngle, Parameters, Pslg, Region};

/// A room with a slit, a point on its own, a hole and a region, at a slant.
fn room() -> Pslg {
    let turned = |[x, y]: [f64; 2]| [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y];
    let points = [
        [0.0, 0.0],
        [6.0, 0.0],
        [6.0, 4.0],
        [0.0, 4.0],
        [1.0, 1.0],
        [2.5, 1.1],
        [2.4, 1.4],
        [4.0, 0.0],
        [4.0, 4.0],
        [5.0, 2.0],
        [1.0, 3.0],
        [1.5, 3.0],
        [1.25, 3.3],
    ];
    let segments = [
        [0, 7],
        [7, 1],
        [1, 2],
        [2, 8],
        [8, 3],
        [3, 0],
        [4, 5],
        [4, 6],
        [7, 8],
        [10, 11],
        [11, 12],
        [12, 10],
    ];
    Pslg {
        points: points.map(turned).to_vec(),
        segments: segments.to_vec(),
        segment_tags: vec![0; segments.len()],
        holes: vec![turned([1.25, 3.1])],
        regions: vec![crate::formats::Region {
            seed: turned([5.5, 1.0]),
            tag: 3,
            attribute: 3.0,
            max_area: None,
        }],
        ..Pslg::default()
    }
}

/// Refines an outline and lets `judge` see what came of it, with a thinner for it.
fn finished(pslg: &Pslg, parameters: Parameters, judge: impl Fn(&mut Refinement, &mut Thinner)) {
    let (domain, _) = Domain::new(pslg, parameters.region).expect("it is clean");
    let (domain, initial) = triangulate(domain).expect("it can be triangulated");
    let segments = Segments::of(&domain, &initial.points, domain.floor());
    let sizing = Sizing::new(parameters.max_area, &[None], &[]);
    let sizes = Sizes::of(&domain, initial.points.len());
    let carved = carve(initial, &domain);
    let mut refinement = Refinement::new(carved, segments, sizing, sizes, &domain, &parameters);
    refine(&mut refinement, &mut |_| ControlFlow::Continue(()));
    let mut thinner = Thinner::of(&refinement);
    judge(&mut refinement, &mut thinner);
}

/// The room under everything that may be asked of it.
fn each_way(judge: impl Fn(&mut Refinement, &mut Thinner)) {
    let ours = Parameters { max_area: Some(0.2), ..Parameters::default() };
    let soft = MinAngle::soft_from_degrees(33.0).expect("it is below 34°");
    let mut sized = room();
    sized.point_sizes = (0..sized.points.len()).map(|i| if i == 4 { 0.1 } else { 0.8 }).collect();
    finished(&room(), ours, &judge);
    finished(&room(), Parameters { soft_angle: Some(soft), ..ours }, &judge);
    finished(&room(), Parameters { soft_angle: Some(soft), max_area: None, ..ours }, &judge);
    finished(&room(), Parameters { region: Region::Global, ..ours }, &judge);
    finished(&sized, Parameters { max_area: None, ..ours }, &judge);
}

fn all_slots(refinement: &Refinement) -> std::ops::Range<u64> {
    0..refinement.mesh.triangles.len() as u64
}

/// All that a try may change.
fn state(refinement: &Refinement) -> String {
    let Refinement { mesh, provenances, refused, sizes, queue, pending, .. } = refinement;
    let sizes = sizes.as_ref().map(Sizes::of_all);
    let queued = (queue.len(), pending.len());
    format!("{mesh:?} {provenances:?} {refused:?} {sizes:?} {queued:?}")
}

/// Triangles turn counter-clockwise, neighbours know each other, every edge is locally Delaunay,
/// and every subsegment is found by its ends.
fn expect_whole(mesh: &Triangulation) {
    for (slot, triangle) in mesh.triangles.iter().enumerate() {
        if *triangle == Triangle::VACANT {
            continue;
        }
        let corners = mesh.corners(slot as u32);
        assert_eq!(side(corners[0], corners[1], corners[2]), Side::Left);
        for i in 0..3 {
            let edge = Edge::new(slot as u32, i);
            let [a, b] = mesh.ends(edge);
            let behind = mesh.behind(edge);
            if behind.is_outside() {
                continue;
            }
            let back = mesh.behind(behind);
            assert_eq!((back.triangle(), back.index()), (slot as u32, i));
            assert_eq!(back.is_constrained(), behind.is_constrained());
            assert_eq!(mesh.ends(behind), [b, a]);
            let beyond = mesh.points[mesh.apex(behind) as usize];
            let seen = corners.map(|corner| Relative::of(corner, beyond));
            assert!(behind.is_constrained() || !in_circle(seen, || corners, beyond));
        }
    }
    let is_there = |edge: &Edge| mesh.triangles[edge.triangle() as usize] != Triangle::VACANT;
    for edge in mesh.constrained_edges().filter(is_there) {
        let [a, b] = mesh.ends(edge);
        let found = mesh.subsegment(a, b).expect("a subsegment is found by its ends");
        let sides = [found, mesh.behind(found)];
        assert!(
            sides
                .map(|side| (side.triangle(), side.index()))
                .contains(&(edge.triangle(), edge.index()))
        );
    }
}

#[test]
fn a_try_that_is_taken_back_leaves_everything_as_it_was() {
    each_way(|refinement, thinner| {
        let (mut back, mut kept) = (0, 0);
        for _ in 0..400 {
            let before = state(refinement);
            let kept_before = thinner.done.kept;
            refinement.make_try(all_slots(refinement), thinner);
            if thinner.done.kept == kept_before {
                assert_eq!(state(refinement), before);
                back += 1;
            } else {
                kept += 1;
            }
        }
        assert!(back > 20 && kept > 1, "{back} tries taken back, {kept} kept");
    });
}

#[test]
fn between_two_tries_the_mesh_is_whole() {
    each_way(|refinement, thinner| {
        for _ in 0..300 {
            refinement.make_try(all_slots(refinement), thinner);
            expect_whole(&refinement.mesh);
        }
    });
}

#[test]
fn closing_the_gaps_leaves_the_same_mesh_without_them() {
    each_way(|refinement, thinner| {
        for _ in 0..300 {
            refinement.make_try(all_slots(refinement), thinner);
        }
        let places = |mesh: &Triangulation| {
            let there = mesh.triangles.iter().filter(|triangle| **triangle != Triangle::VACANT);
            let corners =
                |t: &Triangle| t.vertices.map(|v| mesh.points[v as usize].map(f64::to_bits));
            there.map(corners).collect::<Vec<_>>()
        };
        let (before, gone) = (places(&refinement.mesh), thinner.gone.len());
        assert!(gone > 0);
        let points = refinement.mesh.points.len();
        refinement.close_gaps(thinner);
        assert_eq!(places(&refinement.mesh), before);
        assert_eq!(refinement.mesh.points.len(), points - gone);
        assert!(!refinement.mesh.triangles.contains(&Triangle::VACANT));
        expect_whole(&refinement.mesh);
        let used: std::collections::BTreeSet<u32> =
            refinement.mesh.triangles.iter().flat_map(|triangle| triangle.vertices).collect();
        let vertices = 0..refinement.mesh.points.len() as u32;
        assert!(
            vertices
                .filter(|&v| refinement.provenances.is_steiner_point(v))
                .all(|v| used.contains(&v))
        );
    });
}

#[test]
fn no_try_leaves_a_bad_triangle_or_misses_a_target_anew() {
    each_way(|refinement, thinner| {
        let bad = |refinement: &Refinement| {
            let all = 0..refinement.mesh.triangles.len() as u32;
            let there = all.filter(|&s| refinement.mesh.triangles[s as usize] != Triangle::VACANT);
            there.filter(|&slot| refinement.trigger(slot).is_some()).count()
        };
        assert_eq!(bad(refinement), 0);
        let missed = refinement.missed().count();
        for _ in 0..300 {
            refinement.make_try(all_slots(refinement), thinner);
            assert_eq!(bad(refinement), 0);
        }
        refinement.close_gaps(thinner);
        assert!(refinement.missed().count() <= missed);
    });
}

/// Every point inside may go, and what is left is the triangulation that was never refined.
#[test]
fn points_taken_out_one_by_one_leave_the_outline() {
    finished(&room(), Parameters::default(), |refinement, thinner| {
        let mut taken = 0;
        while let Some((vertex, slot)) = (0..refinement.mesh.triangles.len() as u32)
            .filter(|&slot| refinement.mesh.triangles[slot as usize] != Triangle::VACANT)
            .find_map(|slot| {
                let vertices = refinement.mesh.triangles[slot as usize].vertices;
                let vertex =
                    vertices.into_iter().find(|&v| refinement.provenances.is_steiner_point(v))?;
                Some((vertex, slot))
            })
        {
            thinner.journal.begin(&refinement.mesh);
            refinement.take_out(vertex, slot, thinner).expect("a star can be filled");
            expect_whole(&refinement.mesh);
            taken += 1;
        }
        assert!(taken > 10, "{taken} points");
        let corners = |i: usize| refinement.mesh.triangles.iter().map(move |t| t.vertices[i]);
        let stays = |v: &u32| *v == u32::MAX || !refinement.provenances.is_steiner_point(*v);
        assert!((0..3).all(|i| corners(i).all(|v| stays(&v))));
    });
}
