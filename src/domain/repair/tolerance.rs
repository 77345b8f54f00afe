//! What the user's tolerance joins: points near each other, and points near segments.

use std::ops::ControlFlow;

use super::super::precision;
use super::draft::{Draft, Strand};
use super::grid::Grid;
use super::report::Repair;
use crate::boxes::{Boxes, Rectangle};
use crate::predicates::{Relative, Side, encroaches, side};
use crate::vector::Vector;

/// Merges points that are at most `tolerance` (scaled) apart, and leads segments through points
/// that are as near to them. Returns whether anything changed.
pub fn join(draft: &mut Draft, tolerance: f64) -> bool {
    let merged = merge_points(draft, tolerance);
    let led = lead_through(draft, tolerance);
    merged || led
}

/// Merges each point into the nearest one before it that stays, if that is near enough. Points
/// that stay are farther apart than the tolerance, so a fine line of points does not collapse.
fn merge_points(draft: &mut Draft, tolerance: f64) -> bool {
    let ulp = precision::ulp(&draft.points, &draft.is_kept);
    let mut staying = Grid::new(tolerance.max(ulp));
    let degrees = draft.degrees();
    let mut merged_into: Vec<u32> = (0..draft.points.len() as u32).collect();
    let mut repairs = Vec::new();
    for point in 0..draft.points.len() as u32 {
        if !draft.is_kept[point as usize] {
            continue;
        }
        let place = draft.place(point);
        let distance = |other: u32| Vector::between(place, draft.place(other)).length();
        let near = staying.near(place).map(|other| (distance(other), other));
        let nearest = near.min_by(|(d, p), (e, q)| d.total_cmp(e).then(p.cmp(q)));
        match nearest.filter(|&(distance, _)| distance <= tolerance) {
            None => staying.add(point, place),
            Some((distance, other)) => {
                merged_into[point as usize] = other;
                let (points, distance) = ([other, point], draft.unscaled(distance));
                let is_gap = points.iter().all(|&point| degrees[point as usize] == 1);
                repairs.push(if is_gap {
                    Repair::Gap { points, distance }
                } else {
                    Repair::NearPoints { points, distance }
                });
            }
        }
    }
    if repairs.is_empty() {
        return false;
    }
    for (point, &into) in (0..).zip(&merged_into) {
        draft.is_kept[point as usize] &= into == point;
    }
    let strands = draft
        .strands
        .iter()
        .map(|strand| Strand { ends: strand.ends.map(|end| merged_into[end as usize]), ..*strand });
    let strands: Vec<Strand> = strands.collect();
    let lost = strands.iter().filter(|strand| strand.ends[0] == strand.ends[1]);
    repairs.extend(lost.map(|strand| Repair::ShortSegment { segment: strand.input }));
    draft.repairs.append(&mut repairs);
    draft.set_strands(strands);
    true
}

/// Leads each segment through the points near it, the nearest one first.
///
/// Only points in its diametral disc count: the parts are shorter then, so this ends.
fn lead_through(draft: &mut Draft, tolerance: f64) -> bool {
    let kept: Vec<u32> =
        (0..draft.points.len() as u32).filter(|&point| draft.is_kept[point as usize]).collect();
    let at = |&point: &u32| Rectangle::around(draft.place(point), draft.place(point));
    let boxes = Boxes::new(&kept.iter().map(at).collect::<Vec<_>>());
    let mut strands = Vec::with_capacity(draft.strands.len());
    let mut repairs = Vec::new();
    for &strand in &draft.strands {
        let mut pending = vec![strand];
        while let Some(strand) = pending.pop() {
            let Some((distance, point)) = nearest(draft, &kept, &boxes, strand, tolerance) else {
                strands.push(strand);
                continue;
            };
            let ([a, b], input) = (strand.ends, strand.input);
            pending.extend([[point, b], [a, point]].map(|ends| Strand { ends, input }));
            let distance = draft.unscaled(distance);
            repairs.push(Repair::NearSegment { point, segment: input, distance });
        }
    }
    if repairs.is_empty() {
        return false;
    }
    draft.repairs.append(&mut repairs);
    draft.set_strands(strands);
    true
}

/// The nearest of the points in a segment's diametral disc that are within the tolerance of it,
/// but not on it: its distance and the point.
fn nearest(
    draft: &Draft,
    kept: &[u32],
    boxes: &Boxes,
    strand: Strand,
    tolerance: f64,
) -> Option<(f64, u32)> {
    let [a, b] = strand.ends.map(|end| draft.place(end));
    let along = Vector::between(a, b);
    let length = along.length();
    let mut nearest: Option<(f64, u32)> = None;
    let around = Rectangle::around(a, b);
    let nearby = Rectangle {
        low: around.low.map(|c| c - tolerance),
        high: around.high.map(|c| c + tolerance),
    };
    let search: ControlFlow<()> = boxes.overlapping(&nearby, |item| {
        let point = kept[item as usize];
        let place = draft.place(point);
        let distance = along.cross(Vector::between(a, place)).abs() / length;
        if distance <= tolerance
            && !strand.ends.contains(&point)
            && nearest.is_none_or(|least| (distance, point) < least)
            && encroaches([a, b].map(|end| Relative::of(end, place)), [a, b], place)
            && side(a, b, place) != Side::On
        {
            nearest = Some((distance, point));
        }
        ControlFlow::Continue(())
    });
    debug_assert!(search.is_continue());
    nearest
}
