use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Triangle};

/// Solves e + t d = a + u e₁ + v e₂ by Cramer's rule, with determinants as triple products and
/// each part computed only if it is still needed (Möller & Trumbore, "Fast, Minimum Storage
/// Ray/Triangle Intersection", *J. Graphics Tools* 2(1), 1997; the branch without culling). The
/// paper treats a determinant below an epsilon as parallel; here, only 0 is.
pub struct MollerTrumbore;

impl<F: Real> Kernel<Triangle<F>, F> for MollerTrumbore {
    const NAME: &'static str = "Möller–Trumbore";
    type PreparedRay = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let [a, b, c] = triangle.corners;
        let (e1, e2) = (b - a, c - a);
        let p = ray.direction.cross(e2);
        let determinant = e1.dot(p);
        if determinant == F::zero() {
            return None;
        }
        let inverse = F::one() / determinant;
        let s = ray.origin - a;
        let u = s.dot(p) * inverse;
        if u < F::zero() || u > F::one() {
            return None;
        }
        let q = s.cross(e1);
        let v = ray.direction.dot(q) * inverse;
        if v < F::zero() || u + v > F::one() {
            return None;
        }
        let t = e2.dot(q) * inverse;
        (t >= min_t).then_some(t)
    }
}

/// Möller–Trumbore that treats |determinant| < 1e-8 as parallel, as much public code does. It
/// is here to measure the damage: the determinant scales with the square of the triangle's size
/// and with the direction's length, so small triangles vanish.
pub struct MollerTrumboreEpsilon;

impl<F: Real> Kernel<Triangle<F>, F> for MollerTrumboreEpsilon {
    const NAME: &'static str = "M–T with epsilon";
    type PreparedRay = Ray<F>;

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
