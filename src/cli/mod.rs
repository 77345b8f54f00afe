//! The command: what it is asked, what it says, and with which exit code it ends.

mod certificate;
mod check;
mod colors;
mod convert;
mod draw;
mod failure;
mod format;
mod info;
mod input;
mod interrupt;
mod json;
mod memory;
mod mesh;
mod notes;
mod options;
mod output;
mod presets;
mod progress;
mod refined;
mod refining;
mod repair;
mod shell;
mod summary;
mod trace;
mod triangle;
mod voice;
mod wording;
mod words;
mod writing;

use clap::{Parser, Subcommand};

use failure::{Exit, Failure};
use voice::Voice;

/// Guaranteed-quality, certified triangle meshes of planar outlines.
#[derive(Debug, Parser)]
#[command(name = "meshwright", version, about, after_help = EXIT_CODES)]
#[command(subcommand_required = true, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Say nothing but errors.
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Say more: every excused angle, every point limited by precision.
    #[arg(short, long, global = true)]
    verbose: bool,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  done, every promise kept
  1  the input is wrong (its syntax or its geometry)
  2  wrong usage
  3  a file could not be read or written
  4  a promise is not kept (a fault found, a budget reached, a warning under --strict)
  130  interrupted";

#[derive(Debug, Subcommand)]
enum Command {
    /// Mesh an outline, certify the mesh and write it.
    Mesh(mesh::Arguments),
    /// Judge any triangle mesh: alone, or against the outline it was made from.
    Check(check::Arguments),
    /// Write an outline in another format.
    Convert(convert::Arguments),
    /// Tell what a file holds and whether an outline is ready to mesh.
    Info(info::Arguments),
    /// Draw an outline, a mesh or the steps of a trace as SVG.
    Draw(draw::Arguments),
    /// Tell every step of a refinement, with its reason, as JSON Lines.
    Trace(trace::Arguments),
    /// Print a completion script for a shell.
    Completions(shell::Completions),
    /// Print the manual page (roff).
    Man,
}

/// Runs the command that the arguments ask for.
pub fn run() -> Exit {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let _ = error.print();
            return if error.use_stderr() { Exit::Usage } else { Exit::Done };
        }
    };
    interrupt::handle();
    let voice = Voice::new(arguments.quiet, arguments.verbose);
    match run_command(&arguments.command, &voice) {
        Ok(exit) => exit,
        Err(failure) => {
            voice.fail(&failure);
            failure.exit
        }
    }
}

fn run_command(command: &Command, voice: &Voice) -> Result<Exit, Failure> {
    match command {
        Command::Mesh(arguments) => mesh::run(arguments, voice),
        Command::Check(arguments) => check::run(arguments, voice),
        Command::Convert(arguments) => convert::run(arguments, voice),
        Command::Info(arguments) => info::run(arguments, voice),
        Command::Draw(arguments) => draw::run(arguments, voice),
        Command::Trace(arguments) => trace::run(arguments, voice),
        Command::Completions(arguments) => shell::completions(arguments),
        Command::Man => shell::man(),
    }
}
