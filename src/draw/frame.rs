//! The page: from coordinates to pixels, and what of a line or a polygon lies on it.

use super::Options;

/// White space around the data, in pixels.
const MARGIN: f64 = 16.0;
/// A picture is never higher than this many times its width…
const TALLEST: f64 = 1.5;
/// …nor lower than this many pixels.
const LOWEST: f64 = 80.0;
/// How far beyond the page lines are still drawn, so that their cut ends do not show.
const OVERHANG: f64 = 8.0;

/// A place on the page in pixels, x to the right, y downwards.
pub type Pixel = [f64; 2];

/// How coordinates become pixels.
///
/// Everything is computed with halves of coordinates, which have a difference even where the
/// largest doubles have none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Width of the page in pixels.
    pub width: f64,
    /// Height of the page in pixels, without the legend.
    pub height: f64,
    /// Half the coordinates of the middle of the page.
    half_centre: [f64; 2],
    /// Half of the length that one pixel shows.
    half_pixel: f64,
}

impl Frame {
    /// The page for all of `points`, or for the zoom box of `options`.
    pub fn of<'a>(points: impl Iterator<Item = &'a [f64; 2]>, options: &Options) -> Self {
        let width =
            if options.width.is_finite() { options.width.clamp(64.0, 32_768.0) } else { 960.0 };
        let width = width.round();
        let [xmin, ymin, xmax, ymax] = options.zoom.unwrap_or_else(|| extent(points));
        let half_centre = [xmin / 4.0 + xmax / 4.0, ymin / 4.0 + ymax / 4.0];
        let half_span = [xmax / 2.0 - xmin / 2.0, ymax / 2.0 - ymin / 2.0];
        let room = [width - 2.0 * MARGIN, width * TALLEST - 2.0 * MARGIN];
        let half_pixel = (half_span[0] / room[0]).max(half_span[1] / room[1]);
        // A single point has no extent: any scale shows it.
        let half_pixel = if half_pixel > 0.0 && half_pixel.is_finite() { half_pixel } else { 1.0 };
        let height = (half_span[1] / half_pixel + 2.0 * MARGIN).clamp(LOWEST, width * TALLEST);
        Self { width, height: height.round(), half_centre, half_pixel }
    }

    /// Where a point lies on the page.
    pub fn pixel(&self, [x, y]: [f64; 2]) -> Pixel {
        [
            self.width / 2.0 + (x / 2.0 - self.half_centre[0]) / self.half_pixel,
            self.height / 2.0 - (y / 2.0 - self.half_centre[1]) / self.half_pixel,
        ]
    }

    /// Whether a pixel lies on the page.
    pub fn shows(&self, [x, y]: Pixel) -> bool {
        let [left, top, right, bottom] = self.rim();
        (left..=right).contains(&x) && (top..=bottom).contains(&y)
    }

    /// The part of the line from `a` to `b` that lies on the page (Liang and Barsky).
    pub fn clip_line(&self, a: Pixel, b: Pixel) -> Option<[Pixel; 2]> {
        if self.shows(a) && self.shows(b) {
            return Some([a, b]);
        }
        let step = [b[0] - a[0], b[1] - a[1]];
        let [left, top, right, bottom] = self.rim();
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (axis, low, high) in [(0, left, right), (1, top, bottom)] {
            for (towards, distance) in [(-step[axis], a[axis] - low), (step[axis], high - a[axis])]
            {
                if towards == 0.0 {
                    if distance < 0.0 {
                        return None;
                    }
                } else if towards < 0.0 {
                    enter = enter.max(distance / towards);
                } else {
                    leave = leave.min(distance / towards);
                }
            }
        }
        let at = |t: f64| [a[0] + t * step[0], a[1] + t * step[1]];
        (enter <= leave).then(|| {
            [if enter > 0.0 { at(enter) } else { a }, if leave < 1.0 { at(leave) } else { b }]
        })
    }

    /// The part of a polygon that lies on the page (Sutherland and Hodgman). Winding numbers on
    /// the page do not change, so a region may be cut loop by loop.
    pub fn clip_polygon(&self, polygon: Vec<Pixel>) -> Vec<Pixel> {
        if polygon.iter().all(|&corner| self.shows(corner)) {
            return polygon;
        }
        let [left, top, right, bottom] = self.rim();
        [(0, left, 1.0), (0, right, -1.0), (1, top, 1.0), (1, bottom, -1.0)]
            .into_iter()
            .fold(polygon, |polygon, (axis, bound, sign)| cut(&polygon, axis, bound, sign))
    }

    fn rim(&self) -> [f64; 4] {
        [-OVERHANG, -OVERHANG, self.width + OVERHANG, self.height + OVERHANG]
    }
}

/// The part of a polygon where `sign * (coordinate - bound) >= 0`.
fn cut(polygon: &[Pixel], axis: usize, bound: f64, sign: f64) -> Vec<Pixel> {
    let inside = |corner: &Pixel| sign * (corner[axis] - bound) >= 0.0;
    let mut kept = Vec::with_capacity(polygon.len());
    for (i, &corner) in polygon.iter().enumerate() {
        let next = polygon[(i + 1) % polygon.len()];
        if inside(&corner) {
            kept.push(corner);
        }
        if inside(&corner) != inside(&next) {
            let t = (bound - corner[axis]) / (next[axis] - corner[axis]);
            let mut crossing =
                [corner[0] + t * (next[0] - corner[0]), corner[1] + t * (next[1] - corner[1])];
            crossing[axis] = bound;
            kept.push(crossing);
        }
    }
    kept
}

fn extent<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> [f64; 4] {
    let empty = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    let found = points
        .filter(|[x, y]| x.is_finite() && y.is_finite())
        .fold(empty, |[xmin, ymin, xmax, ymax], &[x, y]| {
            [xmin.min(x), ymin.min(y), xmax.max(x), ymax.max(y)]
        });
    if found[0] <= found[2] { found } else { [0.0; 4] }
}
