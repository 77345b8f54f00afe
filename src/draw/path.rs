//! The data of SVG paths, short: whole hundredths of a pixel, each step relative to the last.

use std::fmt::Write;

use super::frame::{Frame, Pixel};

/// The `d` attribute of a path in the making.
#[derive(Debug, Default)]
pub struct Path {
    data: String,
    pen: [i64; 2],
    /// The command that the next numbers would belong to without naming it.
    command: Option<char>,
}

impl Path {
    /// Whether nothing was drawn.
    pub fn is_empty(&self) -> bool {
        self.data.is_empty()
    }

    /// The `d` attribute.
    pub fn data(&self) -> &str {
        &self.data
    }

    /// A line through these pixels, cut at the rim of the page.
    pub fn line(&mut self, frame: &Frame, pixels: &[Pixel]) {
        let mut pen = None;
        for pair in pixels.windows(2) {
            let Some([a, b]) = frame.clip_line(pair[0], pair[1]) else {
                continue;
            };
            let (a, b) = (hundredths(a), hundredths(b));
            if a == b {
                continue;
            }
            if pen != Some(a) {
                self.move_to(a);
            }
            self.line_to(b);
            pen = Some(b);
        }
    }

    /// A filled polygon, cut at the rim of the page.
    pub fn polygon(&mut self, frame: &Frame, pixels: Vec<Pixel>) {
        let mut corners: Vec<_> = frame.clip_polygon(pixels).into_iter().map(hundredths).collect();
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        let [first, rest @ ..] = corners.as_slice() else {
            return;
        };
        if rest.len() < 2 {
            return;
        }
        self.move_to(*first);
        for &corner in rest {
            self.line_to(corner);
        }
        self.data.push('z');
        (self.pen, self.command) = (*first, None);
    }

    /// A dot as wide as the stroke (a line of no length with round ends).
    pub fn dot(&mut self, pixel: Pixel) {
        self.move_to(hundredths(pixel));
        self.data.push_str("h0");
        self.command = None;
    }

    fn move_to(&mut self, to: [i64; 2]) {
        // A first `m` is read as an absolute one, from (0, 0).
        self.step('m', to);
        self.command = Some('l'); // numbers after those of `m` are lines
    }

    fn line_to(&mut self, to: [i64; 2]) {
        self.step('l', to);
    }

    fn step(&mut self, command: char, to: [i64; 2]) {
        let named = self.command != Some(command) || command == 'm';
        if named {
            self.data.push(command);
            self.command = Some(command);
        }
        let [dx, dy] = [to[0] - self.pen[0], to[1] - self.pen[1]];
        if !named && dx >= 0 {
            self.data.push(' ');
        }
        let space = if dy >= 0 { " " } else { "" };
        write!(self.data, "{dx}{space}{dy}").expect("writing to a string succeeds");
        self.pen = to;
    }
}

/// A pixel in whole hundredths. What is far off the page or no number ends at a bound.
fn hundredths(pixel: Pixel) -> [i64; 2] {
    const FAR: f64 = 1e8;
    pixel.map(|value| (value * 100.0).round().clamp(-FAR, FAR) as i64)
}
