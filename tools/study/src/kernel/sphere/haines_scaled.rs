use super::Haines;
use crate::kernel::Kernel;
use crate::number::{Real, exponent};
use crate::shape::{Ray, Sphere};

/// Haines et al., with the direction first scaled by a power of two so that its largest
/// component is in [1, 2): d·d can then neither overflow nor vanish, and no digit
/// changes. What is counted in multiples of the direction, t and `min_t`, is scaled with
/// it.
///
/// Without it a direction of length 1e-162 or 1e154 has a square that is 0 or infinite.
pub struct HainesScaled;

/// A ray with its direction scaled by 2^−`exponent`. A component that is more than 1e300
/// times smaller than another may lose digits by it, and cannot be had back.
#[derive(Clone, Copy, Debug)]
pub struct Scaled<F> {
    /// The same line.
    pub ray: Ray<F>,
    /// t of this ray times 2^−`exponent` is t of the ray as it was given.
    pub exponent: i32,
}

impl<F: Real> Scaled<F> {
    /// The same line with a direction of length about 1.
    #[inline(always)]
    pub fn new(ray: &Ray<F>) -> Scaled<F> {
        let exponent = exponent(ray.direction.largest().wide());
        let direction = ray.direction.map(|d| d.times_power_of_two(-exponent));
        let ray = Ray { direction, ..*ray };
        Scaled { ray, exponent }
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

impl<F: Real> Kernel<Sphere<F>, F> for HainesScaled {
    const NAME: &'static str = "Haines scaled";
    type Prepared = Scaled<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Scaled<F> {
        Scaled::new(ray)
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, scaled: &Scaled<F>, min_t: F) -> Option<F> {
        let t = Haines::intersect(sphere, &scaled.ray, scaled.scale(min_t))?;
        Some(scaled.unscale(t))
    }
}
