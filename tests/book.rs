//! `docs/paper.md`, the book of the paper: it is complete, and all that it names exists.

use std::path::{Path, PathBuf};

/// The paper's statements, in its order: each has its row.
const STATEMENTS: [&str; 53] = [
    "Assumption 1",
    "Assumption 2",
    "The algorithm",
    "Encroached",
    "(Conformality)",
    "(Quality)",
    "(Quality′)",
    "§3.1",
    "Definition 1",
    "Figure 1",
    "Assumption 3",
    "Lemma 1",
    "Figure 2",
    "Claim 5.1",
    "Figure 3",
    "Claim 5.2",
    "Claim 5.3",
    "Lemma 2",
    "Figure 4",
    "Lemma 3",
    "Definition 2",
    "Lemma 4",
    "Figure 5",
    "Figure 6",
    "Figure 7",
    "Lemma 5",
    "Corollary 1",
    "lfs_min",
    "Theorem 4",
    "Corollary 2",
    "Lemma 6",
    "Claim 8.1",
    "Lemma 7",
    "The Terminator",
    "Corollary 3",
    "Figure 8",
    "Definition 3",
    "Theorem 5",
    "Figure 9",
    "Algorithm 1",
    "Concentric shells",
    "Six-Bounded",
    "Theorem 4 with shells",
    "Off-centers count as input",
    "Claim 10.1",
    "Figure 10",
    "Figure 11",
    "Figure 12",
    "34000",
    "Figure 13",
    "Figure 14",
    "Figure 15",
    "Grading",
];

/// Where the code leaves the paper, in the book's order.
const OURS: [&str; 13] = [
    "Ladder",
    "Measured excuse",
    "Off-center",
    "Domain-Delaunay",
    "Global",
    "Incremental",
    "Precision floor",
    "Soft target",
    "Sizes",
    "Order",
    "Exact predicates",
    "The judge",
    "M-matrix",
];

/// The columns of a row: name, code, tests, remarks.
const COLUMNS: usize = 4;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn book() -> String {
    read(&root().join("docs/paper.md"))
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A row of a table whose first cell starts with a name in bold.
struct Row<'a> {
    name: &'a str,
    cells: Vec<&'a str>,
}

fn rows(book: &str) -> Vec<Row<'_>> {
    let lines = book.lines().filter(|line| line.starts_with("| **"));
    lines
        .map(|line| {
            let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
            let name = cells[0].trim_start_matches("**").split("**").next().unwrap_or_default();
            Row { name, cells }
        })
        .collect()
}

/// A link, and whether what it shows is set as code.
struct Link<'a> {
    shown: &'a str,
    is_code: bool,
    target: &'a str,
}

fn links(text: &str) -> Vec<Link<'_>> {
    let mut links = Vec::new();
    for (place, _) in text.match_indices("](") {
        let shown = text[..place].rsplit('[').next().unwrap_or_default();
        let target = text[place + 2..].split(')').next().unwrap_or_default();
        let is_code = shown.len() > 1 && shown.starts_with('`') && shown.ends_with('`');
        links.push(Link { shown: shown.trim_matches('`'), is_code, target });
    }
    links
}

/// Where a link of the book leads; `None` for one that leaves the project.
fn path(target: &str) -> Option<PathBuf> {
    let file = target.split('#').next().unwrap_or_default();
    (!target.contains("://")).then(|| root().join("docs").join(file))
}

/// The lines of a source that are code, without the spaces before them.
fn code(source: &str) -> impl Iterator<Item = &str> + Clone {
    source.lines().map(str::trim_start).filter(|line| !line.starts_with("//"))
}

/// Whether the line names `word` right behind `keyword`.
fn introduces(line: &str, keyword: &str, word: &str) -> bool {
    let mut words = line.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    words.by_ref().any(|found| found == keyword) && words.next() == Some(word)
}

/// Whether a source declares the item: a name, or a type's method, constant, variant or field
/// `Type::name`.
fn declares(source: &str, item: &str) -> bool {
    let introduced = |keywords: &[&str], word: &str| {
        keywords.iter().any(|keyword| code(source).any(|line| introduces(line, keyword, word)))
    };
    let Some((owner, member)) = item.rsplit_once("::") else {
        return introduced(&["fn", "struct", "enum", "const", "mod", "type"], item);
    };
    let is_associated = || {
        let is_impl = |line: &str| {
            let mut words = line.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            words.next() == Some("impl") && words.any(|word| word == owner)
        };
        code(source).any(is_impl) && introduced(&["fn", "const"], member)
    };
    let is_part = || {
        let opens =
            |line: &&str| introduces(line, "enum", owner) || introduces(line, "struct", owner);
        let body = code(source).skip_while(|line| !opens(line)).skip(1);
        body.take_while(|line| *line != "}")
            .filter_map(|line| line.trim_start_matches("pub ").strip_prefix(member))
            .any(|rest| rest.starts_with([',', ':', '(', ' ']))
    };
    is_associated() || is_part()
}

/// Whether a source has a test of that name.
fn has_test(source: &str, name: &str) -> bool {
    let lines: Vec<&str> = source.lines().map(str::trim_start).collect();
    (0..lines.len()).filter(|&at| introduces(lines[at], "fn", name)).any(|at| {
        let above = lines[..at].iter().rev();
        above.take_while(|line| line.starts_with(['#', '/'])).any(|line| *line == "#[test]")
    })
}

/// What is wrong with a book: each fault in a sentence.
fn faults(book: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let rows = rows(book);
    let names: Vec<_> = rows.iter().map(|row| row.name).collect();
    for &expected in STATEMENTS.iter().chain(&OURS) {
        let count = names.iter().filter(|name| **name == expected).count();
        if count != 1 {
            faults.push(format!("{expected} has {count} rows"));
        }
    }
    for row in &rows {
        let name = row.name;
        if !STATEMENTS.contains(&name) && !OURS.contains(&name) {
            faults.push(format!("{name} is no statement"));
        }
        if row.cells.len() != COLUMNS {
            faults.push(format!("{name} has {} columns", row.cells.len()));
            continue;
        }
        let tests = row.cells[2];
        if !tests.contains("no test: ") && !links(tests).iter().any(|link| link.is_code) {
            faults.push(format!("{name} names no test and does not say why"));
        }
        for link in links(tests).iter().filter(|link| link.is_code) {
            let file = path(link.target).filter(|file| file.is_file());
            if !file.is_some_and(|file| has_test(&read(&file), link.shown)) {
                faults.push(format!("{name}: {} is no test in {}", link.shown, link.target));
            }
        }
    }
    for link in links(book) {
        let Some(file) = path(link.target) else { continue };
        if !file.exists() {
            faults.push(format!("{} leads nowhere: {}", link.shown, link.target));
        } else if link.is_code && link.shown.contains('/') {
            if !link.target.ends_with(link.shown) {
                faults.push(format!("{} is shown, {} is meant", link.shown, link.target));
            }
        } else if link.is_code && !(file.is_file() && declares(&read(&file), link.shown)) {
            faults.push(format!("{} has no {}", link.target, link.shown));
        }
    }
    for (_, behind) in book.match_indices("--bin ").map(|(at, mark)| (at, &book[at + mark.len()..]))
    {
        let program = behind.split([' ', '\n', '`']).next().unwrap_or_default();
        let source = |end: &str| root().join(format!("tests/campaigns/src/bin/{program}{end}"));
        if !source(".rs").is_file() && !source("/main.rs").is_file() {
            faults.push(format!("there is no program {program}"));
        }
    }
    faults
}

#[test]
fn every_statement_has_its_row_and_every_name_exists() {
    let faults = faults(&book());
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn the_rows_stand_in_the_papers_order() {
    let book = book();
    let names: Vec<_> = rows(&book).iter().map(|row| row.name).collect();
    assert_eq!(names, [&STATEMENTS[..], &OURS].concat());
}

#[test]
fn what_is_not_the_papers_says_how_far_it_can_be_trusted() {
    let book = book();
    for row in rows(&book).iter().filter(|row| OURS.contains(&row.name)) {
        let marks = ["Proved in the paper", "Derived here, certified on output", "Measured"];
        assert!(marks.iter().any(|mark| row.cells[3].starts_with(mark)), "{}", row.name);
    }
}

#[test]
fn a_book_that_is_wrong_is_found_out() {
    let with = |row: &str| faults(&format!("{}\n{row}\n", book()));
    let here = "[`has_test`](../tests/book.rs)";
    for (row, fault) in [
        ("| **Lemma 8** | x | no test: it is none | x |", "Lemma 8 is no statement"),
        ("| **Lemma 7** | x | no test: twice | x |", "Lemma 7 has 2 rows"),
        ("| **Lemma 7** | x | x |", "Lemma 7 has 3 columns"),
        ("| **Lemma 7** | x | x | x |", "Lemma 7 names no test and does not say why"),
        (&format!("| **Lemma 7** | x | {here} | x |"), "has_test is no test in ../tests/book.rs"),
        ("[`Row::nothing`](../tests/book.rs)", "../tests/book.rs has no Row::nothing"),
        ("[`src/nothing.rs`](../src/lib.rs)", "src/nothing.rs is shown, ../src/lib.rs is meant"),
        ("[this](../src/nothing.rs)", "this leads nowhere: ../src/nothing.rs"),
        ("`--bin nothing`", "there is no program nothing"),
    ] {
        let found = with(row);
        assert!(found.iter().any(|line| line.ends_with(fault)), "{row}: {found:?}");
    }
    let nothing = faults("");
    assert_eq!(nothing.len(), STATEMENTS.len() + OURS.len(), "{nothing:?}");
}

#[test]
fn items_are_found_where_they_are_declared_and_nowhere_else() {
    let source = "
        /// fn in_a_comment() {}
        pub enum Rule {
            Adaptive,
            Given(u32),
        }
        impl Rule { pub(super) fn holds(&self) -> bool { Elsewhere, } }
        pub const LIMIT: f64 = 1.0;
    ";
    for item in ["Rule", "Rule::Adaptive", "Rule::Given", "Rule::holds", "holds", "LIMIT"] {
        assert!(declares(source, item), "{item}");
    }
    for item in ["in_a_comment", "Rule::Adapt", "Rule::Elsewhere", "Rules", "LIMIT::holds"] {
        assert!(!declares(source, item), "{item}");
    }
    let tests = "#[test]\n/// Why.\nfn yes() {}\n\n#[test]\n\nfn no() {}\nfn neither() {}";
    assert_eq!(["yes", "no", "neither"].map(|name| has_test(tests, name)), [true, false, false]);
}
