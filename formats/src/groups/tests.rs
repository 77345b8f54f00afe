//! Small meshes and the groups that files hold for them.

use super::*;

/// Two triangles of a square, each with its tag; four sides and the diagonal with theirs.
fn square(triangle_tags: [Tag; 2], edge_tags: [Tag; 5], groups: &[(u8, Tag, &str)]) -> Mesh {
    let group = |&(dim, tag, name): &(u8, Tag, &str)| Group { dim, tag, name: name.into() };
    Mesh {
        points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        triangle_tags: triangle_tags.into(),
        edges: vec![[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
        edge_tags: edge_tags.into(),
        groups: groups.iter().map(group).collect(),
        ..Mesh::default()
    }
}

const ANY: Rules = Rules {
    positive: false,
    unique: false,
    quoted: false,
    memberships: false,
    numberless: false,
    names: Names::Any,
    without: None,
};
const POSITIVE: Rules = Rules { positive: true, quoted: true, ..ANY };
const UNIQUE: Rules = Rules { unique: true, ..POSITIVE };

fn written(mesh: &Mesh, rules: Rules) -> Vec<(u8, Tag, String)> {
    let (table, _) = Table::new(mesh, rules);
    table.entries.into_iter().map(|e| (e.dim, e.number, e.name)).collect()
}

fn said(mesh: &Mesh, rules: Rules) -> Vec<String> {
    Table::new(mesh, rules).1.iter().map(Note::to_string).collect()
}

fn named(groups: &[(u8, Tag, &str)]) -> Vec<(u8, Tag, String)> {
    groups.iter().map(|&(dim, number, name)| (dim, number, name.to_owned())).collect()
}

#[test]
fn what_is_untagged_is_named_by_what_it_is() {
    let mesh = square([0, 0], [0; 5], &[]);
    let expected = named(&[(1, 1, "boundary"), (1, 2, "interface"), (2, 3, "region")]);
    assert_eq!(written(&mesh, Rules::default()), expected);
    assert_eq!(written(&mesh, POSITIVE), expected);
    let (table, notes) = Table::new(&mesh, POSITIVE);
    assert_eq!(table.edges, [0, 0, 0, 0, 1]);
    assert!(!notes.iter().any(Note::is_warning));
}

#[test]
fn the_users_numbers_and_names_are_kept() {
    let mesh = square([7, 9], [5, 5, 4, 4, 3], &[(1, 5, "inlet"), (2, 9, "sand")]);
    let expected = [
        (1, 3, "boundary_3"),
        (1, 4, "boundary_4"),
        (1, 5, "inlet"),
        (2, 7, "region_7"),
        (2, 9, "sand"),
    ];
    assert_eq!(written(&mesh, POSITIVE), named(&expected));
    assert!(said(&mesh, POSITIVE).is_empty());
}

#[test]
fn numbers_below_one_are_mapped_and_said_where_they_must_be() {
    let mesh = square([1, 1], [-1, -1, Tag::MIN, 2, 2], &[]);
    let mapped = [
        (1, 3, "boundary_-2147483648"),
        (1, 4, "boundary_-1"),
        (1, 2, "boundary_2"),
        (2, 1, "region_1"),
    ];
    assert_eq!(written(&mesh, POSITIVE), named(&mapped));
    let kept = written(&mesh, Rules::default());
    assert_eq!(kept[0], (1, Tag::MIN, "boundary_-2147483648".to_owned()));
    let notes = said(&mesh, POSITIVE);
    assert_eq!(notes[1], "boundary -1 is written as 4, `boundary_-1`");
}

#[test]
fn a_number_of_a_boundary_and_a_region_is_a_warning_that_unique_ids_end() {
    let mesh = square([1, 2], [1, 1, 2, 2, 3], &[(1, 3, "weir")]);
    let warning = "numbers 1, 2 stand for a boundary and for a region; GetDP and scikit-fem \
                   mix them up";
    assert_eq!(said(&mesh, POSITIVE), [warning]);
    let unique = [
        (1, 3, "boundary_1"),
        (1, 4, "boundary_2"),
        (1, 5, "weir"),
        (2, 1, "region_1"),
        (2, 2, "region_2"),
    ];
    assert_eq!(written(&mesh, UNIQUE), named(&unique));
    let notes = said(&mesh, UNIQUE);
    assert_eq!(notes.len(), 3, "{notes:?}");
    assert_eq!(notes[2], "boundary 3 is written as 5, `weir`");
}

#[test]
fn numbers_that_tell_all_groups_apart_stay_as_they_are() {
    let mesh = square([11, 12], [1, 1, 2, 2, 0], &[(1, 1, "wall")]);
    assert_eq!(written(&mesh, UNIQUE), written(&mesh, POSITIVE));
    assert_eq!(said(&mesh, UNIQUE), said(&mesh, POSITIVE));
}

#[test]
fn a_name_for_what_is_untagged_holds_for_all_of_it() {
    let mesh = square([0, 0], [0; 5], &[(1, 0, "shore"), (2, 0, "water")]);
    assert_eq!(written(&mesh, POSITIVE), named(&[(1, 1, "shore"), (2, 2, "water")]));
}

#[test]
fn names_that_readers_stumble_over_are_said() {
    let names = [(1, 1, "a \"b\""), (1, 2, "twin"), (2, 3, "twin"), (2, 3, "second"), (0, 1, "p")];
    let mesh = square([3, 3], [1, 1, 2, 2, 2], &names);
    let expected = [
        "the name `a \"b\"` is written as `a 'b'`",
        "the group `twin` has a second name, `second`, which is not written",
        "the point group `p` is not written",
        "the name `a 'b'` holds a space; some solvers cut it there",
        "`twin` names two groups; readers that go by names keep one",
    ];
    assert_eq!(said(&mesh, POSITIVE), expected);
}

#[test]
fn stated_names_tell_their_tags() {
    for tag in [Tag::MIN, -1, 1, 7, Tag::MAX] {
        for dim in [1, 2] {
            assert_eq!(stated_tag(dim, &stated_name(dim, tag)), Some(tag));
        }
    }
    for name in ["boundary", "interface"] {
        assert_eq!(stated_tag(1, name), Some(0));
        assert_eq!(stated_tag(2, name), None);
    }
    assert_eq!(stated_tag(2, "region"), Some(0));
    for name in ["boundary_", "boundary_+1", "boundary_01", "region_1", "boundary_2147483648"] {
        assert_eq!(stated_tag(1, name), None, "{name}");
    }
}

#[test]
fn groups_agree_by_name_then_by_number() {
    let group = |tag, name: &str| [Group { dim: 1, tag, name: name.into() }];
    let (inlet, outlet, none) = (group(3, "inlet"), group(3, "outlet"), []);
    assert!(agree(1, (3, &inlet), (3, &inlet)));
    assert!(!agree(1, (3, &inlet), (3, &outlet)), "two names");
    assert!(agree(1, (3, &inlet), (3, &none)), "one name: by number");
    assert!(agree(1, (3, &none), (3, &outlet)), "one name: by number");
    assert!(!agree(1, (3, &inlet), (4, &none)));
    assert!(agree(1, (0, &none), (9, &group(9, "boundary"))));
    assert!(agree(1, (0, &none), (9, &group(9, "interface"))));
    assert!(!agree(1, (9, &none), (9, &group(9, "boundary"))));
    assert!(agree(1, (3, &group(3, "a\"b")), (3, &group(3, "a'b"))), "as .msh writes it");
}

#[test]
fn names_are_made_words_where_they_must_be() {
    let names =
        [(1, 1, "no slip"), (1, 2, "2nd wall"), (1, 3, "No_slip"), (2, 1, "süd\u{7}no slip")];
    let mesh = square([1, 1], [1, 2, 3, 3, 3], &names);
    let plain = Rules { names: Names::Plain, ..ANY };
    let expected =
        [(1, 1, "no_slip"), (1, 2, "g_2nd_wall"), (1, 3, "No_slip_2"), (2, 1, "s_d_no_slip")];
    assert_eq!(written(&mesh, plain), named(&expected));
    assert!(said(&mesh, plain).contains(&"the name `2nd wall` is written as `g_2nd_wall`".into()));
    let words = Rules { names: Names::Words, ..ANY };
    let expected =
        [(1, 1, "no_slip"), (1, 2, "2nd_wall"), (1, 3, "No_slip"), (2, 1, "süd_no_slip")];
    assert_eq!(written(&mesh, words), named(&expected));
}

#[test]
fn nothing_is_said_of_what_a_format_does_not_hold() {
    let mesh = square([1, 0], [1, 0, 0, 0, 0], &[(1, 1, "wall"), (2, 1, "a\tb")]);
    let numberless = Rules { numberless: true, ..ANY };
    assert_eq!(
        said(&mesh, Rules { without: Some(2), ..numberless }),
        ["untagged edges are group `boundary`", "untagged edges are group `interface`",]
    );
    assert_eq!(
        said(&mesh, Rules { without: Some(1), ..numberless }),
        [
            "the name `a\tb` is written as `a b`",
            "untagged triangles are group `region`",
            "the name `a b` holds a space; some solvers cut it there",
        ]
    );
}
