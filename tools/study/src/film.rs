//! A film cast exactly: what `pinhole render --exact` writes.

use std::path::Path;
use std::time::Instant;

use pinhole::{Error, Film, Hit, Intersection, Resolution, Scene};
use serde::Serialize;

use crate::cast::model::Exact;
use crate::cast::rays::rays;
use crate::cast::world::World;
use crate::cast::{Caster, Found, Search};
use crate::shape::Ray;

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

/// Casts a scene file exactly and writes its film.
pub fn write(file: &Path, resolution: Option<Resolution>, to: &Path) -> Result<Report, Error> {
    let mut scene = Scene::read(file)?;
    scene.resolution = resolution.unwrap_or(scene.resolution);
    let rays = rays(&scene);
    let start = Instant::now();
    let caster = Caster::new(World::of(&scene.objects));
    let (found, tally) = caster.film::<Exact>(Search::Boxes, &rays, scene.min_t);
    let seconds = start.elapsed().as_secs_f64();
    let hits: Vec<_> = found.iter().zip(&rays).map(hit).collect();
    Film::of_hits(scene.resolution, &hits).write(to)?;
    Ok(Report {
        seconds,
        tests: tally.tests,
        fallbacks: tally.fallbacks,
        close_calls: tally.close_calls,
    })
}

fn hit((found, ray): (&Option<Found>, &Ray<f64>)) -> Option<Hit> {
    let Found { part, t } = (*found)?;
    let normal = part.shape.normal(ray.origin + ray.direction * t);
    Some(Hit {
        object: part.object as usize,
        intersection: Intersection {
            t,
            normal: normal.array().into(),
        },
    })
}
