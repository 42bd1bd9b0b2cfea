use super::first_from;
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Sphere};

/// The quadratic formula with h = b / 2, so that the factors 2 and 4 cancel; what the
/// assignment's reference does. Digits are lost exactly as in the textbook's form:
/// multiplying by 2 never rounds.
pub struct HalfB;

impl<F: Real> Kernel<Sphere<F>, F> for HalfB {
    const NAME: &'static str = "half-b";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let [a, h, c] = coefficients(sphere, ray);
        let discriminant = h * h - a * c;
        if discriminant < F::ZERO {
            return None;
        }
        let root = discriminant.sqrt();
        first_from(min_t, (-h - root) / a, (-h + root) / a)
    }
}

/// The a, h and c of a t² + 2 h t + c = 0.
#[inline(always)]
pub fn coefficients<F: Real>(sphere: &Sphere<F>, ray: &Ray<F>) -> [F; 3] {
    let f = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let h = ray.direction.dot(f);
    let c = f.dot(f) - sphere.radius * sphere.radius;
    [a, h, c]
}
