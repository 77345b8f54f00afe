//! One mesh of an experiment, and what a table says of it.

use meshwright::draw::{self, Dots, Options};
use meshwright::refine::End;
use meshwright::statistics::{Kinds, Statistics};
use meshwright::{Outcome, Parameters, Pslg, Splitting};

/// The paper's rules (profile `paper`) with this way of splitting.
#[must_use]
pub fn paper(splitting: Splitting) -> Parameters {
    Parameters { splitting, ..Parameters::paper() }
}

/// A mesh and its figures.
#[derive(Debug)]
pub struct Run {
    /// What the run made.
    pub outcome: Outcome,
    /// Counts and angles.
    pub statistics: Statistics,
}

impl Run {
    /// Meshes an outline, whatever the certificate says.
    ///
    /// # Errors
    /// There is no mesh.
    pub fn of(outline: &Pslg, parameters: &Parameters) -> Result<Self, String> {
        let outcome = meshwright::mesh(outline, parameters).map_err(|error| error.to_string())?;
        let statistics = Statistics::of(&outcome.mesh);
        Ok(Self { outcome, statistics })
    }

    /// The number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.statistics.points
    }

    /// How many points of each kind; the mesh of a run knows them.
    #[must_use]
    pub fn kinds(&self) -> Kinds {
        self.statistics.kinds.unwrap_or_default()
    }

    /// The smallest angle as a table shows it.
    #[must_use]
    pub fn smallest(&self) -> String {
        degrees(self.statistics.smallest_angle)
    }

    /// The largest angle as a table shows it.
    #[must_use]
    pub fn largest(&self) -> String {
        format!("{:.2}°", self.statistics.largest_angle.to_degrees())
    }

    /// Where the run ends: by itself, where doubles end, or at the budget of points.
    #[must_use]
    pub fn ends(&self) -> String {
        let outcome = &self.outcome;
        match (outcome.end, outcome.refused, outcome.refused_at.len()) {
            (End::Finished, 0, _) => "by itself".to_owned(),
            (End::Finished, _, 1) => "where doubles end, near 1 point".to_owned(),
            (End::Finished, _, places) => format!("where doubles end, near {places} points"),
            (End::PointBudget | End::Cancelled, ..) => "at the budget".to_owned(),
        }
    }

    /// The mesh as a picture without a legend.
    #[must_use]
    pub fn picture(&self, width: f64, zoom: Option<[f64; 4]>, points: Dots) -> Vec<u8> {
        let options = Options { width, zoom, points, legend: false, marks: Vec::new() };
        let mut svg = Vec::new();
        draw::mesh(&self.outcome.mesh, &options, &mut svg).expect("a vector takes everything");
        svg
    }
}

/// Meshes an outline by a rule that keeps every promise.
///
/// # Errors
/// There is no mesh, it was stopped, or its certificate does not hold.
pub fn adaptive(outline: &Pslg, parameters: &Parameters) -> Result<Run, String> {
    let run = Run::of(outline, parameters)?;
    if run.outcome.end != End::Finished {
        return Err(format!("stopped at {} points", run.points()));
    }
    if !run.outcome.certificate.holds() {
        return Err(run.outcome.certificate.to_string());
    }
    Ok(run)
}

/// An angle in degrees, with as many digits as a small one needs.
#[must_use]
pub fn degrees(radians: f64) -> String {
    let degrees = radians.to_degrees();
    if degrees < 1.0 { format!("{degrees:.4}°") } else { format!("{degrees:.2}°") }
}

/// A whole number with a space before each three digits.
#[must_use]
pub fn grouped(number: usize) -> String {
    if number < 1000 {
        return number.to_string();
    }
    format!("{} {:03}", grouped(number / 1000), number % 1000)
}

/// The median; of an even count the mean of the two in the middle, rounded down.
///
/// # Panics
/// Without numbers.
#[must_use]
pub fn median(mut numbers: Vec<usize>) -> usize {
    numbers.sort_unstable();
    let half = numbers.len() / 2;
    if numbers.len() % 2 == 1 { numbers[half] } else { (numbers[half - 1] + numbers[half]) / 2 }
}
