//! Readers that go away, and interrupts.

use std::io::Read;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::bench::{Bench, SQUARE};

/// Runs with a reader that takes a few bytes of stdout and goes away.
fn cut_short(bench: &Bench, arguments: &str) -> (Option<i32>, String) {
    let mut child = bench.command(arguments).spawn().expect("the command runs");
    let mut stdout = child.stdout.take().expect("stdout is a pipe");
    let mut first = [0; 16];
    stdout.read_exact(&mut first).expect("the first bytes");
    drop(stdout);
    let output = child.wait_with_output().expect("the command ends");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let bench = Bench::with("pipe", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly --max-area 1e-5 -o a.msh");
    for arguments in ["mesh square.poly --max-area 1e-5 -o - --to msh -q", "draw a.msh -o - -q"] {
        assert_eq!(cut_short(&bench, arguments), (Some(0), String::new()), "{arguments}");
    }
}

/// Thinning leaves a whole mesh at any time: an interrupt stops it, and the mesh is written.
#[cfg(unix)]
#[test]
fn an_interrupt_stops_thinning_and_the_mesh_is_written() {
    let bench = Bench::with("interrupt-thinning", "square.poly", SQUARE);
    let is_written = |after: Duration| {
        let mut child = bench
            .command("mesh square.poly --max-area 1e-3 --thin 1000000000000 -o a.msh")
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command runs");
        // An interrupt before the thinning would end the run.
        std::thread::sleep(after);
        let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
        assert!(killed.expect("kill runs").success());
        let mut said = String::new();
        let stderr = child.stderr.take().expect("stderr is a pipe").read_to_string(&mut said);
        stderr.expect("it is text");
        assert_eq!(child.wait().expect("the command ends").code(), Some(130));
        said.contains("error: thinning was interrupted") && bench.names().contains(&"a.msh".into())
    };
    let waits = [1, 4, 16, 64].map(Duration::from_secs);
    assert!(waits.into_iter().any(is_written));
    bench.succeeds("check a.msh --input square.poly");
}

#[cfg(unix)]
#[test]
fn an_interrupt_removes_what_is_half_written() {
    let bench = Bench::with("interrupt", "square.poly", SQUARE);
    let made = Command::new("mkfifo").arg(bench.path("pipe.msh")).status();
    assert!(made.expect("mkfifo runs").success());
    // The first output is written; the second waits for a reader that never comes.
    let mut child = bench
        .command("mesh square.poly -o a.msh -o pipe.msh")
        .stderr(Stdio::null())
        .spawn()
        .expect("the command runs");
    let half_written = || bench.names().iter().any(|name| name.ends_with(".part"));
    let start = Instant::now();
    while !half_written() {
        assert!(start.elapsed() < Duration::from_secs(60), "{:?}", bench.names());
        std::thread::sleep(Duration::from_millis(10));
    }
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(killed.expect("kill runs").success());
    let status = child.wait().expect("the command ends");
    assert_eq!(status.code(), Some(130));
    assert_eq!(bench.names(), ["pipe.msh", "square.poly"]);
}
