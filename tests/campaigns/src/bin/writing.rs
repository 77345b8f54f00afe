//! How fast meshes are written: a square grid, into every format.
//!
//! What counts is the time that the writer had a processor, its system calls included, where the
//! system tells it (Linux); else the time that went by. So it does not matter what else runs.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use meshwright::Mesh;
use meshwright::formats::groups::Note;
use meshwright::formats::{Group, Order, gltf, inp, medit, msh, stl, su2, vtk, vtu, xdmf};

/// Times the writers on a square grid, into files that take the place of each other.
#[derive(Debug, Parser)]
struct Arguments {
    /// About so many triangles.
    #[arg(long, default_value_t = 3_000_000)]
    triangles: usize,
    /// Where to write; memory-backed storage measures the writers alone.
    #[arg(long, default_value = "/dev/shm")]
    folder: PathBuf,
    /// Runs of each; the fastest counts.
    #[arg(long, default_value_t = 3)]
    runs: u32,
    /// Leave `writing.vtu` there, for `writing.py`.
    #[arg(long)]
    keep: bool,
}

type Writer<'a> = &'a dyn Fn(&Mesh, &mut BufWriter<File>) -> io::Result<Vec<Note>>;

/// The writers, with the speed in MB/s that each must have.
const WRITERS: [(&str, &str, f64, Writer); 15] = [
    (".vtu raw", "vtu", 500.0, &|mesh, out| vtu::write(mesh, out)),
    (".vtu Base64", "vtu", 0.0, &|mesh, out| xml(mesh, vtu::Encoding::Base64, false, out)),
    (".vtu text", "vtu", 0.0, &|mesh, out| xml(mesh, vtu::Encoding::Ascii, false, out)),
    (".vtu raw, zlib", "vtu", 0.0, &|mesh, out| xml(mesh, vtu::Encoding::Raw, true, out)),
    (".msh 2.2 text", "msh", 150.0, &|mesh, out| msh::write(mesh, out)),
    (".msh 2.2 binary", "msh", 500.0, &|mesh, out| gmsh(mesh, msh::Version::V2_2, true, out)),
    (".msh 4.1 text", "msh", 0.0, &|mesh, out| gmsh(mesh, msh::Version::V4_1, false, out)),
    (".msh 4.1 binary", "msh", 500.0, &|mesh, out| gmsh(mesh, msh::Version::V4_1, true, out)),
    (".vtk text", "vtk", 0.0, &|mesh, out| vtk::write_with(mesh, LEGACY, out)),
    (".glb", "glb", 0.0, &|mesh, out| gltf::write(mesh, out)),
    (".mesh", "mesh", 0.0, &|mesh, out| medit::write(mesh, out)),
    (".su2", "su2", 0.0, &|mesh, out| su2::write(mesh, out)),
    (".inp", "inp", 0.0, &|mesh, out| inp::write_with(mesh, Order::First, out)),
    (".xdmf", "xdmf", 0.0, &|mesh, out| xdmf::write_with(mesh, Order::First, out)),
    (".stl binary", "stl", 0.0, &|mesh, out| stl::write_with(mesh, true, out)),
];

const LEGACY: vtk::Options = vtk::Options { binary: false, order: Order::First };

fn xml(
    mesh: &Mesh,
    encoding: vtu::Encoding,
    compress: bool,
    out: &mut BufWriter<File>,
) -> io::Result<Vec<Note>> {
    vtu::write_with(mesh, vtu::Options { encoding, compress, order: Order::First }, out)
}

fn gmsh(
    mesh: &Mesh,
    version: msh::Version,
    binary: bool,
    out: &mut BufWriter<File>,
) -> io::Result<Vec<Note>> {
    msh::write_with(mesh, msh::Options { version, binary, ..msh::Options::default() }, out)
}

fn main() -> io::Result<ExitCode> {
    let arguments = Arguments::parse();
    let mesh = grid(arguments.triangles);
    println!("{} points, {} triangles", mesh.points.len(), mesh.triangles.len());
    println!("{:<17}{:>9}{:>9}{:>9}", "", "MB", "s", "MB/s");
    let mut is_slow = false;
    for (name, end, least, write) in WRITERS {
        let file = arguments.folder.join(format!("writing.{end}"));
        let mut seconds = f64::INFINITY;
        for _ in 0..arguments.runs {
            seconds = seconds.min(time(&mesh, &file, write)?);
        }
        let size = std::fs::metadata(&file)?.len() as f64 / 1e6;
        std::fs::remove_file(&file)?;
        let speed = size / seconds;
        let verdict = if speed < least { format!("  less than {least}") } else { String::new() };
        is_slow |= speed < least;
        println!("{name:<17}{size:>9.0}{seconds:>9.2}{speed:>9.0}{verdict}");
    }
    if arguments.keep {
        time(&mesh, &arguments.folder.join("writing.vtu"), WRITERS[0].3)?;
    }
    Ok(if is_slow { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

fn time(mesh: &Mesh, file: &Path, write: Writer) -> io::Result<f64> {
    let clock = Clock::start();
    let mut out = BufWriter::with_capacity(1 << 16, File::create(file)?);
    write(mesh, &mut out)?;
    out.flush()?;
    Ok(clock.seconds())
}

struct Clock {
    start: Instant,
    busy: Option<f64>,
}

impl Clock {
    fn start() -> Self {
        Self { busy: busy(), start: Instant::now() }
    }

    fn seconds(&self) -> f64 {
        match (self.busy, busy()) {
            (Some(start), Some(end)) => end - start,
            _ => self.start.elapsed().as_secs_f64(),
        }
    }
}

/// The seconds that this thread had a processor so far.
fn busy() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: u64 = text.split_whitespace().next()?.parse().ok()?;
    Some(nanoseconds as f64 / 1e9)
}

/// A square cut into squares, each cut into two triangles; coordinates have all their digits. The
/// halves are regions, the sides boundaries.
fn grid(triangles: usize) -> Mesh {
    let side = (triangles as f64 / 2.0).sqrt().ceil().max(1.0) as u32;
    let place = |i: u32| f64::from(i) / f64::from(side) * std::f64::consts::PI;
    let at = |x: u32, y: u32| y * (side + 1) + x;
    let squares = || (0..side).flat_map(|y| (0..side).map(move |x| (x, y)));
    let halves = |(x, y)| {
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        [[a, b, c], [a, c, d]]
    };
    let border = (0..side).flat_map(|i| {
        [
            [at(i, 0), at(i + 1, 0)],
            [at(side, i), at(side, i + 1)],
            [at(i + 1, side), at(i, side)],
            [at(0, i + 1), at(0, i)],
        ]
    });
    let group = |dim, tag, name: &str| Group { dim, tag, name: name.to_owned() };
    Mesh {
        points: (0..=side).flat_map(|y| (0..=side).map(move |x| [place(x), place(y)])).collect(),
        triangles: squares().flat_map(halves).collect(),
        triangle_tags: squares().flat_map(|(x, _)| [1 + i32::from(2 * x > side); 2]).collect(),
        edges: border.collect(),
        edge_tags: (0..side).flat_map(|_| [3, 4, 5, 6]).collect(),
        groups: vec![group(2, 1, "west"), group(2, 2, "east"), group(1, 3, "south")],
        ..Mesh::default()
    }
}
