//! Mending an outline before it is used: what is asked, and what is said about it.

use clap::Args;
use meshwright::domain::{Repaired, Report, repair};
use meshwright::formats::Pslg;

use super::failure::Failure;
use super::options::positive;
use super::voice::Voice;

/// Whether an outline is mended: the same options for every command that reads one.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct RepairOptions {
    /// Mend the outline: split segments at crossings and at points on them, keep once what
    /// overlaps.
    #[arg(long)]
    repair: bool,
    /// Also merge points, close gaps and lead segments through points that are no farther off
    /// than this (after --scale).
    #[arg(long, value_name = "T", requires = "repair", value_parser = positive,
          allow_negative_numbers = true)]
    tolerance: Option<f64>,
}

/// An outline, mended if that is asked for.
pub struct Mended {
    given: Pslg,
    repaired: Option<Repaired>,
    tolerance: f64,
}

impl RepairOptions {
    /// Mending, with a tolerance of 0 where nothing but what meets is mended.
    pub fn within(tolerance: f64) -> Self {
        Self { repair: true, tolerance: (tolerance > 0.0).then_some(tolerance) }
    }

    /// Whether mending is asked for.
    pub fn is_asked(self) -> bool {
        self.repair
    }

    /// Mends an outline, if that is asked for, and warns of what was lost.
    pub fn mend(self, given: Pslg, voice: &Voice) -> Result<Mended, Failure> {
        let tolerance = self.tolerance.unwrap_or(0.0);
        let repaired = if self.repair {
            Some(repair(&given, tolerance).map_err(Failure::input)?)
        } else {
            None
        };
        let warnings = repaired.iter().flat_map(|repaired| &repaired.warnings);
        warnings.for_each(|warning| voice.warn(warning));
        Ok(Mended { given, repaired, tolerance })
    }
}

impl Mended {
    /// The outline.
    pub fn outline(&self) -> &Pslg {
        self.repaired.as_ref().map_or(&self.given, |repaired| &repaired.outline)
    }

    /// The outline.
    pub fn into_outline(self) -> Pslg {
        self.repaired.map_or(self.given, |repaired| repaired.outline)
    }

    /// The tolerance, if the outline was to be mended.
    pub fn tolerance(&self) -> Option<f64> {
        self.repaired.as_ref().map(|_| self.tolerance)
    }

    /// What was mended, if it was to be.
    pub fn report(&self) -> Option<Report<'_>> {
        self.repaired.as_ref().map(|repaired| repaired.report(&self.given))
    }

    /// What was mended, in words, if it was to be: the first of each kind, or all.
    pub fn text(&self, all: bool) -> Option<String> {
        let report = self.report()?;
        Some(match report.repairs() {
            [] if self.has_warnings() => "nothing but duplicates".to_owned(),
            [] => "nothing to mend".to_owned(),
            repairs if all => {
                let sentences = repairs.iter().map(|repair| report.sentence(repair));
                sentences.collect::<Vec<_>>().join("\n")
            }
            _ => report.to_string(),
        })
    }

    fn has_warnings(&self) -> bool {
        self.repaired.as_ref().is_some_and(|repaired| !repaired.warnings.is_empty())
    }

    /// Says what was mended.
    pub fn say(&self, voice: &Voice) {
        if let Some(text) = self.text(voice.verbose) {
            voice.say(&format!("repaired  {}", text.replace('\n', "\n          ")));
        }
    }
}
