//! How mesh files are written: what may be asked for, and the one place that leads from a format
//! to its writer.

use std::borrow::Cow;
use std::io::{self, Write};

use clap::Args;
use meshwright::certify::Certificate;
use meshwright::formats::groups::Note;
use meshwright::formats::msh::Version;
use meshwright::formats::selection::{Cells, select, without_interfaces};
use meshwright::formats::vtu::Encoding;
use meshwright::formats::{
    Data, Mesh, Order, Values, edge, ele, gltf, inp, medit, msh, neigh, node, obj, poly, stl, su2,
    vtk, vtp, vtu, xdmf,
};
use meshwright::statistics::Quality;

use super::colors;
use super::failure::Failure;
use super::format::{Format, listed};
use super::options::positive;
use super::presets::{Preset, Solver};
use super::voice::Voice;
use super::words::{
    CELLS, COLORS, Color, ENCODINGS, EXTRAS, Extra, INTERIORS, Interior, MSH_VERSIONS, ORDERS,
    one_of, word,
};

/// How mesh files are written: the same options for every command that writes one.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "What files hold")]
pub struct WriteOptions {
    /// What this solver takes: its format where a name does not tell, version, numbers, cells.
    /// Without it a file holds all that its format has a place for.
    #[arg(long = "for", value_name = "SOLVER")]
    solver: Option<Solver>,
    /// The version of .msh files: 2.2, which most programs read, or 4.1, where an edge in several
    /// groups is one element [default: 2.2].
    #[arg(long, value_name = "VERSION", value_parser = one_of(MSH_VERSIONS))]
    msh_version: Option<Version>,
    /// Numbers as bytes (.msh, .vtk, .stl): smaller and faster; without it text, which more
    /// programs read. In .stl coordinates are then single precision, and regions have no name.
    #[arg(long)]
    binary: bool,
    /// Elements with a node in the middle of each side (2: .msh, .vtu, .vtk, .mesh, .inp, .xdmf), or
    /// with corners alone (1); the sides stay straight [default: 1].
    #[arg(long, value_name = "ORDER", value_parser = one_of(ORDERS))]
    order: Option<Order>,
    /// The arrays of .vtu and .vtp: bytes (raw), a third larger within the XML (base64), or text;
    /// what they hold is the same [default: raw].
    #[arg(long, value_name = "HOW", value_parser = one_of(ENCODINGS))]
    vtk_encoding: Option<Encoding>,
    /// Compress the arrays of .vtu and .vtp with zlib: smaller and slower; fewer programs read it.
    #[arg(long)]
    compress: bool,
    /// What cells files hold: all, triangles alone (faces; of boundaries points keep the number, where
    /// the format has one), or edges with their points (segments; regions are lost) [default: all].
    #[arg(long, value_parser = one_of(CELLS))]
    cells: Option<Cells>,
    /// What becomes of edges between two triangles (drop: their tags and names are lost)
    /// [default: keep].
    #[arg(long, value_name = "WHAT", value_parser = one_of(INTERIORS))]
    interior_segments: Option<Interior>,
    /// Further data of triangles: quality (smallest and largest angle in degrees, circumradius over
    /// shortest edge, area), excuse (the place of its angle in the certificate's list, from 1).
    #[arg(long, value_name = "WHAT", value_delimiter = ',', value_parser = one_of(EXTRAS))]
    data: Vec<Extra>,
    /// What the colours of .glb and .gltf tell: regions, or the smallest angle of each triangle, dark
    /// where it is small; then triangles share no vertices [default: region].
    #[arg(long, value_name = "WHAT", value_parser = one_of(COLORS))]
    color: Option<Color>,
    /// Write .msh as one layer of prisms of this thickness, as OpenFOAM takes it; data, groups of
    /// points and further groups of an edge are lost.
    #[arg(long, value_name = "THICKNESS", value_parser = positive)]
    layer: Option<f64>,
    /// Renumber groups where a number serves a boundary and a region (.msh); without it the
    /// outline's numbers stay.
    #[arg(long)]
    unique_ids: bool,
}

/// An option, whether it is asked for, and what it is about.
type Asked = (&'static str, bool, fn(Format) -> bool);

impl WriteOptions {
    /// The format of a file whose name does not tell.
    pub fn format(&self) -> Option<Format> {
        self.preset().map(|preset| preset.formats[0])
    }

    /// Refuses an option that none of the files is about; warns of a file that the solver does not
    /// read.
    pub fn check(&self, formats: &[Format], voice: &Voice) -> Result<(), Failure> {
        use Format::{Glb, Gltf, Inp, Medit, Msh, Stl, Vtk, Vtp, Vtu, Xdmf};
        let holds_data: fn(Format) -> bool = |f| matches!(f, Msh | Vtu | Vtk | Xdmf);
        let asked: [Asked; 9] = [
            ("msh-version", self.msh_version.is_some(), |f| f == Msh),
            ("binary", self.binary, |f| matches!(f, Msh | Vtk | Stl)),
            ("order 2", self.order() == Order::Second, |f| {
                matches!(f, Msh | Vtu | Vtk | Medit | Inp | Xdmf)
            }),
            ("vtk-encoding", self.vtk_encoding.is_some(), |f| matches!(f, Vtu | Vtp)),
            ("compress", self.compress, |f| matches!(f, Vtu | Vtp)),
            ("data", !self.data.is_empty(), holds_data),
            ("color", self.color.is_some(), |f| matches!(f, Glb | Gltf)),
            ("layer", self.layer.is_some(), |f| f == Msh),
            ("unique-ids", self.unique_ids, |f| f == Msh),
        ];
        for (option, is_asked, takes) in asked {
            if is_asked && !formats.iter().copied().any(takes) {
                let known = listed(takes);
                return Err(Failure::usage(format!("--{option} is for {known}; no output is one")));
            }
        }
        if let (Some(solver), Some(preset)) = (self.solver, self.preset()) {
            let reads = |format| preset.formats.contains(&format);
            let (name, known) = (solver.name(), listed(reads));
            for format in formats.iter().filter(|&&format| !reads(format)) {
                let found = format.extension();
                voice.warn(format!("--for {name} is about {known}; .{found} is written as ever"));
            }
        }
        Ok(())
    }

    /// The name of a format as it is written, for summaries.
    pub fn name(&self, format: Format) -> String {
        let mut name = match format {
            Format::Msh if self.layer().is_some() => "Gmsh 2.2, one layer".to_owned(),
            Format::Msh => format!("Gmsh {}", word(&MSH_VERSIONS, &self.version())),
            format => format.name().to_owned(),
        };
        let is_layer = format == Format::Msh && self.layer().is_some();
        if self.binary && matches!(format, Format::Msh | Format::Vtk | Format::Stl) && !is_layer {
            name.push_str(" binary");
        }
        name
    }

    /// The mesh as all files are to hold it. `certificate` tells of excused angles.
    pub fn prepare<'a>(
        &'a self,
        mesh: &'a Mesh,
        certificate: Option<&Certificate>,
        voice: &Voice,
    ) -> Prepared<'a> {
        let mut mesh = match self.interior() {
            Interior::Keep => Cow::Borrowed(mesh),
            Interior::Drop => {
                let (part, note) = without_interfaces(mesh);
                // Who asks for it knows it; who names a solver may not.
                if let (None, Some(solver), Some(note)) =
                    (self.interior_segments, self.solver, note)
                {
                    voice.warn(format!("--for {}: {note}", solver.name()));
                }
                part
            }
        };
        if self.cells() != Cells::All {
            mesh = Cow::Owned(select(&mesh, self.cells()).into_owned());
        }
        let wants_quality = self.data.contains(&Extra::Quality);
        let is_coloured = self.color == Some(Color::Quality);
        let quality = (wants_quality || is_coloured).then(|| Quality::of(&mesh));
        let colors = quality.as_ref().filter(|_| is_coloured).map(|quality| {
            quality.smallest_angle.iter().map(|&angle| colors::of_angle(angle)).collect()
        });
        if let Some(quality) = quality.filter(|_| wants_quality) {
            mesh.to_mut().triangle_data.extend(quality.into_data());
        }
        if let Some(certificate) = certificate.filter(|_| self.data.contains(&Extra::Excuse)) {
            let data = excuses(certificate, mesh.triangles.len());
            mesh.to_mut().triangle_data.push(data);
        }
        Prepared { mesh, colors, options: self }
    }

    fn preset(&self) -> Option<Preset> {
        self.solver.map(Solver::preset)
    }

    fn version(&self) -> Version {
        self.msh_version.or(self.preset().map(|preset| preset.version)).unwrap_or_default()
    }

    fn order(&self) -> Order {
        self.order.unwrap_or_default()
    }

    fn cells(&self) -> Cells {
        self.cells.or(self.preset().map(|preset| preset.cells)).unwrap_or_default()
    }

    fn interior(&self) -> Interior {
        let preset = self.preset().map(|preset| preset.interior);
        self.interior_segments.or(preset).unwrap_or(Interior::Keep)
    }

    fn layer(&self) -> Option<f64> {
        self.layer.or(self.preset().and_then(|preset| preset.layer))
    }

    fn msh(&self) -> msh::Options {
        let unique_ids = self.unique_ids || self.preset().is_some_and(|preset| preset.unique_ids);
        let one_group = self.preset().is_some_and(|preset| preset.one_group);
        let (version, binary, order) = (self.version(), self.binary, self.order());
        msh::Options { version, binary, order, one_group, unique_ids }
    }

    fn xml(&self) -> vtu::Options {
        let (encoding, compress) = (self.vtk_encoding.unwrap_or_default(), self.compress);
        vtu::Options { encoding, compress, order: self.order() }
    }
}

/// For each triangle the place of its first excused angle in the certificate's list, from 1; 0 where
/// no angle is excused.
fn excuses(certificate: &Certificate, triangles: usize) -> Data {
    let mut places = vec![0; triangles];
    for (place, excused) in (1..).zip(&certificate.excused) {
        match places.get_mut(excused.triangle as usize) {
            Some(of) if *of == 0 => *of = place,
            _ => {}
        }
    }
    Data { name: "excuse".to_owned(), components: 1, values: Values::Integer(places) }
}

/// A mesh as all files are to hold it.
pub struct Prepared<'a> {
    mesh: Cow<'a, Mesh>,
    /// A colour for each triangle, where regions are not to tell theirs.
    colors: Option<Vec<[u8; 4]>>,
    options: &'a WriteOptions,
}

impl Prepared<'_> {
    /// Writes one file, and says what became of the mesh in it. `poly` is what a `.poly` file holds
    /// beside the mesh.
    pub fn write(
        &self,
        format: Format,
        poly: poly::Options,
        mut out: &mut dyn Write,
    ) -> io::Result<Vec<Note>> {
        let Self { mesh, options, .. } = self;
        let (binary, order) = (options.binary, options.order());
        match format {
            Format::Msh => match options.layer() {
                Some(thickness) => msh::write_layer(mesh, thickness, &mut out),
                None => msh::write_with(mesh, options.msh(), &mut out),
            },
            Format::Vtu => vtu::write_with(mesh, options.xml(), &mut out),
            Format::Vtp => vtp::write_with(mesh, options.xml(), &mut out),
            Format::Vtk => vtk::write_with(mesh, vtk::Options { binary, order }, &mut out),
            Format::Glb | Format::Gltf => {
                let (text, colors) = (format == Format::Gltf, self.colors.as_deref());
                gltf::write_with(mesh, gltf::Options { text, colors }, &mut out)
            }
            Format::Medit => medit::write_with(mesh, order, &mut out),
            Format::Su2 => su2::write(mesh, &mut out),
            Format::Inp => inp::write_with(mesh, order, &mut out),
            Format::Xdmf => xdmf::write_with(mesh, order, &mut out),
            Format::Stl => stl::write_with(mesh, binary, &mut out),
            Format::Obj => obj::write(mesh, &mut out),
            Format::Node => node::write(mesh, &mut out),
            Format::Ele => ele::write(mesh, &mut out),
            Format::Poly => poly::write_with(mesh, poly, &mut out),
            Format::Edge => edge::write(mesh, &mut out),
            Format::Neigh => neigh::write(mesh, &mut out),
            Format::Geo | Format::Area => {
                unreachable!("formats that hold no meshes are refused before")
            }
        }
    }
}
