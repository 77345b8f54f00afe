//! What the README says is done: its commands run, its links lead somewhere.
#![cfg(feature = "cli")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const README: &str = include_str!("../README.md");

/// Commands that a test cannot run: they build the project, run the tests themselves, or want
/// Python's packages (`tests/consumers/test_examples.py` runs those).
const RUN_ELSEWHERE: [&str; 5] = [
    "cargo install --path .",
    "python examples/heat.py",
    "sh examples/membrane.sh",
    "tests/run",
    "tests/solvers",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The contents of the README's code blocks in this language, in order.
fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    let behind = README.split(opening.as_str()).skip(1);
    behind.map(|text| text.split("```").next().unwrap_or(text)).collect()
}

/// Runs a command of the README in a folder, by the program that was built for this test.
fn run(command: &str, folder: &Path) -> Output {
    let arguments = command
        .strip_prefix("cargo run --release -- ")
        .or_else(|| command.strip_prefix("meshwright "))
        .unwrap_or_else(|| panic!("the README's command `{command}` is not meshwright"));
    Command::new(env!("CARGO_BIN_EXE_meshwright"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()
        .expect("meshwright starts")
}

/// An empty folder that looks like the project to the README's commands.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("readme").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    for part in ["examples", "docs"] {
        std::fs::create_dir_all(folder.join(part)).expect("a folder can be made");
    }
    for outline in ["examples/lake_superior.poly", "examples/site.poly"] {
        let copied = std::fs::copy(root().join(outline), folder.join(outline));
        copied.expect("the outline can be copied");
    }
    folder
}

#[test]
fn every_command_runs_and_writes_its_files() {
    let folder = folder("every_command");
    let commands = blocks("sh").into_iter().flat_map(str::lines);
    let commands: Vec<&str> = commands.filter(|line| !RUN_ELSEWHERE.contains(line)).collect();
    assert!(commands.len() >= 6, "the commands are found");
    for command in commands {
        let done = run(command, &folder);
        let said = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{command}\n{said}");
        let words: Vec<&str> = command.split_whitespace().collect();
        for pair in words.windows(2).filter(|pair| pair[0] == "-o") {
            assert!(folder.join(pair[1]).is_file(), "{command} writes {}", pair[1]);
        }
    }
}

/// The words of what the program said; runs of numbers become one `#`, for times and sizes differ
/// between machines, and counts with every better rule.
fn words(said: &str) -> Vec<&str> {
    let has_digit = |word: &str| word.contains(|c: char| c.is_ascii_digit());
    let words = said.split_whitespace().map(|word| if has_digit(word) { "#" } else { word });
    let mut words: Vec<&str> = words.collect();
    words.dedup_by(|a, b| *a == "#" && *b == "#");
    words
}

#[test]
fn the_first_run_says_what_the_readme_shows() {
    let first = blocks("sh")[0].trim();
    let done = run(first, &folder("first_run"));
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(words(&said), words(blocks("text")[0]), "{first}\n{said}");
}

#[test]
fn what_is_mended_is_said_as_the_readme_shows() {
    let command = README.lines().find(|line| line.contains("--write-repaired"));
    let done = run(command.expect("the command is there"), &folder("repaired"));
    let said = String::from_utf8_lossy(&done.stderr);
    let shown = blocks("text").into_iter().find(|text| text.starts_with("repaired"));
    assert!(said.starts_with(shown.expect("the text is there")), "{said}");
}

#[test]
fn every_link_into_the_project_leads_somewhere() {
    let targets = README.split("](").skip(1).filter_map(|text| text.split(')').next());
    let local: Vec<&str> = targets.filter(|target| !target.contains("://")).collect();
    assert!(local.len() >= 4, "the links are found");
    for target in local {
        assert!(root().join(target).exists(), "{target}");
    }
}
