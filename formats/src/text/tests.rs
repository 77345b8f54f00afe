//! Lines, words and numbers, and the places of errors.

use super::*;

fn words(text: &str) -> Vec<(u32, String)> {
    let mut scanner = Scanner::new(text.as_bytes(), "file", Some(b'#'));
    let mut found = Vec::new();
    while scanner.next_line() {
        while let Some(word) = scanner.word() {
            found.push((scanner.line(), String::from_utf8_lossy(word.bytes).into_owned()));
        }
    }
    found
}

fn place(text: &[u8]) -> (u32, u32) {
    let mut scanner = Scanner::new(text, "file", Some(b'#'));
    while scanner.next_line() {
        while let Some(word) = scanner.word() {
            if word.bytes == b"here" {
                let error = scanner.unexpected(word, "nothing");
                return (error.line, error.column);
            }
        }
    }
    let error = scanner.missing("something");
    (error.line, error.column)
}

#[test]
fn words_end_at_white_space_comments_and_line_ends() {
    let expected = [(1, "a"), (1, "b"), (3, "c"), (4, "d"), (5, "e")];
    let expected: Vec<_> = expected.iter().map(|&(l, w)| (l, w.to_owned())).collect();
    assert_eq!(words("\u{feff}a\t b#comment\r\n# all\n  c # rest\rd\ne"), expected);
}

#[test]
fn columns_count_characters_from_one() {
    assert_eq!(place(b"\xef\xbb\xbfhere"), (1, 1));
    assert_eq!(place("ä\r\nöö\there".as_bytes()), (2, 4));
    assert_eq!(place(b"\xff\xff here"), (1, 4));
}

#[test]
fn the_end_of_the_file_is_the_end_of_its_last_line_with_text() {
    assert_eq!(place(b""), (1, 1));
    assert_eq!(place(b"\xef\xbb\xbf"), (1, 1));
    assert_eq!(place(b"a\nbc"), (2, 3));
    assert_eq!(place(b"a\nbc\n"), (2, 3));
    assert_eq!(place(b"a\r\nbc \r\n\r\n"), (2, 3));
    assert_eq!(place(b"\n\n"), (1, 1));
}

#[test]
fn numbers_are_read_in_all_their_spellings() {
    let spellings: [(&str, f64); 12] = [
        ("1", 1.0),
        ("+1.", 1.0),
        (".5", 0.5),
        ("-.0E+00", -0.0),
        ("-.000000E+00", -0.0),
        ("0.418893E+02", 41.8893),
        ("0.0D0", 0.0),
        ("0.D0", 0.0),
        ("10.0D-1", 1.0),
        ("1.0d0", 1.0),
        ("1e-400", 0.0),
        ("0.1000000000000000055511151231257827021181583404541015625", 0.1),
    ];
    for (word, value) in spellings {
        let read = parse_real(word.as_bytes()).map(f64::to_bits);
        assert_eq!(read, Some(value.to_bits()), "{word}");
    }
}

#[test]
fn what_is_no_finite_number_is_refused() {
    for word in [
        "",
        "-",
        ".",
        "0,0",
        "1.0.0",
        "nan",
        "inf",
        "-Infinity",
        "1e999",
        "1d999",
        "1e",
        "d5",
        "1d",
        "1dd0",
        "0x10",
        "1_000",
        "१",
        "--1",
        "1e5d5",
    ] {
        assert_eq!(parse_real(word.as_bytes()), None, "{word}");
    }
}

#[test]
fn whole_numbers_do_not_wrap() {
    assert_eq!(parse_integer(b"-9223372036854775808"), Some(i64::MIN));
    assert_eq!(parse_integer(b"+9223372036854775807"), Some(i64::MAX));
    for word in ["9223372036854775808", "99999999999999999999", "", "-", "1.0", "1e3", "1-"] {
        assert_eq!(parse_integer(word.as_bytes()), None, "{word}");
    }
}

#[test]
fn a_long_or_binary_line_is_cut_and_made_printable() {
    let mut text = vec![b'1'; 5000];
    text[2500] = b' ';
    text.extend(b"\x1b[31m\n");
    let mut scanner = Scanner::new(&text, "file", None);
    scanner.next_line();
    scanner.word();
    let word = scanner.word().unwrap();
    let message = scanner.unexpected(word, "an end").to_string();
    assert!(message.chars().count() < 500, "{message}");
    assert!(!message.contains('\x1b'), "{message}");
    assert!(message.ends_with("help: the file does not look like text"), "{message}");
}
