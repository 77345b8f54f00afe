//! What `mesh` says about a run.

use std::cell::OnceCell;
use std::time::Duration;

use meshwright::certify::ExcusedAngle;
use meshwright::formats::Pslg;
use meshwright::refine::End;
use meshwright::refine::counters::Counters;
use meshwright::refine::thin::Thinned;
use meshwright::statistics::{Statistics, smallest_angle_but};
use meshwright::{MinAngle, Missed, Outcome};

use super::format::Format;
use super::info::groups_text;
use super::output::{STDOUT, Written};
use super::voice::Voice;
use super::wording::{angle, bytes, count, grouped};
use super::writing::WriteOptions;

/// What there is to say.
pub struct Summary<'a> {
    pslg: &'a Pslg,
    outcome: &'a Outcome,
    soft_angle: Option<MinAngle>,
    statistics: OnceCell<Statistics>,
}

impl<'a> Summary<'a> {
    /// What there is to say of a run that meshed an outline.
    pub fn new(pslg: &'a Pslg, outcome: &'a Outcome, soft_angle: Option<MinAngle>) -> Self {
        Self { pslg, outcome, soft_angle, statistics: OnceCell::new() }
    }

    /// The mesh's counts and angles, measured once, and only if anything is said of them.
    pub fn statistics(&self) -> &Statistics {
        self.statistics.get_or_init(|| self.outcome.statistics())
    }

    /// From the outline to the certificate.
    pub fn say_mesh(&self, name: &str, took: Duration, voice: &Voice) {
        if voice.quiet {
            return;
        }
        let (pslg, statistics) = (self.pslg, self.statistics());
        say(voice, "outline", &format!("{name}: {}", outline_counts(pslg)));
        if let Some(text) = self.smallest_input_angle() {
            say(voice, "", &text);
        }
        say(
            voice,
            "mesh",
            &format!(
                "{}, {} in {}",
                count(statistics.points, "point"),
                count(statistics.triangles, "triangle"),
                seconds(took)
            ),
        );
        if let Some(thinned) = self.outcome.thinned {
            say(voice, "thinned", &thinned_text(thinned));
        }
        say(voice, "angles", &self.angles(voice.verbose));
        if voice.verbose {
            let excused = &self.outcome.certificate.excused;
            excused.iter().for_each(|excused| say(voice, "", &excused_text(excused)));
        }
        if let Some(target) = self.soft_angle {
            say(voice, "target", &self.target(target, voice.verbose));
            if voice.verbose {
                let missed = &self.outcome.missed;
                missed.iter().for_each(|missed| say(voice, "", &missed_text(missed)));
            }
        }
        if !self.outcome.introduced.is_empty() {
            say(voice, "order", &self.order());
        }
        say(voice, "groups", &groups_text(&statistics.groups, "edge"));
        self.say_certificate(voice);
    }

    /// What the run did, counted.
    pub fn say_work(&self, voice: &Voice) {
        let Counters { popped, stale, committed, exact, .. } = self.outcome.counters;
        let [stale, exact] = [stale as u64, exact].map(grouped);
        let cavity = self.outcome.counters.mean_cavity();
        let (popped, committed) = (count(popped, "bad triangle"), count(committed, "point"));
        say(voice, "work", &format!("{popped} taken from the queue, {stale} of them gone by then"));
        say(voice, "", &format!("{committed} committed, {cavity:.2} triangles replaced by each"));
        say(voice, "", &format!("{exact} questions that only exact arithmetic could answer"));
    }

    /// Where the mesh went.
    pub fn say_written(
        &self,
        written: &[(Written, Format)],
        options: &WriteOptions,
        voice: &Voice,
    ) {
        let told: Vec<String> = written
            .iter()
            .filter(|(written, _)| written.place.as_os_str() != STDOUT)
            .map(|(written, format)| {
                let size = bytes(written.size);
                format!("{} ({}, {size})", written.place.display(), options.name(*format))
            })
            .collect();
        if !told.is_empty() {
            say(voice, "wrote", &told.join(", "));
        }
    }

    /// `smallest angle 5.85°, between segments 417 and 418 at point 418`
    fn smallest_input_angle(&self) -> Option<String> {
        let corner = self.outcome.smallest_input_angle?;
        let source = &self.pslg.source;
        let [Some(a), Some(b)] = corner.segments else { return None };
        let [a, b] = [a, b].map(|segment| source.segment_number(segment));
        let point = source.point_number(corner.point);
        let smallest = angle(corner.radians);
        Some(format!("smallest angle {smallest}, between segments {a} and {b} at point {point}"))
    }

    /// `26.45° to 126.9°; 3 smaller ones excused by the outline (5.85° … 19.2°; …)`
    fn angles(&self, verbose: bool) -> String {
        let mesh = &self.outcome.mesh;
        let excused = &self.outcome.certificate.excused;
        let named = excused.iter().map(|excused| (excused.triangle, excused.edge));
        let smallest = match excused.len() {
            0 => self.statistics().smallest_angle,
            _ => smallest_angle_but(mesh, named),
        };
        let range = format!("{} to {}", angle(smallest), angle(self.statistics().largest_angle));
        let measured = || excused.iter().map(|excused| excused.angle);
        let least = measured().fold(f64::INFINITY, f64::min);
        let most = measured().fold(0.0, f64::max);
        let list = if verbose { "" } else { "; --verbose lists them" };
        match excused.len() {
            0 => range,
            1 => format!("{range}; a smaller one excused by the outline ({})", angle(least)),
            n => format!(
                "{range}; {} smaller ones excused by the outline ({} … {}{list})",
                grouped(n as u64),
                angle(least),
                angle(most)
            ),
        }
    }

    /// `33.00°: reached, but for what the outline excuses; promised is 26.45°`
    fn target(&self, target: MinAngle, verbose: bool) -> String {
        let asked = angle(target.radians());
        let promised = angle(MinAngle::default().radians());
        let least = self.outcome.missed.iter().map(|missed| missed.radians);
        let least = least.fold(f64::INFINITY, f64::min);
        let list = if verbose { "" } else { "; --verbose lists them" };
        match self.outcome.missed.len() {
            0 => format!(
                "{asked}: reached, but for what the outline excuses; promised is {promised}"
            ),
            n => format!(
                "{asked}: {} missed, from {} up, where it was not safe to ask for more; promised is \
                 {promised}{list}",
                count(n, "angle"),
                angle(least)
            ),
        }
    }

    /// `518 points and segments introduced one by one, 31 before their turn`
    fn order(&self) -> String {
        let introduced = &self.outcome.introduced;
        let early = introduced.iter().filter(|it| it.called_by.is_some()).count();
        format!(
            "{} introduced one by one, {} before their turn",
            count(introduced.len(), "feature"),
            grouped(early as u64)
        )
    }

    fn say_certificate(&self, voice: &Voice) {
        let certificate = &self.outcome.certificate;
        let (label, text) = match (self.outcome.end, certificate.holds()) {
            _ if !certificate.is_judged() => {
                say(
                    voice,
                    "unjudged",
                    "nothing is promised until `meshwright check` has judged it",
                );
                return;
            }
            (End::PointBudget, _) => ("stopped", "early, so not everything is kept:"),
            (_, false) => ("FAILS", "the judge found what must not be:"),
            _ if certificate.limited() => ("certified", "but for places where doubles end:"),
            _ => {
                say(voice, "certified", "conforming, Delaunay, every angle accounted for");
                return;
            }
        };
        say(voice, label, text);
        certificate.to_string().lines().for_each(|line| say(voice, "", line));
    }
}

fn say(voice: &Voice, label: &str, text: &str) {
    voice.say(&format!("{label:<9} {text}"));
}

/// `triangle 12: 19.2° between segments 417 and 418, which meet at 5.85°`
pub fn excused_text(excused: &ExcusedAngle) -> String {
    format!(
        "triangle {}: {} between segments {} and {}, which meet at {}",
        u64::from(excused.triangle) + 1,
        angle(excused.angle),
        excused.segments[0].number,
        excused.segments[1].number,
        angle(excused.theta)
    )
}

/// `triangle 12: 27.3° misses the target`
fn missed_text(missed: &Missed) -> String {
    let number = u64::from(missed.triangle) + 1;
    format!("triangle {number}: {} misses the target", angle(missed.radians))
}

/// `67 points fewer after 20 000 tries, of which 9 120 were kept`
fn thinned_text(Thinned { tries, kept, saved, .. }: Thinned) -> String {
    format!(
        "{} fewer after {}, of which {} were kept",
        count(saved as usize, "point"),
        if tries == 1 { "1 try".to_string() } else { format!("{} tries", grouped(tries)) },
        grouped(kept)
    )
}

/// `1 294 points, 1 294 segments, 16 holes`
pub fn outline_counts(pslg: &Pslg) -> String {
    let mut parts = vec![count(pslg.points.len(), "point"), count(pslg.segments.len(), "segment")];
    for (number, noun) in [(pslg.holes.len(), "hole"), (pslg.regions.len(), "region")] {
        if number > 0 {
            parts.push(count(number, noun));
        }
    }
    parts.join(", ")
}

/// `0.02 s`, `3.1 s`, `75 s`
fn seconds(took: Duration) -> String {
    let seconds = took.as_secs_f64();
    let digits = match seconds {
        s if s < 1.0 => 2,
        s if s < 10.0 => 1,
        _ => 0,
    };
    format!("{seconds:.digits$} s")
}
