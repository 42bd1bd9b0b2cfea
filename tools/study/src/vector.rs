//! A vector of three numbers. Operations have the same order as glam's `DVec3`, so results are
//! the same bit for bit. glam itself has no vector that is generic over the type of numbers.

use std::ops::{Add, Mul, Sub};

use crate::number::{Real, exponent};

/// What can be added, subtracted and multiplied: a number, or several in SIMD lanes.
pub trait Ring: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}

impl<F: Clone + Add<Output = F> + Sub<Output = F> + Mul<Output = F>> Ring for F {}

/// A point or a direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector<F> {
    /// The first component.
    pub x: F,
    /// The second component.
    pub y: F,
    /// The third component.
    pub z: F,
}

impl<F: Ring> Vector<F> {
    /// A vector from its components.
    #[inline(always)]
    pub fn new(x: F, y: F, z: F) -> Vector<F> {
        Vector { x, y, z }
    }

    /// Applies a function to each component.
    #[inline(always)]
    pub fn map<G>(self, function: impl Fn(F) -> G) -> Vector<G> {
        Vector {
            x: function(self.x),
            y: function(self.y),
            z: function(self.z),
        }
    }

    /// Applies a function to pairs of components.
    #[inline(always)]
    pub fn zip<G, H>(self, other: Vector<G>, function: impl Fn(F, G) -> H) -> Vector<H> {
        Vector {
            x: function(self.x, other.x),
            y: function(self.y, other.y),
            z: function(self.z, other.z),
        }
    }

    /// The three components as an array.
    #[inline(always)]
    pub fn array(self) -> [F; 3] {
        [self.x, self.y, self.z]
    }

    /// The dot product.
    #[inline(always)]
    pub fn dot(self, other: Vector<F>) -> F {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The dot product with itself.
    #[inline(always)]
    pub fn squared(self) -> F {
        self.clone().dot(self)
    }

    /// The cross product.
    #[inline(always)]
    pub fn cross(self, other: Vector<F>) -> Vector<F> {
        Vector {
            x: self.y.clone() * other.z.clone() - other.y.clone() * self.z.clone(),
            y: self.z * other.x.clone() - other.z * self.x.clone(),
            z: self.x * other.y - other.x * self.y,
        }
    }
}

impl<F: Real> Vector<F> {
    /// The unit vector along it. It is scaled near 1 before it is squared, because the normal
    /// of a small triangle may be as short as 1e-160.
    #[inline(always)]
    pub fn unit(self) -> Vector<F> {
        let power = -exponent(self.largest().wide());
        let near_one = self.map(|x| x.times_power_of_two(power));
        near_one * (F::one() / near_one.dot(near_one).sqrt())
    }

    /// Whether no component is infinite or NaN.
    #[inline(always)]
    pub fn is_finite(self) -> bool {
        self.array().into_iter().all(F::is_finite)
    }

    /// The magnitude of its largest component. It may overlook a NaN in the first two:
    /// noticing it would make exact kernels 2 to 10 % longer. Ask
    /// [`is_finite`](Self::is_finite) where it matters.
    #[inline(always)]
    pub fn largest(self) -> F {
        let larger = |p, q| if p > q { p } else { q };
        larger(larger(self.x.abs(), self.y.abs()), self.z.abs())
    }
}

impl<F: Ring> Add for Vector<F> {
    type Output = Vector<F>;
    #[inline(always)]
    fn add(self, other: Vector<F>) -> Vector<F> {
        self.zip(other, F::add)
    }
}

impl<F: Ring> Sub for Vector<F> {
    type Output = Vector<F>;
    #[inline(always)]
    fn sub(self, other: Vector<F>) -> Vector<F> {
        self.zip(other, F::sub)
    }
}

impl<F: Ring> Mul<F> for Vector<F> {
    type Output = Vector<F>;
    #[inline(always)]
    fn mul(self, factor: F) -> Vector<F> {
        // The last product takes the factor itself, because copying an exact number is slow.
        Vector::new(
            self.x * factor.clone(),
            self.y * factor.clone(),
            self.z * factor,
        )
    }
}

impl From<Vector<f64>> for glam::DVec3 {
    fn from(vector: Vector<f64>) -> glam::DVec3 {
        vector.array().into()
    }
}

/// The bounding box of boxes, each given by two opposite corners; `None` if there are none.
pub fn around(boxes: impl IntoIterator<Item = [Vector<f64>; 2]>) -> Option<[Vector<f64>; 2]> {
    let wider = |[low, high]: [Vector<f64>; 2], [l, h]: [_; 2]| {
        [low.zip(l, f64::min), high.zip(h, f64::max)]
    };
    boxes.into_iter().reduce(wider)
}
