//! Makes the index of the book of the paper.

use std::path::PathBuf;

use clap::Parser;
use meshwright_campaigns::book::with_index;

/// Makes the index at the end of `docs/paper.md` again, from the tables above it.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// The book
    #[arg(default_value = "docs/paper.md")]
    book: PathBuf,
}

fn main() -> std::io::Result<()> {
    let Arguments { book } = Arguments::parse();
    let text = std::fs::read_to_string(&book)?;
    std::fs::write(&book, with_index(&text))
}
