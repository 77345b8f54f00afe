//! `meshwright mesh`: from an outline to certified mesh files.

use std::path::{Path, PathBuf};

use clap::Args;
use meshwright::certify::Certificate;
use meshwright::domain;
use meshwright::formats::{Pslg, poly};
use meshwright::refine::End;
use meshwright::{Error, Outcome, Parameters, Rule, Warning, mesh_with};

use super::convert;
use super::failure::{Exit, Failure};
use super::format::{Format, listed};
use super::input;
use super::json::{self, MadeFrom, MeshReport};
use super::memory::MemoryOption;
use super::notes::Notes;
use super::options::{ReadOptions, Scale};
use super::output::{Pending, STDOUT, Written, check_places};
use super::progress::ProgressLine;
use super::refining::RefineOptions;
use super::repair::RepairOptions;
use super::summary::Summary;
use super::triangle::{is_beside, tell_incomplete};
use super::voice::{Voice, print};
use super::wording::{count, grouped};
use super::writing::WriteOptions;

/// What `mesh` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The outline (`-`: stdin).
    input: PathBuf,
    /// A file to write, its format by its end: .msh, .vtu, .vtp, .vtk, .glb, .gltf, .mesh, .su2,
    /// .inp, .xdmf, .stl, .obj, or .node, .ele, .poly, .edge, .neigh as Triangle writes them; may be
    /// given several times (`-`: stdout).
    #[arg(short, long, value_name = "OUT")]
    output: Vec<PathBuf>,
    /// The format of the input, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    /// The format of outputs whose names do not tell.
    #[arg(long, value_name = "FORMAT")]
    to: Option<Format>,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    refine: RefineOptions,
    #[command(flatten)]
    memory: MemoryOption,
    #[command(flatten)]
    scale: Scale,
    #[command(flatten)]
    repair: RepairOptions,
    /// Write the mended outline to this .poly or .obj file.
    #[arg(long, value_name = "FILE", requires = "repair")]
    write_repaired: Option<PathBuf>,
    /// Let any warning end the command with exit code 4.
    #[arg(long)]
    strict: bool,
    /// Leave the mesh as it is, unjudged: `meshwright check` can judge it later. Judging takes about
    /// as long as meshing.
    #[arg(long, conflicts_with = "certificate")]
    unjudged: bool,
    /// Write the verdict and the parameters it was judged by to this JSON file, for
    /// `check --certificate`.
    #[arg(long, value_name = "FILE.json")]
    certificate: Option<PathBuf>,
    /// Tell what the run did: triangles queued and replaced, questions asked exactly.
    #[arg(long)]
    stats: bool,
    /// Print one JSON object about the run.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    write: WriteOptions,
}

/// Meshes.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    let formats = arguments.formats(voice)?;
    let parameters = Parameters {
        judged: !arguments.unjudged,
        measured: arguments.json || !voice.quiet,
        ..arguments.refine.parameters()?
    };
    let (mut pslg, input) =
        input::outline(&arguments.input, arguments.from, arguments.read, voice)?;
    check_places(&arguments.places(), &input.files)?;
    arguments.scale.apply(&mut pslg);
    let mended = arguments.repair.mend(pslg, voice)?;
    let pslg = mended.outline();
    mended.say(voice);
    // What is told is what was asked for, not what this machine has free.
    let room = arguments.memory.room();
    let room = room.filter(|room| room.points < parameters.max_points);
    room.map_or(Ok(()), |room| room.expect(pslg.points.len()))?;
    let within_room = Parameters {
        max_points: room.map_or(parameters.max_points, |room| room.points),
        ..parameters
    };

    let line = ProgressLine::new(voice);
    let meshed = mesh_with(pslg, &within_room, &mut |progress| line.show(progress));
    let took = line.finish();
    let outcome = meshed.map_err(failure)?;
    outcome.warnings.iter().for_each(|warning| voice.warn(warning));
    if outcome.certificate.limited() && !outcome.warnings.iter().any(is_about_precision) {
        voice.warn(limit(&outcome.certificate));
    }

    let summary = Summary::new(pslg, &outcome, parameters.soft_angle);
    summary.say_mesh(&input.name, took, voice);
    if arguments.stats {
        summary.say_work(voice);
    }
    let made_from = MadeFrom {
        read: arguments.read,
        scale: arguments.scale,
        tolerance: mended.tolerance(),
        parameters: &parameters,
    };
    let certificate = json::certificate_file(&input, &made_from, &outcome.certificate);
    let (written, notes) = arguments.write(&outcome, pslg, &formats, &certificate, voice)?;
    notes.say(voice);
    tell_incomplete(&arguments.outputs(&formats), voice);
    summary.say_written(&written, &arguments.write, voice);

    let exit = match room.filter(|_| outcome.end == End::PointBudget) {
        Some(room) => Err(room.failure_of_run()),
        None => verdict(&outcome, pslg, &parameters, arguments.strict, voice),
    };
    if arguments.json {
        print(&json::mesh_run(&MeshReport {
            input: &input,
            pslg,
            mended: &mended,
            outcome: &outcome,
            statistics: summary.statistics(),
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
    fn formats(&self, voice: &Voice) -> Result<Vec<Format>, Failure> {
        let wants_stdout = |output: &PathBuf| output == Path::new(STDOUT);
        if self.json && self.output.iter().any(wants_stdout) {
            return Err(Failure::usage("--json and `-o -` both want stdout"));
        }
        if self.certificate.as_ref().is_some_and(wants_stdout) {
            return Err(Failure::usage("a certificate is written to a file; --json holds it too"));
        }
        self.format_of_repaired()?;
        let formats: Vec<Format> =
            self.output.iter().map(|output| self.format(output)).collect::<Result<_, _>>()?;
        self.write.check(&formats, voice)?;
        Ok(formats)
    }

    /// Where the mended outline is written, and in which format.
    fn format_of_repaired(&self) -> Result<Option<(&PathBuf, Format)>, Failure> {
        let Some(place) = &self.write_repaired else { return Ok(None) };
        match Format::of(place) {
            Some(format) if format.outlines_are_written() => Ok(Some((place, format))),
            _ => Err(Failure::usage(format!(
                "{}: outlines are written to {}",
                place.display(),
                listed(Format::outlines_are_written)
            ))),
        }
    }

    /// Every file that is to be written.
    fn places(&self) -> Vec<PathBuf> {
        let others = self.certificate.iter().chain(&self.write_repaired);
        self.output.iter().chain(others).cloned().collect()
    }

    fn format(&self, output: &Path) -> Result<Format, Failure> {
        let known = listed(Format::meshes_are_written);
        match Format::of(output).or(self.to).or(self.write.format()) {
            Some(_) if output.extension().is_some_and(|end| end.eq_ignore_ascii_case("gz")) => {
                Err(Failure::usage(format!(
                    "{}: compressed files are read, not written",
                    output.display()
                )))
            }
            Some(format) if format.meshes_are_written() => Ok(format),
            Some(format) => Err(Failure::usage(format!(
                "{}: {} holds no meshes",
                output.display(),
                format.name()
            ))
            .with_help(format!(
                "meshes are written to {known}; `meshwright convert` writes outlines"
            ))),
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
        outcome: &Outcome,
        pslg: &Pslg,
        formats: &[Format],
        certificate: &[u8],
        voice: &Voice,
    ) -> Result<(Outputs, Notes), Failure> {
        let outputs = self.outputs(formats);
        let prepared = self.write.prepare(&outcome.mesh, Some(&outcome.certificate), voice);
        let mut notes = Notes::default();
        let mut pending = Vec::new();
        for &(output, format) in &outputs {
            let poly = poly::Options {
                outline: Some(pslg),
                points_beside: is_beside(output, Format::Node, &outputs),
            };
            let (file, said) = Pending::write(output, |out| prepared.write(format, poly, out))?;
            pending.push(file);
            notes.add(output, said);
        }
        let write_certificate =
            |place: &PathBuf| Pending::write(place, |out| out.write_all(certificate));
        let certificate = self.certificate.as_ref().map(write_certificate).transpose()?;
        let mut formats = formats.to_vec();
        if let Some((place, format)) = self.format_of_repaired()? {
            let mut outline = pslg.clone();
            convert::keep_what_is_meshed(&mut outline, format, voice);
            let (file, said) = Pending::write(place, |out| convert::write(&outline, format, out))?;
            pending.push(file);
            formats.push(format);
            notes.add(place, said);
        }
        let finish = |(file, format): (Pending, _)| file.finish().map(|file| (file, format));
        let written = pending.into_iter().zip(formats).map(finish).collect::<Result<_, _>>()?;
        if let Some((file, ())) = certificate {
            file.finish()?;
        }
        Ok((written, notes))
    }
}

/// Written files and their formats.
type Outputs = Vec<(Written, Format)>;

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
    if outcome.thinned.is_some_and(|thinned| thinned.stopped) {
        let message = "thinning was interrupted: the mesh is complete, with the points it had then";
        return Err(Failure { exit: Exit::Interrupted, message: message.to_string() });
    }
    match voice.warnings().len() {
        0 => Ok(Exit::Done),
        n if strict => {
            Err(Failure::promise(format!("{}, and --strict allows none", count(n, "warning"))))
        }
        _ => Ok(Exit::Done),
    }
}
