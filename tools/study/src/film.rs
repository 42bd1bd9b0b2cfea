//! Films: cast exactly, what `pinhole render --exact` writes, or as planned.

use std::time::Instant;

use pinhole::{Film, Hit, Intersection, Scene};
use serde::Serialize;

use crate::cast::model::Exact;
use crate::cast::rays::rays;
use crate::cast::world::World;
use crate::cast::{Caster, Found, Search};
use crate::plan::casting::Spent;
use crate::plan::{Plan, Wish, plan};
use crate::shape::Ray;
use crate::vector::Vector;

/// What casting a film took.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Wall time of casting, the tree included.
    pub seconds: f64,
    /// Rays against spheres, planes and triangles.
    pub tests: u64,
    /// Tests that were decided exactly, for a filter left them open.
    pub fallbacks: u64,
    /// Comparisons of two t that were decided exactly.
    pub close_calls: u64,
}

/// What casting a planned film took.
#[derive(Clone, Debug, Serialize)]
pub struct Planned {
    /// Wall time of casting.
    pub seconds: f64,
    /// Wall time of planning, trees included.
    pub planning_seconds: f64,
    /// Who had the last word at how many pixels.
    pub spent: Spent,
    /// The plan, with its reasons.
    pub plan: Plan,
}

/// Casts a scene exactly.
pub fn exact(scene: &Scene) -> (Film, Report) {
    let rays = rays(scene);
    let start = Instant::now();
    let caster = Caster::new(World::of(&scene.objects));
    let (found, tally) = caster.film::<Exact>(Search::Boxes, &rays, scene.min_t);
    let seconds = start.elapsed().as_secs_f64();
    let hits: Vec<_> = found.iter().zip(&rays).map(hit).collect();
    let report = Report {
        seconds,
        tests: tally.tests,
        fallbacks: tally.fallbacks,
        close_calls: tally.close_calls,
    };
    (Film::of_hits(scene.resolution, &hits), report)
}

/// Plans a scene and casts it so.
pub fn planned(scene: &Scene, wish: Wish) -> Result<(Film, Planned), String> {
    let start = Instant::now();
    let (plan, casting) = plan(scene, wish)?;
    let planning_seconds = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let (seen, spent) = casting.film(&rays(scene));
    let seconds = start.elapsed().as_secs_f64();
    let hits: Vec<_> = seen
        .into_iter()
        .map(|seen| seen.map(|(object, t, normal)| at(object, t, normal)))
        .collect();
    let planned = Planned {
        seconds,
        planning_seconds,
        spent,
        plan,
    };
    Ok((Film::of_hits(scene.resolution, &hits), planned))
}

fn at(object: u32, t: f64, normal: Vector<f64>) -> Hit {
    Hit {
        object: object as usize,
        intersection: Intersection {
            t,
            normal: normal.array().into(),
        },
    }
}

fn hit((found, ray): (&Option<Found>, &Ray<f64>)) -> Option<Hit> {
    let Found { part, t } = (*found)?;
    let normal = part.shape.normal(ray.origin + ray.direction * t);
    Some(at(part.object, t, normal))
}
