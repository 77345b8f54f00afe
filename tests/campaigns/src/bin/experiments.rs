//! Makes the page of experiments and its pictures.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use meshwright_campaigns::corpus;
use meshwright_campaigns::experiments::{self, soft, superior};

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
    /// Only write the outlines that Triangle's numbers are recorded of to this folder
    #[arg(long, value_name = "FOLDER")]
    outlines: Option<PathBuf>,
    /// The large collection's folder
    #[arg(long, env = "MESHWRIGHT_DATA")]
    data: Option<PathBuf>,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let tell = |name: &str| eprintln!("{name}");
    let done = match &arguments.outlines {
        Some(folder) => {
            return experiments::write_outlines(folder).map_err(|error| error.to_string());
        }
        None => experiments::write(&arguments.out, tell),
    };
    done.map_err(|error| error.to_string())?;
    arguments.data.as_deref().map_or(Ok(()), papers_outline)
}

/// Prints the figures of the paper's own outline.
fn papers_outline(data: &Path) -> Result<(), String> {
    let read = |file: &str| corpus::read(&data.join(file)).map(|(outline, _)| outline);
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
