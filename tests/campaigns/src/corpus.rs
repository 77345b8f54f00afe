//! The large collection of outlines that `MESHWRIGHT_DATA` names, and what is known of each.
//!
//! `answers.tsv` holds the answers for good files, `bad/expected.json` those for nasty ones; both
//! were made without any mesher. Only `.poly` and `.node` files (compressed ones too) are taken.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

/// The environment variable that names the collection's folder.
pub const VARIABLE: &str = "MESHWRIGHT_DATA";

/// The collection's folder, if the environment names one.
#[must_use]
pub fn folder() -> Option<PathBuf> {
    std::env::var_os(VARIABLE).map(PathBuf::from)
}

/// A file and what must happen to it (without any repair).
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its path below the collection's folder.
    pub file: String,
    /// What may happen: one of these, nothing else.
    pub allowed: Vec<Ending>,
    /// The area of the mesh, if there is one, and how far it may be off (absolute).
    pub area: Option<(f64, f64)>,
    /// What a warning or an error must name.
    pub named: Named,
}

/// What must happen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// A mesh whose certificate holds.
    Meshes,
    /// A mesh as well, and a warning says what was merged.
    MeshesWithWarning,
    /// No mesh, exit code 1: the outline is wrong.
    Refused,
    /// No mesh, exit code 3: a file is missing.
    Missing,
}

/// What the talk of a run must name; each entry is one place, any of its texts will do.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Named {
    /// E.g. `[["bowtie.poly:7"], ["bowtie.poly:9"]]`.
    pub places: Vec<Vec<String>>,
    /// Whether at least one line of the file must be named, whichever.
    pub any_line: bool,
}

/// All cases, in the order of their files.
///
/// # Errors
/// The collection cannot be read, or its tables are not as expected.
pub fn cases(folder: &Path) -> io::Result<Vec<Case>> {
    let answers = fs::read_to_string(folder.join("answers.tsv"))?;
    let mut cases = answers.lines().skip(1).filter_map(answer).collect::<Vec<_>>();
    let expected = fs::read_to_string(folder.join("bad/expected.json"))?;
    let expected: Value = serde_json::from_str(&expected)?;
    let nasty = expected.as_object().into_iter().flatten();
    cases.extend(
        nasty.filter(|(name, _)| is_read(name)).map(|(name, case)| expectation(name, case)),
    );
    cases.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(cases)
}

/// Whether outlines are read from files of this name.
fn is_read(name: &str) -> bool {
    let name = name.strip_suffix(".gz").unwrap_or(name);
    Path::new(name).extension().is_some_and(|end| end == "poly" || end == "node")
}

/// A row of `answers.tsv`: file, points, segments, clean, components, area, …
fn answer(row: &str) -> Option<Case> {
    let columns: Vec<&str> = row.split('\t').collect();
    let (&file, &clean, &area) = (columns.first()?, columns.get(3)?, columns.get(5)?);
    if !is_read(file) {
        return None;
    }
    let area: Option<f64> = area.parse().ok();
    let (ending, named) = match (clean, area) {
        ("yes", Some(area)) if area > 0.0 => (Ending::Meshes, Named::default()),
        ("yes", _) => (Ending::Refused, Named::default()),
        (faults, _) if faults.split("; ").all(is_merged) => {
            (Ending::MeshesWithWarning, Named { any_line: true, ..Named::default() })
        }
        _ => (Ending::Refused, Named { any_line: true, ..Named::default() }),
    };
    let area = area.map(|area| (area, 1e-9 * area));
    Some(Case { file: file.to_owned(), allowed: vec![ending], area, named })
}

/// Whether this fault is mended without being asked.
fn is_merged(fault: &str) -> bool {
    ["duplicate point", "duplicate segment", "zero-length segment"]
        .iter()
        .any(|f| fault.contains(f))
}

/// An entry of `bad/expected.json`.
fn expectation(name: &str, case: &Value) -> Case {
    let missing = case["about"].as_str().is_some_and(|about| about.contains("does not exist"));
    let words = case["expect"].as_str().unwrap_or_default().split('|');
    let mut allowed: Vec<_> =
        words.map(|word| if word == "ok" { Ending::Meshes } else { Ending::Refused }).collect();
    if missing {
        // A file that names one that is not there: wrong input, or nothing to read.
        allowed.push(Ending::Missing);
    }
    let result = &case["result"];
    let area = result["area"].as_f64();
    let tolerance = result["area_tolerance"].as_f64();
    let file = case["file"].as_str().unwrap_or(name);
    let at = |line: &Value| format!("{file}:{line}");
    let mut places = Vec::new();
    match &case["line"] {
        Value::Array(lines) => places.push(lines.iter().map(at).collect()),
        line @ Value::Number(_) => places.push(vec![at(line)]),
        _ => {}
    }
    let culprits = &case["culprits"];
    let lines = culprits["lines"].as_array().into_iter().flatten();
    places.extend(lines.map(|line| vec![at(line)]));
    for (kind, word) in [("segments", "segment"), ("points", "point")] {
        for number in culprits[kind].as_array().into_iter().flatten() {
            places.push(vec![
                format!("{word} {number}"),
                format!("{word}s {number}"),
                format!("and {number}"),
            ]);
        }
    }
    Case {
        file: format!("bad/{name}"),
        allowed,
        area: area.map(|area| (area, tolerance.unwrap_or(1e-6 * area))),
        named: Named { places, any_line: false },
    }
}

impl Case {
    /// What is wrong with how a run ended, if anything: its ending, the area of its mesh, what it
    /// said.
    #[must_use]
    pub fn complaints(&self, ending: Ending, area: Option<f64>, talk: &str) -> Vec<String> {
        let mut complaints = Vec::new();
        let meshed = matches!(ending, Ending::Meshes | Ending::MeshesWithWarning);
        let fits = self
            .allowed
            .iter()
            .any(|&allowed| allowed == ending || (meshed && allowed == Ending::Meshes));
        if !fits {
            complaints.push(format!("{ending:?} where {:?} was expected", self.allowed));
        }
        if let (true, Some((expected, tolerance))) = (meshed, self.area) {
            match area {
                Some(area) if (area - expected).abs() <= tolerance => {}
                Some(area) => complaints.push(format!("area {area}, not {expected}")),
                None => complaints.push("no area is told".to_owned()),
            }
        }
        for place in &self.named.places {
            if !place.iter().any(|text| names(talk, text)) {
                complaints.push(format!("{} is not named", place.join(" or ")));
            }
        }
        let name = Path::new(&self.file).file_name().unwrap_or_default().to_string_lossy();
        if self.named.any_line && !names_a_line(talk, &name) {
            complaints.push("no line is named".to_owned());
        }
        complaints
    }
}

/// Whether the talk holds the text, and no digit goes on where the text ends.
fn names(talk: &str, text: &str) -> bool {
    talk.match_indices(text)
        .any(|(at, _)| !talk[at + text.len()..].starts_with(|next: char| next.is_ascii_digit()))
}

fn names_a_line(talk: &str, name: &str) -> bool {
    let place = format!("{name}:");
    talk.match_indices(&place)
        .any(|(at, _)| talk[at + place.len()..].starts_with(|next: char| next.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_does_not_go_on_in_digits() {
        assert!(names("a.poly:7: segment 1 and 3", "a.poly:7"));
        assert!(!names("a.poly:71: segment 1 and 3", "a.poly:7"));
        assert!(names_a_line("in x/a.poly:71: oh", "a.poly"));
        assert!(!names_a_line("in x/a.poly: oh", "a.poly"));
    }

    #[test]
    fn a_row_of_the_answers_is_understood() {
        let row = "x/a.poly\t4\t4\tyes\t1\t2.5\t90\t0 0 1 1\t0\t0\t";
        let case = answer(row).unwrap();
        assert_eq!((case.file.as_str(), case.allowed), ("x/a.poly", vec![Ending::Meshes]));
        assert_eq!(answer(&row.replace("yes", "6 crossings")).unwrap().allowed, [Ending::Refused]);
        let merged = answer(&row.replace("yes", "1 duplicate point; 1 duplicate segment")).unwrap();
        assert_eq!(merged.allowed, [Ending::MeshesWithWarning]);
        assert_eq!(answer(&row.replace("2.5", "0")).unwrap().allowed, [Ending::Refused]);
        assert_eq!(answer(&row.replace("poly", "obj")), None);
    }

    #[test]
    fn an_expectation_names_its_culprits() {
        let case = serde_json::json!({
            "about": "", "expect": "repair", "culprits": {"lines": [7, 9], "segments": [1, 3]}
        });
        let case = expectation("b.poly", &case);
        assert_eq!(case.allowed, [Ending::Refused]);
        let talk =
            "error: segments 1 and 3 cross near (1, 1)\n  bad/b.poly:7: 1 1 2\n  bad/b.poly:9: 3";
        assert_eq!(case.complaints(Ending::Refused, None, talk), Vec::<String>::new());
        assert_eq!(case.complaints(Ending::Refused, None, "error: it crosses").len(), 4);
    }
}
