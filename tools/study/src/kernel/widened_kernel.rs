use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Shape};

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
