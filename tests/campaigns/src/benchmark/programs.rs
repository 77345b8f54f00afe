//! The programs that are compared, and how each is asked for one mesh.
//!
//! All mesh for the smallest angle 26.45°, and write no mesh: what is timed is reading the outline,
//! meshing it, and (meshwright, but for [`Program::Unjudged`]) judging the mesh. No angle is measured
//! for a report: Triangle is not asked to, and meshwright is quiet.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::cases::{Case, Kind};
use super::process::{Run, run};

/// A program, as it is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Program {
    /// meshwright, the mesh judged.
    Judged,
    /// meshwright, the mesh not judged.
    Unjudged,
    /// meshwright with `--steiner look-ahead`, not judged.
    LookAhead,
    /// Triangle 1.6, by Jonathan Shewchuk.
    Triangle,
    /// The refinement of the Rust library `spade`.
    Spade,
    /// Gmsh, which takes sizes and no angles: squares only.
    Gmsh,
}

impl Program {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Unjudged, Self::Triangle, Self::Judged, Self::LookAhead, Self::Spade, Self::Gmsh];

    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Judged => "meshwright, judged",
            Self::Unjudged => "meshwright",
            Self::LookAhead => "look-ahead",
            Self::Triangle => "Triangle",
            Self::Spade => "spade",
            Self::Gmsh => "Gmsh",
        }
    }

    /// Whether it is meshwright.
    #[must_use]
    pub fn is_ours(self) -> bool {
        matches!(self, Self::Judged | Self::Unjudged | Self::LookAhead)
    }

    /// Whether it meshes this case: spade's refinement ends on few coasts, and Gmsh is asked for
    /// squares.
    #[must_use]
    pub fn takes(self, case: &Case) -> bool {
        match self {
            Self::Spade => matches!(case.kind, Kind::Points(_) | Kind::Square(_)) && !case.is_large,
            Self::Gmsh => matches!(case.kind, Kind::Square(_)) && !case.is_large,
            Self::LookAhead => !case.is_large && !matches!(case.kind, Kind::Close(..)),
            _ => true,
        }
    }
}

/// Where the programs are; `None`: left out.
#[derive(Debug, Clone)]
pub struct Programs {
    /// meshwright's command.
    pub meshwright: PathBuf,
    /// Triangle, built from its source.
    pub triangle: Option<PathBuf>,
    /// The example `spade_refine`.
    pub spade: Option<PathBuf>,
    /// Gmsh's command.
    pub gmsh: Option<PathBuf>,
}

/// How large a mesh is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// The number of points.
    pub points: usize,
    /// The number of triangles.
    pub triangles: usize,
}

impl Programs {
    /// Runs a program on a case that lies in `folder` as `NAME.poly` (for Gmsh as `NAME.geo`), and
    /// takes its time; `None` where the program is missing or does not take it.
    ///
    /// # Errors
    /// The program failed.
    pub fn run(&self, program: Program, case: &Case, folder: &Path) -> Result<Option<Run>, String> {
        let command = self.command(program, case, folder, Wanted::Time);
        command.map(|mut command| run(&mut command, folder)).transpose()
    }

    /// How large the mesh is that a program made in a run; a run of meshwright, which tells nothing,
    /// is made again, and its mesh judged.
    ///
    /// # Errors
    /// The program failed, or printed no counts; the mesh is not certified.
    pub fn counts(
        &self,
        program: Program,
        case: &Case,
        folder: &Path,
        made: &Run,
    ) -> Result<Counts, String> {
        let again = || match self.command(program, case, folder, Wanted::Counts) {
            Some(mut command) => run(&mut command, folder).map(|made| made.output),
            None => Ok(String::new()),
        };
        let told = if program.is_ours() { again()? } else { made.output.clone() };
        let counts = match program {
            Program::Triangle => {
                number_after(&told, "Mesh vertices:").zip(number_after(&told, "Mesh triangles:"))
            }
            Program::Gmsh => gmsh_counts(&told),
            _ => number_after(&told, "\"mesh\":{\"points\":")
                .zip(number_after(&told, "\"triangles\":")),
        };
        let (points, triangles) = counts.ok_or_else(|| {
            format!("{} printed no counts of {}:\n{told}", program.name(), case.name)
        })?;
        Ok(Counts { points, triangles })
    }

    /// How a program is run.
    fn command(
        &self,
        program: Program,
        case: &Case,
        folder: &Path,
        wanted: Wanted,
    ) -> Option<Command> {
        if !program.takes(case) {
            return None;
        }
        let outline = folder.join(case.name).with_extension("poly");
        match program {
            Program::Judged | Program::Unjudged | Program::LookAhead => {
                let mut command = Command::new(&self.meshwright);
                command.arg("mesh").arg(outline);
                command.args(["--max-points", "200000000"]);
                if let Some(area) = case.max_area() {
                    command.arg("--max-area").arg(area.to_string());
                }
                match wanted {
                    Wanted::Counts => command.arg("--json"),
                    Wanted::Time if program == Program::Judged => command.arg("--quiet"),
                    Wanted::Time => command.args(["--quiet", "--unjudged"]),
                };
                if program == Program::LookAhead {
                    command.args(["--steiner", "look-ahead"]);
                }
                Some(command)
            }
            Program::Triangle => {
                let mut switches = String::from("-pq26.45PNE");
                if case.is_conforming {
                    switches.push('D');
                }
                if let Some(area) = case.max_area() {
                    switches.push_str(&format!("a{area:.20}"));
                }
                let mut command = Command::new(self.triangle.as_ref()?);
                command.arg(switches).arg(outline);
                Some(command)
            }
            Program::Spade => {
                let mut command = Command::new(self.spade.as_ref()?);
                command.arg(outline);
                command.args(case.max_area().map(|area| area.to_string()));
                Some(command)
            }
            Program::Gmsh => {
                let mut command = Command::new(self.gmsh.as_ref()?);
                let (geo, mesh) = (outline.with_extension("geo"), folder.join("gmsh.msh"));
                command.arg("-2").arg(geo).args(["-save_all", "-bin", "-o"]).arg(mesh);
                Some(command)
            }
        }
    }
}

/// What a run of meshwright is for. (Of the other programs each run tells its counts.)
#[derive(Clone, Copy)]
enum Wanted {
    /// How long it takes.
    Time,
    /// How large the mesh is, and whether it is certified.
    Counts,
}

/// The `.geo` script of a square for Gmsh: equilateral triangles of 0.57 times the largest area.
#[must_use]
pub fn geo(case: &Case) -> Option<String> {
    let size = (0.57 * case.max_area()? * 4.0 / 3.0_f64.sqrt()).sqrt();
    Some(format!(
        "h = {size};\nPoint(1) = {{0, 0, 0, h}};\nPoint(2) = {{1, 0, 0, h}};\n\
         Point(3) = {{1, 1, 0, h}};\nPoint(4) = {{0, 1, 0, h}};\n\
         Line(1) = {{1, 2}};\nLine(2) = {{2, 3}};\nLine(3) = {{3, 4}};\nLine(4) = {{4, 1}};\n\
         Curve Loop(1) = {{1, 2, 3, 4}};\nPlane Surface(1) = {{1}};\n"
    ))
}

/// The whole number that follows a text.
fn number_after(output: &str, text: &str) -> Option<usize> {
    let (_, rest) = output.split_once(text)?;
    let rest = rest.trim_start();
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    rest[..end].parse().ok()
}

/// The counts of `Info    : 1033 nodes 2068 elements`; of the elements some are points and lines.
fn gmsh_counts(output: &str) -> Option<(usize, usize)> {
    let line =
        output.lines().find(|line| line.contains(" nodes ") && line.contains(" elements"))?;
    let mut numbers = line.split_whitespace().filter_map(|word| word.parse::<usize>().ok());
    Some((numbers.next()?, numbers.next()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_off_what_programs_print() {
        let triangle = "Statistics:\n\n  Mesh vertices: 219366\n  Mesh triangles: 435681\n";
        assert_eq!(number_after(triangle, "Mesh triangles:"), Some(435_681));
        let gmsh = "Info    : Done meshing 2D\nInfo    : 1033 nodes 2068 elements\n";
        assert_eq!(gmsh_counts(gmsh), Some((1033, 2068)));
        assert_eq!(gmsh_counts("Error: no"), None);
    }
}
