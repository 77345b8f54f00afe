//! Figures 13 to 15: coasts with very small angles, and the histograms of their meshes' angles.

use meshwright::draw::{self, Dots, Options};
use meshwright::{Parameters, Pslg, Splitting};

use super::Section;
use super::histogram::{Axis, extreme_angles, histogram};
use super::outlines::{baltic, extent, norway};
use super::run::{self, Run, adaptive, degrees, grouped};
use crate::measure::smallest_angle;

/// The angles' promise as the pictures name it: κ̂ = arctan √(99/400).
const KAPPA_HAT: f64 = 26.45;

/// The Baltic and a fjord by the paper's rules and by ours, with histograms.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn figures_13_to_15() -> Result<Section, String> {
    let (baltic, norway) = (baltic()?, norway()?);
    let mut section = Section::default();
    section.paragraph(
        "The paper's Baltic Sea (1 401 points, 1 301 segments, θ* = 0.052°; a mesh of 21 775 points, \
         43 357 triangles, largest angle 126.9°) is not public. `baltic_like.poly` has as many points \
         and segments and the same θ*, but it is another outline: its figures are not to be compared \
         one by one. What is to be seen is the shape of the histograms: a wall at κ̂, a few triangles \
         below it that a small input angle excuses, nothing near 180°. `norway_sogn.poly` is water \
         with islands as holes. Both are meshed where segments enclose them (`--region domain`), by the \
         paper's rules too.",
    );
    let mut rows = Vec::new();
    let mut shown = Vec::new();
    for (name, outline) in [("baltic_like", &baltic), ("norway_sogn", &norway)] {
        let paper =
            Parameters { region: Parameters::default().region, ..run::paper(Splitting::Shells) };
        for (rules, parameters) in [("the paper's", paper), ("our", Parameters::default())] {
            let run = adaptive(outline, &parameters)?;
            rows.push(row(name, outline, rules, &run));
            shown.push((name, rules, run));
        }
    }
    section.table(
        &[
            "outline",
            "θ*",
            "rules",
            "points",
            "triangles",
            "below κ̂, excused",
            "smallest angle",
            "largest angle",
        ],
        &rows,
    );
    input(&mut section, &baltic)?;
    for (outline, rules, run) in &shown {
        histograms(&mut section, outline, rules, run);
    }
    meshes(&mut section, &baltic, &shown[0].2, &shown[3].2);
    Ok(section)
}

fn row(name: &str, outline: &Pslg, rules: &str, run: &Run) -> Vec<String> {
    let kappa_hat = Parameters::default().min_angle.degrees();
    let below = extreme_angles(&run.outcome.mesh).iter().filter(|a| a[0] < kappa_hat).count();
    vec![
        format!("`{name}`"),
        degrees(smallest_angle(outline).unwrap_or_default()),
        rules.to_owned(),
        grouped(run.points()),
        grouped(run.statistics.triangles),
        grouped(below),
        run.smallest(),
        run.largest(),
    ]
}

/// Figure 13.
fn input(section: &mut Section, baltic: &Pslg) -> Result<(), String> {
    let options = Options { width: 480.0, points: Dots::None, legend: false, ..Options::default() };
    let mut svg = Vec::new();
    draw::outline(baltic, &options, &mut svg).map_err(|error| error.to_string())?;
    section.picture("baltic_input", "Figure 13: the input, `baltic_like.poly`", svg);
    Ok(())
}

/// Figure 14.
fn histograms(section: &mut Section, outline: &str, rules: &str, run: &Run) {
    let extremes = extreme_angles(&run.outcome.mesh);
    let side = |which: usize| extremes.iter().map(|a| a[which]).collect::<Vec<_>>();
    let word = if rules == "our" { "ours" } else { "paper" };
    let smallest = Axis {
        from: 0,
        to: 60,
        step: 10,
        bound: (KAPPA_HAT, "κ̂"),
        title: "smallest angle of a triangle",
    };
    let largest = Axis {
        from: 60,
        to: 180,
        step: 20,
        bound: (180.0 - 2.0 * KAPPA_HAT, "180° − 2κ̂"),
        title: "largest angle of a triangle",
    };
    for (which, axis, kind) in [(0, smallest, "smallest"), (1, largest, "largest")] {
        section.picture(
            &format!("{outline}_{word}_{kind}"),
            &format!("Figure 14: {kind} angles, `{outline}`, {rules} rules"),
            histogram(&side(which), &axis),
        );
    }
}

/// Figure 15: a part that shows every triangle, and a fjord.
fn meshes(section: &mut Section, baltic: &Pslg, paper: &Run, ours: &Run) {
    section.picture(
        "baltic_mesh",
        "Figure 15: a part of the mesh of `baltic_like.poly`, the paper's rules",
        paper.picture(640.0, Some(part(baltic, [0.35, 0.6], 0.2)), Dots::None),
    );
    section.picture(
        "norway_mesh",
        "The mesh of `norway_sogn.poly`, our rules",
        ours.picture(640.0, None, Dots::None),
    );
}

/// A square part of an outline: from this fraction of its extent on, of this fraction of its width.
fn part(outline: &Pslg, from: [f64; 2], width: f64) -> [f64; 4] {
    let [left, bottom, right, top] = extent(outline);
    let side = width * (right - left);
    let low = [left + from[0] * (right - left), bottom + from[1] * (top - bottom)];
    [low[0], low[1], low[0] + side, low[1] + side]
}
