//! The experiments of the paper's §11, and ours beside them: tables and pictures from seeds and
//! from outlines in the public domain.
//!
//! An [`Experiment`] makes a [`Section`] of a page: text and pictures. Nothing in it depends on the
//! clock, the machine or the number of threads: the same code makes the same bytes.

pub mod coasts;
pub mod growth;
pub mod histogram;
pub mod outlines;
pub mod rules;
mod run;
pub mod shortest;
pub mod soft;
pub mod spokes;
pub mod superior;
pub mod triangle;

use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

pub use run::{Run, adaptive, grouped, median, paper};

/// Something to find out, as a section of the page.
#[derive(Debug, Clone, Copy)]
pub struct Experiment {
    /// A word to choose it by.
    pub name: &'static str,
    /// The title of its section.
    pub title: &'static str,
    /// Does it.
    pub conduct: fn() -> Result<Section, String>,
}

/// Every experiment, in the order of the page.
pub const ALL: [Experiment; 7] = [
    Experiment {
        name: "superior",
        title: "Figure 10: Lake Superior in a box",
        conduct: superior::figure_10,
    },
    Experiment {
        name: "spokes",
        title: "Figures 11 and 12: twenty spokes",
        conduct: spokes::figures_11_and_12,
    },
    Experiment {
        name: "coasts",
        title: "Figures 13 to 15: coasts",
        conduct: coasts::figures_13_to_15,
    },
    Experiment { name: "growth", title: "What a small angle costs", conduct: growth::table },
    Experiment { name: "rules", title: "Rule against rule", conduct: rules::table },
    Experiment {
        name: "shortest",
        title: "The shortest edge and Corollary 2",
        conduct: shortest::table,
    },
    Experiment { name: "soft", title: "More than 26.45°", conduct: soft::table },
];

impl Experiment {
    /// Does the experiment.
    ///
    /// # Errors
    /// A mesh could not be made, or its certificate does not hold where it must.
    pub fn section(&self) -> Result<Section, String> {
        (self.conduct)().map_err(|error| format!("{}: {error}", self.name))
    }

    /// Its part of the page.
    #[must_use]
    pub fn markdown(&self, section: &Section) -> String {
        format!("## {}\n\n{}\n", self.title, section.text.trim_end())
    }
}

/// A part of the page in the making.
#[derive(Debug, Clone, Default)]
pub struct Section {
    /// Markdown below the title.
    pub text: String,
    /// The pictures that the text shows.
    pub pictures: Vec<Picture>,
}

/// A picture file beside the page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// The file's name.
    pub name: String,
    /// SVG.
    pub svg: Vec<u8>,
}

impl Section {
    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push_str("\n\n");
    }

    /// Adds a table.
    pub fn table(&mut self, head: &[&str], rows: &[Vec<String>]) {
        let mut line = |cells: &[&str]| {
            writeln!(self.text, "| {} |", cells.join(" | ")).expect("a string takes everything");
        };
        line(head);
        line(&vec!["---"; head.len()]);
        for row in rows {
            line(&row.iter().map(String::as_str).collect::<Vec<_>>());
        }
        self.text.push('\n');
    }

    /// Adds a picture and shows it here.
    pub fn picture(&mut self, name: &str, caption: &str, svg: Vec<u8>) {
        let name = format!("{name}.svg");
        self.paragraph(&format!("![{caption}]({name})\n*{caption}*"));
        self.pictures.push(Picture { name, svg });
    }
}

/// The page's beginning: what it is and how it is made.
pub const OPENING: &str = "\
# Experiments

The experiments of §11 of *When and Why Delaunay Refinement Algorithms Work* (Miller, Pav and
Walkington), and some of our own. One command makes this page and its pictures, byte for byte:

```sh
cargo run --release -p meshwright-campaigns --bin experiments
```

Random outlines come from printed seeds (`meshwright_campaigns::Random`). Coasts are from Natural
Earth, in the public domain. \"The paper's rules\" are: the whole convex hull, splits on concentric
shells, angles excused between midpoints only, circumcenters, the worst angle first. \"Our rules\" are
the defaults. κ̂ = 26.45° unless something else is said. Every mesh of the adaptive rule on this page
is certified: a certificate that does not hold stops the command.

";

/// Writes the outlines that Triangle's numbers are recorded of, as `.poly` files.
///
/// # Errors
/// A file cannot be written.
pub fn write_outlines(folder: &Path) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    for (name, outline) in growth::outlines() {
        fs::write(folder.join(format!("{name}.poly")), triangle::text(&name, &outline))?;
    }
    Ok(())
}

/// Writes the page of all experiments and its pictures into a folder, telling each one's name
/// before it begins.
///
/// # Errors
/// An experiment fails, or a file cannot be written.
pub fn write(folder: &Path, mut tell: impl FnMut(&str)) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let mut page = OPENING.to_owned();
    let mut parts = Vec::new();
    for experiment in &ALL {
        tell(experiment.name);
        let section = experiment.section().map_err(io::Error::other)?;
        parts.push(experiment.markdown(&section));
        for picture in &section.pictures {
            fs::write(folder.join(&picture.name), &picture.svg)?;
        }
    }
    page.push_str(&parts.join("\n"));
    fs::write(folder.join("README.md"), page)
}
