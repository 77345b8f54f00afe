//! Runs meshwright and other programs on the same outlines, in turn, and prints what each took.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Parser;
use meshwright_campaigns::benchmark::cases::Case;
use meshwright_campaigns::benchmark::programs::{Program, Programs, geo};
use meshwright_campaigns::benchmark::table::Made;
use meshwright_campaigns::benchmark::{process, table};
use meshwright_campaigns::poly;

/// The release of the Python package whose source distribution holds Triangle 1.6 in C.
const TRIANGLE: &str = "triangle==20200424";

/// Runs meshwright, Triangle, spade and Gmsh on the same outlines, one after the other, round by
/// round, and prints a table: processor time, time, memory, points, and the median over the rounds
/// of the ratio of the processor times to Triangle's.
///
/// Builds meshwright and spade's refinement and, from its source, Triangle (a C compiler and Python's
/// pip are wanted), each for the machine that it runs on. Each mesh of meshwright is judged once.
///
/// Exit code 0: all programs ran. 1: one did not, or a mesh was not certified.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// Only the cases whose name holds this
    #[arg(long)]
    only: Option<String>,
    /// The cases of 5 and 10 million triangles too
    #[arg(long)]
    large: bool,
    /// How often each program runs on each case
    #[arg(long, default_value_t = 3)]
    rounds: usize,
    /// The folder for outlines and what programs print
    #[arg(long, default_value = "target/benchmark")]
    folder: PathBuf,
    /// The large collection of outlines, for the coasts of the world
    #[arg(long, env = "MESHWRIGHT_DATA")]
    data: Option<PathBuf>,
    /// Triangle's executable, where it is not to be built
    #[arg(long)]
    triangle: Option<PathBuf>,
    /// Gmsh's command
    #[arg(long, default_value = ".venv/bin/gmsh")]
    gmsh: PathBuf,
    /// Makes the outline of this case, and nothing else
    #[arg(long, hide = true)]
    make: Option<String>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(&arguments.folder)?;
    if let Some(name) = &arguments.make {
        let mut all = Case::all().into_iter();
        return make_outline(&all.find(|case| case.name == name).ok_or("no such case")?, arguments);
    }
    let programs = programs(arguments)?;
    println!("{}\n", machine());
    print!("{}", table::head());
    for case in Case::all() {
        let is_named = arguments.only.as_ref().is_none_or(|name| case.name.contains(name.as_str()));
        if !is_named || (case.is_large && !arguments.large) {
            continue;
        }
        make_outline_elsewhere(&case, arguments)?;
        if !file_of(&case, arguments).exists() {
            eprintln!("{}: left out, the collection is not there (MESHWRIGHT_DATA)", case.name);
            continue;
        }
        print!("{}", table::rows(case.name, &compare(&programs, &case, arguments)?));
    }
    Ok(())
}

/// What each program makes of a case, round by round.
fn compare(
    programs: &Programs,
    case: &Case,
    arguments: &Arguments,
) -> Result<Vec<Made>, Box<dyn Error>> {
    let mut runs = Program::ALL.map(|program| (program, Vec::new()));
    for _ in 0..arguments.rounds {
        for (program, runs) in &mut runs {
            runs.extend(programs.run(*program, case, &arguments.folder)?);
        }
    }
    let mut made = Vec::new();
    for (program, runs) in runs {
        if let Some(last) = runs.last() {
            let counts = programs.counts(program, case, &arguments.folder, last)?;
            made.push(Made { program, counts, runs });
        }
    }
    Ok(made)
}

fn file_of(case: &Case, arguments: &Arguments) -> PathBuf {
    arguments.folder.join(case.name).with_extension("poly")
}

/// Makes a case's outline in a process of its own: what this one takes at its peak would count as
/// taken by the programs that it starts.
fn make_outline_elsewhere(case: &Case, arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let file = file_of(case, arguments);
    if file.exists() {
        fs::remove_file(file)?;
    }
    let mut made = Command::new(std::env::current_exe()?);
    made.args(["--make", case.name, "--folder"]).arg(&arguments.folder);
    if let Some(data) = &arguments.data {
        made.arg("--data").arg(data);
    }
    process::run(&mut made, &arguments.folder)?;
    Ok(())
}

/// Writes a case's outline, if it can be made.
fn make_outline(case: &Case, arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let world = arguments.data.as_ref().map(|data| data.join("gis/world50.poly.gz"));
    let file = file_of(case, arguments);
    if let Some(outline) = case.outline(world.as_deref())? {
        fs::write(&file, poly::text(&outline, case.name))?;
    }
    if let Some(script) = geo(case) {
        fs::write(file.with_extension("geo"), script)?;
    }
    Ok(())
}

/// Builds what is built from source, and finds the rest.
fn programs(arguments: &Arguments) -> Result<Programs, Box<dyn Error>> {
    let cargo = || {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["build", "--quiet", "--profile", "fastest"]);
        // As Triangle is built, for this machine.
        cargo.env("RUSTFLAGS", "-C target-cpu=native");
        cargo
    };
    eprintln!("building the programs for this machine: some minutes, but for those that are there");
    process::run(cargo().args(["--package", "meshwright"]), &arguments.folder)?;
    let spade = ["--package", "meshwright-campaigns", "--example", "spade_refine"];
    process::run(cargo().args(spade), &arguments.folder)?;
    let built = std::env::current_exe()?;
    let target = built.parent().and_then(Path::parent).ok_or("this program is in no folder")?;
    let fastest = target.join("fastest");
    let triangle = match &arguments.triangle {
        Some(given) => given.clone(),
        None => build_triangle(&arguments.folder)?,
    };
    Ok(Programs {
        meshwright: fastest.join("meshwright"),
        triangle: Some(triangle),
        spade: Some(fastest.join("examples/spade_refine")),
        gmsh: Some(arguments.gmsh.clone()).filter(|gmsh| gmsh.exists()),
    })
}

/// Fetches the Python package's source distribution and compiles the program within it.
fn build_triangle(folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let program = folder.join("triangle");
    if program.exists() {
        return Ok(program);
    }
    let mut fetch = Command::new("python3");
    fetch.args(["-m", "pip", "download", "--quiet", "--no-deps", "--no-binary", ":all:", TRIANGLE]);
    process::run(fetch.arg("--dest").arg(folder), folder)?;
    let archive = format!("{}.tar.gz", TRIANGLE.replace("==", "-"));
    let mut unpack = Command::new("tar");
    process::run(unpack.arg("-xzf").arg(folder.join(&archive)).arg("-C").arg(folder), folder)?;
    let source = folder.join(archive.trim_end_matches(".tar.gz")).join("c/triangle.c");
    // Contraction to fused operations would break its exact predicates. The package takes two
    // definitions out of the source, which it gives on the command line.
    let mut compile = Command::new("cc");
    compile.args(["-O3", "-march=native", "-ffp-contract=off", "-w"]);
    compile.args(["-DREAL=double", "-DVOID=int", "-DANSI_DECLARATORS", "-o"]);
    process::run(compile.arg(&program).arg(source).arg("-lm"), folder)?;
    Ok(program)
}

/// The processor and the day's compilers.
fn machine() -> String {
    let information = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = information.lines().find_map(|line| line.strip_prefix("model name"));
    let model = model.map_or("unknown processor", |rest| rest.trim_start_matches([' ', '\t', ':']));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{model}, {cores} cores, {} {}", std::env::consts::OS, std::env::consts::ARCH)
}
