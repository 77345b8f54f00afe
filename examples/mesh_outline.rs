//! Reads an outline, meshes it, and writes the mesh for a solver and for ParaView.
//!
//! `cargo run --example mesh_outline -- [OUTLINE.poly [FOLDER]]`

use std::error::Error;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;

use meshwright::formats::{msh, poly, vtu};
use meshwright::{Parameters, mesh};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let outline = arguments.next().unwrap_or_else(|| "examples/lake_superior.poly".into());
    let folder = arguments.next().unwrap_or_else(|| ".".into());
    mesh_outline(&outline, Path::new(&folder))
}

/// Meshes a `.poly` file into `lake.msh` and `lake.vtu` in the folder.
pub fn mesh_outline(outline: &str, folder: &Path) -> Result<(), Box<dyn Error>> {
    let text = fs::read(outline)?;
    let (pslg, warnings) = poly::read(&text, outline, |node| fs::read(node))?;
    for warning in warnings {
        eprintln!("{warning}");
    }
    let outcome = mesh(&pslg, &Parameters::default())?;
    println!("{} points, {} triangles", outcome.mesh.points.len(), outcome.mesh.triangles.len());

    // The writers say what they did with tags that a format cannot hold.
    let notes =
        msh::write(&outcome.mesh, &mut BufWriter::new(File::create(folder.join("lake.msh"))?))?;
    for note in notes {
        println!("lake.msh: {note}");
    }
    vtu::write(&outcome.mesh, &mut BufWriter::new(File::create(folder.join("lake.vtu"))?))?;
    Ok(())
}
