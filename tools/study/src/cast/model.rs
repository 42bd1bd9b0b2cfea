//! With which kernels a scene is cast, and how it is decided which of two parts is first.

use super::world::{Part, Primitive, World};
use super::{Found, Tally};
use crate::kernel::sphere::Scaled;
use crate::kernel::triangle::{Four, Met};
use crate::kernel::{self, Kernel, Limits, Tier, Window, plane, sphere, triangle};
use crate::root::Root;
use crate::shape::Ray;
use crate::vector::Vector;

/// A choice of kernels.
pub trait Model: Sync + 'static {
    /// How tables call it.
    const NAME: &'static str;
    /// How much further than the t it found the first hit may truly be, relative to it.
    const SLACK: f64;
    /// A ray with what all its kernels need.
    type Ray;

    /// Once for a ray; boxes need it scaled as well.
    fn prepare(ray: &Ray<f64>, scaled: &Scaled<f64>, min_t: f64, world: &World) -> Self::Ray;
    /// The smallest t ≥ `min_t` at which a ray meets a part.
    fn meet(part: &Part, ray: &Self::Ray, min_t: f64, tally: &mut Tally) -> Option<f64>;
    /// Which of four triangles it meets. What is left open is asked again, part by part.
    fn meet_four(four: &Four, limits: &Limits, ray: &Self::Ray, min_t: f64) -> Met;
    /// A t of that, in multiples of the ray's direction.
    fn given(t: f64, ray: &Self::Ray) -> f64;
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
    fn prepare(ray: &Ray<f64>, _: &Scaled<f64>, _: f64, _: &World) -> Ray<f64> {
        *ray
    }

    #[inline(always)]
    fn meet(part: &Part, ray: &Ray<f64>, min_t: f64, _: &mut Tally) -> Option<f64> {
        match &part.shape {
            Primitive::Sphere(sphere) => sphere::plainly(sphere, ray, min_t),
            Primitive::Plane(plane) => plane::Shifted::intersect(plane, ray, min_t),
            Primitive::Triangle(triangle) => {
                triangle::MollerTrumbore::intersect(triangle, ray, min_t)
            }
        }
    }

    #[inline(always)]
    fn meet_four(four: &Four, _: &Limits, ray: &Ray<f64>, min_t: f64) -> Met {
        four.plainly(ray, min_t)
    }

    #[inline(always)]
    fn given(t: f64, _: &Ray<f64>) -> f64 {
        t
    }

    #[inline(always)]
    fn comes_first(one: &Found, other: &Found, _: &Ray<f64>, _: f64, _: &mut Tally) -> bool {
        (one.t, one.part.place) < (other.t, other.part.place)
    }
}

/// The adaptive kernels: hit or miss is never wrong, and neither is which part is first.
pub struct Exact;

/// A ray scaled for filters.
pub struct Prepared {
    scaled: Scaled<f64>,
    /// As it was given, for exact decisions.
    direction: Vector<f64>,
    /// From where the parts' limits hold.
    is_near: bool,
    /// Around `min_t`, as the scaled ray counts.
    window: Window,
}

/// The kernels' t are good to √u = 2⁻²⁶·⁵ of themselves; t as different as this are in
/// their true order.
const APART: f64 = 4.0 * 1.1e-8;

impl Model for Exact {
    const NAME: &'static str = "exact";
    const SLACK: f64 = APART;
    type Ray = Prepared;

    #[inline(always)]
    fn prepare(ray: &Ray<f64>, scaled: &Scaled<f64>, min_t: f64, world: &World) -> Prepared {
        Prepared {
            scaled: *scaled,
            direction: ray.direction,
            is_near: world.reach.holds(ray.origin),
            window: Window::new(scaled.scale(min_t)),
        }
    }

    #[inline(always)]
    fn meet(part: &Part, ray: &Prepared, min_t: f64, tally: &mut Tally) -> Option<f64> {
        let (scaled, window, limits) = (&ray.scaled, &ray.window, &part.limits);
        let filtered = match &part.shape {
            _ if !ray.is_near => None,
            Primitive::Sphere(shape) => sphere::filtered(shape, scaled, window, limits),
            Primitive::Plane(shape) => plane::filtered(shape, scaled, window, limits),
            Primitive::Triangle(shape) => triangle::filtered(shape, scaled, window, limits),
        };
        filtered.unwrap_or_else(|| left_open(&part.shape, ray, min_t, tally))
    }

    #[inline(always)]
    fn meet_four(four: &Four, limits: &Limits, ray: &Prepared, _: f64) -> Met {
        match ray.is_near {
            true => four.filtered(&ray.scaled, &ray.window, limits),
            false => four.left_open(),
        }
    }

    #[inline(always)]
    fn given(t: f64, ray: &Prepared) -> f64 {
        ray.scaled.unscale(t)
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

/// What the static filter leaves open is filtered again, with limits of this ray and this
/// shape, and then decided exactly. Out of the way of what it does not leave open.
#[cold]
#[inline(never)]
fn left_open(shape: &Primitive, ray: &Prepared, min_t: f64, tally: &mut Tally) -> Option<f64> {
    let (scaled, direction) = (ray.scaled, ray.direction);
    let given = Ray {
        direction,
        ..scaled.ray
    };
    let ray = kernel::Prepared { scaled, given };
    let (answer, tier) = match shape {
        Primitive::Sphere(shape) => sphere::decided(shape, &ray, min_t),
        Primitive::Plane(shape) => plane::decided(shape, &ray, min_t),
        Primitive::Triangle(shape) => triangle::decided(shape, &ray, min_t),
    };
    tally.semi_static += 1;
    tally.double_double += u64::from(tier > Tier::SemiStatic);
    tally.exact += u64::from(tier == Tier::Exact);
    answer
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
