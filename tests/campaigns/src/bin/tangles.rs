//! Repairs tangled outlines, and prints what that took.

use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use meshwright::domain::{Domain, Error, RepairKind, repair};
use meshwright::{Pslg, Region};
use meshwright_campaigns::Random;
use meshwright_campaigns::tangle::Tangle;

/// Makes tangled outlines and repairs them: a million short segments with a hundred thousand
/// crossings, and smaller ones that are worse.
///
/// Each repair must end within the limit, with an outline that is clean and that another repair
/// leaves as it is.
///
/// Exit code 0: all did. 1: one did not.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// Which outlines: each seed has its own
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The segments of the soup; the others have fewer
    #[arg(long, default_value_t = 1_000_000)]
    segments: usize,
    /// The crossings of the soup, about
    #[arg(long, default_value_t = 100_000)]
    crossings: usize,
    /// Only the outline of this name: soup, hatch, star, fence, stretches
    #[arg(long)]
    only: Option<String>,
    /// No repair may take longer, in seconds
    #[arg(long, default_value_t = 10.0)]
    limit: f64,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let mut failed = false;
    println!(
        "{:<10} {:>9} {:>10} {:>9} {:>8} {:>10} {:>10} {:>8}",
        "outline", "segments", "crossings", "overlaps", "touches", "points", "pieces", "seconds"
    );
    let is_wanted = |kind: &Tangle| arguments.only.as_ref().is_none_or(|name| name == kind.name());
    for kind in Tangle::ALL.into_iter().filter(is_wanted) {
        let segments = match kind {
            Tangle::Soup => arguments.segments,
            Tangle::Hatch | Tangle::Star => arguments.segments / 2_000,
            Tangle::Fence => arguments.segments / 200,
            Tangle::Stretches => arguments.segments / 1_000,
        };
        let mut random = Random::new(arguments.seed);
        let outline = kind.outline(segments, arguments.crossings, &mut random);
        if let Err(fault) = run(kind, &outline, arguments.limit) {
            println!("    WRONG: {fault}");
            failed = true;
        }
    }
    if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

fn run(kind: Tangle, outline: &Pslg, limit: f64) -> Result<(), String> {
    let start = Instant::now();
    let repaired = repair(outline, 0.0).map_err(|error| error.to_string())?;
    let seconds = start.elapsed().as_secs_f64();
    let counts = repaired.report(outline).counts();
    let count = |kind| counts.iter().find(|(k, _)| *k == kind).map_or(0, |(_, count)| *count);
    println!(
        "{:<10} {:>9} {:>10} {:>9} {:>8} {:>10} {:>10} {:>8.2}",
        kind.name(),
        outline.segments.len(),
        count(RepairKind::Crossing),
        count(RepairKind::Overlap),
        count(RepairKind::TJunction),
        repaired.outline.points.len(),
        repaired.outline.segments.len(),
        seconds
    );
    if let Err(error @ Error::Conflicts(_)) = Domain::new(&repaired.outline, Region::Domain) {
        return Err(format!("the repaired outline is not clean: {error}"));
    }
    let again = repair(&repaired.outline, 0.0).map_err(|error| error.to_string())?;
    if again.outline != repaired.outline {
        return Err("another repair changes it again".to_owned());
    }
    if seconds > limit {
        return Err(format!("{seconds:.1} s"));
    }
    Ok(())
}
