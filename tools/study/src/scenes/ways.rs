//! The ways a scene is cast: plainly in `f64` and exactly, by both searches.

use std::hint::black_box;

use crate::cast::model::{Exact, Model, Plain};
use crate::cast::world::World;
use crate::cast::{Caster, Search, Tally};
use crate::shape::Ray;
use crate::speed::now;
use crate::vector::Vector;

/// A scene ready to be cast, and its rays.
pub struct Stage {
    /// As it is.
    pub caster: Caster,
    /// As the camera has them.
    pub rays: Vec<Ray<f64>>,
    min_t: f64,
}

/// What somebody says is seen: object, t and normal.
pub type Seen = Option<(u32, f64, Vector<f64>)>;

/// One way to cast a scene.
pub struct Way {
    /// What it computes with.
    pub numbers: &'static str,
    /// What is looked at.
    pub search: Search,
    /// What is seen along every ray.
    pub see: fn(&Stage, Search, &mut Tally) -> Vec<Seen>,
    /// Casts all rays. It asks no clock: rustix's cannot be asked under valgrind.
    pub film: fn(&Stage, Search),
}

/// All of them.
pub fn ways() -> Vec<Way> {
    let of = |search| [way::<Plain>(search), way::<Exact>(search)];
    [Search::BruteForce, Search::Boxes]
        .into_iter()
        .flat_map(of)
        .collect()
}

impl Stage {
    /// Of a scene's parts and rays.
    pub fn new(world: World, rays: Vec<Ray<f64>>, min_t: f64) -> Stage {
        Stage {
            caster: Caster::new(world),
            rays,
            min_t,
        }
    }
}

fn way<M: Model>(search: Search) -> Way {
    Way {
        numbers: M::NAME,
        search,
        see: |stage, search, tally| {
            let see = |ray| {
                let caster = &stage.caster;
                let found = caster.first::<M>(search, ray, stage.min_t, tally)?;
                let normal = found.part.shape.normal(ray, found.t);
                Some((found.part.object, found.t, normal))
            };
            stage.rays.iter().map(see).collect()
        },
        film: |stage, search| {
            let first = |ray: &Ray<f64>| {
                let (caster, mut tally) = (&stage.caster, Tally::default());
                caster
                    .first::<M>(search, ray, stage.min_t, &mut tally)
                    .map(|found| found.t)
            };
            cast(&stage.rays, first);
        },
    }
}

#[inline(never)]
fn cast(rays: &[Ray<f64>], mut first: impl FnMut(&Ray<f64>) -> Option<f64>) {
    for ray in black_box(rays) {
        black_box(first(ray));
    }
}

/// Nanoseconds for a ray by each way, which take turns: medians. Who is slow has fewer
/// turns, but three at least.
pub fn race(stage: &Stage, ways: &[Way], rounds: usize) -> Vec<f64> {
    let mut times = vec![Vec::new(); ways.len()];
    for round in 0..rounds {
        for (way, times) in ways.iter().zip(&mut times) {
            let so_far = times.iter().sum::<f64>() * stage.rays.len() as f64;
            if round < 3 || so_far < PATIENCE {
                let start = now();
                (way.film)(stage, way.search);
                let spent = (now() - start).as_secs_f64() * 1e9;
                times.push(spent / stage.rays.len() as f64);
            }
        }
    }
    let median = |mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    times.into_iter().map(median).collect()
}

/// Nanoseconds.
const PATIENCE: f64 = 1e9;
