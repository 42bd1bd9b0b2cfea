//! With which kernels a scene is cast, and how it is decided which of two parts is first.

use super::world::{Part, Primitive, World};
use super::{Found, Tally};
use crate::kernel::sphere::Scaled;
use crate::kernel::{Kernel, plane, sphere, triangle};
use crate::root::{Root, rounded};
use crate::shape::Ray;

/// A choice of kernels.
pub trait Model: Sync + 'static {
    /// How tables call it.
    const NAME: &'static str;
    /// How much further than the t it found the first hit may truly be, relative to it.
    const SLACK: f64;
    /// A ray with what all its kernels need.
    type Ray;

    /// Once for a ray.
    fn prepare(ray: &Ray<f64>, world: &World) -> Self::Ray;
    /// The smallest t ≥ `min_t` at which a ray meets a part.
    fn meet(shape: &Primitive, ray: &Self::Ray, min_t: f64, tally: &mut Tally) -> Option<f64>;
    /// Whether a ray meets `one` before `other`, both from `min_t` on.
    fn comes_first(
        one: &Found,
        other: &Found,
        ray: &Ray<f64>,
        min_t: f64,
        tally: &mut Tally,
    ) -> bool;
}

/// Plain `f64`: the best kernels that never decide exactly, and t compared as it is.
pub struct Plain;

impl Model for Plain {
    const NAME: &'static str = "f64";
    const SLACK: f64 = 0.0;
    type Ray = Ray<f64>;

    #[inline(always)]
    fn prepare(ray: &Ray<f64>, _: &World) -> Ray<f64> {
        *ray
    }

    #[inline(always)]
    fn meet(shape: &Primitive, ray: &Ray<f64>, min_t: f64, _: &mut Tally) -> Option<f64> {
        match shape {
            Primitive::Sphere(sphere) => sphere::Haines::intersect(sphere, ray, min_t),
            Primitive::Plane(plane) => plane::Shifted::intersect(plane, ray, min_t),
            Primitive::Triangle(triangle) => {
                triangle::MollerTrumbore::intersect(triangle, ray, min_t)
            }
        }
    }

    #[inline(always)]
    fn comes_first(one: &Found, other: &Found, _: &Ray<f64>, _: f64, _: &mut Tally) -> bool {
        (one.t, one.part.place) < (other.t, other.part.place)
    }
}

/// The adaptive kernels: hit or miss is never wrong, and neither is which part is first.
pub struct Exact;

/// A ray scaled for filters, and as it was given.
pub struct Prepared {
    scaled: Scaled<f64>,
    given: Ray<f64>,
    /// For all triangles of the scene: what this leaves open is filtered again, with the
    /// triangle's own, before it is decided exactly.
    budget: triangle::Budget<f64>,
}

/// The kernels' t are good to √u = 2⁻²⁶·⁵ of themselves; t as different as this are in
/// their true order.
const APART: f64 = 4.0 * 1.1e-8;

impl Model for Exact {
    const NAME: &'static str = "exact";
    const SLACK: f64 = APART;
    type Ray = Prepared;

    #[inline(always)]
    fn prepare(ray: &Ray<f64>, world: &World) -> Prepared {
        Prepared {
            scaled: Scaled::new(ray),
            given: *ray,
            budget: triangle::Budget::new(world.edges(), world.away(ray.origin)),
        }
    }

    #[inline(always)]
    fn meet(shape: &Primitive, ray: &Prepared, min_t: f64, tally: &mut Tally) -> Option<f64> {
        let filtered = match shape {
            Primitive::Sphere(shape) => sphere::filtered(shape, &ray.scaled, min_t),
            Primitive::Plane(shape) => plane::filtered(shape, &ray.given, min_t),
            Primitive::Triangle(shape) => {
                triangle::filtered_within(shape, &ray.scaled, min_t, &ray.budget)
            }
        };
        match filtered {
            Some(answer) => answer,
            None => left_open(shape, ray, min_t, tally),
        }
    }

    #[inline(always)]
    fn comes_first(
        one: &Found,
        other: &Found,
        ray: &Ray<f64>,
        min_t: f64,
        tally: &mut Tally,
    ) -> bool {
        let certain = APART * one.t.abs().max(other.t.abs()) + f64::MIN_POSITIVE;
        match (one.t - other.t).abs() > certain {
            true => one.t < other.t,
            false => {
                tally.close_calls += 1;
                comes_first_exactly(one.part, other.part, ray, min_t)
            }
        }
    }
}

/// What the first filter leaves open. Out of the way of what it does not.
#[cold]
#[inline(never)]
fn left_open(shape: &Primitive, ray: &Prepared, min_t: f64, tally: &mut Tally) -> Option<f64> {
    if let Primitive::Triangle(triangle) = shape
        && let Some(answer) = triangle::filtered(triangle, &ray.scaled, min_t)
    {
        return answer;
    }
    tally.fallbacks += 1;
    rounded(exact(shape, &ray.given, min_t))
}

/// Where a ray truly meets a part.
pub fn exact(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> Option<Root> {
    match shape {
        Primitive::Sphere(shape) => sphere::exact(shape, ray, min_t),
        Primitive::Plane(shape) => plane::exact(shape, ray, min_t),
        Primitive::Triangle(shape) => triangle::exact(shape, ray, min_t),
    }
}

#[cold]
#[inline(never)]
fn comes_first_exactly(one: &Part, other: &Part, ray: &Ray<f64>, min_t: f64) -> bool {
    let met = |part: &Part| exact(&part.shape, ray, min_t).expect("a filter said that it is met");
    let order = met(one).compare(&met(other));
    order.then(one.place.cmp(&other.place)).is_lt()
}
