use super::stable_q::roots_of_q;
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Sphere};

/// The discriminant from the perpendicular: the vector from the centre to the nearest
/// point of the line is l = f − (d·f / d·d) d, and the line meets the sphere if
/// |l|² ≤ r² (Haines, Günther & Akenine-Möller, *Ray Tracing Gems*, 2019, chapter 7,
/// "Precision Improvements for Ray/Sphere Intersection").
///
/// The large parts cancel before anything is squared, so that l is off by a few roundings
/// of |f|, and r² − |l|² by those times r: good to distance/radius 1/u.
pub struct Haines;

impl<F: Real> Kernel<Sphere<F>, F> for Haines {
    const NAME: &'static str = "Haines et al.";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let f = ray.origin - sphere.center;
        let a = ray.direction.dot(ray.direction);
        let h = ray.direction.dot(f);
        let perpendicular = f - ray.direction * (h / a);
        let square = sphere.radius * sphere.radius;
        let within = square - perpendicular.dot(perpendicular);
        if within < F::ZERO {
            return None;
        }
        roots_of_q(min_t, a, h, f.dot(f) - square, a * within)
    }
}
