//! Whether surfaces cover the same place.

use super::contours::Polygon;
use super::seeds::Stretch;

/// Where on each stretch it is looked.
const FRACTIONS: [f64; 3] = [0.5, 0.25, 0.75];

/// A surface as its polygons, and stretches inside it.
pub(super) struct Area<'a> {
    pub polygons: Vec<&'a Polygon>,
    pub stretches: Vec<Stretch>,
}

impl Area<'_> {
    fn holds(&self, p: [f64; 2]) -> bool {
        self.polygons.iter().filter(|polygon| polygon.holds(p)).count() % 2 == 1
    }

    /// The smallest and the largest abscissa.
    fn width(&self) -> [f64; 2] {
        let least = self.polygons.iter().map(|polygon| polygon.least[0]);
        let most = self.polygons.iter().map(|polygon| polygon.most[0]);
        [least.fold(f64::INFINITY, f64::min), most.fold(f64::NEG_INFINITY, f64::max)]
    }
}

/// Two areas, as indices, and a place in both; the first found.
///
/// What is found is true. What is not found is seen as crossing segments, unless the two areas
/// share only slivers.
pub(super) fn overlap(areas: &[Area]) -> Option<([usize; 2], [f64; 2])> {
    let widths: Vec<[f64; 2]> = areas.iter().map(Area::width).collect();
    let low = widths.iter().map(|width| width[0]).fold(f64::INFINITY, f64::min);
    let high = widths.iter().map(|width| width[1]).fold(f64::NEG_INFINITY, f64::max);
    // In strips, so that not every pair is looked at.
    let count = areas.len().max(1);
    let strip = |x: f64| {
        let place = (x - low) / (high - low) * count as f64;
        (place.max(0.0) as usize).min(count - 1)
    };
    let mut strips = vec![Vec::new(); count];
    for (i, &[from, to]) in widths.iter().enumerate() {
        for members in &mut strips[strip(from)..=strip(to)] {
            members.push(i);
        }
    }
    for (i, area) in areas.iter().enumerate() {
        for stretch in &area.stretches {
            for p in FRACTIONS.map(|fraction| stretch.at(fraction)) {
                let mut others = strips[strip(p[0])].iter().filter(|&&j| j != i);
                if let Some(&j) = others.find(|&&j| areas[j].holds(p)) {
                    return Some(([i.min(j), i.max(j)], p));
                }
            }
        }
    }
    None
}
