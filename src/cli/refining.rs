//! How the refinement goes: the options that `mesh` and `trace` share.

use clap::Args;
use meshwright::{Parameters, Rule, Splitting, Steiner, Thinning};

use super::failure::Failure;
use super::options::{PromiseOptions, positive};
use super::words::{RULES, SPLITTINGS, STEINERS, one_of};

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
    max_points: u32,
    /// Where segments are split: at dyadic distances all the way out, on shells as in the paper,
    /// or at points put there before [default: ladder].
    #[arg(long, alias = "split", value_parser = one_of(SPLITTINGS))]
    splitting: Option<Splitting>,
    /// Where the point goes that removes a bad triangle: the best of many (look-ahead) makes the
    /// fewest points [default: off-center; look-ahead with a --min-angle above 26.452].
    #[arg(long, value_parser = one_of(STEINERS))]
    steiner: Option<Steiner>,
    /// Which small angles are attacked: all but the excused ones, or all [default: adaptive].
    #[arg(long, value_parser = one_of(RULES))]
    rule: Option<Rule>,
    /// Introduce points and segments one by one, each into a mesh that is finished but for what is
    /// still to come.
    #[arg(long)]
    incremental: bool,
    /// At the end take a few points out for fewer ones, so many times; auto: 20 times for each
    /// point inside. What is promised stays.
    #[arg(long, value_name = "N|auto", value_parser = thinning)]
    thin: Option<Thinning>,
}

impl RefineOptions {
    /// The parameters that these options stand for.
    pub fn parameters(&self) -> Result<Parameters, Failure> {
        let base = self.promise.parameters()?;
        let usual = match base.steiner {
            // It misses a fifth as many angles as off-centers do, with 12 to 30 % fewer points (the
            // collection's outlines, 30° to 34°).
            Steiner::OffCenter if base.soft_angle.is_some() => Steiner::LookAhead,
            steiner => steiner,
        };
        Ok(Parameters {
            max_area: self.max_area,
            max_points: self.max_points as usize,
            splitting: self.splitting.unwrap_or(base.splitting),
            steiner: self.steiner.unwrap_or(usual),
            rule: self.rule.unwrap_or(base.rule),
            incremental: self.incremental,
            thinning: self.thin.unwrap_or(base.thinning),
            ..base
        })
    }
}

/// A number of tries, or `auto`.
fn thinning(text: &str) -> Result<Thinning, String> {
    match text {
        "auto" => Ok(Thinning::Auto),
        _ => match text.parse() {
            Ok(0) => Ok(Thinning::None),
            Ok(tries) => Ok(Thinning::Tries(tries)),
            Err(_) => Err("a number of tries is wanted, or `auto`".to_string()),
        },
    }
}
