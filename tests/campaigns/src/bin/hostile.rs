//! Makes hostile outlines, meshes them and judges every mesh.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use clap::Parser;
use meshwright::certify::Guarantee;
use meshwright::{Parameters, Pslg};
use meshwright_campaigns::hostile::{Census, hostile};
use meshwright_campaigns::judge::{Verdict, judge};
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::profiles;
use meshwright_campaigns::run::{Ending, FailureFolder, Timed, guarded, in_order};
use meshwright_campaigns::shrink::shrink;

/// Makes hostile outlines, meshes them and judges every mesh.
///
/// The outlines are clean, with angles down to 1e-9 rad, and disjoint features keep 1e-5 of their
/// length apart. Each run must end within the time limit with a certificate that holds, or holds
/// but for what lies within the precision limit of an apex.
///
/// Exit code 0: all of them did. 1: one did not, or the outlines were not hostile enough.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// Which outlines: each seed has its own
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How many
    #[arg(long, default_value_t = 2000)]
    count: u64,
    /// The number of the first one
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// No run may take longer, in seconds
    #[arg(long, default_value_t = 10.0)]
    limit: f64,
    /// How many runs at once
    #[arg(long, default_value_t = 2)]
    threads: usize,
    /// A folder for the outlines that fail, as .poly files: as they are, and made small
    #[arg(long, value_name = "FOLDER")]
    failures: Option<PathBuf>,
    /// Print a line for every outline, not for the failing ones alone
    #[arg(long)]
    all: bool,
    /// Draw the rules at random too, among those that promise to end: each outline has its own
    #[arg(long)]
    profiles: bool,
    /// Only make the outlines and count what they are like
    #[arg(long)]
    census: bool,
}

fn main() -> std::io::Result<ExitCode> {
    let arguments = Arguments::parse();
    let census = Census::of(arguments.seed, arguments.first..arguments.first + arguments.count);
    println!("seed {}: {census}", arguments.seed);
    let mut failed = u64::from(!census.is_hostile_enough());
    if !arguments.census {
        failed += run(&arguments)?;
    }
    Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl Arguments {
    /// An outline and the rules that it is meshed by.
    fn drawn(&self, index: u64) -> (Pslg, Parameters) {
        let outline = hostile(self.seed, index);
        if !self.profiles {
            return (outline, Parameters::default());
        }
        let parameters = profiles::draw(self.seed, index, smallest_angle(&outline));
        (profiles::prepared(outline, &parameters), parameters)
    }
}

/// What one run tells.
struct Told {
    verdict: Verdict,
    points: usize,
}

/// Meshes the outlines and answers how many runs failed.
fn run(arguments: &Arguments) -> std::io::Result<u64> {
    let folder = FailureFolder::new(arguments.failures.clone())?;
    let limit = Duration::from_secs_f64(arguments.limit);
    let (mut kept, mut limited, mut failed, mut points) = (0_u64, 0_u64, 0_u64, 0_usize);
    let mut slowest = (Duration::ZERO, 0);
    let mut trouble = Ok(());
    let mesh_one = |i: usize| {
        let index = arguments.first + i as u64;
        let (outline, parameters) = arguments.drawn(index);
        guarded(move || {
            let judged = judge(&outline, &parameters);
            Told { points: judged.points(), verdict: judged.verdict }
        })
    };
    println!("{:>6}  {:<8}  {:>8}  {:>8}", "number", "verdict", "points", "seconds");
    in_order(arguments.count as usize, arguments.threads, mesh_one, |i, told| {
        let index = arguments.first + i as u64;
        slowest = slowest.max((told.time, index));
        let seconds = told.time.as_secs_f64();
        let (word, count, reasons) = judge_run(told, limit);
        points += count;
        match word {
            "kept" => kept += 1,
            "limited" => limited += 1,
            _ => failed += 1,
        }
        if arguments.all || !reasons.is_empty() {
            println!("{index:>6}  {word:<8}  {count:>8}  {seconds:>8.3}");
        }
        for reason in &reasons {
            println!("        {}", reason.replace('\n', "\n        "));
        }
        if !reasons.is_empty() {
            let (outline, parameters) = arguments.drawn(index);
            println!("        {}", profiles::options(&parameters));
            let name = format!("hostile_{}_{index}", arguments.seed);
            let kept = keep(&folder, &name, &outline, &parameters, &reasons);
            trouble = std::mem::replace(&mut trouble, Ok(())).and(kept);
        }
    });
    println!(
        "{} outlines: {kept} kept every promise, {limited} limited by precision, {failed} failed; \
         {points} points; slowest: number {} in {:.3} s",
        arguments.count,
        slowest.1,
        slowest.0.as_secs_f64()
    );
    trouble.map(|()| failed)
}

/// Writes a failing outline and, where its mesh breaks a guarantee, the smallest part of it whose
/// mesh breaks the same ones.
fn keep(
    folder: &FailureFolder,
    name: &str,
    outline: &Pslg,
    parameters: &Parameters,
    reasons: &[String],
) -> std::io::Result<()> {
    let options = profiles::options(parameters);
    folder.keep(name, outline, &format!("{options}\n{}", reasons.join("\n")))?;
    let original = broken(reasons);
    if folder.is_none() || original.is_empty() {
        return Ok(());
    }
    let fails_alike = |smaller: &Pslg| match judge(smaller, parameters).verdict {
        Verdict::Failed(reasons) => broken(&reasons) == original,
        _ => false,
    };
    let small = shrink(outline, &fails_alike);
    folder.keep(&format!("{name}_small"), &small, &format!("{options}\n{}", original.join(" ")))
}

/// The codes of the guarantees that are broken: the first words of the reasons, where those are.
fn broken(reasons: &[String]) -> Vec<&str> {
    reasons
        .iter()
        .filter_map(|reason| reason.split_once(':'))
        .map(|(code, _)| code)
        .filter(|code| Guarantee::ALL.iter().any(|guarantee| guarantee.code() == *code))
        .collect()
}

/// The word for a run, its points, and what is wrong with it.
fn judge_run(told: Timed<Told>, limit: Duration) -> (&'static str, usize, Vec<String>) {
    let late = (told.time > limit).then(|| {
        format!("{:.1} s, where {:.1} s are allowed", told.time.as_secs_f64(), limit.as_secs_f64())
    });
    match told.ending {
        Ending::Hung => ("hung", 0, vec!["the run does not end".to_owned()]),
        Ending::Panicked(message) => ("panic", 0, vec![message]),
        Ending::Done(Told { verdict: Verdict::Failed(mut reasons), points }) => {
            reasons.extend(late);
            ("failed", points, reasons)
        }
        Ending::Done(Told { points, .. }) if late.is_some() => {
            ("late", points, late.into_iter().collect())
        }
        Ending::Done(Told { verdict: Verdict::Kept, points }) => ("kept", points, Vec::new()),
        Ending::Done(Told { verdict: Verdict::Limited, points }) => ("limited", points, Vec::new()),
    }
}
