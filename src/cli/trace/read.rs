//! The lines of a trace, read back.

use std::collections::BTreeMap;

use meshwright::refine::incremental::{Feature, Introduction};
use meshwright::refine::trace::{BadTriangle, Cause, Event, Fault, Made, Start, Subsegment};
use serde_json::Value;

use super::lines::{KINDS, REFUSALS};
use crate::cli::words::value;

/// Reads the events of a trace, line by line. Vertices and segments count from zero in the order
/// in which they appear.
#[derive(Debug, Default)]
pub struct Reader {
    vertices: BTreeMap<i64, u32>,
    segments: BTreeMap<i64, u32>,
}

impl Reader {
    /// The event of a line; `Ok(None)` for the last line of a trace, `Err` with what is missing
    /// for what is no line of one.
    pub fn read(&mut self, line: &str) -> Result<Option<Event>, String> {
        let value: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
        let event = match value["event"].as_str() {
            Some("start") => Event::Start(self.start(&value)?),
            Some("introduced") => Event::Introduced(self.introduction(&value)?),
            Some("commit") => Event::Commit { bad: self.bad(&value)?, made: self.made(&value)? },
            Some("split") => Event::Split {
                subsegment: self.subsegment(&value)?,
                cause: self.cause(&value["cause"])?,
                kind: meaning(&KINDS, &value["kind"], "kind")?,
                made: self.made(&value)?,
            },
            Some("rejected") => Event::Rejected {
                bad: self.bad(&value)?,
                point: place(&value["place"])?,
                encroached: self.subsegments(&value["encroached"])?,
            },
            Some("refused split") => Event::RefusedSplit {
                subsegment: self.subsegment(&value)?,
                cause: self.cause(&value["cause"])?,
                refusal: meaning(&REFUSALS, &value["reason"], "reason")?,
            },
            Some("refused point") => Event::RefusedPoint {
                bad: self.bad(&value)?,
                point: place(&value["place"])?,
                refusal: meaning(&REFUSALS, &value["reason"], "reason")?,
            },
            Some("end") => return Ok(None),
            _ => return Err(missing("event")),
        };
        Ok(Some(event))
    }

    /// The number that the trace gives to a vertex.
    pub fn number(&self, vertex: u32) -> i64 {
        let found = self.vertices.iter().find(|&(_, &index)| index == vertex);
        found.map_or(-1, |(&number, _)| number)
    }

    fn start(&mut self, value: &Value) -> Result<Start, String> {
        let mut points = Vec::new();
        for point in list(&value["points"], "points")? {
            let vertex = self.new_vertex(&point[0])?;
            points.push((vertex, place(&Value::from(vec![point[1].clone(), point[2].clone()]))?));
        }
        Ok(Start {
            points,
            triangles: self.triangles(&value["triangles"])?,
            subsegments: self.subsegments(&value["subsegments"])?,
        })
    }

    fn new_vertex(&mut self, number: &Value) -> Result<u32, String> {
        let number = number.as_i64().ok_or_else(|| missing("the number of a point"))?;
        let index = self.vertices.len() as u32;
        match self.vertices.insert(number, index) {
            None => Ok(index),
            Some(_) => Err(format!("point {number} is there already")),
        }
    }

    fn vertex(&self, number: &Value) -> Result<u32, String> {
        let number = number.as_i64().ok_or_else(|| missing("the number of a point"))?;
        self.vertices.get(&number).copied().ok_or_else(|| format!("there is no point {number} yet"))
    }

    fn vertices<const N: usize>(&self, value: &Value, name: &str) -> Result<[u32; N], String> {
        let numbers = list(value, name)?.iter().map(|number| self.vertex(number));
        let found: Vec<u32> = numbers.collect::<Result<_, _>>()?;
        found.try_into().map_err(|_| missing(name))
    }

    fn triangles(&self, value: &Value) -> Result<Vec<[u32; 3]>, String> {
        list(value, "triangles")?.iter().map(|corners| self.vertices(corners, "triangle")).collect()
    }

    fn subsegments(&mut self, value: &Value) -> Result<Vec<Subsegment>, String> {
        list(value, "subsegments")?.iter().map(|piece| self.subsegment(piece)).collect()
    }

    fn subsegment(&mut self, value: &Value) -> Result<Subsegment, String> {
        let ends = self.vertices(&value["subsegment"], "subsegment")?;
        Ok(Subsegment { ends, segment: self.segment(&value["segment"]) })
    }

    fn introduction(&mut self, value: &Value) -> Result<Introduction, String> {
        let feature = match &value["point"] {
            Value::Null => Feature::Segment(self.segment(&value["segment"])),
            number => Feature::Point(self.vertex(number)?),
        };
        let called_by = match &value["called_by"] {
            Value::Null => None,
            corners => Some(self.vertices(corners, "called_by")?),
        };
        Ok(Introduction { feature, called_by })
    }

    fn segment(&mut self, number: &Value) -> u32 {
        let next = self.segments.len() as u32;
        number.as_i64().map_or(u32::MAX, |number| *self.segments.entry(number).or_insert(next))
    }

    fn bad(&self, value: &Value) -> Result<BadTriangle, String> {
        let fault = match (value["angle"].as_f64(), value["area"].as_f64()) {
            (Some(angle), _) => Fault::Angle(angle.to_radians()),
            (None, Some(area)) => Fault::Area(area),
            (None, None) => return Err(missing("angle")),
        };
        let vertices = self.vertices(&value["triangle"], "triangle")?;
        Ok(BadTriangle { vertices, edge: self.vertices(&value["edge"], "edge")?, fault })
    }

    fn made(&mut self, value: &Value) -> Result<Made, String> {
        let vertex = self.new_vertex(&value["point"])?;
        let point = place(&value["place"])?;
        Ok(Made { vertex, point, star: self.triangles(&value["star"])? })
    }

    fn cause(&self, value: &Value) -> Result<Cause, String> {
        if value["augmented"] == true {
            return Ok(Cause::Augmented);
        }
        if value["size"] == true {
            return Ok(Cause::Size);
        }
        match value.get("encroached_by") {
            Some(vertex) => Ok(Cause::Encroached(self.vertex(vertex)?)),
            None => Ok(Cause::Rejected(self.vertices(&value["triangle"], "triangle")?)),
        }
    }
}

fn missing(name: &str) -> String {
    format!("`{name}` is missing or wrong")
}

fn list<'a>(value: &'a Value, name: &str) -> Result<&'a [Value], String> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| missing(name))
}

fn place(value: &Value) -> Result<[f64; 2], String> {
    match [0, 1].map(|axis| value[axis].as_f64()) {
        [Some(x), Some(y)] => Ok([x, y]),
        _ => Err(missing("place")),
    }
}

fn meaning<T: Copy>(words: &[(&str, T)], word: &Value, name: &str) -> Result<T, String> {
    word.as_str().and_then(|word| value(words, word)).ok_or_else(|| missing(name))
}
