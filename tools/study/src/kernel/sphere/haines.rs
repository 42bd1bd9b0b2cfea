use super::first_from;
use crate::kernel::Kernel;
use crate::number::{Real, exponent};
use crate::shape::{Ray, Sphere};

/// The discriminant from the perpendicular: l = f − (d·f / d·d) d is the vector from the centre
/// to the nearest point of the line, and the line meets the sphere if |l|² ≤ r² (Haines,
/// Günther & Akenine-Möller, *Ray Tracing Gems*, 2019, chapter 7, "Precision Improvements for
/// Ray/Sphere Intersection"). The roots are c/q and q/a with q = −h − sign(h) √Δ (Press et al.,
/// *Numerical Recipes*, 3rd ed., §5.6), which adds two numbers of the same sign and cannot
/// cancel.
///
/// The large parts cancel before anything is squared. The error of l is a few roundings of |f|,
/// and that of r² − |l|² is about r times as large. The kernel therefore works up to a
/// distance/radius of about 1/u.
///
/// The direction is first scaled by a power of two, so that its largest component is in [1, 2).
/// This changes no digit, and d·d can then neither overflow nor vanish. Without scaling, a
/// direction of length 1e-162 or 1e154 has a square that is 0 or infinite. t and `min_t` are
/// multiples of the direction, so they are scaled with it.
pub struct Haines;

/// The same kernel without scaling, which is just as good for directions of ordinary length.
#[inline(always)]
pub fn plainly<F: Real>(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
    let f = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let h = ray.direction.dot(f);
    let perpendicular = f - ray.direction * (h / a);
    let square = sphere.radius * sphere.radius;
    let within = square - perpendicular.dot(perpendicular);
    if within < F::zero() {
        return None;
    }
    let (c, root) = (f.dot(f) - square, (a * within).sqrt());
    match h < F::zero() {
        true => first_from(min_t, c / (root - h), (root - h) / a),
        false => first_from(min_t, (-h - root) / a, c / (-h - root)),
    }
}

/// A ray with its direction scaled by 2^−`exponent`. A component that is more than 1e300 times
/// smaller than another may lose digits, which scaling back does not restore.
#[derive(Clone, Copy, Debug)]
pub struct ScaledRay<F> {
    /// The scaled ray, along the same line.
    pub ray: Ray<F>,
    /// A t of the scaled ray times 2^−`exponent` is a t of the given ray.
    pub exponent: i32,
}

impl<F: Real> ScaledRay<F> {
    /// Scales a ray so that its direction has a length of about 1.
    #[inline(always)]
    pub fn new(ray: &Ray<F>) -> ScaledRay<F> {
        let exponent = exponent(ray.direction.largest().wide());
        let direction = ray.direction.map(|d| d.times_power_of_two(-exponent));
        let ray = Ray { direction, ..*ray };
        ScaledRay { ray, exponent }
    }

    /// Converts a t of the given ray to the scaled one.
    #[inline(always)]
    pub fn scale(&self, t: F) -> F {
        match self.exponent {
            0 => t,
            e => t.times_power_of_two(e),
        }
    }

    /// Converts a t of the scaled ray to the given one.
    #[inline(always)]
    pub fn unscale(&self, t: F) -> F {
        match self.exponent {
            0 => t,
            e => t.times_power_of_two(-e),
        }
    }
}

impl<F: Real> Kernel<Sphere<F>, F> for Haines {
    const NAME: &'static str = "Haines scaled";
    type PreparedRay = ScaledRay<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> ScaledRay<F> {
        ScaledRay::new(ray)
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, scaled: &ScaledRay<F>, min_t: F) -> Option<F> {
        let t = plainly(sphere, &scaled.ray, scaled.scale(min_t))?;
        Some(scaled.unscale(t))
    }
}
