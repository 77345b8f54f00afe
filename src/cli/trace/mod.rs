//! `meshwright trace`: every step of a refinement, one JSON object a line.

mod lines;
mod picture;
mod read;

use std::path::PathBuf;

use clap::Args;
use meshwright::Thinning;

use super::failure::{Exit, Failure};
use super::format::Format;
use super::input;
use super::mesh::failure;
use super::options::{ReadOptions, Scale};
use super::output::{Pending, STDOUT, check_places};
use super::refining::RefineOptions;
use super::repair::RepairOptions;
use super::voice::Voice;
use super::wording::{bytes, count};
use lines::Lines;
pub use picture::{Film, draw};

/// What `trace` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The outline (`-`: stdin).
    input: PathBuf,
    /// Where the trace goes (`-`: stdout).
    #[arg(short, long, value_name = "OUT.jsonl", default_value = STDOUT)]
    output: PathBuf,
    /// The format of the input, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    refine: RefineOptions,
    #[command(flatten)]
    scale: Scale,
    #[command(flatten)]
    repair: RepairOptions,
}

/// Refines, and writes what it does.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    let parameters = arguments.refine.parameters()?;
    if parameters.thinning != Thinning::None {
        return Err(Failure::usage(
            "--thin: a trace tells the refinement, not what thins its mesh",
        )
        .with_help("`meshwright mesh --thin` thins"));
    }
    let (mut pslg, input) =
        input::outline(&arguments.input, arguments.from, arguments.read, voice)?;
    check_places(std::slice::from_ref(&arguments.output), &input.files)?;
    arguments.scale.apply(&mut pslg);
    let mended = arguments.repair.mend(pslg, voice)?;
    let pslg = mended.outline();
    mended.say(voice);

    let mut lines = Lines::new(&input.name, pslg, &parameters);
    let (pending, traced) = Pending::write(&arguments.output, |out| {
        let mut written = Ok(());
        let mut put = |line: String| {
            if written.is_ok() {
                written = writeln!(out, "{line}");
            }
        };
        let traced = meshwright::trace(pslg, &parameters, &mut |event| put(lines.of(event)));
        if let Ok(outcome) = &traced {
            put(lines.end(outcome.end));
        }
        written.map(|()| traced)
    })?;
    let outcome = traced.map_err(failure)?;
    outcome.warnings.iter().for_each(|warning| voice.warn(warning));
    let steps = count(lines.steps(), "step");
    let written = pending.finish()?;
    voice.say(&format!("traced    {}: {steps}", input.name));
    if arguments.output.as_os_str() != STDOUT {
        let size = bytes(written.size);
        voice.say(&format!("wrote     {} ({size})", written.place.display()));
    }
    Ok(Exit::Done)
}
