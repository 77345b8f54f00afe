//! The mended outline, with what its points and segments carry.

use super::draft::Draft;
use crate::Pslg;
use crate::formats::{Attribute, Membership, Source};
use crate::vector::Vector;

/// The draft as an outline. What was there keeps its order and its numbers: pieces those of their
/// segments, new points the next ones from `first_new` on.
pub fn outline(draft: &Draft, first_new: i64) -> Pslg {
    let given = draft.outline;
    let degrees = draft.degrees();
    let (old, new): (Vec<u32>, Vec<u32>) = (0..draft.points.len() as u32)
        .filter(|&point| {
            let is_new = point as usize >= given.points.len();
            draft.is_kept[point as usize] && !(is_new && degrees[point as usize] == 0)
        })
        .partition(|&point| (point as usize) < given.points.len());
    let mut index = vec![u32::MAX; draft.points.len()];
    for (number, &point) in (0..).zip(old.iter().chain(&new)) {
        index[point as usize] = number;
    }
    let made = NewPoints { draft, points: &new };
    let pieces = || draft.strands.iter().map(|strand| strand.input as usize);

    Pslg {
        points: old.iter().map(|&p| given.points[p as usize]).chain(made.places()).collect(),
        point_markers: selected(&given.point_markers, &old, made.markers()),
        point_attributes: given
            .point_attributes
            .iter()
            .map(|Attribute { name, values }| Attribute {
                name: name.clone(),
                values: selected(values, &old, made.along_segments(values)),
            })
            .collect(),
        point_sizes: selected(&given.point_sizes, &old, made.along_segments(&given.point_sizes)),
        segments: draft.strands.iter().map(|s| s.ends.map(|end| index[end as usize])).collect(),
        segment_tags: pieces().map(|s| given.segment_tags.get(s).copied().unwrap_or(0)).collect(),
        enclosed: given.enclosed,
        holes: given.holes.clone(),
        regions: given.regions.clone(),
        local_areas: given.local_areas.clone(),
        groups: given.groups.clone(),
        memberships: memberships(draft, &index),
        source: Source {
            point_lines: selected(&given.source.point_lines, &old, std::iter::empty()),
            segment_lines: pieces()
                .filter_map(|s| given.source.segment_lines.get(s).copied())
                .collect(),
            point_numbers: old
                .iter()
                .map(|&p| given.source.point_number(p))
                .chain(new.iter().map(|&p| first_new + i64::from(p) - given.points.len() as i64))
                .collect(),
            segment_numbers: pieces().map(|s| given.source.segment_number(s as u32)).collect(),
            ..given.source.clone()
        },
    }
}

/// The memberships of what is left: of points that are kept, of all pieces of segments.
///
/// `index` gives the new index of each point, `u32::MAX` for one that is gone.
fn memberships(draft: &Draft, index: &[u32]) -> Vec<Membership> {
    let given = &draft.outline.memberships;
    let mut found = Vec::new();
    for &membership in given {
        let Membership { dim, item, .. } = membership;
        let mut keep = |item: u32| found.push(Membership { item, ..membership });
        if dim == 0 {
            if let Some(&new) = index.get(item as usize).filter(|&&new| new != u32::MAX) {
                keep(new);
            }
            continue;
        }
        for (piece, _) in (0..).zip(&draft.strands).filter(|(_, strand)| strand.input == item) {
            keep(piece);
        }
    }
    found
}

/// The values of the old points, then those of the new ones; none where there were none.
fn selected<T: Copy>(values: &[T], old: &[u32], new: impl Iterator<Item = T>) -> Vec<T> {
    if values.is_empty() {
        return Vec::new();
    }
    old.iter().map(|&point| values[point as usize]).chain(new).collect()
}

/// Points that were made, each on a segment of the outline.
struct NewPoints<'a> {
    draft: &'a Draft<'a>,
    points: &'a [u32],
}

impl<'a> NewPoints<'a> {
    /// In the outline's units.
    fn places(&self) -> impl Iterator<Item = [f64; 2]> {
        self.points.iter().map(|&point| self.draft.place(point).map(|c| self.draft.unscaled(c)))
    }

    /// A split point inherits the tag of its segment as its marker.
    fn markers(&self) -> impl Iterator<Item = i32> {
        let tags = &self.draft.outline.segment_tags;
        self.points.iter().map(|&p| tags.get(self.segment(p)).copied().unwrap_or(0))
    }

    /// Values that are linear along segments; infinite where that of an end is.
    fn along_segments(&self, values: &'a [f64]) -> impl Iterator<Item = f64> {
        self.points.iter().map(move |&point| {
            let ends = self.draft.outline.segments[self.segment(point)];
            let [a, b] = ends.map(|end| values[end as usize]);
            let part = self.part(point, ends);
            if a.is_finite() && b.is_finite() { (1.0 - part) * a + part * b } else { a.max(b) }
        })
    }

    /// How far along its segment a point is, from 0 to 1.
    fn part(&self, point: u32, ends: [u32; 2]) -> f64 {
        let [a, b] = ends.map(|end| self.draft.place(end));
        let along = Vector::between(a, b);
        (along.dot(Vector::between(a, self.draft.place(point))) / along.dot(along)).clamp(0.0, 1.0)
    }

    /// The input segment that a point was made on.
    fn segment(&self, point: u32) -> usize {
        self.draft.made_on[point as usize - self.draft.outline.points.len()] as usize
    }
}
