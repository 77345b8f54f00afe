//! How a refinement tells its events.

use std::fmt;

use super::{BadTriangle, Cause, Event, Fault, Made, Refusal, Start, Subsegment};
use crate::refine::Refinement;
use crate::refine::incremental::Introduction;
use crate::refine::quality::Trigger;
use crate::triangulation::Edge;

/// Whoever wants to hear the events of a refinement; nobody by default.
#[derive(Default)]
pub struct Listener<'a>(Option<&'a mut dyn FnMut(Event)>);

impl<'a> Listener<'a> {
    /// Lets `hear` hear every event, in the domain's terms.
    pub fn new(hear: &'a mut dyn FnMut(Event)) -> Self {
        Self(Some(hear))
    }
}

impl fmt::Debug for Listener<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Listener" } else { "Nobody" })
    }
}

/// A bad triangle as the refinement meets it.
#[derive(Debug, Clone, Copy)]
pub(in crate::refine) struct Proposer {
    pub vertices: [u32; 3],
    pub trigger: Trigger,
    pub point: [f64; 2],
}

impl Proposer {
    fn told(self) -> BadTriangle {
        let Self { vertices, trigger: Trigger { edge, angle, only_size, .. }, .. } = self;
        BadTriangle {
            vertices,
            edge: [(edge + 1) % 3, (edge + 2) % 3].map(|i| vertices[i]),
            // The cross product of two edges is twice the area.
            fault: if only_size {
                Fault::Area(0.5 * angle.cross)
            } else {
                Fault::Angle(angle.radians())
            },
        }
    }
}

impl Refinement<'_> {
    fn tell(&mut self, event: impl FnOnce(&Self) -> Event) {
        if let Some(hear) = self.listener.0.take() {
            hear(event(self));
            self.listener.0 = Some(hear);
        }
    }

    pub(in crate::refine) fn tell_start(&mut self) {
        self.tell(|refinement| Event::Start(refinement.start()));
    }

    pub(in crate::refine) fn tell_introduced(&mut self, introduction: Introduction) {
        self.tell(|_| Event::Introduced(introduction));
    }

    /// After the commit, while the cavity is still that of the new point.
    pub(in crate::refine) fn tell_commit(&mut self, proposer: Proposer) {
        self.tell(|refinement| Event::Commit { bad: proposer.told(), made: refinement.made() });
    }

    /// After the commit, while the cavity is still that of the new point.
    pub(in crate::refine) fn tell_split(&mut self, ends: [u32; 2], cause: Cause) {
        self.tell(|refinement| {
            let made = refinement.made();
            let kind = refinement.provenances.kind(made.vertex);
            Event::Split { subsegment: refinement.subsegment(ends), cause, kind, made }
        });
    }

    pub(in crate::refine) fn tell_rejected(&mut self, proposer: Proposer, encroached: &[[u32; 2]]) {
        self.tell(|refinement| Event::Rejected {
            bad: proposer.told(),
            point: proposer.point,
            encroached: encroached.iter().map(|&ends| refinement.subsegment(ends)).collect(),
        });
    }

    pub(in crate::refine) fn tell_refused_split(
        &mut self,
        ends: [u32; 2],
        cause: Cause,
        refusal: Refusal,
    ) {
        self.tell(|refinement| {
            let subsegment = refinement.subsegment(ends);
            Event::RefusedSplit { subsegment, cause, refusal }
        });
    }

    pub(in crate::refine) fn tell_refused_point(&mut self, proposer: Proposer, refusal: Refusal) {
        self.tell(|_| Event::RefusedPoint { bad: proposer.told(), point: proposer.point, refusal });
    }

    fn start(&self) -> Start {
        let mesh = &self.mesh;
        let triangles: Vec<_> = mesh.triangles.iter().map(|triangle| triangle.vertices).collect();
        let mut used = triangles.as_flattened().to_vec();
        used.sort_unstable();
        used.dedup();
        let once = |&edge: &Edge| {
            let behind = mesh.behind(edge);
            behind.is_outside() || edge.triangle() < behind.triangle()
        };
        let edges = mesh.constrained_edges().filter(once);
        Start {
            points: used.into_iter().map(|v| (v, mesh.points[v as usize])).collect(),
            triangles,
            subsegments: edges.map(|edge| self.subsegment(mesh.ends(edge))).collect(),
        }
    }

    fn made(&self) -> Made {
        let star = self.cavity.star.iter().map(|&slot| self.mesh.triangles[slot as usize].vertices);
        let vertex = self.mesh.points.len() as u32 - 1;
        Made { vertex, point: self.cavity.point, star: star.collect() }
    }

    fn subsegment(&self, ends: [u32; 2]) -> Subsegment {
        Subsegment { ends, segment: self.segment_of(ends).unwrap_or(u32::MAX) }
    }
}
