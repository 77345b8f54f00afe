//! Real and nasty outlines with known answers: one test per file of the collection that
//! `MESHWRIGHT_DATA` names. Without it, one ignored test per folder says that they did not run.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};
use meshwright::domain;
use meshwright::formats::Enclosed;
use meshwright::{Mesh, Parameters, Pslg};
use meshwright_campaigns::corpus::{self, Case, Ending, Holes, VARIABLE};
use meshwright_campaigns::judge::{Verdict, judge};
use meshwright_campaigns::measure::area;
use meshwright_campaigns::plane::segments_meet;
use meshwright_campaigns::run::{self, guarded};

/// The folders of the collection that hold outlines.
const FOLDERS: [&str; 11] = [
    "bad", "cdt", "cgshop25", "geo", "gis", "mesh2d", "obj", "outlines", "paper", "polygons",
    "triangle",
];

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let trials = match corpus::folder() {
        Some(folder) => trials(&folder),
        None => {
            let folders = FOLDERS.iter().map(|folder| format!("{folder}/*"));
            folders.chain([LFS_MIN.to_owned()]).map(ignored).collect()
        }
    };
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// A test that is counted as ignored.
fn ignored(name: String) -> Trial {
    let without_data = || Err(Failed::from(format!("{VARIABLE} is not set")));
    Trial::test(name, without_data).with_ignored_flag(true)
}

/// The name of the test of lfs_min.
const LFS_MIN: &str = "the least local feature size of Lake Superior";

/// lfs_min of Lake Superior as it was computed from all pairs.
fn lfs_min_of_superior(folder: &Path) -> Result<(), Failed> {
    let (outline, _) = corpus::read(&folder.join("paper/superior.poly"))?;
    let (domain, _) = domain::Domain::new(&outline, meshwright::Region::Domain)?;
    let found = domain.lfs_min().ok_or("the search is given up")?;
    let known = 8.330_436_717_544_945e-4;
    if (found / known - 1.0).abs() < 1e-14 {
        Ok(())
    } else {
        Err(format!("{found}, not {known}").into())
    }
}

fn trials(folder: &Path) -> Vec<Trial> {
    match corpus::cases(folder) {
        Ok(cases) => {
            let superior = folder.to_owned();
            let lfs_min = Trial::test(LFS_MIN, move || lfs_min_of_superior(&superior));
            let cases = cases.into_iter().map(|case| {
                let path = folder.join(&case.file);
                Trial::test(case.name(), move || behaves(case, path))
            });
            cases.chain([lfs_min]).collect()
        }
        Err(error) => {
            let reason = format!("{}: {error}", folder.display());
            vec![Trial::test("answers", move || Err(Failed::from(reason)))]
        }
    }
}

/// What a run did.
struct Ran {
    ending: Ending,
    area: Option<f64>,
    mesh: Option<Mesh>,
    talk: String,
    /// What is wrong whatever was expected.
    faults: Vec<String>,
}

/// Whether a file behaves as it must.
fn behaves(case: Case, path: PathBuf) -> Result<(), Failed> {
    let (holes, tolerance) = (case.holes, case.repair);
    let ran = match guarded(move || mesh_file(&path, holes, tolerance)).ending {
        run::Ending::Done(ran) => ran,
        run::Ending::Panicked(message) => return Err(format!("a panic: {message}").into()),
        run::Ending::Hung => return Err("it does not end".into()),
    };
    let mut complaints = case.complaints(ran.ending, ran.area, &ran.talk);
    complaints.extend(ran.faults);
    complaints.extend(ran.mesh.iter().flat_map(|mesh| case.complaints_of_names(mesh)));
    if complaints.is_empty() {
        return Ok(());
    }
    Err(format!("{}\nit said:\n{}", complaints.join("\n"), ran.talk).into())
}

fn mesh_file(path: &Path, holes: Option<Holes>, tolerance: Option<f64>) -> Ran {
    let mut talk = Vec::new();
    let refused = |talk: Vec<String>, faults| Ran {
        ending: Ending::Refused,
        area: None,
        mesh: None,
        talk: talk.join("\n"),
        faults,
    };
    let outline = match corpus::read(path) {
        Ok((outline, warnings)) => {
            talk.extend(warnings);
            with_holes(outline, holes)
        }
        Err(message) => {
            talk.push(message);
            return refused(talk, Vec::new());
        }
    };
    let mut has_warned = !talk.is_empty();
    let outline = match tolerance.map(|tolerance| domain::repair(&outline, tolerance)) {
        None => outline,
        Some(Ok(repaired)) => {
            has_warned |= !repaired.warnings.is_empty();
            talk.extend(repaired.warnings.iter().map(ToString::to_string));
            talk.push(repaired.report(&outline).to_string());
            repaired.outline
        }
        Some(Err(error)) => {
            talk.push(error.to_string());
            return refused(talk, Vec::new());
        }
    };
    match meshwright::mesh(&outline, &Parameters::default()) {
        Err(error) => {
            talk.push(error.to_string());
            refused(talk, innocent_culprits(&outline, &error))
        }
        Ok(outcome) => {
            has_warned |= !outcome.warnings.is_empty();
            talk.extend(outcome.warnings.iter().map(ToString::to_string));
            let faults = match judge(&outline, &Parameters::default()).verdict {
                Verdict::Failed(reasons) => reasons,
                _ => Vec::new(),
            };
            let ending = if has_warned { Ending::MeshesWithWarning } else { Ending::Meshes };
            let area = Some(area(&outcome.mesh));
            Ran { ending, area, mesh: Some(outcome.mesh), talk: talk.join("\n"), faults }
        }
    }
}

/// The outline with other holes than its format has.
fn with_holes(outline: Pslg, holes: Option<Holes>) -> Pslg {
    let enclosed = match holes {
        None => return outline,
        Some(Holes::EvenOdd) => Enclosed::EvenOdd,
        Some(Holes::None) => Enclosed::All,
    };
    Pslg { enclosed, holes: Vec::new(), ..outline }
}

/// The culprits of an error that have nothing in common, whatever the error says. Exact.
fn innocent_culprits(outline: &Pslg, error: &meshwright::Error) -> Vec<String> {
    let meshwright::Error::Domain(domain::Error::Conflicts(conflicts)) = error else {
        return Vec::new();
    };
    let ends = |item: &domain::Item| match item.kind {
        domain::Kind::Segment => outline.segments[item.index as usize],
        _ => [item.index; 2],
    };
    let at = |v: u32| outline.points[v as usize];
    let guilty = |[s, t]: &[domain::Item; 2]| {
        let ([a, b], [c, d]) = (ends(s), ends(t));
        segments_meet(at(a), at(b), at(c), at(d))
    };
    conflicts
        .first
        .iter()
        .filter(|conflict| !guilty(&conflict.items))
        .map(|conflict| format!("not so: {conflict}"))
        .collect()
}
