//! Soft targets above 26.45° over the large collection.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Parser;
use meshwright::{MinAngle, Parameters, Pslg, Steiner};
use meshwright_campaigns::experiments::adaptive;
use meshwright_campaigns::survey::Survey;

/// Meshes every outline of the large collection that meshes as it is, with the smallest angle aimed at
/// 30°, 33° and 34°, and prints points and missed angles.
///
/// Every mesh must be certified, in 10 s at most. At most one angle in a thousand may be missed
/// (of scripts, which come with sizes of their own, they are only counted). Lake Superior, with and without its box, has bounds on its points.
///
/// Exit code 0: all of that is so. 1: it is not, or an outline took too long.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    #[command(flatten)]
    survey: Survey,
}

/// The targets, in degrees.
const TARGETS: [f64; 3] = [30.0, 33.0, 34.0];

/// The most points for each target.
const MOST_POINTS: [(&str, [usize; TARGETS.len()]); 2] = [
    ("paper/superior.poly", [1_185, 1_460, 1_665]),
    ("paper/superior_box.poly", [2_130, 2_980, 3_465]),
];

/// The longest that a run may take.
const LONGEST: Duration = Duration::from_secs(10);

/// How many of the worst meshes are named.
const NAMED: usize = 10;

/// A mesh with a target, in figures.
#[derive(Debug, Clone, Copy, Default)]
struct Aimed {
    points: usize,
    angles: usize,
    missed: usize,
    excused: usize,
    /// The smallest angle that misses the target, in degrees.
    worst: Option<f64>,
    time: Duration,
}

fn main() -> std::io::Result<ExitCode> {
    let arguments = Arguments::parse();
    print!("{:<56}", "file");
    for target in TARGETS {
        print!(" | {:>7} {:>6} {:>8} at {target}°", "points", "missed", "least");
    }
    println!();
    let mut all: Vec<(String, f64, Aimed)> = Vec::new();
    let tally = arguments.survey.run(aim, |file, meshes| {
        print!("{file:<56}");
        for aimed in &meshes {
            let least = aimed.worst.map_or_else(|| "-".to_owned(), |worst| format!("{worst:.2}°"));
            print!(" | {:>7} {:>6} {least:>8}       ", aimed.points, aimed.missed);
        }
        println!();
        all.extend(
            TARGETS.iter().zip(meshes).map(|(&target, aimed)| (file.to_owned(), target, aimed)),
        );
        complaints(file, &meshes)
    })?;
    sum_up(all);
    println!("{tally}");
    Ok(if tally.wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Meshes an outline with each target.
fn aim(outline: &Pslg) -> Result<[Aimed; TARGETS.len()], String> {
    let mut meshes = [Aimed::default(); TARGETS.len()];
    for (mesh, degrees) in meshes.iter_mut().zip(TARGETS) {
        let target = MinAngle::soft_from_degrees(degrees).map_err(|error| error.to_string())?;
        // As the command does it.
        let steiner = Steiner::LookAhead;
        let parameters = Parameters { soft_angle: Some(target), steiner, ..Parameters::default() };
        let start = Instant::now();
        let run = adaptive(outline, &parameters).map_err(|error| format!("{degrees}°: {error}"))?;
        let missed = &run.outcome.missed;
        *mesh = Aimed {
            points: run.points(),
            angles: 3 * run.statistics.triangles,
            missed: missed.len(),
            excused: run.outcome.certificate.excused.len(),
            time: start.elapsed(),
            worst: missed.iter().map(|one| one.radians.to_degrees()).min_by(f64::total_cmp),
        };
    }
    Ok(meshes)
}

/// What a target promises and did not keep.
fn complaints(file: &str, meshes: &[Aimed; TARGETS.len()]) -> Vec<String> {
    let bounds = MOST_POINTS.iter().find(|(name, _)| *name == file).map(|(_, most)| most);
    let mut complaints = Vec::new();
    for (i, (target, aimed)) in TARGETS.iter().zip(meshes).enumerate() {
        if 1000 * aimed.missed > aimed.angles {
            complaints
                .push(format!("{target}°: {} of {} angles missed", aimed.missed, aimed.angles));
        }
        if aimed.time > LONGEST {
            complaints.push(format!("{target}°: {:.1} s", aimed.time.as_secs_f64()));
        }
        if let Some(most) = bounds.map(|most| most[i]).filter(|&most| aimed.points > most) {
            complaints.push(format!("{target}°: {} points, {most} are allowed", aimed.points));
        }
    }
    complaints
}

/// Prints the sums for each target, and the meshes with the largest share of missed angles.
fn sum_up(mut all: Vec<(String, f64, Aimed)>) {
    for target in TARGETS {
        let mut sum = Aimed::default();
        let mut outlines = 0;
        for (_, _, aimed) in all.iter().filter(|(_, at, _)| *at == target) {
            sum.points += aimed.points;
            sum.angles += aimed.angles;
            sum.missed += aimed.missed;
            sum.excused += aimed.excused;
            outlines += usize::from(aimed.missed > 0);
        }
        println!(
            "{target}°: {} points, {} angles; {} missed in {outlines} outlines, {} excused",
            sum.points, sum.angles, sum.missed, sum.excused
        );
    }
    let share = |aimed: &Aimed| 1000.0 * aimed.missed as f64 / aimed.angles.max(1) as f64;
    all.sort_by(|(_, _, a), (_, _, b)| share(b).total_cmp(&share(a)));
    for (file, target, aimed) in all.iter().take(NAMED).filter(|(_, _, aimed)| aimed.missed > 0) {
        println!(
            "{:.3} of 1000 angles missed: {file} at {target}°, {} of {}",
            share(aimed),
            aimed.missed,
            aimed.angles
        );
    }
}
