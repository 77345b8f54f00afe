//! `meshwright check`: a triangle mesh judged, alone or against its outline.

use std::path::PathBuf;

use clap::Args;
use meshwright::certify::{self, Certificate, Promise};
use meshwright::statistics::Statistics;
use meshwright::{Mesh, Pslg};

use super::certificate::{self, Held};
use super::failure::{Exit, Failure};
use super::format::{Format, listed};
use super::input::{self, Content};
use super::json;
use super::options::{PromiseOptions, ReadOptions, Scale};
use super::repair::RepairOptions;
use super::summary::excused_text;
use super::voice::{Voice, print};

/// What `check` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The mesh (`-`: stdin).
    mesh: PathBuf,
    /// The outline that it was made from.
    #[arg(long, value_name = "OUTLINE")]
    input: Option<PathBuf>,
    /// The format of the mesh, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    promise: PromiseOptions,
    #[command(flatten)]
    scale: Scale,
    #[command(flatten)]
    repair: RepairOptions,
    /// Take what the mesh is held to from this file, which `mesh --certificate` wrote.
    #[arg(long, value_name = "FILE.json",
          conflicts_with_all = ["profile", "min_angle", "no_guarantee", "region", "excuse", "holes",
                                "faces", "refine", "scale", "repair", "tolerance"])]
    certificate: Option<PathBuf>,
    /// Print the verdict as JSON.
    #[arg(long)]
    json: bool,
}

/// Judges.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    let read = ReadOptions::default();
    let mut judged = input::any(&arguments.mesh, arguments.from, read, voice)?;
    let Content::Mesh(mesh) = judged.take() else {
        return Err(Failure::usage(format!(
            "{} holds an outline, where a mesh is wanted ({})",
            judged.name,
            listed(Format::meshes_are_read)
        )));
    };
    let Held { promise, read, scale, repair } = match &arguments.certificate {
        Some(path) => certificate::read(path)?,
        None => Held {
            promise: arguments.promise.promise()?,
            read: arguments.read,
            scale: arguments.scale,
            repair: arguments.repair,
        },
    };
    let mended = match &arguments.input {
        Some(path) => {
            let (mut pslg, _) = input::outline(path, None, read, voice)?;
            scale.apply(&mut pslg);
            Some(repair.mend(pslg, voice)?)
        }
        None => None,
    };
    let statistics = arguments.json.then(|| Statistics::of(&mesh));
    let certificate = match &mended {
        Some(mended) => against(mended.outline(), mesh, judged.format, &promise),
        None => certify::certify_alone(mesh, &promise),
    };
    if let Some(statistics) = statistics {
        let mended = mended.as_ref();
        print(&json::check(&judged, mended, &statistics, &certificate, voice.warnings()))?;
    } else if !voice.quiet {
        if let Some(text) = mended.as_ref().and_then(|mended| mended.text(voice.verbose)) {
            let text = text.replace('\n', &format!("\n{:14}", ""));
            print(format!("{:<13} {text}\n", "repaired").as_bytes())?;
        }
        print(certificate.to_string().as_bytes())?;
        if voice.verbose {
            print(details(&certificate).as_bytes())?;
        }
    }
    Ok(if certificate.holds() { Exit::Done } else { Exit::Promise })
}

/// Judges a mesh against an outline. Where the mesh's format holds one group for each edge and none
/// for points, the others are not asked for.
fn against(outline: &Pslg, mut mesh: Mesh, format: Format, promise: &Promise) -> Certificate {
    if format.holds_memberships() || outline.memberships.is_empty() {
        return certify::certify(outline, mesh, promise);
    }
    let one_group_each = Pslg { memberships: Vec::new(), ..outline.clone() };
    mesh.memberships = Vec::new();
    let mut certificate = certify::certify(&one_group_each, mesh, promise);
    certificate.not_judged.push("groups of points, further groups of edges (the format has none)");
    certificate
}

/// Every fault that the certificate keeps where there are several, and every excused angle.
fn details(certificate: &Certificate) -> String {
    let mut text = String::new();
    for judgement in &certificate.judgements {
        let name = judgement.guarantee.name();
        for (kept, word) in [(&judgement.first, "FAILS"), (&judgement.first_limited, "limited")] {
            for fault in kept.iter().skip(1) {
                text += &format!("{name:<13} {word:<8} {fault}\n");
            }
        }
    }
    for excused in &certificate.excused {
        text += &format!("{:<13} {:<8} {}\n", "angles", "excused", excused_text(excused));
    }
    text
}
