use crate::kernel::Kernel;
use crate::kernel::plane::Shifted;
use crate::number::Real;
use crate::shape::{Plane, Ray};

/// Shifted, with |n·d| < 1e-6 called parallel, as much public code does. It is here to
/// be measured: what is small depends on the lengths of n and d, and a ray that is
/// nearly parallel still meets the plane.
pub struct EpsilonCut;

impl<F: Real> Kernel<Plane<F>, F> for EpsilonCut {
    const NAME: &'static str = "epsilon cut";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(plane: &Plane<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        if plane.normal.dot(ray.direction).abs() < F::of(1e-6) {
            return None;
        }
        Shifted::intersect(plane, ray, min_t)
    }
}
