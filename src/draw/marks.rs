//! What a picture points out: excused angles, triangles limited by precision, faults.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::Mark;
use super::frame::{Frame, Pixel};
use super::layers::write_path;
use super::legend::{Legend, Swatch};
use super::palette;
use super::path::Path;

/// A triangle that looks smaller than this (in pixels) gets a ring around it.
const SMALL: f64 = 14.0;
const RING: f64 = 9.0;

/// The marked triangles, filled: behind the edges.
pub fn draw_triangles(marks: &[Mark], frame: &Frame, page: &mut String) {
    let (mut excused, mut limited) = (Path::default(), Path::default());
    for mark in marks {
        let (path, triangle) = match mark {
            Mark::Excused(triangle) => (&mut excused, triangle),
            Mark::Limited(triangle) => (&mut limited, triangle),
            Mark::Fault { .. } => continue,
        };
        path.polygon(frame, triangle.iter().map(|&corner| frame.pixel(corner)).collect());
    }
    write_path(page, &excused, &format!("fill=\"{}\"", palette::EXCUSED));
    write_path(page, &limited, &format!("fill=\"{}\"", palette::LIMITED));
}

/// Rings around what is too small to be seen, around faults with their number; the legend.
pub fn draw(marks: &[Mark], frame: &Frame, page: &mut String, legend: &mut Legend) {
    let mut fault = 0;
    let (mut any_excused, mut any_limited) = (false, false);
    let mut rings = BTreeSet::new();
    for mark in marks {
        match mark {
            Mark::Excused(triangle) => {
                any_excused = true;
                ring_if_small(triangle, frame, palette::EXCUSED, &mut rings, page);
            }
            Mark::Limited(triangle) => {
                any_limited = true;
                ring_if_small(triangle, frame, palette::LIMITED, &mut rings, page);
            }
            Mark::Fault { place, text } => {
                fault += 1;
                let pixel = frame.pixel(*place);
                if frame.shows(pixel) {
                    ring(pixel, palette::FAULT, page);
                    number(fault, pixel, page);
                }
                legend.add_first(Swatch::Ring(palette::FAULT), format!("{fault}: {text}"));
            }
        }
    }
    if any_excused {
        legend.add(Swatch::Area(palette::EXCUSED), "angle excused by the outline");
    }
    if any_limited {
        legend.add(Swatch::Area(palette::LIMITED), "limited by precision");
    }
}

/// A ring around a triangle that is too small to be seen, unless one of its colour is there.
fn ring_if_small(
    triangle: &[[f64; 2]; 3],
    frame: &Frame,
    colour: &'static str,
    rings: &mut BTreeSet<(&'static str, [i64; 2])>,
    page: &mut String,
) {
    let corners = triangle.map(|corner| frame.pixel(corner));
    let middle = [0, 1].map(|axis| corners.iter().map(|c| c[axis]).sum::<f64>() / 3.0);
    let reach = corners
        .iter()
        .flat_map(|corner| [0, 1].map(|axis| (corner[axis] - middle[axis]).abs()))
        .fold(0.0, f64::max);
    let cell = middle.map(|value| (value / RING).round() as i64);
    if frame.shows(middle) && reach < SMALL / 2.0 && rings.insert((colour, cell)) {
        ring(middle, colour, page);
    }
}

fn ring([x, y]: Pixel, colour: &str, page: &mut String) {
    let circle = format!(
        "<circle cx=\"{:.0}\" cy=\"{:.0}\" r=\"{:.0}\"",
        x * 100.0,
        y * 100.0,
        RING * 100.0
    );
    writeln!(
        page,
        "{circle} stroke=\"{}\" stroke-width=\"400\" stroke-opacity=\".8\"/>\
         {circle} stroke=\"{colour}\" stroke-width=\"180\"/>",
        palette::PAPER
    )
    .expect("writing to a string succeeds");
}

fn number(number: usize, [x, y]: Pixel, page: &mut String) {
    writeln!(
        page,
        "<text x=\"{:.0}\" y=\"{:.0}\" font-family=\"system-ui,'DejaVu Sans',sans-serif\" \
         font-size=\"1300\" font-weight=\"600\" fill=\"{}\" stroke=\"{}\" stroke-width=\"300\" \
         paint-order=\"stroke\">{number}</text>",
        x * 100.0 + 1_050.0,
        y * 100.0 - 600.0,
        palette::FAULT,
        palette::PAPER
    )
    .expect("writing to a string succeeds");
}
