//! What is read and written, and what is left alone.

use std::io::Write;

use flate2::{Compression, write::GzEncoder};

use crate::bench::{Bench, COMMA, CROSSING, SQUARE};

#[test]
fn several_outputs_come_from_one_run() {
    let bench = Bench::with("several", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly -o a.msh -o a.vtu -o a.glb --max-area 0.01");
    assert_eq!(bench.names(), ["a.glb", "a.msh", "a.vtu", "square.poly"]);
    for mesh in ["a.msh", "a.vtu"] {
        bench.succeeds(&format!("check {mesh} --input square.poly"));
    }
    assert!(bench.read("a.glb").starts_with(b"glTF"));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let bench = Bench::with("same", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly --max-area 0.003 -o a.msh -o a.vtu -o a.glb");
    bench.succeeds("mesh square.poly --max-area 0.003 -o b.msh -o b.vtu -o b.glb");
    for end in ["msh", "vtu", "glb"] {
        assert_eq!(bench.read(&format!("a.{end}")), bench.read(&format!("b.{end}")), "{end}");
    }
}

#[test]
fn pipes_carry_what_files_do() {
    let bench = Bench::with("pipes", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly -o a.msh");
    let piped = bench.run_with("mesh - --from poly -o - --to msh", SQUARE.as_bytes());
    assert_eq!(piped.status.code(), Some(0));
    assert!(piped.stdout == bench.read("a.msh"), "stdout holds the file's bytes");

    let checked = bench.run_with("check - --from msh --input square.poly", &piped.stdout);
    assert_eq!(checked.status.code(), Some(0));
}

#[test]
fn messages_about_stdin_have_its_line() {
    let bench = Bench::new("stdin-lines");
    let output = bench.run_with("mesh - --from poly", COMMA.as_bytes());
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stderr.starts_with(b"error: -:4:7: expected a y coordinate"));
}

#[test]
fn compressed_files_are_read() {
    let mut packed = GzEncoder::new(Vec::new(), Compression::default());
    packed.write_all(SQUARE.as_bytes()).expect("a Vec takes everything");
    let packed = packed.finish().expect("a Vec takes everything");
    let bench = Bench::with("gz", "square.poly.gz", &packed);
    bench.put("square.poly", SQUARE);
    bench.succeeds("mesh square.poly.gz -o a.msh");
    bench.succeeds("mesh square.poly -o b.msh");
    assert!(bench.read("a.msh") == bench.read("b.msh"), "both are the same mesh");

    bench.put("short.poly.gz", &packed[..packed.len() / 2]);
    let said = bench.fails("mesh short.poly.gz -o c.msh", 1);
    assert!(said.starts_with("error: short.poly.gz: this is no whole gzip file"), "{said}");
}

#[test]
fn the_node_file_beside_a_poly_file_is_found() {
    let bench = Bench::new("node");
    std::fs::create_dir(bench.path("in")).expect("a folder");
    bench.put("in/site.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
    bench.put("in/site.poly", "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    bench.succeeds("mesh in/site.poly -o a.msh");
    bench.succeeds("info in/site.node");

    std::fs::remove_file(bench.path("in/site.node")).expect("a file to remove");
    let said = bench.fails("mesh in/site.poly -o b.msh", 1);
    assert!(said.contains("in/site.node"), "{said}");
}

#[test]
fn nothing_is_left_after_an_error() {
    let bench = Bench::with("nothing", "site.poly", CROSSING);
    bench.put("comma.poly", COMMA);
    bench.put("square.poly", SQUARE);
    bench.put("old.msh", "old");
    bench.fails("mesh site.poly -o a.msh -o old.msh", 1);
    bench.fails("mesh comma.poly -o a.msh -o old.msh", 1);
    bench.fails("mesh nowhere.poly -o a.msh -o old.msh", 3);
    bench.fails("mesh square.poly -o a.msh -o old.msh -o nowhere/a.vtu", 3);
    bench.fails("draw comma.poly -o a.svg", 1);
    assert_eq!(bench.names(), ["comma.poly", "old.msh", "site.poly", "square.poly"]);
    assert_eq!(bench.read("old.msh"), b"old");
}

#[test]
fn what_cannot_be_read_or_written_is_named() {
    let bench = Bench::with("io", "square.poly", SQUARE);
    std::fs::create_dir(bench.path("folder.msh")).expect("a folder");
    for (arguments, said) in [
        ("mesh nowhere.poly", "error: nowhere.poly: no such file or directory\n"),
        ("mesh square.poly -o no/a.msh", "error: no: no such file or directory\n"),
        ("mesh square.poly -o square.poly/a.msh", "error: square.poly: not a directory\n"),
        ("mesh square.poly -o folder.msh", "error: folder.msh: is a directory\n"),
        ("check nowhere.msh", "error: nowhere.msh: no such file or directory\n"),
    ] {
        assert_eq!(bench.fails(arguments, 3), said, "{arguments}");
    }
}

#[test]
fn an_output_that_is_the_input_is_refused() {
    let bench = Bench::new("same-file");
    bench.put("site.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
    bench.put("site.msh", SQUARE);
    bench.put("site.poly", "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    std::fs::hard_link(bench.path("site.msh"), bench.path("hard.msh")).expect("a link");
    for arguments in ["-o site.msh", "-o ./site.msh", "-o a.vtu -o hard.msh"] {
        let said = bench.fails(&format!("mesh site.msh --from poly {arguments}"), 2);
        assert!(said.contains("is the input site.msh: it would be overwritten"), "{said}");
    }
    std::fs::hard_link(bench.path("site.node"), bench.path("node.msh")).expect("a link");
    let said = bench.fails("mesh site.poly -o node.msh", 2);
    assert!(said.contains("is the input site.node"), "{said}");
    assert_eq!(bench.names(), ["hard.msh", "node.msh", "site.msh", "site.node", "site.poly"]);
}

#[cfg(unix)]
mod special {
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::Command;

    use crate::bench::{Bench, SQUARE};

    #[test]
    fn devices_are_written_to_directly() {
        let bench = Bench::with("devices", "square.poly", SQUARE);
        bench.succeeds("mesh square.poly -o /dev/null --to msh -o /dev/null");
        let ran = bench.succeeds("mesh square.poly -o /dev/stdout --to msh");
        assert!(ran.stdout.starts_with("$MeshFormat\n"));
        assert_eq!(bench.names(), ["square.poly"]);
    }

    #[test]
    fn a_full_device_is_an_error_of_output() {
        let bench = Bench::with("full", "square.poly", SQUARE);
        let said = bench.fails("mesh square.poly -o /dev/full --to msh", 3);
        assert!(said.contains("error: /dev/full: no space left on device"), "{said}");
    }

    #[test]
    fn a_link_stays_a_link() {
        let bench = Bench::with("link", "square.poly", SQUARE);
        bench.put("real.msh", "old");
        symlink("real.msh", bench.path("link.msh")).expect("a link");
        symlink("new.vtu", bench.path("link.vtu")).expect("a link");
        bench.succeeds("mesh square.poly -o link.msh -o link.vtu");
        assert!(bench.path("link.msh").is_symlink() && bench.path("link.vtu").is_symlink());
        assert!(bench.read("real.msh").starts_with(b"$MeshFormat"));
        assert!(bench.read("new.vtu").starts_with(b"<?xml") || !bench.read("new.vtu").is_empty());
    }

    #[test]
    fn an_output_that_links_to_the_input_is_refused() {
        let bench = Bench::with("link-input", "square.poly", SQUARE);
        symlink("square.poly", bench.path("link.msh")).expect("a link");
        let said = bench.fails("mesh square.poly -o link.msh", 2);
        assert!(said.contains("link.msh is the input square.poly"), "{said}");
        assert_eq!(bench.read("square.poly"), SQUARE.as_bytes());
    }

    #[test]
    fn a_replaced_file_keeps_its_permissions() {
        let bench = Bench::with("modes", "square.poly", SQUARE);
        bench.put("a.msh", "old");
        let mode = std::fs::Permissions::from_mode(0o640);
        std::fs::set_permissions(bench.path("a.msh"), mode).expect("permissions");
        bench.succeeds("mesh square.poly -o a.msh");
        let found = std::fs::metadata(bench.path("a.msh")).expect("the output");
        assert_eq!(found.permissions().mode() & 0o777, 0o640);
    }

    #[test]
    fn a_named_pipe_gets_the_mesh() {
        let bench = Bench::with("fifo", "square.poly", SQUARE);
        let made = Command::new("mkfifo").arg(bench.path("pipe.msh")).status();
        assert!(made.expect("mkfifo runs").success());
        let path = bench.path("pipe.msh");
        let reader = std::thread::spawn(move || std::fs::read(path).expect("the pipe is read"));
        bench.succeeds("mesh square.poly -o pipe.msh -o a.msh");
        assert!(reader.join().expect("the reader ends") == bench.read("a.msh"));
    }
}

#[test]
fn a_mesh_that_is_not_judged_is_the_same_mesh_and_says_so() {
    let bench = Bench::with("unjudged", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly --max-area 0.01 -o a.vtu");
    let told = bench.succeeds("mesh square.poly --max-area 0.01 -o b.vtu --unjudged --json");
    assert!(bench.read("a.vtu") == bench.read("b.vtu"), "both are the same mesh");
    assert!(told.stdout.contains("\"holds\":false"), "{told:?}");
    bench.succeeds("check b.vtu --input square.poly");
    // There is no verdict to write.
    bench.fails("mesh square.poly --unjudged --certificate c.json", 2);
}

#[test]
fn what_a_run_did_is_told_on_request() {
    let bench = Bench::with("stats", "square.poly", SQUARE);
    let told = bench.succeeds("mesh square.poly --max-area 0.01 --stats").stderr;
    assert!(told.contains("work      ") && told.contains("taken from the queue"), "{told}");
}
