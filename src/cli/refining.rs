//! How the refinement goes: the options that `mesh` and `trace` share.

use clap::Args;
use meshwright::{Parameters, Rule, Splitting, Steiner};

use super::failure::Failure;
use super::options::{PromiseOptions, one_of, positive};

/// What the mesh is held to, and the rules by which it is made.
#[derive(Debug, Args)]
pub struct RefineOptions {
    #[command(flatten)]
    promise: PromiseOptions,
    /// No triangle may be larger than this area.
    #[arg(long, value_name = "A", value_parser = positive, allow_negative_numbers = true)]
    max_area: Option<f64>,
    /// Stop at this many points.
    #[arg(long, value_name = "N", default_value = "10000000",
          value_parser = clap::value_parser!(u32).range(3..))]
    pub max_points: u32,
    /// Where segments are split: at dyadic distances all the way out, or on shells as in the
    /// paper.
    #[arg(long, default_value = "ladder", value_parser = one_of([
        ("ladder", Splitting::Ladder), ("shells", Splitting::Shells),
        ("augment", Splitting::Augment),
    ]))]
    splitting: Splitting,
    /// Where the point goes that removes a bad triangle.
    #[arg(long, default_value = "off-center", value_parser = one_of([
        ("off-center", Steiner::OffCenter), ("circumcenter", Steiner::Circumcenter),
    ]))]
    steiner: Steiner,
    /// Which small angles are attacked: all but the excused ones, or all.
    #[arg(long, default_value = "adaptive", value_parser = one_of([
        ("adaptive", Rule::Adaptive), ("ruppert", Rule::Ruppert),
        ("terminator", Rule::Terminator),
    ]))]
    pub rule: Rule,
}

impl RefineOptions {
    /// The parameters that these options stand for.
    pub fn parameters(&self) -> Result<Parameters, Failure> {
        let (promise, soft_angle) = self.promise.promise()?;
        Ok(Parameters {
            min_angle: promise.min_angle,
            soft_angle,
            max_area: self.max_area,
            max_points: self.max_points as usize,
            splitting: self.splitting,
            excuse: promise.excuse,
            steiner: self.steiner,
            rule: self.rule,
            region: promise.region,
        })
    }
}
