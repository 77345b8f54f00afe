//! Looks into the certificate of a mesh, then spoils the mesh and has it judged again.
//!
//! `cargo run --example certificate`

use std::error::Error;

use meshwright::certify::certify;
use meshwright::formats::{Provenance, poly};
use meshwright::{Parameters, mesh};

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", certificates()?.join("\n"));
    Ok(())
}

/// The certificates of Lake Superior's mesh and of the same mesh with one point moved.
pub fn certificates() -> Result<[String; 2], Box<dyn Error>> {
    let text = include_bytes!("lake_superior.poly");
    let (pslg, _) =
        poly::read(text, "lake_superior.poly", |_| Err(std::io::ErrorKind::NotFound.into()))?;
    let outcome = mesh(&pslg, &Parameters::default())?;
    let good = outcome.certificate;
    assert!(good.holds());
    for excused in &good.excused {
        println!("{excused:?}");
    }

    // The judge knows nothing of how a mesh was made: it takes any mesh.
    let mut mesh = outcome.mesh;
    let steiner_point = mesh.provenance.iter().rposition(|kind| *kind == Provenance::Circumcenter);
    let [x, _] = &mut mesh.points[steiner_point.ok_or("the mesh has no Steiner point")?];
    *x += 0.5;
    let spoilt = certify(&pslg, &mesh, &good.promise);
    assert!(!spoilt.holds());
    Ok([good.to_string(), spoilt.to_string()])
}
