//! Meshes that are refined: taken as the outlines that they are, with Triangle's `.area` files.

use std::io;
use std::path::Path;

use meshwright::formats::{Mesh, Pslg, Warning, area, ele};
use meshwright::outline_of;

use super::failure::Failure;

/// The largest area of each triangle, and what was passed over.
type Areas = (Vec<Option<f64>>, Vec<Warning>);

/// The outline of a mesh.
pub fn outline(mesh: &Mesh, areas: &[Option<f64>], name: &str) -> Result<Pslg, Failure> {
    let wrong = |error| Failure::input(format!("{name}: {error}"));
    let mut pslg = outline_of(mesh, areas).map_err(wrong)?;
    pslg.source.file = name.to_owned();
    Ok(pslg)
}

/// The areas in the file beside a `.ele` file; none where there is no such file.
pub fn areas_beside(
    name: &str,
    mut companion: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<Areas, Failure> {
    let beside = with_end(name, "area");
    match companion(&beside) {
        Ok(text) => area::read(&text, &beside).map_err(Failure::input),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Areas::default()),
        Err(error) => Err(Failure::io(Path::new(&beside), &error)),
    }
}

/// The outline of the mesh beside a `.area` file.
pub fn beside_areas(
    (areas, mut warnings): Areas,
    name: &str,
    mut companion: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<(Pslg, Vec<Warning>), Failure> {
    let beside = with_end(name, "ele");
    let text = companion(&beside).map_err(|error| Failure::io(Path::new(&beside), &error))?;
    let read = ele::read_with_companions(&text, &beside, companion);
    let (mesh, more) = read.map_err(Failure::input)?;
    warnings.extend(more);
    Ok((outline(&mesh, &areas, name)?, warnings))
}

/// The file beside one: the same name, `.gz` aside, with another end.
fn with_end(name: &str, end: &str) -> String {
    let name = name.strip_suffix(".gz").unwrap_or(name);
    Path::new(name).with_extension(end).display().to_string()
}
