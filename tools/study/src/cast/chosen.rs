//! Any set of kernels in `f64`, as a model.

use std::marker::PhantomData;

use super::kernels::{Kernels, Prepared};
use super::model::Model;
use super::world::{Primitive, World};
use super::{Found, Tally};
use crate::kernel::Kernel;
use crate::shape::Ray;

/// These kernels, and t compared as it is.
pub struct Chosen<K>(PhantomData<K>);

impl<K: Kernels<f64>> Model for Chosen<K> {
    const NAME: &'static str = K::NUMBERS;
    const SLACK: f64 = 0.0;
    type Ray = Prepared<f64, K>;

    #[inline(always)]
    fn prepare(ray: &Ray<f64>, _: &World) -> Prepared<f64, K> {
        Prepared::new(ray)
    }

    #[inline(always)]
    fn meet(shape: &Primitive, ray: &Prepared<f64, K>, min_t: f64, _: &mut Tally) -> Option<f64> {
        match shape {
            Primitive::Sphere(shape) => K::Sphere::intersect(shape, &ray.sphere, min_t),
            Primitive::Plane(shape) => K::Plane::intersect(shape, &ray.plane, min_t),
            Primitive::Triangle(shape) => K::Triangle::intersect(shape, &ray.triangle, min_t),
        }
    }

    #[inline(always)]
    fn comes_first(one: &Found, other: &Found, _: &Ray<f64>, _: f64, _: &mut Tally) -> bool {
        (one.t, one.part.place) < (other.t, other.part.place)
    }
}
