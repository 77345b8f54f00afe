//! What small angles cost by shells and by the ladder: wedges, spokes, needles, random outlines.

use meshwright::{Parameters, Pslg, Splitting};

use super::run::{adaptive, grouped, median, paper};
use super::{Section, triangle};
use crate::families::Family;
use crate::figures::{spokes20, wedge};
use crate::random::Random;

/// The seeds of the spokes.
const SPOKES: std::ops::Range<u64> = 900..940;
/// The seeds of the needles and of the random outlines.
const DRAWS: std::ops::Range<u64> = 1..13;
/// The angles of the wedges, in degrees.
const WEDGES: [f64; 4] = [1.0, 0.1, 0.01, 0.001];

/// An outline and a word to find it by.
pub type Named = (String, Pslg);

/// Points for each kind of outline: by the paper's rules, by Triangle and by ours.
///
/// # Errors
/// A mesh does not keep its promise, or Triangle's numbers are out of date.
pub fn table() -> Result<Section, String> {
    let mut section = Section::default();
    section.paragraph(&format!(
        "By shells the cost of one small angle θ grows like 1/θ: the pieces farther out on its two \
         segments have unrelated lengths. A ladder cuts both at the same dyadic distances all the way \
         out, and the cost grows like log 1/θ. All outlines stand in a box. Spokes: seeds {}–{}. \
         Needles and random outlines: seeds {}–{} of the families `Needles` (up to four triangles; each \
         seed draws θ from 0.02° to 5°, and each needle has θ/2 to 2θ) and `RandomPslg` (40 points, \
         up to 60 segments; nothing comes nearer to a segment than a thousandth of its \
         length).",
        SPOKES.start,
        SPOKES.end - 1,
        DRAWS.start,
        DRAWS.end - 1
    ));
    section.paragraph(
        "Triangle (Shewchuk's, 1.6, `-pq26.45D`) is another program. Its numbers are recorded in \
         [`triangle.csv`](triangle.csv), outline by outline; \
         [the campaigns](../../tests/campaigns/README.md) say how. This page is not made of a record of \
         other outlines.",
    );
    let rows = kinds().into_iter().map(|kind| kind.row()).collect::<Result<Vec<_>, _>>()?;
    section
        .table(&["points", "shells, circumcenters", "Triangle -D", "ladder, off-centers"], &rows);
    Ok(section)
}

/// Every outline of the table.
#[must_use]
pub fn outlines() -> Vec<Named> {
    kinds().into_iter().flat_map(|kind| kind.outlines).collect()
}

/// A row: outlines of one kind.
struct Kind {
    title: String,
    outlines: Vec<Named>,
}

fn kinds() -> Vec<Kind> {
    let wedges = WEDGES.map(|degrees| Kind {
        title: format!("one wedge of {degrees}°"),
        outlines: vec![(format!("wedge_{degrees}"), wedge(degrees.to_radians()))],
    });
    let drawn =
        |title: &str, word: &str, seeds: std::ops::Range<u64>, draw: fn(u64) -> Pslg| Kind {
            title: format!("{title}, median of {}", seeds.clone().count()),
            outlines: seeds.map(|seed| (format!("{word}_{seed}"), draw(seed))).collect(),
        };
    let mut kinds = Vec::from(wedges);
    kinds.push(drawn("20 spokes", "spokes", SPOKES, spokes20));
    kinds.push(drawn("needles", "needles", DRAWS, needles));
    kinds.push(drawn("random outline", "random", DRAWS, |seed| {
        Family::RandomPslg.outline(40, 0.0, seed)
    }));
    kinds
}

/// Up to four needle triangles whose angles are of one size, 0.02° to 5°.
fn needles(seed: u64) -> Pslg {
    let theta = Random::stream(seed, 1).log_range(0.02, 5.0).to_radians();
    Family::Needles.outline(4, theta, seed)
}

impl Kind {
    /// The median points by the paper's rules, by Triangle and by ours.
    fn row(&self) -> Result<Vec<String>, String> {
        let mut counts: [Vec<usize>; 3] = Default::default();
        for (name, outline) in &self.outlines {
            counts[0].push(adaptive(outline, &paper(Splitting::Shells))?.points());
            counts[1].push(triangle::points(name, outline)?);
            counts[2].push(adaptive(outline, &Parameters::default())?.points());
        }
        let medians = counts.map(|counts| grouped(median(counts)));
        Ok([&[self.title.clone()][..], &medians].concat())
    }
}
