use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Triangle};

/// Solves e + t d = a + u e₁ + v e₂ by Cramer's rule, with determinants as triple products and
/// each part computed only if it is still needed (Möller & Trumbore, "Fast, Minimum Storage
/// Ray/Triangle Intersection", *J. Graphics Tools* 2(1), 1997; the branch without culling). The
/// paper treats a determinant below an epsilon as parallel; here, only 0 is.
pub type MollerTrumbore = CramersRule<false>;

/// Möller–Trumbore that treats |determinant| < 1e-8 as parallel, as much public code does. It
/// is here to measure the damage: the determinant scales with the square of the triangle's size
/// and with the direction's length, so small triangles vanish.
pub type MollerTrumboreEpsilon = CramersRule<true>;

/// [`MollerTrumbore`] or [`MollerTrumboreEpsilon`].
pub struct CramersRule<const HAS_EPSILON: bool>;

impl<F: Real, const HAS_EPSILON: bool> Kernel<Triangle<F>, F> for CramersRule<HAS_EPSILON> {
    const NAME: &'static str = match HAS_EPSILON {
        true => "M–T with epsilon",
        false => "Möller–Trumbore",
    };
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
        let is_parallel = match HAS_EPSILON {
            true => determinant.abs() < F::of(1e-8),
            false => determinant == F::zero(),
        };
        if is_parallel {
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
