//! `meshwright draw`: an outline or a mesh as SVG.

use std::path::{Path, PathBuf};

use clap::Args;
use meshwright::certify::{self, Certificate, Promise};
use meshwright::domain::{Conflict, Domain, Error};
use meshwright::draw::{self, Dots, Mark, Options};
use meshwright::formats::{Mesh, Pslg};

use super::failure::{Exit, Failure};
use super::format::Format;
use super::input::{self, Content};
use super::options::{PromiseOptions, ReadOptions, Scale, zoom_box};
use super::output::{Pending, STDOUT, Written, check_places};
use super::repair::RepairOptions;
use super::trace::{self, Film};
use super::voice::Voice;
use super::wording::bytes;
use super::words::one_of;

/// More faults of one kind than this are not marked.
const MOST_MARKS: usize = 40;

/// What `draw` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The outline or the mesh (`-`: stdin).
    #[arg(required_unless_present = "trace")]
    file: Option<PathBuf>,
    #[command(flatten)]
    film: Film,
    /// Where the picture goes, an .svg file (`-`: stdout).
    #[arg(short, long, value_name = "OUT.svg")]
    output: PathBuf,
    /// The format of the input, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    /// The outline of the mesh: what `check` finds is marked in the picture.
    #[arg(long, value_name = "OUTLINE")]
    input: Option<PathBuf>,
    /// Show only this part of the plane.
    #[arg(long = "box", value_name = "XMIN,YMIN,XMAX,YMAX", value_parser = zoom_box,
          allow_hyphen_values = true)]
    zoom: Option<[f64; 4]>,
    /// The picture's width in pixels.
    #[arg(long, value_name = "PX", default_value = "960",
          value_parser = clap::value_parser!(u32).range(64..=32_768))]
    width: u32,
    /// Which points are shown as dots; `auto`: all, where there is room.
    #[arg(long, default_value = "auto", value_parser = one_of([
        ("auto", Dots::Auto), ("all", Dots::All), ("none", Dots::None),
    ]))]
    points: Dots,
    /// Leave the legend out.
    #[arg(long)]
    no_legend: bool,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    promise: PromiseOptions,
    #[command(flatten)]
    scale: Scale,
    #[command(flatten)]
    repair: RepairOptions,
}

/// Draws.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    refuse_other_formats(&arguments.output)?;
    if let Some(trace) = arguments.film.trace()? {
        let options = arguments.options(Vec::new());
        let written = trace::draw(&arguments.film, trace, &options, &arguments.output)?;
        return Ok(say_written(&written, voice));
    }
    let file = arguments.file.as_deref().unwrap_or(Path::new(STDOUT));
    let of_outlines = arguments.read;
    // With an outline of its own, the file is a mesh to be drawn as it is.
    let of_file = if arguments.input.is_some() { ReadOptions::default() } else { of_outlines };
    let mut drawn = input::any(file, arguments.from, of_file, voice)?;
    let outline = match &arguments.input {
        Some(path) => Some(input::outline(path, None, of_outlines, voice)?),
        None => None,
    };
    if let Some((_, input)) = &outline {
        drawn.files.extend_from_slice(&input.files);
    }
    check_places(std::slice::from_ref(&arguments.output), &drawn.files)?;

    let promise = arguments.promise.promise()?;
    let marks = match (&mut drawn.content, outline) {
        (Content::Outline(_), Some(_)) => {
            return Err(Failure::usage("--input goes with a mesh; the file holds an outline"));
        }
        (Content::Outline(pslg), None) => {
            arguments.scale.apply(pslg);
            let mended = arguments.repair.mend(std::mem::take(pslg), voice)?;
            *pslg = mended.into_outline();
            conflicts(pslg, &promise)
        }
        (Content::Mesh(mesh), Some((mut pslg, _))) => {
            arguments.scale.apply(&mut pslg);
            let mended = arguments.repair.mend(pslg, voice)?;
            let certificate = certify::certify(mended.outline(), &*mesh, &promise);
            findings(mesh, &certificate)
        }
        (Content::Mesh(_), None) => Vec::new(),
    };
    let options = arguments.options(marks);
    let (pending, ()) = Pending::write(&arguments.output, |mut out| match &drawn.content {
        Content::Outline(pslg) => draw::outline(pslg, &options, &mut out),
        Content::Mesh(mesh) => draw::mesh(mesh, &options, &mut out),
    })?;
    Ok(say_written(&pending.finish()?, voice))
}

impl Arguments {
    fn options(&self, marks: Vec<Mark>) -> Options {
        Options {
            width: f64::from(self.width),
            zoom: self.zoom,
            points: self.points,
            legend: !self.no_legend,
            marks,
        }
    }
}

fn say_written(written: &Written, voice: &Voice) -> Exit {
    voice.say(&format!("wrote     {} ({})", written.place.display(), bytes(written.size)));
    Exit::Done
}

fn refuse_other_formats(output: &Path) -> Result<(), Failure> {
    let end = output.extension().map(|end| end.to_string_lossy().to_ascii_lowercase());
    let special = std::fs::metadata(output).is_ok_and(|found| !found.is_file());
    if output == Path::new(STDOUT) || special || end.as_deref() == Some("svg") {
        return Ok(());
    }
    Err(Failure::usage(format!("{}: only .svg files are drawn", output.display()))
        .with_help("`rsvg-convert picture.svg -o picture.png` makes a PNG of one"))
}

/// Where an outline is not ready to mesh.
fn conflicts(pslg: &Pslg, promise: &Promise) -> Vec<Mark> {
    let Err(Error::Conflicts(conflicts)) = Domain::new(pslg, promise.region) else {
        return Vec::new();
    };
    let mark =
        |conflict: &Conflict| Mark::Fault { place: conflict.place, text: conflict.to_string() };
    conflicts.first.iter().take(MOST_MARKS).map(mark).collect()
}

/// What the certificate of a mesh points at.
fn findings(mesh: &Mesh, certificate: &Certificate) -> Vec<Mark> {
    let mut marks = Vec::new();
    for excused in &certificate.excused {
        let corners = mesh.triangles[excused.triangle as usize];
        let apex = corners.iter().position(|corner| !excused.edge.contains(corner)).unwrap_or(0);
        let corner = |i: usize| mesh.points[corners[(apex + i) % 3] as usize];
        marks.push(Mark::Excused([corner(0), corner(1), corner(2)]));
    }
    for judgement in &certificate.judgements {
        for fault in &judgement.first_limited {
            if let Some(triangle) = fault.triangle {
                let corners = mesh.triangles[triangle as usize];
                marks.push(Mark::Limited(corners.map(|corner| mesh.points[corner as usize])));
            }
        }
        for fault in judgement.first.iter().take(MOST_MARKS) {
            marks.push(Mark::Fault { place: fault.place, text: fault.to_string() });
        }
    }
    marks
}
