//! Plane shapes of OpenCASCADE: rectangles, disks, whole circles and ellipses.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::{Arc, Curve, CurveKind, Model, Point};
use crate::geo::error::{CurveFault, Problem};
use crate::geo::syntax::Place;

impl Model {
    /// A rectangle from its lower left corner, perhaps with rounded corners.
    pub(in crate::geo) fn add_rectangle(
        &mut self,
        place: Place,
        tag: i32,
        corner: [f64; 3],
        [width, height]: [f64; 2],
        radius: f64,
    ) -> Result<(), Problem> {
        if width == 0.0
            || height == 0.0
            || radius < 0.0
            || 2.0 * radius > width.abs().min(height.abs())
        {
            return Err(Problem::Kind {
                expected: "a rectangle with a width, a height and a radius that fits".into(),
                found: "another one",
            });
        }
        let [x, y, z] = corner;
        let (w, h, r) = (width, height, radius);
        let curves = if r == 0.0 {
            let corners = [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]];
            let points = self.free_points(place, corners.map(|[a, b]| [x + a, y + b, z]))?;
            let sides =
                [0, 1, 2, 3].map(|i| (CurveKind::Line, vec![points[i], points[(i + 1) % 4]]));
            self.free_curves(place, sides)?
        } else {
            let (rx, ry) = (r * w.signum(), r * h.signum());
            let ends = [
                [rx, 0.0],
                [w - rx, 0.0],
                [w, ry],
                [w, h - ry],
                [w - rx, h],
                [rx, h],
                [0.0, h - ry],
                [0.0, ry],
            ];
            let points = self.free_points(place, ends.map(|[a, b]| [x + a, y + b, z]))?;
            let centres = [[w - rx, ry], [w - rx, h - ry], [rx, h - ry], [rx, ry]];
            let pieces: [_; 8] = std::array::from_fn(|i| {
                let ends = vec![points[i], points[(i + 1) % 8]];
                if i % 2 == 0 {
                    return (CurveKind::Line, ends);
                }
                let [a, b] = centres[i / 2];
                let from = -FRAC_PI_2 + FRAC_PI_2 * (i / 2) as f64;
                let (u, v) = ([rx, 0.0, 0.0], [0.0, ry, 0.0]);
                let centre = [x + a, y + b, z];
                (CurveKind::Arc(Box::new(Arc { centre, u, v, from, to: from + FRAC_PI_2 })), ends)
            });
            self.free_curves(place, pieces)?
        };
        self.insert_surface(place, tag, vec![(0, curves)])
    }

    /// A disk, or the inside of an ellipse whose first radius is the larger.
    pub(in crate::geo) fn add_disk(
        &mut self,
        place: Place,
        tag: i32,
        centre: [f64; 3],
        radii: [f64; 2],
    ) -> Result<(), Problem> {
        let curve = self.tags.curve.saturating_add(1);
        self.add_ellipse(place, curve, centre, radii, [0.0, TAU])?;
        self.insert_surface(place, tag, vec![(0, vec![curve])])
    }

    /// A circle or an ellipse about a centre, or a part of it between two angles.
    pub(in crate::geo) fn add_ellipse(
        &mut self,
        place: Place,
        tag: i32,
        centre: [f64; 3],
        radii: [f64; 2],
        [from, to]: [f64; 2],
    ) -> Result<(), Problem> {
        if let Some(&radius) = radii.iter().find(|&&radius| radius <= 0.0) {
            return Err(Problem::Curve { tag, fault: CurveFault::Radius(radius) });
        }
        let (u, v) = ([radii[0], 0.0, 0.0], [0.0, radii[1], 0.0]);
        // Between angles a whole turn apart it is closed; else the arc goes counter-clockwise.
        let turn = to - from;
        let is_whole = (turn.abs() - TAU).abs() <= 1e-9 * PI;
        let to = match is_whole {
            true => from + TAU,
            false => from + turn - TAU * (turn / TAU).floor(),
        };
        if to == from {
            return Err(Problem::Curve { tag, fault: CurveFault::TooFewPoints });
        }
        let arc = Arc { centre, u, v, from, to };
        let points = if is_whole {
            let [point] = self.free_points(place, [arc.at(from)])?;
            vec![point, point]
        } else {
            self.free_points(place, [arc.at(from), arc.at(to)])?.to_vec()
        };
        let kind = CurveKind::Arc(Box::new(arc));
        self.add_curve(tag, Curve { place, kind, points: points.into(), spread: None })
    }

    /// Points with free numbers.
    fn free_points<const N: usize>(
        &mut self,
        place: Place,
        at: [[f64; 3]; N],
    ) -> Result<[i32; N], Problem> {
        let mut tags = [0; N];
        for (tag, at) in tags.iter_mut().zip(at) {
            *tag = self.tags.next_point();
            self.add_point(*tag, Point { place, at, size: None })?;
        }
        Ok(tags)
    }

    /// Curves with free numbers.
    fn free_curves<const N: usize>(
        &mut self,
        place: Place,
        curves: [(CurveKind, Vec<i32>); N],
    ) -> Result<Vec<i32>, Problem> {
        let mut tags = Vec::with_capacity(N);
        for (kind, points) in curves {
            let tag = self.tags.curve.saturating_add(1);
            self.add_curve(tag, Curve { place, kind, points: points.into(), spread: None })?;
            tags.push(tag);
        }
        Ok(tags)
    }
}
