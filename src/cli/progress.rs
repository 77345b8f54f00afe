//! The one line that moves on a terminal while a long run goes on.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use meshwright::refine::Progress;

use super::interrupt;
use super::voice::Voice;

/// Runs shorter than this show nothing.
const SHORT: Duration = Duration::from_millis(300);

/// The line. In a pipe, or if the command is to be quiet, it is nothing.
pub struct ProgressLine {
    bar: ProgressBar,
    start: Instant,
}

impl ProgressLine {
    /// A line that shows itself when the run turns out to be a long one.
    pub fn new(voice: &Voice) -> Self {
        let target = match voice.quiet {
            true => ProgressDrawTarget::hidden(),
            false => ProgressDrawTarget::stderr_with_hz(10),
        };
        let bar = ProgressBar::with_draw_target(None, target);
        if let Ok(style) = ProgressStyle::with_template("{msg}") {
            bar.set_style(style);
        }
        Self { bar, start: Instant::now() }
    }

    /// Shows how far the run has come. It goes on, unless an interrupt asks it to stop.
    pub fn show(&self, progress: Progress) -> ControlFlow<()> {
        let elapsed = self.start.elapsed();
        if elapsed >= SHORT && !self.bar.is_hidden() {
            let rate = progress.triangles as f64 / elapsed.as_secs_f64();
            self.bar.set_message(match progress.thinning {
                None => format!(
                    "refining {} triangles, {} left to judge, {}/s",
                    short(progress.triangles as f64),
                    short(progress.waiting as f64),
                    short(rate)
                ),
                Some(thinning) => format!(
                    "thinning {} points, {} fewer, {} of {} tries",
                    short(progress.points as f64),
                    short(thinning.saved as f64),
                    short(thinning.tries as f64),
                    short(thinning.of as f64)
                ),
            });
            self.bar.tick();
        }
        // What is thinned is a whole mesh at any time.
        interrupt::stops_when_asked(progress.thinning.is_some());
        if interrupt::asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Takes the line away and tells how long the run took.
    pub fn finish(self) -> Duration {
        interrupt::stops_when_asked(false);
        self.bar.finish_and_clear();
        self.start.elapsed()
    }
}

/// `950`, `41 k`, `1.2 M`.
fn short(number: f64) -> String {
    const UNITS: [&str; 4] = ["", " k", " M", " G"];
    let mut value = number;
    let mut unit = 0;
    while value >= 999.5 && unit + 1 < UNITS.len() {
        value /= 1000.0;
        unit += 1;
    }
    let digits = usize::from(unit > 0 && value < 9.95);
    format!("{value:.digits$}{}", UNITS[unit])
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn large_numbers_are_short() {
        let texts = [950.0, 41_234.0, 1_234_567.0, 9_990_000.0, 2.5e9].map(short);
        assert_eq!(texts, ["950", "41 k", "1.2 M", "10 M", "2.5 G"]);
    }
}
