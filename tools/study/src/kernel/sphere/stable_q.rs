use super::first_from;
use super::half_b::coefficients;
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Sphere};

/// Half-b, with the roots c/q and q/a of q = −h − sign(h) √Δ (Press et al., *Numerical
/// Recipes*, 3rd ed., §5.6): q adds two numbers of one sign, so that neither root is
/// what a subtraction left over. The discriminant itself is no better than before.
pub struct StableQ;

impl<F: Real> Kernel<Sphere<F>, F> for StableQ {
    const NAME: &'static str = "stable-q";
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
        roots_of_q(min_t, a, h, c, discriminant)
    }
}

/// The first root of a t² + 2 h t + c from `min_t` on, given h² − a c.
#[inline(always)]
pub fn roots_of_q<F: Real>(min_t: F, a: F, h: F, c: F, discriminant: F) -> Option<F> {
    let root = discriminant.sqrt();
    match h < F::ZERO {
        true => first_from(min_t, c / (root - h), (root - h) / a),
        false => first_from(min_t, (-h - root) / a, c / (-h - root)),
    }
}
