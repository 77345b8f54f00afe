//! Physical groups.

use meshwright_formats::{Group, Membership};

use super::{SQUARE, error, read, warned};

fn group(dim: u8, tag: i32, name: &str) -> Group {
    Group { dim, tag, name: name.to_owned() }
}

#[test]
fn groups_have_numbers_and_names() {
    let pslg = read(&format!(
        "{SQUARE}Physical Curve(\"rim\", 7) = {{1, -3}};\nPhysical Line(8) = {{2}};\n\
         Physical Surface(\"plate\", 7) = {{1}};\nPhysical Point(\"corner\", 3) = {{2}};"
    ));
    assert_eq!(pslg.segment_tags, [7, 8, 7, 0]);
    assert_eq!(pslg.regions[0].tag, 7);
    assert_eq!(pslg.groups, [group(0, 3, "corner"), group(1, 7, "rim"), group(2, 7, "plate")]);
    assert_eq!(pslg.memberships, [Membership { dim: 0, item: 1, tag: 3 }]);
}

#[test]
fn a_name_alone_gets_the_next_number_of_all_groups() {
    let pslg = read(&format!(
        "{SQUARE}Physical Curve(\"a\", 5) = {{1}};\nPhysical Surface(\"b\") = {{1}};\n\
         Physical Curve(\"c\") = {{2}};\nPhysical Curve(\"c\") += {{3}};"
    ));
    assert_eq!(pslg.groups, [group(1, 5, "a"), group(1, 7, "c"), group(2, 6, "b")]);
    assert_eq!(pslg.segment_tags, [5, 7, 7, 0]);
}

#[test]
fn a_curve_may_be_in_several_groups() {
    let pslg = read(&format!(
        "{SQUARE}Physical Curve(9) = {{1, 2}};\nPhysical Curve(4) = {{2, 3}};\n\
         Physical Curve(6) = {{2}};"
    ));
    assert_eq!(pslg.segment_tags, [9, 4, 4, 0]);
    let further = |tag| Membership { dim: 1, item: 1, tag };
    assert_eq!(pslg.memberships, [further(6), further(9)]);
}

#[test]
fn a_surface_keeps_one_group() {
    let script = format!("{SQUARE}Physical Surface(2) = {{1}};\nPhysical Surface(5) = {{1}};");
    let (pslg, warnings) = warned(&script);
    assert_eq!(pslg.regions[0].tag, 2);
    assert_eq!(warnings, ["part.geo:12: surface 1 is in the physical groups 2 and 5: it keeps 2"]);
}

#[test]
fn groups_may_come_before_their_curves() {
    let pslg = read(&format!("Physical Curve(3) = {{1:4}};\n{SQUARE}"));
    assert_eq!(pslg.segment_tags, [3; 4]);
}

#[test]
fn groups_follow_what_coherence_merges() {
    let pslg = read(&format!(
        "{SQUARE}Physical Curve(3) = {{2}};\nTranslate {{-1, 0, 0}} {{ Duplicata {{ Surface{{1}}; }} }}"
    ));
    assert_eq!(pslg.segment_tags.iter().filter(|&&tag| tag == 3).count(), 1);
}

#[test]
fn without_groups_each_curve_and_surface_is_one() {
    let pslg = read(&SQUARE.replace("Surface(1)", "Surface(12)"));
    assert_eq!(pslg.segment_tags, [1, 2, 3, 4]);
    assert_eq!(pslg.regions[0].tag, 12);
    assert_eq!(pslg.groups, []);
}

#[test]
fn names_keep_blanks_letters_of_all_kinds_and_backslashes() {
    let pslg = read(&format!("{SQUARE}Physical Curve(\"rand außen\\a/b:c\", 1) = {{1}};"));
    assert_eq!(pslg.groups, [group(1, 1, "rand außen\\a/b:c")]);
}

#[test]
fn missing_members_are_a_warning() {
    let (_, warnings) = warned(&format!("{SQUARE}Physical Surface(\"a\", 2) = {{1, 77, 78}};"));
    assert_eq!(
        warnings,
        ["part.geo:11: physical group 2: there is no surface 77, and 1 more are missing"]
    );
}

#[test]
fn a_group_is_not_made_twice() {
    let script = format!("{SQUARE}Physical Curve(1) = {{1}};\nPhysical Curve(1) = {{2}};");
    assert_eq!(error(&script), "12:1: physical group 1 exists already (line 11)");
}

#[test]
fn adding_to_a_group_by_its_name_uses_a_number_up() {
    let (pslg, _) = warned(&format!(
        "{SQUARE}Physical Curve(\"a\") = {{1}};\nPhysical Curve(\"a\") += {{2}};\n\
         Physical Curve(\"b\") = {{3}};"
    ));
    assert_eq!(pslg.segment_tags, [1, 1, 3, 0]);
}
