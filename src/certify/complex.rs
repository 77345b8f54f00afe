//! G1, first half: Assumption 2 (i). Are the triangles a complex, whatever they cover?
//!
//! The judge's own picture of the mesh is made here too: which edge of which triangle lies along
//! which other one. Triangles that name no triangle at all are reported and left out of it;
//! a clockwise one is reported and turned, so that one fault does not hide or feign others.

use std::borrow::Cow;
use std::cmp::Ordering;

use super::exact;
use super::fault::{Fault, FaultKind};
use super::frame::Frame;
use super::verdict::Judgement;
use crate::formats::Mesh;

/// Nothing: no half-edge, no triangle, no segment.
pub(super) const NONE: u32 = u32::MAX;

/// The sound triangles of a mesh and how they are glued.
///
/// Half-edge 3t + k runs from corner k of triangle t to the next corner, t on its left.
pub(super) struct Complex<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) frame: Frame,
    /// All points of the mesh, in judged coordinates.
    pub(super) points: Cow<'a, [[f64; 2]]>,
    /// The sound triangles, none of them clockwise.
    pub(super) triangles: Cow<'a, [[u32; 3]]>,
    /// Which triangle of the mesh each of them is; nothing where they are all.
    numbers: Option<Vec<u32>>,
    /// The opposite half-edge, or [`NONE`].
    pub(super) twin: Vec<u32>,
    /// The sum of the triangles' areas, in judged coordinates.
    pub(super) area: f64,
    /// Whether a sound triangle has this point.
    pub(super) used: Vec<bool>,
    /// Half-edges by their smaller point (`start` delimits them), then by their larger one.
    by_smaller: Vec<u32>,
    start: Vec<u32>,
    /// Half-edges by the point they leave, made when first asked for.
    leaving: std::cell::OnceCell<(Vec<u32>, Vec<u32>)>,
}

/// What is wrong with a triangle.
#[derive(PartialEq)]
struct Unsound {
    /// The fault, if it is not its point's.
    fault: Option<FaultKind>,
    /// The triangle that it counts as all the same.
    taken_for: Option<[u32; 3]>,
}

impl<'a> Complex<'a> {
    /// Sorts out the triangles of `mesh`, reporting to `g1` what is no complex.
    pub(super) fn new(mesh: &'a Mesh, frame: Frame, g1: &mut Judgement) -> Self {
        let points = frame.all_scaled(&mesh.points);
        let finite: Vec<bool> = points.iter().map(|p| p.iter().all(|x| x.is_finite())).collect();
        for (i, _) in finite.iter().enumerate().filter(|(_, finite)| !**finite) {
            g1.add(Fault::at_point(mesh, FaultKind::NotFinite, i as u32));
        }
        let mut complex = Self {
            mesh,
            frame,
            points,
            triangles: Cow::Borrowed(&mesh.triangles),
            numbers: None,
            twin: Vec::new(),
            area: 0.0,
            used: vec![false; mesh.points.len()],
            by_smaller: Vec::new(),
            start: Vec::new(),
            leaving: std::cell::OnceCell::new(),
        };
        complex.take_sound_triangles(&finite, g1);
        complex.area = complex.sum_of_areas();
        complex.glue(g1);
        complex
    }

    fn take_sound_triangles(&mut self, finite: &[bool], g1: &mut Judgement) {
        let is_sound = |&corners: &[u32; 3]| self.look_at(corners, finite) == Ok(corners);
        if !self.mesh.triangles.iter().all(is_sound) {
            self.sort_out_triangles(finite, g1);
        }
        for &v in self.triangles.iter().flatten() {
            self.used[v as usize] = true;
        }
        for v in (0..self.points.len()).filter(|&v| !self.used[v] && finite[v]) {
            g1.add(Fault::at_point(self.mesh, FaultKind::UnusedPoint, v as u32));
        }
    }

    /// Leaves out what is no triangle, and turns what is clockwise.
    fn sort_out_triangles(&mut self, finite: &[bool], g1: &mut Judgement) {
        let (mut triangles, mut numbers) = (Vec::new(), Vec::new());
        for (number, &corners) in (0..).zip(&self.mesh.triangles) {
            let looked = self.look_at(corners, finite);
            if let Err(Unsound { fault: Some(fault), .. }) = &looked {
                g1.add(Fault::at_triangle(self.mesh, fault.clone(), number));
            }
            if let Some(triangle) = looked.map_or_else(|unsound| unsound.taken_for, Some) {
                triangles.push(triangle);
                numbers.push(number);
            }
        }
        (self.triangles, self.numbers) = (Cow::Owned(triangles), Some(numbers));
    }

    /// A triangle of the mesh, or what is wrong with it.
    fn look_at(&self, corners: [u32; 3], finite: &[bool]) -> Result<[u32; 3], Unsound> {
        let unsound = |fault| Err(Unsound { fault, taken_for: None });
        let [a, b, c] = corners;
        if corners.iter().any(|&v| v as usize >= self.points.len()) {
            return unsound(Some(FaultKind::NoSuchPoint));
        }
        if corners.iter().any(|&v| !finite[v as usize]) {
            return unsound(None); // its point is reported
        }
        if a == b || b == c || c == a {
            return unsound(Some(FaultKind::RepeatedCorner));
        }
        let (fault, taken_for) = match exact::orientation(self.at(a), self.at(b), self.at(c)) {
            Ordering::Greater => return Ok(corners),
            Ordering::Equal => (FaultKind::Flat, corners),
            Ordering::Less => (FaultKind::Clockwise, [a, c, b]),
        };
        Err(Unsound { fault: Some(fault), taken_for: Some(taken_for) })
    }

    /// Finds the twins; an edge that two triangles run along in one direction is a fault.
    fn glue(&mut self, g1: &mut Judgement) {
        let halves = 3 * self.triangles.len() as u32;
        let mut start = vec![0_u32; self.points.len() + 1];
        for h in 0..halves {
            start[self.smaller(h) as usize + 1] += 1;
        }
        for v in 1..start.len() {
            start[v] += start[v - 1];
        }
        let mut next = start.clone();
        let mut by_smaller = vec![0; halves as usize];
        for h in 0..halves {
            let place = &mut next[self.smaller(h) as usize];
            by_smaller[*place as usize] = h;
            *place += 1;
        }
        drop(next);
        let mut twin = vec![NONE; halves as usize];
        // Of one point: larger point and half-edge.
        let mut sorted: Vec<u64> = Vec::new();
        for (smaller, range) in (0..).zip(start.windows(2)) {
            let around = &mut by_smaller[range[0] as usize..range[1] as usize];
            sorted.clear();
            sorted.extend(around.iter().map(|&h| u64::from(self.larger(h)) << 32 | u64::from(h)));
            sorted.sort_unstable();
            around.iter_mut().zip(&sorted).for_each(|(h, &packed)| *h = packed as u32);
            for edge in sorted.chunk_by(|x, y| x >> 32 == y >> 32) {
                let mut ways = [NONE; 2];
                for h in edge.iter().map(|&packed| packed as u32) {
                    let way = usize::from(self.origin(h) == smaller);
                    if ways[way] == NONE {
                        ways[way] = h;
                    } else {
                        let (triangle, edge) = (self.number(h), self.edge(h));
                        g1.add(
                            Fault::at_edge(self.mesh, FaultKind::Overlap, edge)
                                .of_triangle(triangle),
                        );
                    }
                }
                if let [h, g] = ways
                    && h != NONE
                    && g != NONE
                {
                    (twin[h as usize], twin[g as usize]) = (g, h);
                }
            }
        }
        (self.twin, self.by_smaller, self.start) = (twin, by_smaller, start);
    }

    fn smaller(&self, h: u32) -> u32 {
        self.origin(h).min(self.target(h))
    }

    fn larger(&self, h: u32) -> u32 {
        self.origin(h).max(self.target(h))
    }

    /// The point where a half-edge begins.
    pub(super) fn origin(&self, h: u32) -> u32 {
        self.triangles[h as usize / 3][h as usize % 3]
    }

    /// The point where a half-edge ends.
    pub(super) fn target(&self, h: u32) -> u32 {
        self.triangles[h as usize / 3][(h as usize + 1) % 3]
    }

    /// The places of a triangle's corners.
    #[inline]
    pub(super) fn corners(&self, t: usize) -> [[f64; 2]; 3] {
        let [a, b, c] = self.triangles[t];
        [self.at(a), self.at(b), self.at(c)]
    }

    /// The corner opposite a half-edge.
    pub(super) fn apex(&self, h: u32) -> u32 {
        self.triangles[h as usize / 3][(h as usize + 2) % 3]
    }

    /// A half-edge as its two points.
    pub(super) fn edge(&self, h: u32) -> [u32; 2] {
        [self.origin(h), self.target(h)]
    }

    /// The triangle of the mesh that a half-edge belongs to.
    pub(super) fn number(&self, h: u32) -> u32 {
        self.number_of(h as usize / 3)
    }

    /// The triangle of the mesh that a sound one is.
    pub(super) fn number_of(&self, t: usize) -> u32 {
        self.numbers.as_ref().map_or(t as u32, |numbers| numbers[t])
    }

    /// The coordinates of a point.
    pub(super) fn at(&self, v: u32) -> [f64; 2] {
        self.points[v as usize]
    }

    /// The half-edges from `v` to `w` and from `w` to `v`, each [`NONE`] where there is none.
    pub(super) fn find(&self, v: u32, w: u32) -> [u32; 2] {
        let smaller = v.min(w) as usize;
        let mut found = [NONE; 2];
        if smaller + 1 >= self.start.len() {
            return found;
        }
        let around =
            &self.by_smaller[self.start[smaller] as usize..self.start[smaller + 1] as usize];
        let larger = v.max(w);
        let first = around.partition_point(|&h| self.larger(h) < larger);
        for &h in around[first..].iter().take_while(|&&h| self.larger(h) == larger) {
            let way = usize::from(self.origin(h) != v);
            if found[way] == NONE {
                found[way] = h;
            }
        }
        found
    }

    /// The half-edges that leave `v`.
    pub(super) fn leaving(&self, v: u32) -> &[u32] {
        let (start, halves) = self.leaving.get_or_init(|| {
            let count = 3 * self.triangles.len() as u32;
            super::grouped(self.points.len(), (0..count).map(|h| (self.origin(h), h)))
        });
        &halves[start[v as usize] as usize..start[v as usize + 1] as usize]
    }

    /// Every point that shares an edge with `v` (twice, where the edge has two sides).
    pub(super) fn around(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        self.leaving(v).iter().flat_map(|&h| [self.target(h), self.apex(h)])
    }

    /// V − E + F of the sound triangles and the points they use.
    pub(super) fn euler_characteristic(&self) -> i64 {
        let points = self.used.iter().filter(|used| **used).count() as i64;
        let twins = self.twin.iter().filter(|twin| **twin != NONE).count() as i64;
        let edges = self.twin.len() as i64 - twins / 2;
        points - edges + self.triangles.len() as i64
    }

    /// The sum of the triangles' areas, in the units of the file.
    pub(super) fn area_outside(&self) -> f64 {
        self.frame.area_outside(self.area)
    }

    /// The sum of the triangles' areas, in judged coordinates.
    fn sum_of_areas(&self) -> f64 {
        let mut doubled = exact::Double::default();
        for t in 0..self.triangles.len() {
            let [a, b, c] = self.corners(t);
            doubled = doubled + exact::cross(a, b, c);
        }
        0.5 * doubled.to_f64()
    }
}
