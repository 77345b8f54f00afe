//! Outlines of the large test collection, which `MESHWRIGHT_DATA` names, against answers that were
//! computed without any mesher. See `INDEX.md` there.

use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use meshwright::domain::{ConflictKind, Domain, Error, Warning, repair};
use meshwright::formats::{node, poly};
use meshwright::{Pslg, Region};

fn data() -> PathBuf {
    PathBuf::from(std::env::var_os("MESHWRIGHT_DATA").expect("MESHWRIGHT_DATA names a folder"))
}

fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    let bytes = fs::read(path)?;
    if path.extension().is_some_and(|extension| extension == "gz") {
        let mut unpacked = Vec::new();
        flate2::read::GzDecoder::new(&bytes[..]).read_to_end(&mut unpacked)?;
        return Ok(unpacked);
    }
    Ok(bytes)
}

fn read(path: &Path) -> Pslg {
    let name = path.to_str().expect("a UTF-8 path");
    let text = bytes(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let read = if name.trim_end_matches(".gz").ends_with(".node") {
        node::read(&text, name)
    } else {
        poly::read(&text, name, |companion| fs::read(companion))
    };
    read.unwrap_or_else(|error| panic!("{error}")).0
}

/// A row of `answers.tsv`.
struct Answer {
    file: String,
    clean: String,
    area: f64,
    smallest_angle: Option<f64>,
    /// The smallest angle after a repair, to four digits.
    mended_angle: Option<f64>,
}

fn answers() -> Vec<Answer> {
    let table = fs::read_to_string(data().join("answers.tsv")).expect("answers.tsv");
    let row = |line: &str| {
        let column: Vec<&str> = line.split('\t').collect();
        Answer {
            file: column[0].to_owned(),
            clean: column[3].to_owned(),
            area: column[5].parse().unwrap_or(f64::NAN),
            smallest_angle: column[6].parse().ok(),
            mended_angle: column.get(10).and_then(|note| {
                let (_, behind) = note.split_once("theta* ")?;
                behind.split([';', ' ']).next()?.parse().ok()
            }),
        }
    };
    let is_read = |answer: &Answer| {
        let name = answer.file.trim_end_matches(".gz");
        name.ends_with(".poly") || name.ends_with(".node")
    };
    table.lines().skip(1).map(row).filter(is_read).collect()
}

/// The number before a word in a list such as `2 crossings; 1 T-junction`.
fn count_of(clean: &str, word: &str) -> usize {
    let entry = clean.split("; ").find(|entry| entry.contains(word));
    entry.map_or(0, |entry| entry.split(' ').next().expect("a count").parse().expect("a count"))
}

/// Mends an outline, and compares with what is known of it then.
fn is_mended_as_answered(pslg: &Pslg, answer: &Answer) {
    let file = &answer.file;
    let mended = repair(pslg, 0.0).unwrap_or_else(|error| panic!("{file}: {error}"));
    let domain = Domain::new(&mended.outline, Region::Domain);
    let (domain, _) = domain.unwrap_or_else(|error| panic!("{file}: {error}"));
    let (area, found) = (answer.area, domain.area());
    assert!((found - area).abs() <= 1e-9 * area, "{file}: area {found}, not {area}");
    let angle = domain.smallest_angle().expect("segments adjoin").radians.to_degrees();
    if let Some(degrees) = answer.mended_angle {
        assert!((angle - degrees).abs() <= 1e-3 * degrees, "{file}: {angle}°, not {degrees}°");
    }
}

#[test]
#[ignore = "needs MESHWRIGHT_DATA"]
fn every_outline_is_judged_as_its_answers_say() {
    let mut judged = 0;
    for answer in answers() {
        let Answer { file, clean, area, smallest_angle, .. } = &answer;
        let pslg = read(&data().join(file));
        let result = Domain::new(&pslg, Region::Domain);
        let conflicts = [
            ("crossing", ConflictKind::Crossing),
            ("overlap", ConflictKind::Overlap),
            ("isolated point", ConflictKind::PointOnSegment),
        ];
        if conflicts.iter().any(|(word, _)| clean.contains(word)) || clean.contains("T-junction") {
            let Err(Error::Conflicts(found)) = &result else {
                panic!("{file}: {clean}, but {result:?}");
            };
            for (word, kind) in conflicts {
                assert_eq!(found.count(kind), count_of(clean, word), "{file}: {word} of {clean}");
            }
            // A point on a segment that its own segment overlaps counts as an overlap alone.
            let touching = found.count(ConflictKind::TJunction);
            assert!(touching <= count_of(clean, "T-junction"), "{file}: {touching} of {clean}");
            assert!(found.all_counted, "{file}");
            is_mended_as_answered(&pslg, &answer);
        } else if *area == 0.0 {
            assert!(
                matches!(
                    result,
                    Err(Error::EnclosesNothing { .. } | Error::HolesLeaveNothing { .. })
                ),
                "{file}: {result:?}"
            );
        } else {
            let (domain, warnings) = result.unwrap_or_else(|error| panic!("{file}: {error}"));
            let found = domain.area();
            assert!((found - area).abs() <= 1e-9 * area, "{file}: area {found}, not {area}");
            let merged = warnings.iter().any(|warning| {
                matches!(
                    warning,
                    Warning::DuplicatePoints { .. } | Warning::DuplicateSegments { .. }
                )
            });
            assert_eq!(merged, clean.contains("duplicate"), "{file}: {warnings:?}");
            if let Some(degrees) = smallest_angle {
                let angle = domain.smallest_angle().expect("segments adjoin").radians.to_degrees();
                assert!(
                    (angle - degrees).abs() <= 1e-8 * degrees,
                    "{file}: smallest angle {angle}°, not {degrees}°"
                );
            }
        }
        judged += 1;
    }
    assert!(judged > 500, "only {judged} outlines");
}
