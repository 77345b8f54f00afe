//! What the code must never do, read off its sources.
//!
//! Each test closes one door: it looks through the files of one part for names that part must
//! not know. It also holds against the door a line that must be caught, so that a door which
//! catches nothing any more fails too.

mod source;

use source::{Name, names};
use std::path::{Path, PathBuf};

/// Fails if a file of `part` names what `forbidden` forbids, or if `breach` is not caught.
fn closed(part: impl Fn(&str) -> bool, forbidden: impl Fn(&Name) -> bool, breach: &str) {
    assert!(names(breach).iter().any(&forbidden), "the door does not catch `{breach}`");
    let mut breaches = Vec::new();
    for file in sources().iter().filter(|file| part(file)) {
        let text = std::fs::read_to_string(root().join(file)).expect("a source file can be read");
        for name in names(&text).iter().filter(|name| forbidden(name)) {
            breaches.push(format!("{file}:{}: {}", name.line, name.words.join("::")));
        }
    }
    assert!(breaches.is_empty(), "\n{}", breaches.join("\n"));
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The `.rs` files of both packages, relative to the root; their files of tests are left out.
fn sources() -> Vec<String> {
    let mut files = Vec::new();
    let mut folders = vec![PathBuf::from("src"), PathBuf::from("formats/src")];
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(root().join(&folder)).expect("a source folder can be read");
        for entry in entries {
            let name = entry.expect("a folder's entry can be read").file_name();
            let path = folder.join(&name);
            let is_tests = path.file_stem().is_some_and(|stem| stem == "tests");
            if root().join(&path).is_dir() && !is_tests {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") && !is_tests {
                files.push(path.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    assert!(files.len() > 5, "the sources are found");
    files.sort();
    files
}

fn everywhere(_: &str) -> bool {
    true
}

fn in_library(file: &str) -> bool {
    !in_command(file)
}

fn in_command(file: &str) -> bool {
    file == "src/main.rs" || file.starts_with("src/cli/")
}

fn in_formats(file: &str) -> bool {
    file.starts_with("formats/")
}

/// Whether the name has one of these words anywhere.
fn has(words: &'static [&'static str]) -> impl Fn(&Name) -> bool {
    move |name| name.words.iter().any(|word| words.contains(&word.as_str()))
}

/// Whether the name has one of these words as a part of a longer path (`use refine::…`).
fn through(words: &'static [&'static str]) -> impl Fn(&Name) -> bool {
    move |name| name.words.len() > 1 && has(words)(name)
}

/// Whether the name is a path that starts with this one.
fn under(prefix: &'static [&'static str]) -> impl Fn(&Name) -> bool {
    move |name| name.words.iter().zip(prefix).filter(|(a, b)| a == b).count() == prefix.len()
}

#[test]
fn formats_knows_no_geometry() {
    let forbidden = has(&["meshwright", "robust", "spade"]);
    closed(in_formats, forbidden, "use robust::{Coord, orient2d};");
}

#[test]
fn a_reader_sees_no_file_system() {
    let forbidden = |name: &Name| under(&["std", "path"])(name) || under(&["std", "fs"])(name);
    closed(in_formats, forbidden, "use std::{io::{self, Write}, path::Path};");
}

#[test]
fn only_the_command_prints() {
    let prints = has(&["print", "println", "eprint", "eprintln", "dbg"]);
    let forbidden = move |name: &Name| {
        name.after == Some('!') && prints(name)
            || under(&["std", "io", "stdout"])(name)
            || under(&["std", "io", "stderr"])(name)
    };
    closed(in_library, forbidden, "fn f() { println!(\"done\"); }");
}

#[test]
fn anyhow_and_clap_are_known_to_the_command_alone() {
    closed(in_library, has(&["anyhow", "clap", "indicatif"]), "use anyhow::Context;");
}

#[test]
fn the_judge_shares_nothing_with_the_refiner() {
    let part = |file: &str| file.starts_with("src/certify");
    let forbidden =
        through(&["refine", "triangulation", "predicates", "constructions", "domain", "carve"]);
    closed(part, forbidden, "use crate::predicates::orientation;");
}

#[test]
fn the_judge_has_its_own_exact_arithmetic() {
    let part = |file: &str| file.starts_with("src/certify");
    closed(part, has(&["robust", "spade"]), "let side = robust::orient2d(a, b, c);");
}

#[test]
fn the_rules_of_refinement_are_functions_of_values() {
    let part = |file: &str| {
        ["quality", "excuse", "shells", "ladder", "bounds"].iter().any(|rule| {
            file == format!("src/refine/{rule}.rs")
                || file.starts_with(&format!("src/refine/{rule}/"))
        })
    };
    let forbidden = has(&["triangulation", "Triangulation"]);
    closed(part, forbidden, "fn removable(mesh: &Triangulation) -> bool { true }");
}

#[test]
fn spade_has_one_door() {
    let part = |file: &str| !file.starts_with("src/triangulation");
    closed(part, has(&["spade"]), "let mut t = spade::DelaunayTriangulation::new();");
}

#[test]
fn robust_has_one_door() {
    closed(|file| file != "src/predicates.rs", has(&["robust"]), "robust::incircle(a, b, c, d)");
}

#[test]
fn nom_has_one_door() {
    let part = |file: &str| !file.starts_with("formats/src/geo");
    closed(part, has(&["nom"]), "use nom::Parser;");
}

#[test]
fn nothing_depends_on_hash_order() {
    let forbidden = has(&["HashMap", "HashSet", "RandomState", "DefaultHasher", "hashbrown"]);
    closed(everywhere, forbidden, "use std::collections::{BTreeMap, HashMap};");
}

#[test]
fn nothing_depends_on_the_clock() {
    closed(in_library, has(&["Instant", "SystemTime"]), "let start = std::time::Instant::now();");
}

#[test]
fn nothing_depends_on_the_platforms_mathematical_library() {
    const ROUNDED: &[&str] = &[
        "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh",
        "asinh", "acosh", "atanh", "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10",
        "powf", "powi", "cbrt", "hypot",
    ];
    let forbidden = |name: &Name| {
        let method = name.words.len() == 1 && name.before == Some('.') && name.after == Some('(');
        let function = under(&["f64"])(name) || under(&["f32"])(name);
        (method || function) && has(ROUNDED)(name)
    };
    closed(everywhere, forbidden, "let height = length * angle.sin();");
    assert!(!names("libm::sin(x)").iter().any(forbidden));
    assert!(names("f64::atan2(y, x)").iter().any(forbidden));
}

#[test]
fn there_is_no_unsafe_code() {
    closed(everywhere, has(&["unsafe"]), "let x = unsafe { *p };");
}

#[test]
fn comments_literals_and_tests_are_not_code() {
    let source = r##"
        // robust::a
        /* robust::b /* robust::c */ */
        const A: &str = "robust::d \" robust::e";
        const B: &str = r#"robust::f " robust::g"#;
        const C: char = '"'; // robust::h
        #[cfg(test)]
        mod tests { fn f<'a>() { robust::i() } }
        fn here<'a>(x: &'a str) { robust :: j (x) }
    "##;
    let found: Vec<Name> = names(source).into_iter().filter(has(&["robust"])).collect();
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].line, found[0].words[1].as_str()), (9, "j"));
}

#[test]
fn no_tracked_file_speaks_of_a_machine_or_a_registry() {
    // In two halves each, so that this file does not speak of them either.
    let forbidden = [
        ["/wo", "rk/"],
        ["/ro", "ot/"],
        ["/ho", "me/"],
        ["/tmp", "/"],
        ["bash", "_jobs"],
        ["crates", ".io"],
        ["pypi", ".org"],
        ["python", "hosted.org"],
        ["npm", "js."],
        ["debian", ".org"],
    ]
    .map(|halves| halves.concat());
    let mut git = std::process::Command::new("git");
    let list = git.args(["ls-files", "-z"]).current_dir(root()).output();
    let list = list.expect("git lists the files");
    let list = String::from_utf8(list.stdout).expect("names are UTF-8");
    let files: Vec<&str> = list.split('\0').filter(|file| !file.is_empty()).collect();
    assert!(files.contains(&"Cargo.toml"), "the files are found");
    let mut breaches = Vec::new();
    for file in files.into_iter().filter(|file| !file.ends_with("Cargo.lock")) {
        // Not UTF-8: no text. Gone: deleted, but not committed yet.
        let Ok(text) = std::fs::read_to_string(root().join(file)) else {
            continue;
        };
        for (number, line) in (1..).zip(text.lines()) {
            if forbidden.iter().any(|word| line.contains(word.as_str())) {
                breaches.push(format!("{file}:{number}: {}", line.trim()));
            }
        }
    }
    assert!(breaches.is_empty(), "\n{}", breaches.join("\n"));
}
