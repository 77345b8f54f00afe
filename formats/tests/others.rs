//! Meshes that other programs wrote. All hold one domain: two regions with an interface between
//! them, a hole, named groups; `tests/meshes/make.py` made them.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use meshwright_formats::{Mesh, Values, Warning, groups, msh};

fn bytes(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes").join(name);
    fs::read(path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn read_msh(name: &str) -> (Mesh, Vec<String>) {
    let (mesh, warnings) = msh::read(&bytes(name), name).unwrap_or_else(|error| panic!("{error}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
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
