//! The page of experiments and the index of the book are what the code makes. Where a change of the code moves its figures:
//! `cargo run --release -p meshwright-campaigns --bin experiments` makes it again.

use std::fs;
use std::path::PathBuf;

use meshwright_campaigns::book::with_index;
use meshwright_campaigns::experiments::histogram::{Axis, counts, histogram};
use meshwright_campaigns::experiments::{ALL, OPENING, growth, triangle};
use meshwright_campaigns::figures;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs/experiments")
}

#[test]
fn the_experiments_are_made_again_byte_for_byte() {
    let page = fs::read_to_string(folder().join("README.md")).expect("the page is there");
    assert!(page.starts_with(OPENING));
    for experiment in &ALL {
        let section = experiment.section().expect("its meshes keep their promise");
        let text = experiment.markdown(&section);
        assert!(page.contains(&text), "the page does not hold this:\n{text}");
        for picture in section.pictures {
            let file = fs::read(folder().join(&picture.name)).expect("the picture is there");
            assert!(file == picture.svg, "{} is not what the code makes", picture.name);
        }
    }
}

#[test]
fn every_section_has_its_title_and_every_picture_is_shown_and_small() {
    let page = fs::read_to_string(folder().join("README.md")).expect("the page is there");
    let titles: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("## ")).collect();
    assert_eq!(titles, ALL.map(|experiment| experiment.title));
    let mut pictures = 0;
    for entry in fs::read_dir(folder()).expect("the folder is there") {
        let entry = entry.expect("it can be read");
        let name = entry.file_name().to_string_lossy().into_owned();
        if name == "README.md" {
            continue;
        }
        assert!(page.contains(&format!("]({name})")), "{name} is not shown");
        assert!(entry.metadata().expect("it is a file").len() < 150_000, "{name} is large");
        pictures += usize::from(name.ends_with(".svg"));
    }
    assert_eq!(page.matches("![").count(), pictures);
}

#[test]
fn triangles_points_are_recorded_of_these_very_outlines() {
    for (name, outline) in growth::outlines() {
        assert!(triangle::points(&name, &outline).expect("it is recorded") >= outline.points.len());
    }
    let other = figures::wedge(0.2);
    let error = triangle::points("wedge_1", &other).expect_err("it is another outline");
    assert!(error.contains("another outline of the name `wedge_1`"), "{error}");
    let error = triangle::points("wedge_2", &other).expect_err("there is none");
    assert!(error.contains("no row for `wedge_2`"), "{error}");
}

#[test]
fn the_books_index_is_made_again_byte_for_byte() {
    let file = folder().join("../paper.md");
    let book = fs::read_to_string(file).expect("the book is there");
    assert!(
        with_index(&book) == book,
        "cargo run -p meshwright-campaigns --bin book makes it again"
    );
}

#[test]
fn a_histogram_counts_each_triangle_once() {
    let axis = Axis { from: 0, to: 60, step: 10, bound: (26.45, "κ̂"), title: "angle" };
    let angles = [0.05, 0.95, 26.45, 59.999, 60.0];
    let counted = counts(&angles, &axis);
    assert_eq!(counted.iter().sum::<usize>(), angles.len());
    assert_eq!([counted[0], counted[26], counted[59]], [2, 1, 2]);
    let svg = String::from_utf8(histogram(&angles, &axis)).expect("it is text");
    assert_eq!(svg.matches('M').count(), 3 + 4 + 2 - 1, "{svg}");
}
