//! Statements that have no effect on a plane mesh.

use super::{SQUARE, warned};

#[test]
fn one_warning_counts_what_is_passed_over() {
    let script = format!(
        "{SQUARE}Recombine Surface {{1}};\nColor Red {{ Surface{{1}}; }}\nMesh.Algorithm = 6;\n\
         Field[1] = Box;\nField[1].VIn = 0.1;\nBackground Field = 1;\n"
    );
    let (_, warnings) = warned(&script);
    assert_eq!(
        warnings,
        ["part.geo:11: 6 statements without effect on this mesh: Background Field, Color, \
          Field (2), Mesh.Algorithm, Recombine Surface"]
    );
}

#[test]
fn statements_about_display_files_and_structure_are_passed_over() {
    for statement in [
        "Transfinite Surface {1} = {1, 2, 3, 4};",
        "Transfinite Surface \"*\" AlternateLeft;",
        "Recombine Surface \"*\";",
        "Smoother Surface {1} = 5;",
        "MeshAlgorithm Surface {1} = 5;",
        "Periodic Line {1} = {-3};",
        "Periodic Curve {2} = {4} Translate {1, 0, 0};",
        "Hide { Curve{1:4}; }",
        "Recursive Hide { Curve{1:4}; }",
        "Show \"*\";",
        "Recursive Color SkyBlue { Surface{1}; }",
        "View \"comments\" { T2(10, -10, 0){ StrCat(\"Created on \", Today) }; };",
        "View[0].Visible = 0;",
        "General.SmallAxes = 0;",
        "Geometry.DoubleClickedCurveCommand = \"Printf('%g');\";",
        "Mesh.Color.Points = {255, 0, 0};",
        "Geometry.Color.Points = Red;",
        "Mesh 2;",
        "Save \"part.msh\";",
        "Save Sprintf(\"part-%g.msh\", 1);",
        "SetOrder 2;",
        "Printf(\"%g and %g\", 1, 2);",
        "Plugin(AnalyseMeshQuality).Run;",
        "Coherence Mesh;",
        "BoundaryLayer Field = 1;",
        "Field[1].F = \"x*y\";",
        "Compound Curve {1, 2};",
        "Physical Volume(1) = {1};",
    ] {
        let (pslg, warnings) = warned(&format!("{SQUARE}{statement}\n"));
        assert_eq!(pslg.segments.len(), 4);
        assert_eq!(warnings.len(), 1, "{statement}");
        assert!(warnings[0].starts_with("part.geo:11: 1 statement without effect"), "{warnings:?}");
    }
}
