//! File formats by their names and by the ends of file names.

use std::path::Path;

/// A file format that the command knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Triangle's outlines.
    Poly,
    /// Triangle's points.
    Node,
    /// Wavefront's polylines and faces.
    Obj,
    /// Gmsh's geometry scripts.
    Geo,
    /// Gmsh's meshes.
    Msh,
    /// VTK's unstructured grids.
    Vtu,
    /// VTK's polygonal data: boundary lines.
    Vtp,
    /// VTK's legacy files.
    Vtk,
    /// glTF, binary.
    Glb,
    /// glTF, text.
    Gltf,
    /// Medit's meshes, for FreeFEM and Mmg.
    #[value(name = "mesh", alias = "medit")]
    Medit,
    /// SU2's meshes.
    Su2,
    /// Input of Abaqus and CalculiX.
    Inp,
    /// XDMF, for DOLFINx.
    Xdmf,
    /// Facets.
    Stl,
    /// Triangle's triangles.
    Ele,
    /// Triangle's edges.
    Edge,
    /// Triangle's neighbours of triangles.
    Neigh,
    /// Triangle's largest areas of triangles.
    Area,
}

impl Format {
    const ALL: [Self; 19] = [
        Self::Msh,
        Self::Vtu,
        Self::Vtp,
        Self::Vtk,
        Self::Glb,
        Self::Gltf,
        Self::Medit,
        Self::Su2,
        Self::Inp,
        Self::Xdmf,
        Self::Stl,
        Self::Poly,
        Self::Node,
        Self::Obj,
        Self::Geo,
        Self::Ele,
        Self::Edge,
        Self::Neigh,
        Self::Area,
    ];

    /// The format of a file with this name, `.gz` at its end aside.
    pub fn of(path: &Path) -> Option<Self> {
        let mut path = path.to_path_buf();
        if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("gz")) {
            path.set_extension("");
        }
        let end = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::ALL.into_iter().find(|format| format.extension() == end)
    }

    /// The end of a file name, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Poly => "poly",
            Self::Node => "node",
            Self::Obj => "obj",
            Self::Geo => "geo",
            Self::Msh => "msh",
            Self::Vtu => "vtu",
            Self::Vtp => "vtp",
            Self::Vtk => "vtk",
            Self::Glb => "glb",
            Self::Gltf => "gltf",
            Self::Medit => "mesh",
            Self::Su2 => "su2",
            Self::Inp => "inp",
            Self::Xdmf => "xdmf",
            Self::Stl => "stl",
            Self::Ele => "ele",
            Self::Edge => "edge",
            Self::Neigh => "neigh",
            Self::Area => "area",
        }
    }

    /// The name that summaries use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Poly => "Triangle .poly",
            Self::Node => "Triangle .node",
            Self::Obj => "Wavefront OBJ",
            Self::Geo => "Gmsh .geo",
            Self::Msh => "Gmsh .msh",
            Self::Vtu => "VTK",
            Self::Vtp => "VTK lines",
            Self::Vtk => "VTK legacy",
            Self::Glb | Self::Gltf => "glTF",
            Self::Medit => "Medit",
            Self::Su2 => "SU2",
            Self::Inp => "Abaqus",
            Self::Xdmf => "XDMF",
            Self::Stl => "STL",
            Self::Ele => "Triangle .ele",
            Self::Edge => "Triangle .edge",
            Self::Neigh => "Triangle .neigh",
            Self::Area => "Triangle .area",
        }
    }

    /// Whether outlines are read from it.
    pub fn holds_outlines(self) -> bool {
        matches!(self, Self::Poly | Self::Node | Self::Obj | Self::Geo)
    }

    /// Whether outlines are written to it.
    pub fn outlines_are_written(self) -> bool {
        matches!(self, Self::Poly | Self::Obj)
    }

    /// Whether meshes are read from it.
    pub fn meshes_are_read(self) -> bool {
        matches!(
            self,
            Self::Msh | Self::Vtu | Self::Vtk | Self::Medit | Self::Su2 | Self::Inp | Self::Ele
        )
    }

    /// Whether points are in groups in its meshes, and edges in more than one.
    pub fn holds_memberships(self) -> bool {
        matches!(self, Self::Msh | Self::Inp)
    }

    /// Whether meshes are written to it.
    pub fn meshes_are_written(self) -> bool {
        !matches!(self, Self::Geo | Self::Area)
    }

    /// Whether anything is read from it. A `.area` file stands for the mesh beside it, refined.
    pub fn is_read(self) -> bool {
        self.holds_outlines() || self.meshes_are_read() || self == Self::Area
    }
}

/// The formats that pass a test, as `.poly, .node`.
pub fn listed(test: impl Fn(Format) -> bool) -> String {
    let names = Format::ALL.into_iter().filter(|&format| test(format));
    names.map(|format| format!(".{}", format.extension())).collect::<Vec<_>>().join(", ")
}
