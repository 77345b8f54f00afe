//! What the certificate says of the shortest edge (G8), the kinds of the points (G9) and the
//! stiffness matrix (G10), beside what is computed here.

use std::f64::consts::{FRAC_PI_3, SQRT_2};

use meshwright::certify::{Guarantee, Promise, Verdict, certify};
use meshwright::domain::Domain;
use meshwright::formats::Provenance;
use meshwright::{MinAngle, Parameters, Pslg, Region, Splitting};
use meshwright_campaigns::families::Family;
use meshwright_campaigns::figures;
use meshwright_campaigns::hostile::hostile;
use meshwright_campaigns::judge::judge;
use meshwright_campaigns::plane::{cross, distance, dot, minus};

/// Outlines of every family, with angles that are not too small.
fn outlines() -> impl Iterator<Item = (String, Pslg)> {
    Family::ALL.into_iter().flat_map(|family| {
        (0..4).map(move |seed| (format!("{family:?} {seed}"), family.outline(6, 0.3, seed)))
    })
}

/// G8: no edge is shorter than Corollary 2 says, lfs′_min·2 sin(θ*/2)/μ, μ = 1 + √2/(1 − 2 sin κ̂), for
/// the outline augmented by the shell points; and the judge's figures are those computed here.
#[test]
fn the_certificate_judges_corollary_2() {
    let mu = 1.0 + SQRT_2 / (1.0 - 2.0 * libm::sin(MinAngle::default().radians()));
    let hostile = (0..40).map(|number| (format!("hostile {number}"), hostile(5, number)));
    let mut least_pessimism = f64::INFINITY;
    for (name, outline) in outlines().chain(hostile) {
        let (domain, _) = Domain::new(&outline, Region::Domain).expect("it is clean");
        if domain.scale_exponent != 0 {
            continue; // at 1e-300 the bound is subnormal: a double with few digits
        }
        // Plain doubles would lose seven digits of an angle of 1e-9 rad.
        let theta = domain.smallest_angle().map_or(FRAC_PI_3, |least| least.radians).min(FRAC_PI_3);
        for splitting in [Splitting::Ladder, Splitting::Shells] {
            if splitting == Splitting::Shells && theta < 0.01 {
                continue; // millions of points
            }
            let parameters = Parameters { splitting, ..Parameters::default() };
            let made = judge(&outline, &parameters).well();
            let verdict = made.certificate.verdict(Guarantee::ShortestEdge);
            assert!(
                [Verdict::Holds, Verdict::LimitedByPrecision].contains(&verdict),
                "{name}: {verdict:?}"
            );
            let found = made.certificate.corollary_2.expect("the kinds of the points are known");
            let ratio = found.bound * mu / (2.0 * libm::sin(0.5 * theta)) / found.lfs_min;
            assert!((ratio - 1.0).abs() < 1e-9, "{name}: {ratio}");
            let mesh = &made.mesh;
            let at = |v: u32| mesh.points[v as usize];
            let sides = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
            let shortest = sides.map(|[v, w]| distance(at(v), at(w))).fold(f64::INFINITY, f64::min);
            assert!((found.shortest / shortest - 1.0).abs() < 1e-9, "{name}");
            // Cut at no shell point at all the feature size is that of the outline.
            if !mesh.provenance.contains(&Provenance::Shell) {
                let lfs_min = domain.lfs_min().expect("it is small");
                assert!((found.lfs_min / lfs_min - 1.0).abs() < 1e-9, "{name}");
            }
            if verdict == Verdict::Holds {
                least_pessimism = least_pessimism.min(found.shortest / found.bound);
            }
        }
    }
    assert!((1.0..1e3).contains(&least_pessimism), "{least_pessimism}");
}

/// Corollary 2 is about what the outline asks for: edges that a bound on areas made shorter are a
/// fault only of a run that had none.
#[test]
fn corollary_2_does_not_speak_of_sizes() {
    let outline = figures::outline(
        figures::corners([0.0, 0.0], [1.0, 1.0]).to_vec(),
        vec![[0, 1], [1, 2], [2, 3], [3, 0]],
    );
    let fine = Parameters { max_area: Some(1e-4), ..Parameters::default() };
    let made = judge(&outline, &fine).well();
    let verdict = |is_plain| {
        let promise = Promise { is_plain, ..Promise::default() };
        certify(&outline, &made.mesh, &promise).verdict(Guarantee::ShortestEdge)
    };
    assert_eq!(verdict(Some(true)), Verdict::Fails);
    for other in [None, Some(false)] {
        assert!(matches!(verdict(other), Verdict::NotJudged(_)), "{other:?}");
    }
}

/// G9: a point whose kind is not where it lies is found.
#[test]
fn a_kind_that_is_not_true_is_found() {
    let outline = figures::spokes20(900);
    let mut mesh = judge(&outline, &Parameters::default()).well().mesh;
    for v in [0, mesh.points.len() - 1] {
        let was = mesh.provenance[v];
        for kind in [Provenance::Input, Provenance::Midpoint, Provenance::Circumcenter] {
            mesh.provenance[v] = kind;
            let certificate = certify(&outline, &mesh, &Promise::default());
            let judgement = certificate.judgement(Guarantee::Provenance);
            assert_eq!(judgement.faults, usize::from(kind != was && !same_place(kind, was)));
            assert!(judgement.first.iter().all(|fault| fault.point == Some(v as u32)));
        }
        mesh.provenance[v] = was;
    }
    mesh.provenance.clear();
    let certificate = certify(&outline, &mesh, &Promise::default());
    for guarantee in [Guarantee::ShortestEdge, Guarantee::Provenance] {
        assert!(matches!(certificate.verdict(guarantee), Verdict::NotJudged(_)));
    }
}

/// Shell points and midpoints both lie inside of segments.
fn same_place(a: Provenance, b: Provenance) -> bool {
    let is_inside = |kind| matches!(kind, Provenance::Shell | Provenance::Midpoint);
    is_inside(a) && is_inside(b)
}

/// G10, by the matrix itself: with a conductivity of its own on each side of every segment, no entry
/// outside the diagonal is positive.
#[test]
fn the_stiffness_matrix_is_an_m_matrix() {
    for (name, outline) in outlines() {
        let made = judge(&outline, &Parameters::default()).well();
        assert_eq!(made.certificate.verdict(Guarantee::Matrix), Verdict::Holds, "{name}");
        let mesh = &made.mesh;
        let at = |v: u32| mesh.points[v as usize];
        let mut entries: Vec<([u32; 2], f64)> = Vec::new();
        for &[a, b, c] in &mesh.triangles {
            for [p, q, apex] in [[a, b, c], [b, c, a], [c, a, b]] {
                let (u, v) = (minus(at(p), at(apex)), minus(at(q), at(apex)));
                entries.push(([p.min(q), p.max(q)], dot(u, v) / cross(u, v)));
            }
        }
        let mut bound: Vec<[u32; 2]> =
            mesh.edges.iter().map(|&[v, w]| [v.min(w), v.max(w)]).collect();
        bound.sort_unstable();
        entries.sort_by_key(|&(edge, _)| edge);
        for group in entries.chunk_by(|(e, _), (f, _)| e == f) {
            let cotangents = group.iter().map(|&(_, cotangent)| cotangent);
            let least = match bound.binary_search(&group[0].0) {
                Ok(_) => cotangents.fold(f64::INFINITY, f64::min),
                Err(_) => cotangents.sum(),
            };
            assert!(least >= -1e-9, "{name}: edge {:?} has {least}", group[0].0);
        }
    }
}
