//! The paper's own figures: its rules on its outlines, each beside what a straight reading gives.

use std::path::Path;
use std::time::Duration;

use meshwright::domain::Domain;
use meshwright::{MinAngle, Outcome, Parameters, Pslg, Region, Rule, Splitting, mesh};
use meshwright_campaigns::experiments::spokes::{SEEDS, common_cut};
use meshwright_campaigns::experiments::{grouped, median, paper};
use meshwright_campaigns::figures;

use super::read;
use super::table::{Bound, Table};

/// The figures of §11 and what hangs on them. Lake Superior is in the large collection.
pub fn figures(table: &mut Table, data: Option<&Path>) -> std::io::Result<()> {
    for degrees in [1.0, 0.1, 0.01] {
        let wedge = figures::wedge(f64::to_radians(degrees));
        let name = format!("wedge of {degrees}°, the paper's rules");
        table.mesh(&name, &wedge, &paper(Splitting::Shells), Bound::default());
    }
    spokes(table);
    if let Some(data) = data {
        let (lake, boxed) =
            (read(data, "paper/superior.poly")?, read(data, "paper/superior_box.poly")?);
        figure_10(table, &boxed);
        ruppert(table, &lake);
        lfs_min(table, &lake);
    }
    Ok(())
}

/// Figures 11 and 12: the median of sixty draws, and where their spokes are cut.
fn spokes(table: &mut Table) {
    let (mut points, mut same) = (Vec::new(), 0);
    for seed in SEEDS {
        let outline = figures::spokes20(seed);
        let name = format!("20 spokes, seed {seed}, the paper's rules");
        let (count, made) =
            table.mesh(&name, &outline, &paper(Splitting::Shells), Bound::default());
        points.push(count);
        let cut = made.and_then(|made| common_cut(&outline, &made.mesh));
        same += usize::from(cut.is_some_and(|cut| [1.0 / 32.0, 1.0 / 64.0].contains(&cut)));
    }
    let draws = points.len();
    let bound = Bound::within(865..=1_060);
    table.row("Figure 11: their median", median(points), Duration::ZERO, bound, "", None);
    table.fact(
        "Figure 12: all 20 cut at 1/32, or all at 1/64",
        &format!("{same} of {draws}"),
        same * 60 >= 57 * draws,
    );
}

/// Figure 10: Lake Superior in a box.
fn figure_10(table: &mut Table, boxed: &Pslg) {
    let shells = paper(Splitting::Shells);
    let (_, made) = table.mesh("Figure 10: shells", boxed, &shells, Bound::within(1_690..=1_860));
    let smallest =
        made.and_then(|made| made.certificate.smallest_angle).unwrap_or_default().to_degrees();
    table.fact(
        "Figure 10: smallest angle, 14.0713° ± 0.0001°",
        &format!("{smallest:.5}°"),
        (smallest - 14.0713).abs() <= 1e-4,
    );
    let augment = paper(Splitting::Augment);
    table.mesh("Figure 10: Algorithm 1", boxed, &augment, Bound::within(5_900..=6_200));
}

/// §3.1 and Claim 10.1: Ruppert's rule below and above what the lake's smallest angle allows.
fn ruppert(table: &mut Table, lake: &Pslg) {
    let run = |degrees: f64| {
        let min_angle = MinAngle::from_degrees(degrees).expect("it is below 26.45°");
        let rules = Parameters { region: Region::Domain, ..paper(Splitting::Shells) };
        mesh(lake, &Parameters { rule: Rule::Ruppert, min_angle, ..rules })
            .expect("the lake is clean")
    };
    let below = run(14.07);
    let smallest = below.certificate.smallest_angle.unwrap_or_default().to_degrees();
    table.fact(
        "Ruppert's rule, κ = 14.07°: ends, no excuse",
        &format!(
            "{} points, smallest angle {smallest:.4}°, {}",
            grouped(below.mesh.points.len()),
            ending(&below)
        ),
        below.refused == 0
            && smallest >= 14.07
            && below.certificate.excused.is_empty()
            && below.certificate.holds(),
    );
    for degrees in [16.0, 20.0, 26.45] {
        let above = run(degrees);
        let apex = above.smallest_input_angle.map(|angle| angle.point);
        table.fact(
            &format!("Ruppert's rule, κ = {degrees}°: names the apex"),
            &format!("{} points, {}", grouped(above.mesh.points.len()), ending(&above)),
            above.refused > 0 && apex.is_some_and(|apex| above.refused_at == [apex]),
        );
    }
}

/// How Ruppert's rule ended, with the points of the outline (from 1) that it stops at.
fn ending(outcome: &Outcome) -> String {
    let places: Vec<String> =
        outcome.refused_at.iter().map(|point| (point + 1).to_string()).collect();
    match outcome.refused {
        0 => "ends by itself".to_owned(),
        _ => format!("stops where doubles end near point {}", places.join(", ")),
    }
}

/// lfs_min of the lake, as it was computed from all pairs.
fn lfs_min(table: &mut Table, lake: &Pslg) {
    const KNOWN: f64 = 8.330_436_717_544_945e-4;
    let found = Domain::new(lake, Region::Domain).ok().and_then(|(domain, _)| domain.lfs_min());
    let found = found.unwrap_or_default();
    table.fact(
        "lfs_min, 8.330436717544945e-4",
        &format!("{found:e}"),
        (found / KNOWN - 1.0).abs() < 1e-14,
    );
}
