//! What is written reads back equal, as far as the format can hold it.

mod common;

use meshwright_formats::{Group, Mesh, gltf, groups, msh, vtu};
use proptest::prelude::*;

/// Coordinates bit for bit: `-0.0 == 0.0` says too little.
fn bits(points: &[[f64; 2]]) -> Vec<[u64; 2]> {
    points.iter().map(|point| point.map(f64::to_bits)).collect()
}

fn through_vtu(mesh: &Mesh) -> Mesh {
    let mut bytes = Vec::new();
    vtu::write(mesh, &mut bytes).expect("memory takes all");
    vtu::read(&bytes, "mesh.vtu").unwrap_or_else(|error| panic!("{error}"))
}

fn through_msh(mesh: &Mesh, options: msh::Options) -> Mesh {
    let mut text = Vec::new();
    msh::write_with(mesh, options, &mut text).expect("memory takes all");
    let (read, warnings) = msh::read(&text, "mesh.msh").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(warnings, []);
    read
}

fn distinct_names(groups: &[Group]) -> bool {
    let names: std::collections::BTreeSet<_> = groups.iter().map(|g| &g.name).collect();
    names.len() == groups.len()
}

proptest! {
    #[test]
    fn vtu_holds_the_whole_mesh(mesh in common::mesh()) {
        let read = through_vtu(&mesh);
        prop_assert_eq!(bits(&read.points), bits(&mesh.points));
        prop_assert_eq!(read, mesh);
    }

    #[test]
    fn msh_holds_points_cells_and_groups(mesh in common::mesh(), unique_ids: bool) {
        prop_assume!(distinct_names(&mesh.groups));
        let read = through_msh(&mesh, msh::Options { unique_ids });
        prop_assert_eq!(bits(&read.points), bits(&mesh.points));
        prop_assert_eq!(&read.triangles, &mesh.triangles);
        prop_assert_eq!(&read.edges, &mesh.edges);
        for (&user, &file) in mesh.edge_tags.iter().zip(&read.edge_tags) {
            prop_assert!(groups::agree(1, (user, &mesh.groups), (file, &read.groups)));
        }
        for (&user, &file) in mesh.triangle_tags.iter().zip(&read.triangle_tags) {
            prop_assert!(groups::agree(2, (user, &mesh.groups), (file, &read.groups)));
        }
    }

    #[test]
    fn tags_that_differ_still_differ_in_msh(mesh in common::mesh(), unique_ids: bool) {
        prop_assume!(distinct_names(&mesh.groups));
        let read = through_msh(&mesh, msh::Options { unique_ids });
        for (&user, _) in mesh.edge_tags.iter().zip(&read.edge_tags) {
            for (&other, &file) in mesh.edge_tags.iter().zip(&read.edge_tags) {
                let agree = groups::agree(1, (user, &mesh.groups), (file, &read.groups));
                prop_assert_eq!(agree, user == other);
            }
        }
    }

    #[test]
    fn every_number_in_msh_is_positive_and_has_a_name(mesh in common::mesh(), unique_ids: bool) {
        let read = through_msh(&mesh, msh::Options { unique_ids });
        let cells = read.edge_tags.iter().map(|&tag| (1, tag));
        for (dim, tag) in cells.chain(read.triangle_tags.iter().map(|&tag| (2, tag))) {
            prop_assert!(tag > 0);
            let named = read.groups.iter().filter(|g| (g.dim, g.tag) == (dim, tag)).count();
            prop_assert_eq!(named, 1);
        }
        if unique_ids {
            let shared = read.edge_tags.iter().find(|tag| read.triangle_tags.contains(tag));
            prop_assert_eq!(shared, None);
        }
    }

    #[test]
    fn the_same_mesh_gives_the_same_bytes(mesh in common::mesh()) {
        let files = || {
            let mut files = [Vec::new(), Vec::new(), Vec::new()];
            msh::write(&mesh, &mut files[0]).expect("memory takes all");
            vtu::write(&mesh, &mut files[1]).expect("memory takes all");
            gltf::write(&mesh, &mut files[2]).expect("memory takes all");
            files
        };
        prop_assert_eq!(files(), files());
    }
}
