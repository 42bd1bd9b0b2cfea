//! Plans for every scene and several accuracies: does each meet what was wished at every
//! pixel, and what does it cost beside exact objects alone and beside plain `f64`?

use std::hint::black_box;
use std::path::Path;

use rayon::prelude::*;

use crate::cast::model::Plain;
use crate::cast::rays::rays;
use crate::cast::world::World;
use crate::cast::{Caster, Search, Tally};
use crate::oracle::scene::{Compared, Sight, sight};
use crate::plan::casting::Casting;
use crate::plan::{Wish, plan};
use crate::result::{Kept, PlanTally};
use crate::scenes::{self, Share};
use crate::shape::Ray;
use crate::speed::now;

/// What is wished, one after another.
pub const ACCURACIES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Plans for a scene with every wish, judged at a share of its pixels.
pub fn studied(file: &Path, share: Share, accuracies: &[f64]) -> Result<Vec<PlanTally>, String> {
    let scene = scenes::read(file).map_err(|error| error.to_string())?;
    let world = World::of(&scene.objects);
    let rays: Vec<_> = rays(&scene).into_iter().step_by(share.step).collect();
    let truth = |ray| sight(&world.parts, ray, scene.min_t);
    let truths: Vec<_> = rays.par_iter().map(truth).collect();
    let everything = |accuracy| Wish {
        accuracy,
        depth: true,
        normal: true,
    };
    let mut castings = Vec::new();
    for accuracy in accuracies {
        castings.push((
            everything(*accuracy),
            plan(&scene, everything(*accuracy))?.1,
        ));
    }
    let unwatched = Casting::new(world.clone(), scene.min_t, everything(f64::INFINITY));
    let plain = Caster::new(world.clone());
    let search = Search::cheaper(&world.parts);

    let mut times = vec![Vec::new(); castings.len() + 2];
    for _ in 0..share.rounds {
        let see = |casting: &Casting| timed(&rays, |ray| casting.see(ray, &mut Tally::default()));
        for ((_, casting), times) in castings.iter().zip(&mut times) {
            times.push(see(casting));
        }
        times[castings.len()].push(see(&unwatched));
        times[castings.len() + 1].push(timed(&rays, |ray| {
            let found = plain.first::<Plain>(search, ray, scene.min_t, &mut Tally::default())?;
            Some((found.t, found.part.shape.normal(ray, found.t)))
        }));
    }
    let medians: Vec<f64> = times
        .into_iter()
        .map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect();
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let tally = |(at, (wish, casting)): (usize, &(Wish, Casting))| {
        let (kept, tally) = kept(&rays, &truths, casting, wish);
        PlanTally {
            scene: name.clone().into(),
            accuracy: wish.accuracy,
            kept,
            exact_hits: tally.exact_hits,
            nanoseconds: medians[at],
            exact_ids: medians[castings.len()],
            plain: medians[castings.len() + 1],
        }
    };
    Ok(castings.iter().enumerate().map(tally).collect())
}

/// Casts rays as planned, and judges what is seen by what is true. What is truly first is
/// first, edges included, and of what is met together the object listed first: nothing else
/// is right.
pub fn kept(rays: &[Ray<f64>], truths: &[Sight], casting: &Casting, wish: &Wish) -> (Kept, Tally) {
    let (seen, tally) = casting.film(rays);
    let mut kept = Kept {
        rays: rays.len() as u64,
        ..Kept::default()
    };
    for ((ray, truth), seen) in rays.iter().zip(truths).zip(seen) {
        let first = truth.first.as_ref().map(|(part, _)| part.object);
        if first != seen.map(|(object, ..)| object) {
            kept.wrong_ids += 1;
        } else if let Compared::Off { t, normal, .. } = truth.compared(ray, seen) {
            let t = if wish.depth { t } else { 0.0 };
            let normal = if wish.normal { normal } else { 0.0 };
            kept.worst_t = kept.worst_t.max(t);
            kept.worst_normal = kept.worst_normal.max(normal);
            kept.violations += u64::from(!(t <= wish.accuracy && normal <= wish.accuracy));
        }
    }
    (kept, tally)
}

#[inline(never)]
fn timed<T>(rays: &[Ray<f64>], mut see: impl FnMut(&Ray<f64>) -> T) -> f64 {
    let start = now();
    for ray in black_box(rays) {
        black_box(see(ray));
    }
    (now() - start).as_secs_f64() * 1e9 / rays.len() as f64
}
