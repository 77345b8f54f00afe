//! `meshwright convert`: an outline in another format.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use meshwright::formats::groups::Note;
use meshwright::formats::{Enclosed, Pslg, obj, poly};
use meshwright::{meshed_alike, told_by_seeds};

use super::failure::{Exit, Failure};
use super::format::{Format, listed};
use super::input;
use super::notes::Notes;
use super::options::{ReadOptions, Scale};
use super::output::{Pending, STDOUT, check_places};
use super::repair::RepairOptions;
use super::summary::outline_counts;
use super::voice::Voice;
use super::wording::{bytes, count};

/// What `convert` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The outline (`-`: stdin).
    input: PathBuf,
    /// The file to write, its format by its end: .poly or .obj (`-`: stdout).
    output: PathBuf,
    /// The format of the input, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    /// The format of the output, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    to: Option<Format>,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    scale: Scale,
    #[command(flatten)]
    repair: RepairOptions,
    /// Write nothing where the output cannot hold all of the outline, or anything else is warned
    /// of.
    #[arg(long)]
    strict: bool,
}

/// Converts.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    let format = arguments.format()?;
    let (mut pslg, input) =
        input::outline(&arguments.input, arguments.from, arguments.read, voice)?;
    check_places(std::slice::from_ref(&arguments.output), &input.files)?;
    arguments.scale.apply(&mut pslg);
    let mended = arguments.repair.mend(pslg, voice)?;
    mended.say(voice);
    let mut pslg = mended.into_outline();
    keep_what_is_meshed(&mut pslg, format, voice);
    let (pending, said) = Pending::write(&arguments.output, |out| write(&pslg, format, out))?;
    let mut notes = Notes::default();
    notes.add(&arguments.output, said);
    notes.say(voice);
    match voice.warnings().len() {
        n if n > 0 && arguments.strict => {
            let warnings = count(n, "warning");
            return Err(Failure::promise(format!("{warnings}, and --strict allows none")));
        }
        _ => {}
    }
    voice.say(&format!("outline   {}: {}", input.name, outline_counts(&pslg)));
    let written = pending.finish()?;
    if arguments.output != Path::new(STDOUT) {
        let (place, size) = (written.place.display(), bytes(written.size));
        voice.say(&format!("wrote     {place} ({}, {size})", format.name()));
    }
    Ok(Exit::Done)
}

impl Arguments {
    fn format(&self) -> Result<Format, Failure> {
        match Format::of(&self.output).or(self.to) {
            Some(format) if format.outlines_are_written() => Ok(format),
            _ => Err(Failure::usage(format!(
                "{}: its name does not tell the format of an outline",
                self.output.display()
            ))
            .with_help(format!(
                "outlines are written to {}; --to FORMAT says it too",
                listed(Format::outlines_are_written)
            ))),
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
