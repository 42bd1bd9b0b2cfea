use std::ops::Sub;

use super::Dyadic;
use crate::number::Real;
use crate::vector::Vector;

/// A vector of such numbers.
#[derive(Clone, Debug)]
pub struct DyadicVector(pub [Dyadic; 3]);

impl DyadicVector {
    /// A vector of finite numbers, exactly.
    pub fn of(vector: Vector<impl Real>) -> DyadicVector {
        DyadicVector(vector.array().map(Dyadic::of))
    }

    /// The dot product.
    pub fn dot(&self, other: &DyadicVector) -> Dyadic {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        &(&(a * x) + &(b * y)) + &(c * z)
    }

    /// The cross product.
    pub fn cross(&self, other: &DyadicVector) -> DyadicVector {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        let minor = |p: &Dyadic, q: &Dyadic, r: &Dyadic, s: &Dyadic| &(p * q) - &(r * s);
        DyadicVector([minor(b, z, c, y), minor(c, x, a, z), minor(a, y, b, x)])
    }
}

impl Sub for &DyadicVector {
    type Output = DyadicVector;
    fn sub(self, other: &DyadicVector) -> DyadicVector {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        DyadicVector([a - x, b - y, c - z])
    }
}
