//! Places over a trigger edge, close to where the rule of Steiner points begins to allow them.
//!
//! No vertex may be nearer to a Steiner point than √2 trigger edges, so the ends of the edge forbid
//! what lies below two arcs around them. It is just above these that points do the most: random
//! places anywhere in the circumdisc, twice as many, are worth a quarter less to thinning.

/// Where a point stands over the trigger edge: height over it and shift from its middle, in its
/// lengths.
pub(super) type Place = [f64; 2];

/// How far from the arcs places are spread, in lengths of the trigger edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spread {
    /// To each side of the middle.
    pub sideways: f64,
    /// Upwards from the arcs.
    pub upwards: f64,
}

impl Spread {
    /// The place that a point of the unit square stands for, where no vertex may be nearer than the
    /// root of `nearest`, in lengths of the edge. The farther up, the fewer places.
    pub fn place(self, [x, y]: [f64; 2], nearest: f64) -> Place {
        let shift = self.sideways * (2.0 * x - 1.0);
        let beside_end = shift.abs() - 0.5;
        let least = (nearest - beside_end * beside_end).max(0.0).sqrt();
        [least + self.upwards * y * y, shift]
    }

    /// So many places, evenly, from the middle outwards; no vertex may be nearer than √2 edges.
    pub fn evenly(self, count: u32) -> Vec<Place> {
        let mut places: Vec<_> = (0..count).map(|i| self.place(r2(i), 2.0)).collect();
        places.sort_by(|[_, a], [_, b]| a.abs().total_cmp(&b.abs()));
        places
    }
}

/// The R₂ sequence: points that fill the unit square evenly, however many there are (Roberts, *The
/// Unreasonable Effectiveness of Quasirandom Sequences*, 2018). Its steps are 1/g and 1/g², g³ = g + 1.
fn r2(i: u32) -> [f64; 2] {
    [0.754_877_666_246_692_7, 0.569_840_290_998_053_2]
        .map(|step| (0.5 + step * f64::from(i)).fract())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_place_is_nearer_to_an_end_than_the_rule_allows() {
        for [height, shift] in (Spread { sideways: 1.1, upwards: 0.7 }).evenly(46) {
            let to_end = height.hypot(shift.abs() - 0.5);
            assert!((2.0_f64.sqrt()..2.3).contains(&to_end), "{to_end}");
        }
    }

    #[test]
    fn the_places_fill_the_square_evenly() {
        let mut sixteenths = [0; 16];
        for i in 0..160 {
            let [column, row] = r2(i).map(|x| (4.0 * x) as usize);
            sixteenths[4 * row + column] += 1;
        }
        assert!(sixteenths.iter().all(|count| (7..=13).contains(count)), "{sixteenths:?}");
    }
}
