//! Ways to intersect a ray with a shape: one small file for each.
//!
//! All have the same signature, [`Kernel::intersect`], and answer with t alone: the
//! first intersection from `min_t` on, as the lecture asks. A normal follows from t and
//! the shape, and not every caller wants one.
//!
//! A kernel is a type without values, chosen at compile time: in the leaf of a tree it
//! costs what its formula costs. What depends on the ray alone is worked out once for a
//! ray, by [`Kernel::prepare`], and not again at every shape.

mod filter;
pub mod plane;
pub mod sphere;
pub mod triangle;
mod widened;

pub use filter::{Limits, Prepared, Tier, Window};
pub use widened::WidenedKernel;

use crate::number::Real;
use crate::shape::Ray;

/// One way to intersect a ray with a shape `S` whose numbers are `F`.
pub trait Kernel<S, F: Real>: 'static {
    /// How tables and plots call it.
    const NAME: &'static str;

    /// The ray, with whatever this kernel works out of it beforehand.
    type Prepared: Copy;

    /// Once for a ray.
    fn prepare(ray: &Ray<F>) -> Self::Prepared;

    /// The smallest t ≥ `min_t` at which the ray meets the shape.
    fn intersect(shape: &S, ray: &Self::Prepared, min_t: F) -> Option<F>;
}
