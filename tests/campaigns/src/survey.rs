//! A table over every outline of the large collection that meshes as it is.

use std::io;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use meshwright::Pslg;

use crate::corpus;
use crate::run::{Ending, guarded, in_order};

/// Which outlines, and how long each may take.
#[derive(Debug, Args)]
pub struct Survey {
    /// The large collection's folder
    #[arg(long, env = corpus::VARIABLE)]
    pub data: PathBuf,
    /// Only files whose path holds this text
    #[arg(long, default_value = "")]
    pub only: String,
    /// No outline may take longer, in seconds, all its runs together
    #[arg(long, default_value_t = 60.0)]
    pub limit: f64,
    /// How many outlines at once
    #[arg(long, default_value_t = 2)]
    pub threads: usize,
}

/// How a survey went.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tally {
    /// How many outlines there were.
    pub outlines: usize,
    /// How many of them have complaints.
    pub wrong: usize,
    /// The longest that an outline took, and which.
    pub slowest: (Duration, String),
}

impl Survey {
    /// Works on each outline and hands the results over in the order of the files. `row` prints
    /// what was found and answers with complaints.
    ///
    /// # Errors
    /// The collection cannot be read.
    pub fn run<T: Send + 'static>(
        &self,
        work: impl Fn(&Pslg) -> Result<T, String> + Copy + Send + Sync + 'static,
        mut row: impl FnMut(&str, T) -> Vec<String>,
    ) -> io::Result<Tally> {
        let mut files = corpus::meshable(&self.data)?;
        files.retain(|file| file.contains(&self.only));
        let mut tally = Tally { outlines: files.len(), ..Tally::default() };
        let work_on = |i: usize| {
            let path = self.data.join(&files[i]);
            guarded(move || corpus::read(&path).and_then(|(outline, _)| work(&outline)))
        };
        in_order(files.len(), self.threads, work_on, |i, timed| {
            let file = &files[i];
            let mut complaints = match timed.ending {
                Ending::Done(Ok(found)) => row(file, found),
                Ending::Done(Err(error)) => vec![format!("{file}: {error}")],
                Ending::Panicked(message) => vec![format!("{file}: a panic: {message}")],
                Ending::Hung => vec![format!("{file}: it does not end")],
            };
            let seconds = timed.time.as_secs_f64();
            if seconds > self.limit {
                complaints.push(format!("{file}: {seconds:.1} s"));
            }
            complaints.iter().for_each(|complaint| println!("    WRONG: {complaint}"));
            tally.wrong += usize::from(!complaints.is_empty());
            if timed.time > tally.slowest.0 {
                tally.slowest = (timed.time, file.clone());
            }
        });
        Ok(tally)
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (time, file) = &self.slowest;
        let Self { outlines, wrong, .. } = self;
        let seconds = time.as_secs_f64();
        write!(
            f,
            "{outlines} outlines, {wrong} not as promised; the slowest is {file}, {seconds:.2} s"
        )
    }
}
