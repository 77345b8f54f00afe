//! Makes the page of experiments and its pictures.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use meshwright_campaigns::experiments::{self, outlines, soft, superior};

/// Makes the page `docs/experiments/README.md` and its pictures again, from seeds and from outlines
/// in the public domain. The same code makes the same bytes.
///
/// Where the large collection is at hand, the figures of the paper's own outline of Lake Superior,
/// which may not be copied, are printed; they are not part of the page.
///
/// Exit code 0: the page is written. 1: a mesh does not keep its promise, or a file cannot be written.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// The folder that the page is written to
    #[arg(long, default_value = "docs/experiments")]
    out: PathBuf,
    /// The large collection's folder
    #[arg(long, env = "MESHWRIGHT_DATA")]
    data: Option<PathBuf>,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let done = experiments::write(&arguments.out, |name| eprintln!("{name}"))
        .map_err(|error| error.to_string())
        .and_then(|()| arguments.data.as_deref().map_or(Ok(()), papers_outline));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Prints the figures of the paper's own outline.
fn papers_outline(data: &Path) -> Result<(), String> {
    let read = |file: &str| outlines::of_the_collection(data, file);
    let boxed = read("paper/superior_box.poly")?;
    print(
        "Figure 10, the paper's outline",
        &superior::HEAD,
        &superior::rows(&superior::runs(&boxed)?),
    );
    let mut rows = soft::rows("the paper's outline", &read("paper/superior.poly")?)?;
    rows.extend(soft::rows("in its box", &boxed)?);
    print("Soft targets, the paper's outline", &soft::HEAD, &rows);
    Ok(())
}

fn print(title: &str, head: &[&str], rows: &[Vec<String>]) {
    println!("{title}\n{}", head.join(" | "));
    for row in rows {
        println!("{}", row.join(" | "));
    }
}
