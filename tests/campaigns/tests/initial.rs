//! The initial constrained triangulation, compared with that of `spade`.

mod support;

use std::collections::BTreeMap;

use meshwright::domain::Domain;
use meshwright::triangulation::initial::{Initial, triangulate};
use meshwright::{Pslg, Region};
use meshwright_campaigns::Random;
use meshwright_campaigns::families::Family;
use meshwright_campaigns::hostile::hostile;
use proptest::prelude::*;
use robust::{Coord, incircle};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};

/// The edges of a triangulation (smaller vertex first), each with the vertices opposite it.
type Edges = BTreeMap<[usize; 2], Vec<usize>>;

fn edges(triangles: impl Iterator<Item = [usize; 3]>) -> Edges {
    let mut edges = Edges::new();
    for [a, b, c] in triangles {
        for (u, v, apex) in [(a, b, c), (b, c, a), (c, a, b)] {
            edges.entry([u.min(v), u.max(v)]).or_default().push(apex);
        }
    }
    edges
}

fn of_ours(initial: &Initial) -> Edges {
    edges(initial.triangles.iter().map(|triangle| triangle.vertices.map(|v| v as usize)))
}

fn of_spade(domain: &Domain) -> Edges {
    let points = domain.points.iter().map(|&[x, y]| Point2::new(x, y)).collect();
    let segments = domain.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    let mut conflicts = 0;
    let cdt: ConstrainedDelaunayTriangulation<Point2<f64>> =
        ConstrainedDelaunayTriangulation::try_bulk_load_cdt(points, segments, |_| conflicts += 1)
            .expect("the coordinates are within spade's range");
    assert_eq!(conflicts, 0);
    edges(cdt.inner_faces().map(|face| face.vertices().map(|vertex| vertex.index())))
}

/// The two may differ only where four points lie on one circle, exactly.
fn agrees_with_spade(outline: &Pslg, region: Region) {
    let (domain, _) = Domain::new(outline, region).expect("it is clean");
    let (domain, initial) = triangulate(domain).expect("it is within range");
    let (ours, spades) = (of_ours(&initial), of_spade(&domain));
    assert_eq!(ours.len(), spades.len());
    let at = |v: usize| {
        let [x, y] = domain.points[v];
        Coord { x, y }
    };
    for (&[u, v], apexes) in ours.iter().filter(|(edge, _)| !spades.contains_key(*edge)) {
        let [p, q] = apexes[..] else { panic!("edge {u} {v} of the hull is ours alone") };
        assert_eq!(incircle(at(u), at(v), at(p), at(q)), 0.0, "edge {u} {v}, apexes {p} {q}");
    }
    for &[a, b] in &domain.segments {
        let [a, b] = [a as usize, b as usize];
        assert!(ours.contains_key(&[a.min(b), a.max(b)]), "segment {a} {b}");
    }
    for (slot, triangle) in initial.triangles.iter().enumerate() {
        for (i, edge) in triangle.neighbors.iter().enumerate().filter(|(_, e)| !e.is_outside()) {
            let back = initial.triangles[edge.triangle() as usize].neighbors[edge.index()];
            assert_eq!((back.triangle() as usize, back.index()), (slot, i));
            assert_eq!(back.is_constrained(), edge.is_constrained());
        }
    }
}

proptest! {
    #![proptest_config(support::cases(200))]

    #[test]
    fn every_initial_triangulation_is_that_of_spade(
        family in prop::sample::select(Family::ALL.to_vec()),
        size in 1_usize..60,
        exponent in -5.0..-0.3,
        seed: u64,
        region in prop::sample::select(vec![Region::Domain, Region::Hull]),
    ) {
        agrees_with_spade(&family.outline(size, libm::exp10(exponent), seed), region);
    }

    /// Long segments across many points: most triangles that they cross come anew.
    #[test]
    fn long_segments_across_many_points_are_edges(seed: u64, points in 3_usize..400, lattice: bool) {
        let random = &mut Random::new(seed);
        let place = |random: &mut Random| {
            let c = random.unit();
            if lattice { (c * 16.0).floor() / 16.0 } else { c }
        };
        let mut outline = Pslg::default();
        for _ in 0..points {
            outline.points.push([place(random), place(random)]);
        }
        outline.points.extend([[0.47, -3.0], [0.53, 4.0], [-3.0, 0.51], [4.0, 0.48]]);
        for _ in 0..24 {
            let ends = [0, 1].map(|_| random.whole(0, outline.points.len() - 1) as u32);
            let ends = if random.chance(0.2) { [outline.points.len() as u32 - 1, ends[0]] } else { ends };
            outline.segments.push(ends);
            outline.segment_tags.push(0);
            if Domain::new(&outline, Region::Hull).is_err() {
                outline.segments.pop();
                outline.segment_tags.pop();
            }
        }
        if Domain::new(&outline, Region::Hull).is_ok() {
            agrees_with_spade(&outline, Region::Hull);
        }
    }
}

#[test]
fn hostile_outlines_are_triangulated_as_by_spade() {
    for number in 0..60 {
        agrees_with_spade(&hostile(9, number), Region::Domain);
    }
}

#[test]
fn points_on_one_line_but_for_one_are_triangulated() {
    for n in [2, 3, 50] {
        let line = (0..n).map(|i| [f64::from(i), 2.0 * f64::from(i)]);
        let points = line.chain([[0.5, 7.0]]).collect();
        let outline = Pslg { points, ..Pslg::default() };
        agrees_with_spade(&outline, Region::Hull);
    }
}
