//! Soft targets above κ̂ on Lake Superior.

use meshwright::draw::Dots;
use meshwright::{MinAngle, Parameters, Pslg};

use super::Section;
use super::histogram::extreme_angles;
use super::outlines::{extent, lake};
use super::run::{Run, adaptive, grouped};
use crate::figures::in_a_box;

/// The targets of the table, in degrees.
const TARGETS: [f64; 3] = [30.0, 33.0, 34.0];

/// Points for each target, and what was missed.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn table() -> Result<Section, String> {
    let mut section = Section::default();
    section.paragraph(
        "Above 26.452° a smallest angle is a target: it cannot keep a run from ending, and what is \
         missed is listed. The promise stays 26.45°. A triangle below its target is across a small input \
         angle, which excuses it, or missed.",
    );
    let lake = lake()?;
    let boxed = in_a_box(&lake);
    let mut rows = Vec::new();
    for (name, outline) in [("Lake Superior", &lake), ("in a box", &boxed)] {
        rows.extend(self::rows(name, outline)?);
    }
    section.table(&HEAD, &rows);
    let [left, bottom, right, top] = extent(&lake);
    let zoom = Some([left, bottom, left + (right - left) / 4.0, bottom + (top - bottom) / 2.0]);
    section.picture(
        "superior_soft",
        "Target 33°, the lake's western end",
        adaptive(&lake, &aimed_at(33.0)?)?.picture(640.0, zoom, Dots::None),
    );
    Ok(section)
}

/// What the columns of [`rows`] are.
pub const HEAD: [&str; 8] = [
    "outline",
    "target",
    "points",
    "triangles",
    "below it",
    "missed",
    "smallest angle",
    "largest angle",
];

/// An outline's rows: without a target, then with each of them.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn rows(name: &str, outline: &Pslg) -> Result<Vec<Vec<String>>, String> {
    let kappa_hat = MinAngle::default();
    let untargeted = adaptive(outline, &Parameters::default())?;
    let mut rows = vec![row(name, "none", kappa_hat.degrees(), &untargeted)];
    for target in TARGETS {
        let run = adaptive(outline, &aimed_at(target)?)?;
        rows.push(row(name, &format!("{target}°"), target, &run));
    }
    Ok(rows)
}

fn aimed_at(degrees: f64) -> Result<Parameters, String> {
    let target = MinAngle::soft_from_degrees(degrees).map_err(|error| error.to_string())?;
    Ok(Parameters { soft_angle: Some(target), ..Parameters::default() })
}

fn row(name: &str, target: &str, degrees: f64, run: &Run) -> Vec<String> {
    let extremes = extreme_angles(&run.outcome.mesh);
    // The last bit of an angle that is exactly the target is no matter here.
    let below = extremes.iter().filter(|angles| angles[0] < degrees * (1.0 - 1e-12)).count();
    vec![
        name.to_owned(),
        target.to_owned(),
        grouped(run.points()),
        grouped(run.statistics.triangles),
        grouped(below),
        grouped(run.outcome.missed.len()),
        run.smallest(),
        run.largest(),
    ]
}
