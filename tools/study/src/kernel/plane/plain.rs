use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Plane, Ray};

/// The implicit form n·x = n·p (Marschner & Shirley, §4.4.3): t = (n·p − n·e) / n·d.
///
/// Far from the origin of the world n·p and n·e are large and nearly equal, and their
/// difference has lost its digits: a plane should not care where the world's origin is.
pub struct Plain;

impl<F: Real> Kernel<Plane<F>, F> for Plain {
    const NAME: &'static str = "plain";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(plane: &Plane<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let along_normal = plane.normal.dot(ray.direction);
        if along_normal == F::ZERO {
            return None;
        }
        let t = (plane.normal.dot(plane.point) - plane.normal.dot(ray.origin)) / along_normal;
        (t >= min_t).then_some(t)
    }
}
