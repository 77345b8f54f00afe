//! Steps of a trace as a picture: one of them, or a film strip.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use meshwright::draw::{self, Highlight, Options, Step};
use meshwright::refine::incremental::{Feature, Introduction};
use meshwright::refine::trace::{BadTriangle, Cause, Event, Fault, Made, Refusal, Replay};

use super::read::Reader;
use crate::cli::failure::Failure;
use crate::cli::output::{Pending, Written, check_places};
use crate::cli::wording::angle;

/// Which steps of which trace are drawn.
#[derive(Debug, Args)]
pub struct Film {
    /// Draw steps of this trace (what `meshwright trace` writes).
    #[arg(long, value_name = "FILE", conflicts_with_all = ["file", "from", "input", "scale"])]
    trace: Option<PathBuf>,
    /// The step that is drawn; 0 is what the run began with [default: the last one].
    #[arg(long, value_name = "N", conflicts_with = "film")]
    step: Option<usize>,
    /// Draw a film strip of this many steps, evenly from the first to the last.
    #[arg(long, value_name = "N",
          value_parser = clap::value_parser!(u16).range(1..=400))]
    film: Option<u16>,
    /// How many pictures of a film strip stand side by side.
    #[arg(long, value_name = "N", default_value = "4",
          value_parser = clap::value_parser!(u16).range(1..=20))]
    columns: u16,
}

impl Film {
    /// The trace that is drawn, if one is.
    pub fn trace(&self) -> Result<Option<&Path>, Failure> {
        if self.trace.is_none() && (self.step.is_some() || self.film.is_some()) {
            return Err(Failure::usage("--step and --film draw a trace; --trace FILE names it"));
        }
        Ok(self.trace.as_deref())
    }

    /// The steps that are drawn, of so many after the first.
    fn steps(&self, last: usize) -> Result<Vec<usize>, Failure> {
        if let Some(frames) = self.film.map(usize::from) {
            let all = (0..frames).map(|i| match frames {
                1 => last,
                _ => i * last / (frames - 1),
            });
            let mut steps: Vec<usize> = all.collect();
            steps.dedup();
            return Ok(steps);
        }
        match self.step {
            Some(step) if step > last => {
                Err(Failure::usage(format!("--step {step}: the last step of the trace is {last}")))
            }
            step => Ok(vec![step.unwrap_or(last)]),
        }
    }
}

/// Draws the steps that are asked for.
pub fn draw(
    film: &Film,
    trace: &Path,
    options: &Options,
    output: &Path,
) -> Result<Written, Failure> {
    check_places(&[output.to_path_buf()], &[trace.to_path_buf()])?;
    let text = fs::read_to_string(trace).map_err(|error| Failure::io(trace, &error))?;
    let mut reader = Reader::default();
    let mut events = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let wrong = |text: String| {
            Failure::input(format!(
                "{}:{number}: this is no line of a trace: {text}",
                trace.display()
            ))
        };
        events.extend(reader.read(line).map_err(wrong)?);
    }
    if events.is_empty() {
        return Err(Failure::input(format!("{}: the trace is empty", trace.display())));
    }
    let wanted = film.steps(events.len() - 1)?;
    let mut replay = Replay::default();
    let mut drawn = Vec::new();
    for (number, event) in events.iter().enumerate() {
        replay.apply(event).map_err(|error| {
            Failure::input(format!("{}:{}: {error}", trace.display(), number + 1))
        })?;
        if wanted.contains(&number) {
            let seen = Seen { event, replay: &replay, reader: &reader };
            drawn.push(Step {
                mesh: replay.mesh(),
                caption: seen.caption(number),
                highlights: seen.highlights(),
            });
        }
    }
    let columns = usize::from(film.columns).min(drawn.len());
    let written = |mut out: &mut dyn std::io::Write| draw::film(&drawn, columns, options, &mut out);
    let (pending, ()) = Pending::write(output, written)?;
    pending.finish()
}

/// An event and the triangulation after it.
struct Seen<'a> {
    event: &'a Event,
    replay: &'a Replay,
    reader: &'a Reader,
}

impl Seen<'_> {
    /// `step 7: midpoint 12 splits segment 3, which point 9 encroaches`
    fn caption(&self, number: usize) -> String {
        let what = match self.event {
            Event::Introduced(Introduction { feature, called_by }) => {
                let what = match feature {
                    Feature::Point(vertex) => format!("point {}", self.number(*vertex)),
                    Feature::Segment(_) => "a segment".to_string(),
                };
                let early = if called_by.is_some() { " before its turn" } else { "" };
                format!("{what} comes in{early}")
            }
            Event::Commit { bad, made } => {
                format!("point {} for {}", self.number(made.vertex), fault(bad))
            }
            Event::Split { cause, made, .. } => {
                format!("split at {}: {}", self.number(made.vertex), self.cause(*cause))
            }
            Event::Rejected { bad, .. } => format!("rejected, for {}", fault(bad)),
            Event::RefusedSplit { refusal, .. } => format!("split refused: {}", reason(*refusal)),
            Event::RefusedPoint { refusal, .. } => format!("point refused: {}", reason(*refusal)),
            _ => "the start".to_string(),
        };
        format!("{number}: {what}")
    }

    fn cause(&self, cause: Cause) -> String {
        match cause {
            Cause::Encroached(vertex) => format!("{} encroaches", self.number(vertex)),
            Cause::Rejected(_) => "a rejected point encroaches".to_string(),
            Cause::Size => "too long".to_string(),
            Cause::Augmented => "Algorithm 1".to_string(),
        }
    }

    fn number(&self, vertex: u32) -> i64 {
        self.reader.number(vertex)
    }

    fn highlights(&self) -> Vec<Highlight> {
        match self.event {
            Event::Introduced(Introduction { feature, called_by }) => {
                let point = match feature {
                    Feature::Point(vertex) => self.replay.point(*vertex).map(Highlight::New),
                    Feature::Segment(_) => None,
                };
                let caller = called_by.and_then(|corners| self.corners(corners));
                point.into_iter().chain(caller.map(Highlight::Bad)).collect()
            }
            Event::Commit { bad, made } => {
                let mut found = self.star(made);
                found.extend(self.corners(bad.vertices).map(Highlight::Bad));
                found.push(Highlight::New(made.point));
                found
            }
            Event::Split { subsegment, cause, made, .. } => {
                let mut found = self.star(made);
                found.extend(self.ends(subsegment.ends).map(Highlight::Encroached));
                found.extend(self.because(*cause));
                found.push(Highlight::New(made.point));
                found
            }
            Event::Rejected { bad, point, encroached } => {
                let mut found: Vec<_> =
                    self.corners(bad.vertices).map(Highlight::Bad).into_iter().collect();
                let circles = encroached.iter().filter_map(|piece| self.ends(piece.ends));
                found.extend(circles.map(Highlight::Encroached));
                found.push(Highlight::Rejected(*point));
                found
            }
            Event::RefusedSplit { subsegment, cause, .. } => {
                let circle = self.ends(subsegment.ends).map(Highlight::Encroached);
                circle.into_iter().chain(self.because(*cause)).collect()
            }
            Event::RefusedPoint { bad, point, .. } => {
                let bad = self.corners(bad.vertices).map(Highlight::Bad);
                bad.into_iter().chain([Highlight::Rejected(*point)]).collect()
            }
            _ => Vec::new(),
        }
    }

    fn star(&self, made: &Made) -> Vec<Highlight> {
        let triangles = made.star.iter().filter_map(|&vertices| self.corners(vertices));
        triangles.map(Highlight::Made).collect()
    }

    fn because(&self, cause: Cause) -> Option<Highlight> {
        match cause {
            Cause::Encroached(vertex) => self.replay.point(vertex).map(Highlight::Encroaching),
            Cause::Rejected(vertices) => self.corners(vertices).map(Highlight::Bad),
            Cause::Size | Cause::Augmented => None,
        }
    }

    fn corners(&self, [a, b, c]: [u32; 3]) -> Option<[[f64; 2]; 3]> {
        Some([self.replay.point(a)?, self.replay.point(b)?, self.replay.point(c)?])
    }

    fn ends(&self, [a, b]: [u32; 2]) -> Option<[[f64; 2]; 2]> {
        Some([self.replay.point(a)?, self.replay.point(b)?])
    }
}

fn fault(bad: &BadTriangle) -> String {
    match bad.fault {
        Fault::Angle(radians) => angle(radians),
        Fault::Area(_) => "size".to_string(),
    }
}

fn reason(refusal: Refusal) -> &'static str {
    match refusal {
        Refusal::AllSplitsRefused => "all its splits are",
        _ => "where doubles end",
    }
}
