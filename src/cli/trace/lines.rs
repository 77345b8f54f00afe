//! Events as lines of JSON, in the numbers of the outline's file: `docs/schema/trace-1.json`.

use meshwright::Parameters;
use meshwright::formats::{Provenance, Pslg};
use meshwright::refine::End;
use meshwright::refine::incremental::Introduction;
use meshwright::refine::trace::{
    BadTriangle, Cause, Event, Fault, Made, Refusal, Start, Subsegment,
};
use serde_json::{Map, Value, json};

use crate::cli::json::{introduced, parameters};
use crate::cli::words::word;

/// The version of these objects: it changes when a reader of them would have to change.
const VERSION: u32 = 1;

/// The words for why a point is not committed.
pub const REFUSALS: [(&str, Refusal); 5] = [
    ("floor", Refusal::Floor),
    ("outside its disc", Refusal::OutsideItsDisc),
    ("unseen", Refusal::Unseen),
    ("malformed", Refusal::Malformed),
    ("all splits refused", Refusal::AllSplitsRefused),
];

/// The words for the kinds of split points.
pub const KINDS: [(&str, Provenance); 2] =
    [("shell", Provenance::Shell), ("midpoint", Provenance::Midpoint)];

/// Makes the lines of one run, in their order.
pub struct Lines<'a> {
    file: &'a str,
    pslg: &'a Pslg,
    parameters: &'a Parameters,
    /// The number of the first new point.
    first_new: i64,
    steps: usize,
    /// The step of the last rejection.
    rejection: usize,
}

impl<'a> Lines<'a> {
    /// Nothing is told yet.
    pub fn new(file: &'a str, pslg: &'a Pslg, parameters: &'a Parameters) -> Self {
        let numbers = (0..pslg.points.len() as u32).map(|index| pslg.source.point_number(index));
        let first_new = numbers.max().map_or(0, |largest| largest.saturating_add(1));
        Self { file, pslg, parameters, first_new, steps: 0, rejection: 0 }
    }

    /// How many steps were told.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// The line of an event. Its start is step 0.
    pub fn of(&mut self, event: &Event) -> String {
        if let Event::Start(start) = event {
            return self.start(start).to_string();
        }
        self.steps += 1;
        let mut object = Map::new();
        let mut put = |entries: Value| {
            if let Value::Object(entries) = entries {
                object.extend(entries);
            }
        };
        put(json!({ "event": name(event), "step": self.steps }));
        match event {
            Event::Introduced(introduction) => put(self.introduction(introduction)),
            Event::Commit { bad, made } => {
                put(self.bad(bad));
                put(self.made(made));
            }
            Event::Split { subsegment, cause, kind, made } => {
                put(self.subsegment(*subsegment));
                put(json!({ "cause": self.cause(*cause), "kind": word(&KINDS, kind) }));
                put(self.made(made));
            }
            Event::Rejected { bad, point, encroached } => {
                self.rejection = self.steps;
                put(self.bad(bad));
                let encroached: Vec<_> = encroached.iter().map(|&s| self.subsegment(s)).collect();
                put(json!({ "place": point, "encroached": encroached }));
            }
            Event::RefusedSplit { subsegment, cause, refusal } => {
                put(self.subsegment(*subsegment));
                put(json!({ "cause": self.cause(*cause), "reason": word(&REFUSALS, refusal) }));
            }
            Event::RefusedPoint { bad, point, refusal } => {
                put(self.bad(bad));
                put(json!({ "place": point, "reason": word(&REFUSALS, refusal) }));
            }
            _ => {}
        }
        Value::Object(object).to_string()
    }

    /// The last line.
    pub fn end(&self, end: End) -> String {
        let finished = end == End::Finished;
        json!({ "event": "end", "steps": self.steps, "finished": finished }).to_string()
    }

    fn start(&self, start: &Start) -> Value {
        let point = |&(index, [x, y]): &(u32, [f64; 2])| json!([self.number(index), x, y]);
        json!({
            "event": "start",
            "version": VERSION,
            "meshwright": env!("CARGO_PKG_VERSION"),
            "file": self.file,
            "parameters": parameters(self.parameters),
            "points": start.points.iter().map(point).collect::<Vec<_>>(),
            "triangles": self.triangles(&start.triangles),
            "subsegments": start.subsegments.iter().map(|&s| self.subsegment(s)).collect::<Vec<_>>(),
        })
    }

    /// The number of a vertex: the file's own; new points go on counting from its largest.
    fn number(&self, vertex: u32) -> i64 {
        match vertex.checked_sub(self.pslg.points.len() as u32) {
            Some(new) => self.first_new.saturating_add(i64::from(new)),
            None => self.pslg.source.point_number(vertex),
        }
    }

    fn triangles(&self, triangles: &[[u32; 3]]) -> Vec<[i64; 3]> {
        triangles.iter().map(|corners| corners.map(|v| self.number(v))).collect()
    }

    fn bad(&self, bad: &BadTriangle) -> Value {
        let [triangle, edge] = [&bad.vertices[..], &bad.edge]
            .map(|vertices| vertices.iter().map(|&v| self.number(v)).collect::<Vec<_>>());
        match bad.fault {
            Fault::Angle(angle) => {
                json!({ "triangle": triangle, "edge": edge, "angle": angle.to_degrees() })
            }
            Fault::Area(area) => json!({ "triangle": triangle, "edge": edge, "area": area }),
        }
    }

    fn subsegment(&self, Subsegment { ends, segment }: Subsegment) -> Value {
        let number = (segment != u32::MAX).then(|| self.pslg.source.segment_number(segment));
        json!({ "subsegment": ends.map(|v| self.number(v)), "segment": number })
    }

    fn introduction(&self, introduction: &Introduction) -> Value {
        let mut object = introduced(introduction, self.pslg);
        object["called_by"] =
            introduction.called_by.map(|corners| corners.map(|v| self.number(v))).into();
        object
    }

    fn made(&self, made: &Made) -> Value {
        json!({
            "point": self.number(made.vertex),
            "place": made.point,
            "star": self.triangles(&made.star),
        })
    }

    fn cause(&self, cause: Cause) -> Value {
        match cause {
            Cause::Encroached(vertex) => json!({ "encroached_by": self.number(vertex) }),
            Cause::Rejected(vertices) => json!({
                "rejected_in": self.rejection,
                "triangle": vertices.map(|v| self.number(v)),
            }),
            Cause::Size => json!({ "size": true }),
            Cause::Augmented => json!({ "augmented": true }),
        }
    }
}

fn name(event: &Event) -> &'static str {
    match event {
        Event::Introduced(_) => "introduced",
        Event::Commit { .. } => "commit",
        Event::Split { .. } => "split",
        Event::Rejected { .. } => "rejected",
        Event::RefusedSplit { .. } => "refused split",
        Event::RefusedPoint { .. } => "refused point",
        _ => "other",
    }
}
