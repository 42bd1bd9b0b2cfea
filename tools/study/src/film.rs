//! Casts films for `pinhole render`: exactly (`--exact`), or by a plan (`--plan`).

use std::time::Instant;

use pinhole::{Film, Hit, Intersection, Scene};
use serde::Serialize;

use crate::cast::Seen;
use crate::plan::casting::PlannedCaster;
use crate::plan::{AccuracyTarget, Plan, plan};

/// What it took to cast a film.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Wall time of casting.
    pub seconds: f64,
    /// Wall time of planning, including building the tree.
    pub planning_seconds: f64,
    /// Tests of a ray against a sphere, plane or triangle.
    pub tests: u64,
    /// Tests that no filter could decide and that were therefore decided exactly.
    pub fallbacks: u64,
    /// Comparisons of two t that were decided exactly.
    pub close_calls: u64,
    /// Pixels whose t and normal were computed exactly, because their error bounds were too
    /// large.
    pub exact_hits: u64,
    /// The plan, with its reasons.
    pub plan: Plan,
}

/// What an exact film promises besides the true object at every pixel. The accuracy is far
/// beyond the digits of the film's own `f32`.
pub const EXACT: AccuracyTarget = AccuracyTarget {
    accuracy: 1e-12,
    depth: true,
    normal: true,
};

/// Plans a scene and casts it by that plan.
pub fn planned(scene: &Scene, wish: AccuracyTarget) -> Result<(Film, Report), String> {
    let start = Instant::now();
    let casting = PlannedCaster::new(scene, wish)?;
    let plan = plan(&casting);
    let planning_seconds = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let (seen, tally) = casting.film();
    let seconds = start.elapsed().as_secs_f64();
    let hits: Vec<_> = seen.into_iter().map(hit).collect();
    let report = Report {
        seconds,
        planning_seconds,
        tests: tally.tests,
        fallbacks: tally.exact,
        close_calls: tally.close_calls,
        exact_hits: tally.exact_hits,
        plan,
    };
    Ok((Film::of_hits(scene.resolution, &hits), report))
}

/// Converts a hit for the film, whose samples must be finite: a t beyond the largest `f32`
/// becomes that number.
fn hit(seen: Seen) -> Option<Hit> {
    let (object, t, normal) = seen?;
    let largest = f64::from(f32::MAX);
    Some(Hit {
        object: object as usize,
        intersection: Intersection {
            t: t.clamp(-largest, largest),
            normal: normal.array().into(),
        },
    })
}
