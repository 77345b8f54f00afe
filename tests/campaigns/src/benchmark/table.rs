//! The table of a benchmark, in Markdown.

use super::programs::{Made, Program};

/// What a program made of a case, run by run; empty where it did not take part.
pub type Runs = Vec<Made>;

/// The head of the table.
#[must_use]
pub fn head() -> String {
    "| case | program | points | triangles | CPU s | wall s | peak MB | bytes/triangle | CPU / Triangle's |\n\
     |---|---|---:|---:|---:|---:|---:|---:|---:|\n"
        .to_owned()
}

/// The rows of a case: each program's runs, the medians of what they took, and the median of the
/// ratios to Triangle's run of the same round.
#[must_use]
pub fn rows(case: &str, runs: &[(Program, Runs)]) -> String {
    let triangle = runs.iter().find(|(program, _)| *program == Program::Triangle);
    let triangle = triangle.map_or(&[][..], |(_, runs)| &runs[..]);
    let took_part = runs.iter().filter(|(_, runs)| !runs.is_empty());
    took_part.map(|(program, runs)| row(case, *program, runs, triangle)).collect()
}

fn row(case: &str, program: Program, runs: &[Made], triangle: &[Made]) -> String {
    let first = &runs[0];
    let of = |value: fn(&Made) -> f64| median(runs.iter().map(value).collect());
    let cpu = of(|made| made.run.cpu);
    let wall = of(|made| made.run.wall);
    let peak = of(|made| made.run.peak as f64);
    let pairs = runs.iter().zip(triangle);
    let ratios: Vec<f64> = pairs.map(|(ours, theirs)| ours.run.cpu / theirs.run.cpu).collect();
    let ratio = match ratios.is_empty() {
        true => "–".to_owned(),
        false => format!("{:.2}", median(ratios)),
    };
    format!(
        "| {case} | {} | {} | {} | {cpu:.2} | {wall:.2} | {:.0} | {:.0} | {ratio} |\n",
        program.name(),
        first.points,
        first.triangles,
        peak / 1e6,
        peak / first.triangles as f64,
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
    use super::super::process::Run;
    use super::*;

    #[test]
    fn a_ratio_is_the_median_of_the_rounds() {
        let made = |cpu| Made {
            run: Run { cpu, wall: cpu, peak: 1_000_000, output: String::new() },
            points: 9,
            triangles: 10,
        };
        // A slow round slows both: 1/2, 5/10, 3/4.
        let ours = [1.0, 5.0, 3.0].map(made).to_vec();
        let theirs = [2.0, 10.0, 4.0].map(made).to_vec();
        let text = rows("c", &[(Program::Judged, ours), (Program::Triangle, theirs)]);
        let first = text.lines().next().expect("there is a row");
        assert!(first.ends_with("| 0.50 |"), "{text}");
    }
}
