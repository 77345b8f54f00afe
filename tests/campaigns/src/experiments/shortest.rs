//! Corollary 2 on meshes: how far its bound lies below the shortest edge.

use meshwright::{Parameters, Pslg, Splitting};

use super::Section;
use super::outlines::{baltic, lake, norway};
use super::run::{adaptive, degrees, grouped, paper};
use crate::figures::{in_a_box, spokes20, wedge};
use crate::measure::smallest_angle;

/// The bound of Corollary 2 (G8 of the certificate) beside the shortest edge.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn table() -> Result<Section, String> {
    let mut section = Section::default();
    section.paragraph(
        "Corollary 2 bounds the distance of any two points from below: lfs′_min · 2 sin(θ*/2) / μ, \
         μ = 1 + √2 / (1 − 2 sin κ̂) = 14.0, where lfs′_min is the least local feature size of the \
         outline cut at its shell points. The certificate judges it (G8), and `check` prints how \
         pessimistic it is: the shortest edge in units of the bound, which grows like 1/θ*. By `ladder` the bound is derived, \
         not the paper's.",
    );
    let lake = lake()?;
    let mut rows = Vec::new();
    for (name, outline) in [
        ("wedge of 45°", wedge(f64::to_radians(45.0))),
        ("wedge of 5°", wedge(f64::to_radians(5.0))),
        ("wedge of 0.1°", wedge(f64::to_radians(0.1))),
        ("20 spokes, seed 900", spokes20(900)),
        ("Lake Superior in a box", in_a_box(&lake)),
        ("`norway_sogn`", norway()?),
        ("`baltic_like`", baltic()?),
    ] {
        rows.push(row(name, &outline, "the paper's", &paper_in_the_domain())?);
        rows.push(row(name, &outline, "our", &Parameters::default())?);
    }
    section.table(&HEAD, &rows);
    Ok(section)
}

const HEAD: [&str; 7] =
    ["outline", "θ*", "rules", "lfs′_min", "bound", "shortest edge", "in units of the bound"];

/// The paper's rules where segments enclose an outline: its holes stay holes.
fn paper_in_the_domain() -> Parameters {
    Parameters { region: Parameters::default().region, ..paper(Splitting::Shells) }
}

fn row(
    name: &str,
    outline: &Pslg,
    rules: &str,
    parameters: &Parameters,
) -> Result<Vec<String>, String> {
    let run = adaptive(outline, parameters)?;
    let found = run.outcome.certificate.corollary_2.ok_or("the kinds of the points are lost")?;
    Ok(vec![
        name.to_owned(),
        degrees(smallest_angle(outline).unwrap_or_default()),
        rules.to_owned(),
        format!("{:.2e}", found.lfs_min),
        format!("{:.2e}", found.bound),
        format!("{:.2e}", found.shortest),
        grouped(libm::round(found.shortest / found.bound) as usize),
    ])
}
