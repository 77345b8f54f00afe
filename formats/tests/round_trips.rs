//! What is written reads back equal, as far as the format can hold it.

mod common;

use meshwright_formats::{
    Attribute, Data, Group, Mesh, Order, Pslg, Region, Source, Values, edge, ele, gltf, groups,
    inp, medit, msh, neigh, node, obj, poly, stl, su2, vtk, vtp, vtu, xdmf,
};
use proptest::collection::vec;
use proptest::prelude::*;

/// Coordinates bit for bit: `-0.0 == 0.0` says too little.
fn bits(points: &[[f64; 2]]) -> Vec<[u64; 2]> {
    points.iter().map(|point| point.map(f64::to_bits)).collect()
}

fn through_vtu(mesh: &Mesh) -> Mesh {
    let mut bytes = Vec::new();
    vtu::write(mesh, &mut bytes).expect("memory takes all");
    let (read, warnings) = vtu::read(&bytes, "mesh.vtu").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(warnings, []);
    read
}

fn through_msh(mesh: &Mesh, options: msh::Options) -> Mesh {
    let mut text = Vec::new();
    msh::write_with(mesh, options, &mut text).expect("memory takes all");
    let (read, warnings) = msh::read(&text, "mesh.msh").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(warnings, []);
    read
}

/// What a mesh holds, in whatever order: points and cells by the bits of their coordinates, with
/// tags and real data.
fn content(mesh: &Mesh) -> [Vec<Vec<u64>>; 3] {
    let real = |data: &[Data], item: usize| -> Vec<u64> {
        let of = |data: &Data| match &data.values {
            Values::Real(all) => all[item * data.components..][..data.components].to_vec(),
            Values::Integer(_) => Vec::new(), // real numbers hold them up to 2^53
        };
        data.iter().flat_map(of).map(f64::to_bits).collect()
    };
    let place = |&point: &u32| mesh.points[point as usize].map(f64::to_bits);
    let point = |i: u32| [place(&i).to_vec(), real(&mesh.point_data, i as usize)].concat();
    let edge = |i: usize| {
        let places = mesh.edges[i].iter().flat_map(place);
        places.chain([mesh.edge_tag(i) as u64]).collect()
    };
    let triangle = |i: usize| {
        let places = mesh.triangles[i].iter().flat_map(place);
        let data = real(&mesh.triangle_data, i);
        places.chain([mesh.triangle_tag(i) as u64]).chain(data).collect()
    };
    let mut all = [
        (0..mesh.points.len() as u32).map(point).collect(),
        (0..mesh.edges.len()).map(edge).collect(),
        (0..mesh.triangles.len()).map(triangle).collect::<Vec<_>>(),
    ];
    all.iter_mut().for_each(|items| items.sort());
    all
}

/// The `.node`, `.ele` and `.poly` files of a mesh, read back together.
fn through_triangle(mesh: &Mesh, points_beside: bool) -> Mesh {
    let [mut node, mut ele, mut poly] = [const { Vec::new() }; 3];
    node::write(mesh, &mut node).expect("memory takes all");
    ele::write(mesh, &mut ele).expect("memory takes all");
    let options = poly::Options { points_beside, ..poly::Options::default() };
    poly::write_with(mesh, options, &mut poly).expect("memory takes all");
    let beside = |name: &str| match name {
        "mesh.node" if points_beside => Ok(node.clone()),
        "mesh.poly" => Ok(poly.clone()),
        _ => Err(std::io::ErrorKind::NotFound.into()),
    };
    let read = ele::read_with_companions(&ele, "mesh.ele", beside);
    let (read, warnings) = read.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(warnings, []);
    read
}

/// The data that attributes can hold, under the names that they read back with: all but the
/// first `before` attributes.
fn attributes(data: &[Data], before: usize) -> Vec<Data> {
    let fit = data.iter().filter(|d| d.components == 1 && matches!(d.values, Values::Real(_)));
    let numbered = (before + 1..).zip(fit);
    let name = |(i, data): (usize, &Data)| Data { name: format!("attribute_{i}"), ..data.clone() };
    numbered.map(name).collect()
}

fn distinct_names(groups: &[Group]) -> bool {
    let names: std::collections::BTreeSet<_> = groups.iter().map(|g| &g.name).collect();
    names.len() == groups.len()
}

/// An outline of points and tagged segments, with the names of tags in use.
fn outline() -> impl Strategy<Value = Pslg> {
    common::mesh().prop_map(|mesh| {
        let is_used = |group: &Group| group.dim == 1 && mesh.edge_tags.contains(&group.tag);
        Pslg {
            groups: mesh.groups.iter().filter(|group| is_used(group)).cloned().collect(),
            points: mesh.points,
            segments: mesh.edges,
            segment_tags: mesh.edge_tags,
            ..Pslg::default()
        }
    })
}

fn through_obj(outline: &Pslg) -> (Pslg, Vec<groups::Note>) {
    let mut text = Vec::new();
    let notes = obj::write_outline(outline, &mut text).expect("memory takes all");
    let (read, _) = obj::read(&text, "outline.obj").unwrap_or_else(|error| panic!("{error}"));
    (Pslg { source: Source::default(), ..read }, notes)
}

fn through_poly(outline: &Pslg) -> (Pslg, Vec<groups::Note>) {
    let mut text = Vec::new();
    let notes = poly::write_outline(outline, &mut text).expect("memory takes all");
    let read = poly::read(&text, "outline.poly", |_| unreachable!("it holds its points"));
    let (read, _) = read.unwrap_or_else(|error| panic!("{error}"));
    (Pslg { source: Source::default(), ..read }, notes)
}

/// The names that are written as they are.
fn plain_names(outline: &Pslg, notes: &[groups::Note]) -> Vec<Group> {
    let is_changed = |name: &str| {
        notes
            .iter()
            .any(|note| matches!(note, groups::Note::NameChanged { name: n, .. } if n == name))
    };
    outline.groups.iter().filter(|group| !is_changed(&group.name)).cloned().collect()
}

/// A region whose attribute is a whole number.
fn region() -> impl Strategy<Value = Region> {
    let area = prop_oneof![Just(None), (1e-3..1e3).prop_map(Some)];
    (common::tag(), [-1.0..1.0, -1.0..1.0], area).prop_map(|(tag, seed, max_area)| Region {
        seed,
        tag,
        attribute: f64::from(tag),
        max_area,
    })
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
        let read = through_msh(&mesh, msh::Options { unique_ids, ..msh::Options::default() });
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
    fn every_kind_of_msh_file_holds_the_same(mesh in common::mesh(), binary: bool) {
        prop_assume!(distinct_names(&mesh.groups));
        let text = through_msh(&mesh, msh::Options::default());
        for version in [msh::Version::V2_2, msh::Version::V4_1] {
            let options = msh::Options { version, binary, ..msh::Options::default() };
            prop_assert_eq!(content(&through_msh(&mesh, options)), content(&text));
        }
    }

    #[test]
    fn tags_that_differ_still_differ_in_msh(mesh in common::mesh(), unique_ids: bool) {
        prop_assume!(distinct_names(&mesh.groups));
        let read = through_msh(&mesh, msh::Options { unique_ids, ..msh::Options::default() });
        for (&user, _) in mesh.edge_tags.iter().zip(&read.edge_tags) {
            for (&other, &file) in mesh.edge_tags.iter().zip(&read.edge_tags) {
                let agree = groups::agree(1, (user, &mesh.groups), (file, &read.groups));
                prop_assert_eq!(agree, user == other);
            }
        }
    }

    #[test]
    fn every_number_in_msh_is_positive_and_has_a_name(mesh in common::mesh(), unique_ids: bool) {
        let read = through_msh(&mesh, msh::Options { unique_ids, ..msh::Options::default() });
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
    fn the_files_of_triangle_hold_all_but_names(mesh in common::mesh(), points_beside: bool) {
        let read = through_triangle(&mesh, points_beside);
        prop_assert_eq!(bits(&read.points), bits(&mesh.points));
        let expected = Mesh {
            provenance: Vec::new(),
            edge_segments: Vec::new(),
            groups: Vec::new(),
            point_data: attributes(&mesh.point_data, 0),
            triangle_data: attributes(&mesh.triangle_data, 1),
            ..mesh
        };
        prop_assert_eq!(read, expected);
    }

    #[test]
    fn poly_holds_an_outline(mesh in common::mesh(), regions in vec(region(), 0..4)) {
        let attribute = |(i, data): (usize, Data)| match data.values {
            Values::Real(values) => Attribute { name: format!("attribute_{}", i + 1), values },
            Values::Integer(_) => unreachable!("attributes are real numbers"),
        };
        let fit = attributes(&mesh.point_data, 0);
        let outline = Pslg {
            holes: mesh.points[1..].to_vec(),
            points: mesh.points,
            point_markers: mesh.point_markers,
            point_attributes: fit.into_iter().enumerate().map(attribute).collect(),
            segments: mesh.edges,
            segment_tags: mesh.edge_tags,
            regions,
            ..Pslg::default()
        };
        let mut text = Vec::new();
        let notes = poly::write_outline(&outline, &mut text).expect("memory takes all");
        prop_assert_eq!(notes, []);
        let read = poly::read(&text, "outline.poly", |_| unreachable!("it holds its points"));
        let (read, _) = read.unwrap_or_else(|error| panic!("{error}"));
        prop_assert_eq!(Pslg { source: Source::default(), ..read }, outline);
    }

    #[test]
    fn a_poly_file_comes_back_from_an_obj_file(outline in outline()) {
        let (first, _) = through_poly(&outline);
        let (between, notes) = through_obj(&first);
        prop_assert_eq!(notes, []);
        let (last, _) = through_poly(&between);
        prop_assert_eq!(bits(&last.points), bits(&outline.points));
        prop_assert_eq!(&last, &first);
    }

    #[test]
    fn an_obj_file_comes_back_from_a_poly_file_but_for_names(outline in outline()) {
        let (first, notes) = through_obj(&outline);
        for group in plain_names(&outline, &notes) {
            prop_assert!(first.groups.contains(&group), "{:?} in {:?}", group, first.groups);
        }
        let (between, notes) = through_poly(&first);
        let names = first.groups.len();
        prop_assert_eq!(names > 0, matches!(&notes[..], [groups::Note::NumbersOnly { dim: 1, .. }]));
        let (last, _) = through_obj(&between);
        prop_assert_eq!(bits(&last.points), bits(&outline.points));
        prop_assert_eq!(last.segments, outline.segments);
        prop_assert_eq!(last.segment_tags, outline.segment_tags);
    }

    #[test]
    fn the_same_mesh_gives_the_same_bytes(mesh in common::mesh()) {
        let files = || {
            let mut files = [const { Vec::new() }; 16];
            msh::write(&mesh, &mut files[0]).expect("memory takes all");
            vtu::write(&mesh, &mut files[1]).expect("memory takes all");
            gltf::write(&mesh, &mut files[2]).expect("memory takes all");
            node::write(&mesh, &mut files[3]).expect("memory takes all");
            ele::write(&mesh, &mut files[4]).expect("memory takes all");
            poly::write(&mesh, &mut files[5]).expect("memory takes all");
            edge::write(&mesh, &mut files[6]).expect("memory takes all");
            neigh::write(&mesh, &mut files[7]).expect("memory takes all");
            vtk::write_with(&mesh, vtk::Options::default(), &mut files[8]).expect("memory takes all");
            vtp::write_with(&mesh, vtu::Options::default(), &mut files[9]).expect("memory takes all");
            medit::write(&mesh, &mut files[10]).expect("memory takes all");
            su2::write(&mesh, &mut files[11]).expect("memory takes all");
            inp::write_with(&mesh, Order::Second, &mut files[12]).expect("memory takes all");
            xdmf::write_with(&mesh, Order::Second, &mut files[13]).expect("memory takes all");
            stl::write_with(&mesh, true, &mut files[14]).expect("memory takes all");
            obj::write(&mesh, &mut files[15]).expect("memory takes all");
            files
        };
        prop_assert_eq!(files(), files());
    }
}
