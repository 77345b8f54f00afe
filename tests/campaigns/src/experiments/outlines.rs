//! The outlines of the experiments that are files.

use std::io;

use meshwright::Pslg;
use meshwright::formats::poly;

/// Lake Superior from Natural Earth: 1 294 points, 16 islands as holes.
///
/// # Errors
/// The file cannot be read as an outline.
pub fn lake() -> Result<Pslg, String> {
    read("lake_superior.poly", include_bytes!("../../../../examples/lake_superior.poly"))
}

/// Open coast chains in a box, θ* = 0.052°: like the paper's Baltic Sea, which is not public.
///
/// # Errors
/// The file cannot be read as an outline.
pub fn baltic() -> Result<Pslg, String> {
    read("baltic_like.poly", include_bytes!("../../data/baltic_like.poly"))
}

/// Fjords of Norway: one outline, 12 islands as holes.
///
/// # Errors
/// The file cannot be read as an outline.
pub fn norway() -> Result<Pslg, String> {
    read("norway_sogn.poly", include_bytes!("../../data/norway_sogn.poly"))
}

fn read(name: &str, text: &[u8]) -> Result<Pslg, String> {
    // Its points are in the same file.
    let outline = poly::read(text, name, |_| Err(io::ErrorKind::NotFound.into()));
    outline.map(|(outline, _)| outline).map_err(|error| error.to_string())
}

/// The extent of an outline's points, `[xmin, ymin, xmax, ymax]`.
#[must_use]
pub fn extent(outline: &Pslg) -> [f64; 4] {
    let empty = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    outline.points.iter().fold(empty, |[left, bottom, right, top], &[x, y]| {
        [left.min(x), bottom.min(y), right.max(x), top.max(y)]
    })
}
