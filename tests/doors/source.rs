//! As much of Rust's grammar as it takes to see what a source file names.

/// A name in the code of a file: a path such as `std::fs::read`, or a word such as `unsafe`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    /// The line, one-based.
    pub line: usize,
    /// The words between the `::`.
    pub words: Vec<String>,
    /// The character before the path, spaces left out; `.` before a method.
    pub before: Option<char>,
    /// The character behind the path, spaces left out; `!` behind a macro.
    pub after: Option<char>,
}

/// Every name in a source, once per place; those of a `use` in full. Comments, literals and
/// items under `#[cfg(test)]` are left out.
pub fn names(source: &str) -> Vec<Name> {
    let code = without_tests(&without_text(source));
    let code: Vec<char> = code.chars().collect();
    let mut names = Vec::new();
    let mut at = 0;
    let mut line = 1;
    while at < code.len() {
        if code[at] == '\n' {
            line += 1;
        }
        if !starts_word(&code, at) {
            at += 1;
            continue;
        }
        let before = code[..at].iter().rev().copied().find(|c| !c.is_whitespace());
        let (words, end) = path(&code, at);
        if words == ["use"] {
            let end = find(&code, end, ';');
            let tree: String = code[at + 3..end].iter().collect();
            for words in leaves(&tree) {
                names.push(Name { line, words, before: None, after: Some(';') });
            }
            line += newlines(&code[at..end]);
            at = end;
            continue;
        }
        let after = code[end..].iter().copied().find(|c| !c.is_whitespace());
        names.push(Name { line, words, before, after });
        line += newlines(&code[at..end]);
        at = end;
    }
    names
}

fn newlines(code: &[char]) -> usize {
    code.iter().filter(|c| **c == '\n').count()
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn starts_word(code: &[char], at: usize) -> bool {
    let inside = at > 0 && is_word(code[at - 1]);
    is_word(code[at]) && !code[at].is_numeric() && !inside
}

fn find(code: &[char], from: usize, wanted: char) -> usize {
    (from..code.len()).find(|&at| code[at] == wanted).unwrap_or(code.len())
}

/// The path that starts here, and the position behind it.
fn path(code: &[char], start: usize) -> (Vec<String>, usize) {
    let mut words = Vec::new();
    let mut at = start;
    loop {
        let end = (at..code.len()).find(|&i| !is_word(code[i])).unwrap_or(code.len());
        words.push(code[at..end].iter().collect());
        let next = skip_space(code, end);
        let behind = skip_space(code, next + 2);
        let goes_on = code.get(next) == Some(&':') && code.get(next + 1) == Some(&':');
        if !goes_on || behind >= code.len() || !starts_word(code, behind) {
            return (words, end);
        }
        at = behind;
    }
}

fn skip_space(code: &[char], from: usize) -> usize {
    (from..code.len()).find(|&at| !code[at].is_whitespace()).unwrap_or(code.len())
}

/// The paths that a `use` tree such as `std::{fs, io::{self, Write}}` brings in.
fn leaves(tree: &str) -> Vec<Vec<String>> {
    let tree = tree.trim();
    let Some(open) = tree.find('{') else {
        let path = tree.split(" as ").next().unwrap_or(tree);
        return vec![path.split("::").map(|word| word.trim().to_owned()).collect()];
    };
    let prefix = tree[..open].split("::").map(str::trim).filter(|word| !word.is_empty());
    let prefix: Vec<String> = prefix.map(str::to_owned).collect();
    let inner = &tree[open + 1..tree.rfind('}').unwrap_or(tree.len())];
    let mut paths = Vec::new();
    let (mut depth, mut start) = (0, 0);
    for (at, c) in inner.char_indices().chain([(inner.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let leaf = inner[start..at].trim();
                if !leaf.is_empty() {
                    paths.extend(leaves(leaf).into_iter().map(|l| [prefix.clone(), l].concat()));
                }
                start = at + 1;
            }
            _ => {}
        }
    }
    paths
}

/// The source with comments and literals replaced by spaces; lines stay where they are.
fn without_text(source: &str) -> String {
    let source: Vec<char> = source.chars().collect();
    let mut code = String::new();
    let mut at = 0;
    while at < source.len() {
        let end = match source[at] {
            '/' if source.get(at + 1) == Some(&'/') => find(&source, at, '\n'),
            '/' if source.get(at + 1) == Some(&'*') => block_comment(&source, at),
            'r' if starts_word(&source, at) && raw_string(&source, at).is_some() => {
                raw_string(&source, at).unwrap_or(at + 1)
            }
            '"' => quoted(&source, at, '"'),
            // A lifetime has no closing quote behind its first letter.
            '\'' if source.get(at + 1) == Some(&'\\') || source.get(at + 2) == Some(&'\'') => {
                quoted(&source, at, '\'')
            }
            c => {
                code.push(c);
                at += 1;
                continue;
            }
        };
        code.extend(source[at..end].iter().map(|&c| if c == '\n' { c } else { ' ' }));
        at = end;
    }
    code
}

fn block_comment(source: &[char], start: usize) -> usize {
    let mut depth = 0;
    let mut at = start;
    while at + 1 < source.len() {
        match (source[at], source[at + 1]) {
            ('/', '*') => depth += 1,
            ('*', '/') => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            return at;
        }
    }
    source.len()
}

fn quoted(source: &[char], start: usize, quote: char) -> usize {
    let mut at = start + 1;
    while at < source.len() && source[at] != quote {
        at += if source[at] == '\\' { 2 } else { 1 };
    }
    (at + 1).min(source.len())
}

fn raw_string(source: &[char], start: usize) -> Option<usize> {
    let quote = (start + 1..source.len()).find(|&at| source[at] != '#')?;
    if source[quote] != '"' {
        return None;
    }
    let hashes = quote - start - 1;
    (quote + 1..source.len())
        .find(|&at| {
            source[at] == '"' && (at + 1..=at + hashes).all(|i| source.get(i) == Some(&'#'))
        })
        .map(|at| at + 1 + hashes)
}

/// The code without the items that stand under `#[cfg(test)]`; lines stay where they are.
fn without_tests(code: &str) -> String {
    const MARK: &str = "#[cfg(test)]";
    let mut kept = String::new();
    let mut rest = code;
    while let Some(start) = rest.find(MARK) {
        let (before, item) = rest.split_at(start);
        kept.push_str(before);
        let end = item_end(&item[MARK.len()..]) + MARK.len();
        kept.extend(item[..end].chars().filter(|c| *c == '\n'));
        rest = &item[end..];
    }
    kept + rest
}

/// Where the item ends that the code starts with: at a `;` or behind its braces.
fn item_end(code: &str) -> usize {
    let mut depth = 0;
    for (at, c) in code.char_indices() {
        match c {
            ';' if depth == 0 => return at + 1,
            '{' => depth += 1,
            '}' => {
                depth -= 1;
                if depth <= 0 {
                    return at + 1;
                }
            }
            _ => {}
        }
    }
    code.len()
}
