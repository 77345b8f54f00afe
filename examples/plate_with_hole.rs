//! Makes an outline in code: a plate with a round hole, its sides named, finer near the hole.
//!
//! `cargo run --example plate_with_hole -- [PLATE.msh]`

use std::error::Error;
use std::f64::consts::TAU;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use meshwright::formats::{Group, Region, msh};
use meshwright::{Parameters, Pslg, mesh};

const CLAMPED: i32 = 1;
const PULLED: i32 = 2;
const FREE: i32 = 3;
const HOLE: i32 = 4;
const STEEL: i32 = 10;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "plate.msh".into());
    write_plate(Path::new(&file))
}

/// Meshes the plate into a `.msh` file.
pub fn write_plate(file: &Path) -> Result<(), Box<dyn Error>> {
    let outcome = mesh(&plate(), &Parameters::default())?;
    println!("{} triangles", outcome.mesh.triangles.len());
    msh::write(&outcome.mesh, &mut BufWriter::new(File::create(file)?))?;
    Ok(())
}

/// Four by two, with a hole of radius one half in the middle.
fn plate() -> Pslg {
    let mut plate = Pslg {
        points: vec![[-2.0, -1.0], [2.0, -1.0], [2.0, 1.0], [-2.0, 1.0]],
        segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
        segment_tags: vec![FREE, PULLED, FREE, CLAMPED],
        holes: vec![[0.0, 0.0]],
        ..Pslg::default()
    };
    // A circle is as round as its segments are many.
    const SIDES: u32 = 48;
    for side in 0..SIDES {
        let angle = TAU * f64::from(side) / f64::from(SIDES);
        plate.points.push([0.5 * angle.cos(), 0.5 * angle.sin()]);
        plate.segments.push([4 + side, 4 + (side + 1) % SIDES]);
        plate.segment_tags.push(HOLE);
    }
    plate.regions.push(Region {
        seed: [-1.9, -0.9],
        tag: STEEL,
        attribute: f64::from(STEEL),
        max_area: Some(0.02),
    });
    let name = |dim, tag, name: &str| Group { dim, tag, name: name.into() };
    plate.groups = vec![
        name(1, CLAMPED, "clamped"),
        name(1, PULLED, "pulled"),
        name(1, FREE, "free"),
        name(1, HOLE, "hole"),
        name(2, STEEL, "steel"),
    ];
    plate
}
