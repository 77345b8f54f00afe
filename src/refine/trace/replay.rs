//! A refinement's triangulation, rebuilt from its events alone.

use std::collections::BTreeMap;

use super::{Event, Made, Start, Subsegment};
use crate::formats::Mesh;
use crate::refine::provenance::Kind;

/// The triangulation as it is after the events that were [`apply`](Replay::apply)ed.
#[derive(Debug, Clone, Default)]
pub struct Replay {
    points: BTreeMap<u32, ([f64; 2], Kind)>,
    /// The third vertex of the triangle to the left of each directed edge.
    apexes: BTreeMap<[u32; 2], u32>,
    /// The segment of each subsegment, by its ends (the smaller index first).
    subsegments: BTreeMap<[u32; 2], u32>,
}

/// An event that does not fit the triangulation: the trace is not whole, or not one run's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the events do not fit each other: this is no whole trace of one run")]
pub struct Damaged;

impl Replay {
    /// Makes the event happen. A rejection or a refusal changes nothing.
    ///
    /// # Errors
    /// [`Damaged`] where the event names what is not there.
    pub fn apply(&mut self, event: &Event) -> Result<(), Damaged> {
        match event {
            Event::Start(start) => self.start(start),
            Event::Commit { made, .. } => self.commit(made, Kind::Circumcenter),
            Event::Split { subsegment, kind, made, .. } => self.split(*subsegment, *kind, made),
            Event::Introduced(_)
            | Event::Rejected { .. }
            | Event::RefusedSplit { .. }
            | Event::RefusedPoint { .. } => Ok(()),
        }
    }

    /// The coordinates of a vertex.
    #[must_use]
    pub fn point(&self, vertex: u32) -> Option<[f64; 2]> {
        self.points.get(&vertex).map(|&(place, _)| place)
    }

    /// Whether this counter-clockwise triangle is there.
    #[must_use]
    pub fn has_triangle(&self, [a, b, c]: [u32; 3]) -> bool {
        self.apexes.get(&[a, b]) == Some(&c)
    }

    /// The triangulation as a mesh: points by their indices, triangles by theirs. At the end of a
    /// trace these are the points of the run's mesh, and its triangles in another order.
    #[must_use]
    pub fn mesh(&self) -> Mesh {
        let ranks: BTreeMap<u32, u32> =
            (0..).zip(self.points.keys()).map(|(i, &v)| (v, i)).collect();
        let rank = |v: u32| ranks[&v];
        // Each triangle once: from its smallest vertex.
        let triangles = self.apexes.iter().filter(|&(&[a, b], &c)| a < b && a < c);
        let triangles = triangles.map(|(&[a, b], &c)| [a, b, c].map(rank)).collect();
        Mesh {
            points: self.points.values().map(|&(place, _)| place).collect(),
            provenance: self.points.values().map(|&(_, kind)| kind).collect(),
            triangles,
            edges: self.subsegments.keys().map(|ends| ends.map(rank)).collect(),
            edge_segments: self.subsegments.values().copied().collect(),
            ..Mesh::default()
        }
    }

    fn start(&mut self, start: &Start) -> Result<(), Damaged> {
        if !self.points.is_empty() {
            return Err(Damaged);
        }
        self.points.extend(start.points.iter().map(|&(v, place)| (v, (place, Kind::Input))));
        for &corners in &start.triangles {
            self.add(corners)?;
        }
        for &Subsegment { ends, segment } in &start.subsegments {
            self.expect_edge(ends)?;
            self.subsegments.insert(sorted(ends), segment);
        }
        Ok(())
    }

    fn split(&mut self, piece: Subsegment, kind: Kind, made: &Made) -> Result<(), Damaged> {
        let segment = self.subsegments.remove(&sorted(piece.ends)).ok_or(Damaged)?;
        self.commit(made, kind)?;
        for end in piece.ends {
            self.expect_edge([end, made.vertex])?;
            self.subsegments.insert(sorted([end, made.vertex]), segment);
        }
        Ok(())
    }

    /// Puts the star of a new point in the place of what is there.
    fn commit(&mut self, made: &Made, kind: Kind) -> Result<(), Damaged> {
        let rim: Vec<[u32; 2]> = made.star.iter().map(|&[_, a, b]| [a, b]).collect();
        for &edge in &rim {
            self.remove_behind(edge, &rim);
        }
        if self.points.insert(made.vertex, (made.point, kind)).is_some() {
            return Err(Damaged);
        }
        made.star.iter().try_for_each(|&corners| self.add(corners))
    }

    /// Takes out every triangle that is reached from the left of `edge` without crossing the rim.
    fn remove_behind(&mut self, edge: [u32; 2], rim: &[[u32; 2]]) {
        let mut waiting = vec![edge];
        while let Some([a, b]) = waiting.pop() {
            let Some(c) = self.apexes.remove(&[a, b]) else { continue };
            for side in [[b, c], [c, a]] {
                self.apexes.remove(&side);
                if !rim.contains(&side) {
                    waiting.push([side[1], side[0]]);
                }
            }
        }
    }

    fn add(&mut self, [a, b, c]: [u32; 3]) -> Result<(), Damaged> {
        for (edge, apex) in [([a, b], c), ([b, c], a), ([c, a], b)] {
            if !self.points.contains_key(&apex) || self.apexes.insert(edge, apex).is_some() {
                return Err(Damaged);
            }
        }
        Ok(())
    }

    fn expect_edge(&self, [a, b]: [u32; 2]) -> Result<(), Damaged> {
        let there = self.apexes.contains_key(&[a, b]) || self.apexes.contains_key(&[b, a]);
        if there { Ok(()) } else { Err(Damaged) }
    }
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
