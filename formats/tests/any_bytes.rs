//! No reader panics, whatever it is given; a message always has a place to point to.

mod common;

use std::io;

use meshwright_formats::{Mesh, Pslg, SyntaxError, ele, msh, node, poly, vtu};
use proptest::collection::vec;
use proptest::prelude::*;

const POLY: &str = "4 2 1 1\n1 0 0 .5 3\n2 1 0 .5 3\n3 1 1 0 -3\n4 0 1 0 0\n4 1\n1 1 2 7\n\
                    2 2 3 7\n3 3 4 8\n4 4 1 0\n1\n1 .5 .5\n2\n1 .1 .1 3 .5\n2 .9 .9 4.5 -1\n";

fn no_companion(_: &str) -> io::Result<Vec<u8>> {
    Err(io::ErrorKind::NotFound.into())
}

/// Reads as every format, and checks that errors point into the text.
fn read_all(bytes: &[u8]) {
    let lines = 1 + bytes.iter().filter(|&&b| b == b'\n' || b == b'\r').count();
    let check = |error: Option<SyntaxError>| {
        if let Some(error) = error {
            assert!((1..=lines).contains(&(error.line as usize)), "{error}");
            assert!(error.column as usize <= error.text.chars().count() + 1, "{error}");
            assert!(error.to_string().len() < 2000);
        }
    };
    check(poly::read(bytes, "any", no_companion).err());
    check(poly::read(bytes, "any", |_| Ok(bytes.to_vec())).err());
    check(node::read(bytes, "any").err());
    check(msh::read(bytes, "any").err());
    let outline = Pslg { points: vec![[0.0; 2]; 5], ..Pslg::default() };
    check(ele::read(bytes, "any", &outline).err());
    check(ele::read_with_companions(bytes, "any", |_| Ok(bytes.to_vec())).err());
    check(ele::read_with_companions(bytes, "any", no_companion).err());
    let _ = vtu::read(bytes, "any");
}

fn msh_of(mesh: &Mesh) -> Vec<u8> {
    let mut text = Vec::new();
    msh::write(mesh, &mut text).expect("memory takes all");
    text
}

fn vtu_of(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = Vec::new();
    vtu::write(mesh, &mut bytes).expect("memory takes all");
    bytes
}

/// A small edit: bytes overwritten, put in or taken out at a place.
#[derive(Debug, Clone)]
struct Edit {
    place: prop::sample::Index,
    taken: usize,
    put: Vec<u8>,
}

fn edit() -> impl Strategy<Value = Edit> {
    let words = prop::sample::select(vec![
        "-",
        "0",
        "9",
        "\n",
        " ",
        "#",
        "$",
        "e",
        "\"",
        "<",
        ">",
        "4294967295",
        "-1",
        "1e999",
        "nan",
        "99999999999999999999",
        "$Nodes\n",
        "/>",
    ]);
    let put = prop_oneof![words.prop_map(|w| w.as_bytes().to_vec()), vec(any::<u8>(), 0..9)];
    (any::<prop::sample::Index>(), 0_usize..9, put).prop_map(|(place, taken, put)| Edit {
        place,
        taken,
        put,
    })
}

fn edited(mut bytes: Vec<u8>, edits: &[Edit]) -> Vec<u8> {
    for Edit { place, taken, put } in edits {
        let start = place.index(bytes.len() + 1);
        let end = (start + taken).min(bytes.len());
        bytes.splice(start..end, put.iter().copied());
    }
    bytes
}

proptest! {
    #[test]
    fn any_bytes_are_read_or_refused(bytes in vec(any::<u8>(), 0..200)) {
        read_all(&bytes);
    }

    #[test]
    fn any_words_are_read_or_refused(text in "([0-4]{1,2}[ \t]){0,4}([-0-9.edn#,]{0,5}[ \r\n]){0,40}") {
        read_all(text.as_bytes());
    }

    #[test]
    fn edited_poly_files_are_read_or_refused(edits in vec(edit(), 1..4)) {
        read_all(&edited(POLY.into(), &edits));
    }

    #[test]
    fn edited_msh_files_are_read_or_refused(mesh in common::mesh(), edits in vec(edit(), 1..4)) {
        read_all(&edited(msh_of(&mesh), &edits));
    }

    #[test]
    fn edited_vtu_files_are_read_or_refused(mesh in common::mesh(), edits in vec(edit(), 1..4)) {
        read_all(&edited(vtu_of(&mesh), &edits));
    }

    #[test]
    fn a_truncated_msh_file_is_refused(mesh in common::mesh(), cut: prop::sample::Index) {
        let text = msh_of(&mesh);
        let whole = text.trim_ascii_end().len();
        prop_assert!(msh::read(&text[..cut.index(whole)], "cut").is_err());
    }

    #[test]
    fn a_truncated_vtu_file_is_refused(mesh in common::mesh(), cut: prop::sample::Index) {
        let bytes = vtu_of(&mesh);
        let tail = b"\n  </AppendedData>\n</VTKFile>\n".len();
        prop_assert!(vtu::read(&bytes[..cut.index(bytes.len() - tail)], "cut").is_err());
    }
}
