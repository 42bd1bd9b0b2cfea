//! Kernels that are never wrong about hit or miss: a filter answers nearly every question, and the
//! rest is decided exactly.

use super::sphere::{ScaledRay, at_most};
use super::{Kernel, Limits, ScaledQuery, Tier};
use crate::number::ROOT_OF_UNIT;
use crate::root::{Root, rounded};
use crate::shape::Ray;
use crate::vector::Vector;

/// A shape with a filter and an exact decision. The proofs are in its own file.
pub trait Filtered: 'static {
    /// The point that kernels subtract from a ray's origin.
    fn anchor(&self) -> Vector<f64>;

    /// The filter's limits for rays whose origin is up to `distance` from the anchor, and up to
    /// `away` in each component. Where the filter answers with a t, `accuracy` bounds its relative
    /// error, besides the rounding of the final operations; it is at most √u.
    fn limits(&self, away: f64, distance: f64, accuracy: f64) -> Limits;

    /// The filter: the answer, or `None` if rounding might have changed it.
    fn filtered(&self, query: &ScaledQuery, limits: &Limits) -> Option<Option<f64>>;

    /// The answer, if `f64` arithmetic rounds nothing but t; see [`super::short`].
    fn short(&self, _ray: &Ray<f64>, _min_t: f64) -> Option<Option<f64>> {
        None
    }

    /// The answer by exact arithmetic; `None`, too, if a number is not finite.
    fn exact(&self, ray: &Ray<f64>, min_t: f64) -> Option<Root>;

    /// The dividend and the divisor of a hit's t, if `f64` arithmetic rounds neither; see
    /// [`super::short`].
    fn short_fraction(&self, _ray: &Ray<f64>) -> Option<[f64; 2]> {
        None
    }

    /// The exact t of a ray that is known to hit.
    fn exact_hit(&self, ray: &Ray<f64>, min_t: f64) -> Root {
        self.exact(ray, min_t).expect("the ray hits")
    }
}

/// The kernel of every shape that is [`Filtered`]. The relative error of t is at most √u, and
/// mostly about an ulp.
pub struct Adaptive;

impl<S: Filtered> Kernel<S, f64> for Adaptive {
    const NAME: &'static str = "adaptive exact";
    /// The scaled ray, for filters, and the ray as it was given, for exact decisions.
    type PreparedRay = (ScaledRay<f64>, Ray<f64>);

    #[inline(always)]
    fn prepare(ray: &Ray<f64>) -> Self::PreparedRay {
        (ScaledRay::new(ray), *ray)
    }

    #[inline(always)]
    fn intersect(shape: &S, (scaled, ray): &Self::PreparedRay, min_t: f64) -> Option<f64> {
        decided(shape, scaled, ray, min_t).0
    }
}

/// The answer, and the tier that decided it.
#[inline(always)]
pub fn decided(
    shape: &impl Filtered,
    scaled: &ScaledRay<f64>,
    ray: &Ray<f64>,
    min_t: f64,
) -> (Option<f64>, Tier) {
    let query = ScaledQuery::new(*scaled, scaled.scale(min_t));
    let away = (scaled.ray.origin - shape.anchor()).largest();
    let limits = shape.limits(away, at_most(away), ROOT_OF_UNIT);
    if min_t >= 0.0
        && let Some(answer) = shape.filtered(&query, &limits)
    {
        return (answer, Tier::SemiStatic);
    }
    let short = shape.short(ray, min_t);
    let answer = short.unwrap_or_else(|| rounded(shape.exact(ray, min_t)));
    (answer, Tier::Exact)
}
