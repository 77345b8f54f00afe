//! Outlines and meshes as pictures (SVG), the y axis upwards.
//!
//! A picture is a page of fixed width in pixels: line widths do not depend on the extent of the
//! data, coordinates are rounded to a hundredth of a pixel, and what lies outside a zoom box is
//! not written at all. The same input gives the same bytes.
//!
//! ```
//! use meshwright::draw::{self, Options};
//! use meshwright::Pslg;
//!
//! let square = Pslg {
//!     points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
//!     segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
//!     segment_tags: vec![1, 1, 2, 2],
//!     ..Pslg::default()
//! };
//! let mut svg = Vec::new();
//! draw::outline(&square, &Options::default(), &mut svg)?;
//! assert!(svg.starts_with(b"<svg "));
//! # Ok::<(), std::io::Error>(())
//! ```

mod film;
mod frame;
mod layers;
mod legend;
mod marks;
mod palette;
mod path;
mod trails;

use std::io::{self, Write};

use meshwright_formats::{Mesh, Pslg};

pub use film::{Highlight, Step, film};
use frame::Frame;
use legend::Legend;

/// What a picture shows besides the outline or the mesh itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The width of the picture in pixels. Its height follows from the extent of what is shown.
    pub width: f64,
    /// Only this part of the plane is shown, `[xmin, ymin, xmax, ymax]`; `None`: everything.
    pub zoom: Option<[f64; 4]>,
    /// Which points are shown as dots.
    pub points: Dots,
    /// Whether a legend with the groups' names stands below the picture.
    pub legend: bool,
    /// Places that are pointed out.
    pub marks: Vec<Mark>,
}

impl Default for Options {
    fn default() -> Self {
        Self { width: 960.0, zoom: None, points: Dots::Auto, legend: true, marks: Vec::new() }
    }
}

/// Which points are shown as dots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dots {
    /// All of them, where the picture has room for them.
    #[default]
    Auto,
    /// All of them.
    All,
    /// None.
    None,
}

/// A place that is pointed out, in the coordinates of what is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A triangle, its small angle (at the first corner) excused by the outline.
    Excused([[f64; 2]; 3]),
    /// A triangle limited by precision.
    Limited([[f64; 2]; 3]),
    /// A place where something is wrong; the text explains it in the legend.
    Fault {
        /// Where.
        place: [f64; 2],
        /// What is wrong there.
        text: String,
    },
}

/// Draws an outline: segments in the colour of their tag, points, holes (crosses) and region
/// seeds (diamonds).
///
/// # Errors
/// Those of `out`.
pub fn outline(pslg: &Pslg, options: &Options, out: &mut impl Write) -> io::Result<()> {
    let seeds = pslg.holes.iter().chain(pslg.regions.iter().map(|region| &region.seed));
    let frame = Frame::of(pslg.points.iter().chain(seeds), options);
    let mut legend = Legend::default();
    let mut page = String::new();
    layers::segments(pslg, &frame, &mut page, &mut legend);
    layers::outline_points(pslg, options.points, &frame, &mut page, &mut legend);
    layers::seeds(pslg, &frame, &mut page, &mut legend);
    marks::draw(&options.marks, &frame, &mut page, &mut legend);
    write_page(&frame, &page, options.legend.then_some(&legend), out)
}

/// Draws a mesh: triangles in the colour of their region, the edges of segments in the colour of
/// their tag, points by kind.
///
/// # Errors
/// Those of `out`.
pub fn mesh(mesh: &Mesh, options: &Options, out: &mut impl Write) -> io::Result<()> {
    let frame = Frame::of(mesh.points.iter(), options);
    let mut legend = Legend::default();
    let mut page = String::new();
    layers::regions(mesh, &frame, &mut page, &mut legend);
    marks::draw_triangles(&options.marks, &frame, &mut page);
    layers::inner_edges(mesh, &frame, &mut page);
    layers::tagged_edges(mesh, &frame, &mut page, &mut legend);
    layers::mesh_points(mesh, options.points, &frame, &mut page, &mut legend);
    marks::draw(&options.marks, &frame, &mut page, &mut legend);
    write_page(&frame, &page, options.legend.then_some(&legend), out)
}

/// The page: a white sheet, the layers in hundredths of a pixel, the legend below them.
fn write_page(
    frame: &Frame,
    layers: &str,
    legend: Option<&Legend>,
    out: &mut impl Write,
) -> io::Result<()> {
    let (width, picture_height) = (frame.width, frame.height);
    let (legend, legend_height) = match legend {
        Some(legend) => legend.lay_out(width, picture_height),
        None => (String::new(), 0.0),
    };
    let height = picture_height + legend_height;
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">"
    )?;
    writeln!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>", palette::PAPER)?;
    // Nothing runs over the legend; round dots at the rim of a zoom box are cut off.
    writeln!(
        out,
        "<svg width=\"{width}\" height=\"{picture_height}\">\
         <g transform=\"scale(.01)\" fill=\"none\" stroke-linejoin=\"round\" \
         stroke-linecap=\"round\">"
    )?;
    out.write_all(layers.as_bytes())?;
    writeln!(out, "</g></svg>")?;
    out.write_all(legend.as_bytes())?;
    writeln!(out, "</svg>")
}

#[cfg(test)]
mod tests;
