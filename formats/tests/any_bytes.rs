//! No reader panics, whatever it is given; a message always has a place to point to.

mod common;

use std::io;

use meshwright_formats::geo;
use meshwright_formats::{
    FileError, Mesh, Pslg, SyntaxError, ele, inp, medit, msh, node, poly, su2, vtk, vtu,
};
use proptest::collection::vec;
use proptest::prelude::*;

const POLY: &str = "4 2 1 1\n1 0 0 .5 3\n2 1 0 .5 3\n3 1 1 0 -3\n4 0 1 0 0\n4 1\n1 1 2 7\n\
                    2 2 3 7\n3 3 4 8\n4 4 1 0\n1\n1 .5 .5\n2\n1 .1 .1 3 .5\n2 .9 .9 4.5 -1\n";

/// A script with something of everything.
const GEO: &str = "DefineConstant[ h = {0.2, Min 0, Name \"h\"} ]; r = 1; l[] = {1:4}; n = \"rim\";\n\
    Macro Corner\n Point(newp) = {x, y, 0, h};\nReturn\n\
    For i In {0:3}\n x = Cos(i*Pi/2); y = Sin(i*Pi/2); Call Corner;\nEndFor\n\
    Point(9) = {0, 0, 0, h}; Circle(1) = {1, 9, 2}; Circle(2) = {2, 9, 3}; Spline(3) = {3, 4};\n\
    If (#l[] > 3)\n Line(4) = {4, 1};\nElse\n BSpline(4) = {4, 1};\nEndIf\n\
    Curve Loop(1) = {l[]}; Plane Surface(1) = {1}; Point{9} In Surface{1};\n\
    s[] = Translate {3, 0, 0} { Duplicata { Surface{1}; } };\n\
    e[] = Extrude {0, 2, 0} { Curve{4}; Layers{3}; Recombine; }; Coherence;\n\
    Transfinite Curve {-1, 2} = 5 Using Progression 1.2; MeshSize {:} = h/2;\n\
    Physical Curve(StrCat(n, Sprintf(\"_%g\", 1)), 7) = {1, -2}; Physical Surface(8) += {1, s[0]};\n\
    Recombine Surface {1}; Color Red { Surface{1}; } Delete { Surface{e[1]}; }\n";

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
    read_script(bytes);
    for error in [msh::read(bytes, "any").err(), vtk::read(bytes, "any").err()] {
        match error {
            Some(FileError::Text(error)) => check(Some(error)),
            Some(FileError::Binary(error)) => assert!(error.offset <= bytes.len(), "{error}"),
            _ => {}
        }
    }
    let outline = Pslg { points: vec![[0.0; 2]; 5], ..Pslg::default() };
    check(ele::read(bytes, "any", &outline).err());
    check(medit::read(bytes, "any").err());
    check(su2::read(bytes, "any").err());
    check(inp::read(bytes, "any").err());
    check(ele::read_with_companions(bytes, "any", |_| Ok(bytes.to_vec())).err());
    check(ele::read_with_companions(bytes, "any", no_companion).err());
    let _ = vtu::read(bytes, "any");
}

/// Reads a script, which may include itself, and checks that errors point into the text.
fn read_script(bytes: &[u8]) {
    if let Err(error) = geo::read(bytes, "any", |_| Ok(bytes.to_vec())) {
        assert!(error.line >= 1, "{error}");
        assert!(error.column as usize <= error.text.chars().count() + 1, "{error}");
        assert!(error.to_string().len() < 2000);
    }
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
        "{",
        "};",
        "(",
        "9*",
        "[]",
        "-1:",
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

#[test]
fn the_script_is_good_before_it_is_edited() {
    let (pslg, warnings) = geo::read(GEO.as_bytes(), "any", no_companion).expect("it is good");
    assert_eq!((pslg.regions.len(), warnings.len()), (2, 1));
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
    fn edited_scripts_are_read_or_refused(edits in vec(edit(), 1..4)) {
        read_script(&edited(GEO.into(), &edits));
    }

    #[test]
    fn truncated_scripts_are_read_or_refused(cut: prop::sample::Index) {
        read_script(&GEO.as_bytes()[..cut.index(GEO.len())]);
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
        // Data may follow the elements, or not.
        let end = b"$EndElements";
        let place = text.windows(end.len()).position(|part| part == end);
        let whole = place.map_or(0, |place| place + end.len());
        prop_assert!(msh::read(&text[..cut.index(whole)], "cut").is_err());
    }

    #[test]
    fn a_truncated_vtu_file_is_refused(mesh in common::mesh(), cut: prop::sample::Index) {
        let bytes = vtu_of(&mesh);
        let whole = bytes.trim_ascii_end().len();
        prop_assert!(vtu::read(&bytes[..cut.index(whole)], "cut").is_err());
    }
}
