//! Completion scripts and the manual page.

use clap::{Args, CommandFactory};

use super::Arguments;
use super::failure::{Exit, Failure};
use super::voice::print;

/// Which shell completions are for.
#[derive(Debug, Args)]
pub struct Completions {
    /// The shell.
    shell: clap_complete::Shell,
}

/// Prints the completion script.
pub fn completions(arguments: &Completions) -> Result<Exit, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "meshwright", &mut script);
    print(&script).map(|()| Exit::Done)
}

/// Prints the manual page: the command's own, then one section for each subcommand.
pub fn man() -> Result<Exit, Failure> {
    let mut command = Arguments::command();
    command.build();
    let mut page = Vec::new();
    let written = clap_mangen::Man::new(command.clone()).render(&mut page).and_then(|()| {
        command
            .get_subcommands()
            .filter(|sub| sub.get_name() != "help")
            .try_for_each(|sub| clap_mangen::Man::new(sub.clone()).render(&mut page))
    });
    written.map_err(|error| Failure::io("stdout".as_ref(), &error))?;
    print(&page).map(|()| Exit::Done)
}
