//! Rounded numbers that keep their relative accuracy where plain doubles cancel: differences of
//! coordinates without error, products by fused multiply-add. For numbers that are shown; what is
//! decided is asked in [`predicates`](crate::predicates).

/// The vector between two points, without error: `high + low`.
#[derive(Clone, Copy)]
pub struct Vector {
    high: [f64; 2],
    low: [f64; 2],
}

/// The vector from `a` to `b`.
pub fn vector(a: [f64; 2], b: [f64; 2]) -> Vector {
    let parts = [0, 1].map(|k| {
        // Knuth's two-sum of b and −a.
        let high = b[k] - a[k];
        let minus_a = high - b[k];
        let low = (b[k] - (high - minus_a)) + (-a[k] - minus_a);
        [high, low]
    });
    Vector { high: [parts[0][0], parts[1][0]], low: [parts[0][1], parts[1][1]] }
}

impl Vector {
    /// The length.
    pub fn length(self) -> f64 {
        libm::sqrt(self.dot(self))
    }

    /// The cross product: positive where `other` lies counter-clockwise of this vector.
    pub fn cross(self, other: Self) -> f64 {
        let (Self { high: [ax, ay], low: [al, am] }, Self { high: [bx, by], low: [bl, bm] }) =
            (self, other);
        difference_of_products(ax, by, ay, bx) + ((al * by + ax * bm) - (am * bx + ay * bl))
    }

    /// The dot product.
    pub fn dot(self, other: Self) -> f64 {
        let (Self { high: [ax, ay], low: [al, am] }, Self { high: [bx, by], low: [bl, bm] }) =
            (self, other);
        difference_of_products(ax, bx, -ay, by) + ((al * bx + ax * bl) + (am * by + ay * bm))
    }
}

/// a·b − c·d within 1.5 units in the last place (Kahan).
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    let error = (-c).mul_add(d, cd);
    a.mul_add(b, -cd) + error
}

/// A sum whose rounding errors are summed too (Neumaier).
pub fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let (sum, error) = terms.fold((0.0_f64, 0.0), |(sum, error), term| {
        let next = sum + term;
        let (larger, smaller) = if sum.abs() >= term.abs() { (sum, term) } else { (term, sum) };
        (next, error + ((larger - next) + smaller))
    });
    sum + error
}
