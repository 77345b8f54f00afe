//! The vector between two points, without error, and its products: they keep their relative
//! accuracy where plain doubles cancel. (Plain doubles lose seven digits of the sine of an angle
//! of 1e-9 rad.) Rounded all the same: a sign is asked of [`predicates`](crate::predicates).

use crate::double_double::DoubleDouble;

/// The vector between two points, without error: `high + low`.
#[derive(Clone, Copy)]
pub(crate) struct Vector {
    high: [f64; 2],
    low: [f64; 2],
}

impl Vector {
    /// The vector from `a` to `b`.
    pub fn between(a: [f64; 2], b: [f64; 2]) -> Self {
        let (x, y) = (DoubleDouble::difference(b[0], a[0]), DoubleDouble::difference(b[1], a[1]));
        Self { high: [x.hi, y.hi], low: [x.lo, y.lo] }
    }

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
