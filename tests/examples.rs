//! The examples run, and do what they say.

#[path = "../examples/certificate.rs"]
#[allow(dead_code)]
mod certificate;
#[path = "../examples/mesh_outline.rs"]
#[allow(dead_code)]
mod mesh_outline;
#[path = "../examples/plate_with_hole.rs"]
#[allow(dead_code)]
mod plate_with_hole;

use std::fs;
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

#[test]
fn an_outline_becomes_two_files() {
    let folder = folder("mesh_outline");
    let outline = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/lake_superior.poly");
    mesh_outline::mesh_outline(outline, &folder).expect("Lake Superior is meshed");
    assert!(fs::metadata(folder.join("lake.msh")).expect("it is written").len() > 100_000);
    assert!(fs::metadata(folder.join("lake.vtu")).expect("it is written").len() > 100_000);
}

#[test]
fn a_moved_point_is_found() {
    let [good, spoilt] = certificate::certificates().expect("Lake Superior is meshed");
    assert!(!good.contains("FAILS"), "{good}");
    assert!(spoilt.contains("FAILS"), "{spoilt}");
}

#[test]
fn an_outline_made_in_code_keeps_its_names() {
    let file = folder("plate_with_hole").join("plate.msh");
    plate_with_hole::write_plate(&file).expect("the plate is meshed");
    let text = fs::read_to_string(file).expect("it is written");
    for group in ["1 1 \"clamped\"", "1 4 \"hole\"", "2 10 \"steel\""] {
        assert!(text.contains(group), "{group}");
    }
}
