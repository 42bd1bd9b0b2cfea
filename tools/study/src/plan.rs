//! Plans the cheapest way to cast a scene with the requested accuracy, and proves that the
//! accuracy is reached.
//!
//! 1. Which object a ray hits first is always decided exactly. This costs a few instructions per
//!    ray, and also proves t to [`PROVEN_T`].
//! 2. [`bounds`](crate::cast::bounds) tells for each part how accurate t must be, so that t and the
//!    normal are as accurate as requested. The filters' limits are chosen accordingly, once for the
//!    whole film.
//! 3. [`casting`] casts by the plan. A hit that a filter leaves open is computed by
//!    [`refined`](crate::cast::refined).
//! 4. [`description`](crate::summary::description) describes the plan in words.
//!
//! All of this is proven for every ray, if t is a normal `f64`; any other t is rounded to an `f64`
//! beside it, which may be far from it. Nothing is sampled or timed, so the same scene has the
//! same plan on every machine.

pub mod casting;

use serde::Serialize;

use crate::cast::bounds::of_normal;
use crate::cast::world::{Accurate, PROVEN_T, Part, Primitive};
use casting::PlannedCaster;

/// An accuracy that costs exact casting nothing in ordinary scenes: normals are off by at most a
/// tenth of a radian, and t is as accurate as the search leaves it.
pub const EXACT_OBJECTS: f64 = 0.1;

/// The accuracy of t and normals in an exact film: far beyond the digits of the film's own `f32`.
pub const EXACT_FILM: f64 = 1e-12;

/// The plan for one kind of shape.
#[derive(Clone, Debug, Serialize)]
pub struct KindPlan {
    /// `sphere`, `plane` or `triangle`.
    pub kind: &'static str,
    /// The number of parts of this kind.
    pub parts: usize,
    /// Worst relative error of t in `f64`, over all rays.
    pub worst_t: f64,
    /// Worst error of a normal, in radians; `None` if unbounded.
    pub worst_normal: Option<f64>,
    /// Whether hits are watched, because not all are certain to have the requested accuracy.
    /// Stricter filters then decide which have it, and the others are computed with more digits.
    pub watched: bool,
}

/// A plan for one scene.
#[derive(Clone, Debug, Serialize)]
pub struct Plan {
    /// The requested accuracy: the largest relative error of t, and the largest angle of a normal
    /// in radians.
    pub accuracy: f64,
    /// The number of pixels.
    pub pixels: usize,
    /// The plans of the kinds that occur in the scene.
    pub kinds: Vec<KindPlan>,
    /// The chosen search: `brute force` or `boxes`.
    pub search: &'static str,
    /// Instructions per ray to test every part except planes.
    pub price_of_all: u64,
    /// The costs that decide the search.
    pub prices: Prices,
}

/// Costs of the exact caster per ray. They are numbers of instructions, because these repeat
/// exactly, unlike times. They were measured with callgrind. For spheres and triangles, `render
/// --plan` cast scenes of 1 to 3 parts that all rays miss, at two resolutions, and the difference
/// of the two counts was divided by the difference in pixels. `boxes` is what the hierarchy of the
/// scene `inside_a_box` adds to the tests in its leaves.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Prices {
    /// Testing one sphere.
    pub sphere: u64,
    /// Testing one triangle.
    pub triangle: u64,
    /// Traversing the hierarchy of a small scene that fills the picture.
    pub boxes: u64,
}

/// The costs measured on x86-64-v3.
pub const PRICES: Prices = Prices {
    sphere: 21,
    triangle: 35,
    boxes: 330,
};

/// Instructions to test every part that can be in a box. Planes cost the same either way.
fn price_of_all(parts: &[Part]) -> u64 {
    let price = |part: &Part| match part.shape {
        Primitive::Sphere(_) => PRICES.sphere,
        Primitive::Plane(_) => 0,
        Primitive::Triangle(_) => PRICES.triangle,
    };
    parts.iter().map(price).sum()
}

/// The name of a search with boxes, or of one that tests every part.
pub fn search_name(has_boxes: bool) -> &'static str {
    if has_boxes { "boxes" } else { "brute force" }
}

/// The finest accuracy that a plan can reach. Even an exact t is rounded once, and a normal again
/// when it is normalised.
pub const FINEST: f64 = 2e-15;

/// The plan that a caster follows.
pub fn plan(casting: &PlannedCaster) -> Plan {
    let camera = &casting.camera;
    let worst_normal =
        |part: &&Part| of_normal(&part.shape, camera.distance(part.shape.anchor()), PROVEN_T);
    let all = casting.parts();
    let kind = |kind| {
        let parts: Vec<&Part> = all.iter().filter(|it| it.shape.kind() == kind).collect();
        let worst_normal = parts.iter().map(worst_normal).fold(0.0, f64::max);
        (!parts.is_empty()).then(|| KindPlan {
            kind,
            parts: parts.len(),
            worst_t: PROVEN_T,
            worst_normal: worst_normal.is_finite().then_some(worst_normal),
            watched: parts.iter().any(|part| part.accurate != Accurate::Always),
        })
    };
    Plan {
        accuracy: casting.accuracy,
        pixels: casting.rays().len(),
        kinds: ["sphere", "plane", "triangle"]
            .into_iter()
            .filter_map(kind)
            .collect(),
        search: search_name(casting.has_boxes),
        price_of_all: price_of_all(all),
        prices: PRICES,
    }
}
