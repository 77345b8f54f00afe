//! Faults planted in good meshes are found, under the right guarantee and in the right place.
//!
//! Three meshes are made here by hand, independent of the refinement: grids whose inner points are
//! shaken, with a hole, an interface and a slit, and a small angle. One is Lake Superior's, as
//! meshwright makes it. Every random choice comes from [`SEED`].

use meshwright::Mesh;
use meshwright::certify::{Fault, FaultKind, Guarantee, Promise, certify};
use meshwright::formats::Membership;

mod subjects;

use subjects::{Point, Random, Subject, area, in_circle, member, subjects};

/// Printed with every failure.
const SEED: u64 = 0x5eed_0003;
/// How often each kind of fault is planted.
const PLANTINGS: usize = 240;

/// A damaged mesh, and where the damage is.
struct Planting {
    mesh: Mesh,
    /// Points around the damage: the witness lies in their bounding box.
    damage: Vec<Point>,
}

/// Plants faults into all meshes, and expects each one to be found: a fault of `guarantee` for
/// which `is_it` holds, in the bounding box of the damage.
fn finds(
    guarantee: Guarantee,
    plant: impl Fn(&Subject, &mut Random) -> Option<Planting>,
    is_it: impl Fn(&FaultKind) -> bool,
) {
    let mut random = Random(SEED);
    let subjects = subjects(&mut random);
    let mut planted = 0;
    for round in 0.. {
        assert!(round < 100 * PLANTINGS, "only {planted} plantings were possible");
        if planted >= PLANTINGS && round % subjects.len() == 0 {
            break;
        }
        let mut subject = subjects[round % subjects.len()].clone();
        if random.below(2) == 0 {
            subject.mesh.edge_segments.clear(); // as a file that does not hold them
        }
        let Some(planting) = plant(&subject, &mut random) else { continue };
        planted += 1;
        let certificate = certify(&subject.pslg, &planting.mesh, &Promise::default());
        let judgement = certificate.judgement(guarantee);
        let found = judgement
            .first
            .iter()
            .any(|fault| is_it(&fault.kind) && is_inside(fault, &planting.damage));
        assert!(
            found,
            "seed {SEED:#x}, round {round}, {}: no such fault of {guarantee:?} near {:?} in\n{certificate}{:#?}",
            subject.name, planting.damage, judgement.first
        );
    }
}

fn is_inside(fault: &Fault, damage: &[Point]) -> bool {
    (0..2).all(|i| {
        let values = damage.iter().map(|p| p[i]);
        let (least, most) = (
            values.clone().fold(f64::INFINITY, f64::min),
            values.fold(f64::NEG_INFINITY, f64::max),
        );
        (least - 1e-9..=most + 1e-9).contains(&fault.place[i])
    })
}

#[test]
fn the_meshes_are_good_before_anything_is_planted() {
    for mut subject in subjects(&mut Random(SEED)) {
        let certificate = certify(&subject.pslg, &subject.mesh, &Promise::default());
        assert!(certificate.holds() && !certificate.limited(), "{}:\n{certificate}", subject.name);
        subject.mesh.edge_segments.clear();
        let certificate = certify(&subject.pslg, &subject.mesh, &Promise::default());
        assert!(certificate.holds() && !certificate.limited(), "{}:\n{certificate}", subject.name);
    }
}

#[test]
fn a_moved_vertex_is_found() {
    finds(
        Guarantee::Complex,
        |subject, random| {
            // Over the far edge of one of its triangles: that triangle is clockwise then.
            let mut mesh = subject.mesh.clone();
            let v = random
                .pick(&[steiner_points(subject, false), steiner_points(subject, true)].concat());
            let star = star(&mesh, v);
            let mut damage = corners(&mesh, &star);
            let triangle = mesh.triangles[random.pick(&star)];
            let others: Vec<Point> =
                triangle.iter().filter(|&&w| w != v).map(|&w| mesh.points[w as usize]).collect();
            let p = mesh.points[v as usize];
            let middle = [0.5 * (others[0][0] + others[1][0]), 0.5 * (others[0][1] + others[1][1])];
            mesh.points[v as usize] =
                [p[0] + 1.3 * (middle[0] - p[0]), p[1] + 1.3 * (middle[1] - p[1])];
            damage.push(mesh.points[v as usize]);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::Clockwise),
    );
}

#[test]
fn a_flipped_edge_is_found() {
    finds(
        Guarantee::Delaunay,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let (t, k) = (random.below(mesh.triangles.len()), random.below(3));
            let [a, b, c] = [0, 1, 2].map(|i| mesh.triangles[t][(k + i) % 3]);
            let is_listed = mesh.edges.iter().any(|e| *e == [a, b] || *e == [b, a]);
            let other = mesh
                .triangles
                .iter()
                .position(|u| (0..3).any(|i| u[i] == b && u[(i + 1) % 3] == a));
            let u = other.filter(|_| !is_listed)?;
            let d = *mesh.triangles[u].iter().find(|v| **v != a && **v != b)?;
            let at = |v: u32| mesh.points[v as usize];
            let convex = area(at(a), at(d), at(c)) > 1e-6 && area(at(d), at(b), at(c)) > 1e-6;
            if !convex || in_circle(at(a), at(b), at(c), at(d)).abs() < 1e-9 {
                return None;
            }
            (mesh.triangles[t], mesh.triangles[u]) = ([a, d, c], [d, b, c]);
            let damage = [a, b, c, d].map(|v| mesh.points[v as usize]).to_vec();
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::NotDelaunay),
    );
}

#[test]
fn a_turned_triangle_is_found() {
    finds(
        Guarantee::Complex,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let t = random.below(mesh.triangles.len());
            mesh.triangles[t].swap(1, 2);
            let damage = corners(&mesh, &[t]);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::Clockwise),
    );
}

#[test]
fn a_missing_triangle_is_found() {
    finds(
        Guarantee::Complex,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let t = random.below(mesh.triangles.len());
            let damage = corners(&mesh, &[t]);
            mesh.triangles.remove(t);
            mesh.triangle_tags.remove(t);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::Gap | FaultKind::Unmeshed),
    );
}

#[test]
fn a_doubled_triangle_is_found() {
    finds(
        Guarantee::Complex,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let t = random.below(mesh.triangles.len());
            mesh.triangles.push(mesh.triangles[t]);
            mesh.triangle_tags.push(mesh.triangle_tags[t]);
            let damage = corners(&mesh, &[t]);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::Overlap),
    );
}

#[test]
fn a_missing_boundary_edge_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let e = random.below(mesh.edges.len());
            let damage = mesh.edges[e].map(|v| mesh.points[v as usize]).to_vec();
            remove_edge(&mut mesh, e);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::Unlisted),
    );
}

#[test]
fn a_surplus_boundary_edge_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let triangle = random.pick(&mesh.triangles);
            let edge = if random.below(4) == 0 {
                random.pick(&mesh.edges) // one of the list again
            } else {
                [triangle[0], triangle[1]]
            };
            let is_new = |e: &[u32; 2]| *e != edge && *e != [edge[1], edge[0]];
            let is_interior = mesh.edges.iter().all(is_new);
            let damage = edge.map(|v| mesh.points[v as usize]).to_vec();
            mesh.edges.push(edge);
            mesh.edge_tags.push(random.pick(&subject.mesh.edge_tags));
            if !mesh.edge_segments.is_empty() {
                let said =
                    if is_interior { random.pick(&subject.mesh.edge_segments) } else { u32::MAX };
                mesh.edge_segments.push(said);
            }
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::Surplus),
    );
}

#[test]
fn a_lost_input_point_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let v = random.below(subject.pslg.points.len());
            let i = random.below(2);
            let p = &mut mesh.points[v];
            p[i] =
                if random.below(2) == 0 { p[i].next_up() } else { p[i] + 1e-3 * random.signed() };
            let damage = vec![subject.pslg.points[v]];
            (mesh.points[v] != subject.pslg.points[v]).then_some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::LostPoint),
    );
}

#[test]
fn an_unexcused_angle_is_found() {
    finds(
        Guarantee::SmallAngles,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let t = random.below(mesh.triangles.len());
            let [a, b, c] = mesh.triangles[t];
            let [p, q, r] = [a, b, c].map(|v| mesh.points[v as usize]);
            let d = mesh.points.len() as u32;
            let inner = [0, 1].map(|i| 0.44 * p[i] + 0.44 * q[i] + 0.12 * r[i]);
            mesh.points.push(inner);
            mesh.triangles[t] = [a, b, d];
            mesh.triangles.extend([[b, c, d], [c, a, d]]);
            mesh.triangle_tags.extend([mesh.triangle_tags[t]; 2]);
            Some(Planting { mesh, damage: vec![p, q, r] })
        },
        |kind| matches!(kind, FaultKind::UnexcusedAngle),
    );
}

#[test]
fn a_wrong_boundary_tag_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let e = random.below(mesh.edges.len());
            let old = mesh.edge_tags[e];
            mesh.edge_tags[e] = random.pick(&[0, 1, 2, 3, 7, -5]);
            let damage = mesh.edges[e].map(|v| mesh.points[v as usize]).to_vec();
            (mesh.edge_tags[e] != old).then_some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::WrongBoundaryTag { .. }),
    );
}

#[test]
fn a_lost_group_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let lost = random.below(mesh.memberships.len().max(1));
            let lost = (lost < mesh.memberships.len()).then(|| mesh.memberships.remove(lost))?;
            let damage = members(&mesh, lost);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::LostGroup { .. }),
    );
}

#[test]
fn a_group_that_the_outline_does_not_give_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let dim = random.below(2) as u8;
            let count = if dim == 0 { mesh.points.len() } else { mesh.edges.len() };
            let strange = member(dim, random.below(count) as u32, random.pick(&[4, 8, 9, 77]));
            let is_tag = dim == 1 && mesh.edge_tags[strange.item as usize] == strange.tag;
            if is_tag || mesh.memberships.contains(&strange) {
                return None;
            }
            mesh.memberships.push(strange);
            let damage = members(&mesh, strange);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::StrangeGroup { .. }),
    );
}

#[test]
fn a_group_with_another_number_is_lost_and_strange() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let i = random.below(mesh.memberships.len().max(1));
            mesh.memberships.get_mut(i)?.tag = 77;
            let damage = members(&mesh, mesh.memberships[i]);
            let certificate = certify(&subject.pslg, &mesh, &Promise::default());
            assert_eq!(certificate.judgement(Guarantee::Conforming).faults, 2);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::LostGroup { .. }),
    );
}

#[test]
fn a_wrong_region_tag_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let t = random.below(mesh.triangles.len());
            let old = mesh.triangle_tags[t];
            mesh.triangle_tags[t] = random.pick(&[0, 1, 2, 10, 20, -5]);
            let damage = corners(&mesh, &[t]);
            (mesh.triangle_tags[t] != old).then_some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::WrongRegionTag { .. }),
    );
}

#[test]
fn an_unused_vertex_is_found() {
    finds(
        Guarantee::Complex,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let p = random.pick(&mesh.points);
            let new = [p[0] + random.signed(), p[1] + random.signed()];
            mesh.points.push(new);
            Some(Planting { mesh, damage: vec![new] })
        },
        |kind| matches!(kind, FaultKind::UnusedPoint),
    );
}

#[test]
fn a_vertex_off_its_segment_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            // Two units in the last place are enough.
            let mut mesh = subject.mesh.clone();
            let v = random.pick(&steiner_points(subject, true));
            let [a, b] = neighbours_on_segment(&mesh, v);
            let (p, along) = (mesh.points[v as usize], [b[0] - a[0], b[1] - a[1]]);
            let size = p[0].abs().max(p[1].abs())
                * f64::EPSILON
                * 2.0
                * 10_f64.powi(random.below(12) as i32);
            let length = along[0].hypot(along[1]);
            let size = size.min(0.2 * length);
            mesh.points[v as usize] =
                [p[0] - size * along[1] / length, p[1] + size * along[0] / length];
            let damage = vec![a, b, p, mesh.points[v as usize]];
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::OffSegment { .. }),
    );
}

#[test]
fn a_chain_that_runs_back_is_found() {
    finds(
        Guarantee::Conforming,
        |subject, random| {
            let mut mesh = subject.mesh.clone();
            let on_segments = steiner_points(subject, true);
            let pairs: Vec<_> =
                mesh.edges.iter().filter(|e| e.iter().all(|v| on_segments.contains(v))).collect();
            let &[v, w] = pairs[random.below(pairs.len())];
            let damage = [v, w].map(|v| mesh.points[v as usize]).to_vec();
            mesh.points.swap(v as usize, w as usize);
            Some(Planting { mesh, damage })
        },
        |kind| matches!(kind, FaultKind::NotMonotone),
    );
}

#[test]
fn a_hole_that_is_meshed_is_found() {
    let mut random = Random(SEED);
    let subject = &subjects(&mut random)[0];
    let mut mesh = subject.mesh.clone();
    let corners = [[4.0, 2.0], [5.0, 2.0], [5.0, 3.0], [4.0, 3.0]];
    let [a, b, c, d] = corners.map(|p| mesh.points.iter().position(|q| *q == p).unwrap() as u32);
    mesh.triangles.extend([[a, b, c], [a, c, d]]);
    mesh.triangle_tags.extend([10, 10]);
    let certificate = certify(&subject.pslg, &mesh, &Promise::default());
    let complex = certificate.judgement(Guarantee::Complex);
    assert_eq!(complex.faults, 4, "{certificate}");
    assert!(complex.first.iter().all(|fault| fault.kind == FaultKind::Overmeshed));
    assert!(complex.first.iter().all(|fault| is_inside(fault, &corners)));
}

#[test]
fn a_face_that_is_not_meshed_is_found() {
    let mut random = Random(SEED);
    let subject = &subjects(&mut random)[0];
    let mut mesh = subject.mesh.clone();
    let kept = |i: &usize| subject.mesh.triangle_tags[*i] != 20;
    mesh.triangles =
        (0..mesh.triangles.len()).filter(kept).map(|i| subject.mesh.triangles[i]).collect();
    mesh.triangle_tags.retain(|tag| *tag != 20);
    let certificate = certify(&subject.pslg, &mesh, &Promise::default());
    let complex = certificate.judgement(Guarantee::Complex);
    let unmeshed = complex.first.iter().filter(|fault| fault.kind == FaultKind::Unmeshed);
    assert!(unmeshed.clone().count() > 10, "{certificate}");
    assert!(unmeshed.clone().all(|fault| fault.place[0] >= 6.0), "{certificate}");
}

/// Points that are no input: on segments, or not.
fn steiner_points(subject: &Subject, on_segments: bool) -> Vec<u32> {
    let mesh = &subject.mesh;
    let mut is_on = vec![false; mesh.points.len()];
    for v in mesh.edges.iter().flatten() {
        is_on[*v as usize] = true;
    }
    (subject.pslg.points.len() as u32..mesh.points.len() as u32)
        .filter(|v| is_on[*v as usize] == on_segments)
        .collect()
}

fn neighbours_on_segment(mesh: &Mesh, v: u32) -> [Point; 2] {
    let beside = mesh.edges.iter().filter(|e| e.contains(&v));
    let others: Vec<u32> = beside.map(|e| if e[0] == v { e[1] } else { e[0] }).collect();
    [others[0], others[1]].map(|w| mesh.points[w as usize])
}

/// The triangles at a point.
fn star(mesh: &Mesh, v: u32) -> Vec<usize> {
    (0..mesh.triangles.len()).filter(|&t| mesh.triangles[t].contains(&v)).collect()
}

/// Where the member of a group is.
fn members(mesh: &Mesh, membership: Membership) -> Vec<Point> {
    let item = membership.item as usize;
    let points = if membership.dim == 0 { vec![item as u32] } else { mesh.edges[item].to_vec() };
    points.into_iter().map(|v| mesh.points[v as usize]).collect()
}

fn corners(mesh: &Mesh, triangles: &[usize]) -> Vec<Point> {
    triangles.iter().flat_map(|&t| mesh.triangles[t]).map(|v| mesh.points[v as usize]).collect()
}

fn remove_edge(mesh: &mut Mesh, e: usize) {
    mesh.edges.remove(e);
    mesh.edge_tags.remove(e);
    if !mesh.edge_segments.is_empty() {
        mesh.edge_segments.remove(e);
    }
}
