//! Histograms of angles as pictures (SVG), one bar for each degree.

use std::fmt::Write;

use meshwright::Mesh;

use crate::plane::angle;

/// The smallest and the largest angle of each triangle, in degrees.
#[must_use]
pub fn extreme_angles(mesh: &Mesh) -> Vec<[f64; 2]> {
    let extremes = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| mesh.points[v as usize]);
        let angles = [angle(c, a, b), angle(a, b, c), angle(b, c, a)].map(f64::to_degrees);
        let [first, second, third] = angles;
        [first.min(second).min(third), first.max(second).max(third)]
    };
    mesh.triangles.iter().map(extremes).collect()
}

/// What a histogram shows.
#[derive(Debug, Clone, Copy)]
pub struct Axis<'a> {
    /// The first degree.
    pub from: usize,
    /// The degree after the last one.
    pub to: usize,
    /// The degrees that the axis names.
    pub step: usize,
    /// A line at this angle, with its name.
    pub bound: (f64, &'a str),
    /// Below the axis.
    pub title: &'a str,
}

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 260.0;
/// Room at the left, right, top and bottom for names.
const LEFT: f64 = 56.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 26.0;
const BOTTOM: f64 = 44.0;

/// How many triangles have their angle in each degree of the axis. Angles beyond it count in its
/// first or last degree.
#[must_use]
pub fn counts(angles: &[f64], axis: &Axis) -> Vec<usize> {
    let mut counts = vec![0; axis.to - axis.from];
    for &angle in angles {
        let degree = angle.clamp(axis.from as f64, axis.to as f64 - 1.0) as usize;
        counts[degree - axis.from] += 1;
    }
    counts
}

/// Draws how many triangles have their angle in each degree. A bar of few triangles is a pixel high
/// at least, so that it is seen.
#[must_use]
pub fn histogram(angles: &[f64], axis: &Axis) -> Vec<u8> {
    let counts = counts(angles, axis);
    let most = counts.iter().copied().max().unwrap_or(0).max(1);
    let (wide, high) = (WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM);
    let base = HEIGHT - BOTTOM;
    let across =
        |degrees: f64| LEFT + wide * (degrees - axis.from as f64) / (axis.to - axis.from) as f64;
    let up = |count: usize| base - high * count as f64 / most as f64;

    let mut bars = String::new();
    for (i, &count) in counts.iter().enumerate().filter(|&(_, &count)| count > 0) {
        let (left, right) = (across((axis.from + i) as f64), across((axis.from + i + 1) as f64));
        let top = up(count).min(base - 1.0);
        put(&mut bars, &format!("M{left:.1} {base:.0}V{top:.1}H{right:.1}V{base:.0}z"));
    }
    let mut svg = String::new();
    let mut line = |text: &str| put(&mut svg, &format!("{text}\n"));
    line(&format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
         viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"12\" \
         fill=\"#33414d\">"
    ));
    line(&format!("<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>"));
    let tick = round_step(most);
    for count in (0..=most).step_by(tick) {
        let (y, right) = (up(count), WIDTH - RIGHT);
        line(&format!("<path stroke=\"#dde3e8\" d=\"M{LEFT} {y:.1}H{right}\"/>"));
        let (x, y) = (LEFT - 6.0, y + 4.0);
        line(&format!("<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"end\">{count}</text>"));
    }
    line(&format!("<path fill=\"#6f9cc0\" stroke=\"#ffffff\" stroke-width=\".5\" d=\"{bars}\"/>"));
    let (right, below) = (WIDTH - RIGHT, base + 16.0);
    line(&format!("<path stroke=\"#33414d\" d=\"M{LEFT} {base}H{right}\"/>"));
    for degree in (axis.from..=axis.to).step_by(axis.step) {
        let x = across(degree as f64);
        line(&format!("<text x=\"{x:.1}\" y=\"{below}\" text-anchor=\"middle\">{degree}°</text>"));
    }
    let (bound, name) = axis.bound;
    let (x, above) = (across(bound), TOP - 8.0);
    line(&format!(
        "<path stroke=\"#c2502e\" stroke-dasharray=\"4 3\" d=\"M{x:.1} {TOP}V{base}\"/>"
    ));
    line(&format!(
        "<text x=\"{x:.1}\" y=\"{above}\" text-anchor=\"middle\" fill=\"#c2502e\">{name}</text>"
    ));
    let (middle, lowest) = ((LEFT + WIDTH - RIGHT) / 2.0, HEIGHT - 8.0);
    line(&format!(
        "<text x=\"{middle}\" y=\"{lowest}\" text-anchor=\"middle\">{}</text>",
        axis.title
    ));
    line("</svg>");
    svg.into_bytes()
}

fn put(to: &mut String, text: &str) {
    to.write_str(text).expect("a string takes everything");
}

/// The step of some 4 to 10 round numbers up to this one.
fn round_step(most: usize) -> usize {
    let mut step = 1;
    loop {
        for factor in [1, 2, 5] {
            if most / (step * factor) <= 6 {
                return step * factor;
            }
        }
        step *= 10;
    }
}
