//! Statements that are not read: what is passed over, what is refused, and what they are called.

use super::expressions::option_path;
use super::input::Text;
use super::tokens::{Until, word};

/// Whether a statement that begins with this word makes something that no plane has.
pub(super) fn is_solid(first: &str) -> bool {
    matches!(
        first,
        "Volume"
            | "Box"
            | "Sphere"
            | "Cylinder"
            | "Cone"
            | "Torus"
            | "Wedge"
            | "ThruSections"
            | "Ruled"
            | "Fillet"
            | "Chamfer"
            | "Nurbs"
            | "Surface"
            | "PolarSphere"
            | "ParametricSphere"
            | "Compound"
            | "SystemCall"
            | "NonBlockingSystemCall"
            | "OnelabRun"
            | "CreateTopology"
            | "CreateGeometry"
            | "ClassifySurfaces"
    )
}

/// Where a statement ends that has no effect on a plane mesh; `None` if it is none of those.
pub(super) fn is_skipped(input: Text, first: &str) -> Option<Until> {
    let (rest, _) = word(input).ok()?;
    let second = word(rest).map_or("", |(_, word)| word);
    Some(match (first, second) {
        ("Color" | "Hide" | "Show" | "View", _) => Until::Block,
        ("Background" | "BoundaryLayer", "Field") => Until::Semicolon,
        // `Mesh 2;`
        ("Mesh", "") if !rest.rest.starts_with(b".") => Until::Semicolon,
        (
            "Field"
            | "Periodic"
            | "Recombine"
            | "Smoother"
            | "MeshAlgorithm"
            | "Reverse"
            | "ReverseMesh"
            | "ReorientMesh"
            | "OptimizeMesh"
            | "RefineMesh"
            | "RecombineMesh"
            | "RenumberMeshNodes"
            | "RenumberMeshElements"
            | "RelocateMesh"
            | "SetOrder"
            | "Save"
            | "Print"
            | "Printf"
            | "Warning"
            | "Draw"
            | "SetChanged"
            | "Sleep"
            | "Plugin"
            | "General"
            | "Solver"
            | "PostProcessing"
            | "Print_"
            | "TransfQuadTri"
            | "MeshSizeFromBoundary"
            | "UndefineConstant"
            | "SetNumber"
            | "SetString"
            | "Parent"
            | "BoundingBox"
            | "NewModel"
            | "Combine"
            | "Homology"
            | "Cohomology",
            _,
        ) => Until::Semicolon,
        _ => return None,
    })
}

/// The words that a statement begins with, for messages: `Color Red`, `Recombine Surface`.
pub(super) fn title(input: Text) -> String {
    let Ok((mut rest, first)) = word(input) else { return String::new() };
    let mut title = first.to_owned();
    if rest.rest.starts_with(b".") {
        return option_path(rest, title.clone()).map_or(title, |(_, path)| path);
    }
    if matches!(first, "Color" | "Hide" | "Show" | "View" | "Field" | "Printf" | "Print") {
        return title;
    }
    while let Ok((after, next)) = word(rest) {
        title = format!("{title} {next}");
        rest = after;
    }
    title
}
