//! Random meshes: any arrays that are consistent, whatever their geometry.

use std::collections::BTreeSet;

use meshwright_formats::{Data, Group, Mesh, Provenance, Tag, Values, groups};
use proptest::collection::{btree_map, vec};
use proptest::prelude::*;

/// Any finite coordinate, often one that is short.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-100_i32..100).prop_map(f64::from),
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
    ]
}

/// Any tag, often one that others have too.
pub fn tag() -> impl Strategy<Value = Tag> {
    prop_oneof![4 => -3..6, 1 => any::<Tag>()]
}

/// Names as a user may give them; none that is a stated one.
pub fn name() -> impl Strategy<Value = String> {
    let names = prop_oneof!["[a-z]{1,3}", "[ a-zäß<&>'/\\\\:]{1,12}", "\\PC{1,8}"];
    names.prop_filter("a user's name", |name| {
        (1..=2).all(|dim| groups::stated_tag(dim, name).is_none())
    })
}

fn data(name: &'static str, count: usize) -> impl Strategy<Value = Data> {
    (1_usize..4).prop_flat_map(move |components| {
        let numbers = components * count;
        let values = prop_oneof![
            vec(coordinate(), numbers).prop_map(Values::Real),
            vec(any::<i64>(), numbers).prop_map(Values::Integer),
        ];
        values.prop_map(move |values| Data { name: name.to_owned(), components, values })
    })
}

fn provenance() -> impl Strategy<Value = Provenance> {
    use Provenance::{Circumcenter, Input, Midpoint, Shell};
    prop::sample::select(vec![Input, Shell, Midpoint, Circumcenter])
}

/// Either nothing or one value for each.
fn all_or_none<S: Strategy>(value: S, count: usize) -> impl Strategy<Value = Vec<S::Value>>
where
    S::Value: Clone,
{
    (any::<bool>(), vec(value, count)).prop_map(|(some, all)| if some { all } else { Vec::new() })
}

type Points = (Vec<[f64; 2]>, Vec<Tag>, Vec<Provenance>, Vec<Data>);
type Triangles = (Vec<[u32; 3]>, Vec<Tag>, Vec<Data>);
type Edges = (Vec<[u32; 2]>, Vec<Tag>, Vec<u32>);

fn points() -> impl Strategy<Value = Points> {
    (3_usize..12).prop_flat_map(|count| {
        (
            vec([coordinate(), coordinate()], count),
            all_or_none(tag(), count),
            all_or_none(provenance(), count),
            vec(data("depth", count), 0..2),
        )
    })
}

fn triangles(points: u32) -> impl Strategy<Value = Triangles> {
    (0_usize..8).prop_flat_map(move |count| {
        let corner = move || 0..points;
        (
            vec([corner(), corner(), corner()], count),
            vec(tag(), count),
            vec(data("load", count), 0..2),
        )
    })
}

fn edges(points: u32) -> impl Strategy<Value = Edges> {
    let end = move || 0..points;
    vec([end(), end()], 1..8).prop_flat_map(|mut edges| {
        // An edge that is there again is a membership.
        let mut known = BTreeSet::new();
        edges.retain(|[a, b]| known.insert([*a.min(b), *a.max(b)]));
        let count = edges.len();
        let segment = prop_oneof![0_u32..9, Just(u32::MAX)];
        (Just(edges), vec(tag(), count), all_or_none(segment, count))
    })
}

/// Names for some of the tags other than 0, sorted.
fn group_names() -> impl Strategy<Value = Vec<Group>> {
    let key = (1_u8..3, tag().prop_filter("tagged", |&tag| tag != 0));
    btree_map(key, name(), 0..5).prop_map(|names| {
        let group = |((dim, tag), name)| Group { dim, tag, name };
        let mut groups: Vec<Group> = names.into_iter().map(group).collect();
        groups.sort();
        groups
    })
}

/// A mesh whose indices are in range.
pub fn mesh() -> impl Strategy<Value = Mesh> {
    points().prop_flat_map(|(points, point_markers, provenance, point_data)| {
        let count = points.len() as u32;
        let start = Mesh { points, point_markers, provenance, point_data, ..Mesh::default() };
        (Just(start), triangles(count), edges(count), group_names()).prop_map(
            |(start, (triangles, triangle_tags, triangle_data), edges, groups)| {
                let (edges, edge_tags, edge_segments) = edges;
                Mesh {
                    triangles,
                    triangle_tags,
                    triangle_data,
                    edges,
                    edge_tags,
                    edge_segments,
                    groups,
                    ..start
                }
            },
        )
    })
}
