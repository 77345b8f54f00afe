//! What is said, and the exit codes.

use crate::bench::{Bench, COMMA, CROSSING, SQUARE, TWO};

#[test]
fn a_syntax_error_shows_the_word_to_mend() {
    let bench = Bench::with("syntax", "site.poly", COMMA);
    assert_eq!(
        bench.fails("mesh site.poly -o site.msh", 1),
        "\
error: site.poly:4:7: expected a y coordinate, found `0,0`
  |
4 | 3 1.0 0,0
  |       ^
help: coordinates are separated by spaces
"
    );
}

#[test]
fn crossing_segments_are_both_named() {
    let bench = Bench::with("crossing", "site.poly", CROSSING);
    assert_eq!(
        bench.fails("mesh site.poly -o site.msh", 1),
        "\
error: segments 5 and 6 cross near (0.5, 0.5)
  site.poly:11: 5 1 3
  site.poly:12: 6 2 4
help: `--repair` splits them there; `meshwright draw site.poly -o site.svg` shows the place
"
    );
}

#[test]
fn an_obj_file_that_was_cut_off_names_its_last_line() {
    let cut = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nl 1 2 3\nl 3 4";
    let bench = Bench::with("cut-off", "site.obj", cut);
    assert_eq!(
        bench.fails("mesh site.obj -o site.msh", 1),
        "\
error: the outline encloses nothing: points 1 and 4 are open ends, 4 apart
  site.obj:1: 1 0 0
  site.obj:4: 4 0 4
help: line 6 is the last: is the file whole? `--region hull` meshes the convex hull of the points
"
    );
}

#[test]
fn wrong_values_are_refused_with_the_reason() {
    let bench = Bench::with("usage", "square.poly", SQUARE);
    for (arguments, reason) in [
        ("--min-angle 35", "a minimum angle of 35° is not possible: it must be from 0° to 34°"),
        ("--min-angle 61 --no-guarantee", "it must be from 0° to 60°"),
        ("--min-angle -1", "a minimum angle of -1° is not possible"),
        ("--min-angle 26,4", "this is no finite number"),
        ("--min-angle nan", "this is no finite number"),
        ("--max-area 0", "it must be greater than 0"),
        ("--max-area -2", "it must be greater than 0"),
        ("--max-area inf", "this is no finite number"),
        ("--max-points 2", "2 is not in 3..=4294967295"),
        ("--scale 0", "it must be greater than 0"),
        ("--splitting steps", "[possible values: ladder, shells, augment]"),
        ("--excuse none", "[possible values: measured, midpoints]"),
        ("--steiner centroid", "[possible values: off-center, circumcenter, look-ahead]"),
        ("--rule chew", "[possible values: adaptive, ruppert, terminator]"),
        ("--region box", "[possible values: domain, hull, global]"),
        ("--no-such-flag", "unexpected argument '--no-such-flag'"),
        ("-q -v", "cannot be used with"),
        ("-o square.png", "square.png: its name does not tell the format of a mesh"),
        ("-o square.msh.gz", "compressed files are read, not written"),
        ("-o -", "--to FORMAT says it"),
        ("-o - --to msh --json", "both want stdout"),
        ("-o a.msh -o ./a.msh", "two outputs have one place: a.msh and ./a.msh"),
    ] {
        let said = bench.fails(&format!("mesh square.poly {arguments}"), 2);
        assert!(said.contains(reason), "{arguments}: {said}");
        assert!(said.starts_with("error: "), "{arguments}: {said}");
    }
    assert_eq!(bench.names(), ["square.poly"]);
}

#[test]
fn drawing_has_its_own_refusals() {
    let bench = Bench::with("draw-usage", "square.poly", SQUARE);
    bench.put("two.msh", TWO);
    for (arguments, reason) in [
        ("square.poly", "--output"),
        ("square.poly -o square.png", "square.png: only .svg files are drawn"),
        ("square.poly -o a.svg --box 1,2,3", "a box has four numbers: xmin,ymin,xmax,ymax"),
        ("square.poly -o a.svg --box 0,0,0,1", "the box is empty"),
        ("square.poly -o a.svg --box 0,0,x,1", "this is no finite number"),
        ("square.poly -o a.svg --width 10", "10 is not in 64..=32768"),
        ("square.poly -o a.svg --points some", "[possible values: auto, all, none]"),
        ("square.poly -o a.svg --input square.poly", "--input goes with a mesh"),
        ("two.msh -o a.svg --input two.msh", "two.msh holds a mesh, where an outline is wanted"),
    ] {
        let said = bench.fails(&format!("draw {arguments}"), 2);
        assert!(said.contains(reason), "{arguments}: {said}");
    }
    assert_eq!(bench.names(), ["square.poly", "two.msh"]);
}

#[test]
fn a_file_of_the_wrong_kind_is_refused() {
    let bench = Bench::with("kinds", "square.poly", SQUARE);
    bench.put("two.msh", TWO);
    bench.put("site.dxf", "0\nSECTION\n");
    bench.put("site", SQUARE);
    for (arguments, reason) in [
        ("mesh two.msh", "two.msh holds a mesh, where an outline is wanted (.poly, "),
        (
            "check square.poly",
            "square.poly holds an outline, where a mesh is wanted (.msh, .vtu, .vtk, ",
        ),
        ("info site.dxf", "site.dxf: files that end in .dxf are not read"),
        ("mesh site", "site: its name does not tell its format"),
        ("mesh -", "stdin has no name that tells its format"),
        ("info scene.glb", "scene.glb: files that end in .glb are not read"),
    ] {
        let said = bench.fails(arguments, 2);
        assert!(said.contains(reason), "{arguments}: {said}");
    }
}

#[test]
fn a_name_that_does_not_tell_the_format_is_overridden() {
    let bench = Bench::with("from", "site", SQUARE);
    bench.succeeds("mesh site --from poly -o site.out --to msh");
    bench.put("site.poly", SQUARE);
    bench.succeeds("check site.out --from msh --input site.poly");
}

#[test]
fn the_summary_stands_on_stderr() {
    let bench = Bench::with("summary", "square.poly", SQUARE);
    let ran = bench.succeeds("mesh square.poly -o square.msh -o square.vtu");
    assert_eq!(ran.stdout, "");
    let labels: Vec<&str> =
        ran.stderr.lines().filter_map(|line| line.split_whitespace().next()).collect();
    for label in ["outline", "mesh", "angles", "groups", "certified", "wrote"] {
        assert!(labels.contains(&label), "{label}: {}", ran.stderr);
    }
    assert!(ran.stderr.contains("outline   square.poly: 4 points, 4 segments, 1 region\n"));
    assert!(ran.stderr.contains("certified conforming, Delaunay, every angle accounted for\n"));
    assert!(ran.stderr.contains("wrote     square.msh (Gmsh 2.2, "), "{}", ran.stderr);
}

#[test]
fn quiet_says_nothing() {
    let bench = Bench::with("quiet", "square.poly", SQUARE);
    for arguments in ["mesh square.poly -o a.msh -q", "--quiet check a.msh --input square.poly"] {
        let ran = bench.succeeds(arguments);
        assert_eq!((ran.stdout.as_str(), ran.stderr.as_str()), ("", ""), "{arguments}");
    }
    assert_ne!(bench.fails("mesh -q nowhere.poly", 3), "");
}

#[test]
fn a_pipe_gets_no_colour_and_no_progress() {
    let bench = Bench::with("plain", "square.poly", SQUARE);
    let ran = bench.succeeds("mesh square.poly --max-area 1e-5 -o a.msh");
    assert!(!ran.stderr.contains('\x1b') && !ran.stderr.contains('\r'), "{}", ran.stderr);
    assert!(!bench.fails("mesh --frobnicate", 2).contains('\x1b'));
}

#[test]
fn what_is_merged_is_a_warning_with_its_line() {
    let twice = SQUARE.replace("4 1\n1 1 2 1", "5 1\n5 2 1 1\n1 1 2 1");
    let bench = Bench::with("warning", "square.poly", twice);
    let ran = bench.succeeds("mesh square.poly -o a.msh");
    assert!(ran.stderr.contains("warning: 1 duplicate segment dropped"), "{}", ran.stderr);
    assert!(ran.stderr.contains("square.poly:8: "), "{}", ran.stderr);

    let said = bench.fails("mesh square.poly --strict -o b.msh", 4);
    assert!(said.contains("error: 1 warning, and --strict allows none"), "{said}");
}

#[test]
fn where_doubles_end_is_a_warning_that_names_the_point() {
    // A free point 1e-15 above a side.
    let narrow = "5 2\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 1e-15\n\
                  4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
    let bench = Bench::with("narrow", "narrow.poly", narrow);
    let said = bench.succeeds("mesh narrow.poly").stderr;
    assert!(said.contains("warning: the mesh is limited by precision near point 5\n"), "{said}");
    assert!(said.contains("certified but for places where doubles end:\n"), "{said}");
}

#[test]
fn a_run_ends_before_memory_does() {
    let bench = Bench::with("memory", "square.poly", SQUARE);
    let said = bench.fails("mesh square.poly --max-area 1e-5 --memory 1MB -o a.msh", 4);
    assert!(
        said.contains("stopped at 2 500 points, as many as fit into 1.0 MB (--memory)"),
        "{said}"
    );
    assert!(said.contains("help: a larger --memory"), "{said}");
    let said = bench.fails("mesh square.poly --memory 1kB -o a.msh", 4);
    assert!(said.contains("an outline of 4 points does not fit into 1 kB (--memory)"), "{said}");
    bench.succeeds("mesh square.poly --memory 2GiB");
}

#[test]
fn a_budget_that_is_reached_is_a_promise_not_kept() {
    let bench = Bench::with("budget", "square.poly", SQUARE);
    let said = bench.fails("mesh square.poly --max-area 1e-4 --max-points 50 -o a.msh", 4);
    assert!(said.contains("error: the run stopped at 50 points (--max-points)"), "{said}");
}

#[test]
fn verbose_lists_the_excused_angles() {
    let needle = "3 2\n1 0 0\n2 1 0\n3 1 0.02\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
    let bench = Bench::with("verbose", "needle.poly", needle);
    let short = bench.succeeds("mesh needle.poly").stderr;
    assert!(short.contains("smallest angle 1.15°, between segments 1 and 3 at point 1"), "{short}");
    assert!(!short.contains("which meet at"), "{short}");
    let long = bench.succeeds("mesh needle.poly --verbose").stderr;
    assert!(long.contains("between segments 1 and 3, which meet at 1.15°"), "{long}");
}

#[test]
fn a_planted_fault_is_found_and_named() {
    let bench = Bench::with("fault", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly --max-area 0.02 -o a.msh");
    let ran = bench.succeeds("check a.msh --input square.poly");
    assert!(ran.stdout.contains("conforming    holds"), "{}", ran.stdout);

    let text = String::from_utf8(bench.read("a.msh")).expect("a .msh file is text");
    let moved = text.replacen("\n1 0 0 0\n", "\n1 0 -0.01 0\n", 1);
    assert_ne!(moved, text);
    bench.put("moved.msh", moved);
    let ran = bench.run("check moved.msh --input square.poly");
    assert_eq!(ran.code, Some(4), "{ran:?}");
    assert!(ran.stdout.contains("conforming    FAILS"), "{}", ran.stdout);
    assert!(ran.stdout.contains("point 1 of the outline is missing"), "{}", ran.stdout);
    assert_eq!(bench.run("check moved.msh --input square.poly -q").code, Some(4));
}

#[test]
fn a_lost_second_group_is_found_and_named() {
    let rooms = include_str!("../fixtures/named_rooms.geo");
    let bench = Bench::with("second-group", "rooms.geo", rooms);
    bench.succeeds("mesh rooms.geo -o a.msh -o a.vtu");
    let ran = bench.succeeds("check a.msh --input rooms.geo");
    assert!(ran.stdout.contains("conforming    holds"), "{}", ran.stdout);

    // Group 21, `cold`, is the second one of the right wall; 40, `probe`, holds a point.
    let text = String::from_utf8(bench.read("a.msh")).expect("a .msh file is text");
    for (old, new, lost) in [
        (" 1 2 21 ", " 1 2 3 ", "is not in the group 21 (cold), where the outline puts it"),
        (" 15 2 40 ", " 15 2 41 ", "point 1 is not in the group 40 (probe)"),
    ] {
        let changed = text.replacen(old, new, 1);
        assert_ne!(changed, text);
        bench.put("changed.msh", changed);
        let ran = bench.run("check changed.msh --input rooms.geo -v");
        assert_eq!(ran.code, Some(4), "{ran:?}");
        assert!(ran.stdout.contains(lost), "{}", ran.stdout);
    }

    let ran = bench.succeeds("check a.vtu --input rooms.geo");
    assert!(ran.stdout.contains("groups of points, further groups of edges"), "{}", ran.stdout);
}

#[test]
fn verbose_check_lists_every_fault_and_excused_angle() {
    let needle = "3 2\n1 0 0\n2 1 0\n3 1 0.02\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
    let bench = Bench::with("verbose-check", "needle.poly", needle);
    bench.succeeds("mesh needle.poly -o a.msh");
    let said = bench.succeeds("check a.msh --input needle.poly -v").stdout;
    assert!(said.contains("angles        excused  triangle "), "{said}");
    bench.put("square.poly", SQUARE);
    let ran = bench.run("check a.msh --input square.poly -v");
    assert_eq!(ran.code, Some(4));
    assert!(ran.stdout.matches("conforming    FAILS").count() > 1, "{}", ran.stdout);
}

#[test]
fn without_the_outline_check_says_what_it_did_not_judge() {
    let bench = Bench::with("alone", "two.msh", TWO);
    let said = bench.succeeds("check two.msh").stdout;
    assert!(said.contains("not judged: it needs the outline"), "{said}");
}

#[test]
fn check_takes_the_promise_that_mesh_took() {
    let needle = "3 2\n1 0 0\n2 1 0\n3 1 0.9\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
    let bench = Bench::with("promise", "a.poly", needle);
    bench.succeeds("mesh a.poly --min-angle 5 -o a.msh --region hull");
    bench.succeeds("check a.msh --input a.poly --min-angle 5 --region hull");
}

#[test]
fn lengths_are_multiplied_by_the_scale() {
    let bench = Bench::with("scale", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly --scale 1000 -o a.msh");
    assert!(bench.succeeds("info a.msh").stdout.contains("extent      (0, 0) to (1 000, 1 000)"));
    bench.succeeds("check a.msh --input square.poly --scale 1000");
    assert_eq!(bench.run("check a.msh --input square.poly").code, Some(4));
}

#[test]
fn unique_ids_leave_no_number_to_two_groups() {
    let shared = SQUARE.replace("0.5 0.5 7", "0.5 0.5 1");
    let bench = Bench::with("unique", "square.poly", shared);
    let said = bench.succeeds("mesh square.poly -o a.msh").stderr;
    assert!(
        said.contains("warning: a.msh: number 1 stands for a boundary and for a region"),
        "{said}"
    );
    let said = bench.succeeds("mesh square.poly --unique-ids -o b.msh").stderr;
    assert!(!said.contains("warning"), "{said}");
    assert!(said.contains("note: b.msh: boundary 1 is written as 2"), "{said}");
}

#[test]
fn info_tells_what_an_outline_holds() {
    let bench = Bench::with("info", "square.poly", SQUARE);
    assert_eq!(
        bench.succeeds("info square.poly").stdout,
        "\
file        square.poly: Triangle .poly, one-based, 4 points, 4 segments, 1 region
extent      (0, 0) to (1, 1): doubles resolve 2e-16 here
angles      smallest 90.00° at point 1 (segments 1, 4)
detail      closest pair: points 1 and 4, 1 apart; lfs_min 0.5
groups      boundary 1: 3 segments · boundary 2: 1 segment
outline     ready to mesh
"
    );
}

#[test]
fn info_reports_an_unclean_outline_and_succeeds() {
    let bench = Bench::with("unclean", "site.poly", CROSSING);
    let said = bench.succeeds("info site.poly").stdout;
    let not_ready = "outline     not ready to mesh: segments 5 and 6 cross near (0.5, 0.5)\n";
    assert!(said.contains(not_ready), "{said}");
}

#[test]
fn the_version_is_that_of_the_package() {
    let version = concat!("meshwright ", env!("CARGO_PKG_VERSION"), "\n");
    assert_eq!(Bench::new("version").succeeds("--version").stdout, version);
}

#[test]
fn help_names_every_command_and_exit_code() {
    let help = Bench::new("help").succeeds("--help").stdout;
    for word in ["mesh", "check", "info", "draw", "completions", "man", "130  interrupted"] {
        assert!(help.contains(word), "{word}: {help}");
    }
}

#[test]
fn completions_and_the_manual_page_come_from_the_command() {
    let bench = Bench::new("shell");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = bench.succeeds(&format!("completions {shell}")).stdout;
        assert!(script.contains("--min-angle") || script.contains("min-angle"), "{shell}");
    }
    let page = bench.succeeds("man").stdout;
    assert!(page.contains(".TH meshwright 1") && page.contains("max\\-area"), "{page}");
}
