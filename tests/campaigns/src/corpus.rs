//! The large collection of outlines that `MESHWRIGHT_DATA` names, and what is known of each.
//!
//! `answers.tsv` holds the answers for good files, `bad/expected.json` those for nasty ones; both
//! were made without any mesher. `geo/expected.json` holds those for real `.geo` scripts. Files of
//! the formats in [`READ`] are taken, compressed ones too, each with and without a repair; some a
//! second time, with other holes.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use meshwright::formats::groups::stated_tag;
use meshwright::formats::{Tag, area, geo, node, obj, poly};
use meshwright::{Mesh, Pslg};
use serde_json::Value;

/// The environment variable that names the collection's folder.
pub const VARIABLE: &str = "MESHWRIGHT_DATA";

/// The ends of the names of the files that are taken.
pub const READ: [&str; 5] = ["poly", "node", "obj", "area", "geo"];

/// The collection's folder, if the environment names one.
#[must_use]
pub fn folder() -> Option<PathBuf> {
    std::env::var_os(VARIABLE).map(PathBuf::from)
}

/// A file and what must happen to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its path below the collection's folder.
    pub file: String,
    /// What takes a face out, as `--holes` has it; `None`: as the format has it.
    pub holes: Option<Holes>,
    /// The tolerance with which it is repaired first, 0 for none; `None`: it is not.
    pub repair: Option<f64>,
    /// What may happen: one of these, nothing else.
    pub allowed: Vec<Ending>,
    /// The area of the mesh, if there is one, and how far it may be off (absolute).
    pub area: Option<(f64, f64)>,
    /// How many boundaries of the mesh have names, where that is known.
    pub boundaries: Option<usize>,
    /// Names that boundaries of the mesh must have.
    pub names: Vec<String>,
    /// The groups that the mesh must have: dimension, number, name (empty for none).
    pub groups: Vec<(u8, Tag, String)>,
    /// How many triangles Gmsh makes of the same sizes, where the two can be compared.
    pub triangles_of_gmsh: Option<usize>,
    /// What a warning or an error must name.
    pub named: Named,
    /// Why what is expected here is not what the collection says; `None`: it is.
    pub differs: Option<&'static str>,
}

/// What takes a face out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holes {
    /// An even number of loops around it.
    EvenOdd,
    /// Nothing.
    None,
}

impl Holes {
    /// The word of the option `--holes`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::EvenOdd => "even-odd",
            Self::None => "none",
        }
    }
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
    /// Whether a run that meshes need name nothing.
    pub only_if_refused: bool,
}

/// All cases, in the order of their files.
///
/// # Errors
/// The collection cannot be read, or its tables are not as expected.
pub fn cases(folder: &Path) -> io::Result<Vec<Case>> {
    let answers = fs::read_to_string(folder.join("answers.tsv"))?;
    let mut cases = answers.lines().skip(1).flat_map(answer).collect::<Vec<_>>();
    let expected = fs::read_to_string(folder.join("bad/expected.json"))?;
    let expected: Value = serde_json::from_str(&expected)?;
    let nasty = expected.as_object().into_iter().flatten();
    cases.extend(
        nasty.filter(|(name, _)| is_read(name)).flat_map(|(name, case)| expectation(name, case)),
    );
    let scripts = fs::read_to_string(folder.join("geo/expected.json"))?;
    let scripts: Value = serde_json::from_str(&scripts)?;
    let scripts = scripts.as_object().into_iter().flatten();
    cases.extend(scripts.map(|(name, case)| script(name, case)));
    cases.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(cases)
}

/// The files that mesh as they are, in the order of their names.
///
/// # Errors
/// The collection cannot be read, or its tables are not as expected.
pub fn meshable(folder: &Path) -> io::Result<Vec<String>> {
    let mut cases = cases(folder)?;
    cases.retain(|case| {
        let mut allowed = case.allowed.iter();
        case.holes.is_none()
            && case.repair.is_none()
            && allowed.all(|ending| matches!(ending, Ending::Meshes | Ending::MeshesWithWarning))
    });
    Ok(cases.into_iter().map(|case| case.file).collect())
}

/// Reads an outline, and what its reader warns of.
///
/// # Errors
/// The file cannot be read, or not as an outline.
pub fn read(path: &Path) -> Result<(Pslg, Vec<String>), String> {
    let name = path.display().to_string();
    let text = uncompressed(fs::read(path).map_err(|error| format!("{name}: {error}"))?)?;
    let end = |end: &&str| name.trim_end_matches(".gz").ends_with(&format!(".{end}"));
    let told = |error: &dyn std::fmt::Display| error.to_string();
    let (outline, warnings) = match READ.into_iter().find(end) {
        Some("node") => node::read(&text, &name).map_err(|error| told(&error)),
        Some("obj") => obj::read(&text, &name).map_err(|error| told(&error)),
        Some("area") => area::read(&text, &name)
            .map(|(_, said)| (Pslg::default(), said))
            .map_err(|error| told(&error)),
        Some("geo") => geo::read(&text, &name, |file| fs::read(file)).map_err(|error| told(&error)),
        _ => poly::read(&text, &name, |node| fs::read(node)).map_err(|error| told(&error)),
    }?;
    Ok((outline, warnings.iter().map(ToString::to_string).collect()))
}

fn uncompressed(bytes: Vec<u8>) -> Result<Vec<u8>, String> {
    if !bytes.starts_with(&[0x1f, 0x8b]) {
        return Ok(bytes);
    }
    let mut text = Vec::new();
    let mut reader = flate2::read::MultiGzDecoder::new(&bytes[..]);
    reader.read_to_end(&mut text).map_err(|error| error.to_string())?;
    Ok(text)
}

/// A script of `geo/` whose circle of arcs turns back: two arcs of a half and two of a quarter.
const TURNING_BACK: &str = "hudson-br_ellipsoidal-void__domain.geo";

/// A script of `geo/` with one surface twice, which its answer counts twice; and its area.
const TWICE: (&str, f64) = ("AliKarakus_camwa__meshes_fence2d_pml_use_v2.geo", 49.95);

/// A script of `geo/` with a curve number 0, whose group Gmsh loses: it writes number 0.
const LOST_GROUP: &str = "feelpp_feelpp__hdg_cvg-mp-tests_darcy2D.geo";

/// An entry of `geo/expected.json`. Curves may be cut to chords: areas are within 1 %.
fn script(name: &str, case: &Value) -> Case {
    let is_refused = name == TURNING_BACK;
    let differs = match name {
        TURNING_BACK => Some("refused: its arcs run back over one another"),
        _ if name == TWICE.0 => Some("the area counts a surface once"),
        LOST_GROUP => Some("the group keeps its number"),
        _ => None,
    };
    let area = if name == TWICE.0 { Some(TWICE.1) } else { case["area"].as_f64() };
    let mut groups = groups(case["physical"].as_array().into_iter().flatten());
    if name == LOST_GROUP {
        groups.retain(|&(_, tag, _)| tag != 0);
        groups.push((1, 1, "in".to_owned()));
    }
    Case {
        file: format!("geo/{name}"),
        holes: None,
        repair: None,
        allowed: vec![if is_refused { Ending::Refused } else { Ending::Meshes }],
        area: area.map(|area| (area, 0.01 * area)),
        boundaries: None,
        names: Vec::new(),
        groups,
        triangles_of_gmsh: triangles_of_gmsh(case),
        named: Named { any_line: is_refused, ..Named::default() },
        differs,
    }
}

/// What Gmsh makes of a script whose sizes are those of its points: without size fields, structured
/// parts, or quadrangles.
fn triangles_of_gmsh(case: &Value) -> Option<usize> {
    let features = case["features"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let other = ["Field", "Recombine", "Transfinite Surface"];
    let compares = !features.into_iter().any(|name| other.iter().any(|word| name.contains(word)));
    let count = case["triangles_gmsh"].as_u64().filter(|&count| compares && count > 0)?;
    usize::try_from(count).ok()
}

/// A nasty file with a circle, which is cut to chords.
const CUT_CIRCLE: &str = "occ_boolean.geo";

/// How far the area of a nasty file may be off.
fn relative_tolerance(name: &str) -> f64 {
    if name == CUT_CIRCLE { 0.01 } else { 1e-6 }
}

/// Groups, given as objects or as lists of dimension, number and name.
fn groups<'a>(listed: impl Iterator<Item = &'a Value>) -> Vec<(u8, Tag, String)> {
    let group = |group: &Value| {
        let [dim, tag, name] = match group {
            Value::Array(parts) => [0, 1, 2].map(|i| parts.get(i).unwrap_or(&Value::Null)),
            object => ["dim", "tag", "name"].map(|key| &object[key]),
        };
        let name = name.as_str().unwrap_or_default().to_owned();
        Some((dim.as_u64()? as u8, number(tag)?, name))
    };
    listed.filter_map(group).collect()
}

fn number(tag: &Value) -> Option<Tag> {
    Tag::try_from(tag.as_i64()?).ok()
}

/// Whether outlines are read from files of this name.
fn is_read(name: &str) -> bool {
    let name = name.strip_suffix(".gz").unwrap_or(name);
    Path::new(name).extension().is_some_and(|end| READ.iter().any(|read| end == *read))
}

/// A row of `answers.tsv`: file, points, segments, clean, components, area, … markers, regions,
/// note.
fn answer(row: &str) -> Vec<Case> {
    let columns: Vec<&str> = row.split('\t').collect();
    let column = |index: usize| columns.get(index).copied().unwrap_or_default();
    let (file, clean, area, note) = (column(0), column(3), column(5), column(10));
    if !is_read(file) {
        return Vec::new();
    }
    let area: Option<f64> = area.parse().ok();
    let encloses = area.is_some_and(|area| area > 0.0);
    let [ending, mended] = match clean {
        "yes" if encloses => [Ending::Meshes; 2],
        "yes" => [Ending::Refused; 2],
        faults if faults.split("; ").all(is_merged) => [Ending::MeshesWithWarning; 2],
        _ if encloses => [Ending::Refused, Ending::Meshes],
        _ => [Ending::Refused; 2],
    };
    let named = Named { any_line: clean != "yes", ..Named::default() };
    // OBJ: `g15`, `g28 m1`. One material tells no groups apart.
    let named_groups = |word: &str| word.strip_prefix('g').and_then(|count| count.parse().ok());
    let is_obj = file.ends_with(".obj");
    let boundaries = column(8).split(' ').find_map(named_groups).filter(|_| is_obj);
    let case = Case {
        file: file.to_owned(),
        holes: None,
        repair: None,
        allowed: vec![ending],
        area: area.map(|area| (area, 1e-9 * area)),
        boundaries,
        names: Vec::new(),
        groups: Vec::new(),
        triangles_of_gmsh: None,
        named,
        differs: None,
    };
    let other = if is_obj {
        (Holes::None, number_after(note, "all faces "))
    } else {
        (Holes::EvenOdd, number_after(note, "even-odd nesting would give "))
    };
    with_repair(with_other_holes(case, other, 1e-9), 0.0, &[mended])
}

/// The cases, and the same ones repaired first.
fn with_repair(cases: Vec<Case>, tolerance: f64, allowed: &[Ending]) -> Vec<Case> {
    let mended =
        |case: &Case| Case { repair: Some(tolerance), allowed: allowed.to_vec(), ..case.clone() };
    let mended: Vec<Case> = cases.iter().map(mended).collect();
    [cases, mended].concat()
}

/// The number that stands behind a text.
fn number_after(note: &str, text: &str) -> Option<f64> {
    let (_, rest) = note.split_once(text)?;
    rest.split([' ', ';']).next()?.parse().ok()
}

/// The case, and the same file with other holes where the area is known then.
fn with_other_holes(case: Case, (holes, area): (Holes, Option<f64>), tolerance: f64) -> Vec<Case> {
    let other = area.map(|area| Case {
        holes: Some(holes),
        area: Some((area, tolerance * area)),
        ..case.clone()
    });
    [case].into_iter().chain(other).collect()
}

/// Whether this fault is mended without being asked.
fn is_merged(fault: &str) -> bool {
    ["duplicate point", "duplicate segment", "zero-length segment"]
        .iter()
        .any(|f| fault.contains(f))
}

/// An entry of `bad/expected.json`.
fn expectation(name: &str, case: &Value) -> Vec<Case> {
    let missing = case["about"].as_str().is_some_and(|about| about.contains("does not exist"));
    let words = case["expect"].as_str().unwrap_or_default().split('|');
    let ending = |is_good: bool| if is_good { Ending::Meshes } else { Ending::Refused };
    let mut allowed: Vec<_> = words.clone().map(|word| ending(word == "ok")).collect();
    let mut mended: Vec<_> = words.map(|word| ending(word != "error")).collect();
    if missing {
        // A file that names one that is not there: wrong input, or nothing to read.
        allowed.push(Ending::Missing);
        mended.push(Ending::Missing);
    }
    let arguments = case["args"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let repair_tolerance = arguments.skip_while(|word| *word != "--tolerance").nth(1);
    let repair_tolerance = repair_tolerance.and_then(|word| word.parse().ok()).unwrap_or(0.0);
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
    let names = result["names"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let case = Case {
        file: format!("bad/{name}"),
        holes: None,
        repair: None,
        allowed,
        area: area.map(|area| (area, tolerance.unwrap_or(area * relative_tolerance(name)))),
        boundaries: None,
        names: names.map(str::to_owned).collect(),
        groups: if name.ends_with(".geo") {
            groups(result["groups"].as_array().into_iter().flatten())
        } else {
            Vec::new()
        },
        triangles_of_gmsh: None,
        named: Named { places, any_line: false, only_if_refused: case["expect"] == "ok|error" },
        differs: (name == CUT_CIRCLE).then_some("the area is that of chords, within 1 %"),
    };
    let cases = with_other_holes(case, (Holes::None, result["area_all"].as_f64()), 1e-6);
    with_repair(cases, repair_tolerance, &mended)
}

impl Case {
    /// The options that it is read with.
    #[must_use]
    pub fn options(&self) -> Vec<String> {
        let mut words: Vec<String> = Vec::new();
        if let Some(holes) = self.holes {
            words.extend(["--holes", holes.word()].map(str::to_owned));
        }
        if let Some(tolerance) = self.repair {
            words.push("--repair".to_owned());
            if tolerance > 0.0 {
                words.extend(["--tolerance".to_owned(), format!("{tolerance:e}")]);
            }
        }
        words
    }

    /// The file and the options that it is read with.
    #[must_use]
    pub fn name(&self) -> String {
        [vec![self.file.clone()], self.options()].concat().join(" ")
    }

    /// What is wrong with the names of the boundaries of a mesh and with its groups, if anything.
    #[must_use]
    pub fn complaints_of_names(&self, mesh: &Mesh) -> Vec<String> {
        let given = mesh
            .groups
            .iter()
            .filter(|group| group.dim == 1 && stated_tag(1, &group.name).is_none());
        let given: BTreeSet<&str> = given.map(|group| group.name.as_str()).collect();
        let missing = self.names.iter().filter(|name| !given.contains(name.as_str()));
        let mut complaints: Vec<String> =
            missing.map(|name| format!("no boundary is named `{name}`")).collect();
        if self.boundaries.is_some_and(|count| count != given.len()) {
            complaints.push(format!("named boundaries: {given:?}, not {:?}", self.boundaries));
        }
        let found = groups_of(mesh);
        // Group 0 is written as what has no group; another number below 1 keeps its name alone.
        let is_there = |(dim, tag, name): &&(u8, Tag, String)| {
            found.contains(&(*dim, *tag, name.clone()))
                || *tag < 1 && !name.is_empty() && found.iter().any(|g| g.0 == *dim && g.2 == *name)
        };
        let missing = self.groups.iter().filter(|group| !is_there(group));
        complaints.extend(missing.map(|group| format!("no group {group:?} among {found:?}")));
        complaints
    }

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
        if meshed && self.named.only_if_refused {
            return complaints;
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

/// The groups that something in a mesh is in, by their numbers in the outline, with their names.
fn groups_of(mesh: &Mesh) -> BTreeSet<(u8, Tag, String)> {
    let edges = (0..mesh.edges.len()).map(|edge| (1, mesh.edge_tag(edge)));
    let triangles = (0..mesh.triangles.len()).map(|triangle| (2, mesh.triangle_tag(triangle)));
    let further = mesh.memberships.iter().map(|m| (m.dim, m.tag));
    let used: BTreeSet<(u8, Tag)> = edges.chain(triangles).chain(further).collect();
    let described = |(dim, tag): (u8, Tag)| {
        let name = mesh.groups.iter().find(|group| group.dim == dim && group.tag == tag);
        let name = name.map_or("", |group| group.name.as_str());
        match stated_tag(dim, name) {
            Some(tag) => (dim, tag, String::new()),
            None => (dim, tag, name.to_owned()),
        }
    };
    used.into_iter().map(described).collect()
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
    use meshwright::formats::{Group, Membership};

    #[test]
    fn an_entry_of_the_scripts_is_understood() {
        let text = r#"{"area": 2.5, "physical": [{"dim": 1, "tag": 7, "name": "rim"},
                       {"dim": 2, "tag": 0, "name": ""}]}"#;
        let case = script("a.geo", &serde_json::from_str(text).unwrap());
        assert_eq!((case.file.as_str(), case.area), ("geo/a.geo", Some((2.5, 0.025))));
        assert_eq!(case.groups, [(1, 7, "rim".to_owned()), (2, 0, String::new())]);
        assert_eq!(case.allowed, [Ending::Meshes]);
        let refused = script(TURNING_BACK, &Value::Null);
        assert_eq!((refused.allowed, refused.named.any_line), (vec![Ending::Refused], true));
    }

    #[test]
    fn the_groups_of_a_mesh_have_the_numbers_of_the_outline() {
        let group = |dim, tag, name: &str| Group { dim, tag, name: name.into() };
        let mesh = Mesh {
            edges: vec![[0, 1], [1, 2]],
            edge_tags: vec![4, 9],
            groups: vec![group(1, 4, "boundary_-3"), group(1, 9, "rim"), group(0, 2, "corner")],
            memberships: vec![Membership { dim: 0, item: 1, tag: 2 }],
            ..Mesh::default()
        };
        let found = groups_of(&mesh);
        let expected = [(0, 2, "corner"), (1, -3, ""), (1, 9, "rim")];
        assert_eq!(found, expected.map(|(d, t, n): (u8, Tag, &str)| (d, t, n.to_owned())).into());
    }

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
        let both = |row: &str| {
            let [case, mended] = &answer(row)[..] else { panic!("two cases") };
            assert_eq!((case.repair, mended.repair), (None, Some(0.0)));
            [case.clone(), mended.clone()]
        };
        let only = |row: &str| {
            let [case, mended] = both(row);
            assert_eq!(case.allowed, mended.allowed);
            case
        };
        let case = only(row);
        assert_eq!((case.file.as_str(), case.allowed), ("x/a.poly", vec![Ending::Meshes]));
        let [case, mended] = both(&row.replace("yes", "6 crossings"));
        assert_eq!(
            (&case.allowed[..], &mended.allowed[..]),
            (&[Ending::Refused][..], &[Ending::Meshes][..])
        );
        assert!(mended.named.any_line);
        let merged = only(&row.replace("yes", "1 duplicate point; 1 duplicate segment"));
        assert_eq!(merged.allowed, [Ending::MeshesWithWarning]);
        assert_eq!(only(&row.replace("2.5", "0")).allowed, [Ending::Refused]);
        assert_eq!(answer(&row.replace("poly", "svg")), []);
    }

    #[test]
    fn a_file_whose_area_with_other_holes_is_known_is_read_with_both() {
        let row = "x/a.obj\t4\t4\tyes\t1\t2.5\t90\t0 0 1 1\tg3 m1\t0\topen; all faces 4.5; x";
        let [first, second, mended, _] = &answer(row)[..] else { panic!("four cases") };
        assert_eq!((&mended.area, &mended.name()[..]), (&first.area, "x/a.obj --repair"));
        assert_eq!((first.holes, first.area), (None, Some((2.5, 2.5e-9))));
        assert_eq!((second.holes, second.area), (Some(Holes::None), Some((4.5, 1e-9 * 4.5))));
        assert_eq!(first.boundaries, Some(3));
        let row = row.replace("obj", "poly").replace("all faces", "even-odd nesting would give");
        assert_eq!(answer(&row)[1].holes, Some(Holes::EvenOdd));
        assert_eq!(answer(&row)[1].boundaries, None);
    }

    #[test]
    fn an_expectation_names_its_culprits() {
        let case = serde_json::json!({
            "about": "", "expect": "repair", "culprits": {"lines": [7, 9], "segments": [1, 3]},
            "args": ["--repair", "--tolerance", "1e-8"]
        });
        let [case, mended] = &expectation("b.poly", &case)[..] else { panic!("two cases") };
        assert_eq!(case.allowed, [Ending::Refused]);
        assert_eq!(mended.allowed, [Ending::Meshes]);
        assert_eq!(mended.name(), "bad/b.poly --repair --tolerance 1e-8");
        let talk =
            "error: segments 1 and 3 cross near (1, 1)\n  bad/b.poly:7: 1 1 2\n  bad/b.poly:9: 3";
        assert_eq!(case.complaints(Ending::Refused, None, talk), Vec::<String>::new());
        assert_eq!(case.complaints(Ending::Refused, None, "error: it crosses").len(), 4);
    }
}
