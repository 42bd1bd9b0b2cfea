use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Plane, Ray};

/// The implicit form (Marschner & Shirley, §4.4.3), with the origin shifted to the plane's
/// point first, as in the assignment's reference: t = n·(p − e) / n·d. Far from the world's
/// origin, the expanded form n·p − n·e would subtract two large numbers. Subtracting nearby
/// points first has little or no rounding error (Sterbenz's lemma), and the products are then
/// as small as the scene.
pub struct ShiftedOrigin;

impl<F: Real> Kernel<Plane<F>, F> for ShiftedOrigin {
    const NAME: &'static str = "shifted origin";
    type PreparedRay = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(plane: &Plane<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let along_normal = plane.normal.dot(ray.direction);
        if along_normal == F::zero() {
            return None;
        }
        let t = plane.normal.dot(plane.point - ray.origin) / along_normal;
        (t >= min_t).then_some(t)
    }
}
