//! Steps of a refinement, one picture each: what is new, and why.

use std::fmt::Write as _;
use std::io::{self, Write};

use meshwright_formats::Mesh;

use super::Options;
use super::frame::{Frame, Pixel};
use super::layers::{self, write_path};
use super::legend::{Legend, Swatch, escape};
use super::palette;
use super::path::Path;

/// Between the pictures of a strip, in pixels.
const GAP: f64 = 8.0;
/// The height of a caption, in pixels.
const CAPTION: f64 = 18.0;

/// A step: the triangulation after it, and what it is about.
#[derive(Debug, Clone, Default)]
pub struct Step {
    /// The triangulation.
    pub mesh: Mesh,
    /// One line below the picture.
    pub caption: String,
    /// What stands out.
    pub highlights: Vec<Highlight>,
}

/// What stands out in the picture of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Highlight {
    /// A triangle that was made.
    Made([[f64; 2]; 3]),
    /// The bad triangle that is the reason, though it may be gone.
    Bad([[f64; 2]; 3]),
    /// A subsegment that is encroached, with its diametral circle.
    Encroached([[f64; 2]; 2]),
    /// A vertex that encroaches.
    Encroaching([f64; 2]),
    /// A Steiner point that is not committed.
    Rejected([f64; 2]),
    /// The point that was committed.
    New([f64; 2]),
}

impl Highlight {
    fn colour_and_name(&self) -> (&'static str, &'static str) {
        match self {
            Self::Made(_) => (palette::MADE, "new triangle"),
            Self::Bad(_) => (palette::FAULT, "bad triangle"),
            Self::Encroached(_) => (palette::ENCROACHED, "encroached subsegment"),
            Self::Encroaching(_) => (palette::ENCROACHED, "encroaching point"),
            Self::Rejected(_) => (palette::FAULT, "rejected point"),
            Self::New(_) => (palette::NEW, "new point"),
        }
    }
}

/// Draws steps side by side, so many in a row, each with its caption. All show the same part of
/// the plane.
///
/// # Errors
/// Those of `out`.
pub fn film(
    steps: &[Step],
    columns: usize,
    options: &Options,
    out: &mut impl Write,
) -> io::Result<()> {
    let columns = columns.max(1) as f64;
    let one =
        Options { width: (options.width - GAP * (columns - 1.0)) / columns, ..options.clone() };
    let all = steps.iter().flat_map(|step| &step.mesh.points);
    let frame = Frame::of(all, &one);
    let mut legend = Legend::default();
    let mut sheet = String::new();
    let (mut column, mut row) = (0.0, 0.0);
    for step in steps {
        if column == columns {
            (column, row) = (0.0, row + 1.0);
        }
        let corner = [column * (frame.width + GAP), row * (frame.height + CAPTION + GAP)];
        picture(step, corner, &frame, options, &mut sheet, &mut legend);
        column += 1.0;
    }
    let width = columns * (frame.width + GAP) - GAP;
    let height = (row + 1.0) * (frame.height + CAPTION + GAP) - GAP;
    let (legend, legend_height) =
        if options.legend { legend.lay_out(width, height) } else { (String::new(), 0.0) };
    let height = height + legend_height;
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>",
        palette::PAPER
    )?;
    writeln!(out, "{sheet}{legend}</svg>")
}

/// One picture and its caption, its upper left corner there.
fn picture(
    step: &Step,
    [x, y]: Pixel,
    frame: &Frame,
    options: &Options,
    sheet: &mut String,
    legend: &mut Legend,
) {
    let mut page = String::new();
    let mut names = Legend::default();
    layers::regions(&step.mesh, frame, &mut page, &mut names);
    areas(&step.highlights, frame, &mut page);
    layers::inner_edges(&step.mesh, frame, &mut page);
    layers::tagged_edges(&step.mesh, frame, &mut page, &mut Legend::default());
    names.add(Swatch::Line(palette::UNTAGGED), "subsegment");
    circles(&step.highlights, frame, &mut page);
    layers::mesh_points(&step.mesh, options.points, frame, &mut page, &mut names);
    dots(&step.highlights, frame, &mut page);
    for highlight in &step.highlights {
        let (colour, name) = highlight.colour_and_name();
        let swatch = match highlight {
            Highlight::Made(_) | Highlight::Bad(_) => Swatch::Area(colour),
            Highlight::Encroached(_) => Swatch::Line(colour),
            Highlight::Rejected(_) => Swatch::Cross(colour),
            Highlight::Encroaching(_) | Highlight::New(_) => Swatch::Dot(colour),
        };
        names.add(swatch, name);
    }
    legend.add_new(names);
    let (width, height) = (frame.width, frame.height);
    writeln!(
        sheet,
        "<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\">\
         <g transform=\"scale(.01)\" fill=\"none\" stroke-linejoin=\"round\" \
         stroke-linecap=\"round\">\n{page}</g></svg>"
    )
    .expect("writing to a string succeeds");
    let mut caption = String::new();
    escape(&step.caption, &mut caption);
    writeln!(
        sheet,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" \
         font-family=\"system-ui,'Segoe UI',Roboto,'DejaVu Sans',sans-serif\" font-size=\"11\" \
         fill=\"{}\">{caption}</text>",
        x + width / 2.0,
        y + height + 11.0,
        palette::TEXT
    )
    .expect("writing to a string succeeds");
}

/// New triangles and bad ones, filled: behind the edges.
fn areas(highlights: &[Highlight], frame: &Frame, page: &mut String) {
    let mut made = Path::default();
    let mut bad = Path::default();
    for highlight in highlights {
        let (path, corners) = match highlight {
            Highlight::Made(corners) => (&mut made, corners),
            Highlight::Bad(corners) => (&mut bad, corners),
            _ => continue,
        };
        path.polygon(frame, corners.iter().map(|&corner| frame.pixel(corner)).collect());
    }
    write_path(page, &made, &format!("fill=\"{}\"", palette::MADE));
    let style = "fill-opacity=\".3\" stroke-width=\"100\" stroke-dasharray=\"300 250\"";
    write_path(page, &bad, &format!("fill=\"{0}\" stroke=\"{0}\" {style}", palette::FAULT));
}

/// Encroached subsegments with their diametral circles.
fn circles(highlights: &[Highlight], frame: &Frame, page: &mut String) {
    let mut lines = Path::default();
    for highlight in highlights {
        let Highlight::Encroached(ends) = highlight else { continue };
        let [a, b] = ends.map(|end| frame.pixel(end));
        lines.line(frame, &[a, b]);
        let radius = 0.5 * libm::hypot(b[0] - a[0], b[1] - a[1]);
        // Far off the page or wider than any it is not worth its digits.
        if radius.max(a[0].abs()).max(a[1].abs()) < 1e6 {
            writeln!(
                page,
                "<circle cx=\"{:.0}\" cy=\"{:.0}\" r=\"{:.0}\" stroke=\"{}\" stroke-width=\"100\"/>",
                50.0 * (a[0] + b[0]),
                50.0 * (a[1] + b[1]),
                100.0 * radius,
                palette::ENCROACHED
            )
            .expect("writing to a string succeeds");
        }
    }
    write_path(page, &lines, &format!("stroke=\"{}\" stroke-width=\"260\"", palette::ENCROACHED));
}

/// Points of interest, before all others.
fn dots(highlights: &[Highlight], frame: &Frame, page: &mut String) {
    for highlight in highlights {
        let (colour, _) = highlight.colour_and_name();
        let mut path = Path::default();
        match highlight {
            Highlight::Encroaching(place) | Highlight::New(place) => {
                let pixel = frame.pixel(*place);
                if frame.shows(pixel) {
                    path.dot(pixel);
                }
                write_path(page, &path, &format!("stroke=\"{colour}\" stroke-width=\"650\""));
            }
            Highlight::Rejected(place) => {
                let [x, y] = frame.pixel(*place);
                path.line(frame, &[[x - 4.0, y - 4.0], [x + 4.0, y + 4.0]]);
                path.line(frame, &[[x - 4.0, y + 4.0], [x + 4.0, y - 4.0]]);
                write_path(page, &path, &format!("stroke=\"{colour}\" stroke-width=\"200\""));
            }
            _ => {}
        }
    }
}
