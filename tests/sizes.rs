//! Target sizes at the points of an outline.

use meshwright::{Outcome, Parameters, Pslg, Region, Splitting, mesh};

/// A unit square with these sizes at its corners, counter-clockwise from the origin.
fn square(sizes: [f64; 4]) -> Pslg {
    Pslg {
        points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        point_sizes: sizes.to_vec(),
        segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
        segment_tags: vec![0; 4],
        ..Pslg::default()
    }
}

fn meshed(pslg: &Pslg, parameters: &Parameters) -> Outcome {
    let outcome = mesh(pslg, parameters).expect("it is clean");
    assert!(outcome.certificate.holds(), "{}", outcome.certificate);
    outcome
}

/// How many triangles Gmsh 4.15 makes of the same squares (`gmsh -2`, sizes at the corners).
const GMSH: [([f64; 4], usize); 7] = [
    ([0.2; 4], 66),
    ([0.1; 4], 242),
    ([0.05; 4], 944),
    ([0.02; 4], 5_824),
    ([0.01, 0.1, 0.1, 0.01], 2_566),
    ([0.01, 0.1, 0.1, 0.1], 676),
    ([0.1, 0.01, 0.1, 0.01], 1_258),
];

#[test]
fn sizes_make_about_as_many_triangles_as_in_gmsh() {
    for (sizes, of_gmsh) in GMSH {
        let ours = meshed(&square(sizes), &Parameters::default()).mesh.triangles.len();
        let ratio = ours as f64 / of_gmsh as f64;
        assert!((0.75..1.25).contains(&ratio), "{sizes:?}: {ours} against {of_gmsh}");
    }
}

/// Without sizes anywhere nothing changes; with one at a single point that point is refined.
#[test]
fn points_without_a_size_ask_for_nothing() {
    let none = meshed(&square([f64::INFINITY; 4]), &Parameters::default()).mesh;
    assert_eq!(none.triangles.len(), 2);
    let one = [0.05, f64::INFINITY, f64::INFINITY, f64::INFINITY];
    assert!(meshed(&square(one), &Parameters::default()).mesh.triangles.len() > 500);
}

#[test]
fn edges_are_as_long_as_the_size_where_they_are() {
    let mesh = meshed(&square([0.01, 0.1, 0.1, 0.01]), &Parameters::default()).mesh;
    for triangle in &mesh.triangles {
        let corners = triangle.map(|v| mesh.points[v as usize]);
        let size = corners.iter().map(|[x, _]| 0.01 + 0.09 * x).sum::<f64>() / 3.0;
        for i in 0..3 {
            let [[ax, ay], [bx, by]] = [corners[i], corners[(i + 1) % 3]];
            let length = (bx - ax).hypot(by - ay);
            assert!(length < 1.7 * size, "an edge of {length} where the size is {size}");
        }
    }
}

#[test]
fn sizes_go_with_every_way_of_refining() {
    let sized = square([0.02, 0.2, 0.1, 0.05]);
    let ours = Parameters::default();
    for parameters in [
        Parameters { incremental: true, ..ours },
        Parameters { region: Region::Global, ..ours },
        Parameters { max_area: Some(0.001), ..ours },
        Parameters { splitting: Splitting::Augment, ..Parameters::paper() },
    ] {
        assert!(meshed(&sized, &parameters).mesh.triangles.len() > 300, "{parameters:?}");
    }
}

#[test]
fn scaling_an_outline_and_its_sizes_scales_the_mesh() {
    let small = square([0.02, 0.2, 0.1, 0.05]);
    let mut large = small.clone();
    large.points.iter_mut().flatten().for_each(|c| *c *= 1024.0);
    large.point_sizes.iter_mut().for_each(|size| *size *= 1024.0);
    let [small, large] = [small, large].map(|pslg| meshed(&pslg, &Parameters::default()).mesh);
    assert_eq!(small.triangles, large.triangles);
}
