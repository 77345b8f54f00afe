//! What holds of every mesh that a reader gives.

use meshwright_formats::{Data, Mesh, Values};

/// Checks that every array fits the others.
pub fn check(mesh: &Mesh) {
    let (points, edges, triangles) = (mesh.points.len(), mesh.edges.len(), mesh.triangles.len());
    assert!(mesh.points.iter().flatten().all(|x| x.is_finite()));
    let is_point = |&point: &u32| (point as usize) < points;
    assert!(mesh.triangles.iter().flatten().all(is_point));
    assert!(mesh.edges.iter().flatten().all(is_point));
    assert_eq!((mesh.triangle_tags.len(), mesh.edge_tags.len()), (triangles, edges));
    for length in [mesh.point_markers.len(), mesh.provenance.len()] {
        assert!(length == 0 || length == points);
    }
    assert!(mesh.edge_segments.is_empty() || mesh.edge_segments.len() == edges);
    for membership in &mesh.memberships {
        let items = if membership.dim == 0 { points } else { edges };
        assert!(membership.dim <= 1 && (membership.item as usize) < items);
    }
    for (data, items) in [(&mesh.point_data, points), (&mesh.triangle_data, triangles)] {
        assert!(data.iter().all(|data| data.components * items == length(data)));
    }
}

fn length(data: &Data) -> usize {
    match &data.values {
        Values::Real(values) => values.len(),
        Values::Integer(values) => values.len(),
    }
}
