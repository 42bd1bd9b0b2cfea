use super::half_b::coefficients;
use super::stable_q::roots_of_q;
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Sphere};

/// Stable-q, with the discriminant as a difference of two products by fused
/// multiply-adds: an algorithm of Kahan's (*On the Cost of Floating-Point Computation
/// Without Extra-Precise Arithmetic*, 2004; analysed by Jeannerod, Louvet & Muller,
/// *Math. Comp.* 82, 2013).
///
/// The subtraction is then all but exact, and it does not help: a, h and c were rounded
/// before, and what they lost is what the subtraction brings to light.
pub struct Fma;

impl<F: Real> Kernel<Sphere<F>, F> for Fma {
    const NAME: &'static str = "fma discriminant";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let [a, h, c] = coefficients(sphere, ray);
        let product = a * c;
        let lost = (-a).mul_add(c, product);
        let discriminant = h.mul_add(h, -product) + lost;
        if discriminant < F::ZERO {
            return None;
        }
        roots_of_q(min_t, a, h, c, discriminant)
    }
}
