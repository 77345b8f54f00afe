//! Runs the command over the large collection and prints file × expected × got × points × time.

use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use clap::Parser;
use meshwright::formats::msh;
use meshwright_campaigns::corpus::{self, Case, Ending};
use meshwright_campaigns::run::in_order;

/// Runs `meshwright mesh` over the large collection of outlines, without and with --repair.
///
/// Good outlines must mesh with the area of answers.tsv, and `meshwright check` must find nothing;
/// bad ones must end as bad/expected.json says, with the right line named. Nothing may panic, take
/// longer than the limit, or leave a file behind after an error.
///
/// Exit code 0: everything as expected, or known to differ (which is said). 1: something was not.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// The collection's folder
    #[arg(long, env = "MESHWRIGHT_DATA")]
    data: PathBuf,
    /// The command; by default the `meshwright` beside this program
    #[arg(long)]
    command: Option<PathBuf>,
    /// Only files whose path holds this text
    #[arg(long)]
    only: Option<String>,
    /// No run may take longer, in seconds
    #[arg(long, default_value_t = 10.0)]
    limit: f64,
    /// How many runs at once
    #[arg(long, default_value_t = 2)]
    threads: usize,
    /// A folder for what is written on the way; by default the system's
    #[arg(long)]
    scratch: Option<PathBuf>,
}

fn main() -> io::Result<ExitCode> {
    let arguments = Arguments::parse();
    let command = match &arguments.command {
        Some(command) => command.clone(),
        None => std::env::current_exe()?
            .with_file_name(format!("meshwright{}", std::env::consts::EXE_SUFFIX)),
    };
    let own_scratch = std::env::temp_dir().join(format!("meshwright-data-{}", std::process::id()));
    let scratch = arguments.scratch.clone().unwrap_or_else(|| own_scratch.clone());
    fs::create_dir_all(&scratch)?;
    let only = arguments.only.as_deref().unwrap_or_default();
    let mut cases = corpus::cases(&arguments.data)?;
    cases.retain(|case| case.file.contains(only));

    let runner = Runner {
        command,
        data: arguments.data.clone(),
        scratch,
        limit: Duration::from_secs_f64(arguments.limit),
    };
    let (mut wrong, mut broken, mut triangles) = (0, Ok(()), Tally::default());
    println!("{:<56} {:<18} {:<18} {:>8} {:>8}", "file", "expected", "got", "points", "seconds");
    in_order(
        cases.len(),
        arguments.threads,
        |i| runner.run(i, &cases[i]),
        |i, row| match row {
            Ok(row) => {
                row.print(&cases[i]);
                triangles.add(&row, &cases[i]);
                wrong += usize::from(!row.complaints.is_empty());
            }
            Err(error) => broken = Err(error),
        },
    );
    broken?;
    let _ = fs::remove_dir_all(own_scratch);
    let differ = cases.iter().filter(|case| case.differs.is_some()).count();
    println!(
        "{} runs: {differ} are known not to be as the collection says, {} of the others are as it \
         says; {wrong} are neither",
        cases.len(),
        cases.len() - differ - wrong
    );
    println!("{triangles}");
    let good = wrong == 0 && triangles.is_good();
    Ok(if good { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// How many meshes have about as many triangles as Gmsh's.
#[derive(Default)]
struct Tally {
    near: usize,
    meshed: usize,
    refused: usize,
}

impl Tally {
    /// A count within 30 % is near.
    const NEAR: std::ops::RangeInclusive<f64> = 0.7..=1.3;

    fn add(&mut self, row: &Row, case: &Case) {
        match case.triangles_of_gmsh.map(|gmsh| row.ratio(gmsh)) {
            Some(Some(ratio)) => {
                self.meshed += 1;
                self.near += usize::from(Self::NEAR.contains(&ratio));
            }
            Some(None) => self.refused += 1,
            None => {}
        }
    }

    /// Nine of ten scripts, refused ones counted, have a mesh that is near.
    fn is_good(&self) -> bool {
        10 * self.near >= 9 * (self.meshed + self.refused)
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { near, meshed, refused } = self;
        write!(
            f,
            "{near} of the {meshed} meshes of scripts with sizes at points have as many triangles as \
             Gmsh's, within 30 %; {refused} of these scripts are refused"
        )
    }
}

/// A line of the table.
struct Row {
    got: String,
    points: Option<usize>,
    triangles: Option<usize>,
    time: Duration,
    complaints: Vec<String>,
}

impl Row {
    /// Our triangles by Gmsh's.
    fn ratio(&self, of_gmsh: usize) -> Option<f64> {
        self.triangles.map(|ours| ours as f64 / of_gmsh as f64)
    }

    fn print(&self, case: &Case) {
        let expected: Vec<_> = case.allowed.iter().map(|ending| word(*ending)).collect();
        let points = self.points.map_or_else(|| "-".to_owned(), |points| points.to_string());
        println!(
            "{:<56} {:<18} {:<18} {points:>8} {:>8.3}",
            case.name(),
            expected.join(" or "),
            self.got,
            self.time.as_secs_f64()
        );
        if let Some(why) = case.differs {
            println!("    not as the collection says: {why}");
        }
        let far = |&ratio: &f64| !Tally::NEAR.contains(&ratio);
        if let Some(gmsh) = case.triangles_of_gmsh
            && let Some(ratio) = self.ratio(gmsh).filter(far)
        {
            println!("    {ratio:.2} times as many triangles as the {gmsh} that Gmsh makes");
        }
        for complaint in &self.complaints {
            println!("    WRONG: {}", complaint.trim_end().replace('\n', "\n    "));
        }
    }
}

fn word(ending: Ending) -> &'static str {
    match ending {
        Ending::Meshes => "mesh",
        Ending::MeshesWithWarning => "mesh + warning",
        Ending::Refused => "error",
        Ending::Missing => "missing file",
    }
}

/// What a run of the command did.
struct Done {
    code: Option<i32>,
    talk: String,
    time: Duration,
}

struct Runner {
    command: PathBuf,
    data: PathBuf,
    scratch: PathBuf,
    limit: Duration,
}

impl Runner {
    /// Meshes one file, checks the mesh, compares with what is known.
    fn run(&self, number: usize, case: &Case) -> io::Result<Row> {
        let input = self.data.join(&case.file);
        let output = self.scratch.join(format!("{number}.msh"));
        let options = case.options();
        let options: Vec<&Path> = options.iter().map(Path::new).collect();
        let mesh = [Path::new("mesh"), &input, Path::new("-o"), &output];
        let done = self.call(&[&mesh[..], &options].concat())?;
        let mut complaints = Vec::new();
        let (mut points, mut triangles, mut area) = (None, None, None);
        let ending = match done.code {
            Some(0) => Some(if names_a_warning(&done.talk) {
                Ending::MeshesWithWarning
            } else {
                Ending::Meshes
            }),
            Some(1) => Some(Ending::Refused),
            Some(3) => Some(Ending::Missing),
            _ => None,
        };
        if done.code == Some(0) {
            match msh::read(&fs::read(&output)?, "output") {
                Ok((mesh, _)) => {
                    points = Some(mesh.points.len());
                    triangles = Some(mesh.triangles.len());
                    area = Some(meshwright_campaigns::measure::area(&mesh));
                    complaints.extend(case.complaints_of_names(&mesh));
                }
                Err(error) => complaints.push(format!("the output cannot be read: {error}")),
            }
            let check = [Path::new("check"), &output, Path::new("--input"), &input];
            let check = self.call(&[&check[..], &options].concat())?;
            if check.code != Some(0) {
                complaints.push(format!("check exits {:?}\n{}", check.code, check.talk));
            }
        } else if output.exists() {
            complaints.push("a file was left behind".to_owned());
        }
        let _ = fs::remove_file(&output);
        match ending {
            Some(ending) => complaints.extend(case.complaints(ending, area, &done.talk)),
            None => complaints.push(format!("exit code {:?}", done.code)),
        }
        if done.talk.contains("panicked at") {
            complaints.push("it panicked".to_owned());
        }
        if done.time > self.limit {
            complaints.push(format!("{:.1} s", done.time.as_secs_f64()));
        }
        if !complaints.is_empty() {
            complaints.push(format!("it said:\n{}", done.talk));
        }
        let got = ending.map_or_else(|| format!("exit {:?}", done.code), |e| word(e).to_owned());
        Ok(Row { got, points, triangles, time: done.time, complaints })
    }

    /// Runs the command; it is ended after three times the limit.
    fn call(&self, arguments: &[&Path]) -> io::Result<Done> {
        let start = Instant::now();
        let mut child = Command::new(&self.command)
            .args(arguments)
            .env("NO_COLOR", "1")
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()?;
        let stdout = reader(child.stdout.take());
        let stderr = reader(child.stderr.take());
        let code = self.wait(&mut child, start)?;
        let time = start.elapsed();
        let heard = [stdout, stderr].map(|handle| handle.join().unwrap_or_default());
        Ok(Done { code, talk: heard.concat(), time })
    }

    fn wait(&self, child: &mut Child, start: Instant) -> io::Result<Option<i32>> {
        loop {
            if let Some(status) = child.try_wait()? {
                return Ok(status.code());
            }
            if start.elapsed() > 3 * self.limit {
                child.kill()?;
                child.wait()?;
                return Ok(None);
            }
            thread::sleep(Duration::from_millis(1));
        }
    }
}

/// Reads a pipe to its end on a thread of its own, so that it never fills.
fn reader(pipe: Option<impl Read + Send + 'static>) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // What could be read before an error is what there is to judge.
            let _ = pipe.read_to_end(&mut bytes);
        }
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

fn names_a_warning(talk: &str) -> bool {
    talk.contains("warning")
}
