//! `meshwright mesh`: from an outline to certified mesh files.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use meshwright::certify::Certificate;
use meshwright::domain;
use meshwright::formats::groups::Note;
use meshwright::formats::{Mesh, Pslg, edge, ele, gltf, msh, neigh, node, poly, vtu};
use meshwright::refine::End;
use meshwright::{Error, Outcome, Parameters, Rule, Warning, mesh_with};

use super::failure::{Exit, Failure};
use super::format::{Format, listed};
use super::input;
use super::json::{self, MeshReport};
use super::options::Scale;
use super::output::{Pending, STDOUT, Written, check_places};
use super::progress::ProgressLine;
use super::refining::RefineOptions;
use super::summary::Summary;
use super::triangle::{is_beside, tell_incomplete};
use super::voice::{Voice, print};
use super::wording::{count, grouped};

/// More notes of writers than this are counted, not shown, unless asked for.
const MOST_NOTES: usize = 6;

/// What `mesh` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The outline (`-`: stdin).
    input: PathBuf,
    /// A file to write, its format by its end: .msh, .vtu, .glb, or .node, .ele, .poly,
    /// .edge, .neigh as Triangle writes them; may be given several times (`-`: stdout).
    #[arg(short, long, value_name = "OUT")]
    output: Vec<PathBuf>,
    /// The format of the input, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    /// The format of outputs whose names do not tell.
    #[arg(long, value_name = "FORMAT")]
    to: Option<Format>,
    #[command(flatten)]
    refine: RefineOptions,
    #[command(flatten)]
    scale: Scale,
    /// Renumber groups so that no number serves a boundary and a region (.msh).
    #[arg(long)]
    unique_ids: bool,
    /// Let any warning end the command with exit code 4.
    #[arg(long)]
    strict: bool,
    /// Write the verdict and the parameters it was judged by to this JSON file, for
    /// `check --certificate`.
    #[arg(long, value_name = "FILE.json")]
    certificate: Option<PathBuf>,
    /// Print one JSON object about the run.
    #[arg(long)]
    json: bool,
}

/// Meshes.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    let formats = arguments.formats()?;
    let parameters = arguments.refine.parameters()?;
    let (mut pslg, input) = input::outline(&arguments.input, arguments.from, voice)?;
    let places: Vec<PathBuf> =
        arguments.output.iter().chain(&arguments.certificate).cloned().collect();
    check_places(&places, &input.files)?;
    arguments.scale.apply(&mut pslg);

    let line = ProgressLine::new(voice);
    let meshed = mesh_with(&pslg, &parameters, &mut |progress| line.show(progress));
    let took = line.finish();
    let outcome = meshed.map_err(failure)?;
    outcome.warnings.iter().for_each(|warning| voice.warn(warning));
    if outcome.certificate.limited() && !outcome.warnings.iter().any(is_about_precision) {
        voice.warn(limit(&outcome.certificate));
    }

    let summary = Summary::new(&pslg, &outcome, parameters.soft_angle);
    summary.say_mesh(&input.name, took, voice);
    let scale = arguments.scale.factor();
    let certificate = json::certificate_file(&input, &parameters, scale, &outcome.certificate);
    let (written, notes) = arguments.write(&outcome.mesh, &pslg, &formats, &certificate)?;
    say_notes(notes, voice);
    tell_incomplete(&arguments.outputs(&formats), voice);
    summary.say_written(&written, voice);

    let exit = verdict(&outcome, &pslg, &parameters, arguments.strict, voice);
    if arguments.json {
        print(&json::mesh_run(&MeshReport {
            input: &input,
            pslg: &pslg,
            outcome: &outcome,
            statistics: &summary.statistics,
            parameters: &parameters,
            written: &written,
            warnings: voice.warnings(),
            exit: exit.as_ref().map_or_else(|failure| failure.exit, |&exit| exit),
        }))?;
    }
    exit
}

impl Arguments {
    /// The format of each output, known before anything is read.
    fn formats(&self) -> Result<Vec<Format>, Failure> {
        let wants_stdout = |output: &PathBuf| output == Path::new(STDOUT);
        if self.json && self.output.iter().any(wants_stdout) {
            return Err(Failure::usage("--json and `-o -` both want stdout"));
        }
        if self.certificate.as_ref().is_some_and(wants_stdout) {
            return Err(Failure::usage("a certificate is written to a file; --json holds it too"));
        }
        self.output.iter().map(|output| self.format(output)).collect()
    }

    fn format(&self, output: &Path) -> Result<Format, Failure> {
        let known = listed(|_| true);
        match Format::of(output).or(self.to) {
            Some(_) if output.extension().is_some_and(|end| end.eq_ignore_ascii_case("gz")) => {
                Err(Failure::usage(format!(
                    "{}: compressed files are read, not written",
                    output.display()
                )))
            }
            Some(format) => Ok(format),
            None => Err(Failure::usage(format!(
                "{}: its name does not tell the format of a mesh",
                output.display()
            ))
            .with_help(format!("meshes are written to {known}; --to FORMAT says it too"))),
        }
    }

    fn outputs(&self, formats: &[Format]) -> Vec<(&PathBuf, Format)> {
        self.output.iter().zip(formats.iter().copied()).collect()
    }

    /// Writes every output, then puts all in their places: none is there if one fails.
    fn write(
        &self,
        mesh: &Mesh,
        pslg: &Pslg,
        formats: &[Format],
        certificate: &[u8],
    ) -> Result<(Outputs, Notes), Failure> {
        let outputs = self.outputs(formats);
        let mut notes = Notes::default();
        let mut pending = Vec::new();
        for &(output, format) in &outputs {
            let content = FileContent {
                mesh,
                format,
                msh: msh::Options { unique_ids: self.unique_ids },
                poly: poly::Options {
                    outline: Some(pslg),
                    points_beside: is_beside(output, Format::Node, &outputs),
                },
            };
            let (file, said) = Pending::write(output, |out| content.write(out))?;
            pending.push(file);
            notes.add(output, said);
        }
        let write_certificate =
            |place: &PathBuf| Pending::write(place, |out| out.write_all(certificate));
        let certificate = self.certificate.as_ref().map(write_certificate).transpose()?;
        let finish = |(file, &format): (Pending, _)| file.finish().map(|file| (file, format));
        let written = pending.into_iter().zip(formats).map(finish).collect::<Result<_, _>>()?;
        if let Some((file, ())) = certificate {
            file.finish()?;
        }
        Ok((written, notes))
    }
}

/// What one output holds.
struct FileContent<'a> {
    mesh: &'a Mesh,
    format: Format,
    msh: msh::Options,
    poly: poly::Options<'a>,
}

impl FileContent<'_> {
    fn write(&self, mut out: &mut dyn Write) -> io::Result<Vec<Note>> {
        let Self { mesh, .. } = *self;
        match self.format {
            Format::Msh => msh::write_with(mesh, self.msh, &mut out),
            Format::Vtu => vtu::write(mesh, &mut out),
            Format::Glb => gltf::write(mesh, &mut out),
            Format::Node => node::write(mesh, &mut out),
            Format::Ele => ele::write(mesh, &mut out),
            Format::Poly => poly::write_with(mesh, self.poly, &mut out),
            Format::Edge => edge::write(mesh, &mut out),
            Format::Neigh => neigh::write(mesh, &mut out),
        }
    }
}

/// Written files and their formats.
type Outputs = Vec<(Written, Format)>;

/// What writers said, each with the files it is about.
#[derive(Default)]
struct Notes {
    texts: Vec<(String, bool)>,
    files: BTreeMap<String, Vec<String>>,
}

impl Notes {
    fn add(&mut self, output: &Path, notes: Vec<Note>) {
        for note in notes {
            let text = match &note {
                Note::SharedNumbers { .. } => format!("{note} (--unique-ids renumbers)"),
                note => note.to_string(),
            };
            let files = self.files.entry(text.clone()).or_default();
            if files.is_empty() {
                self.texts.push((text, note.is_warning()));
            }
            files.push(output.display().to_string());
        }
    }
}

/// Warnings one by one; what only tells, in one line for the files that it is about.
fn say_notes(notes: Notes, voice: &Voice) {
    let mut told: Vec<(String, Vec<String>)> = Vec::new();
    for (text, is_warning) in notes.texts {
        let files = notes.files[&text].join(", ");
        if is_warning {
            voice.warn(format!("{files}: {text}"));
            continue;
        }
        match told.last_mut().filter(|(same, _)| *same == files) {
            Some((_, texts)) => texts.push(text),
            None => told.push((files, vec![text])),
        }
    }
    for (files, mut texts) in told {
        if texts.len() > MOST_NOTES && !voice.verbose {
            let more = texts.len() - MOST_NOTES;
            texts.truncate(MOST_NOTES);
            texts.push(format!("and {} more (--verbose tells all)", grouped(more as u64)));
        }
        voice.note(format!("{files}: {}", texts.join("; ")));
    }
}

/// Where doubles end: `the mesh is limited by precision near points 5, 17 and 3 more`.
fn limit(certificate: &Certificate) -> String {
    let mut points: Vec<i64> = certificate.apexes.iter().map(|apex| apex.point.number).collect();
    points.extend(certificate.narrows.iter().map(|narrow| narrow.point.number));
    format!("the mesh is limited by precision {}", near(points))
}

/// `near points 5, 17 and 3 more`, by the numbers of the file.
fn near_points(indices: &[u32], pslg: &Pslg) -> String {
    near(indices.iter().map(|&index| pslg.source.point_number(index)).collect())
}

fn near(mut points: Vec<i64>) -> String {
    const NAMED: usize = 3;
    points.sort_unstable();
    points.dedup();
    let named: Vec<String> = points.iter().take(NAMED).map(ToString::to_string).collect();
    let noun = if points.len() == 1 { "point" } else { "points" };
    let more = match points.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {} more", grouped(more as u64)),
    };
    format!("near {noun} {}{more}", named.join(", "))
}

fn is_about_precision(warning: &Warning) -> bool {
    matches!(warning, Warning::Domain(domain::Warning::LimitedByPrecision { .. }))
}

/// Why there is no mesh.
pub fn failure(error: Error) -> Failure {
    match error {
        Error::Cancelled => Failure { exit: Exit::Interrupted, message: error.to_string() },
        error => Failure::input(error),
    }
}

/// How a run ends that made and wrote a mesh.
fn verdict(
    outcome: &Outcome,
    pslg: &Pslg,
    parameters: &Parameters,
    strict: bool,
    voice: &Voice,
) -> Result<Exit, Failure> {
    if outcome.end == End::PointBudget {
        let budget = count(parameters.max_points, "point");
        return Err(Failure::promise(format!(
            "the run stopped at {budget} (--max-points): the mesh is complete, its angles are not"
        )));
    }
    if parameters.rule == Rule::Ruppert && outcome.refused > 0 {
        return Err(Failure::promise(format!(
            "Ruppert's rule does not end {}: it stopped where doubles end",
            near_points(&outcome.refused_at, pslg)
        ))
        .with_help("--rule adaptive ends on every outline; so does a smaller --min-angle"));
    }
    if !outcome.certificate.holds() {
        return Err(Failure::promise("the mesh does not keep what was promised"));
    }
    match voice.warnings().len() {
        0 => Ok(Exit::Done),
        n if strict => {
            Err(Failure::promise(format!("{}, and --strict allows none", count(n, "warning"))))
        }
        _ => Ok(Exit::Done),
    }
}
