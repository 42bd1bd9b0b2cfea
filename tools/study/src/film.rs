//! Films: cast exactly, what `pinhole render --exact` writes, or as planned.

use std::time::Instant;

use pinhole::{Film, Hit, Intersection, Scene};
use serde::Serialize;

use crate::cast::Tally;
use crate::cast::rays::rays;
use crate::plan::casting::Seen;
use crate::plan::{AccuracyTarget, Plan, plan};

/// What casting a film took.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Wall time of casting.
    pub seconds: f64,
    /// Wall time of planning, the tree included.
    pub planning_seconds: f64,
    /// Rays against spheres, planes and triangles.
    pub tests: u64,
    /// Tests that were decided exactly, for a filter left them open.
    pub fallbacks: u64,
    /// Comparisons of two t that were decided exactly.
    pub close_calls: u64,
    /// Pixels whose t and normal were computed exactly, for their bounds were too large.
    pub exact_hits: u64,
    /// The plan, with its reasons.
    pub plan: Plan,
}

/// What an exact film promises, beside the true object at every pixel: far more digits than
/// the film's own numbers have.
pub const EXACT: AccuracyTarget = AccuracyTarget {
    accuracy: 1e-12,
    depth: true,
    normal: true,
};

/// Plans a scene and casts it so.
pub fn planned(scene: &Scene, wish: AccuracyTarget) -> Result<(Film, Report), String> {
    let start = Instant::now();
    let (plan, casting) = plan(scene, wish)?;
    let planning_seconds = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let (seen, tally) = casting.film(&rays(scene));
    let seconds = start.elapsed().as_secs_f64();
    let hits: Vec<_> = seen.into_iter().map(hit).collect();
    let Tally {
        tests,
        exact: fallbacks,
        close_calls,
        exact_hits,
        ..
    } = tally;
    let report = Report {
        seconds,
        planning_seconds,
        tests,
        fallbacks,
        close_calls,
        exact_hits,
        plan,
    };
    Ok((Film::of_hits(scene.resolution, &hits), report))
}

/// What a film holds is finite: a t beyond its largest number is that number.
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
