//! Mending an outline for which Assumption 1 does not hold.
//!
//! Segments are split where they cross, touch or overlap, so that what they share is there once;
//! what lies within the user's tolerance is joined. Points stay where they are, bit for bit: only
//! crossings make new ones, and only the tolerance merges any.

mod chain;
mod crossings;
mod draft;
mod grid;
mod outline;
mod report;
#[cfg(test)]
mod tests;
mod tolerance;

pub use report::{Repair, RepairKind, Report};

use super::error::{Error, Item, Kind, Warning};
use crate::Pslg;
use draft::Draft;

/// Joining what the tolerance asks for may bring other things within it; that settles, or ends
/// after this many rounds.
const MOST_ROUNDS: usize = 32;

/// A mended outline, and what was mended.
#[derive(Debug, Clone)]
pub struct Repaired {
    /// The outline, for which Assumption 1 (i) to (iii) hold exactly. Its points and segments keep
    /// the numbers and lines of the given one's; pieces have those of their segment.
    pub outline: Pslg,
    /// What was mended: kind by kind, in the order of the outline.
    pub repairs: Vec<Repair>,
    /// What was merged or dropped as it always is, and tags that were lost.
    pub warnings: Vec<Warning>,
    /// The points that were made, in the order of their numbers; a tolerance may have merged some
    /// of them into others.
    pub new_points: Vec<[f64; 2]>,
}

impl Repaired {
    /// What was mended, in the numbers of the outline that was `given`.
    #[must_use]
    pub fn report<'a>(&'a self, given: &'a Pslg) -> Report<'a> {
        Report {
            outline: given,
            repairs: &self.repairs,
            new_points: &self.new_points,
            first_new: first_new_number(given),
        }
    }
}

/// Mends an outline: splits segments at crossings and at points on them, unites overlapping ones,
/// and, where the `tolerance` (a distance, in the units of the outline) is greater than 0, merges
/// points that are no farther apart and leads segments through points that are no farther off.
///
/// A clean outline stays as it is, and mending a mended one changes nothing.
///
/// ```
/// use meshwright::{Pslg, domain};
/// let bowtie = Pslg {
///     points: vec![[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]],
///     segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
///     segment_tags: vec![0; 4],
///     ..Pslg::default()
/// };
/// let repaired = domain::repair(&bowtie, 0.0)?;
/// assert_eq!(
///     repaired.report(&bowtie).to_string().lines().nth(1),
///     Some("segments 0 and 2 cross near (1, 1): split at point 4")
/// );
/// let outcome = meshwright::mesh(&repaired.outline, &meshwright::Parameters::default())?;
/// assert!(outcome.mesh.points.contains(&[1.0, 1.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Coordinates out of range; more to mend than bounded time and memory allow; a tolerance that
/// joins one thing after another without an end.
pub fn repair(given: &Pslg, tolerance: f64) -> Result<Repaired, Error> {
    let mut warnings = Vec::new();
    let mut draft = Draft::new(given, &mut warnings)?;
    mend(&mut draft, tolerance)?;

    draft.overlaps.sort_unstable();
    draft.overlaps.dedup();
    warnings.extend(lost_tags(&draft));
    let mut repairs = std::mem::take(&mut draft.repairs);
    repairs.extend(draft.overlaps.iter().map(|&segments| Repair::Overlap { segments }));
    repairs.sort_by(|a, b| a.order().cmp(&b.order()));
    let new = &draft.points[given.points.len()..];
    let new_points = new.iter().map(|place| place.map(|c| draft.unscaled(c))).collect();
    let outline = if draft.is_as_given() {
        given.clone()
    } else {
        outline::outline(&draft, first_new_number(given))
    };
    Ok(Repaired { outline, repairs, warnings, new_points })
}

fn mend(draft: &mut Draft, tolerance: f64) -> Result<(), Error> {
    if tolerance.is_nan() || tolerance <= 0.0 {
        return crossings::untangle(draft);
    }
    let scaled = libm::scalbn(tolerance, -draft.scale_exponent);
    for round in 0..MOST_ROUNDS {
        let has_joined = tolerance::join(draft, scaled);
        if round > 0 && !has_joined {
            return Ok(());
        }
        crossings::untangle(draft)?;
    }
    Err(Error::Unsettled { tolerance, rounds: MOST_ROUNDS })
}

/// The warning about stretches that two segments with different tags shared.
fn lost_tags(draft: &Draft) -> Option<Warning> {
    let given = draft.outline;
    let tag = |segment: u32| given.segment_tags.get(segment as usize).copied().unwrap_or(0);
    let lost: Vec<[u32; 2]> =
        draft.overlaps.iter().copied().filter(|&[s, t]| tag(s) != tag(t)).collect();
    let first = || lost.iter().take(super::conflicts::IN_FULL);
    let items = first().map(|pair| pair.map(|s| Item::new(given, Kind::Segment, s)));
    (!lost.is_empty()).then(|| Warning::TagsOverlap {
        count: lost.len(),
        first: items.collect(),
        tags: first().map(|pair| pair.map(tag)).collect(),
    })
}

/// The number after the largest that the outline has for a point.
fn first_new_number(outline: &Pslg) -> i64 {
    let counted = i64::from(outline.source.first_number) + outline.points.len() as i64;
    let largest = outline.source.point_numbers.iter().copied().max();
    largest.map_or(counted, |largest| largest + 1)
}
