//! From the domain's terms to the outline's.

use super::{BadTriangle, Cause, Event, Fault, Made, Start, Subsegment};
use crate::domain::Domain;
use crate::refine::incremental::{Feature, Introduction};

/// How the outline calls what a refinement knows by its own indices and scale.
#[derive(Debug)]
pub(crate) struct Names<'a> {
    /// Its points are the first vertices.
    domain: &'a Domain,
    /// How many points the outline has.
    outline_points: u32,
}

impl<'a> Names<'a> {
    pub fn new(domain: &'a Domain, outline_points: usize) -> Self {
        Self { domain, outline_points: outline_points as u32 }
    }

    /// The event in the outline's terms.
    pub fn translate(&self, event: Event) -> Event {
        match event {
            Event::Start(start) => Event::Start(self.start(start)),
            Event::Introduced(introduction) => Event::Introduced(self.introduction(introduction)),
            Event::Commit { bad, made } => {
                Event::Commit { bad: self.bad(bad), made: self.made(made) }
            }
            Event::Split { subsegment, cause, kind, made } => Event::Split {
                subsegment: self.subsegment(subsegment),
                cause: self.cause(cause),
                kind,
                made: self.made(made),
            },
            Event::Rejected { bad, point, encroached } => Event::Rejected {
                bad: self.bad(bad),
                point: self.place(point),
                encroached: encroached.into_iter().map(|s| self.subsegment(s)).collect(),
            },
            Event::RefusedSplit { subsegment, cause, refusal } => Event::RefusedSplit {
                subsegment: self.subsegment(subsegment),
                cause: self.cause(cause),
                refusal,
            },
            Event::RefusedPoint { bad, point, refusal } => {
                Event::RefusedPoint { bad: self.bad(bad), point: self.place(point), refusal }
            }
        }
    }

    fn start(&self, start: Start) -> Start {
        let mut points: Vec<_> = start
            .points
            .into_iter()
            .map(|(v, point)| (self.vertex(v), self.place(point)))
            .collect();
        points.sort_unstable_by_key(|&(index, _)| index);
        Start {
            points,
            triangles: start.triangles.into_iter().map(|corners| self.corners(corners)).collect(),
            subsegments: start.subsegments.into_iter().map(|s| self.subsegment(s)).collect(),
        }
    }

    fn vertex(&self, vertex: u32) -> u32 {
        match self.domain.input_points.get(vertex as usize) {
            Some(&input) => input,
            None => vertex - self.domain.input_points.len() as u32 + self.outline_points,
        }
    }

    fn corners(&self, vertices: [u32; 3]) -> [u32; 3] {
        vertices.map(|v| self.vertex(v))
    }

    fn place(&self, point: [f64; 2]) -> [f64; 2] {
        point.map(|c| libm::scalbn(c, self.domain.scale_exponent))
    }

    /// The introduction in the outline's terms.
    pub fn introduction(&self, Introduction { feature, called_by }: Introduction) -> Introduction {
        let feature = match feature {
            Feature::Point(vertex) => Feature::Point(self.vertex(vertex)),
            Feature::Segment(segment) => Feature::Segment(self.segment(segment)),
        };
        Introduction { feature, called_by: called_by.map(|corners| self.corners(corners)) }
    }

    fn segment(&self, segment: u32) -> u32 {
        self.domain.input_segments.get(segment as usize).copied().unwrap_or(u32::MAX)
    }

    fn subsegment(&self, Subsegment { ends, segment }: Subsegment) -> Subsegment {
        Subsegment { ends: ends.map(|v| self.vertex(v)), segment: self.segment(segment) }
    }

    fn made(&self, Made { vertex, point, star }: Made) -> Made {
        Made {
            vertex: self.vertex(vertex),
            point: self.place(point),
            star: star.into_iter().map(|corners| self.corners(corners)).collect(),
        }
    }

    fn bad(&self, BadTriangle { vertices, edge, fault }: BadTriangle) -> BadTriangle {
        let fault = match fault {
            Fault::Area(area) => Fault::Area(libm::scalbn(area, 2 * self.domain.scale_exponent)),
            angle => angle,
        };
        BadTriangle { vertices: self.corners(vertices), edge: edge.map(|v| self.vertex(v)), fault }
    }

    fn cause(&self, cause: Cause) -> Cause {
        match cause {
            Cause::Encroached(v) => Cause::Encroached(self.vertex(v)),
            Cause::Rejected(vertices) => Cause::Rejected(self.corners(vertices)),
            cause @ (Cause::Size | Cause::Augmented) => cause,
        }
    }
}
