//! Figures 11 and 12: twenty spokes, and the axle they meet at.

use meshwright::draw::{self, Dots, Options};
use meshwright::formats::Mesh;
use meshwright::{Parameters, Pslg, Splitting};

use super::Section;
use super::run::{adaptive, degrees, grouped, median, paper};
use crate::figures::spokes20;
use crate::measure::smallest_angle;
use crate::plane::distance;

/// The seed of the pictures.
const SHOWN: u64 = 900;
/// The seeds of the distribution.
pub const SEEDS: std::ops::Range<u64> = 900..960;
/// The number of the point that the spokes of [`spokes20`] meet at, and of the first spoke.
const AXLE: usize = 4;

/// One set of twenty spokes in pictures, sixty in figures.
///
/// # Errors
/// A mesh does not keep its promise.
pub fn figures_11_and_12() -> Result<Section, String> {
    let mut section = Section::default();
    let rules = paper(Splitting::Shells);
    let outline = spokes20(SHOWN);
    let shown = adaptive(&outline, &rules)?;
    section.paragraph(&format!(
        "Twenty segments of random directions and of lengths from 1/4 to 3/8 in a unit box, the closest \
         pair 0.85° to 1° apart. The paper's draw (0.92°) has 1 042 points, and all its spokes are cut \
         at one distance from the axle. Ours of seed {SHOWN} ({}): {} points by the paper's rules.",
        degrees(smallest_angle(&outline).unwrap_or_default()),
        grouped(shown.points()),
    ));
    let options = Options { width: 480.0, legend: false, ..Options::default() };
    let mut svg = Vec::new();
    draw::outline(&outline, &options, &mut svg).map_err(|error| error.to_string())?;
    section.picture("spokes_input", "Figure 11 (a): the input, seed 900", svg);
    section.picture(
        "spokes_mesh",
        "Figure 11 (b): the mesh by the paper's rules",
        shown.picture(560.0, None, Dots::None),
    );
    let around = |reach: f64| Some([0.5 - reach, 0.5 - reach, 0.5 + reach, 0.5 + reach]);
    section.picture(
        "spokes_axle",
        "Figure 12: the axle; shell points are red, midpoints green",
        shown.picture(560.0, around(1.0 / 16.0), Dots::All),
    );
    section.picture(
        "spokes_ladder",
        "The axle by our rules, four times as wide",
        adaptive(&outline, &Parameters::default())?.picture(560.0, around(0.25), Dots::All),
    );
    distribution(&mut section)?;
    Ok(section)
}

/// The points of sixty draws and where their spokes are cut first.
fn distribution(section: &mut Section) -> Result<(), String> {
    section.paragraph(&format!(
        "The inputs are random, so figures are distributions: seeds {}–{}. \"One cut\" counts the draws \
         in which all twenty spokes are cut at one distance from the axle.",
        SEEDS.start,
        SEEDS.end - 1
    ));
    let mut rows = Vec::new();
    for (name, rules) in
        [("the paper's rules", paper(Splitting::Shells)), ("our rules", Parameters::default())]
    {
        let (mut points, mut one_cut) = (Vec::new(), Vec::new());
        for seed in SEEDS {
            let outline = spokes20(seed);
            let run = adaptive(&outline, &rules)?;
            points.push(run.points());
            one_cut.extend(common_cut(&outline, &run.outcome.mesh));
        }
        one_cut.sort_by(f64::total_cmp);
        let counted: Vec<String> = one_cut
            .chunk_by(|a, b| a == b)
            .map(|same| format!("{} at 1/{}", same.len(), 1.0 / same[0]))
            .collect();
        let (least, most) = (points.iter().min(), points.iter().max());
        rows.push(vec![
            name.to_owned(),
            grouped(median(points.clone())),
            format!("{} to {}", grouped(*least.unwrap_or(&0)), grouped(*most.unwrap_or(&0))),
            format!("{} of {}", one_cut.len(), points.len()),
            counted.join(", "),
        ]);
    }
    section.table(&["rules", "median points", "range", "one cut", "where"], &rows);
    Ok(())
}

/// The distance from the axle at which all spokes are cut first; `None` where they differ.
///
/// Shell points lie at powers of two; the coordinates of a cut are rounded, so its distance is
/// compared to nine digits.
#[must_use]
pub fn common_cut(outline: &Pslg, mesh: &Mesh) -> Option<f64> {
    let axle = outline.points[AXLE];
    let spokes = AXLE..outline.segments.len();
    let mut first = vec![f64::INFINITY; outline.segments.len()];
    for (edge, &segment) in mesh.edges.iter().zip(&mesh.edge_segments) {
        for end in edge.map(|v| mesh.points[v as usize]).into_iter().filter(|&end| end != axle) {
            let first = first.get_mut(segment as usize)?;
            *first = first.min(distance(axle, end));
        }
    }
    let power = libm::exp2(libm::round(libm::log2(first[AXLE])));
    let same = |spoke: usize| (first[spoke] / power - 1.0).abs() < 1e-9;
    spokes.into_iter().all(same).then_some(power)
}
