//! Figures 11 and 12: 20 spokes.

use meshwright::{Mesh, Parameters, Pslg};
use meshwright_campaigns::figures::spokes20;
use meshwright_campaigns::judge::judge;
use meshwright_campaigns::plane::distance;

/// The distance of the first point on each spoke from the axle.
fn first_cuts(outline: &Pslg, mesh: &Mesh) -> Vec<f64> {
    let axle = outline.points[4];
    let spokes = (0..).zip(&outline.segments).filter(|(_, ends)| ends.contains(&4));
    let first = |(spoke, _): (u32, _)| {
        let own = mesh.edges.iter().zip(&mesh.edge_segments).filter(|&(_, &s)| s == spoke);
        let distances = own.flat_map(|(edge, _)| edge.map(|v| mesh.points[v as usize]));
        let distances = distances.map(|point| distance(axle, point));
        distances.filter(|&d| d > 0.0).fold(f64::INFINITY, f64::min)
    };
    spokes.map(first).collect()
}

/// Figure 12: "all spokes are split at the same distance from the axle", a power of two of about
/// an eighth of the shortest spoke: 1/32 or 1/64. In one draw of many there are both.
#[test]
fn figure_12() {
    let mut same = 0;
    for seed in 900..920 {
        let outline = spokes20(seed);
        let cuts = first_cuts(&outline, &judge(&outline, &Parameters::paper()).well().mesh);
        assert_eq!(cuts.len(), 20);
        let is = |cut: f64, power: f64| (cut / power - 1.0).abs() < 1e-12;
        same += u32::from([1.0 / 32.0, 1.0 / 64.0].iter().any(|&p| cuts.iter().all(|&c| is(c, p))));
    }
    assert!(same >= 19, "in {same} of 20 draws all spokes are cut alike");
}
