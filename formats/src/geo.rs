//! Outlines in Gmsh's `.geo` scripts.
//!
//! A script is evaluated, not searched for patterns: `grammar` reads it statement by statement
//! (its files open with their productions), `evaluate` runs the statements, which build the
//! geometry (`model`), and `outline` lays that into its plane.
//!
//! Read is what plane geometries use: variables, lists, texts, functions, `If`, `For`, `Macro`,
//! `Include`; points, lines, circles, ellipses and splines; curve loops and plane surfaces;
//! transformations, copies, extrusions within the plane, coherence; rectangles, disks, circles and
//! ellipses of OpenCASCADE and its boolean operations on surfaces of straight lines and circles
//! (holes may be of any curves); sizes at points, transfinite curves; embedded points and curves;
//! physical groups. Not read: volumes, files of other programs. Statements about display, size
//! fields, structured or periodic meshes are passed over and counted in one warning.
//!
//! What a boolean operation makes has the numbers that Gmsh 4.15 gives it; the curves of a union
//! are not to be named by number.
//!
//! Surfaces become regions with the number of their physical group, curves become segments. Only
//! what a surface covers is meshed. A script without any physical group has each surface and each
//! curve as a group of its own. Curves are cut into straight pieces as long as the sizes ask for,
//! and short enough that no surface loses more than a hundredth of its area.

mod error;
mod evaluate;
mod grammar;
mod model;
mod outline;
mod sources;
mod syntax;

use std::io;

pub use error::{CurveFault, Error, Problem};

use crate::error::{Notice, Warning};
use crate::pslg::Pslg;
use evaluate::Evaluator;
use syntax::Place;

/// Reads the text of a `.geo` script.
///
/// `file` is the name that messages use. For `Include` and for `Merge` of another script
/// `include` is asked for the text of a file beside this one, or in a folder below, by name:
/// `dir/part.geo` for `Include "part.geo";` in `dir/plate.geo`. Nothing else is read, nothing is
/// executed.
///
/// # Errors
/// The first place that cannot be read or evaluated; geometry that is not plane or whose surfaces
/// are open or overlap.
///
/// ```
/// use meshwright_formats::geo;
/// let script = b"
///     lc = 0.1;
///     Point(1) = {0, 0, 0, lc}; Point(2) = {1, 0, 0, lc}; Point(3) = {0, 1, 0, lc};
///     Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 1};
///     Curve Loop(1) = {1:3};
///     Plane Surface(1) = {1};
///     Physical Curve(\"side\", 7) = {1, 3};
///     Physical Surface(\"plate\", 8) = {1};
/// ";
/// let (outline, warnings) = geo::read(script, "plate.geo", geo::no_includes)?;
/// assert_eq!(outline.points, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
/// assert_eq!(outline.segment_tags, [7, 0, 7]);
/// assert_eq!(outline.regions[0].tag, 8);
/// assert_eq!(outline.point_sizes, [0.1; 3]);
/// assert!(warnings.is_empty());
/// # Ok::<(), geo::Error>(())
/// ```
pub fn read(
    text: &[u8],
    file: &str,
    mut include: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<(Pslg, Vec<Warning>), Error> {
    let mut evaluator = Evaluator::new(&mut include);
    let made = evaluator.run_script(text, file).and_then(|()| {
        let end = Place { file: 0, offset: text.trim_ascii_end().len() as u32 };
        let model = std::mem::take(&mut evaluator.model);
        outline::outline(model, &evaluator.options, &evaluator.sources, end)
    });
    let (pslg, mut warnings) = made.map_err(|trouble| evaluator.sources.error(trouble))?;
    warnings.extend(skipped(&evaluator));
    Ok((pslg, warnings))
}

/// An `include` for scripts that stand alone.
///
/// # Errors
/// Always.
pub fn no_includes(_: &str) -> io::Result<Vec<u8>> {
    Err(io::Error::other("there is no file beside the script"))
}

/// One warning about all statements that were passed over.
fn skipped(evaluator: &Evaluator) -> Option<Warning> {
    let first = evaluator.skipped.values().map(|&(_, place)| place);
    let first = first.min_by_key(|place| (place.file, place.offset))?;
    let statements =
        evaluator.skipped.iter().map(|(name, &(count, _))| (name.clone(), count)).collect();
    Some(Warning {
        file: evaluator.sources.name(first.file).to_owned(),
        line: evaluator.sources.line(first),
        notice: Notice::SkippedStatements { statements },
    })
}
