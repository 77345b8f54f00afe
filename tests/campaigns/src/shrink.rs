//! Making a failing outline small.

use meshwright::Pslg;

/// The outline with as much left out as possible while it still fails: segments, then isolated
/// points, holes and regions, one at a time and over again until nothing more can go.
///
/// `fails` must be true of the outline itself; it is asked some hundred times.
#[must_use]
pub fn shrink(outline: &Pslg, fails: &dyn Fn(&Pslg) -> bool) -> Pslg {
    let mut smallest = outline.clone();
    loop {
        let before = size(&smallest);
        for remove in [segments, points, holes, regions] {
            smallest = without(smallest, remove, fails);
        }
        if size(&smallest) == before {
            return smallest;
        }
    }
}

fn size(outline: &Pslg) -> usize {
    outline.points.len() + outline.segments.len() + outline.holes.len() + outline.regions.len()
}

/// Takes the chunk of items from `from` on, `length` of them, out; `None` past the end.
type Remove = fn(&Pslg, usize, usize) -> Option<Pslg>;

/// Removes chunks of one kind of item: half of all at first, single ones at last.
fn without(mut smallest: Pslg, remove: Remove, fails: &dyn Fn(&Pslg) -> bool) -> Pslg {
    let mut length = smallest.points.len().max(smallest.segments.len()).max(1);
    loop {
        let mut from = 0;
        while let Some(smaller) = remove(&smallest, from, length) {
            if fails(&smaller) {
                smallest = smaller;
            } else {
                from += length;
            }
        }
        if length == 1 {
            return smallest;
        }
        length = length.div_ceil(2);
    }
}

fn segments(outline: &Pslg, from: usize, length: usize) -> Option<Pslg> {
    let range = chunk(outline.segments.len(), from, length)?;
    let mut smaller = outline.clone();
    smaller.segments.drain(range.clone());
    smaller.segment_tags.drain(range);
    Some(smaller)
}

/// Points that end no segment only: the others stay.
fn points(outline: &Pslg, from: usize, length: usize) -> Option<Pslg> {
    let range = chunk(outline.points.len(), from, length)?;
    let mut keep: Vec<bool> = (0..outline.points.len()).map(|i| !range.contains(&i)).collect();
    outline.segments.iter().flatten().for_each(|&v| keep[v as usize] = true);
    let mut number = 0;
    let numbers: Vec<u32> = keep
        .iter()
        .map(|&kept| {
            number += u32::from(kept);
            number.wrapping_sub(1)
        })
        .collect();
    let mut smaller = outline.clone();
    let mut kept = keep.iter();
    smaller.points.retain(|_| kept.next() == Some(&true));
    smaller.segments.iter_mut().flatten().for_each(|v| *v = numbers[*v as usize]);
    // Where every point of the chunk is needed nothing is gained: go on behind it.
    Some(smaller)
        .filter(|s| s.points.len() < outline.points.len())
        .or_else(|| points(outline, from + length, length))
}

fn holes(outline: &Pslg, from: usize, length: usize) -> Option<Pslg> {
    let range = chunk(outline.holes.len(), from, length)?;
    let mut smaller = outline.clone();
    smaller.holes.drain(range);
    Some(smaller)
}

fn regions(outline: &Pslg, from: usize, length: usize) -> Option<Pslg> {
    let range = chunk(outline.regions.len(), from, length)?;
    let mut smaller = outline.clone();
    smaller.regions.drain(range);
    Some(smaller)
}

fn chunk(count: usize, from: usize, length: usize) -> Option<std::ops::Range<usize>> {
    (from < count).then(|| from..count.min(from + length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::families::Family;

    #[test]
    fn what_fails_alone_is_left_alone() {
        let outline = Family::RandomPslg.outline(20, 0.1, 1);
        let culprit = outline.points[outline.segments[7][0] as usize];
        let fails = |o: &Pslg| o.segments.iter().any(|s| o.points[s[0] as usize] == culprit);
        let smallest = shrink(&outline, &fails);
        assert_eq!((smallest.points.len(), smallest.segments.len()), (2, 1));
        assert!(fails(&smallest));
    }
}
