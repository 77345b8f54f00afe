//! Claims 5.3, 8.1 and 10.1, Lemma 7, Theorem 4, Corollaries 2 and 3: whole meshes, judged here from
//! their points and triangles alone.

use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_3, PI, SQRT_2};

use meshwright::formats::Provenance;
use meshwright::{Mesh, MinAngle, Parameters, Pslg, Region, Rule};
use meshwright_campaigns::Random;
use meshwright_campaigns::families::Family;
use meshwright_campaigns::figures::{self, corners};
use meshwright_campaigns::hostile::hostile;
use meshwright_campaigns::judge::judge;
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::plane::{angle, cross, distance, distance_to_segment, minus, polar};

use crate::{f, kappa_hat};

/// Slack of ALGORITHM's G5: equality occurs.
const SLACK: f64 = 1e-7;

/// The default rules.
fn ours() -> Parameters {
    Parameters::default()
}

/// Outlines for the paper's own rules: each in a box, so that its convex hull is a union of
/// segments (Assumption 1 (iv)).
fn boxed_outlines() -> impl Iterator<Item = (String, Pslg)> {
    outlines().map(|(name, outline)| (name, figures::in_a_box(&outline)))
}

/// Outlines for these rules.
fn outlines_for(parameters: &Parameters) -> Vec<(String, Pslg)> {
    match parameters.region {
        Region::Hull => boxed_outlines().collect(),
        Region::Domain | Region::Global => outlines().collect(),
    }
}

/// Outlines of all families, none with angles that take the paper's shells more than some
/// thousand points.
fn outlines() -> impl Iterator<Item = (String, Pslg)> {
    let families = Family::ALL.into_iter().flat_map(|family| {
        (0..4).map(move |seed| (format!("{family:?}, seed {seed}"), family.outline(8, 0.05, seed)))
    });
    let spokes = (900..903).map(|seed| (format!("spokes {seed}"), figures::spokes20(seed)));
    families.chain(spokes)
}

/// For each point strictly inside input segments: which one.
fn segment_of_point(outline: &Pslg, mesh: &Mesh) -> HashMap<u32, u32> {
    let mut inside = HashMap::new();
    for (&edge, &segment) in mesh.edges.iter().zip(&mesh.edge_segments) {
        for v in edge {
            let place = mesh.points[v as usize];
            let ends = outline
                .segments
                .get(segment as usize)
                .map(|s| s.map(|p| outline.points[p as usize]));
            if ends.is_some_and(|ends| !ends.contains(&place)) {
                inside.insert(v, segment);
            }
        }
    }
    inside
}

/// The angle of two segments at their common end; `None` if they have none.
fn angle_of_segments(outline: &Pslg, s: u32, t: u32) -> Option<f64> {
    let [a, b] = outline.segments[s as usize];
    let [c, d] = outline.segments[t as usize];
    let (x, p, q) = match () {
        () if a == c => (a, b, d),
        () if a == d => (a, b, c),
        () if b == c => (b, a, d),
        () if b == d => (b, a, c),
        () => return None,
    };
    let at = |v: u32| outline.points[v as usize];
    (s != t).then(|| angle(at(p), at(x), at(q)))
}

/// Lemma 7: every angle is at least κ̂, or its opposite edge joins two adjoining input segments at
/// θ ≤ π/3 and it is at least f(θ). Hence none is below min{κ̂, f(θ*)}.
#[test]
fn lemma_7() {
    let mut across = 0;
    let kappa = MinAngle::default().radians();
    for parameters in [Parameters::paper(), ours()] {
        for (name, outline) in outlines_for(&parameters) {
            let mesh = judge(&outline, &parameters).well().mesh;
            let on_segment = segment_of_point(&outline, &mesh);
            let theta_star = smallest_angle(&outline).unwrap_or(FRAC_PI_3).min(FRAC_PI_3);
            let smallest_allowed = kappa.min(f(theta_star)) * (1.0 - SLACK);
            for [p, q, r] in corners_of(&mesh) {
                let found = angle_at(&mesh, p, r, q);
                assert!(found >= smallest_allowed, "{name}: {found} < {smallest_allowed}");
                if found >= kappa * (1.0 - 1e-9) {
                    continue;
                }
                across += 1;
                let theta = match (on_segment.get(&p), on_segment.get(&q)) {
                    (Some(&s), Some(&t)) => angle_of_segments(&outline, s, t),
                    _ => None,
                };
                let theta =
                    theta.unwrap_or_else(|| panic!("{name}: {found} at {r} is across nothing"));
                assert!(theta <= FRAC_PI_3 * (1.0 + 1e-9), "{name}: across {theta}");
                assert!(found >= f(theta) * (1.0 - SLACK), "{name}: {found} < f({theta})");
            }
        }
    }
    assert!(across > 100, "only {across} small angles: nothing was exercised");
}

/// Corollary 3: no angle exceeds max{π − 2κ̂, π − 2 arcsin((√3 − 1)/2)}.
#[test]
fn corollary_3() {
    let mut largest_found = 0.0_f64;
    for degrees in [15.0, 20.0, 24.0, MinAngle::default().degrees()] {
        let min_angle = MinAngle::from_degrees(degrees).expect("within the range");
        let bound = (PI - 2.0 * degrees.to_radians())
            .max(PI - 2.0 * libm::asin((libm::sqrt(3.0) - 1.0) / 2.0));
        for parameters in
            [Parameters { min_angle, ..Parameters::paper() }, Parameters { min_angle, ..ours() }]
        {
            for (name, outline) in outlines_for(&parameters) {
                let mesh = judge(&outline, &parameters).well().mesh;
                for [p, q, r] in corners_of(&mesh) {
                    let found = angle_at(&mesh, p, r, q);
                    assert!(
                        found <= bound * (1.0 + 1e-9),
                        "{name} at {degrees}°: {found} > {bound}"
                    );
                    largest_found = largest_found.max(found);
                }
            }
        }
    }
    assert!(largest_found.to_degrees() > 115.0, "{largest_found}: nothing was exercised");
}

/// Claim 8.1: in a Delaunay triangulation, of all points on r's side of the line through p and q
/// the apex r of the triangle pqr sees the edge under the largest angle.
#[test]
fn claim_8_1() {
    let parameters = Parameters { region: Region::Hull, ..ours() };
    for (name, outline) in boxed_outlines() {
        let mesh = judge(&outline, &parameters).well().mesh;
        if mesh.points.len() > 400 {
            continue;
        }
        for [p, q, r] in corners_of(&mesh) {
            let apex = angle_at(&mesh, p, r, q);
            let (a, b) = (mesh.points[p as usize], mesh.points[q as usize]);
            for (other, &place) in (0_u32..).zip(&mesh.points) {
                let same_side = cross(minus(b, a), minus(place, a)) > 0.0;
                if same_side && other != p && other != q {
                    let seen = angle(a, place, b);
                    assert!(seen <= apex + 1e-9, "{name}: {other} sees {p}–{q} better than {r}");
                }
            }
        }
    }
}

/// Claim 5.3 on meshes: between two points that count as input (its ends, §10's "off-centers"), a
/// segment is bisected again and again: |x−y| / |a−b| is a power of two, |x−a| / |a−b| an integer.
#[test]
fn claim_5_3_on_meshes() {
    let mut deepest = 0;
    for (name, outline) in boxed_outlines() {
        let mesh = judge(&outline, &Parameters::paper()).well().mesh;
        for chain in chains(&outline, &mesh) {
            let counts_as_input = |v: &u32| mesh.provenance[*v as usize] != Provenance::Midpoint;
            let stops: Vec<usize> =
                (0..chain.len()).filter(|&i| counts_as_input(&chain[i])).collect();
            assert!(stops.len() <= 5, "{name}: {} off-centers on one segment", stops.len() - 2);
            for stop in stops.windows(2) {
                let part = &chain[stop[0]..=stop[1]];
                let place = |i: usize| mesh.points[part[i] as usize];
                let length = distance(place(0), place(part.len() - 1));
                let (mut pieces, mut at) = (Vec::new(), 0.0);
                for i in 1..part.len() {
                    pieces.push((at, distance(place(i - 1), place(i))));
                    at += pieces[i - 1].1;
                }
                for (from, piece) in pieces {
                    let doublings = libm::log2(length / piece);
                    assert!(
                        (doublings - doublings.round()).abs() < 1e-6,
                        "{name}: {length} / {piece}"
                    );
                    let steps = from / piece;
                    assert!(
                        (steps - steps.round()).abs() < 1e-6 * (1.0 + steps),
                        "{name}: {from} / {piece}"
                    );
                    deepest = deepest.max(doublings.round() as i32);
                }
            }
        }
    }
    assert!(deepest >= 3, "segments were hardly split: {deepest}");
}

/// Claim 5.1 on meshes: between an end x of a segment and the first point that counts as input, a
/// subsegment begins at x or is no longer than its distance from x.
#[test]
fn claim_5_1_on_meshes() {
    let mut away_from_x = 0;
    for (name, outline) in boxed_outlines() {
        let mesh = judge(&outline, &Parameters::paper()).well().mesh;
        for chain in chains(&outline, &mesh) {
            let reversed: Vec<u32> = chain.iter().rev().copied().collect();
            for chain in [chain, reversed] {
                let x = mesh.points[chain[0] as usize];
                for pair in chain.windows(2) {
                    let [a, b] = [pair[0], pair[1]].map(|v| mesh.points[v as usize]);
                    let (near, size) = (distance(x, a), distance(a, b));
                    assert!(near == 0.0 || size <= near * (1.0 + 1e-9), "{name}: {size} at {near}");
                    away_from_x += u32::from(near > 0.0);
                    if mesh.provenance[pair[1] as usize] != Provenance::Midpoint {
                        break;
                    }
                }
            }
        }
    }
    assert!(away_from_x > 100, "only {away_from_x} subsegments say anything");
}

/// Claim 10.1: with shells, Ruppert's own rule ends where κ < κ̂ ∧ f(θ*), and leaves no angle below κ.
#[test]
fn claim_10_1() {
    let mut refined = 0;
    for (name, outline) in boxed_outlines() {
        let Some(theta_star) = smallest_angle(&outline) else { continue };
        let limit = kappa_hat().min(f(theta_star.min(FRAC_PI_3)));
        let kappa = MinAngle::from_degrees((0.999 * limit).to_degrees()).expect("below 26.45°");
        let parameters = Parameters {
            rule: Rule::Ruppert,
            min_angle: kappa,
            max_points: 200_000,
            ..Parameters::paper()
        };
        let mesh = judge(&outline, &parameters).well().mesh;
        refined += mesh.points.len() - outline.points.len().min(mesh.points.len());
        for [p, q, r] in corners_of(&mesh) {
            let found = angle_at(&mesh, p, r, q);
            assert!(
                found >= kappa.radians() * (1.0 - 1e-9),
                "{name}: {found} < {}",
                kappa.radians()
            );
        }
    }
    assert!(refined > 1_000, "{refined} points: nothing was exercised");
}

/// Theorem 4: where adjoining segments have lengths that are the same but for a power of two
/// (Assumption 3), every midpoint that is committed has a radius r ≥ lfs_min / μ,
/// μ = 1 + √2 / (1 − 2 sin κ̂). Hence it ends.
#[test]
fn theorem_4() {
    let mu = 1.0 + SQRT_2 / (1.0 - 2.0 * libm::sin(MinAngle::default().radians()));
    for seed in 0..24 {
        let outline = dyadic_spokes(&mut Random::new(seed));
        let least = smallest_feature_size(&outline) / mu;
        let mesh = judge(&outline, &Parameters::paper()).well().mesh;
        for &[v, w] in &mesh.edges {
            // The radius of a midpoint is the length of the two subsegments that it made.
            let size = distance(mesh.points[v as usize], mesh.points[w as usize]);
            assert!(size >= least * (1.0 - 1e-9), "seed {seed}: {size} < {least}");
        }
    }
}

/// Corollary 2: where Assumption 3 holds, no two points are nearer to each other than
/// lfs_min · 2 sin(θ*/2) / μ.
#[test]
fn corollary_2() {
    let mu = 1.0 + SQRT_2 / (1.0 - 2.0 * libm::sin(MinAngle::default().radians()));
    for seed in 0..24 {
        let outline = dyadic_spokes(&mut Random::new(seed));
        let theta_star = smallest_angle(&outline).unwrap_or(FRAC_PI_3).min(FRAC_PI_3);
        let least = smallest_feature_size(&outline) * 2.0 * libm::sin(0.5 * theta_star) / mu;
        let mesh = judge(&outline, &Parameters::paper()).well().mesh;
        // The closest pair of points is an edge of a Delaunay triangulation.
        for [p, q, _] in corners_of(&mesh) {
            let size = distance(mesh.points[p as usize], mesh.points[q as usize]);
            assert!(size >= least * (1.0 - 1e-9), "seed {seed}: {size} < {least}");
        }
    }
}

/// What Theorem 4 is for: the adaptive rule ends on every input, whatever its angles.
#[test]
fn theorem_4_ends_on_hostile_outlines() {
    for number in 0..40 {
        let outline = hostile(5, number);
        let outcome = meshwright::mesh(&outline, &ours()).expect("hostile outlines are clean");
        assert!(outcome.mesh.points.len() < ours().max_points, "number {number}");
    }
}

/// Spokes in a square, every length a power of two: they conform to Assumption 3, and their shells
/// are midpoints.
fn dyadic_spokes(random: &mut Random) -> Pslg {
    let mut points = corners([-2.0, -2.0], [2.0, 2.0]).to_vec();
    points.push([0.0, 0.0]);
    let mut segments = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    let mut towards = random.direction();
    for _ in 0..random.whole(2, 9) {
        segments.push([4, points.len() as u32]);
        points.push(polar([0.0, 0.0], towards, *random.pick(&[0.25, 0.5, 1.0])));
        towards += random.range(0.02, 0.6);
    }
    figures::outline(points, segments)
}

/// lfs_min = half the least distance of a point and a feature that does not contain it.
fn smallest_feature_size(outline: &Pslg) -> f64 {
    let at = |v: u32| outline.points[v as usize];
    let mut least = f64::INFINITY;
    for (v, &place) in (0_u32..).zip(&outline.points) {
        for (w, &other) in (0_u32..).zip(&outline.points) {
            if v != w {
                least = least.min(distance(place, other));
            }
        }
        for &[a, b] in &outline.segments {
            if v != a && v != b {
                least = least.min(distance_to_segment(place, at(a), at(b)));
            }
        }
    }
    least / 2.0
}

/// The points of each segment that was meshed, from its first end to its second.
fn chains(outline: &Pslg, mesh: &Mesh) -> Vec<Vec<u32>> {
    let mut of_segment: HashMap<u32, Vec<u32>> = HashMap::new();
    for (edge, &segment) in mesh.edges.iter().zip(&mesh.edge_segments) {
        if (segment as usize) < outline.segments.len() {
            of_segment.entry(segment).or_default().extend(edge);
        }
    }
    let mut chains: Vec<_> = of_segment
        .into_iter()
        .map(|(segment, mut chain)| {
            let start = outline.points[outline.segments[segment as usize][0] as usize];
            let far = |v: &u32| distance(start, mesh.points[*v as usize]);
            chain.sort_by(|v, w| far(v).total_cmp(&far(w)));
            chain.dedup();
            (segment, chain)
        })
        .collect();
    chains.sort_unstable();
    chains.into_iter().map(|(_, chain)| chain).collect()
}

/// Each triangle three times: its edge p–q, then the corner r opposite.
fn corners_of(mesh: &Mesh) -> impl Iterator<Item = [u32; 3]> + '_ {
    mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]])
}

/// The angle prq.
fn angle_at(mesh: &Mesh, p: u32, r: u32, q: u32) -> f64 {
    let at = |v: u32| mesh.points[v as usize];
    angle(at(p), at(r), at(q))
}
