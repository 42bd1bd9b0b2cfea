//! The choice of kernels for casting a scene, and how to decide which of two hits comes first.

use super::world::{Part, Primitive, World};
use super::{Found, Tally};
use crate::kernel::sphere::ScaledRay;
use crate::kernel::triangle::{PacketHits, TrianglePacket};
use crate::kernel::{FilterRay, Kernel, Limits, Tier, Window, plane, sphere, triangle};
use crate::root::Root;
use crate::shape::Ray;

/// A ray with everything that filters precompute from it.
pub struct Query<'r> {
    /// The ray as it was given, for exact decisions.
    pub ray: &'r Ray<f64>,
    /// The scaled ray, for filters and boxes.
    pub scaled: ScaledRay<f64>,
    /// The smallest t that counts; not negative.
    pub min_t: f64,
    /// `min_t` in the scaled ray's parameter, with the margins of the filters.
    window: Window,
    /// Whether the origin is near enough for the parts' precomputed limits to hold.
    is_near: bool,
}

impl<'r> Query<'r> {
    /// Prepares a ray. What only filters need is computed only for models with filters.
    #[inline(always)]
    pub fn new<M: Model>(ray: &'r Ray<f64>, min_t: f64, world: &World) -> Query<'r> {
        let scaled = ScaledRay::new(ray);
        let from = if M::FILTERS { scaled.scale(min_t) } else { 0.0 };
        Query {
            ray,
            scaled,
            min_t,
            window: Window::new(from),
            is_near: M::FILTERS && world.reach.holds(ray.origin),
        }
    }
}

/// A choice of kernels.
pub trait Model: Sync + 'static {
    /// The name in tables.
    const NAME: &'static str;
    /// Bound on the relative error of t: the true first hit may be this much further than the t
    /// found.
    const SLACK: f64;
    /// Whether the kernels use filters.
    const FILTERS: bool;

    /// The smallest t ≥ `min_t` at which a ray meets a part.
    fn meet(part: &Part, query: &Query, tally: &mut Tally) -> Option<f64>;
    /// Tests four triangles. The caller tests undecided ones again, one by one.
    fn meet_four(four: &TrianglePacket, limits: &Limits, query: &Query) -> PacketHits;
    /// Converts a t from [`Model::meet_four`] to multiples of the ray's direction.
    fn given(t: f64, query: &Query) -> f64;
    /// Whether hit `one` comes before hit `other`.
    fn comes_first(one: &Found, other: &Found, query: &Query, tally: &mut Tally) -> bool;
}

/// Plain `f64`: the best kernels without exact decisions, and a comparison of rounded t.
pub struct Plain;

impl Model for Plain {
    const NAME: &'static str = "f64";
    const SLACK: f64 = 0.0;
    const FILTERS: bool = false;

    #[inline(always)]
    fn meet(part: &Part, &Query { ray, min_t, .. }: &Query, _: &mut Tally) -> Option<f64> {
        match &part.shape {
            Primitive::Sphere(sphere) => sphere::plainly(sphere, ray, min_t),
            Primitive::Plane(plane) => plane::ShiftedOrigin::intersect(plane, ray, min_t),
            Primitive::Triangle(triangle) => {
                triangle::MollerTrumbore::intersect(triangle, ray, min_t)
            }
        }
    }

    #[inline(always)]
    fn meet_four(four: &TrianglePacket, _: &Limits, query: &Query) -> PacketHits {
        four.plainly(query.ray, query.min_t)
    }

    #[inline(always)]
    fn given(t: f64, _: &Query) -> f64 {
        t
    }

    #[inline(always)]
    fn comes_first(one: &Found, other: &Found, _: &Query, _: &mut Tally) -> bool {
        (one.t, one.part.place) < (other.t, other.part.place)
    }
}

/// The adaptive kernels: hit or miss is never wrong, and neither is the order of hits.
pub struct Exact;

/// The kernels' t have a relative error of at most √u = 2⁻²⁶·⁵. Two t that differ by more than
/// this are in their true order.
const APART: f64 = 4.0 * 1.1e-8;

impl Model for Exact {
    const NAME: &'static str = "exact";
    const SLACK: f64 = APART;
    const FILTERS: bool = true;

    #[inline(always)]
    fn meet(part: &Part, query: &Query, tally: &mut Tally) -> Option<f64> {
        let (scaled, window, limits) = (&query.scaled, &query.window, &part.limits);
        let filtered = match &part.shape {
            _ if !query.is_near => None,
            Primitive::Sphere(shape) => sphere::filtered(shape, scaled, window, limits),
            Primitive::Plane(shape) => plane::filtered(shape, scaled, window, limits),
            Primitive::Triangle(shape) => triangle::filtered(shape, scaled, window, limits),
        };
        filtered.unwrap_or_else(|| left_open(&part.shape, query, tally))
    }

    #[inline(always)]
    fn meet_four(four: &TrianglePacket, limits: &Limits, query: &Query) -> PacketHits {
        match query.is_near {
            true => four.filtered(&query.scaled, &query.window, limits),
            false => four.left_open(),
        }
    }

    #[inline(always)]
    fn given(t: f64, query: &Query) -> f64 {
        query.scaled.unscale(t)
    }

    #[inline(always)]
    fn comes_first(one: &Found, other: &Found, query: &Query, tally: &mut Tally) -> bool {
        let certain = APART * one.t.abs().max(other.t.abs()) + f64::MIN_POSITIVE;
        match (one.t - other.t).abs() > certain {
            true => one.t < other.t,
            false => {
                tally.close_calls += 1;
                comes_first_exactly(one.part, other.part, query)
            }
        }
    }
}

/// Decides a test that the static filter could not: first with the semi-static filter, whose
/// limits are computed for this ray and shape, then exactly. It is cold and never inlined, to
/// keep the common path short.
#[cold]
#[inline(never)]
fn left_open(shape: &Primitive, query: &Query, tally: &mut Tally) -> Option<f64> {
    let (scaled, given, min_t) = (query.scaled, *query.ray, query.min_t);
    let ray = FilterRay { scaled, given };
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

/// The exact t at which a ray hits a part.
pub fn exact(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> Option<Root> {
    match shape {
        Primitive::Sphere(shape) => sphere::exact(shape, ray, min_t),
        Primitive::Plane(shape) => plane::exact(shape, ray, min_t),
        Primitive::Triangle(shape) => triangle::exact(shape, ray, min_t),
    }
}

#[cold]
#[inline(never)]
fn comes_first_exactly(one: &Part, other: &Part, query: &Query) -> bool {
    let met =
        |part: &Part| exact(&part.shape, query.ray, query.min_t).expect("a filter found this hit");
    let order = met(one).compare(&met(other));
    order.then(one.place.cmp(&other.place)).is_lt()
}
