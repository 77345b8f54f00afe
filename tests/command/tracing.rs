//! Traces and the pictures of their steps.

use std::path::Path;

use serde_json::Value;

use crate::bench::{Bench, SQUARE};
use crate::schema::broken;

const POND: &str = include_str!("../../examples/pond.poly");

/// The same outline, its points counted from 0 and its segments too.
fn pond_from_zero() -> String {
    let mut text = String::new();
    for line in POND.lines().filter(|line| !line.starts_with('#')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let less = |word: &str| (word.parse::<i64>().expect("a number") - 1).to_string();
        let line = match words[..] {
            [number, x, y] if x.contains('.') => format!("{} {x} {y}", less(number)),
            [number, a, b, tag] if number != "13" || b != "0" => {
                format!("{} {} {} {tag}", less(number), less(a), less(b))
            }
            _ => line.to_string(),
        };
        text += &format!("{line}\n");
    }
    text
}

/// The lines of a trace, each judged by the schema.
fn lines(trace: &str) -> Vec<Value> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/schema/trace-1.json");
    let schema = std::fs::read_to_string(file).expect("the schema");
    let schema: Value = serde_json::from_str(&schema).expect("the schema is JSON");
    let judged = |line: &str| {
        let value: Value = serde_json::from_str(line).expect("a line is one object");
        assert_eq!(broken(&schema, &schema, &value, "line"), Vec::<String>::new(), "{line}");
        value
    };
    trace.lines().map(judged).collect()
}

fn count(lines: &[Value], event: &str) -> usize {
    lines.iter().filter(|line| line["event"] == event).count()
}

#[test]
fn thinning_is_not_traced_and_named() {
    let bench = Bench::with("trace-thin", "pond.poly", POND);
    let ran = bench.run("trace pond.poly --thin auto");
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("error: --thin: a trace tells the refinement"), "{}", ran.stderr);
    assert_eq!(bench.names(), ["pond.poly"]);
}

#[test]
fn a_trace_is_as_its_schema_says_and_counts_what_the_mesh_holds() {
    let bench = Bench::with("trace-counts", "pond.poly", POND);
    bench.put("wedge.poly", "3 2\n1 0 0\n2 4 0\n3 4 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    for run in [
        "pond.poly",
        "pond.poly --max-area 0.2",
        "pond.poly --splitting augment --rule terminator",
        "pond.poly --incremental",
        "pond.poly --profile paper --incremental --split augment",
        "pond.poly --region hull --splitting shells --steiner circumcenter",
        "wedge.poly --rule ruppert --max-points 3000",
    ] {
        let lines = lines(&bench.succeeds(&format!("trace {run}")).stdout);
        let report: Value =
            serde_json::from_str(&bench.run(&format!("mesh {run} --json")).stdout).expect("JSON");
        let kinds = &report["mesh"]["points_by_kind"];
        assert_eq!(kinds["circumcenter"], count(&lines, "commit"), "{run}");
        let splits = kinds["shell"].as_u64().zip(kinds["midpoint"].as_u64());
        let splits = splits.map(|(shell, midpoint)| (shell + midpoint) as usize);
        assert_eq!(splits, Some(count(&lines, "split")), "{run}");
        let refused = count(&lines, "refused split") + count(&lines, "refused point");
        assert_eq!(report["refused"], refused, "{run}");
        assert_eq!(lines[0]["event"], "start", "{run}");
        assert_eq!(lines[0]["parameters"], report["parameters"], "{run}");
        let end = lines.last().expect("a last line");
        assert_eq!(end["steps"], lines.len() - 2, "{run}");
        assert_eq!(end["finished"], !report["stopped"].as_bool().expect("yes or no"), "{run}");
        for (line, step) in lines[1..lines.len() - 1].iter().zip(1..) {
            assert_eq!(line["step"], step, "{run}");
        }
    }
}

#[test]
fn a_split_names_the_step_that_rejected_a_point() {
    let bench = Bench::with("trace-rejected", "pond.poly", POND);
    let lines = lines(&bench.succeeds("trace pond.poly").stdout);
    let rejected = lines.iter().filter(|line| line["cause"]["rejected_in"].is_u64());
    let mut splits = 0;
    for split in rejected {
        let step = split["cause"]["rejected_in"].as_u64().expect("a step") as usize;
        assert_eq!(lines[step]["event"], "rejected");
        assert_eq!(lines[step]["triangle"], split["cause"]["triangle"]);
        let named = lines[step]["encroached"].as_array().expect("a list");
        assert!(named.iter().any(|piece| piece["subsegment"] == split["subsegment"]), "{split}");
        splits += 1;
    }
    assert!(splits > 0);
}

#[test]
fn a_trace_counts_as_the_file_does() {
    let bench = Bench::with("trace-numbers", "one.poly", POND);
    bench.put("zero.poly", pond_from_zero());
    let [one, zero] =
        ["one", "zero"].map(|name| lines(&bench.succeeds(&format!("trace {name}.poly")).stdout));
    assert_eq!(one.len(), zero.len());
    assert_eq!((&one[0]["points"][0][0], &zero[0]["points"][0][0]), (&1.into(), &0.into()));
    for (one, zero) in one.iter().zip(&zero) {
        for name in ["point", "segment"] {
            let less = one[name].as_i64().map(|number| number - 1);
            assert_eq!(less, zero[name].as_i64(), "{one} {zero}");
        }
    }
}

#[test]
fn the_same_outline_gives_the_same_trace() {
    let bench = Bench::with("trace-same", "square.poly", SQUARE);
    let piped = bench.succeeds("trace square.poly --max-area 0.01").stdout;
    bench.succeeds("trace square.poly --max-area 0.01 -o square.jsonl");
    assert_eq!(piped.as_bytes(), bench.read("square.jsonl"));
}

#[test]
fn the_picture_in_the_documentation_is_what_its_commands_make() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(root.join("docs/trace.md")).expect("the page");
    let block = page.split("```sh\n").nth(1).and_then(|rest| rest.split("```").next());
    let bench = Bench::new("trace-docs");
    for folder in ["examples", "docs"] {
        std::fs::create_dir(bench.path(folder)).expect("a folder for the test");
    }
    bench.put("examples/pond.poly", POND);
    for command in block.expect("the commands").lines() {
        bench.succeeds(command.strip_prefix("meshwright ").expect("a command of ours"));
    }
    let picture = std::fs::read(root.join("docs/pond_film.svg")).expect("the picture");
    assert!(bench.read("docs/pond_film.svg") == picture, "docs/pond_film.svg is another one");
}

#[test]
fn the_last_step_is_the_mesh() {
    let bench = Bench::with("trace-last", "pond.poly", POND);
    bench.succeeds("trace pond.poly --max-area 0.2 -o pond.jsonl");
    bench.succeeds("mesh pond.poly --max-area 0.2 -o pond.vtu");
    let report = bench.succeeds("info pond.vtu --json").stdout;
    let report: Value = serde_json::from_str(&report).expect("JSON");
    let last = lines(&String::from_utf8(bench.read("pond.jsonl")).expect("UTF-8")).len() - 2;
    let draw = |options: &str| {
        bench.succeeds(&format!("draw --trace pond.jsonl {options} --points all -o -")).stdout
    };
    let svg = draw("");
    assert_eq!(svg, draw(&format!("--step {last}")));
    assert_ne!(svg, draw(&format!("--step {}", last - 1)));
    // A dot for each point is `h0`, and one more for the new point.
    let points = report["mesh"]["points"].as_u64().expect("a count") as usize;
    assert_eq!(svg.matches("h0").count(), points + 1);
    let captions = |svg: &str| svg.matches("text-anchor").count();
    assert_eq!([captions(&draw("--film 3 --columns 2")), captions(&svg)], [3, 1]);
}

#[test]
fn what_is_no_trace_is_refused() {
    let bench = Bench::with("trace-wrong", "square.poly", SQUARE);
    bench.succeeds("trace square.poly --max-area 0.1 -o square.jsonl");
    let said = bench.fails("draw --trace square.jsonl --step 999 -o a.svg", 2);
    assert!(said.contains("--step 999: the last step of the trace is"), "{said}");
    let said = bench.fails("draw --trace square.poly -o a.svg", 1);
    assert!(said.contains("square.poly:1: this is no line of a trace"), "{said}");
    let trace = String::from_utf8(bench.read("square.jsonl")).expect("UTF-8");
    let kept: Vec<&str> = trace.lines().enumerate().filter(|&(i, _)| i != 1).map(|l| l.1).collect();
    bench.put("torn.jsonl", kept.join("\n"));
    let said = bench.fails("draw --trace torn.jsonl -o a.svg", 1);
    assert!(said.starts_with("error: torn.jsonl:"), "{said}");
    bench.put("empty.jsonl", "");
    let said = bench.fails("draw --trace empty.jsonl -o a.svg", 1);
    assert!(said.contains("the trace is empty"), "{said}");
    bench.fails("draw --trace square.jsonl square.poly -o a.svg", 2);
    bench.fails("draw --step 3 square.poly -o a.svg", 2);
    bench.fails("draw -o a.svg", 2);
    let said = bench.fails("draw --trace square.jsonl -o square.jsonl.svg --film 0", 2);
    assert!(said.contains("--film"), "{said}");
    assert_eq!(bench.names(), ["empty.jsonl", "square.jsonl", "square.poly", "torn.jsonl"]);
}
