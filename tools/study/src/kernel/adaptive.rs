//! Rays for kernels that filter decisions, and decide exactly what the filter leaves open.

use super::sphere::Scaled;
use crate::number::Real;
use crate::shape::Ray;

/// A ray scaled for the filter, and as it was given, for exact decisions.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F> {
    /// For the filter.
    pub(super) scaled: Scaled<F>,
    /// For exact decisions.
    pub(super) given: Ray<F>,
}

impl<F: Real> Prepared<F> {
    /// Once for a ray.
    #[inline(always)]
    pub fn new(ray: &Ray<F>) -> Prepared<F> {
        let (scaled, given) = (Scaled::new(ray), *ray);
        Prepared { scaled, given }
    }
}
