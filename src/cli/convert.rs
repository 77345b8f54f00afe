//! `meshwright convert`: an outline or a mesh in another format; the outline of a mesh.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use meshwright::formats::groups::Note;
use meshwright::formats::{Enclosed, Mesh, Pslg, obj, poly};
use meshwright::{boundary_of, meshed_alike, told_by_seeds};

use super::failure::{Exit, Failure};
use super::format::{Format, listed};
use super::input::{self, Content};
use super::notes::Notes;
use super::options::{ReadOptions, Scale};
use super::output::{Pending, STDOUT, Written, check_places};
use super::repair::RepairOptions;
use super::summary::outline_counts;
use super::triangle::{is_beside, tell_incomplete};
use super::voice::Voice;
use super::wording::{bytes, count};
use super::writing::WriteOptions;

/// What `convert` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The outline or the mesh (`-`: stdin).
    input: PathBuf,
    /// The files to write, their formats by their ends (`-`: stdout). Of an outline: .poly or .obj.
    /// Of a mesh: any format of meshes; .poly is its boundary and its interfaces, an outline that can
    /// be meshed again, but beside a .node or .ele file of its name it is the edges of that mesh.
    #[arg(required = true)]
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
    scale: Scale,
    #[command(flatten)]
    repair: RepairOptions,
    #[command(flatten)]
    write: WriteOptions,
    /// Write nothing where an output cannot hold all of the input, or anything else is warned of.
    #[arg(long)]
    strict: bool,
}

/// Converts.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    let formats = arguments.formats(voice)?;
    let mut input = input::any(&arguments.input, arguments.from, arguments.read, voice)?;
    check_places(&arguments.output, &input.files)?;
    let name = std::mem::take(&mut input.name);
    let (pending, notes) = match input.content {
        Content::Outline(pslg) => {
            if let Some(format) = formats.iter().find(|format| !format.outlines_are_written()) {
                return Err(arguments.no_mesh(*format, &name));
            }
            arguments.write_outline(pslg, &name, &formats, voice)?
        }
        Content::Mesh(mesh) => arguments.write_mesh(mesh, &name, &formats, voice)?,
    };
    notes.say(voice);
    match voice.warnings().len() {
        n if n > 0 && arguments.strict => {
            let warnings = count(n, "warning");
            return Err(Failure::promise(format!("{warnings}, and --strict allows none")));
        }
        _ => {}
    }
    let finished = pending.into_iter().map(Pending::finish).collect::<Result<Vec<_>, _>>()?;
    arguments.say_written(&finished, &formats, voice);
    Ok(Exit::Done)
}

/// Files that wait to be put in their places, and what is to be said of them.
type Outputs = (Vec<Pending>, Notes);

impl Arguments {
    /// The format of each output, known before anything is read.
    fn formats(&self, voice: &Voice) -> Result<Vec<Format>, Failure> {
        let format = |output: &PathBuf| match Format::of(output).or(self.to) {
            Some(format) if format.outlines_are_written() || format.meshes_are_written() => {
                Ok(format)
            }
            _ => Err(Failure::usage(format!(
                "{}: its name does not tell a format that is written",
                output.display()
            ))
            .with_help(format!(
                "outlines are written to {}, meshes to {}; --to FORMAT says it too",
                listed(Format::outlines_are_written),
                listed(Format::meshes_are_written)
            ))),
        };
        let formats: Vec<Format> = self.output.iter().map(format).collect::<Result<_, _>>()?;
        self.write.check(&formats, voice)?;
        Ok(formats)
    }

    fn no_mesh(&self, format: Format, name: &str) -> Failure {
        let known = listed(Format::outlines_are_written);
        let format = format.extension();
        Failure::usage(format!("{name} holds an outline, and .{format} files hold meshes"))
            .with_help(format!("outlines are written to {known}; `meshwright mesh` makes meshes"))
    }

    fn write_outline(
        &self,
        mut pslg: Pslg,
        name: &str,
        formats: &[Format],
        voice: &Voice,
    ) -> Result<Outputs, Failure> {
        self.scale.apply(&mut pslg);
        let mended = self.repair.mend(pslg, voice)?;
        mended.say(voice);
        let pslg = mended.into_outline();
        let mut outputs = Outputs::default();
        for (place, &format) in self.output.iter().zip(formats) {
            let mut pslg = pslg.clone();
            keep_what_is_meshed(&mut pslg, format, voice);
            let (pending, said) = Pending::write(place, |out| write(&pslg, format, out))?;
            outputs.0.push(pending);
            outputs.1.add(place, said);
        }
        voice.say(&format!("outline   {name}: {}", outline_counts(&pslg)));
        Ok(outputs)
    }

    fn write_mesh(
        &self,
        mut mesh: Mesh,
        name: &str,
        formats: &[Format],
        voice: &Voice,
    ) -> Result<Outputs, Failure> {
        let pairs: Vec<(&PathBuf, Format)> =
            self.output.iter().zip(formats.iter().copied()).collect();
        let is_of_mesh = |place: &Path| {
            [Format::Node, Format::Ele].iter().any(|&format| is_beside(place, format, &pairs))
        };
        if self.repair.is_asked() {
            return Err(Failure::usage(format!("--repair is for outlines; {name} holds a mesh"))
                .with_help("with --refine the mesh is taken as an outline"));
        }
        self.scale.apply_to_mesh(&mut mesh);
        let prepared = self.write.prepare(&mesh, None, voice);
        let mut outputs = Outputs::default();
        for &(place, format) in &pairs {
            let (pending, said) = if format == Format::Poly && !is_of_mesh(place) {
                let wrong = |error| Failure::input(format!("{name}: {error}"));
                let mut pslg = boundary_of(&mesh).map_err(wrong)?;
                pslg.source.file = name.to_owned();
                keep_what_is_meshed(&mut pslg, format, voice);
                voice.say(&format!("outline   {name}: {}", outline_counts(&pslg)));
                Pending::write(place, |out| write(&pslg, format, out))?
            } else {
                let points_beside = is_beside(place, Format::Node, &pairs);
                let poly = poly::Options { outline: None, points_beside };
                Pending::write(place, |out| prepared.write(format, poly, out))?
            };
            outputs.0.push(pending);
            outputs.1.add(place, said);
        }
        tell_incomplete(&pairs, voice);
        let (points, triangles) = (mesh.points.len(), mesh.triangles.len());
        let (points, triangles) = (count(points, "point"), count(triangles, "triangle"));
        voice.say(&format!("mesh      {name}: {points}, {triangles}"));
        Ok(outputs)
    }

    fn say_written(&self, written: &[Written], formats: &[Format], voice: &Voice) {
        for (written, &format) in written.iter().zip(formats) {
            if written.place != Path::new(STDOUT) {
                let (place, size) = (written.place.display(), bytes(written.size));
                voice.say(&format!("wrote     {place} ({}, {size})", self.write.name(format)));
            }
        }
    }
}

/// Writes an outline.
pub fn write(pslg: &Pslg, format: Format, mut out: &mut dyn Write) -> io::Result<Vec<Note>> {
    match format {
        Format::Obj => obj::write_outline(pslg, &mut out),
        _ => poly::write_outline(pslg, &mut out),
    }
}

/// Lets the file mean what the outline means, where its format can: a `.poly` file tells holes by
/// seeds, an `.obj` file by nesting.
pub fn keep_what_is_meshed(pslg: &mut Pslg, format: Format, voice: &Voice) {
    match (format, pslg.enclosed) {
        (Format::Obj, Enclosed::EvenOdd) | (Format::Poly, Enclosed::All) => {}
        (Format::Obj, _) => {
            let with = |enclosed| Pslg { enclosed, ..without_holes(pslg) };
            if meshed_alike(pslg, &with(Enclosed::EvenOdd)) == Some(false) {
                let help = match meshed_alike(pslg, &with(Enclosed::All)) {
                    Some(true) => "`--holes none` reads it as it is here",
                    _ => "no option reads it as it is here",
                };
                voice.warn(format!(
                    "in an .obj file each loop within a loop is a hole, here it is not; {help}"
                ));
            }
        }
        (_, enclosed) => match told_by_seeds(pslg) {
            Ok(told) => *pslg = told,
            Err(error) => {
                let option = match enclosed {
                    Enclosed::EvenOdd => "; `--holes even-odd` reads it so",
                    _ => "",
                };
                voice.warn(format!(
                    "a .poly file tells by seeds what is a hole, and here they cannot be \
                     found{option}: {error}"
                ));
            }
        },
    }
}

fn without_holes(pslg: &Pslg) -> Pslg {
    Pslg { holes: Vec::new(), ..pslg.clone() }
}
