//! What small angles cost by shells and by the ladder: wedges, spokes, needles, random outlines.

use meshwright::{Parameters, Pslg, Splitting};

use super::Section;
use super::run::{adaptive, grouped, median, paper};
use crate::families::Family;
use crate::figures::{spokes20, wedge};
use crate::random::Random;

/// The seeds of the spokes.
const SPOKES: std::ops::Range<u64> = 900..940;
/// The seeds of the needles and of the random outlines.
const DRAWS: std::ops::Range<u64> = 1..13;

/// Points for each kind of outline, by the paper's rules and by ours.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn table() -> Result<Section, String> {
    let mut section = Section::default();
    section.paragraph(&format!(
        "By shells the cost of one small angle θ grows like 1/θ: the pieces farther out on its two \
         segments have unrelated lengths. A ladder cuts both at the same dyadic distances all the way \
         out, and the cost grows like log 1/θ. All outlines stand in a box. Spokes: seeds {}–{}. \
         Needles and random outlines: seeds {}–{} of the families `Needles` (up to four triangles; each \
         seed draws θ from 0.02° to 5°, and each needle has θ/2 to 2θ) and `RandomPslg` (40 points, \
         up to 60 segments; nothing comes nearer to a segment than a thousandth of its \
         length). Triangle's own column is left out: it is another program.",
        SPOKES.start,
        SPOKES.end - 1,
        DRAWS.start,
        DRAWS.end - 1
    ));
    let mut rows = Vec::new();
    for degrees in [1.0, 0.1, 0.01, 0.001] {
        let outline = wedge(f64::to_radians(degrees));
        rows.push(row(&format!("one wedge of {degrees}°"), [outline].into_iter())?);
    }
    rows.push(row("20 spokes, median of 40", SPOKES.map(spokes20))?);
    rows.push(row("needles, median of 12", DRAWS.map(needles))?);
    let random = DRAWS.map(|seed| Family::RandomPslg.outline(40, 0.0, seed));
    rows.push(row("random outline, median of 12", random)?);
    section.table(&["points", "shells, circumcenters", "ladder, off-centers"], &rows);
    Ok(section)
}

/// Up to four needle triangles whose angles are of one size, 0.02° to 5°.
fn needles(seed: u64) -> Pslg {
    let theta = Random::stream(seed, 1).log_range(0.02, 5.0).to_radians();
    Family::Needles.outline(4, theta, seed)
}

/// The median points by the paper's rules and by ours.
fn row(name: &str, outlines: impl Iterator<Item = Pslg>) -> Result<Vec<String>, String> {
    let (mut shells, mut ladder) = (Vec::new(), Vec::new());
    for outline in outlines {
        shells.push(adaptive(&outline, &paper(Splitting::Shells))?.points());
        ladder.push(adaptive(&outline, &Parameters::default())?.points());
    }
    Ok(vec![name.to_owned(), grouped(median(shells)), grouped(median(ladder))])
}
