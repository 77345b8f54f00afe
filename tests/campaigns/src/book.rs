//! The index of `docs/paper.md`, the book of the paper: which statements each source file holds.
//!
//! The rows of the book's tables are written by hand, and a test of the root package
//! (`tests/book.rs`) holds them complete and true. The index is made from them.

use std::collections::BTreeMap;
use std::fmt::Write;

/// The line that the index begins with; what follows is made.
pub const OPENING: &str = "## Index of the sources";

/// What stands before the table.
const ABOUT: &str = "\
Made from the tables above by one command, byte for byte:

```sh
cargo run -p meshwright-campaigns --bin book
```
";

/// The book with its index made again.
///
/// ```
/// use meshwright_campaigns::book::with_index;
/// let book = "# Book\n\n| **Lemma 1**: so | [`f`](../src/a.rs) | [`g`](../tests/b.rs) | ok |\n";
/// let made = with_index(book);
/// assert!(made.ends_with("| [`src/a.rs`](../src/a.rs) | Lemma 1 | |\n\
///     | [`tests/b.rs`](../tests/b.rs) | | Lemma 1 |\n"));
/// assert_eq!(with_index(&made), made);
/// ```
#[must_use]
pub fn with_index(book: &str) -> String {
    let by_hand = book.split(OPENING).next().unwrap_or(book).trim_end();
    let rows: Vec<Row> = by_hand.lines().filter_map(Row::of).collect();
    let mut made = format!("{by_hand}\n\n{OPENING}\n\n{ABOUT}\n");
    let mut line = |text: String| writeln!(made, "{text}").expect("a string takes everything");
    let tests: usize = rows.iter().map(|row| row.tests.len()).sum();
    let files = files(&rows);
    line(format!("{} rows, {tests} times a test, {} files.\n", rows.len(), files.len()));
    line("| file | code of | tests of |".to_owned());
    line("|---|---|---|".to_owned());
    for (file, [code, tests]) in files {
        let cell = |names: &[&str]| {
            if names.is_empty() { String::new() } else { format!(" {}", names.join(", ")) }
        };
        line(format!("| [`{file}`](../{file}) |{} |{} |", cell(&code), cell(&tests)));
    }
    made
}

/// A row: the statement, and the files that its code and its tests are in.
struct Row<'a> {
    name: &'a str,
    code: Vec<&'a str>,
    tests: Vec<&'a str>,
}

impl<'a> Row<'a> {
    fn of(line: &'a str) -> Option<Self> {
        let rest = line.strip_prefix("| **")?;
        let name = rest.split("**").next()?;
        let cells: Vec<&str> = line.trim_matches('|').split('|').collect();
        let [_, code, tests, _] = cells[..] else { return None };
        Some(Self { name, code: sources(code), tests: sources(tests) })
    }
}

/// The files of the project that the names in a cell lead to.
fn sources(cell: &str) -> Vec<&str> {
    let targets = cell.split("`](../").skip(1);
    targets.filter_map(|text| text.split([')', '#']).next()).collect()
}

/// For each file the statements whose code it holds, and those whose tests.
fn files<'a>(rows: &[Row<'a>]) -> BTreeMap<&'a str, [Vec<&'a str>; 2]> {
    let mut files: BTreeMap<&str, [Vec<&str>; 2]> = BTreeMap::new();
    for row in rows {
        for (which, named) in [&row.code, &row.tests].into_iter().enumerate() {
            for file in named {
                let names = &mut files.entry(file).or_default()[which];
                if names.last() != Some(&row.name) {
                    names.push(row.name);
                }
            }
        }
    }
    files
}
