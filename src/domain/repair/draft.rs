//! The outline while it is being mended.

use super::super::adjoining::adjoining;
use super::super::error::{Error, Warning};
use super::super::sweep::{Linework, sweep};
use super::super::{lexicographic_order, merge, range};
use super::report::Repair;
use crate::Pslg;

/// A segment of the draft.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Strand {
    /// Its ends.
    pub ends: [u32; 2],
    /// The input segment that it is a piece of.
    pub input: u32,
}

/// The outline while it is being mended. Points are known by their input index; new ones follow
/// after those, in the order in which they are made.
#[derive(Debug)]
pub struct Draft<'a> {
    /// The outline as it is given.
    pub outline: &'a Pslg,
    /// Input coordinates are 2^this times those of the draft.
    pub scale_exponent: i32,
    /// All points, scaled; also those that were merged into others.
    pub points: Vec<[f64; 2]>,
    /// Whether each point was not merged into another one.
    pub is_kept: Vec<bool>,
    /// For each new point an input segment that it lies on.
    pub made_on: Vec<u32>,
    /// The segments: distinct, none of length zero.
    pub strands: Vec<Strand>,
    /// What was mended so far; overlaps apart.
    pub repairs: Vec<Repair>,
    /// Pairs of input segments with a common stretch, the one that keeps it first.
    pub overlaps: Vec<[u32; 2]>,
}

impl<'a> Draft<'a> {
    /// The outline with its duplicates merged.
    ///
    /// # Errors
    /// Coordinates for which predicates are not exact.
    pub fn new(outline: &'a Pslg, warnings: &mut Vec<Warning>) -> Result<Self, Error> {
        let scale_exponent = range::scale_exponent(outline)?;
        let scaled = |&place: &[f64; 2]| range::scaled(place, scale_exponent);
        let points: Vec<[f64; 2]> = outline.points.iter().map(scaled).collect();
        let merged = merge::points(outline, points.clone(), warnings);
        let segments = merge::segments(outline, &merged.distinct, warnings);
        let mut is_kept = vec![false; points.len()];
        merged.input.iter().for_each(|&point| is_kept[point as usize] = true);
        let strands = segments.segments.iter().zip(&segments.input).map(|(&ends, &input)| Strand {
            ends: ends.map(|end| merged.input[end as usize]),
            input,
        });
        Ok(Self {
            outline,
            scale_exponent,
            is_kept,
            made_on: Vec::new(),
            strands: strands.collect(),
            repairs: Vec::new(),
            overlaps: Vec::new(),
            points,
        })
    }

    /// Where a point is, scaled.
    pub fn place(&self, point: u32) -> [f64; 2] {
        self.points[point as usize]
    }

    /// A new point on an input segment.
    pub fn make_point(&mut self, place: [f64; 2], on: u32) -> u32 {
        self.points.push(place);
        self.is_kept.push(true);
        self.made_on.push(on);
        self.points.len() as u32 - 1
    }

    /// A length in the units of the outline.
    pub fn unscaled(&self, length: f64) -> f64 {
        libm::scalbn(length, self.scale_exponent)
    }

    /// A place, rounded so that the outline's own coordinates hold it.
    pub fn representable(&self, place: [f64; 2]) -> [f64; 2] {
        // What is too small for exact arithmetic is zero beside the largest coordinate.
        let kept = place.map(|c| if range::is_too_small(c, 0) { 0.0 } else { c });
        range::scaled(kept.map(|c| self.unscaled(c)), self.scale_exponent)
    }

    /// The number of segments that end at each point.
    pub fn degrees(&self) -> Vec<u32> {
        let mut degrees = vec![0; self.points.len()];
        self.strands.iter().flat_map(|s| s.ends).for_each(|end| degrees[end as usize] += 1);
        degrees
    }

    /// Replaces the segments: drops those of length zero and all but the first of those with the
    /// same ends.
    pub fn set_strands(&mut self, strands: Vec<Strand>) {
        let undirected = |&Strand { ends: [a, b], .. }: &Strand| [a.min(b), a.max(b)];
        let mut order: Vec<([u32; 2], u32)> = strands.iter().map(undirected).zip(0..).collect();
        order.sort_unstable();
        let mut is_first = vec![true; strands.len()];
        for same in order.chunk_by(|(ends, _), (others, _)| ends == others) {
            let first = strands[same[0].1 as usize].input;
            for &(_, again) in &same[1..] {
                is_first[again as usize] = false;
                let input = strands[again as usize].input;
                if input != first {
                    self.overlaps.push([first, input]);
                }
            }
        }
        let kept = strands.iter().zip(is_first).filter(|(strand, is_first)| {
            let [a, b] = strand.ends;
            *is_first && a != b
        });
        self.strands = kept.map(|(&strand, _)| strand).collect();
    }

    /// Whether nothing was merged or split.
    pub fn is_as_given(&self) -> bool {
        let is_same = |(strand, ends): (&Strand, &[u32; 2])| strand.ends == *ends;
        self.is_kept.iter().take(self.outline.points.len()).all(|&is_kept| is_kept)
            && self.strands.len() == self.outline.segments.len()
            && self.strands.iter().zip(&self.outline.segments).all(is_same)
    }

    /// Whether Assumption 1 (ii) and (iii) hold.
    pub fn is_clean(&self) -> bool {
        let mut compact = vec![u32::MAX; self.points.len()];
        let mut points = Vec::new();
        for (index, place) in self.points.iter().enumerate().filter(|&(i, _)| self.is_kept[i]) {
            compact[index] = points.len() as u32;
            points.push(*place);
        }
        let ends = |strand: &Strand| strand.ends.map(|end| compact[end as usize]);
        let segments: Vec<[u32; 2]> = self.strands.iter().map(ends).collect();
        let (adjoining_start, adjoining) = adjoining(&points, &segments);
        let linework = Linework {
            points: &points,
            segments: &segments,
            order: &lexicographic_order(&points),
            adjoining_start: &adjoining_start,
            adjoining: &adjoining,
        };
        sweep(&linework, &[]).is_ok()
    }
}
