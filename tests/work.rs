//! The work of a run, in counts that no machine changes: what makes it slower shows here first.

use meshwright::refine::counters::Counters;
use meshwright::{Outcome, Parameters, Pslg, Steiner, mesh};

/// Random points in a box (the generator is Knuth's, MMIX).
fn points(count: usize) -> Pslg {
    let mut state = 1_u64;
    let mut unit = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut points = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    points.extend((0..count).map(|_| [unit(), unit()]));
    let segments = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    Pslg { points, segments, segment_tags: vec![1; 4], ..Pslg::default() }
}

fn work(outline: &Pslg, parameters: &Parameters) -> Counters {
    mesh(outline, parameters).expect("it is meshed").counters
}

#[test]
fn a_steiner_point_replaces_few_triangles_and_few_wait_in_vain() {
    let found = work(&points(10_000), &Parameters::default());
    let stale = found.stale as f64 / found.popped as f64;
    assert!((12_000..13_500).contains(&found.committed), "{found:?}");
    assert!(found.mean_cavity() < 4.3, "{found:?}");
    assert!(stale < 0.6, "{found:?}");
}

/// More wait there than one tile holds: squares fill up one after the other.
#[test]
fn a_square_that_fills_up_by_tiles_keeps_every_promise_with_few_more_points() {
    let by_area = |max_area| Parameters { max_area: Some(max_area), ..Parameters::default() };
    let made = |max_area| mesh(&points(0), &by_area(max_area)).expect("it is meshed");
    let (coarse, fine) = (made(1e-4), made(5e-6));
    assert!(fine.certificate.holds(), "{:?}", fine.certificate);
    let filling = |made: &Outcome, max_area: f64| 1.0 / max_area / made.mesh.triangles.len() as f64;
    let (coarse, fine) = (filling(&coarse, 1e-4), filling(&fine, 5e-6));
    assert!((fine / coarse - 1.0).abs() < 0.02, "{coarse} {fine}");
}

#[test]
fn points_at_random_leave_hardly_a_question_open() {
    let found = work(&points(10_000), &Parameters::default());
    assert!(found.exact < 20, "{found:?}");
}

#[test]
fn a_grid_asks_no_more_than_a_few_exact_questions_for_each_point() {
    let side = 100;
    let at = |i: usize| [(i % side) as f64 / 99.0, (i / side) as f64 / 99.0];
    let grid = Pslg { points: (0..side * side).map(at).collect(), ..Pslg::default() };
    let found = work(&grid, &Parameters::default());
    assert!((1..6 * 10_000).contains(&found.exact), "{found:?}");
}

#[test]
fn look_ahead_commits_fewer_points() {
    let outline = points(2_000);
    let ahead = Parameters { steiner: Steiner::LookAhead, ..Parameters::default() };
    let (usual, ahead) = (work(&outline, &Parameters::default()), work(&outline, &ahead));
    assert!(ahead.committed < usual.committed, "{ahead:?} {usual:?}");
}
