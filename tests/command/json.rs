//! `--json`: what it prints is what `docs/schema/` says.

use serde_json::Value;

use crate::bench::{Bench, CROSSING, Ran, SQUARE, TWO};
use crate::schema::broken;

/// The object on stdout, judged by the schema.
fn report(ran: &Ran) -> Value {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/schema/report-1.json");
    let schema = std::fs::read_to_string(file).expect("the schema");
    let schema: Value = serde_json::from_str(&schema).expect("the schema is JSON");
    let report: Value = serde_json::from_str(&ran.stdout).expect("stdout is one object");
    assert_eq!(broken(&schema, &schema, &report, "report"), Vec::<String>::new());
    report
}

#[test]
fn mesh_reports_as_the_schema_says() {
    let bench = Bench::with("json-mesh", "square.poly", SQUARE);
    let ran = bench.succeeds("mesh square.poly --json -o a.msh -o a.vtu --max-area 0.01");
    let report = report(&ran);
    assert_eq!(report["command"], "mesh");
    assert_eq!(report["outline"]["segments"], 4);
    assert_eq!(report["certificate"]["holds"], true);
    assert_eq!(report["outputs"][1]["bytes"], bench.read("a.vtu").len());
    assert_eq!(report["exit"], 0);
    let kinds = report["mesh"]["points_by_kind"].as_object().expect("the kinds are known");
    let sum: u64 = kinds.values().filter_map(Value::as_u64).sum();
    assert_eq!(report["mesh"]["points"], sum);
}

#[test]
fn a_run_that_breaks_its_promise_reports_it() {
    let bench = Bench::with("json-budget", "square.poly", SQUARE);
    let ran = bench.run("mesh square.poly --json --max-area 1e-4 --max-points 50");
    assert_eq!(ran.code, Some(4));
    let report = report(&ran);
    assert_eq!((&report["stopped"], &report["exit"]), (&true.into(), &4.into()));
}

#[test]
fn thinning_is_reported_as_the_schema_says() {
    let bench = Bench::with("json-thin", "square.poly", SQUARE);
    let run = |thin: &str| {
        report(&bench.succeeds(&format!("mesh square.poly --max-area 0.01 --json {thin}")))
    };
    let (none, some, auto) = (run("--thin 0"), run("--thin 500"), run("--thin auto"));
    assert_eq!((&none["thinned"], &none["parameters"]["thin"]), (&Value::Null, &0.into()));
    assert_eq!(
        (&some["thinned"]["tries"], &some["parameters"]["thin"]),
        (&500.into(), &500.into())
    );
    assert_eq!(auto["parameters"]["thin"], "auto");
    let points = |report: &Value| report["mesh"]["points"].as_u64().expect("a count");
    let saved = some["thinned"]["saved"].as_u64().expect("a count");
    assert!(saved > 0);
    assert_eq!(points(&none) - points(&some), saved);
    assert_eq!(bench.run("mesh square.poly --thin often").code, Some(2));
}

#[test]
fn the_report_holds_no_clock() {
    let bench = Bench::with("json-same", "square.poly", SQUARE);
    let run = || bench.succeeds("mesh square.poly --json --max-area 0.01").stdout;
    assert_eq!(run(), run());
}

#[test]
fn a_needle_at_the_end_of_doubles_is_reported_as_the_schema_says() {
    // Two segments at 1e-9 rad, slanted so that nothing is exact.
    let needle = "7 2\n1 0 0\n2 0.955336489125606 0.29552020666133955\n3 0.7929292857289711 0.24528177232184115\n\
                  4 -1 -1\n5 2 -1\n6 2 2\n7 -1 2\n\
                  6 0\n1 1 2\n2 1 3\n3 4 5\n4 5 6\n5 6 7\n6 7 4\n0\n";
    let bench = Bench::with("json-needle", "needle.poly", needle);
    let report = report(&bench.succeeds("mesh needle.poly --json"));
    assert_eq!(report["certificate"]["limited_by_precision"], true);
    assert_eq!(report["certificate"]["apexes"][0]["point"], 1);
    assert_eq!(bench.run("mesh needle.poly --strict").code, Some(4));
}

#[test]
fn check_reports_as_the_schema_says() {
    let bench = Bench::with("json-check", "two.msh", TWO);
    bench.put("square.poly", SQUARE);
    let alone = report(&bench.succeeds("check two.msh --json"));
    assert_eq!(alone["certificate"]["theta_star"], Value::Null);

    let ran = bench.run("check two.msh --input square.poly --json");
    assert_eq!(ran.code, Some(4), "the tags differ: {ran:?}");
    let report = report(&ran);
    assert_eq!(report["certificate"]["holds"], false);
    assert_eq!(report["certificate"]["guarantees"][3]["verdict"], "fails");
}

#[test]
fn info_reports_as_the_schema_says() {
    let bench = Bench::with("json-info", "square.poly", SQUARE);
    bench.put("two.msh", TWO);
    bench.put("site.poly", CROSSING);
    let clean = report(&bench.succeeds("info square.poly --json"));
    assert_eq!(clean["outline"]["ready"], true);
    assert_eq!(clean["outline"]["area"], 1.0);
    let unclean = report(&bench.succeeds("info site.poly --json"));
    assert_eq!(unclean["outline"]["ready"], false);
    assert_eq!(unclean["outline"]["places"][0][0], 0.5);
    assert_eq!(report(&bench.succeeds("info two.msh --json"))["mesh"]["triangles"], 2);

    bench.put("lone.poly", SQUARE.replace("0.5 0.5 7 -1", "0.5 0.5 7"));
    let warned = report(&bench.succeeds("info lone.poly --json"));
    assert_eq!(warned["warnings"].as_array().map(Vec::len), Some(1));
}

#[test]
fn what_was_mended_is_reported_as_the_schema_says() {
    let bench = Bench::with("json-repair", "site.poly", CROSSING);
    let ran = bench.succeeds(
        "mesh site.poly --repair -o a.vtu --certificate a.json --write-repaired b.poly --json",
    );
    let meshed = report(&ran);
    let mended = serde_json::json!([{
        "kind": "crossing",
        "points": [5],
        "segments": [5, 6],
        "place": [0.5, 0.5],
        "distance": null,
        "lines": [["site.poly", 11], ["site.poly", 12]],
    }]);
    assert_eq!(meshed["repair"], serde_json::json!({ "tolerance": 0.0, "mended": mended }));
    assert_eq!(meshed["outputs"][1]["file"], "b.poly");

    let file = String::from_utf8(bench.read("a.json")).expect("JSON is UTF-8");
    let file = report(&Ran { stdout: file, ..bench.succeeds("--version") });
    assert_eq!(file["repair"]["tolerance"], 0.0);
    let checked =
        report(&bench.succeeds("check a.vtu --input site.poly --certificate a.json --json"));
    assert_eq!(checked["repair"]["mended"], mended);
    let told = report(&bench.succeeds("info site.poly --repair --json"));
    assert_eq!((&told["repair"]["mended"], &told["outline"]["ready"]), (&mended, &true.into()));
    let plain = report(&bench.succeeds("check a.vtu --input b.poly --json"));
    assert_eq!(plain["repair"], Value::Null);
}

#[test]
fn the_schema_judge_finds_what_breaks_a_schema() {
    let schema: Value = serde_json::json!({
        "type": "object",
        "additionalProperties": false,
        "required": ["a"],
        "properties": {
            "a": { "type": "integer", "minimum": 0 },
            "b": { "type": ["array", "null"], "items": { "enum": [1, 2] }, "maxItems": 2 },
            "c": { "oneOf": [{ "const": 1 }, { "const": 2 }] },
        },
    });
    let faults = |value: &Value| broken(&schema, &schema, value, "x").len();
    assert_eq!(faults(&serde_json::json!({ "a": 1, "b": [1, 2], "c": 2 })), 0);
    for wrong in [
        serde_json::json!({}),
        serde_json::json!([]),
        serde_json::json!({ "a": -1 }),
        serde_json::json!({ "a": 1.5 }),
        serde_json::json!({ "a": 1, "d": 1 }),
        serde_json::json!({ "a": 1, "b": [3] }),
        serde_json::json!({ "a": 1, "b": [1, 1, 1] }),
        serde_json::json!({ "a": 1, "c": 3 }),
    ] {
        assert_ne!(faults(&wrong), 0, "{wrong}");
    }
}

#[test]
fn a_certificate_file_is_what_the_schema_says_and_check_judges_by_it() {
    let bench = Bench::with("json-certificate", "square.poly", SQUARE);
    bench.succeeds(
        "mesh square.poly -o a.vtu --certificate a.json --min-angle 20 --region hull --scale 3 -q",
    );
    let file = String::from_utf8(bench.read("a.json")).expect("JSON is UTF-8");
    let file = report(&Ran { stdout: file, ..bench.succeeds("--version") });
    assert_eq!(file["scale"], 3.0);
    assert_eq!(file["parameters"]["plain"], true);
    assert_eq!(file["certificate"]["corollary_2"]["lfs_min"], 1.5);

    let ran = bench.succeeds("check a.vtu --input square.poly --certificate a.json --json");
    let checked = report(&ran);
    let [checked, written] = [&checked["certificate"], &file["certificate"]];
    for what in ["guarantees", "points_by_kind", "theta_star", "excused"] {
        assert_eq!(checked[what], written[what], "{what}");
    }
    for what in ["region", "excuse", "plain"] {
        assert_eq!(checked["promise"][what], written["promise"][what], "{what}");
    }
    assert_eq!(checked["promise"]["region"], "hull");
    let degrees = checked["promise"]["min_angle"].as_f64().expect("a number");
    assert!((degrees - 20.0).abs() < 1e-12, "{degrees}");
    let ran = bench.run("check a.vtu --input square.poly");
    assert_eq!(ran.code, Some(4), "without the scale it is no mesh of the outline");
}

#[test]
fn what_is_no_certificate_is_told_so() {
    let bench = Bench::with("no-certificate", "square.poly", SQUARE);
    bench.succeeds("mesh square.poly -o a.vtu -q");
    let said = bench.run("check a.vtu --input square.poly --certificate square.poly");
    assert_eq!(said.code, Some(1));
    assert!(said.stderr.contains("square.poly: this is no JSON"), "{}", said.stderr);
    let both = bench.run("check a.vtu --certificate a.json --min-angle 20");
    assert_eq!(both.code, Some(2), "the angle is either given or in the file");
    let stdout = bench.run("mesh square.poly --certificate -");
    assert_eq!(stdout.code, Some(2));
}

#[test]
fn a_target_above_what_is_promised_is_aimed_at_by_look_ahead() {
    let bench = Bench::with("json-target", "square.poly", SQUARE);
    for (options, expected) in [
        ("--min-angle 33", "look-ahead"),
        ("--min-angle 33 --steiner off-center", "off-center"),
        ("--min-angle 26", "off-center"),
        ("--min-angle 33 --profile paper", "circumcenter"),
    ] {
        let told = report(&bench.succeeds(&format!("mesh square.poly --json {options}")));
        assert_eq!(told["parameters"]["steiner"], expected, "{options}");
    }
}
