//! Variables, expressions, texts, branches, loops, macros, included files.

use std::io;

use meshwright_formats::geo;

use super::{SQUARE, error, error_with, read, value, value_after};

#[test]
fn numbers_are_read_in_all_their_spellings() {
    for (text, number) in [("1", 1.0), (".5", 0.5), ("2.", 2.0), ("1.e-1", 0.1), ("1.5D+1", 15.0)] {
        assert_eq!(value(text), number, "{text}");
    }
}

#[test]
fn operators_bind_as_in_gmsh() {
    for (text, number) in [
        ("1 + 2*3", 7.0),
        ("(1 + 2)*3", 9.0),
        ("7 - 2 - 1", 4.0),
        ("2^3^2", 512.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("7 % 4", 3.0),
        ("1 + 2 < 4", 1.0),
        ("1 < 2 && 2 < 1", 0.0),
        ("0 || 3 == 3", 1.0),
        ("!1 + 2", 2.0),
        ("1 != 1 ? 5 : 2 > 1 ? 6 : 7", 6.0),
        ("+3 - -2", 5.0),
        ("Pi", std::f64::consts::PI),
    ] {
        assert_eq!(value(text), number, "{text}");
    }
}

#[test]
fn functions_take_both_kinds_of_brackets() {
    for (text, number) in [
        ("Sqrt(16)", 4.0),
        ("Sqrt[16]", 4.0),
        ("Fabs(-2)", 2.0),
        ("Floor(-1.5)", -2.0),
        ("Ceil(1.2)", 2.0),
        ("Round(2.5)", 3.0),
        ("Fmod(7.5, 2)", 1.5),
        ("Hypot(3, 4)", 5.0),
        ("Atan2(0, 1)", 0.0),
        ("Max(1, 4, 2) + Min(3, 2)", 6.0),
        ("Exp(0) + Log(1) + Cos(0)", 2.0),
        ("Sign(-3) + Sign(0)", -1.0),
    ] {
        assert_eq!(value(text), number, "{text}");
    }
    assert_eq!(value("Sin(Pi/6)"), libm::sin(std::f64::consts::PI / 6.0));
}

#[test]
fn variables_are_changed_by_all_assignments() {
    assert_eq!(value_after("a = 2; a += 3; a *= 4; a -= 2; a /= 6;", "a"), 3.0);
    assert_eq!(value_after("a = 2; a++; a++; a--;", "a"), 3.0);
    assert_eq!(value_after("a = 2; b = a++;", "a + b"), 6.0);
    assert_eq!(value_after("For i In {1:2} x~{i} = 10*i; EndFor", "x_1 + x~{2}"), 30.0);
    assert_eq!(value_after("a = 4; b = Exists(a) + Exists(c);", "b"), 1.0);
}

#[test]
fn lists_hold_ranges_and_other_lists() {
    assert_eq!(value_after("l[] = {1, 3:5, 9:5:-2};", "#l[]"), 7.0);
    assert_eq!(value_after("l[] = {1, 3 ... 5};", "l[3]"), 5.0);
    assert_eq!(value_after("l() = {5, 6}; m[] = {l(), l[]};", "#m[] + m(1)"), 10.0);
    assert_eq!(value_after("l[] = {5}; l[] += {6, 7}; l[] -= 6;", "#l() + l[1]"), 9.0);
    assert_eq!(value_after("l[2] = 4; l[0] = 1;", "l[0] + l[1] + l[2]"), 5.0);
    assert_eq!(
        value_after("l[] = {1:9}; m[] = l[{2:4}]; m[{0, 1}] = {7, 8};", "m[0] + m[2]"),
        12.0
    );
    assert_eq!(value_after("l[] = {1, 2}; m[] = -l[]; n[] = 2*l[];", "m[1] + n[1]"), 2.0);
    assert_eq!(value_after("l[] = LinSpace[0, 1, 5];", "l[3]"), 0.75);
    assert_eq!(value_after("l[] = Unique({3, 1, 3});", "#l[] + l[0]"), 3.0);
}

#[test]
fn a_lists_name_alone_is_its_first_element() {
    assert_eq!(value_after("l[] = {5, 6};", "l"), 5.0);
}

#[test]
fn texts_are_joined_and_formatted() {
    let name = |expression: &str| {
        let script =
            format!("{SQUARE}t = \"side\"; n = 3;\nPhysical Surface({expression}, 4) = {{1}};");
        read(&script).groups[0].name.clone()
    };
    assert_eq!(name("\"a b\""), "a b");
    assert_eq!(name("StrCat(t, \"/\", \"x\")"), "side/x");
    assert_eq!(name("Sprintf(\"fin_%g\", n)"), "fin_3");
    assert_eq!(
        name("Sprintf(\"%03g|%5.2f|%-4g|%e|%g\", 7, 1.005, n, 1.5, 1e20)"),
        "007| 1.00|3   |1.500000e+00|1e+20"
    );
    assert_eq!(name("Str(t)"), "side");
    assert_eq!(name("UpperCase(t)"), "SIDE");
    assert_eq!(name("StrReplace(t, \"s\", \"w\")"), "wide");
    assert_eq!(name("StrSub(t, 1, 2)"), "id");
    assert_eq!(name("StrPrefix(\"a.geo\")"), "a");
}

#[test]
fn constants_keep_a_value_that_they_have() {
    let define = "a = 1; DefineConstant[ a = 5, b = {6, Min 0, Max 9, Name StrCat[\"x\", \"y\"]} \
                  c = {7, Choices{0=\"no\", 7=\"yes\"}} d ];";
    assert_eq!(value_after(define, "a + b + c + d"), 14.0);
    assert_eq!(value_after("h = DefineNumber[ 0.5, Name \"h\" ];", "h"), 0.5);
    assert_eq!(value_after("h = GetNumber[\"h\", 3];", "h"), 3.0);
}

#[test]
fn branches_are_taken_by_their_conditions() {
    let script =
        |x: u32| format!("x = {x}; If (x == 1) y = 10; ElseIf (x == 2) y = 20; Else y = 30; EndIf");
    for (x, y) in [(1, 10.0), (2, 20.0), (3, 30.0)] {
        assert_eq!(value_after(&script(x), "y"), y);
    }
}

#[test]
fn what_is_not_taken_may_hold_what_is_not_read() {
    let script = "dim = 2; If (dim == 3) Box(1) = {0, 0, 0, 1, 1, 1}; \
                  v[] = BooleanUnion{ Volume{1}; Delete; }{ Volume{2}; Delete; }; EndIf";
    assert_eq!(value_after(script, "dim"), 2.0);
}

#[test]
fn loops_run_up_and_down_in_both_forms() {
    assert_eq!(value_after("s = 0; For i In {1:4} s += i; EndFor", "s"), 10.0);
    assert_eq!(value_after("s = 0; For i In {4:1:-1} s = 10*s + i; EndFor", "s"), 4321.0);
    assert_eq!(value_after("s = 0; For (1:3) s++; EndFor", "s"), 3.0);
    assert_eq!(value_after("s = 0; For t In {0:1:0.1} s++; EndFor", "s"), 11.0);
    assert_eq!(value_after("s = 0; For i In {2:1} s++; EndFor", "s"), 0.0);
}

#[test]
fn macros_work_on_the_variables_of_all() {
    let script = "Macro Twice\n a = 2*a;\nReturn\nFunction Thrice\n a = 3*a;\nReturn\n\
                  a = 1; Call Twice; Call \"Thrice\";";
    assert_eq!(value_after(script, "a"), 6.0);
}

#[test]
fn nothing_is_read_after_exit() {
    read(&format!("{SQUARE}Exit;\nthis is not read {{ ("));
}

#[test]
fn comments_may_stand_anywhere() {
    read(&format!("// one\n/* two\n // three */ {SQUARE}//+\n/**/ // end"));
}

#[test]
fn line_ends_and_a_byte_order_mark_do_not_matter() {
    let pslg = read(&format!("\u{feff}{}", SQUARE.replace('\n', "\r\n")));
    assert_eq!(pslg.source.segment_lines, [5, 6, 7, 8]);
}

#[test]
fn included_files_share_the_variables() {
    let mut asked = Vec::new();
    let include = |name: &str| {
        asked.push(name.to_owned());
        Ok(SQUARE.as_bytes().to_vec())
    };
    let script = b"Include \"parts/square.geo\";\nPhysical Surface(9) = {1};";
    let (pslg, _) = geo::read(script, "dir/plate.geo", include).unwrap();
    assert_eq!(asked, ["dir/parts/square.geo"]);
    assert_eq!(pslg.regions[0].tag, 9);
    let merge = b"Merge \"square.geo\";";
    assert!(geo::read(merge, "plate.geo", |_| Ok(SQUARE.as_bytes().to_vec())).is_ok());
}

#[test]
fn an_error_in_an_included_file_names_that_file() {
    let error = geo::read(b"Include \"a.geo\";", "dir/b.geo", |_| Ok(b"\nx = y;".to_vec()));
    let message = error.unwrap_err().to_string();
    assert!(message.starts_with("dir/a.geo:2:5: there is no variable `y`"), "{message}");
}

#[test]
fn files_elsewhere_are_not_read() {
    for name in ["/etc/passwd", "../x.geo", "a/../../x.geo", "c:x.geo", "a\\\\x.geo", ""] {
        let include = |name: &str| -> io::Result<Vec<u8>> { panic!("{name} is asked for") };
        let message = error_with(&format!("Include \"{name}\";"), include);
        assert!(message.contains("cannot be read: it is not beside the script"), "{message}");
    }
    let message = error("Merge \"part.step\";");
    assert_eq!(message, "1:1: `Merge of a file that is no .geo script` is not read");
}
