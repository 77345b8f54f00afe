//! Meshes that other programs wrote. All hold one domain: two regions with an interface between
//! them, a hole, named groups; `tests/meshes/make.py` made them.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use meshwright_formats::{Mesh, Values, Warning, groups, inp, medit, msh, su2, vtk, vtu};

fn bytes(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes").join(name);
    fs::read(path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn read_msh(name: &str) -> (Mesh, Vec<String>) {
    let (mesh, warnings) = msh::read(&bytes(name), name).unwrap_or_else(|error| panic!("{error}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
}

fn read_vtk(name: &str) -> (Mesh, Vec<String>) {
    let read = match name.ends_with(".vtu") {
        true => vtu::read(&bytes(name), name).map_err(|error| error.to_string()),
        false => vtk::read(&bytes(name), name).map_err(|error| error.to_string()),
    };
    let (mesh, warnings) = read.unwrap_or_else(|error| panic!("{error}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
}

/// Checks a mesh against another that has the same items in the same order; text of few digits
/// may have moved the points.
fn same(mesh: &Mesh, expected: &Mesh, name: &str) {
    let close = |(a, b): (&[f64; 2], &[f64; 2])| (0..2).all(|k| (a[k] - b[k]).abs() < 1e-5);
    assert_eq!(mesh.points.len(), expected.points.len(), "{name}");
    assert!(mesh.points.iter().zip(&expected.points).all(close), "{name}");
    assert_eq!(mesh.triangles, expected.triangles, "{name}");
    assert_eq!(mesh.triangle_tags, expected.triangle_tags, "{name}");
    assert_eq!(mesh.edges, expected.edges, "{name}");
    assert_eq!(mesh.edge_tags, expected.edge_tags, "{name}");
    assert_eq!(mesh.memberships, expected.memberships, "{name}");
}

/// The corners of a cell, in billionths (16 digits of text are not every double), and its group.
type Cell = (Vec<[i64; 2]>, String);

/// What a mesh says, whatever the order in which it says it: cells by their corners' coordinates,
/// each with the name of its group.
#[derive(Debug, PartialEq)]
struct Told {
    points: usize,
    edges: Vec<Cell>,
    triangles: Vec<Cell>,
}

fn told(mesh: &Mesh) -> Told {
    let name = |dim: u8, tag| {
        let group = mesh.groups.iter().find(|group| (group.dim, group.tag) == (dim, tag));
        group.map_or_else(|| groups::stated_name(dim, tag), |group| group.name.clone())
    };
    let place = |&v: &u32| mesh.points[v as usize].map(|x| (x * 1e9).round() as i64);
    let cell = |corners: &[u32], name: String| {
        let mut places: Vec<[i64; 2]> = corners.iter().map(place).collect();
        places.sort_unstable();
        (places, name)
    };
    let edges = mesh.edges.iter().enumerate();
    let mut edges: Vec<_> = edges.map(|(i, e)| cell(e, name(1, mesh.edge_tag(i)))).collect();
    let triangles = mesh.triangles.iter().enumerate();
    let mut triangles: Vec<_> =
        triangles.map(|(i, t)| cell(t, name(2, mesh.triangle_tag(i)))).collect();
    edges.sort_unstable();
    triangles.sort_unstable();
    Told { points: mesh.points.len(), edges, triangles }
}

/// How many cells each group has.
fn counts(cells: &[Cell]) -> BTreeMap<&str, usize> {
    let mut counts = BTreeMap::new();
    cells.iter().for_each(|(_, name)| *counts.entry(name.as_str()).or_insert(0) += 1);
    counts
}

#[test]
fn the_domain_is_what_it_was_made_as() {
    let (mesh, warnings) = read_msh("gmsh_22_ascii.msh");
    assert!(warnings.is_empty(), "{warnings:?}");
    let told = told(&mesh);
    assert_eq!(told.points, 27);
    assert_eq!(
        counts(&told.edges),
        BTreeMap::from([
            ("in flow", 2),
            ("interface wall", 2),
            ("outlet", 2),
            ("pillar", 3),
            ("wall", 8)
        ])
    );
    assert_eq!(counts(&told.triangles), BTreeMap::from([("Stein ß", 14), ("water", 25)]));
    assert_eq!(mesh.memberships.len(), 1, "the corner");
}

#[test]
fn every_msh_of_gmsh_holds_the_same() {
    let expected = told(&read_msh("gmsh_22_ascii.msh").0);
    for name in ["gmsh_22_binary.msh", "gmsh_41_ascii.msh", "gmsh_41_binary.msh"] {
        let (mesh, warnings) = read_msh(name);
        assert!(warnings.is_empty(), "{warnings:?}");
        assert_eq!(told(&mesh), expected, "{name}");
        assert_eq!(mesh.memberships.len(), 1, "{name}");
    }
}

#[test]
fn second_order_meshes_are_read_by_their_corners() {
    let expected = told(&read_msh("gmsh_22_ascii.msh").0);
    for version in ["22", "41"] {
        for kind in ["ascii", "binary"] {
            let name = format!("order2_{version}_{kind}.msh");
            let (mesh, warnings) = read_msh(&name);
            assert_eq!(told(&mesh), expected, "{name}");
            let said = "56 cells of second or higher order are read by their corners; 66 nodes \
                        between them are left out";
            assert_eq!(warnings, [format!("{name}: {said}")]);
        }
    }
}

#[test]
fn data_of_nodes_and_elements_are_kept() {
    for version in ["22", "41"] {
        for kind in ["ascii", "binary"] {
            let (mesh, _) = read_msh(&format!("data_{version}_{kind}.msh"));
            let [load] = &mesh.triangle_data[..] else { panic!("one array for triangles") };
            assert_eq!((load.name.as_str(), load.components), ("load", 1));
            let expected = (0..39).map(|i| f64::from(i) + 0.5).collect();
            assert_eq!(load.values, Values::Real(expected));
            let [speed] = &mesh.point_data[..] else { panic!("one array for points") };
            assert_eq!((speed.name.as_str(), speed.components), ("speed", 3));
            let Values::Real(values) = &speed.values else { panic!("real numbers") };
            assert_eq!(values.len(), 3 * mesh.points.len());
            assert_eq!(values[75..], [25.0, 0.25, 0.0, 26.0, 0.25, 0.0]);
        }
    }
}

#[test]
fn every_encoding_of_vtk_and_meshio_is_read() {
    let (expected, _) = read_msh("gmsh_22_ascii.msh");
    for name in [
        "meshio_ascii.vtu",
        "meshio_plain.vtu",
        "meshio_zlib.vtu",
        "meshio_42.vtk",
        "meshio_51.vtk",
        "vtk_ascii.vtu",
        "vtk_inline_zlib.vtu",
        "vtk_inline_plain_big.vtu",
        "vtk_raw_plain_big.vtu",
        "vtk_raw_zlib.vtu",
        "vtk_base64_plain.vtu",
        "vtk_base64_zlib.vtu",
        "vtk_42_ascii.vtk",
        "vtk_42_binary.vtk",
        "vtk_51_ascii.vtk",
        "vtk_51_binary.vtk",
    ] {
        let (mesh, warnings) = read_vtk(name);
        assert!(warnings.is_empty(), "{name}: {warnings:?}");
        same(&mesh, &expected, name);
        if name.starts_with("vtk") {
            let [depth] = &mesh.point_data[..] else { panic!("{name}: one array of points") };
            assert_eq!((depth.name.as_str(), depth.components), ("depth of water", 1), "{name}");
            let [load] = &mesh.triangle_data[..] else { panic!("{name}: one array of triangles") };
            // The triangles are the last 39 of 57 cells.
            let values = (18..57).map(|i| f64::from(i) + 0.5).collect();
            assert_eq!((load.name.as_str(), &load.values), ("load", &Values::Real(values)));
        }
    }
}

#[test]
fn polygons_of_vtk_are_read_with_their_tags() {
    let (mut expected, _) = read_msh("gmsh_22_ascii.msh");
    expected.groups.clear(); // VTK knows their numbers alone
    let (mesh, _) = read_vtk("vtk_polydata.vtk");
    assert_eq!(told(&mesh), told(&expected));
}

#[test]
fn vtk_files_of_gmsh_are_read_with_the_numbers_of_entities() {
    let expected = told(&read_msh("gmsh_22_ascii.msh").0);
    for name in ["gmsh.vtk", "gmsh_binary.vtk", "order2.vtk"] {
        let found = told(&read_vtk(name).0);
        assert_eq!((found.points, found.edges.len()), (expected.points, expected.edges.len()));
        assert_eq!(counts(&found.triangles).into_values().collect::<Vec<_>>(), [25, 14], "{name}");
    }
}

/// Every part of the file up to a place where a whole file may end, and any byte changed.
#[test]
fn files_that_are_cut_or_changed_are_read_or_refused() {
    for name in ["gmsh_22_ascii.msh", "gmsh_41_ascii.msh", "gmsh_41_binary.msh"] {
        let bytes = bytes(name);
        for length in 0..bytes.trim_ascii_end().len() {
            assert!(msh::read(&bytes[..length], name).is_err(), "{name}, {length} bytes");
        }
    }
    for name in ["vtk_51_ascii.vtk", "vtk_42_binary.vtk", "vtk_polydata.vtk"] {
        let bytes = bytes(name);
        for length in 0..bytes.len() {
            let _ = vtk::read(&bytes[..length], name);
            let mut changed = bytes.clone();
            changed[length] ^= 0x11;
            let _ = vtk::read(&changed, name);
        }
    }
    for name in ["meshio_zlib.vtu", "vtk_raw_zlib.vtu", "vtk_inline_plain_big.vtu"] {
        let bytes = bytes(name);
        for length in 0..bytes.trim_ascii_end().len() {
            assert!(vtu::read(&bytes[..length], name).is_err(), "{name}, {length} bytes");
            let mut changed = bytes.clone();
            changed[length] ^= 0x11;
            let _ = vtu::read(&changed, name);
        }
    }
}

/// The counts of edges and triangles by group, in the order of their numbers.
fn sizes(mesh: &Mesh) -> [Vec<(i32, usize)>; 2] {
    let counted = |tags: &[i32]| {
        let mut counts = BTreeMap::new();
        tags.iter().for_each(|&tag| *counts.entry(tag).or_insert(0) += 1);
        counts.into_iter().collect()
    };
    [counted(&mesh.edge_tags), counted(&mesh.triangle_tags)]
}

#[test]
fn medit_files_are_read_with_their_numbers() {
    let (expected, _) = read_msh("gmsh_22_ascii.msh");
    let read = |name: &str| {
        let read = medit::read(&bytes(name), name);
        read.unwrap_or_else(|error| panic!("{error}")).0
    };
    let mesh = read("meshio.mesh");
    assert_eq!((mesh.points.len(), sizes(&mesh)), (27, sizes(&expected)));
    // Gmsh writes the numbers of its entities.
    let mesh = read("gmsh.mesh");
    assert_eq!((mesh.points.len(), mesh.edges.len()), (27, 17));
    assert_eq!(sizes(&mesh)[1], [(1, 25), (2, 14)]);
}

#[test]
fn su2_files_are_read_with_their_markers() {
    let expected = in_words(told(&read_msh("gmsh_22_ascii.msh").0));
    let (mesh, _) = su2::read(&bytes("gmsh.su2"), "gmsh.su2").unwrap_or_else(|e| panic!("{e}"));
    let found = told(&mesh);
    assert_eq!(found.edges, expected.edges);
    assert_eq!((found.points, found.triangles.len()), (27, 39));
}

/// With names that are single words, as Gmsh writes them where names must be.
fn in_words(mut told: Told) -> Told {
    let cells = told.edges.iter_mut().chain(&mut told.triangles);
    cells.for_each(|(_, name)| *name = name.replace(' ', "_"));
    told
}

#[test]
fn sets_of_gmsh_are_read_with_their_names() {
    let expected = in_words(told(&read_msh("gmsh_22_ascii.msh").0));
    for name in ["gmsh.inp", "order2.inp"] {
        let (mesh, _) = inp::read(&bytes(name), name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(told(&mesh), expected, "{name}");
    }
}

#[test]
fn half_a_surrogate_in_a_name_is_an_error_with_its_place() {
    // U+D800 as three bytes, as a reference, and as escaped bytes.
    let half = b"\xed\xa0\x80";
    let named = |head: &str, tail: &str| [head.as_bytes(), half, tail.as_bytes()].concat();
    let file = named("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"", "\"\n");
    let error = msh::read(&file, "a.msh").expect_err("no name").to_string();
    assert!(error.starts_with("a.msh:6:5: expected a name between double quotes"), "{error}");
    assert!(error.ends_with("help: its bytes are no UTF-8"), "{error}");
    let file = named("NDIME= 2\nMARKER_TAG= ", "\n");
    let error = su2::read(&file, "a.su2").expect_err("no name").to_string();
    assert!(error.starts_with("a.su2:2:13: expected a name in UTF-8"), "{error}");
    let file = named("*NODE, NSET=", "\n");
    let error = inp::read(&file, "a.inp").expect_err("no name").to_string();
    assert!(error.starts_with("a.inp:1:1: expected a keyword line in UTF-8"), "{error}");
    let file =
        "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nFIELD F 1\n%ED%A0%80 1 1 int\n";
    let error = vtk::read(file.as_bytes(), "a.vtk").expect_err("no name").to_string();
    assert!(error.starts_with("a.vtk:6:1: expected a name in UTF-8, found `%ED%A0%80`"), "{error}");
    let file = "<VTKFile type=\"UnstructuredGrid\">\n<DataArray type=\"Int8\" Name=\"&#xD800;\"/></VTKFile>";
    let error = vtu::read(file.as_bytes(), "a.vtu").expect_err("no name").to_string();
    assert!(error.starts_with("a.vtu: line 2: "), "{error}");
    let file = named("<VTKFile type=\"UnstructuredGrid\">\n<DataArray Name=\"", "\"/></VTKFile>");
    let error = vtu::read(&file, "a.vtu").expect_err("no name").to_string();
    assert_eq!(error, "a.vtu: line 2: the header is not UTF-8");
}

#[test]
fn a_billion_announced_takes_no_memory() {
    let billion = "1000000000";
    let msh2 = format!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{billion}\n1 0 0 0\n");
    let msh4 = format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {billion} 1 {billion}\n\
                        2 1 0 {billion}\n1\n"
    );
    let vtk =
        format!("# vtk DataFile Version 5.1\n\nASCII\nDATASET POLYDATA\nPOINTS {billion} float\n");
    let medit = format!("MeshVersionFormatted 2 Dimension 2 Vertices {billion}\n0 0 0\n");
    let su2 = format!("NDIME= 2\nNPOIN= {billion}\n0 0\n");
    let found = "found the end of the file";
    let says = |error: &dyn std::fmt::Display| {
        let error = error.to_string();
        assert!(error.contains(found) && error.contains(billion), "{error}");
    };
    says(&msh::read(msh2.as_bytes(), "a").expect_err("cut"));
    says(&msh::read(msh4.as_bytes(), "a").expect_err("cut"));
    says(&vtk::read(vtk.as_bytes(), "a").expect_err("cut"));
    says(&medit::read(medit.as_bytes(), "a").expect_err("cut"));
    says(&su2::read(su2.as_bytes(), "a").expect_err("cut"));
}
