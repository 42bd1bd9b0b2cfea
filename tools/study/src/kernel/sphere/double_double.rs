use super::first_from;
use crate::double_double::{self, DoubleVector};
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Sphere};

/// Half-b in numbers of twice the digits: e − c is exact, and what is left of the
/// discriminant after its cancellation is still good to distance/radius 1/u. It costs
/// several times the plain formula, and its range is no larger.
pub struct DoubleDouble;

impl<F: Real> Kernel<Sphere<F>, F> for DoubleDouble {
    const NAME: &'static str = "double-double";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let f = DoubleVector::between(ray.origin, sphere.center);
        let d = DoubleVector::of(ray.direction);
        let (a, h) = (d.dot(d), d.dot(f));
        let square = double_double::DoubleDouble::product(sphere.radius, sphere.radius);
        let c = f.dot(f) - square;
        let discriminant = h * h - a * c;
        if discriminant.high < F::ZERO {
            return None;
        }
        let root = discriminant.sqrt();
        let (near, far) = match h.high < F::ZERO {
            true => (c / (root - h), (root - h) / a),
            false => ((-h - root) / a, c / (-h - root)),
        };
        first_from(min_t, near.high, far.high)
    }
}
