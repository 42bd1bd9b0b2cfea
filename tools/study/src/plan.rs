//! The cheapest way to cast one scene that is as accurate as is wished, and proof that it is.
//!
//! 1. Which object is first is always decided exactly: it costs a few instructions a ray, and
//!    proves t to [`bounds::PROVEN_T`] besides.
//! 2. [`bounds`] says how far t and the normal of a hit may be off, from the hit's own
//!    numbers. It is asked only if X is smaller than what is proven already.
//! 3. [`casting`] casts so; what its bounds leave uncertain is worked out [`exactly`].
//! 4. [`told`] puts the plan in words.
//!
//! All of that is proven, for every ray. Nothing is sampled and nothing is timed, so the same
//! scene has the same plan on every machine.

pub mod bounds;
pub mod casting;
pub mod exactly;
pub mod told;

use pinhole::Scene;
use serde::Serialize;

use crate::cast::rays::rays;
use crate::cast::search::{PRICES, Prices, Search, price_of_all};
use crate::cast::world::{Primitive, World};
use crate::number::U;
use crate::vector::{Vector, around};
use bounds::{PROVEN_T, normal_of, of_normal};
use casting::PlannedCaster;

/// What a user wants of a film. Objects are the true ones in any case.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AccuracyTarget {
    /// The largest relative error of t, and the largest angle of a normal in radians.
    pub accuracy: f64,
    /// Whether t is asked for.
    pub depth: bool,
    /// Whether the normal is.
    pub normal: bool,
}

/// A kind of shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Spheres.
    Sphere,
    /// Planes.
    Plane,
    /// Triangles, alone or in soups.
    Triangle,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 3] = [Kind::Sphere, Kind::Plane, Kind::Triangle];

    /// Of a part.
    pub fn of(shape: &Primitive) -> Kind {
        match shape {
            Primitive::Sphere(_) => Kind::Sphere,
            Primitive::Plane(_) => Kind::Plane,
            Primitive::Triangle(_) => Kind::Triangle,
        }
    }

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Sphere => "spheres",
            Kind::Plane => "planes",
            Kind::Triangle => "triangles",
        }
    }
}

/// What is planned for a kind of shape.
#[derive(Clone, Debug, Serialize)]
pub struct KindPlan {
    /// Which.
    pub kind: Kind,
    /// How many there are.
    pub parts: usize,
    /// How far t may be off, relative to it, in `f64`, whatever ray is cast.
    pub worst_t: f64,
    /// And the normal of any of them, in radians; none without an end.
    pub worst_normal: Option<f64>,
    /// Whether that is more than is wished: each hit's own bound is then looked at, and what
    /// exceeds the wish is computed exactly.
    pub watched: bool,
}

/// A plan for one scene.
#[derive(Clone, Debug, Serialize)]
pub struct Plan {
    /// What for.
    pub wish: AccuracyTarget,
    /// Pixels of the film.
    pub pixels: usize,
    /// The kinds there are.
    pub kinds: Vec<KindPlan>,
    /// `brute force` or `boxes`.
    pub search: &'static str,
    /// Instructions for a ray if every part is asked, planes apart.
    pub price_of_all: u64,
    /// By what the search is chosen.
    pub prices: Prices,
}

/// Plans; or says why nothing meets the wish.
pub fn plan(scene: &Scene, wish: AccuracyTarget) -> Result<(Plan, PlannedCaster), String> {
    // An exact t is rounded once, and a normal when it is made unit length.
    if !(wish.accuracy >= 16.0 * U) {
        return Err(format!(
            "an f64 holds 16 digits: no answer is known to {:e}\n  remedy: ask for 2e-15 or more",
            wish.accuracy
        ));
    }
    let (world, rays) = (World::of(&scene.objects), rays(scene));
    let origins = around(rays.iter().map(|ray| [ray.origin; 2])).unwrap_or_default();
    let kind = |kind: Kind| {
        let parts: Vec<&Primitive> = world
            .parts
            .iter()
            .map(|part| &part.shape)
            .filter(|shape| Kind::of(shape) == kind)
            .collect();
        let worst = parts.iter().map(|shape| worst_normal(shape, origins));
        let worst_normal = worst.fold(0.0, f64::max);
        (!parts.is_empty()).then(|| KindPlan {
            kind,
            parts: parts.len(),
            worst_t: PROVEN_T,
            worst_normal: worst_normal.is_finite().then_some(worst_normal),
            watched: wish.depth && PROVEN_T > wish.accuracy
                || wish.normal && worst_normal > wish.accuracy,
        })
    };
    let plan = Plan {
        wish,
        pixels: rays.len(),
        kinds: Kind::ALL.into_iter().filter_map(kind).collect(),
        search: Search::cheaper(&world.parts).name(),
        price_of_all: price_of_all(&world.parts),
        prices: PRICES,
    };
    Ok((plan, PlannedCaster::new(world, scene.min_t, wish)))
}

/// How far the normal of a part may be turned, whichever ray from this box meets it.
fn worst_normal(shape: &Primitive, [low, high]: [Vector<f64>; 2]) -> f64 {
    match shape {
        Primitive::Plane(_) => bounds::OF_UNIT,
        Primitive::Triangle(triangle) => normal_of(triangle).1,
        Primitive::Sphere(sphere) => {
            let away = |corner: Vector<f64>| (corner - sphere.center).largest();
            of_normal(sphere, away(low).max(away(high)), PROVEN_T)
        }
    }
}
