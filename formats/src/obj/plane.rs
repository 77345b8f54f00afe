//! From vertices in space to points of the plane that they lie in.
//!
//! A plane along two axes keeps their coordinates bit for bit. In any other, the axes of the
//! drawing are the first two axes of space (those that are least steep), made perpendicular.

use super::Reader;
use crate::error::{Found, Notice, SyntaxError, Warning};

/// How far from a plane vertices may lie, in parts of their extent: exporters round.
const TOLERANCE: f64 = 1e-5;

/// Larger coordinates leave no room for the arithmetic of a tilted plane.
const HUGE: f64 = 1e300;

/// Axes of space, in the order in which a drawing leaves them out, each with those it keeps.
const AXES: [(usize, [usize; 2], char); 3] = [(2, [0, 1], 'z'), (1, [0, 2], 'y'), (0, [1, 2], 'x')];

type Place = [f64; 3];

/// Puts the vertices of a reader into their plane.
///
/// # Errors
/// A vertex that does not lie in the plane of the others.
pub fn flatten(
    reader: &mut Reader,
    numbers: &[i64],
    warnings: &mut Vec<Warning>,
) -> Result<(), SyntaxError> {
    let space = Space { points: &reader.vertices, heights: &reader.heights };
    if space.is_empty() {
        return Ok(());
    }
    let bounds = space.bounds();
    // Halves, which no coordinates are too large for.
    let halves = bounds.map(|[least, most]| 0.5 * most - 0.5 * least);
    let off = TOLERANCE * halves.into_iter().fold(0.0, f64::max);
    let line = reader.vertex_lines[0];
    let flat = AXES.into_iter().find(|&(axis, ..)| halves[axis] <= off);
    if let Some((axis, kept, name)) = flat {
        let [least, most] = bounds[axis];
        if axis != 2 || least != 0.0 || most != 0.0 {
            let notice = Notice::FlatAxis { axis: name, least, most };
            warnings.push(reader.warning(line, notice));
        }
        if axis != 2 {
            reader.vertices = space.places().map(|place| kept.map(|axis| place[axis])).collect();
        }
        return Ok(());
    }
    let is_huge = |place: Place| place.iter().any(|x| x.abs() > HUGE);
    if let Some(vertex) = space.places().position(is_huge) {
        let expected = "coordinates up to 1e300, for the plane is tilted";
        return Err(reader.scanner.unexpected_in_line(reader.vertex_lines[vertex], expected));
    }
    let plane = Plane::through(&space);
    if space.farthest_by(|place| plane.distance(place)).1 > 2.0 * off {
        return Err(off_plane(reader, &space, 2.0 * off, numbers));
    }
    let [u, v] = plane.axes();
    let points = space.places().map(|place| [dot(place, u), dot(place, v)]).collect();
    warnings.push(reader.warning(line, Notice::Projected { normal: plane.normal }));
    reader.vertices = points;
    Ok(())
}

/// Vertices in space.
struct Space<'a> {
    points: &'a [[f64; 2]],
    heights: &'a [f64],
}

impl Space<'_> {
    fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    fn place(&self, vertex: usize) -> Place {
        let [x, y] = self.points[vertex];
        [x, y, self.heights[vertex]]
    }

    fn places(&self) -> impl Iterator<Item = Place> + Clone + '_ {
        (0..self.points.len()).map(|vertex| self.place(vertex))
    }

    /// The least and the greatest coordinate along each axis.
    fn bounds(&self) -> [[f64; 2]; 3] {
        let nothing = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        self.places().fold(nothing, |bounds, place| {
            [0, 1, 2]
                .map(|axis| [bounds[axis][0].min(place[axis]), bounds[axis][1].max(place[axis])])
        })
    }

    /// The vertex that is farthest by this measure, and its distance.
    fn farthest_by(&self, measure: impl Fn(Place) -> f64) -> (usize, f64) {
        let distances = self.places().map(measure).enumerate();
        distances.reduce(|best, next| if next.1 > best.1 { next } else { best }).unwrap_or_default()
    }
}

/// A plane in space.
struct Plane {
    origin: Place,
    /// Of length 1.
    normal: Place,
}

impl Plane {
    /// The plane through three vertices that are as far apart as can be had in three passes.
    fn through(space: &Space) -> Self {
        let at = |(vertex, _)| space.place(vertex);
        let first = space.place(0);
        let a = at(space.farthest_by(|place| length(minus(place, first))));
        let b = at(space.farthest_by(|place| length(minus(place, a))));
        let along = unit(minus(b, a));
        let c = at(space.farthest_by(|place| length(cross(minus(place, a), along))));
        let mut normal = unit(cross(along, minus(c, a)));
        if length(normal) == 0.0 {
            // All on one line: any plane through it.
            let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let steepest = axes.map(|axis| cross(along, axis));
            normal = unit(largest(steepest));
        }
        if normal[steepest_axis(normal)] < 0.0 {
            normal = normal.map(|coordinate| -coordinate);
        }
        Self { origin: a, normal }
    }

    /// The plane across an axis that half of the vertices are below or in.
    fn at_median(space: &Space, axis: usize) -> Self {
        let mut coordinates: Vec<f64> = space.places().map(|place| place[axis]).collect();
        let middle = (coordinates.len() - 1) / 2;
        let (_, &mut median, _) = coordinates.select_nth_unstable_by(middle, f64::total_cmp);
        let (mut origin, mut normal) = ([0.0; 3], [0.0; 3]);
        (origin[axis], normal[axis]) = (median, 1.0);
        Self { origin, normal }
    }

    fn distance(&self, place: Place) -> f64 {
        dot(minus(place, self.origin), self.normal).abs()
    }

    /// The axes of a drawing in this plane, perpendicular and of length 1.
    fn axes(&self) -> [Place; 2] {
        let kept = AXES[2 - steepest_axis(self.normal)].1;
        let [e, f] = kept.map(|axis| {
            let mut unit = [0.0; 3];
            unit[axis] = 1.0;
            unit
        });
        let without = |from: Place, axis: Place| minus(from, axis.map(|x| x * dot(from, axis)));
        let u = unit(without(e, self.normal));
        let v = unit(without(without(f, self.normal), u));
        [u, v]
    }
}

/// The error that the vertices lie in no plane: of the planes along two axes and the one through
/// far vertices, the one that holds most vertices tells which vertex is off.
fn off_plane(reader: &Reader, space: &Space, most: f64, numbers: &[i64]) -> SyntaxError {
    // A vertex that fixes a plane says nothing for it.
    let along_axes = [2, 1, 0].map(|axis| (1, Plane::at_median(space, axis)));
    let planes = along_axes.into_iter().chain([(3, Plane::through(space))]);
    let held = |plane: &Plane| space.places().filter(|&p| plane.distance(p) <= most).count();
    let counted = planes.map(|(fixing, plane)| (held(&plane).saturating_sub(fixing), plane));
    let best = counted.reduce(|best, next| if next.0 > best.0 { next } else { best });
    let distance = |place| best.as_ref().map_or(0.0, |(_, plane)| plane.distance(place));
    let (vertex, distance) = space.farthest_by(distance);
    let number = numbers.get(vertex).copied().unwrap_or(vertex as i64 + 1);
    let line = reader.vertex_lines[vertex];
    let mut error = reader.scanner.unexpected_in_line(line, "vertices in one plane");
    error.found = Found::OffPlane { vertex: number, distance };
    error.help = Some("an outline is flat: export a drawing in one plane".into());
    error
}

fn steepest_axis(normal: Place) -> usize {
    let mut steepest = 2;
    for axis in [1, 0] {
        if normal[axis].abs() > normal[steepest].abs() {
            steepest = axis;
        }
    }
    steepest
}

fn largest(vectors: [Place; 3]) -> Place {
    let [first, rest @ ..] = vectors;
    rest.into_iter().fold(first, |best, next| if length(next) > length(best) { next } else { best })
}

fn minus(a: Place, b: Place) -> Place {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Place, b: Place) -> Place {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: Place) -> f64 {
    // Scaled, so that no square is too large or too small.
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let scaled = a.map(|x| x / largest);
    largest * dot(scaled, scaled).sqrt()
}

/// The vector of length 1 in this direction; zero for zero.
fn unit(a: Place) -> Place {
    let length = length(a);
    if length == 0.0 { a } else { a.map(|x| x / length) }
}
