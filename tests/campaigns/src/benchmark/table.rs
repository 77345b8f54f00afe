//! The table of a benchmark, in Markdown.

use super::process::Run;
use super::programs::{Counts, Program};

/// What a program made of a case.
#[derive(Debug, Clone)]
pub struct Made {
    /// The program.
    pub program: Program,
    /// How large its mesh is, which is the same in each run.
    pub counts: Counts,
    /// What each run took.
    pub runs: Vec<Run>,
}

/// The head of the table.
#[must_use]
pub fn head() -> String {
    "| case | program | points | triangles | CPU s | wall s | peak MB | bytes/triangle | CPU / Triangle's |\n\
     |---|---|---:|---:|---:|---:|---:|---:|---:|\n"
        .to_owned()
}

/// The rows of a case: the medians of what each program's runs took, and the median of the ratios to
/// Triangle's run of the same round.
#[must_use]
pub fn rows(case: &str, made: &[Made]) -> String {
    let triangle = made.iter().find(|made| made.program == Program::Triangle);
    let triangle = triangle.map_or(&[][..], |made| &made.runs[..]);
    made.iter().map(|made| row(case, made, triangle)).collect()
}

fn row(case: &str, made: &Made, triangle: &[Run]) -> String {
    let Made { program, counts: Counts { points, triangles }, runs } = made;
    let of = |value: fn(&Run) -> f64| median(runs.iter().map(value).collect());
    let cpu = of(|run| run.cpu);
    let wall = of(|run| run.wall);
    let peak = of(|run| run.peak as f64);
    let pairs = runs.iter().zip(triangle);
    let ratios: Vec<f64> = pairs.map(|(ours, theirs)| ours.cpu / theirs.cpu).collect();
    let ratio = match ratios.is_empty() {
        true => "–".to_owned(),
        false => format!("{:.2}", median(ratios)),
    };
    format!(
        "| {case} | {} | {points} | {triangles} | {cpu:.2} | {wall:.2} | {:.0} | {:.0} | {ratio} |\n",
        program.name(),
        peak / 1e6,
        peak / *triangles as f64,
    )
}

/// The middle of some numbers, of an even count the mean of the two in the middle.
///
/// # Panics
/// Where there are none.
#[must_use]
pub fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let middle = numbers.len() / 2;
    match numbers.len() % 2 {
        1 => numbers[middle],
        _ => 0.5 * (numbers[middle - 1] + numbers[middle]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_the_median_of_the_rounds() {
        let run = |cpu| Run { cpu, wall: cpu, peak: 1_000_000, output: String::new() };
        let made = |program, cpu: [f64; 3]| Made {
            program,
            counts: Counts { points: 9, triangles: 10 },
            runs: cpu.map(run).to_vec(),
        };
        // A slow round slows both: 1/2, 5/10, 3/4.
        let ours = made(Program::Judged, [1.0, 5.0, 3.0]);
        let theirs = made(Program::Triangle, [2.0, 10.0, 4.0]);
        let text = rows("c", &[ours, theirs]);
        let first = text.lines().next().expect("there is a row");
        assert!(first.ends_with("| 0.50 |"), "{text}");
    }
}
