//! Parts of a mesh: what a consumer wants is not always all.

use std::borrow::Cow;

use crate::groups::{Note, inner_edges};
use crate::mesh::{Data, Mesh, Values};
use crate::pslg::Membership;

/// Which cells of a mesh a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cells {
    /// Edges and triangles.
    #[default]
    All,
    /// Triangles alone, with all points. A point without a marker has the tag of an edge that it is
    /// on, the first in the mesh.
    Faces,
    /// Edges alone, with the points that they have and those that are in a group.
    Segments,
}

/// The mesh with these cells alone, and with the groups that are left.
#[must_use]
pub fn select(mesh: &Mesh, cells: Cells) -> Cow<'_, Mesh> {
    match cells {
        Cells::All => Cow::Borrowed(mesh),
        Cells::Faces => {
            let mut mesh = mesh.clone();
            mark_ends(&mut mesh);
            keep_edges(&mut mesh, |_| false);
            mesh.groups.retain(|group| group.dim != 1);
            Cow::Owned(mesh)
        }
        Cells::Segments => Cow::Owned(segments(mesh)),
    }
}

/// The mesh without its interfaces: no edge is left that two triangles share. The note, if there is
/// one, names what is lost.
#[must_use]
pub fn without_interfaces(mesh: &Mesh) -> (Cow<'_, Mesh>, Option<Note>) {
    let inner = inner_edges(mesh, |_| true);
    if inner.is_empty() {
        return (Cow::Borrowed(mesh), None);
    }
    let mut tags: Vec<_> = inner.iter().map(|&edge| mesh.edge_tag(edge)).collect();
    tags.sort_unstable();
    tags.dedup();
    let note = Note::Interfaces { count: inner.len(), tags };
    let mut mesh = mesh.clone();
    keep_edges(&mut mesh, |edge| !inner.contains(&edge));
    // A name without an edge of its own says nothing any more.
    let used = |tag| mesh.edge_tags.contains(&tag) || further(&mesh.memberships, tag);
    let lost: Vec<bool> = mesh.groups.iter().map(|g| g.dim == 1 && !used(g.tag)).collect();
    let mut lost = lost.into_iter();
    mesh.groups.retain(|_| lost.next() == Some(false));
    (Cow::Owned(mesh), Some(note))
}

/// Gives the ends of tagged edges the tag as their marker, where they have none.
fn mark_ends(mesh: &mut Mesh) {
    if mesh.edge_tags.iter().all(|&tag| tag == 0) {
        return;
    }
    mesh.point_markers.resize(mesh.points.len(), 0);
    for (edge, &tag) in mesh.edges.iter().zip(&mesh.edge_tags) {
        for &end in edge {
            let marker = &mut mesh.point_markers[end as usize];
            if *marker == 0 {
                *marker = tag;
            }
        }
    }
}

fn further(memberships: &[Membership], tag: i32) -> bool {
    memberships.iter().any(|membership| (membership.dim, membership.tag) == (1, tag))
}

/// Keeps the edges that pass a test, with all that is known of them.
fn keep_edges(mesh: &mut Mesh, keep: impl Fn(usize) -> bool) {
    let mut next = 0;
    let numbers: Vec<Option<u32>> = (0..mesh.edges.len())
        .map(|edge| {
            next += u32::from(keep(edge));
            keep(edge).then(|| next - 1)
        })
        .collect();
    let kept = |edge: usize| numbers.get(edge).is_some_and(Option::is_some);
    retain(&mut mesh.edges, kept);
    retain(&mut mesh.edge_tags, kept);
    retain(&mut mesh.edge_segments, kept);
    let moved = |membership: &Membership| match membership.dim {
        1 => {
            let item = numbers.get(membership.item as usize).copied().flatten()?;
            Some(Membership { item, ..*membership })
        }
        _ => Some(*membership),
    };
    mesh.memberships = mesh.memberships.iter().filter_map(moved).collect();
}

fn segments(mesh: &Mesh) -> Mesh {
    let mut used = vec![false; mesh.points.len()];
    let of_points = mesh.memberships.iter().filter(|m| m.dim == 0).map(|m| m.item);
    for point in mesh.edges.iter().flatten().copied().chain(of_points) {
        used[point as usize] = true;
    }
    let numbers: Vec<u32> = used
        .iter()
        .scan(0, |next, &used| {
            *next += u32::from(used);
            Some(next.saturating_sub(1))
        })
        .collect();
    let kept = |point: usize| used[point];
    let mut part = Mesh {
        triangles: Vec::new(),
        triangle_tags: Vec::new(),
        triangle_data: Vec::new(),
        ..mesh.clone()
    };
    retain(&mut part.points, kept);
    retain(&mut part.point_markers, kept);
    retain(&mut part.provenance, kept);
    part.point_data.iter_mut().for_each(|data| retain_tuples(data, kept));
    for end in part.edges.iter_mut().flatten() {
        *end = numbers[*end as usize];
    }
    for membership in part.memberships.iter_mut().filter(|membership| membership.dim == 0) {
        membership.item = numbers[membership.item as usize];
    }
    part.groups.retain(|group| group.dim != 2);
    part
}

fn retain<T>(items: &mut Vec<T>, keep: impl Fn(usize) -> bool) {
    let mut place = 0..;
    items.retain(|_| place.next().is_some_and(&keep));
}

fn retain_tuples(data: &mut Data, keep: impl Fn(usize) -> bool) {
    let components = data.components.max(1);
    match &mut data.values {
        Values::Real(values) => retain(values, |i| keep(i / components)),
        Values::Integer(values) => retain(values, |i| keep(i / components)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pslg::Group;

    /// A square cut by its diagonal, which is in two groups; one corner is a group.
    fn square() -> Mesh {
        let group = |dim, tag, name: &str| Group { dim, tag, name: name.into() };
        Mesh {
            points: vec![[5.0, 5.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.1]],
            triangles: vec![[1, 2, 3], [1, 3, 4], [1, 2, 5]],
            triangle_tags: vec![7, 8, 7],
            edges: vec![[1, 3], [2, 3], [3, 4]],
            edge_tags: vec![4, 3, 4],
            edge_segments: vec![9, 8, 7],
            groups: vec![group(0, 1, "probe"), group(1, 3, "wall"), group(1, 6, "cut")],
            memberships: vec![
                Membership { dim: 1, item: 0, tag: 6 },
                Membership { dim: 1, item: 2, tag: 3 },
                Membership { dim: 0, item: 5, tag: 1 },
            ],
            point_data: vec![Data {
                name: "d".into(),
                components: 2,
                values: Values::Integer((0..12).collect()),
            }],
            ..Mesh::default()
        }
    }

    #[test]
    fn edges_that_two_triangles_share_are_left_out() {
        let mesh = square();
        let (mesh, note) = without_interfaces(&mesh);
        assert_eq!(mesh.edges, [[2, 3], [3, 4]]);
        assert_eq!((&mesh.edge_tags[..], &mesh.edge_segments[..]), (&[3, 4][..], &[8, 7][..]));
        assert_eq!(
            mesh.memberships,
            [Membership { dim: 1, item: 1, tag: 3 }, Membership { dim: 0, item: 5, tag: 1 },]
        );
        let names: Vec<&str> = mesh.groups.iter().map(|group| &group.name[..]).collect();
        assert_eq!(names, ["probe", "wall"]);
        let said = note.expect("the diagonal is lost").to_string();
        assert_eq!(said, "1 edge between two triangles is not written: boundary 4");
    }

    #[test]
    fn a_mesh_without_interfaces_stays_as_it_is() {
        let mesh = Mesh { edges: vec![[2, 3]], edge_tags: vec![1], ..square() };
        assert!(matches!(without_interfaces(&mesh), (Cow::Borrowed(_), None)));
    }

    #[test]
    fn segments_keep_their_points_alone() {
        let mesh = square();
        let mesh = select(&mesh, Cells::Segments);
        assert_eq!(mesh.points, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.1]]);
        assert_eq!(mesh.edges, [[0, 2], [1, 2], [2, 3]]);
        assert_eq!(mesh.memberships[2], Membership { dim: 0, item: 4, tag: 1 });
        assert_eq!(mesh.point_data[0].values, Values::Integer((2..12).collect()));
        assert!(mesh.triangles.is_empty());
    }

    #[test]
    fn faces_keep_all_points_and_no_edge() {
        let mesh = square();
        let faces = select(&mesh, Cells::Faces);
        assert_eq!((&faces.points, &faces.triangles), (&mesh.points, &mesh.triangles));
        assert!(faces.edges.is_empty() && faces.edge_tags.is_empty());
        assert_eq!(faces.memberships, [Membership { dim: 0, item: 5, tag: 1 }]);
        assert_eq!(faces.point_markers, [0, 4, 3, 4, 4, 0]);
    }

    #[test]
    fn markers_of_points_stay_where_edges_go() {
        let mesh = Mesh { point_markers: vec![0, 9, 0, -2, 0, 0], ..square() };
        assert_eq!(select(&mesh, Cells::Faces).point_markers, [0, 9, 3, -2, 4, 0]);
        let untagged = Mesh { edge_tags: Vec::new(), ..square() };
        assert!(select(&untagged, Cells::Faces).point_markers.is_empty());
    }
}
