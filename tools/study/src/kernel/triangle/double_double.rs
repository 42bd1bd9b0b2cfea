use crate::double_double::{self, DoubleVector};
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Triangle};

/// Möller–Trumbore in numbers of twice the digits, signs instead of divisions: edges are
/// exact, and a volume is wrong only where the exact one is below 1e-30 of its terms.
/// Still not watertight: neighbours round differently.
pub struct DoubleDouble;

impl<F: Real> Kernel<Triangle<F>, F> for DoubleDouble {
    const NAME: &'static str = "double-double";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let [a, b, c] = triangle.corners;
        let d = DoubleVector::of(ray.direction);
        let (e1, e2) = (DoubleVector::between(b, a), DoubleVector::between(c, a));
        let p = d.cross(e2);
        let determinant = e1.dot(p);
        if determinant.high == F::ZERO {
            return None;
        }
        let is_negative = determinant.high < F::ZERO;
        let upright = |x: double_double::DoubleDouble<F>| if is_negative { -x } else { x };
        let s = DoubleVector::between(ray.origin, a);
        let u = upright(s.dot(p));
        if u.high < F::ZERO {
            return None;
        }
        let q = s.cross(e1);
        let v = upright(d.dot(q));
        if v.high < F::ZERO || (upright(determinant) - u - v).high < F::ZERO {
            return None;
        }
        let t = (e2.dot(q) / determinant).high;
        (t >= min_t).then_some(t)
    }
}
