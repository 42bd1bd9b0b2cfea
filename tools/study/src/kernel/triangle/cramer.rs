use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Triangle};

/// The lecture's 3 × 3 system by Cramer's rule, with the common subexpressions spelled
/// out (Marschner & Shirley, §4.4.2, "Ray-Triangle Intersection"):
/// β (a − b) + γ (a − c) + t d = a − e.
pub struct Cramer;

impl<F: Real> Kernel<Triangle<F>, F> for Cramer {
    const NAME: &'static str = "Cramer";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    #[allow(clippy::many_single_char_names)] // They are the book's.
    fn intersect(triangle: &Triangle<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let [corner_a, corner_b, corner_c] = triangle.corners;
        let [a, b, c] = (corner_a - corner_b).array();
        let [d, e, f] = (corner_a - corner_c).array();
        let [g, h, i] = ray.direction.array();
        let [j, k, l] = (corner_a - ray.origin).array();
        let (ei_hf, gf_di, dh_eg) = (e * i - h * f, g * f - d * i, d * h - e * g);
        let (ak_jb, jc_al, bl_kc) = (a * k - j * b, j * c - a * l, b * l - k * c);
        let m = a * ei_hf + b * gf_di + c * dh_eg;
        let t = -(f * ak_jb + e * jc_al + d * bl_kc) / m;
        if !(t >= min_t) {
            return None;
        }
        let gamma = (i * ak_jb + h * jc_al + g * bl_kc) / m;
        if gamma < F::ZERO || gamma > F::ONE {
            return None;
        }
        let beta = (j * ei_hf + k * gf_di + l * dh_eg) / m;
        if beta < F::ZERO || beta > F::ONE - gamma {
            return None;
        }
        Some(t)
    }
}
