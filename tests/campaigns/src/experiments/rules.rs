//! The adaptive rule against Ruppert's and the Terminator.

use meshwright::{MinAngle, Parameters, Pslg, Rule, Splitting};

use super::Section;
use super::outlines::{baltic, lake, norway};
use super::run::{Run, adaptive, degrees, grouped, paper};
use crate::figures::{in_a_box, spokes20, wedge};
use crate::measure::smallest_angle;

/// Ruppert's rule is stopped at this many points.
const BUDGET: usize = 50_000;

/// Counts, extreme angles and the end of each rule on several outlines.
///
/// # Errors
/// A mesh of the adaptive rule does not keep its promise.
pub fn table() -> Result<Section, String> {
    let mut section = Section::default();
    section.paragraph(&format!(
        "`adaptive` leaves an angle alone that a small input angle causes, `ruppert` attacks them all, \
         `terminator` (Shewchuk's) refuses to split some segments for the sake of such an angle. All \
         three split on shells and take circumcenters. Where an input angle is below κ̂, Ruppert's rule \
         has no end of its own: it goes on until doubles end, or to a budget of {} points. Its meshes, and \
         the Terminator's, are not held to the promises about angles.",
        grouped(BUDGET)
    ));
    let lake = lake()?;
    let outlines = [
        ("wedge of 45°", wedge(f64::to_radians(45.0))),
        ("wedge of 5°", wedge(f64::to_radians(5.0))),
        ("20 spokes, seed 900", spokes20(900)),
        ("Lake Superior in a box", in_a_box(&lake)),
        ("`norway_sogn`", norway()?),
        ("`baltic_like`", baltic()?),
    ];
    let mut rows = Vec::new();
    for (name, outline) in &outlines {
        for (word, rule) in [
            ("adaptive", Rule::Adaptive),
            ("ruppert", Rule::Ruppert),
            ("terminator", Rule::Terminator),
        ] {
            let run = run(outline, Parameters { rule, ..rules(outline) })?;
            rows.push(row(name, outline, word, &run));
        }
    }
    section.table(&HEAD, &rows);
    below_its_limit(&mut section, &lake)?;
    Ok(section)
}

const HEAD: [&str; 7] =
    ["outline", "θ*", "rule", "points", "smallest angle", "largest angle", "ends"];

/// The paper's rules, in the holes of an outline too where it has none.
fn rules(outline: &Pslg) -> Parameters {
    let rules = paper(Splitting::Shells);
    if outline.holes.is_empty() {
        rules
    } else {
        Parameters { region: Parameters::default().region, ..rules }
    }
}

/// Meshes an outline: the adaptive rule keeps its promises, Ruppert's gets a budget.
fn run(outline: &Pslg, rules: Parameters) -> Result<Run, String> {
    match rules.rule {
        Rule::Adaptive => adaptive(outline, &rules),
        Rule::Ruppert => Run::of(outline, &Parameters { max_points: BUDGET, ..rules }),
        Rule::Terminator => Run::of(outline, &rules),
    }
}

fn row(name: &str, outline: &Pslg, rule: &str, run: &Run) -> Vec<String> {
    vec![
        name.to_owned(),
        degrees(smallest_angle(outline).unwrap_or_default()),
        rule.to_owned(),
        grouped(run.points()),
        run.smallest(),
        run.largest(),
        run.ends(),
    ]
}

/// Ruppert's rule with κ̂ below what the outline's angles allow.
fn below_its_limit(section: &mut Section, lake: &Pslg) -> Result<(), String> {
    let theta = smallest_angle(lake).unwrap_or_default();
    // §3.1: what is across from θ* makes no angle smaller than this.
    let across = libm::atan2(libm::sin(theta), 2.0 - libm::cos(theta));
    let degrees_asked = across.to_degrees() * 0.99;
    let min_angle = MinAngle::from_degrees(degrees_asked).map_err(|error| error.to_string())?;
    let mut rows = Vec::new();
    for (word, rule) in [("adaptive", Rule::Adaptive), ("ruppert", Rule::Ruppert)] {
        let run = run(lake, Parameters { min_angle, rule, ..rules(lake) })?;
        rows.push(row("Lake Superior", lake, word, &run));
    }
    section.paragraph(&format!(
        "With κ̂ below arctan(sin θ* / (2 − cos θ*)) = {}, here {degrees_asked:.2}°, Ruppert's rule ends by \
         itself, and no angle is excused (§3.1):",
        degrees(across)
    ));
    section.table(&HEAD, &rows);
    Ok(())
}
