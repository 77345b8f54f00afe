//! Numbers of twice the precision of a double, for the few places where a rounded difference of
//! products would lose the answer (Dekker 1971; Ogita, Rump & Oishi 2005).

/// An unevaluated sum `hi + lo` with |lo| ≤ ½ ulp(hi): about 106 significant bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DoubleDouble {
    pub hi: f64,
    pub lo: f64,
}

impl DoubleDouble {
    /// `a − b`, exactly.
    pub fn difference(a: f64, b: f64) -> Self {
        two_sum(a, -b)
    }

    /// `a · b`, exactly.
    pub fn product(a: f64, b: f64) -> Self {
        let hi = a * b;
        Self { hi, lo: a.mul_add(b, -hi) }
    }

    pub fn plus(self, other: Self) -> Self {
        let sum = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let partial = fast_two_sum(sum.hi, sum.lo + low.hi);
        fast_two_sum(partial.hi, partial.lo + low.lo)
    }

    pub fn minus(self, other: Self) -> Self {
        self.plus(Self { hi: -other.hi, lo: -other.lo })
    }

    pub fn times(self, other: Self) -> Self {
        let product = Self::product(self.hi, other.hi);
        fast_two_sum(product.hi, product.lo + self.hi.mul_add(other.lo, self.lo * other.hi))
    }

    /// The quotient, by one step of Newton's iteration.
    pub fn over(self, divisor: Self) -> Self {
        let hi = self.hi / divisor.hi;
        let rest = self.minus(divisor.times(Self { hi, lo: 0.0 }));
        fast_two_sum(hi, rest.hi / divisor.hi)
    }

    /// The square root of a positive number, by one step of Newton's iteration.
    pub fn square_root(self) -> Self {
        let hi = self.hi.sqrt();
        if hi == 0.0 {
            return Self { hi, lo: 0.0 };
        }
        let rest = self.minus(Self::product(hi, hi));
        fast_two_sum(hi, rest.hi / (2.0 * hi))
    }
}

/// `a + b`, exactly.
pub(crate) fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let b_part = hi - a;
    let a_part = hi - b_part;
    DoubleDouble { hi, lo: (a - a_part) + (b - b_part) }
}

/// `a + b`, exactly, for |a| ≥ |b|.
fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// An exact sum of doubles as non-overlapping components of increasing magnitude
/// (Shewchuk 1997, *Grow-Expansion*).
#[derive(Default)]
pub(crate) struct Expansion {
    components: [f64; 16],
    length: usize,
}

impl Expansion {
    /// Adds the exact product of two sums: eight components.
    pub fn add_product(&mut self, u: DoubleDouble, v: DoubleDouble) {
        for (s, t) in [(u.hi, v.hi), (u.hi, v.lo), (u.lo, v.hi), (u.lo, v.lo)] {
            let product = DoubleDouble::product(s, t);
            self.add(product.lo);
            self.add(product.hi);
        }
    }

    fn add(&mut self, value: f64) {
        let mut rest = value;
        for component in &mut self.components[..self.length] {
            let sum = two_sum(rest, *component);
            *component = sum.lo;
            rest = sum.hi;
        }
        self.components[self.length] = rest;
        self.length += 1;
    }

    /// The largest component that is not zero: it has the sign of the whole sum.
    pub fn leading(&self) -> f64 {
        let components = &self.components[..self.length];
        components.iter().rev().copied().find(|&c| c != 0.0).unwrap_or(0.0)
    }

    /// The sum, rounded.
    pub fn value(&self) -> DoubleDouble {
        let zero = DoubleDouble { hi: 0.0, lo: 0.0 };
        let components = self.components[..self.length].iter();
        components.fold(zero, |sum, &c| sum.plus(DoubleDouble { hi: c, lo: 0.0 }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_keeps_what_a_double_drops() {
        let d = DoubleDouble::difference(1.0, 1e-30);
        assert_eq!((d.hi, d.lo), (1.0, -1e-30));
    }

    #[test]
    fn the_root_of_two_squares_back_to_thirty_digits() {
        let root = DoubleDouble { hi: 2.0, lo: 0.0 }.square_root();
        let rest = root.times(root).minus(DoubleDouble { hi: 2.0, lo: 0.0 });
        assert!(rest.hi.abs() < 1e-31, "{rest:?}");
    }

    #[test]
    fn a_third_times_three_is_one_to_thirty_digits() {
        let three = DoubleDouble { hi: 3.0, lo: 0.0 };
        let third = DoubleDouble { hi: 1.0, lo: 0.0 }.over(three);
        let rest = third.times(three).minus(DoubleDouble { hi: 1.0, lo: 0.0 });
        assert!(rest.hi.abs() < 1e-31, "{rest:?}");
    }
}
