//! Plans for every scene and several accuracies: does each meet what was wished at every
//! pixel, and what does it cost beside the most and the least accurate way?

use std::hint::black_box;
use std::path::Path;

use rayon::prelude::*;

use crate::cast::kernels::Fastest;
use crate::cast::narrow::{Narrow, rounded};
use crate::cast::rays::rays;
use crate::cast::world::World;
use crate::oracle::scene::sight;
use crate::plan::casting::{Casting, How, Spent};
use crate::plan::sample::{Sample, confirm};
use crate::plan::{Kind, Numbers, Wish, crossover, planned};
use crate::result::PlanTally;
use crate::scenes::{self, Share};
use crate::shape::Ray;
use crate::speed::now;

/// What is wished, one after another.
pub const ACCURACIES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Plans for a scene with every wish, judged at a share of its pixels.
pub fn studied(file: &Path, share: Share, accuracies: &[f64]) -> Result<Vec<PlanTally>, String> {
    let scene = scenes::read(file).map_err(|error| error.to_string())?;
    let world = World::of(&scene.objects);
    let all = rays(&scene);
    let sample = Sample::of(&world, &all, scene.min_t);
    let rays: Vec<_> = all.iter().copied().step_by(share.step).collect();
    let truth = |ray| sight(&world.parts, ray, scene.min_t);
    let truths: Vec<_> = rays.par_iter().map(truth).collect();

    let wish = |accuracy, exact_ids| Wish {
        accuracy,
        exact_ids,
        depth: true,
        normal: true,
    };
    let mut plans = Vec::new();
    for (accuracy, exact_ids) in accuracies.iter().flat_map(|x| [(*x, false), (*x, true)]) {
        plans.push(planned(
            &scene,
            &world,
            &sample,
            all.len(),
            wish(accuracy, exact_ids),
        )?);
    }
    let count = |kind| {
        let parts = world.parts.iter();
        parts.filter(|part| Kind::of(&part.shape) == kind).count()
    };
    let search = |numbers| crossover::search(count(Kind::Sphere), count(Kind::Triangle), numbers);
    let most = Casting::new(
        &world,
        scene.min_t,
        How {
            wish: wish(accuracies[0], true),
            numbers: [(Numbers::Exact, false); 3],
            narrow: search(Numbers::F32),
            wide: search(Numbers::Exact),
        },
    );
    let narrow = Narrow::new(world.parts.iter());
    let narrow_search = search(Numbers::F32);
    let least = |ray: &Ray<f64>| {
        let ray = rounded(ray);
        let near = narrow.first::<Fastest>(narrow_search, &ray, scene.min_t as f32)?;
        Some((near.t, near.normal(&ray)))
    };

    let mut times = vec![Vec::new(); plans.len() + 2];
    for _ in 0..share.rounds {
        for ((_, casting), times) in plans.iter().zip(&mut times) {
            times.push(timed(&rays, |ray| casting.see(ray, &mut Spent::default())));
        }
        times[plans.len()].push(timed(&rays, |ray| most.see(ray, &mut Spent::default())));
        times[plans.len() + 1].push(timed(&rays, least));
    }
    let medians: Vec<f64> = times
        .into_iter()
        .map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect();
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let tally = |(at, (plan, casting)): (usize, &(crate::plan::Plan, Casting))| {
        let confirmed = confirm(&rays, &truths, casting, &plan.wish);
        PlanTally {
            scene: name.clone().into(),
            accuracy: plan.wish.accuracy,
            exact_ids: plan.wish.exact_ids,
            choice: plan.short(),
            rays: confirmed.rays,
            violations: confirmed.violations.iter().sum(),
            wrong_ids: confirmed.wrong_ids,
            worst_t: confirmed.worst_t,
            worst_normal: confirmed.worst_normal,
            again_in_f64: confirmed.spent.again_in_f64,
            again_exactly: confirmed.spent.again_exactly,
            nanoseconds: medians[at],
            most_accurate: medians[plans.len()],
            least_accurate: medians[plans.len() + 1],
        }
    };
    Ok(plans.iter().enumerate().map(tally).collect())
}

#[inline(never)]
fn timed<T>(rays: &[Ray<f64>], mut see: impl FnMut(&Ray<f64>) -> T) -> f64 {
    let start = now();
    for ray in black_box(rays) {
        black_box(see(ray));
    }
    (now() - start).as_secs_f64() * 1e9 / rays.len() as f64
}
