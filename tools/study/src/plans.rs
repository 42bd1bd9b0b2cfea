//! Checks plans for every scene and several accuracies: does each reach the requested accuracy
//! at every pixel, and what does it cost compared with exact objects alone and with plain
//! `f64`?

use std::hint::black_box;
use std::path::Path;

use rayon::prelude::*;

use crate::cast::model::Plain;
use crate::cast::rays::{camera, rays};
use crate::cast::world::World;
use crate::cast::{Caster, Search, Tally};
use crate::oracle::scene::{HitComparison, TrueHit, compared, sight};
use crate::plan::casting::PlannedCaster;
use crate::plan::{AccuracyTarget, EXACT_OBJECTS, plan};
use crate::result::{PlanErrors, PlanTally};
use crate::scenes::{self, Share};
use crate::shape::Ray;
use crate::speed::{Workload, race};

/// The requested accuracies.
pub const ACCURACIES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Plans a scene for each accuracy, and judges a share of its pixels.
pub fn studied(file: &Path, share: Share, accuracies: &[f64]) -> Result<Vec<PlanTally>, String> {
    let scene = scenes::read(file).map_err(|error| error.to_string())?;
    let world = World::of(&scene.objects);
    let rays: Vec<_> = rays(&scene).into_iter().step_by(share.step).collect();
    let truth = |ray| sight(&world.parts, ray, scene.min_t);
    let truths: Vec<_> = rays.par_iter().map(truth).collect();
    let everything = |accuracy| AccuracyTarget {
        accuracy,
        depth: true,
        normal: true,
    };
    let mut castings = Vec::new();
    for accuracy in accuracies {
        let wish = everything(*accuracy);
        castings.push((wish, plan(&scene, wish)?.1));
    }
    let unwatched = PlannedCaster::new(
        world.clone(),
        camera(&scene, &rays),
        scene.min_t,
        EXACT_OBJECTS,
    );
    let plain = Caster::new(world.clone());
    let search = Search::cheaper(&world.parts);

    let all = castings
        .iter()
        .map(|(_, casting)| casting)
        .chain([&unwatched]);
    let planned =
        all.map(|casting| film(&rays, move |ray| casting.see(ray, &mut Tally::default())));
    let mut films: Vec<_> = planned.collect();
    films.push(film(&rays, |ray| {
        let found = plain.first::<Plain>(search, ray, scene.min_t, &mut Tally::default())?;
        Some((found.t, found.part.shape.normal(ray, found.t)))
    }));
    let times = race(films, rays.len(), share.seconds);
    let [.., exact_ids, plain] = times.as_slice() else {
        unreachable!("the last two are always there");
    };
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let tally = |(at, (wish, casting)): (usize, &(AccuracyTarget, PlannedCaster))| {
        let (kept, tally) = kept(&rays, &truths, casting, wish);
        PlanTally {
            scene: name.clone().into(),
            accuracy: wish.accuracy,
            kept,
            exact_hits: tally.exact_hits,
            nanoseconds: times[at].nanoseconds,
            exact_ids: exact_ids.nanoseconds,
            plain: plain.nanoseconds,
        }
    };
    Ok(castings.iter().enumerate().map(tally).collect())
}

/// Casts rays by a plan, and judges the result by the truth.
pub fn kept(
    rays: &[Ray<f64>],
    truths: &[TrueHit],
    casting: &PlannedCaster,
    wish: &AccuracyTarget,
) -> (PlanErrors, Tally) {
    let (seen, tally) = casting.film(rays);
    let mut kept = PlanErrors {
        rays: rays.len() as u64,
        ..PlanErrors::default()
    };
    for ((ray, truth), seen) in rays.iter().zip(truths).zip(seen) {
        match compared(truth, ray, seen) {
            HitComparison::Miss => (),
            HitComparison::AnotherObject => kept.wrong_ids += 1,
            HitComparison::Off { t, normal } => {
                let t = if wish.depth { t } else { 0.0 };
                let normal = if wish.normal { normal } else { 0.0 };
                kept.worst_t = kept.worst_t.max(t);
                kept.worst_normal = kept.worst_normal.max(normal);
                kept.violations += u64::from(!(t <= wish.accuracy && normal <= wish.accuracy));
            }
        }
    }
    (kept, tally)
}

/// A workload: each call casts all rays.
fn film<'a, T>(rays: &'a [Ray<f64>], see: impl Fn(&Ray<f64>) -> T + 'a) -> Workload<'a> {
    Box::new(move || {
        for ray in black_box(rays) {
            black_box(see(ray));
        }
    })
}
