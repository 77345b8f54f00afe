//! Meshes from every format to every other, and back to outlines.

use meshwright::Mesh;
use meshwright::formats::groups::stated_tag;
use meshwright::formats::{ele, inp, medit, msh, su2, vtk, vtu};
use meshwright::statistics::Statistics;

use crate::bench::Bench;

/// Two rooms, a hole, an interface, names for all.
const ROOMS: &str = include_str!("../fixtures/named_rooms.geo");

/// A kind of file that is read and written: the files of one mesh, and the options that make them.
const KINDS: [(&str, &str, &str); 12] = [
    ("22.msh", "", "all"),
    ("22b.msh", "--binary", "all"),
    ("41.msh", "--msh-version 4.1", "all"),
    ("41b.msh", "--msh-version 4.1 --binary", "all"),
    ("raw.vtu", "", "all"),
    ("text.vtu", "--vtk-encoding ascii", "all"),
    ("zlib.vtu", "--vtk-encoding base64 --compress", "all"),
    ("text.vtk", "", "all"),
    ("bytes.vtk", "--binary", "all"),
    ("medit.mesh", "", "numbers"),
    ("ccx.inp", "", "names"),
    ("su2.su2", "", "boundary names"),
];

/// Formats that are written only.
const WRITTEN_ONLY: [&str; 8] =
    ["a.glb", "a.gltf", "a.vtp", "a.xdmf", "a.stl", "a.obj", "a.edge", "a.neigh"];

fn read(bench: &Bench, file: &str) -> Mesh {
    let bytes = bench.read(file);
    let end = file.rsplit('.').next().unwrap_or_default();
    let read = match end {
        "msh" => msh::read(&bytes, file).map_err(|error| error.to_string()),
        "vtu" => vtu::read(&bytes, file).map_err(|error| error.to_string()),
        "vtk" => vtk::read(&bytes, file).map_err(|error| error.to_string()),
        "mesh" => medit::read(&bytes, file).map_err(|error| error.to_string()),
        "su2" => su2::read(&bytes, file).map_err(|error| error.to_string()),
        "inp" => inp::read(&bytes, file).map_err(|error| error.to_string()),
        "ele" => {
            let beside = |name: &str| std::fs::read(bench.path(name));
            ele::read_with_companions(&bytes, file, beside).map_err(|error| error.to_string())
        }
        _ => panic!("{file} is not read"),
    };
    read.unwrap_or_else(|error| panic!("{error}")).0
}

/// A group of a mesh: its dimension, its name (or `#` and its number), its number, its cells.
type Group = (u8, String, Option<i32>, usize);

fn groups(mesh: &Mesh) -> Vec<Group> {
    let group = |group: &meshwright::statistics::GroupCount| {
        let name = group.name.clone();
        let told = name.as_ref().map_or(Some(group.tag), |name| stated_tag(group.dim, name));
        match (told, name) {
            (None, Some(name)) => (group.dim, name, Some(group.tag), group.count),
            (told, _) => (group.dim, format!("#{}", told.unwrap_or(0)), None, group.count),
        }
    };
    let mut groups: Vec<Group> = Statistics::of(mesh).groups.iter().map(group).collect();
    groups.retain(|group| group.3 > 0);
    groups.sort();
    groups
}

/// What a format that holds this keeps of groups.
fn kept(groups: &[Group], holds: &str, interfaces: &[String]) -> Vec<Group> {
    let triangles: usize = groups.iter().filter(|group| group.0 == 2).map(|group| group.3).sum();
    let mut kept: Vec<Group> = groups
        .iter()
        .filter(|group| holds != "boundary names" || group.0 == 1)
        .filter(|group| holds != "boundary names" || !interfaces.contains(&group.1))
        .map(|(dim, name, number, count)| match (holds, number) {
            ("numbers", Some(number)) => (*dim, format!("#{number}"), None, *count),
            ("all" | "numbers", _) => (*dim, name.clone(), *number, *count),
            _ => (*dim, name.clone(), None, *count),
        })
        .collect();
    if holds == "boundary names" {
        kept.push((2, "#0".to_owned(), None, triangles));
    }
    kept.sort();
    kept
}

/// The groups without the numbers that a format of names alone cannot hold.
fn comparable(groups: Vec<Group>, holds: &str) -> Vec<Group> {
    let keeps = matches!(holds, "all" | "numbers");
    let group = |(dim, name, number, count)| (dim, name, if keeps { number } else { None }, count);
    groups.into_iter().map(group).collect()
}

/// Whether two meshes have the same points, bit for bit, and the same triangles, whatever their order.
fn same_geometry(a: &Mesh, b: &Mesh) -> bool {
    let bits = |point: &[f64; 2]| point.map(f64::to_bits);
    let points = |mesh: &Mesh| {
        let mut points: Vec<[u64; 2]> = mesh.points.iter().map(bits).collect();
        points.sort_unstable();
        points
    };
    let triangles = |mesh: &Mesh| {
        let corners = |triangle: &[u32; 3]| {
            let mut corners = triangle.map(|v| bits(&mesh.points[v as usize]));
            corners.sort_unstable();
            corners
        };
        let mut triangles: Vec<[[u64; 2]; 3]> = mesh.triangles.iter().map(corners).collect();
        triangles.sort_unstable();
        triangles
    };
    points(a) == points(b) && triangles(a) == triangles(b)
}

/// The partition, by its name and by its number in this mesh.
fn interfaces(mesh: &Mesh) -> Vec<String> {
    let named = mesh.groups.iter().filter(|group| group.dim == 1 && group.name == "partition");
    let numbers = named.map(|group| format!("#{}", group.tag));
    ["partition".to_owned(), "#7".to_owned()].into_iter().chain(numbers).collect()
}

#[test]
fn names_numbers_and_counts_survive_every_pair() {
    let bench = Bench::with("convert-pairs", "rooms.geo", ROOMS);
    bench.succeeds("mesh rooms.geo -o start.msh --max-area 0.02");
    let start = read(&bench, "start.msh");
    assert_eq!(groups(&start).len(), 7, "{:?}", groups(&start));
    for (from, options, holds) in KINDS {
        bench.succeeds(&format!("convert start.msh from_{from} {options}"));
        let source = read(&bench, &format!("from_{from}"));
        let expected = kept(&groups(&start), holds, &interfaces(&start));
        assert_eq!(comparable(groups(&source), holds), expected, "{from}");
        for (to, options, holds) in KINDS {
            bench.succeeds(&format!("convert from_{from} to_{to} {options}"));
            let target = read(&bench, &format!("to_{to}"));
            assert!(same_geometry(&target, &start), "{from} to {to}");
            // Numbers alone may tell the partition.
            let expected = kept(&groups(&source), holds, &interfaces(&source));
            assert_eq!(comparable(groups(&target), holds), expected, "{from} to {to}");
        }
        for to in WRITTEN_ONLY {
            bench.succeeds(&format!("convert from_{from} {to}"));
        }
    }
}

#[test]
fn the_files_of_triangle_are_one_of_the_pairs() {
    let bench = Bench::with("convert-triangle", "rooms.geo", ROOMS);
    bench.succeeds("mesh rooms.geo -o start.msh");
    let start = read(&bench, "start.msh");
    let expected = kept(&groups(&start), "numbers", &[]);
    for (from, options, holds) in KINDS {
        bench.succeeds(&format!("convert start.msh from_{from} {options}"));
        bench.succeeds(&format!("convert from_{from} a.node a.ele a.poly"));
        let target = read(&bench, "a.ele");
        assert!(same_geometry(&target, &start), "{from}");
        if holds == "all" {
            assert_eq!(groups(&target), expected, "{from}");
        }
        bench.succeeds(&format!("convert a.ele to_{from} {options}"));
        assert!(same_geometry(&read(&bench, &format!("to_{from}")), &start), "{from}");
    }
}

#[test]
fn every_mesh_that_is_read_is_judged_and_told_of() {
    let bench = Bench::with("convert-check", "rooms.geo", ROOMS);
    bench.succeeds("mesh rooms.geo -o start.msh");
    for (file, options, _) in KINDS {
        bench.succeeds(&format!("convert start.msh {file} {options}"));
        bench.succeeds(&format!("check {file}"));
        let told = bench.succeeds(&format!("info {file}")).stdout;
        let told = told.lines().find(|line| line.starts_with("area")).map(str::to_owned);
        let start = bench.succeeds("info start.msh").stdout;
        assert_eq!(told.as_deref(), start.lines().find(|line| line.starts_with("area")), "{file}");
    }
}

#[test]
fn the_boundary_of_a_mesh_is_an_outline_that_can_be_meshed_again() {
    let bench = Bench::with("convert-outline", "rooms.geo", ROOMS);
    bench.succeeds("mesh rooms.geo -o fine.msh --max-area 0.001");
    bench.succeeds("convert fine.msh outline.poly");
    let told = bench.succeeds("info outline.poly").stdout;
    assert!(told.contains("1 hole, 2 regions"), "{told}");
    assert!(told.contains("ready to mesh"), "{told}");
    bench.succeeds("mesh outline.poly -o again.msh --strict");
    bench.succeeds("check again.msh --input outline.poly");
    let (fine, again) = (read(&bench, "fine.msh"), read(&bench, "again.msh"));
    let area = |mesh: &Mesh| Statistics::of(mesh).area;
    assert!((area(&fine) - area(&again)).abs() < 1e-12);
    assert!(again.points.len() < fine.points.len() / 2, "nothing inside is kept");
    let tags = |mesh: &Mesh| {
        let mut tags = [mesh.edge_tags.clone(), mesh.triangle_tags.clone()];
        tags.iter_mut().for_each(|tags| {
            tags.sort_unstable();
            tags.dedup();
        });
        tags
    };
    assert_eq!(tags(&again), tags(&fine));
}

#[test]
fn what_cannot_be_converted_is_said() {
    let bench = Bench::with("convert-refused", "rooms.geo", ROOMS);
    let said = bench.fails("convert rooms.geo a.msh", 2);
    assert!(said.contains("rooms.geo holds an outline, and .msh files hold meshes"), "{said}");
    bench.succeeds("mesh rooms.geo -o a.msh");
    let said = bench.fails("convert a.msh b.poly --repair", 2);
    assert!(said.contains("--repair is for outlines; a.msh holds a mesh"), "{said}");
    let said = bench.fails("convert a.msh b.mesh --strict", 4);
    assert!(said.contains("numbers here, no names"), "{said}");
    let half = bench.read("a.msh").len() / 2;
    bench.put("half.msh", &bench.read("a.msh")[..half]);
    let said = bench.fails("convert half.msh b.vtu", 1);
    assert!(said.starts_with("error: half.msh:"), "{said}");
    assert_eq!(bench.names(), ["a.msh", "half.msh", "rooms.geo"], "nothing is left");
}
