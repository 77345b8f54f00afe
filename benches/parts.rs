//! The parts of a run, one by one: `cargo bench`. For comparing one state of the code with another on
//! one machine; the `benchmark` campaign compares whole runs with other programs.

use std::io;

use divan::{Bencher, black_box};
use meshwright::certify::{Promise, certify};
use meshwright::domain::Domain;
use meshwright::formats::{poly, vtu};
use meshwright::statistics::Statistics;
use meshwright::triangulation::initial::triangulate;
use meshwright::{Mesh, Parameters, Pslg, Region, mesh};

const POINTS: [usize; 2] = [10_000, 100_000];

fn main() {
    divan::main();
}

/// Points spread evenly (by the fractional parts of multiples of two irrational numbers), in a box.
fn outline(count: usize) -> Pslg {
    let spread =
        |i: usize| [0.754_877_666, 0.569_840_291].map(|step: f64| (step * i as f64).fract());
    let mut points = vec![[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]];
    points.extend((1..=count).map(spread));
    let segments = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    Pslg { points, segments, segment_tags: vec![1; 4], ..Pslg::default() }
}

fn unjudged() -> Parameters {
    Parameters { judged: false, ..Parameters::default() }
}

fn meshed(count: usize) -> (Pslg, Mesh) {
    let outline = outline(count);
    let mesh = mesh(&outline, &unjudged()).expect("the outline is clean").mesh;
    (outline, mesh)
}

#[divan::bench(args = POINTS)]
fn read_poly(bencher: Bencher, count: usize) {
    let mut text = Vec::new();
    poly::write_outline(&outline(count), &mut text).expect("memory takes everything");
    bencher.bench(|| {
        poly::read(black_box(&text), "points.poly", |_| Err(io::ErrorKind::NotFound.into()))
    });
}

#[divan::bench(args = POINTS)]
fn judge_the_outline(bencher: Bencher, count: usize) {
    let outline = outline(count);
    bencher.bench(|| Domain::new(black_box(&outline), Region::Domain));
}

#[divan::bench(args = POINTS)]
fn triangulate_it(bencher: Bencher, count: usize) {
    let (domain, _) = Domain::new(&outline(count), Region::Domain).expect("the outline is clean");
    bencher.with_inputs(|| domain.clone()).bench_values(|domain| triangulate(black_box(domain)));
}

#[divan::bench(args = POINTS)]
fn all_but_the_judge(bencher: Bencher, count: usize) {
    let outline = outline(count);
    bencher.bench(|| mesh(black_box(&outline), &unjudged()));
}

#[divan::bench(args = POINTS)]
fn judge_the_mesh(bencher: Bencher, count: usize) {
    let (outline, mesh) = meshed(count);
    bencher.bench(|| certify(black_box(&outline), black_box(&mesh), &Promise::default()));
}

#[divan::bench(args = POINTS)]
fn measure_the_mesh(bencher: Bencher, count: usize) {
    let (_, mesh) = meshed(count);
    bencher.bench(|| Statistics::of(black_box(&mesh)));
}

#[divan::bench(args = POINTS)]
fn write_vtu(bencher: Bencher, count: usize) {
    let (_, mesh) = meshed(count);
    bencher.bench(|| vtu::write(black_box(&mesh), &mut Vec::new()));
}
