//! Figure 10: Lake Superior in a box, by Algorithm 1 and by concentric shells.

use meshwright::draw::Dots;
use meshwright::{Parameters, Pslg, Splitting};

use super::Section;
use super::outlines::{extent, lake};
use super::run::{Run, adaptive, degrees, grouped, paper};
use crate::figures::in_a_box;
use crate::measure::smallest_angle;

/// Lake Superior in a box, by three ways of splitting.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn figure_10() -> Result<Section, String> {
    let lake = lake()?;
    let boxed = in_a_box(&lake);
    let mut section = Section::default();
    section.paragraph(&format!(
        "The paper meshes an outline of Lake Superior of 522 points in a box, with θ* = 15.02°: 5 964 \
         points after Algorithm 1, which puts 1 044 of them there beforehand, and 1 750 on concentric \
         shells. That outline is not free: where it is at hand, `experiments --data` prints its figures. \
         Here is Natural Earth's in a box: {} points, θ* = {}. Points that Algorithm 1 puts there \
         beforehand count as shell points.",
        grouped(boxed.points.len()),
        degrees(smallest_angle(&boxed).unwrap_or_default()),
    ));
    let runs = runs(&boxed)?;
    section.table(&HEAD, &rows(&runs));
    let [left, bottom, right, top] = extent(&lake);
    // The western end, where the picture has room for every triangle.
    let zoom = Some([left, bottom, left + (right - left) / 4.0, bottom + (top - bottom) / 2.0]);
    for (name, caption, run) in [
        ("superior_augment", "Algorithm 1, the lake's western end", &runs[0].1),
        ("superior_shells", "The same place on concentric shells", &runs[1].1),
        ("superior_ladder", "The same place by our rules", &runs[2].1),
    ] {
        section.picture(name, caption, run.picture(640.0, zoom, Dots::None));
    }
    Ok(section)
}

/// What the columns of [`rows`] are.
pub const HEAD: [&str; 8] = [
    "splitting",
    "points",
    "input",
    "shell points",
    "midpoints",
    "inside",
    "smallest angle",
    "largest angle",
];

/// An outline in its box by Algorithm 1, by shells, and by our rules.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn runs(boxed: &Pslg) -> Result<[(&'static str, Run); 3], String> {
    Ok([
        ("Algorithm 1, the paper's rules", adaptive(boxed, &paper(Splitting::Augment))?),
        ("shells, the paper's rules", adaptive(boxed, &paper(Splitting::Shells))?),
        ("ladder, our rules", adaptive(boxed, &Parameters::default())?),
    ])
}

/// Runs as rows of a table.
#[must_use]
pub fn rows(runs: &[(&str, Run)]) -> Vec<Vec<String>> {
    let row = |(name, run): &(&str, Run)| {
        let kinds = run.kinds();
        let counts = [run.points(), kinds.input, kinds.shell, kinds.midpoint, kinds.circumcenter];
        let counts = counts.map(grouped);
        [vec![(*name).to_owned()], counts.to_vec(), vec![run.smallest(), run.largest()]].concat()
    };
    runs.iter().map(row).collect()
}
