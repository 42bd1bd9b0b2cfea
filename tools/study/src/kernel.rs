//! Ways to intersect a ray with a shape, each in a small file of its own.
//!
//! All have the same signature, [`Kernel::intersect`], and return t alone: the first
//! intersection with t ≥ `min_t`, as in the lecture. A normal follows from t and the shape, and
//! not every caller wants one.
//!
//! A kernel is a type without values, chosen at compile time, so that the compiler can inline
//! it into the leaves of a tree. [`Kernel::prepare`] computes what depends on the ray alone,
//! once per ray instead of once per shape.

mod adaptive;
mod camera;
mod filter;
pub mod plane;
pub mod short;
pub mod sphere;
pub mod triangle;

pub use adaptive::{Adaptive, Filtered, decided};
pub use camera::Camera;
pub use filter::{Limits, ScaledQuery, Tier};

use crate::number::Real;
use crate::shape::{Ray, Shape};

/// One way to intersect a ray with a shape `S` whose numbers are `F`.
pub trait Kernel<S, F: Real>: 'static {
    /// The name in tables and plots.
    const NAME: &'static str;

    /// The ray, with everything that this kernel precomputes from it.
    type PreparedRay: Copy;

    /// Prepares a ray, once for all shapes.
    fn prepare(ray: &Ray<F>) -> Self::PreparedRay;

    /// The smallest t ≥ `min_t` at which the ray meets the shape.
    fn intersect(shape: &S, ray: &Self::PreparedRay, min_t: F) -> Option<F>;
}

/// A kernel that computes in `f64` on `f32` data. t is rounded once, at the end, and products
/// of two `f32` are exact.
pub struct WidenedKernel<K>(K);

impl<S: Shape<Number = f32>, K: Kernel<S::With<f64>, f64>> Kernel<S, f32> for WidenedKernel<K> {
    const NAME: &'static str = K::NAME;
    type PreparedRay = K::PreparedRay;

    #[inline(always)]
    fn prepare(ray: &Ray<f32>) -> K::PreparedRay {
        K::prepare(&ray.map(f32::wide, f32::wide))
    }

    #[inline(always)]
    fn intersect(shape: &S, ray: &K::PreparedRay, min_t: f32) -> Option<f32> {
        // Rounding never takes a t ≥ min_t below min_t, because min_t is an `f32`.
        K::intersect(&shape.map(f32::wide, f32::wide), ray, min_t.wide()).map(f32::of)
    }
}
