//! G1, first half: Assumption 2 (i). Are the triangles a complex, whatever they cover?
//!
//! The judge's own picture of the mesh is made here too: which edge of which triangle lies along
//! which other one. Triangles that name no triangle at all are reported and left out of it;
//! a clockwise one is reported and turned, so that one fault does not hide or feign others.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::Range;

use super::edges::{self, Edges};
use super::exact;
use super::fault::{Fault, FaultKind};
use super::frame::Frame;
use super::outline::{distance, distance_squared};
use super::verdict::Judgement;
use crate::corners::{each, previous};
use crate::formats::Mesh;

/// Nothing: no half-edge, no triangle, no segment.
pub(super) const NONE: u32 = u32::MAX;

/// The sound triangles of a mesh and how they are glued.
///
/// The triangles stand in the order of their smallest points, as [`Nearby`](super::nearby::Nearby)
/// puts them. Half-edge 3t + k runs from corner k of triangle t to the next corner, t on its left.
pub(super) struct Complex<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) frame: Frame,
    /// All points of the mesh, in judged coordinates.
    pub(super) points: Cow<'a, [[f64; 2]]>,
    /// The sound triangles, none of them clockwise.
    pub(super) triangles: Cow<'a, [[u32; 3]]>,
    /// Which triangle of the mesh each of them is; nothing where they are all.
    numbers: Option<Vec<u32>>,
    /// The sum of the triangles' areas, in judged coordinates.
    pub(super) area: f64,
    /// The length of the shortest edge.
    pub(super) shortest: f64,
    /// Whether a sound triangle has this point.
    pub(super) used: Vec<bool>,
    /// How they are glued.
    edges: Edges,
    /// The two half-edges of each edge that is not locally Delaunay, the smaller one first, in order.
    pub(super) not_delaunay: Vec<[u32; 2]>,
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
            area: 0.0,
            shortest: f64::INFINITY,
            used: vec![false; mesh.points.len()],
            edges: Edges::default(),
            not_delaunay: Vec::new(),
            leaving: std::cell::OnceCell::new(),
        };
        complex.take_sound_triangles(&finite, g1);
        complex.glue(g1);
        complex
    }

    fn take_sound_triangles(&mut self, finite: &[bool], g1: &mut Judgement) {
        let mut measures = Measures::default();
        let sound = self.mesh.triangles.iter().take_while(|&&corners| {
            let is_sound = self.look_at(corners, finite) == Ok(corners);
            if is_sound {
                measures.add(each(corners, |v| self.at(v)));
            }
            is_sound
        });
        if sound.count() < self.mesh.triangles.len() {
            self.sort_out_triangles(finite, g1);
            measures = Measures::default();
            (0..self.triangles.len()).for_each(|t| measures.add(self.corners(t)));
        }
        self.area = 0.5 * measures.doubled_area.to_f64();
        self.shortest = measures.shortest_squared.sqrt();
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

    /// Glues the triangles; an edge that two of them run along in one direction is a fault.
    fn glue(&mut self, g1: &mut Judgement) {
        let mut not_delaunay = Vec::new();
        let edges = Edges::new(&self.triangles, self.points.len(), |halves| {
            if !self.is_locally_delaunay(halves) {
                not_delaunay.push(halves);
            }
        });
        for &h in &edges.overlaps {
            let fault = Fault::at_edge(self.mesh, FaultKind::Overlap, self.edge(h));
            g1.add(fault.of_triangle(self.number(h)));
        }
        not_delaunay.sort_unstable();
        (self.edges, self.not_delaunay) = (edges, not_delaunay);
    }

    /// Whether the apex on one side of an edge is not strictly inside the circle of the triangle on
    /// the other.
    fn is_locally_delaunay(&self, [h, twin]: [u32; 2]) -> bool {
        let [a, b, c] = self.corners(h as usize / 3);
        exact::in_circle(a, b, c, self.at(self.apex(twin))) != Ordering::Greater
    }

    /// The half-edges.
    pub(super) fn halves(&self) -> Range<u32> {
        0..3 * self.triangles.len() as u32
    }

    /// The half-edges that have no opposite one.
    pub(super) fn one_sided(&self) -> &[u32] {
        &self.edges.one_sided
    }

    /// The point where a half-edge begins.
    pub(super) fn origin(&self, h: u32) -> u32 {
        edges::origin(&self.triangles, h)
    }

    /// The point where a half-edge ends.
    pub(super) fn target(&self, h: u32) -> u32 {
        edges::target(&self.triangles, h)
    }

    /// The places of a triangle's corners.
    #[inline]
    pub(super) fn corners(&self, t: usize) -> [[f64; 2]; 3] {
        let [a, b, c] = self.triangles[t];
        [self.at(a), self.at(b), self.at(c)]
    }

    /// The corner opposite a half-edge.
    pub(super) fn apex(&self, h: u32) -> u32 {
        self.triangles[h as usize / 3][previous(h as usize % 3)]
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
        self.edges.find(&self.triangles, v, w)
    }

    /// The opposite half-edge, or [`NONE`].
    pub(super) fn twin(&self, h: u32) -> u32 {
        match self.find(self.origin(h), self.target(h)) {
            [first, twin] if first == h => twin,
            _ => NONE, // beside another one
        }
    }

    /// The half-edges that leave `v`.
    pub(super) fn leaving(&self, v: u32) -> &[u32] {
        let (start, halves) = self.leaving.get_or_init(|| {
            super::grouped(self.points.len(), self.halves().map(|h| (self.origin(h), h)))
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
        let edges = self.edges.count as i64;
        points - edges + self.triangles.len() as i64
    }

    /// The sum of the triangles' areas, in the units of the file.
    pub(super) fn area_outside(&self) -> f64 {
        self.frame.area_outside(self.area)
    }

    /// The half-edges that are shorter than a length.
    pub(super) fn edges_below(&self, length: f64) -> impl Iterator<Item = u32> + '_ {
        let halves = if self.shortest < length { self.halves() } else { 0..0 };
        halves.filter(move |&h| distance(self.at(self.origin(h)), self.at(self.target(h))) < length)
    }
}

/// What is summed up of triangles.
struct Measures {
    /// Twice the sum of their areas.
    doubled_area: exact::Double,
    /// The square of the length of their shortest edge.
    shortest_squared: f64,
}

impl Default for Measures {
    fn default() -> Self {
        Self { doubled_area: exact::Double::default(), shortest_squared: f64::INFINITY }
    }
}

impl Measures {
    #[inline(always)]
    fn add(&mut self, [a, b, c]: [[f64; 2]; 3]) {
        self.doubled_area = self.doubled_area + exact::cross(a, b, c);
        let sides = each([(a, b), (b, c), (c, a)], |(p, q)| distance_squared(p, q));
        self.shortest_squared = sides.into_iter().fold(self.shortest_squared, f64::min);
    }
}
