//! The incremental version (§3, its Ref. 8): points and segments are introduced one by one.
//!
//! Every operation is one of (Conformality) and (Quality′): only their order differs, and any order
//! ends and keeps every promise. All input points are committed from the start, as §3 says. An
//! operation waits until what it is about has been introduced: a segment is not split before it is,
//! and a triangle is not improved before all its corners are. So after each introduction the mesh
//! around what is there is finished.
//!
//! A segment comes before its turn where a Steiner point needs to know of it: it would be
//! encroached by the point, or hide it. The bad triangle then waits until the segment conforms.
//! (A segment that an apex encroaches already may be encroached by a point that is in the
//! circumcircle of none of its triangles: the cavity does not show it, so such are looked up. A
//! point may lie as near to it as chance will, and pieces as short would be asked for later.)

use std::ops::ControlFlow;

use super::queue::Entry;
use super::trace::Proposer;
use super::{End, Flow, Refinement, Watch};
use crate::boxes::{Boxes, Rectangle};
use crate::domain::Domain;
use crate::parameters::Splitting;
use crate::predicates::{Relative, encroaches};
use crate::triangulation::Edge;

/// What is introduced. Indices are the domain's segments and the triangulation's vertices while the
/// refinement runs, the outline's in what it tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// A point on no segment.
    Point(u32),
    /// A segment with its ends (`u32::MAX`: an edge of the convex hull that the outline lacks).
    Segment(u32),
}

/// A feature's entry into the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Introduction {
    /// What came.
    pub feature: Feature,
    /// The bad triangle whose Steiner point called it before its turn.
    pub called_by: Option<[u32; 3]>,
}

/// What has been introduced, and what waits for the rest.
#[derive(Debug, Clone)]
pub(super) struct Introduced {
    segments: Vec<bool>,
    /// By the vertices of the domain; every later vertex is introduced.
    vertices: Vec<bool>,
    /// The squares around the segments' diametral discs.
    discs: Boxes,
    /// For each vertex of the domain, bad triangles that wait for it.
    waiting: Vec<Vec<Entry>>,
    /// The introductions so far.
    pub(super) order: Vec<Introduction>,
}

impl Introduced {
    /// Nothing has, of a domain whose points are the first of `points`.
    pub(super) fn none_of(domain: &Domain, points: &[[f64; 2]]) -> Self {
        let ends = domain.segments.iter().map(|ends| ends.map(|v| points[v as usize]));
        let discs: Vec<_> = ends.map(|[a, b]| around_diametral_disc(a, b)).collect();
        Self {
            discs: Boxes::new(&discs),
            segments: vec![false; domain.segments.len()],
            vertices: vec![false; domain.input_points.len()],
            waiting: vec![Vec::new(); domain.input_points.len()],
            order: Vec::new(),
        }
    }

    /// Lets a bad triangle wait for a vertex of its that is still to come, if there is one.
    pub(super) fn lets_wait(&mut self, entry: Entry, vertices: [u32; 3]) -> bool {
        let absent = |v: &u32| self.vertices.get(*v as usize) == Some(&false);
        let missing = vertices.into_iter().find(absent);
        if let Some(vertex) = missing {
            self.waiting[vertex as usize].push(entry);
        }
        missing.is_some()
    }
}

impl Refinement<'_> {
    /// Introduces the points on no segment, then the segments, in the domain's order; finishes the
    /// mesh after each.
    pub(super) fn introduce_one_by_one(&mut self, watch: &mut Watch) -> Flow {
        self.keep_background();
        for slot in 0..self.mesh.triangles.len() as u32 {
            self.queue_if_bad(slot);
        }
        let vertices = 0..self.provenances.inputs();
        let alone = vertices.filter(|&v| self.segments.at(v).is_empty()).map(Feature::Point);
        let segments = (0..self.segments.ends.len() as u32).map(Feature::Segment);
        let features: Vec<Feature> = alone.chain(segments).collect();
        for feature in features {
            self.introduce(Introduction { feature, called_by: None })?;
            self.restore_conformality(watch)?;
            self.improve_all(watch)?;
        }
        ControlFlow::Continue(())
    }

    /// Whether a segment may be split.
    pub(super) fn is_introduced(&self, segment: u32) -> bool {
        self.introduced.as_ref().is_none_or(|introduced| introduced.segments[segment as usize])
    }

    /// Introduces the segments that a Steiner point must not pass by, and restores conformality.
    /// False where there are none.
    pub(super) fn calls_segments(
        &mut self,
        proposer: Proposer,
        watch: &mut Watch,
    ) -> ControlFlow<End, bool> {
        let called = self.segments_to_call();
        for &segment in &called {
            let feature = Feature::Segment(segment);
            let introduction = Introduction { feature, called_by: Some(proposer.vertices) };
            self.introduce(introduction)?;
        }
        if !called.is_empty() {
            self.restore_conformality(watch)?;
        }
        ControlFlow::Continue(!called.is_empty())
    }

    /// The segments around the cavity that are still to come, and that the new point or an apex
    /// encroaches, and all others that the new point encroaches. (A point hidden behind a segment
    /// lies in the circumcircle of a triangle whose apex encroaches it.)
    fn segments_to_call(&self) -> Vec<u32> {
        let mut called = self.segments_to_come_encroached_by(self.cavity.point);
        for side in self.cavity.subsegments() {
            let Some(segment) = self.segment_of(side.ends) else { continue };
            if self.is_introduced(segment) || called.contains(&segment) {
                continue;
            }
            let corners = side.ends.map(|v| self.mesh.points[v as usize]);
            let by_new = encroaches(side.seen, corners, self.cavity.point);
            let by_apex = || {
                self.sides_of(side.ends).into_iter().flatten().any(|edge| {
                    let apex = self.mesh.points[self.mesh.apex(edge) as usize];
                    encroaches(corners.map(|corner| Relative::of(corner, apex)), corners, apex)
                })
            };
            if by_new || by_apex() {
                called.push(segment);
            }
        }
        called
    }

    /// The segments that are still to come and whose diametral discs hold a point.
    fn segments_to_come_encroached_by(&self, point: [f64; 2]) -> Vec<u32> {
        let mut found = Vec::new();
        let Some(introduced) = &self.introduced else { return found };
        let _ = introduced.discs.overlapping(&Rectangle::around(point, point), |segment| {
            let ends = self.segments.ends[segment as usize].map(|v| self.mesh.points[v as usize]);
            let seen = ends.map(|end| Relative::of(end, point));
            if !introduced.segments[segment as usize] && encroaches(seen, ends, point) {
                found.push(segment);
            }
            ControlFlow::<()>::Continue(())
        });
        found.sort_unstable();
        found
    }

    /// The triangles' edges that a subsegment is, one on either meshed side.
    fn sides_of(&self, ends: [u32; 2]) -> [Option<Edge>; 2] {
        let edge = self.mesh.subsegment(ends[0], ends[1]);
        let behind = edge.map(|edge| self.mesh.behind(edge)).filter(|edge| !edge.is_outside());
        [edge, behind]
    }

    /// Introduces a feature: queues its pieces where they are encroached, and the bad triangles
    /// that waited for its points. Nothing happens where it is there already.
    fn introduce(&mut self, introduction: Introduction) -> Flow {
        let Some(introduced) = &mut self.introduced else {
            return ControlFlow::Continue(());
        };
        let arriving = match introduction.feature {
            Feature::Point(vertex) => vec![vertex],
            Feature::Segment(segment) => {
                if std::mem::replace(&mut introduced.segments[segment as usize], true) {
                    return ControlFlow::Continue(());
                }
                self.segments.ends[segment as usize].to_vec()
            }
        };
        introduced.order.push(introduction);
        let mut released = Vec::new();
        for vertex in arriving {
            introduced.vertices[vertex as usize] = true;
            released.append(&mut introduced.waiting[vertex as usize]);
        }
        self.tell_introduced(introduction);
        if let Feature::Segment(segment) = introduction.feature {
            self.begin_segment(segment)?;
        }
        for entry in released {
            if self.is_still_there(entry) {
                self.queue_if_bad(entry.slot());
            }
        }
        ControlFlow::Continue(())
    }

    fn begin_segment(&mut self, segment: u32) -> Flow {
        let pieces = if self.parameters.splitting == Splitting::Augment {
            self.augment_segment(segment)?
        } else {
            vec![self.segments.ends[segment as usize]]
        };
        for ends in pieces {
            for edge in self.sides_of(ends).into_iter().flatten() {
                self.queue_if_encroached(edge);
            }
        }
        ControlFlow::Continue(())
    }
}

/// A square that holds the diametral disc of a segment, whatever rounding did.
fn around_diametral_disc([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> Rectangle {
    let [x, y] = [0.5 * ax + 0.5 * bx, 0.5 * ay + 0.5 * by];
    let radius = 0.5 * Relative::of([ax, ay], [bx, by]).squared.sqrt();
    let reach = radius + 1e-12 * (radius + x.abs() + y.abs());
    Rectangle::around([x - reach, y - reach], [x + reach, y + reach])
}
