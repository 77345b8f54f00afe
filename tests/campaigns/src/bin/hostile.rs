//! Makes hostile outlines and meshes them.

use std::process::ExitCode;

use clap::Parser;
use meshwright_campaigns::hostile::{NEAREST, hostile};
use meshwright_campaigns::measure::{clearance, is_clean, smallest_angle};

/// Makes hostile outlines: clean, with angles down to 1e-9 rad.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// Which outlines: each seed has its own.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How many.
    #[arg(long, default_value_t = 2000)]
    count: u64,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let census = Census::of(arguments.seed, arguments.count);
    println!("{census}");
    if census.is_hostile_enough() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// What a set of outlines is like.
struct Census {
    outlines: u64,
    unclean: u64,
    too_near: u64,
    under_a_degree: u64,
    under_a_millidegree: u64,
    under_1e_7: u64,
}

impl Census {
    fn of(seed: u64, count: u64) -> Self {
        let mut census = Self {
            outlines: count,
            unclean: 0,
            too_near: 0,
            under_a_degree: 0,
            under_a_millidegree: 0,
            under_1e_7: 0,
        };
        for outline in (0..count).map(|index| hostile(seed, index)) {
            let theta = smallest_angle(&outline).unwrap_or(f64::INFINITY);
            census.unclean += u64::from(!is_clean(&outline));
            census.too_near += u64::from(clearance(&outline) < NEAREST);
            census.under_a_degree += u64::from(theta.to_degrees() < 1.0);
            census.under_a_millidegree += u64::from(theta.to_degrees() < 1e-3);
            census.under_1e_7 += u64::from(theta < 1e-7);
        }
        census
    }

    fn is_hostile_enough(&self) -> bool {
        self.unclean == 0
            && self.too_near == 0
            && self.under_a_degree * 5 >= self.outlines
            && self.under_a_millidegree * 20 >= self.outlines
            && self.under_1e_7 * 100 >= self.outlines
    }
}

impl std::fmt::Display for Census {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let percent = |part: u64| 100.0 * part as f64 / self.outlines.max(1) as f64;
        write!(
            f,
            "{} outlines: {} not clean, {} with disjoint features too near; θ* < 1°: {:.1} %, \
             < 1e-3°: {:.1} %, < 1e-7 rad: {:.1} %",
            self.outlines,
            self.unclean,
            self.too_near,
            percent(self.under_a_degree),
            percent(self.under_a_millidegree),
            percent(self.under_1e_7)
        )
    }
}
