//! Checks plans for every scene and several accuracies: does each reach the requested accuracy
//! at every pixel, and what does it cost compared with exact objects alone and with plain
//! `f64`?

use std::hint::black_box;
use std::time::Instant;

use crate::cast::world::World;
use crate::cast::{Caster, Tally};
use crate::extent::Extent;
use crate::oracle::scene::{FilmErrors, TrueHit, errors};
use crate::plan::casting::PlannedCaster;
use crate::result::PlanTally;
use crate::scenes::Stage;
use crate::speed::{Workload, race};

/// Plans a scene for each accuracy, and judges a share of its pixels.
pub fn studied(stage: &Stage, extent: &Extent) -> Vec<PlanTally> {
    let scene = &stage.scene;
    let pixels = scene.resolution.pixels() as f64;
    let mut castings = Vec::new();
    let mut planning = Vec::new();
    for accuracy in extent.accuracies {
        let plan = || PlannedCaster::new(scene, *accuracy).expect("its rays are finite");
        planning.push(least_time(plan) / pixels);
        castings.push(plan().every(extent.step));
    }
    let (truths, rays) = (stage.exact.truths(), stage.exact.rays());
    let plain_tree = least_time(|| Caster::new(World::of(&scene.objects), None, true)) / pixels;

    let planned = castings.iter();
    let mut films: Vec<Workload> = Vec::new();
    films.extend(planned.map(|casting| Box::new(|| casting.cast()) as Workload));
    films.push(Box::new(|| stage.cast(None)));
    films.push(Box::new(|| stage.cast(Some(stage.exact.has_boxes))));
    let times = race(films, rays.len(), extent.seconds);
    let [.., exact_ids, plain] = times.as_slice() else {
        unreachable!("the last two are always there");
    };
    let tally = |(at, casting): (usize, &PlannedCaster)| {
        let (kept, tally) = kept(casting, &truths);
        PlanTally {
            scene: stage.name.clone(),
            accuracy: casting.accuracy,
            kept,
            exact_hits: tally.exact_hits,
            planning: planning[at],
            plain_tree,
            nanoseconds: times[at].nanoseconds,
            exact_ids: exact_ids.nanoseconds,
            plain: plain.nanoseconds,
        }
    };
    castings.iter().enumerate().map(tally).collect()
}

/// The shortest of five times, in nanoseconds.
fn least_time<T>(prepare: impl Fn() -> T) -> f64 {
    let time = || {
        let start = Instant::now();
        black_box(prepare());
        start.elapsed().as_secs_f64() * 1e9
    };
    (0..5).map(|_| time()).fold(f64::INFINITY, f64::min)
}

/// Casts all rays by a plan, and judges the result by the truth.
pub fn kept(casting: &PlannedCaster, truths: &[TrueHit]) -> (FilmErrors, Tally) {
    let (hits, tally) = casting.hits();
    let kept = errors(casting.rays(), truths, hits, casting.accuracy);
    (kept, tally)
}
