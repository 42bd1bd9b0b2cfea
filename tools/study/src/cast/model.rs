//! The choice of kernels for casting a scene, and how to decide which of two hits comes first.

use super::refined::nearer;
use super::world::{Accurate, Part, Primitive, World, of_each};
use super::{Found, Tally};
use crate::kernel::sphere::ScaledRay;
use crate::kernel::{
    Camera, Filtered, Kernel, ScaledQuery, Tier, decided, plane, short, sphere, triangle,
};
use crate::root::Root;
use crate::shape::Ray;
use crate::vector::Vector;

/// A ray with everything that filters precompute from it.
pub struct Query<'r> {
    /// The ray as it was given, for exact decisions.
    pub ray: &'r Ray<f64>,
    /// The scaled ray with the margins of the filters, for filters and boxes.
    pub scaled: ScaledQuery,
    /// The smallest t that counts; not negative.
    pub min_t: f64,
    /// What the camera does not fix of the ray: the q of [`Camera`].
    pub varying: Vector<f64>,
}

impl<'r> Query<'r> {
    /// Prepares a ray. What only filters need is computed only for models with filters.
    #[inline(always)]
    pub fn new<M: Model>(ray: &'r Ray<f64>, min_t: f64, world: &World) -> Query<'r> {
        let may_differ = M::FILTERS && !M::HAS_EYE;
        let camera = world.camera.as_ref().filter(|_| may_differ);
        let (scaled, varying) = Camera::scaled(camera, ray);
        let from = if M::FILTERS { scaled.scale(min_t) } else { 0.0 };
        Query {
            ray,
            scaled: ScaledQuery::new(scaled, from),
            min_t,
            varying,
        }
    }
}

/// A choice of kernels.
pub trait Model: Sized + Sync + 'static {
    /// Bound on the relative error of t: the true first hit may be this much further than the t
    /// found.
    const SLACK: f64;
    /// Whether the kernels use filters, which are made for the rays of the world's camera.
    const FILTERS: bool;
    /// Whether all rays start at the camera's eye.
    const HAS_EYE: bool;

    /// The hit with the smallest t ≥ `min_t` of a ray with a part.
    fn meet<'a>(part: &'a Part, query: &Query, tally: &mut Tally) -> Option<Found<'a>>;
    /// Whether hit `one` comes before hit `other`.
    fn comes_first(one: &Found, other: &Found, query: &Query, tally: &mut Tally) -> bool;
}

/// Plain `f64`: the best kernels without exact decisions, and a comparison of rounded t.
pub struct Plain;

impl Model for Plain {
    const SLACK: f64 = 0.0;
    const FILTERS: bool = false;
    const HAS_EYE: bool = false;

    #[inline(always)]
    fn meet<'a>(part: &'a Part, query: &Query, _: &mut Tally) -> Option<Found<'a>> {
        let &Query { ray, min_t, .. } = query;
        let t = match &part.shape {
            Primitive::Sphere(sphere) => sphere::plainly(sphere, ray, min_t),
            Primitive::Plane(plane) => plane::ShiftedOrigin::intersect(plane, ray, min_t),
            Primitive::Triangle(triangle) => {
                triangle::MollerTrumbore::intersect(triangle, ray, min_t)
            }
        };
        t.map(|t| Found::new(part, t))
    }

    #[inline(always)]
    fn comes_first(one: &Found, other: &Found, _: &Query, _: &mut Tally) -> bool {
        (one.t, one.part.place) < (other.t, other.part.place)
    }
}

/// Kernels with filters for the rays of the camera for which the caster was made: hit or miss is
/// never wrong, and neither is the order of hits. `HAS_EYE` says whether the camera has a
/// perspective, so that all rays start at its eye.
pub struct Exact<const HAS_EYE: bool>;

/// The kernels' t have a relative error of at most √u = 2⁻²⁶·⁵. Two t that differ by more than
/// this are in their true order.
const APART: f64 = 4.0 * 1.1e-8;

impl<const HAS_EYE: bool> Model for Exact<HAS_EYE> {
    const SLACK: f64 = APART;
    const FILTERS: bool = true;
    const HAS_EYE: bool = HAS_EYE;

    #[inline(always)]
    fn meet<'a>(part: &'a Part, query: &Query, tally: &mut Tally) -> Option<Found<'a>> {
        match part.filtered::<HAS_EYE>(query.varying, &query.scaled) {
            Some(t) => t.map(|t| Found {
                is_accurate: part.accurate >= Accurate::IfFiltered,
                ..Found::new(part, t)
            }),
            None => {
                left_open(&part.shape, query.ray, query.min_t, tally).map(|t| Found::new(part, t))
            }
        }
    }

    #[inline(always)]
    fn comes_first(one: &Found, other: &Found, query: &Query, tally: &mut Tally) -> bool {
        let certain = APART * one.t.abs().max(other.t.abs()) + f64::MIN_POSITIVE;
        match (one.t - other.t).abs() > certain {
            true => one.t < other.t,
            false => {
                tally.close_calls += 1;
                comes_first_exactly(one.part, other.part, query.ray, query.min_t)
            }
        }
    }
}

/// Decides a test that the static filter could not: in `f64` if that is exact, else with the
/// semi-static filter, whose limits are computed for this ray and shape, and at last with more
/// digits. It is cold and never inlined, to keep the common path short.
#[cold]
#[inline(never)]
fn left_open(shape: &Primitive, ray: &Ray<f64>, min_t: f64, tally: &mut Tally) -> Option<f64> {
    let short = of_each!(shape, shape => shape.short(ray, min_t));
    let (answer, tier) = match short {
        Some(answer) => (answer, Tier::Exact),
        None => {
            let scaled = ScaledRay::new(ray);
            of_each!(shape, shape => decided(shape, &scaled, ray, min_t))
        }
    };
    tally.semi_static += 1;
    tally.exact += u64::from(tier == Tier::Exact);
    answer
}

/// The exact t at which a ray hits a shape, which it is known to hit.
pub fn exact_hit(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> Root {
    of_each!(shape, shape => shape.exact_hit(ray, min_t))
}

#[cold]
#[inline(never)]
fn comes_first_exactly(one: &Part, other: &Part, ray: &Ray<f64>, min_t: f64) -> bool {
    let (p, q) = (&one.shape, &other.shape);
    if p == q {
        return one.place < other.place;
    }
    let fraction = |shape: &Primitive| of_each!(shape, shape => shape.short_fraction(ray));
    let fractions = fraction(p).and_then(|one| Some((one, fraction(q)?)));
    let order = match fractions {
        Some((one, other)) => short::compare(one, other),
        None => nearer(p, q, ray).unwrap_or_else(|| {
            let [one, other] = [p, q].map(|shape| exact_hit(shape, ray, min_t));
            one.compare(&other)
        }),
    };
    order.then(one.place.cmp(&other.place)).is_lt()
}
