use super::first_from;
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Sphere};

/// The quadratic formula as schools teach it (Marschner & Shirley, *Fundamentals of Computer
/// Graphics*, §4.4.1): a t² + b t + c = 0.
///
/// For a distant sphere, b² and 4 a c are huge and nearly equal. Their difference loses every
/// digit as distance/radius approaches 1/√u, about 1e8 in `f64` and 4e3 in `f32`.
pub struct Textbook;

impl<F: Real> Kernel<Sphere<F>, F> for Textbook {
    const NAME: &'static str = "textbook";
    type PreparedRay = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let (two, four) = (F::of(2.0), F::of(4.0));
        let f = ray.origin - sphere.center;
        let a = ray.direction.dot(ray.direction);
        let b = two * ray.direction.dot(f);
        let c = f.dot(f) - sphere.radius * sphere.radius;
        let discriminant = b * b - four * a * c;
        if discriminant < F::zero() {
            return None;
        }
        let root = discriminant.sqrt();
        first_from(min_t, (-b - root) / (two * a), (-b + root) / (two * a))
    }
}
