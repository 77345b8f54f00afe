//! A table of figures beside their bounds.

use std::time::{Duration, Instant};

use meshwright::{Parameters, Pslg};
use meshwright_campaigns::judge::{Made, Verdict, judge};

/// What a row may not exceed.
#[derive(Debug, Clone, Copy, Default)]
pub struct Bound {
    /// The fewest points.
    pub fewest: usize,
    /// The most points.
    pub points: Option<usize>,
    /// The longest time.
    pub seconds: Option<f64>,
}

impl Bound {
    /// So many points.
    pub fn at_most(points: usize) -> Self {
        Self { points: Some(points), ..Self::default() }
    }

    /// From so many points to so many.
    pub fn within(points: std::ops::RangeInclusive<usize>) -> Self {
        Self { fewest: *points.start(), ..Self::at_most(*points.end()) }
    }

    fn points_text(self) -> String {
        match (self.fewest, self.points) {
            (0, Some(most)) => format!("≤ {most}"),
            (fewest, Some(most)) => format!("{fewest}–{most}"),
            _ => String::new(),
        }
    }
}

/// Prints rows as they come and counts them.
pub struct Table {
    /// How many rows there are.
    pub rows: usize,
    /// How many of them are beyond their bound.
    pub broken: usize,
}

impl Table {
    /// A table without rows.
    pub fn new() -> Self {
        println!(
            "{:<50} {:>8} {:>11} {:>9} {:>8}  {:<8} {:>9}",
            "outline", "points", "bound", "seconds", "bound", "verdict", "smallest"
        );
        Self { rows: 0, broken: 0 }
    }

    /// Meshes an outline, judges it, prints the row. Answers with the number of points and what
    /// was made.
    pub fn mesh(
        &mut self,
        name: &str,
        outline: &Pslg,
        parameters: &Parameters,
        bound: Bound,
    ) -> (usize, Option<Made>) {
        let start = Instant::now();
        let judged = judge(outline, parameters);
        let time = start.elapsed();
        let points = judged.points();
        let (word, reasons) = match &judged.verdict {
            Verdict::Kept => ("kept", Vec::new()),
            Verdict::Limited => ("limited", Vec::new()),
            Verdict::Failed(reasons) => ("FAILED", reasons.clone()),
        };
        let smallest = judged.made.as_ref().and_then(|made| made.certificate.smallest_angle);
        self.row(name, points, time, bound, word, smallest);
        for reason in &reasons {
            println!("    {}", reason.replace('\n', "\n    "));
        }
        if !reasons.is_empty() {
            self.broken += 1;
        }
        (points, judged.made)
    }

    /// Prints a row.
    pub fn row(
        &mut self,
        name: &str,
        points: usize,
        time: Duration,
        bound: Bound,
        word: &str,
        smallest: Option<f64>,
    ) {
        let seconds = time.as_secs_f64();
        let within = points >= bound.fewest
            && bound.points.is_none_or(|most| points <= most)
            && bound.seconds.is_none_or(|most| seconds <= most);
        let most = |text: Option<String>| text.unwrap_or_default();
        println!(
            "{name:<50} {points:>8} {:>11} {seconds:>9.4} {:>8}  {word:<8} {:>9}{}",
            bound.points_text(),
            most(bound.seconds.map(|s| format!("≤ {s}"))),
            most(smallest.map(|a| format!("{:.4}°", a.to_degrees()))),
            if within { "" } else { "  BEYOND" }
        );
        self.rows += 1;
        self.broken += usize::from(!within);
    }

    /// Prints whether something holds, with what was found.
    pub fn fact(&mut self, name: &str, found: &str, holds: bool) {
        println!("{name:<50} {found}{}", if holds { "" } else { "  BEYOND" });
        self.rows += 1;
        self.broken += usize::from(!holds);
    }
}
