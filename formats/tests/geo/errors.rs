//! What is refused: the place and the words.

use super::{SQUARE, error};

/// Scripts and the first lines of their errors.
fn refused(cases: &[(&str, &str)]) {
    for (script, message) in cases {
        assert_eq!(error(script), *message, "{script}");
    }
}

#[test]
fn syntax_errors_name_what_is_missing() {
    refused(&[
        ("Line(4) = {4,1}\nLine(5) = {2,3};", "1:16: expected `;`, found the end of the line"),
        ("Point(1) = {0, 0, 0;", "1:20: expected `,` or `}`, found `;`"),
        ("Point(1) = ;", "1:12: expected an expression, found `;`"),
        ("Point(1) {0, 0, 0};", "1:10: expected `=`, found `{`"),
        ("x = 1 + ;", "1:9: expected an expression, found `;`"),
        ("x = (1;", "1:7: expected `)`, found `;`"),
        ("x = 1e400;", "1:5: expected a finite number (the largest is 1.797e308), found `1e400`"),
        ("\nPrintf(\"a);", "2:8: expected a text that ends with `\"`, found `\"`"),
        ("/* never", "1:1: expected a comment that ends with `*/`, found `/`"),
        ("For i In {1} EndFor", "1:11: expected a range such as `1:10`, found `1`"),
        ("EndIf", "1:1: expected a statement (nothing is open that this would end), found `EndIf`"),
        ("@", "1:1: expected a statement, found `@`"),
    ]);
}

#[test]
fn a_block_that_never_ends_is_named_where_it_begins() {
    let rest = "which is missing or stands in another block";
    for (script, what) in [
        ("\nIf (1)\nx = 1;", "2:1: expected `If` with its `EndIf`, {}, found `If`"),
        ("For i In {1:2}\nx = 1;", "1:1: expected `For` with its `EndFor`, {}, found `For`"),
        ("Macro M\nx = 1;", "1:1: expected `Macro` with its `Return`, {}, found `Macro`"),
        ("If (1)\nFor (1:2)\nEndIf", "2:1: expected `For` with its `EndFor`, {}, found `For`"),
    ] {
        assert_eq!(error(script), what.replace("{}", rest));
    }
}

#[test]
fn values_that_do_not_exist_are_named() {
    refused(&[
        ("x = y + 1;", "1:5: there is no variable `y`"),
        ("x += 1;", "1:1: there is no variable `x`"),
        ("Call Missing;", "1:1: there is no macro Missing"),
        (
            "a[] = {1, 2};\nx = a[2];",
            "2:7: `a` has 2 elements: there is none at 2 (the first is at 0)",
        ),
        ("a[] = {};\nx = a;", "2:5: `a` has 0 elements: there is none at 0 (the first is at 0)"),
        ("Line(1) = {1, 2};", "1:1: there is no point 1"),
        ("Curve Loop(1) = {5};", "1:1: there is no curve 5"),
        ("Plane Surface(1) = {-5};", "1:1: there is no curve loop -5"),
        ("Translate {1, 0, 0} { Surface{3}; }", "1:1: there is no surface 3"),
        (
            "x = Mesh.Nonsense;",
            "1:5: there is no option `Mesh.Nonsense` that matters to a plane mesh",
        ),
    ]);
}

#[test]
fn operations_without_a_number_are_named() {
    refused(&[
        ("x = 1/0;", "1:5: 1 / 0 gives no finite number"),
        ("x = Sqrt(-1);", "1:5: Sqrt(-1) gives no finite number"),
        ("x = 9^9^9^9;", "1:7: 9 ^ 387420489 gives no finite number"),
        ("x = \"a\" + 1;", "1:5: expected a number, found a text"),
        ("x = Sin(1, 2);", "1:5: a function takes one number, not 2"),
        ("Point(1.5) = {0, 0, 0};", "1:7: the number of an entity must be a whole number, not 1.5"),
        ("Point(1) = {0};", "1:1: Point takes three or four numbers, not 1"),
        ("Circle(1) = {1, 2};", "1:1: Circle takes two ends and the centre between them, not 2"),
        ("x = {1, \"a\"};", "1:5: expected a list of numbers or a list of texts, found both"),
    ]);
}

#[test]
fn curves_that_their_points_do_not_define_are_named() {
    let points = "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nPoint(3) = {0, 1.1, 0};\n";
    for (curve, message) in [
        ("Circle(1) = {2, 1, 1};", "4:1: curve 1: the arc ends in its own centre"),
        (
            "Circle(1) = {2, 1, 3};",
            "4:1: curve 1: the ends of the arc are 1 and 1.1 away from its centre",
        ),
        ("Spline(1) = {1};", "4:1: a curve takes two points or more, not 1"),
    ] {
        assert_eq!(error(&format!("{points}{curve}")), message);
    }
    let occ = "SetFactory(\"OpenCASCADE\");\nDisk(1) = {0, 0, 0, -1};";
    assert_eq!(error(occ), "2:1: curve 1: a radius must be positive, not -1");
}

#[test]
fn surfaces_with_a_fault_are_named() {
    let open = SQUARE.replace("{1, 2, 3, 4};\nPlane", "{1, 2, 3};\nPlane");
    assert_eq!(error(&open), "10:1: surface 1: its boundary is open at point 1");
    let outside = format!(
        "{SQUARE}Point(11) = {{5, 5, 0}}; Point(12) = {{6, 5, 0}}; Point(13) = {{6, 6, 0}};\n\
         Line(11) = {{11, 12}}; Line(12) = {{12, 13}}; Line(13) = {{13, 11}};\n\
         Line Loop(2) = {{11:13}};\nPlane Surface(2) = {{1, 2}};"
    );
    assert_eq!(error(&outside), "14:1: surface 2: loop 2 lies outside of loop 1");
    let overlap = format!(
        "{SQUARE}Point(5) = {{.5, 0, 0}}; Point(6) = {{1.5, 0, 0}}; Point(7) = {{1.5, 1, 0}};\n\
         Point(8) = {{.5, 1, 0}};\nLine(5) = {{5, 6}}; Line(6) = {{6, 7}}; Line(7) = {{7, 8}};\n\
         Line(8) = {{8, 5}};\nLine Loop(2) = {{5:8}};\nPlane Surface(2) = {{2}};"
    );
    let message = error(&overlap);
    assert!(message.starts_with("16:1: surface 2 overlaps surface 1 (line 10) near"), "{message}");
    assert_eq!(error("x = 1;\n\n"), "1:7: the script makes no surface: there is nothing to mesh");
}

#[test]
fn an_entity_is_not_made_twice() {
    let script = format!("{SQUARE}Point(2) = {{5, 5, 0}};");
    assert_eq!(error(&script), "11:1: point 2 exists already (line 2)");
}

#[test]
fn what_no_plane_has_is_refused_by_name() {
    let subset = "help: read are points, lines, arcs";
    for (statement, name) in [
        ("Volume(1) = {1};", "Volume"),
        ("Surface Loop(1) = {1};", "Surface Loop"),
        ("Box(1) = {0, 0, 0, 1, 1, 1};", "Box"),
        ("v[] = Affine{ {1, 0, 0} }{ Surface{1}; };", "Affine"),
        ("SystemCall \"rm -rf x\";", "SystemCall"),
        ("Compound Surface(3) = {1, 2};", "Compound Surface"),
    ] {
        let error = meshwright_formats::geo::read(
            statement.as_bytes(),
            "part.geo",
            meshwright_formats::geo::no_includes,
        );
        let error = error.expect_err(statement).to_string();
        assert!(error.contains(&format!("`{name}` is not read")), "{error}");
        assert!(error.contains(subset), "{error}");
    }
    let netgen = "algebraic3d\nsolid cube = orthobrick (0, 0, 0; 1, 1, 1);\ntlo cube;";
    assert_eq!(error(netgen), "1:1: this is a geometry of Netgen, no script of Gmsh");
}

#[test]
fn the_script_may_give_up_by_itself() {
    let raised = "If (2 > 1)\n Error(\"no more than %g\", 1);\nEndIf";
    assert_eq!(error(raised), "2:2: the script stops with `no more than 1`");
    assert_eq!(error("Abort;"), "1:1: the script stops with `Abort`");
}

#[test]
fn endless_and_hostile_scripts_end_in_an_error() {
    let deep = format!("x = {}1;", "(".repeat(100_000));
    assert!(error(&deep).contains("at most 100 levels"));
    let deep = "If(1)\n".repeat(20_000);
    assert!(error(&deep).contains("at most 100 levels"));
    assert!(error(&format!("x = {}1;", "-".repeat(100_000))).contains("at most 100 levels"));
    assert!(error("For i In {1:2:0}\nEndFor").ends_with("this loop never ends: its step is 0"));
    assert!(
        error("For i In {1e300:2e300}\nEndFor").ends_with("this loop never ends: its step is 0")
    );
    let limit = "this script is too much";
    for script in [
        "Macro M\nCall M;\nReturn\nCall M;",
        "For i In {1:1e5}\nFor j In {1:1e5}\nEndFor\nEndFor",
        "l[] = {1:1e15};",
        "l[1e9] = 1;",
        "l[] = {1};\nFor i In {1:60}\nl[] = {l[], l[]};\nEndFor",
        "t = \"a\";\nFor i In {1:60}\nt = StrCat(t, t);\nEndFor",
        "l[] = LinSpace[0, 1, 1e9];",
    ] {
        assert!(error(script).contains(limit), "{script}: {}", error(script));
    }
    let tiny =
        SQUARE.replace("Line(1) = {1, 2};", "Point(9) = {0.5, 0, 0}; Circle(1) = {1, 9, 2};");
    let tiny = tiny.replace("0.5}", "1e-12}");
    assert!(error(&tiny).contains("a curve has more than 10 million pieces at its size"));
}
