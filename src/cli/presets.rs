//! What each solver wants of a file: the presets of `--for`.
//!
//! A preset fills in what the user leaves open; what is asked for beside it stays.

use meshwright::formats::msh::Version;
use meshwright::formats::selection::Cells;

use super::format::Format;
use super::words::Interior;

/// A program that reads the files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Solver {
    /// Gmsh: .msh 4.1, its own version.
    Gmsh,
    /// ParaView: .vtu with everything in it.
    Paraview,
    /// FEniCSx (DOLFINx): .msh 4.1, where an edge in two groups is one facet; or .xdmf.
    Fenicsx,
    /// MFEM: .msh 2.2, every edge once.
    Mfem,
    /// scikit-fem: .msh 2.2 with unique ids, for it mixes up a region and a boundary of one number;
    /// every edge once, for it keeps the last group.
    ScikitFem,
    /// deal.II: .msh 2.2 without edges between triangles, which it refuses; every edge once.
    Dealii,
    /// NGSolve: .msh 2.2, every group with a name.
    Ngsolve,
    /// GetDP: .msh 2.2 with unique ids, for its groups are numbers alone.
    Getdp,
    /// FreeFEM: Medit's .mesh; its labels are numbers.
    Freefem,
    /// SfePy: Medit's .mesh with triangles alone; the numbers of points are its groups.
    Sfepy,
    /// CalculiX: .inp.
    Calculix,
    /// OpenFOAM: .msh 2.2, one layer of prisms of thickness 1, for gmshToFoam.
    Openfoam,
    /// Elmer: .msh 2.2 for ElmerGrid; by its manual, not run.
    Elmer,
    /// SU2: .su2, boundaries by name; by its manual, not run.
    Su2,
}

/// What a solver wants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Preset {
    /// The formats that it reads; a file whose name does not tell is in the first.
    pub formats: &'static [Format],
    /// The version of `.msh` files.
    pub version: Version,
    /// What cells a file holds.
    pub cells: Cells,
    /// What becomes of edges between two triangles.
    pub interior: Interior,
    /// Whether no number may serve a boundary and a region.
    pub unique_ids: bool,
    /// Whether an edge stands there once, in its first group alone.
    pub one_group: bool,
    /// The thickness of the layer that the mesh becomes.
    pub layer: Option<f64>,
}

/// A file with everything in it, in the version that most programs read.
const PLAIN: Preset = Preset {
    formats: &[Format::Msh],
    version: Version::V2_2,
    cells: Cells::All,
    interior: Interior::Keep,
    unique_ids: false,
    one_group: false,
    layer: None,
};

impl Solver {
    /// What this solver wants.
    pub fn preset(self) -> Preset {
        use Format::{Gltf, Inp, Medit, Msh, Su2, Vtk, Vtp, Vtu, Xdmf};
        match self {
            Self::Gmsh => Preset { version: Version::V4_1, ..PLAIN },
            Self::Paraview => Preset { formats: &[Vtu, Vtk, Vtp, Xdmf, Gltf], ..PLAIN },
            Self::Fenicsx => Preset { formats: &[Msh, Xdmf], version: Version::V4_1, ..PLAIN },
            Self::Ngsolve | Self::Elmer => PLAIN,
            Self::Mfem => Preset { one_group: true, ..PLAIN },
            Self::ScikitFem => {
                let formats = &[Msh, Vtu];
                Preset { formats, unique_ids: true, one_group: true, ..PLAIN }
            }
            Self::Dealii => Preset { interior: Interior::Drop, one_group: true, ..PLAIN },
            Self::Getdp => Preset { unique_ids: true, ..PLAIN },
            Self::Freefem => Preset { formats: &[Medit], ..PLAIN },
            Self::Sfepy => Preset { formats: &[Medit], cells: Cells::Faces, ..PLAIN },
            Self::Calculix => Preset { formats: &[Inp], ..PLAIN },
            Self::Openfoam => Preset { layer: Some(1.0), ..PLAIN },
            Self::Su2 => Preset { formats: &[Su2], ..PLAIN },
        }
    }

    /// The name that `--for` takes.
    pub fn name(self) -> String {
        let value = clap::ValueEnum::to_possible_value(&self);
        value.map(|value| value.get_name().to_owned()).unwrap_or_default()
    }
}
