//! What §1 merges and drops without being asked: duplicate points, segments of length zero and
//! segments given twice.

use super::error::{Item, Kind, Warning};
use crate::Pslg;
use crate::columns::in_columns;
use crate::memory::give_back;
use crate::radix;

/// The distinct points of an outline.
pub struct Points {
    /// Their coordinates, in the order of the outline.
    pub points: Vec<[f64; 2]>,
    /// The input point that each of them is: the first of those that were merged.
    pub input: Vec<u32>,
    /// The distinct point that each input point became.
    pub distinct: Vec<u32>,
    /// The distinct points in the order of the plane sweep.
    pub order: Vec<u32>,
}

/// Merges points with equal coordinates (−0 equals 0).
pub fn points(pslg: &Pslg, scaled: Vec<[f64; 2]>, warnings: &mut Vec<Warning>) -> Points {
    let placed = in_columns(&scaled, 0..scaled.len() as u32);
    let duplicates = duplicates(&scaled, &placed);
    let order: Vec<u32> = placed.iter().map(|&placed| placed as u32).collect();
    give_back(placed);
    let all = 0..scaled.len() as u32;
    if duplicates.is_empty() {
        return Points {
            points: scaled,
            input: all.clone().collect(),
            distinct: all.collect(),
            order,
        };
    }

    let mut first: Vec<u32> = all.collect();
    duplicates.iter().for_each(|&[same, index]| first[index as usize] = same);
    let mut merged =
        Points { points: Vec::new(), input: Vec::new(), distinct: Vec::new(), order: Vec::new() };
    for (index, &same) in (0..).zip(&first) {
        if same == index {
            merged.distinct.push(merged.input.len() as u32);
            merged.input.push(index);
            merged.points.push(scaled[index as usize]);
        } else {
            merged.distinct.push(merged.distinct[same as usize]);
        }
    }
    let distinct = order.into_iter().filter(|&index| first[index as usize] == index);
    merged.order = distinct.map(|index| merged.distinct[index as usize]).collect();
    warnings.push(Warning::DuplicatePoints {
        count: duplicates.len(),
        first: pairs(pslg, Kind::Point, &duplicates),
    });
    merged
}

/// The points that are there already, each with the first that is like it, by their own numbers.
fn duplicates(points: &[[f64; 2]], placed: &[u64]) -> Vec<[u32; 2]> {
    let mut found: Vec<[u32; 2]> = Vec::new();
    for pair in placed.windows(2).filter(|pair| pair[0] >> 32 == pair[1] >> 32) {
        let [before, index] = [pair[0] as u32, pair[1] as u32];
        if points[before as usize] == points[index as usize] {
            let same = match found.last() {
                Some(&[same, last]) if last == before => same,
                _ => before,
            };
            found.push([same, index]);
        }
    }
    found.sort_unstable_by_key(|&[_, index]| index);
    found
}

/// The target size at each of `count` distinct points: the smallest of those that were merged.
pub fn sizes(pslg: &Pslg, distinct: &[u32], count: usize, scale_exponent: i32) -> Vec<f64> {
    if pslg.point_sizes.is_empty() {
        return Vec::new();
    }
    let mut sizes = vec![f64::INFINITY; count];
    for (&point, &size) in distinct.iter().zip(&pslg.point_sizes) {
        if size > 0.0 {
            let scaled = libm::scalbn(size, -scale_exponent);
            sizes[point as usize] = sizes[point as usize].min(scaled);
        }
    }
    sizes
}

/// The distinct segments of an outline.
pub struct Segments {
    /// Their ends as indices of distinct points, in the order of the outline.
    pub segments: Vec<[u32; 2]>,
    /// The input segment that each of them is: the first of those that were merged.
    pub input: Vec<u32>,
    /// Their tags.
    pub tags: Vec<i32>,
}

/// Drops segments of length zero, and all but the first of those that join the same two points.
pub fn segments(pslg: &Pslg, distinct: &[u32], warnings: &mut Vec<Warning>) -> Segments {
    let ends = |index: u32| {
        let [a, b] = pslg.segments[index as usize];
        [distinct[a as usize], distinct[b as usize]]
    };
    let undirected = |index: u32| {
        let [a, b] = ends(index);
        [a.min(b), a.max(b)]
    };
    let tag = |index: u32| pslg.segment_tags.get(index as usize).copied().unwrap_or(0);
    let first = firsts(pslg.segments.len() as u32, undirected);
    let room = pslg.segments.len();
    let mut kept = Segments {
        segments: Vec::with_capacity(room),
        input: Vec::with_capacity(room),
        tags: Vec::with_capacity(room),
    };
    let (mut zero, mut twice, mut other_tag) = (Vec::new(), Vec::new(), Vec::new());
    for (index, &same) in (0..).zip(&first) {
        let [a, b] = ends(index);
        if a == b {
            zero.push(index);
        } else if same != index {
            let list = if tag(same) == tag(index) { &mut twice } else { &mut other_tag };
            list.push([same, index]);
        } else {
            kept.segments.push([a, b]);
            kept.input.push(index);
            kept.tags.push(tag(index));
        }
    }
    if !zero.is_empty() {
        let first = zero.iter().take(3).map(|&i| Item::new(pslg, Kind::Segment, i)).collect();
        warnings.push(Warning::ZeroLength { count: zero.len(), first });
    }
    if !twice.is_empty() {
        let first = pairs(pslg, Kind::Segment, &twice);
        warnings.push(Warning::DuplicateSegments { count: twice.len(), first });
    }
    if !other_tag.is_empty() {
        let tags = other_tag.iter().take(3).map(|pair| pair.map(tag)).collect();
        let first = pairs(pslg, Kind::Segment, &other_tag);
        warnings.push(Warning::TagsDiffer { count: other_tag.len(), first, tags });
    }
    kept
}

/// For each of so many segments the first one with the same ends: mostly itself.
fn firsts(count: u32, ends: impl Fn(u32) -> [u32; 2]) -> Vec<u32> {
    let mut placed: Vec<u64> =
        (0..count).map(|index| u64::from(ends(index)[0]) << 32 | u64::from(index)).collect();
    radix::sort(&mut placed);
    let mut first: Vec<u32> = (0..count).collect();
    for at_end in placed.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|same| same.len() > 1) {
        at_end.sort_unstable_by_key(|&placed| (ends(placed as u32)[1], placed as u32));
        for pair in at_end.windows(2) {
            let [before, index] = [pair[0] as u32, pair[1] as u32];
            if ends(before) == ends(index) {
                first[index as usize] = first[before as usize];
            }
        }
    }
    give_back(placed);
    first
}

fn pairs(pslg: &Pslg, kind: Kind, pairs: &[[u32; 2]]) -> Vec<[Item; 2]> {
    pairs.iter().take(3).map(|pair| pair.map(|index| Item::new(pslg, kind, index))).collect()
}
