//! Thinning, as a caller of the library meets it.

use std::ops::ControlFlow;

use meshwright::formats::{Mesh, poly};
use meshwright::{Error, Outcome, Parameters, Pslg, Steiner, Thinning, mesh, mesh_with, trace};

fn superior() -> Pslg {
    let text = include_bytes!("../examples/lake_superior.poly");
    poly::read(text, "lake_superior.poly", |_| unreachable!("it holds its points")).expect("read").0
}

fn thinned(thinning: Thinning) -> Parameters {
    Parameters { steiner: Steiner::LookAhead, thinning, ..Parameters::default() }
}

fn meshed(pslg: &Pslg, parameters: &Parameters) -> Outcome {
    let outcome = mesh(pslg, parameters).expect("it is clean");
    assert!(outcome.certificate.holds(), "{}", outcome.certificate);
    outcome
}

fn bits(mesh: &Mesh) -> (Vec<[u64; 2]>, &[[u32; 3]]) {
    (mesh.points.iter().map(|point| point.map(f64::to_bits)).collect(), &mesh.triangles)
}

#[test]
fn the_same_outline_is_thinned_to_the_same_mesh() {
    let lake = superior();
    let [first, second] = [0, 1].map(|_| meshed(&lake, &thinned(Thinning::Tries(3_000))));
    assert_eq!(first.thinned, second.thinned);
    assert_eq!(bits(&first.mesh), bits(&second.mesh));
}

#[test]
fn doubling_the_coordinates_doubles_the_thinned_mesh() {
    let lake = superior();
    let mut large = lake.clone();
    large.points.iter_mut().flatten().for_each(|c| *c *= 2.0);
    large.holes.iter_mut().flatten().for_each(|c| *c *= 2.0);
    let [small, large] =
        [lake, large].map(|pslg| meshed(&pslg, &thinned(Thinning::Tries(2_000))).mesh);
    assert_eq!(small.triangles, large.triangles);
    let doubled: Vec<_> = small.points.iter().map(|point| point.map(|c| 2.0 * c)).collect();
    assert_eq!(doubled, large.points);
}

#[test]
fn twenty_tries_for_each_point_save_more_than_one() {
    let lake = superior();
    let none = meshed(&lake, &thinned(Thinning::None));
    assert_eq!(none.thinned, None);
    let [one, twenty] = [Thinning::Tries(1_000), Thinning::Auto].map(|thinning| {
        let outcome = meshed(&lake, &thinned(thinning));
        let told = outcome.thinned.expect("it is thinned");
        assert!(!told.stopped && told.kept <= told.tries);
        assert_eq!(none.mesh.points.len() - outcome.mesh.points.len(), told.saved as usize);
        told
    });
    assert_eq!(one.tries, 1_000);
    assert!(twenty.tries > 10_000 && twenty.saved > one.saved && one.saved > 0, "{twenty:?}");
}

#[test]
fn areas_are_kept() {
    let lake = superior();
    let parameters = Parameters { max_area: Some(1e-3), ..thinned(Thinning::Tries(3_000)) };
    let outcome = meshed(&lake, &parameters);
    assert!(outcome.thinned.is_some_and(|thinned| thinned.saved > 0));
    for corners in outcome.mesh.triangles.iter().map(|t| t.map(|v| outcome.mesh.points[v as usize]))
    {
        let [[ax, ay], [bx, by], [cx, cy]] = corners;
        assert!((bx - ax) * (cy - ay) - (by - ay) * (cx - ax) <= 2e-3 * (1.0 + 1e-9));
    }
}

#[test]
fn an_outline_without_points_inside_has_nothing_to_thin() {
    let square = Pslg {
        points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
        segment_tags: vec![0; 4],
        ..Pslg::default()
    };
    for thinning in [Thinning::Tries(u64::MAX), Thinning::Auto] {
        let told = meshed(&square, &thinned(thinning)).thinned.expect("it was asked for");
        assert_eq!((told.tries, told.saved, told.stopped), (0, 0, false));
    }
}

#[test]
fn thinning_that_is_stopped_leaves_a_whole_mesh() {
    let lake = superior();
    let mut told = 0;
    let parameters = thinned(Thinning::Tries(1_000_000));
    let outcome = mesh_with(&lake, &parameters, &mut |progress| match progress.thinning {
        Some(tried) if tried.tries >= 2_000 => ControlFlow::Break(()),
        Some(_) => {
            told += 1;
            ControlFlow::Continue(())
        }
        None => ControlFlow::Continue(()),
    });
    let outcome = outcome.expect("a mesh is there");
    assert!(told > 1 && outcome.certificate.holds());
    let thinned = outcome.thinned.expect("it was thinned");
    assert!(thinned.stopped && (2_000..10_000).contains(&thinned.tries) && thinned.saved > 0);
    let none = meshed(&lake, &self::thinned(Thinning::None)).mesh.points.len();
    assert_eq!(none - outcome.mesh.points.len(), thinned.saved as usize);
}

#[test]
fn a_refinement_that_is_stopped_is_still_no_mesh() {
    let lake = superior();
    let parameters = thinned(Thinning::Auto);
    let outcome = mesh_with(&lake, &parameters, &mut |_| ControlFlow::Break(()));
    assert!(matches!(outcome, Err(Error::Cancelled)));
}

#[test]
fn a_run_that_stops_at_its_budget_is_not_thinned() {
    let parameters = Parameters { max_points: 1_400, ..thinned(Thinning::Auto) };
    let outcome = mesh(&superior(), &parameters).expect("it is clean");
    assert_eq!(outcome.thinned, None);
}

#[test]
fn a_trace_tells_no_thinning() {
    let traced = trace(&superior(), &thinned(Thinning::Auto), &mut |_| ());
    assert!(matches!(traced, Err(Error::TraceOfThinning)));
}
