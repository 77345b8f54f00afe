//! The figures that an acceptance asks for, each beside its bound.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Parser;
use meshwright::formats::poly;
use meshwright::{Excuse, Parameters, Pslg, Region, Splitting, Steiner};
use meshwright_campaigns::figures;
use meshwright_campaigns::judge::{Made, Verdict, judge};
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::motion::Motion;

/// Meshes the outlines that a figure is known for and prints each figure beside its bound.
///
/// Every mesh is judged. The rows that need the large collection of outlines (Lake Superior) are
/// left out without it.
///
/// Exit code 0: every bound is kept. 1: one is not.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// The large collection's folder
    #[arg(long, env = "MESHWRIGHT_DATA")]
    data: Option<PathBuf>,
    /// The first of the twelve seeds of the 20 spokes
    #[arg(long, default_value_t = 900)]
    seed: u64,
    /// Also the figures of the paper's own rules, which are slow for thin wedges
    #[arg(long)]
    paper: bool,
}

fn main() -> std::io::Result<ExitCode> {
    let arguments = Arguments::parse();
    let mut table = Table::new();
    wedges(&mut table);
    spokes(&mut table, arguments.seed, &Parameters::default(), Some(300));
    precision(&mut table);
    if let Some(data) = &arguments.data {
        superior(&mut table, data)?;
    } else {
        println!("(no MESHWRIGHT_DATA: Lake Superior is left out)");
    }
    if arguments.paper {
        paper(&mut table, arguments.seed);
    }
    println!("{} rows, {} beyond their bound", table.rows, table.broken);
    Ok(if table.broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// What a row may not exceed.
#[derive(Debug, Clone, Copy, Default)]
struct Bound {
    points: Option<usize>,
    seconds: Option<f64>,
}

/// Prints rows as they come and counts them.
struct Table {
    rows: usize,
    broken: usize,
}

impl Table {
    fn new() -> Self {
        println!(
            "{:<50} {:>8} {:>8} {:>9} {:>8}  {:<8} {:>9}",
            "outline", "points", "bound", "seconds", "bound", "verdict", "smallest"
        );
        Self { rows: 0, broken: 0 }
    }

    /// Meshes an outline, judges it, prints the row. Answers with the number of points and what
    /// was made.
    fn mesh(
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

    fn row(
        &mut self,
        name: &str,
        points: usize,
        time: Duration,
        bound: Bound,
        word: &str,
        smallest: Option<f64>,
    ) {
        let seconds = time.as_secs_f64();
        let within = bound.points.is_none_or(|most| points <= most)
            && bound.seconds.is_none_or(|most| seconds <= most);
        let most = |text: Option<String>| text.unwrap_or_default();
        println!(
            "{name:<50} {points:>8} {:>8} {seconds:>9.4} {:>8}  {word:<8} {:>9}{}",
            most(bound.points.map(|p| format!("≤ {p}"))),
            most(bound.seconds.map(|s| format!("≤ {s}"))),
            most(smallest.map(|a| format!("{:.4}°", a.to_degrees()))),
            if within { "" } else { "  BEYOND" }
        );
        self.rows += 1;
        self.broken += usize::from(!within);
    }
}

/// One wedge in a box.
fn wedges(table: &mut Table) {
    for (degrees, most) in [(1.0, 100), (0.1, 130), (0.01, 220), (0.001, 300)] {
        let wedge = figures::wedge(f64::to_radians(degrees));
        let bound = Bound { points: Some(most), ..Bound::default() };
        table.mesh(&format!("wedge of {degrees}°"), &wedge, &Parameters::default(), bound);
    }
}

/// The paper's 20 spokes.
fn spokes(table: &mut Table, first_seed: u64, parameters: &Parameters, most: Option<usize>) {
    let mut counts = Vec::new();
    for seed in first_seed..first_seed + 12 {
        let spokes = figures::spokes20(seed);
        let closest = smallest_angle(&spokes).unwrap_or_default().to_degrees();
        let name = format!("20 spokes, seed {seed}, closest pair {closest:.3}°");
        counts.push(table.mesh(&name, &spokes, parameters, Bound::default()).0);
    }
    counts.sort_unstable();
    let median = (counts[5] + counts[6]) / 2;
    let bound = Bound { points: most, ..Bound::default() };
    table.row("20 spokes, median of these twelve", median, Duration::ZERO, bound, "", None);
}

/// Where doubles end.
fn precision(table: &mut Table) {
    let slow = |points| Bound { points, seconds: Some(5.0) };
    let default = &Parameters::default();
    for theta in [1e-7, 1e-8, 1e-9] {
        let wedge = figures::wedge(theta);
        table.mesh(&format!("wedge of {theta:e} rad"), &wedge, default, slow(Some(600)));
        let away = Motion::offset([1e3, 1e3]).apply(&wedge);
        table.mesh(
            &format!("wedge of {theta:e} rad at (1000, 1000)"),
            &away,
            default,
            slow(Some(600)),
        );
    }
    let plate = figures::millimetres_at_five_million();
    table.mesh("details of 1e-3 at 5e6", &plate, default, slow(None));
    for scale in [1e-300, 1e300] {
        let wedge = Motion::scale(scale).apply(&figures::wedge(0.01));
        table.mesh(&format!("wedge of 0.01 rad, times {scale:e}"), &wedge, default, slow(None));
        let spokes = Motion::scale(scale).apply(&figures::spokes20(900));
        table.mesh(&format!("20 spokes, times {scale:e}"), &spokes, default, slow(None));
    }
    for (name, grid) in [
        ("200 × 200 squares, turned by 0.3 rad", figures::grid(200, 0.3)),
        ("200 × 200 lattice points, turned by 0.3 rad", figures::grid_points(200, 0.3)),
        ("200 × 200 squares", figures::grid(200, 0.0)),
    ] {
        table.mesh(name, &grid, default, slow(None));
    }
}

/// Lake Superior, from the large collection.
fn superior(table: &mut Table, data: &Path) -> std::io::Result<()> {
    let lake = read(data, "paper/superior.poly")?;
    let mut times: Vec<Duration> = (0..5)
        .map(|_| {
            let start = Instant::now();
            drop(meshwright::mesh(&lake, &Parameters::default()));
            start.elapsed()
        })
        .collect();
    times.sort_unstable();
    let bound = Bound { points: Some(967), ..Bound::default() };
    table.mesh("Lake Superior", &lake, &Parameters::default(), bound);
    table.row(
        "Lake Superior, median of 5 runs",
        0,
        times[2],
        Bound { seconds: Some(0.3), points: None },
        "",
        None,
    );
    table.mesh(
        "Lake Superior in a box",
        &read(data, "paper/superior_box.poly")?,
        &Parameters::default(),
        Bound::default(),
    );
    table.mesh(
        "Lake Superior (Natural Earth)",
        &read(data, "gis/superior_ne10.poly")?,
        &Parameters::default(),
        Bound::default(),
    );
    table.mesh(
        "Lake Superior in a box, the paper's rules (1 775)",
        &read(data, "paper/superior_box.poly")?,
        &paper_profile(),
        Bound::default(),
    );
    Ok(())
}

fn read(data: &Path, file: &str) -> std::io::Result<Pslg> {
    let path = data.join(file);
    let text = std::fs::read(&path)?;
    let (outline, _) = poly::read(&text, file, |node| std::fs::read(node))
        .map_err(|error| std::io::Error::other(error.to_string()))?;
    Ok(outline)
}

/// The paper's own rules.
fn paper_profile() -> Parameters {
    Parameters {
        splitting: Splitting::Shells,
        excuse: Excuse::Midpoints,
        steiner: Steiner::Circumcenter,
        region: Region::Hull,
        ..Parameters::default()
    }
}

/// The figures of the paper's rules, for comparison: no bound.
fn paper(table: &mut Table, seed: u64) {
    for degrees in [1.0, 0.1, 0.01] {
        let wedge = figures::wedge(f64::to_radians(degrees));
        table.mesh(
            &format!("wedge of {degrees}°, the paper's rules"),
            &wedge,
            &paper_profile(),
            Bound::default(),
        );
    }
    spokes(table, seed, &paper_profile(), None);
}
