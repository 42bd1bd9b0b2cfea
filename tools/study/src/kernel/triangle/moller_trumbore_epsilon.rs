use crate::kernel::Kernel;
use crate::kernel::triangle::MollerTrumbore;
use crate::number::Real;
use crate::shape::{Ray, Triangle};

/// Möller–Trumbore with |determinant| < 1e-8 called parallel, as in much public code. It
/// is here to be measured: the determinant goes with the square of the triangle's size
/// and with the direction's length, so that small triangles vanish.
pub struct MollerTrumboreEpsilon;

impl<F: Real> Kernel<Triangle<F>, F> for MollerTrumboreEpsilon {
    const NAME: &'static str = "M–T with epsilon";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let [a, b, c] = triangle.corners;
        let determinant = (b - a).dot(ray.direction.cross(c - a));
        if determinant.abs() < F::of(1e-8) {
            return None;
        }
        MollerTrumbore::intersect(triangle, ray, min_t)
    }
}
