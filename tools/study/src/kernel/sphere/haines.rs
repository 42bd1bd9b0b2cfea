use super::first_from;
use crate::kernel::Kernel;
use crate::number::{Real, exponent};
use crate::shape::{Ray, Sphere};

/// The discriminant from the perpendicular: the vector from the centre to the nearest
/// point of the line is l = f − (d·f / d·d) d, and the line meets the sphere if
/// |l|² ≤ r² (Haines, Günther & Akenine-Möller, *Ray Tracing Gems*, 2019, chapter 7,
/// "Precision Improvements for Ray/Sphere Intersection"). The roots are c/q and q/a of
/// q = −h − sign(h) √Δ (Press et al., *Numerical Recipes*, 3rd ed., §5.6), which adds two
/// numbers of one sign.
///
/// The large parts cancel before anything is squared, so that l is off by a few roundings
/// of |f|, and r² − |l|² by those times r: good to distance/radius 1/u.
///
/// The direction is first scaled by a power of two so that its largest component is in
/// [1, 2): d·d can then neither overflow nor vanish, and no digit changes. Without it a
/// direction of length 1e-162 or 1e154 has a square that is 0 or infinite. What is counted in
/// multiples of the direction, t and `min_t`, is scaled with it.
pub struct Haines;

/// The same without scaling, which is as good for directions of ordinary length.
#[inline(always)]
pub fn plainly<F: Real>(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
    let f = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let h = ray.direction.dot(f);
    let perpendicular = f - ray.direction * (h / a);
    let square = sphere.radius * sphere.radius;
    let within = square - perpendicular.dot(perpendicular);
    if within < F::ZERO {
        return None;
    }
    let (c, root) = (f.dot(f) - square, (a * within).sqrt());
    match h < F::ZERO {
        true => first_from(min_t, c / (root - h), (root - h) / a),
        false => first_from(min_t, (-h - root) / a, c / (-h - root)),
    }
}

/// A ray with its direction scaled by 2^−`exponent`. A component that is more than 1e300
/// times smaller than another may lose digits by it, and cannot be had back.
#[derive(Clone, Copy, Debug)]
pub struct ScaledRay<F> {
    /// The same line.
    pub ray: Ray<F>,
    /// t of this ray times 2^−`exponent` is t of the ray as it was given.
    pub exponent: i32,
}

impl<F: Real> ScaledRay<F> {
    /// The same line with a direction of length about 1.
    #[inline(always)]
    pub fn new(ray: &Ray<F>) -> ScaledRay<F> {
        let exponent = exponent(ray.direction.largest().wide());
        let direction = ray.direction.map(|d| d.times_power_of_two(-exponent));
        let ray = Ray { direction, ..*ray };
        ScaledRay { ray, exponent }
    }

    /// A t of the given ray as one of the scaled.
    #[inline(always)]
    pub fn scale(&self, t: F) -> F {
        match self.exponent {
            0 => t,
            e => t.times_power_of_two(e),
        }
    }

    /// A t of the scaled ray as one of the given.
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
    type Prepared = ScaledRay<F>;

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
