//! What may be asked of the files that hold meshes.

use crate::bench::{Bench, SQUARE};

/// The first lines of a text file.
fn head(bench: &Bench, file: &str) -> String {
    String::from_utf8_lossy(&bench.read(file)).lines().take(3).collect::<Vec<_>>().join("\n")
}

#[test]
fn every_format_of_meshes_is_written() {
    let bench = Bench::with("every-format", "square.poly", SQUARE);
    let ends = ["gltf", "inp", "mesh", "obj", "stl", "su2", "vtk", "vtp", "xdmf"];
    let outputs: String = ends.iter().map(|end| format!(" -o a.{end}")).collect();
    bench.succeeds(&format!("mesh square.poly{outputs}"));
    for end in ends {
        assert!(!bench.read(&format!("a.{end}")).is_empty(), "{end}");
    }
}

#[test]
fn an_option_that_no_output_is_about_is_wrong_usage() {
    let bench = Bench::with("no-use", "square.poly", SQUARE);
    for (option, formats) in [
        ("--msh-version 4.1", ".msh"),
        ("--binary", ".msh, .vtk, .stl"),
        ("--order 2", ".msh, .vtu, .vtk, .mesh, .inp, .xdmf"),
        ("--vtk-encoding ascii", ".vtu, .vtp"),
        ("--compress", ".vtu, .vtp"),
        ("--data quality", ".msh, .vtu, .vtk, .xdmf"),
        ("--color quality", ".glb, .gltf"),
        ("--layer 1", ".msh"),
        ("--unique-ids", ".msh"),
    ] {
        let said = bench.fails(&format!("mesh square.poly -o a.su2 {option}"), 2);
        let option = option.strip_suffix(" 4.1").unwrap_or(option);
        let word = option.split_whitespace().next().expect("an option");
        assert!(said.starts_with(&format!("error: {word}")), "{said}");
        assert!(said.contains(&format!(" is for {formats}; no output is one")), "{said}");
    }
    assert_eq!(bench.names(), ["square.poly"]);
}

#[test]
fn a_version_and_a_kind_of_msh_file_are_chosen() {
    let bench = Bench::with("versions", "square.poly", SQUARE);
    for (options, line, name) in [
        ("", "2.2 0 8", "Gmsh 2.2, "),
        ("--binary", "2.2 1 8", "Gmsh 2.2 binary, "),
        ("--msh-version 4.1", "4.1 0 8", "Gmsh 4.1, "),
        ("--msh-version 4.1 --binary", "4.1 1 8", "Gmsh 4.1 binary, "),
        ("--layer 0.5", "2.2 0 8", "Gmsh 2.2, one layer, "),
        ("--for gmsh", "4.1 0 8", "Gmsh 4.1, "),
        ("--for gmsh --msh-version 2.2", "2.2 0 8", "Gmsh 2.2, "),
    ] {
        let said = bench.succeeds(&format!("mesh square.poly -o a.msh {options}")).stderr;
        assert!(said.contains(&format!("wrote     a.msh ({name}")), "{options}: {said}");
        assert!(head(&bench, "a.msh").starts_with(&format!("$MeshFormat\n{line}")), "{options}");
    }
}

#[test]
fn a_solver_gets_its_own_format_where_the_name_does_not_tell() {
    let bench = Bench::with("solvers", "square.poly", SQUARE);
    for (solver, start) in [
        ("freefem", "MeshVersionFormatted 2"),
        ("calculix", "*NODE"),
        ("su2", "NDIME= 2"),
        ("mfem", "$MeshFormat\n2.2"),
        ("paraview", "<?xml"),
    ] {
        bench.succeeds(&format!("mesh square.poly --for {solver} -o mesh.out"));
        assert!(head(&bench, "mesh.out").starts_with(start), "{solver}");
    }
}

#[test]
fn a_file_that_the_solver_does_not_read_is_a_warning() {
    let bench = Bench::with("foreign", "square.poly", SQUARE);
    let said = bench.succeeds("mesh square.poly --for scikit-fem -o a.vtk").stderr;
    assert!(
        said.contains("warning: --for scikit-fem is about .msh, .vtu; .vtk is written as ever"),
        "{said}"
    );
}

#[test]
fn a_solver_that_refuses_interfaces_gets_none_and_that_is_said() {
    let halves = "6 2 0 0\n1 0 0\n2 1 0\n3 2 0\n4 2 1\n5 1 1\n6 0 1\n7 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n\
                  4 4 5 1\n5 5 6 1\n6 6 1 1\n7 2 5 9\n0\n2\n1 0.5 0.5 7 -1\n2 1.5 0.5 8 -1\n";
    let bench = Bench::with("interfaces", "halves.poly", halves);
    let said = bench.succeeds("mesh halves.poly --for dealii -o a.msh").stderr;
    let warning = "warning: --for dealii: 1 edge between two triangles is not written: boundary 9";
    assert!(said.contains(warning), "{said}");
    let text = String::from_utf8(bench.read("a.msh")).expect("text");
    assert!(!text.contains(" 1 2 9 9 "), "{text}");
    let said = bench.fails("mesh halves.poly --for dealii --strict -o b.msh", 4);
    assert!(said.contains("1 warning, and --strict allows none"), "{said}");
    let said = bench.succeeds("mesh halves.poly --interior-segments drop -o c.msh").stderr;
    assert!(!said.contains("warning"), "who asks for it knows it: {said}");
    assert_eq!(bench.read("a.msh"), bench.read("c.msh"));
    let said = bench.succeeds("mesh halves.poly --for dealii --interior-segments keep -o d.msh");
    assert!(!said.stderr.contains("warning"), "{said:?}");
    assert!(String::from_utf8(bench.read("d.msh")).expect("text").contains(" 1 2 9 9 "));
}

#[test]
fn a_name_that_the_format_cannot_hold_is_a_warning() {
    let square = "g no slip\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2 3 4 1\n";
    let bench = Bench::with("words", "square.obj", square);
    let said = bench.succeeds("mesh square.obj -o a.su2 -o a.mesh").stderr;
    let warning = "warning: a.su2: the name `no slip` is written as `no_slip`";
    assert!(said.contains(warning), "{said}");
    let warning = "warning: a.mesh: boundaries have numbers here, no names: `no slip` (1)";
    assert!(said.contains(warning), "{said}");
}
