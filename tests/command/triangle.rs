//! Triangle's files, written and read together.

use crate::bench::{Bench, Ran, SQUARE};

const ROOMS: &str = include_str!("../fixtures/two_rooms.poly");

/// The first line of a file.
fn header(bench: &Bench, file: &str) -> String {
    let text = String::from_utf8(bench.read(file)).expect("text");
    text.lines().next().unwrap_or_default().to_owned()
}

fn says(ran: &Ran, part: &str) {
    assert!(ran.stderr.contains(part), "{}", ran.stderr);
}

#[test]
fn one_mesh_is_read_from_its_files_together() {
    let bench = Bench::with("triangle-together", "rooms.poly", ROOMS);
    let outputs = "-o a.node -o a.ele -o a.poly -o a.edge -o a.neigh -o a.msh";
    let ran = bench.succeeds(&format!("mesh rooms.poly {outputs} --strict"));
    assert!(!ran.stderr.contains("not written"), "{}", ran.stderr);
    assert_eq!(header(&bench, "a.poly"), "0 2 0 1", "the points stand in a.node");

    let judged = |mesh: &str| bench.succeeds(&format!("check {mesh} --input rooms.poly")).stdout;
    assert_eq!(judged("a.ele"), judged("a.msh"), "tags and all");
    let groups = |mesh: &str| {
        let told = bench.succeeds(&format!("info {mesh}")).stdout;
        told.lines().filter(|line| line.starts_with("angles")).collect::<String>()
    };
    assert_eq!(groups("a.ele"), groups("a.msh"));
}

#[test]
fn a_poly_file_without_a_node_file_is_an_outline_of_its_own() {
    let bench = Bench::with("triangle-alone", "rooms.poly", ROOMS);
    bench.succeeds("mesh rooms.poly -o a.poly -o a.ele");
    bench.succeeds("check a.ele --input rooms.poly");

    bench.succeeds("mesh a.poly -o b.msh --strict");
    bench.succeeds("check b.msh --input a.poly");
    let told = bench.succeeds("info a.poly").stdout;
    assert!(told.contains("1 hole, 2 regions"), "{told}");
}

#[test]
fn the_outline_is_not_taken_for_the_mesh_of_its_name() {
    let bench = Bench::with("triangle-outline", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly -o square.node -o square.ele --max-area 0.05");
    let ran = bench.succeeds("check square.ele");
    says(&ran, "warning: square.poly:2: these are not the points of `square.node`");
}

#[test]
fn files_without_what_they_refer_to_are_told() {
    let bench = Bench::with("triangle-missing", "square.poly", SQUARE);
    let ran = bench.succeeds("mesh square.poly -o a.ele -o b.neigh -o c.edge");
    says(&ran, "note: a.ele: its points belong into a.node, which is not written");
    says(&ran, "note: b.neigh: its triangles belong into b.ele, which is not written");
    says(&ran, "note: c.edge: its points belong into c.node, which is not written");

    let said = bench.fails("check a.ele", 1);
    assert!(said.starts_with("error: a.ele:1:1: expected points beside, in `a.node`"), "{said}");
    assert!(said.ends_with("help: there is no a.node and no a.poly\n"), "{said}");
    let said = bench.fails("check a.edge --from edge", 2);
    assert!(said.contains("a.edge: files that end in .edge are not read"), "{said}");
}

#[test]
fn a_part_goes_through_a_pipe() {
    let bench = Bench::with("triangle-pipe", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly -o a.ele");
    let piped = bench.succeeds("mesh square.poly -o - --to ele");
    assert_eq!(piped.stdout.as_bytes(), bench.read("a.ele"));
}
