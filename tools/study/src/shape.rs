//! The harness's ray and shapes, generic over the type of numbers.

use crate::number::{Real, exponent};
use crate::vector::Vector;

/// p(t) = origin + t direction; the direction need not be unit length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<F> {
    /// The point at t = 0.
    pub origin: Vector<F>,
    /// The vector from t = 0 to t = 1.
    pub direction: Vector<F>,
}

/// All points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<F> {
    /// The centre.
    pub center: Vector<F>,
    /// The radius; positive.
    pub radius: F,
}

/// All points p with (p − `point`) · `normal` = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<F> {
    /// Any point of the plane.
    pub point: Vector<F>,
    /// A normal; it need not be unit length.
    pub normal: Vector<F>,
}

/// A flat triangle, edges included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<F> {
    /// Its corners a, b, c.
    pub corners: [Vector<F>; 3],
}

impl<F: Real> Triangle<F> {
    /// A vector along its normal. Both edges are first scaled near 1 by powers of two, because
    /// the area of a triangle with edges of 1e-160 underflows in `f64`.
    pub fn outward_near_one(&self) -> Vector<F> {
        let [a, b, c] = self.corners;
        let near_one = |edge: Vector<F>| {
            let power = -exponent(edge.largest().wide());
            edge.map(|x| x.times_power_of_two(power))
        };
        near_one(b - a).cross(near_one(c - a))
    }
}

/// A shape that questions can be asked about, with everything that the study needs to round,
/// scale and corrupt a question.
pub trait Shape: Copy + Send + Sync + 'static {
    /// The type of its numbers.
    type Number: Real;
    /// Its name in tables.
    const NAME: &'static str;
    /// The same shape with other numbers.
    type With<G: Real>: Shape<Number = G>;
    /// Applies one function to all lengths, and another to numbers that are not lengths (a plane's
    /// normal).
    fn map<G: Real>(
        &self,
        length: impl Fn(Self::Number) -> G,
        free: impl Fn(Self::Number) -> G,
    ) -> Self::With<G>;
}

impl<F: Real> Shape for Sphere<F> {
    type Number = F;
    const NAME: &'static str = "sphere";
    type With<G: Real> = Sphere<G>;
    #[inline(always)]
    fn map<G: Real>(&self, length: impl Fn(F) -> G, _: impl Fn(F) -> G) -> Sphere<G> {
        Sphere {
            center: self.center.map(&length),
            radius: length(self.radius),
        }
    }
}

impl<F: Real> Shape for Plane<F> {
    type Number = F;
    const NAME: &'static str = "plane";
    type With<G: Real> = Plane<G>;
    #[inline(always)]
    fn map<G: Real>(&self, length: impl Fn(F) -> G, free: impl Fn(F) -> G) -> Plane<G> {
        Plane {
            point: self.point.map(length),
            normal: self.normal.map(free),
        }
    }
}

impl<F: Real> Shape for Triangle<F> {
    type Number = F;
    const NAME: &'static str = "triangle";
    type With<G: Real> = Triangle<G>;
    #[inline(always)]
    fn map<G: Real>(&self, length: impl Fn(F) -> G, _: impl Fn(F) -> G) -> Triangle<G> {
        Triangle {
            corners: self.corners.map(|corner| corner.map(&length)),
        }
    }
}

impl<F: Real> Ray<F> {
    /// Whether all its numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.origin.is_finite() && self.direction.is_finite()
    }

    /// Applies one function to the origin and another to the direction.
    #[inline(always)]
    pub fn map<G: Real>(&self, length: impl Fn(F) -> G, direction: impl Fn(F) -> G) -> Ray<G> {
        Ray {
            origin: self.origin.map(length),
            direction: self.direction.map(direction),
        }
    }
}
