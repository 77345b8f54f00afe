//! Makes large files, reads them, and prints how fast and in how much memory.

use std::f64::consts::TAU;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use clap::Parser;
use meshwright_campaigns::{Random, corpus};

/// Makes one large outline in each format, a noisy star of as many points as fill the file, and
/// reads it in a process of its own.
///
/// Read fast enough is 100 MB in a second of processor time for .poly and .obj, 20 MB for .geo; small
/// enough is three times the file at the peak. Where the system tells no process
/// times and peaks (it does on Linux), the time is what passed, and memory is not judged.
///
/// Then the last hundredth of each file is cut off: it must end in an error that names its last
/// line.
///
/// Exit code 0: all did. 1: one did not.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// The size of each file in megabytes (millions of bytes)
    #[arg(long, default_value_t = 200.0)]
    megabytes: f64,
    /// Only this format: poly, obj, geo
    #[arg(long)]
    only: Option<String>,
    /// A folder for the files; by default the system's
    #[arg(long)]
    scratch: Option<PathBuf>,
    /// Read this file and print what that took: what each run calls
    #[arg(long, hide = true)]
    read: Option<PathBuf>,
}

/// A format, its bytes for each point, and what is fast and small enough.
struct Wanted {
    format: &'static str,
    bytes_per_point: f64,
    megabytes_per_second: f64,
    memory: f64,
}

const WANTED: [Wanted; 3] = [
    Wanted { format: "poly", bytes_per_point: 68.0, megabytes_per_second: 100.0, memory: 3.0 },
    Wanted { format: "obj", bytes_per_point: 44.0, megabytes_per_second: 100.0, memory: 3.0 },
    Wanted { format: "geo", bytes_per_point: 95.0, megabytes_per_second: 20.0, memory: 3.0 },
];

fn main() -> io::Result<ExitCode> {
    let arguments = Arguments::parse();
    if let Some(file) = &arguments.read {
        return Ok(read(file));
    }
    let own = std::env::temp_dir().join(format!("meshwright-reading-{}", std::process::id()));
    let scratch = arguments.scratch.clone().unwrap_or_else(|| own.clone());
    fs::create_dir_all(&scratch)?;
    let mut failed = false;
    println!(
        "{:<8} {:>8} {:>8} {:>8} {:>16}",
        "format", "MB", "seconds", "MB/s", "peak by the file"
    );
    for wanted in &WANTED {
        if arguments.only.as_deref().is_some_and(|only| only != wanted.format) {
            continue;
        }
        let file = scratch.join(format!("star.{}", wanted.format));
        let points = (1e6 * arguments.megabytes / wanted.bytes_per_point).max(100.0) as usize;
        write_star(&file, wanted.format, points)?;
        for fault in faults(wanted, &file)? {
            println!("    WRONG: {fault}");
            failed = true;
        }
        fs::remove_file(&file)?;
    }
    let _ = fs::remove_dir_all(own);
    Ok(if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Reads a file, whole and cut off, prints a line, and tells what is wrong.
fn faults(wanted: &Wanted, file: &Path) -> io::Result<Vec<String>> {
    let mut faults = Vec::new();
    let size = fs::metadata(file)?.len();
    let megabytes = size as f64 / 1e6;
    let took = call(file)?;
    let Some((seconds, peak)) = figures(&took) else {
        return Ok(vec![took]);
    };
    let speed = megabytes / seconds;
    let memory = peak.map(|peak| peak / megabytes);
    let told = memory.map_or_else(|| "-".to_owned(), |memory| format!("{memory:.2}"));
    println!("{:<8} {megabytes:>8.1} {seconds:>8.2} {speed:>8.1} {told:>16}", wanted.format);
    if speed < wanted.megabytes_per_second {
        faults.push(format!("{speed:.1} MB/s"));
    }
    if let Some(memory) = memory
        && memory > wanted.memory
    {
        faults.push(format!("{memory:.2} times the file"));
    }
    File::options().write(true).open(file)?.set_len(size - size / 100)?;
    let last = fs::read(file)?.split(|&byte| byte == b'\n').filter(|line| !line.is_empty()).count();
    let said = call(file)?;
    // A line that was cut at its end may still be good: then what is missing is named behind it.
    let names = |line: usize| said.contains(&format!(".{}:{line}:", wanted.format));
    let is_told = wanted.format == "obj" && said.contains("segments");
    if !names(last) && !names(last + 1) && !is_told {
        faults.push(format!("cut off in line {last} it says: {said}"));
    }
    Ok(faults)
}

/// Reads a file in another process.
fn call(file: &Path) -> io::Result<String> {
    let done = Command::new(std::env::current_exe()?).arg("--read").arg(file).output()?;
    Ok(String::from_utf8_lossy(&done.stdout).into_owned())
}

/// The seconds, and the megabytes at the peak where they are known.
fn figures(took: &str) -> Option<(f64, Option<f64>)> {
    let (seconds, rest) = took.strip_prefix("read in ")?.split_once(" s, ")?;
    let peak = rest.split(' ').next()?.parse().ok();
    Some((seconds.parse().ok()?, peak))
}

/// Reads a file in this process, and prints what that took or what is wrong with the file.
fn read(file: &Path) -> ExitCode {
    let start = Instant::now();
    match corpus::read(file) {
        Ok((outline, _)) => {
            let seconds = processor_seconds().unwrap_or_else(|| start.elapsed().as_secs_f64());
            let peak = peak_megabytes().map_or_else(|| "-".to_owned(), |peak| format!("{peak:.1}"));
            println!("read in {seconds:.3} s, {peak} MB; {} segments", outline.segments.len());
            ExitCode::SUCCESS
        }
        Err(error) => {
            println!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The processor time of this process, in hundredths of seconds as Linux tells it.
fn processor_seconds() -> Option<f64> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    // Behind the name in brackets come the state and 10 other fields.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut times = fields.split_whitespace().skip(11).map(str::parse::<f64>);
    let (user, system) = (times.next()?.ok()?, times.next()?.ok()?);
    Some(((user + system) / 100.0).max(0.01))
}

/// The largest resident size of this process.
fn peak_megabytes() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kibibytes * 1024.0 / 1e6)
}

/// A star of so many points with a little noise.
fn star(points: usize) -> impl Iterator<Item = [f64; 2]> {
    let mut random = Random::new(7);
    (0..points).map(move |i| {
        let (sin, cos) = libm::sincos(TAU * i as f64 / points as f64);
        let along = TAU * i as f64 / points as f64;
        let radius = 1.0 + 0.2 * libm::sin(9.0 * along) + 0.2 / points as f64 * random.unit();
        [radius * cos, radius * sin]
    })
}

fn write_star(file: &Path, format: &str, points: usize) -> io::Result<()> {
    let mut out = BufWriter::new(File::create(file)?);
    let next = |i: usize| i % points + 1;
    match format {
        "poly" => {
            writeln!(out, "{points} 2 0 0")?;
            for (i, [x, y]) in (1..).zip(star(points)) {
                writeln!(out, "{i} {x:.15} {y:.15}")?;
            }
            writeln!(out, "{points} 0")?;
            for i in 1..=points {
                writeln!(out, "{i} {i} {}", next(i))?;
            }
            writeln!(out, "0")?;
        }
        "obj" => {
            for [x, y] in star(points) {
                writeln!(out, "v {x:.12} {y:.12} 0")?;
            }
            for first in (1..=points).step_by(100) {
                write!(out, "l {first}")?;
                for i in first..points.min(first + 99) + 1 {
                    write!(out, " {}", next(i))?;
                }
                writeln!(out)?;
            }
        }
        _ => {
            writeln!(out, "lc = 0.1;")?;
            for (i, [x, y]) in (1..).zip(star(points)) {
                writeln!(out, "Point({i}) = {{{x:.12}, {y:.12}, 0, lc}};")?;
            }
            for i in 1..=points {
                writeln!(out, "Line({i}) = {{{i}, {}}};", next(i))?;
            }
            writeln!(out, "Curve Loop(1) = {{1:{points}}};\nPlane Surface(1) = {{1}};")?;
            writeln!(out, "Physical Curve(\"rim\", 1) = {{1:{points}}};")?;
            writeln!(out, "Physical Surface(\"disk\", 2) = {{1}};")?;
        }
    }
    out.flush()
}
