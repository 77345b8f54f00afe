//! Rule against rule over the large collection: points, angles, and where each rule ends.

use std::process::ExitCode;

use clap::Parser;
use meshwright::certify::{Certificate, Guarantee, Verdict};
use meshwright::{Parameters, Pslg, Rule, Splitting};
use meshwright_campaigns::experiments::{Run, paper};
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::survey::Survey;

/// Meshes every outline of the large collection that meshes as it is, by each of the three rules,
/// and prints points, smallest and largest angle, and where the rule ends.
///
/// The adaptive rule must keep every promise. The Terminator must end by itself with a conforming
/// Delaunay mesh whose subsegments nothing encroaches; its angles are not held to anything, and an
/// angle of 1e-7 rad costs it millions of points.
/// Ruppert's rule ends by itself, where doubles end, or at its budget of points.
///
/// Exit code 0: all of that is so. 1: it is not, or an outline took too long.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    #[command(flatten)]
    survey: Survey,
    /// Split on shells and take circumcenters, as the paper does, under all three rules
    #[arg(long)]
    paper: bool,
    /// The most points that Ruppert's rule may take
    #[arg(long, default_value_t = 50_000)]
    budget: usize,
}

/// The rules, in the order of the columns.
const RULES: [(&str, Rule); 3] =
    [("adaptive", Rule::Adaptive), ("terminator", Rule::Terminator), ("ruppert", Rule::Ruppert)];

fn main() -> std::io::Result<ExitCode> {
    let arguments = Arguments::parse();
    print!("{:<56} {:>9}", "", "");
    RULES.iter().for_each(|(word, _)| print!(" | {word:<35}"));
    print!("\n{:<56} {:>9}", "file", "θ*");
    RULES.iter().for_each(|_| {
        print!(" | {:>7} {:>9} {:>8} {:<8}", "points", "smallest", "largest", "ends")
    });
    println!();
    let mut sums = RULES.map(|_| Sum::default());
    let (by_the_paper, budget) = (arguments.paper, arguments.budget);
    let tally = arguments.survey.run(
        move |outline| Compared::of(outline, by_the_paper, budget),
        |file, compared| {
            compared.print(file);
            sums.iter_mut().zip(&compared.found).for_each(|(sum, found)| sum.add(found, file));
            compared.found.into_iter().flat_map(|found| found.complaints).collect()
        },
    )?;
    for ((word, _), sum) in RULES.iter().zip(&sums) {
        println!("{word:<10}  {sum}");
    }
    println!("{tally}");
    Ok(if tally.wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// What the rules make of one outline.
struct Compared {
    theta: Option<f64>,
    found: [Found; RULES.len()],
}

/// A rule's mesh in figures; angles in degrees.
#[derive(Default)]
struct Found {
    points: usize,
    smallest: f64,
    largest: f64,
    ends: End,
    complaints: Vec<String>,
}

/// Where a rule ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum End {
    /// By itself.
    #[default]
    Itself,
    /// Where doubles end.
    Floor,
    /// At the budget.
    Budget,
}

impl Compared {
    fn of(outline: &Pslg, by_the_paper: bool, budget: usize) -> Result<Self, String> {
        let ours = Parameters::default();
        let rules = if by_the_paper {
            Parameters { region: ours.region, ..paper(Splitting::Shells) }
        } else {
            ours
        };
        let mut found = RULES.map(|_| Found::default());
        for (found, (word, rule)) in found.iter_mut().zip(RULES) {
            let max_points = if rule == Rule::Ruppert { budget } else { rules.max_points };
            let run = Run::of(outline, &Parameters { rule, max_points, ..rules })?;
            *found = Found::of(&run, rule);
            found
                .complaints
                .iter_mut()
                .for_each(|complaint| *complaint = format!("{word}: {complaint}"));
        }
        Ok(Self { theta: smallest_angle(outline), found })
    }

    fn print(&self, file: &str) {
        let theta = self
            .theta
            .map_or_else(|| "-".to_owned(), |theta| format!("{:.4}°", theta.to_degrees()));
        print!("{file:<56} {theta:>9}");
        for Found { points, smallest, largest, ends, .. } in &self.found {
            print!(" | {points:>7} {smallest:>8.4}° {largest:>7.2}° {:<8}", ends.word());
        }
        println!();
    }
}

impl Found {
    fn of(run: &Run, rule: Rule) -> Self {
        let outcome = &run.outcome;
        let ends = match outcome.end {
            meshwright::refine::End::Finished if outcome.refused == 0 => End::Itself,
            meshwright::refine::End::Finished => End::Floor,
            _ => End::Budget,
        };
        Self {
            points: run.points(),
            smallest: run.statistics.smallest_angle.to_degrees(),
            largest: run.statistics.largest_angle.to_degrees(),
            complaints: complaints(rule, ends, &outcome.certificate),
            ends,
        }
    }
}

/// What a rule promises and did not keep.
fn complaints(rule: Rule, ends: End, certificate: &Certificate) -> Vec<String> {
    let held: &[Guarantee] = match rule {
        Rule::Adaptive => &Guarantee::ALL,
        Rule::Terminator => &[
            Guarantee::Complex,
            Guarantee::Delaunay,
            Guarantee::Unencroached,
            Guarantee::Conforming,
        ],
        Rule::Ruppert => &[Guarantee::Complex, Guarantee::Conforming],
    };
    let broken = held.iter().filter(|&&one| certificate.verdict(one) == Verdict::Fails);
    let mut complaints: Vec<String> = broken.map(|one| format!("{} fails", one.code())).collect();
    if rule != Rule::Ruppert && ends == End::Budget {
        complaints.push("it does not end".to_owned());
    }
    complaints
}

impl End {
    fn word(self) -> &'static str {
        match self {
            Self::Itself => "itself",
            Self::Floor => "doubles",
            Self::Budget => "budget",
        }
    }
}

/// What a rule does on all outlines.
#[derive(Default)]
struct Sum {
    points: usize,
    ends: [usize; 3],
    smallest: Option<(f64, String)>,
    largest: Option<(f64, String)>,
    /// How many meshes have an angle above the adaptive rule's bound.
    beyond: usize,
}

/// Corollary 3: 180° − 2 arcsin((√3 − 1)/2), rounded up.
const LARGEST: f64 = 137.06;

impl Sum {
    fn add(&mut self, found: &Found, file: &str) {
        self.points += found.points;
        self.ends[found.ends as usize] += 1;
        self.beyond += usize::from(found.largest > LARGEST);
        if self.smallest.as_ref().is_none_or(|least| found.smallest < least.0) {
            self.smallest = Some((found.smallest, file.to_owned()));
        }
        if self.largest.as_ref().is_none_or(|most| found.largest > most.0) {
            self.largest = Some((found.largest, file.to_owned()));
        }
    }
}

impl std::fmt::Display for Sum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [itself, doubles, budget] = self.ends;
        write!(
            f,
            "{} points; ends {itself} times by itself, {doubles} where doubles end, {budget} at the budget",
            self.points
        )?;
        if let Some((angle, file)) = &self.smallest {
            write!(f, "; smallest angle {angle:.4}° ({file})")?;
        }
        if let Some((angle, file)) = &self.largest {
            write!(f, ", largest {angle:.2}° ({file}); {} above {LARGEST}°", self.beyond)?;
        }
        Ok(())
    }
}
