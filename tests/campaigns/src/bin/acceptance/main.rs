//! The figures that an acceptance asks for, each beside its bound.

mod paper;
mod table;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Parser;
use meshwright::{MinAngle, Parameters, Pslg, Steiner, Thinning};
use meshwright_campaigns::experiments::median;
use meshwright_campaigns::measure::smallest_angle;
use meshwright_campaigns::motion::Motion;
use meshwright_campaigns::{corpus, figures};
use table::{Bound, Table};

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
    /// Also the paper's own figures
    #[arg(long)]
    paper: bool,
}

fn main() -> std::io::Result<ExitCode> {
    let arguments = Arguments::parse();
    let mut table = Table::new();
    wedges(&mut table);
    spokes(&mut table, arguments.seed);
    precision(&mut table);
    if let Some(data) = &arguments.data {
        superior(&mut table, data)?;
        fewest_points(&mut table, data)?;
    } else {
        println!("(no MESHWRIGHT_DATA: Lake Superior is left out)");
    }
    if arguments.paper {
        paper::figures(&mut table, arguments.data.as_deref())?;
    }
    println!("{} rows, {} beyond their bound", table.rows, table.broken);
    Ok(if table.broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// One wedge in a box.
fn wedges(table: &mut Table) {
    for (degrees, most) in [(1.0, 100), (0.1, 130), (0.01, 220), (0.001, 300)] {
        let wedge = figures::wedge(f64::to_radians(degrees));
        let bound = Bound::at_most(most);
        table.mesh(&format!("wedge of {degrees}°"), &wedge, &Parameters::default(), bound);
    }
}

/// The paper's 20 spokes.
fn spokes(table: &mut Table, first_seed: u64) {
    let mut counts = Vec::new();
    for seed in first_seed..first_seed + 12 {
        let spokes = figures::spokes20(seed);
        let closest = smallest_angle(&spokes).unwrap_or_default().to_degrees();
        let name = format!("20 spokes, seed {seed}, closest pair {closest:.3}°");
        counts.push(table.mesh(&name, &spokes, &Parameters::default(), Bound::default()).0);
    }
    let bound = Bound::at_most(300);
    table.row("20 spokes, median of these twelve", median(counts), Duration::ZERO, bound, "", None);
}

/// Where doubles end.
fn precision(table: &mut Table) {
    let slow = |points| Bound { points, seconds: Some(5.0), ..Bound::default() };
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
    let bound = Bound::at_most(967);
    table.mesh("Lake Superior", &lake, &Parameters::default(), bound);
    table.row(
        "Lake Superior, median of 5 runs",
        0,
        times[2],
        Bound { seconds: Some(0.3), ..Bound::default() },
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
    Ok(())
}

/// The fewest points of any program: look-ahead, and thinning after it.
fn fewest_points(table: &mut Table, data: &Path) -> std::io::Result<()> {
    let rows = [
        ("superior", 26.45, 830, 745),
        ("superior_box", 26.45, 1_190, 1_030),
        ("superior_box", 30.0, 1_480, 1_230),
        ("superior_box", 33.0, 1_930, 1_480),
        ("superior_box", 34.0, 2_210, 1_630),
    ];
    for (name, degrees, ahead, thinned) in rows {
        let outline = read(data, &format!("paper/{name}.poly"))?;
        let soft = MinAngle::soft_from_degrees(degrees).expect("it is at most 34°");
        let soft_angle = (degrees > MinAngle::LARGEST_DEGREES).then_some(soft);
        let steiner = Steiner::LookAhead;
        let parameters = Parameters { steiner, soft_angle, ..Parameters::default() };
        let row = format!("{name} at {degrees}°, look-ahead");
        table.mesh(&row, &outline, &parameters, Bound::at_most(ahead));
        let parameters = Parameters { thinning: Thinning::Tries(20_000), ..parameters };
        let seconds = (name == "superior").then_some(3.0);
        let bound = Bound { seconds, ..Bound::at_most(thinned) };
        table.mesh(&format!("{row}, 20 000 tries"), &outline, &parameters, bound);
    }
    Ok(())
}

fn read(data: &Path, file: &str) -> std::io::Result<Pslg> {
    let read = corpus::read(&data.join(file)).map_err(std::io::Error::other);
    read.map(|(outline, _)| outline)
}
