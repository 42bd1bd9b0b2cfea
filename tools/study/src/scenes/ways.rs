//! The ways a scene is cast: each set of kernels in each type of numbers, and both
//! searches.

use std::hint::black_box;

use crate::cast::chosen::Chosen;
use crate::cast::kernels::{Fastest, Kernels, Steadiest, Usual, UsualWidened};
use crate::cast::model::{Exact, Model, Plain};
use crate::cast::narrow::{Narrow, rounded};
use crate::cast::world::World;
use crate::cast::{Caster, Search, Tally};
use crate::shape::Ray;
use crate::speed::now;
use crate::vector::Vector;

/// A scene ready to be cast in either type of numbers, and its rays.
pub struct Stage {
    /// As it is.
    pub caster: Caster,
    narrow: Narrow,
    /// Of the parts, in the order in which they were given.
    objects: Vec<u32>,
    /// As the camera has them.
    pub rays: Vec<Ray<f64>>,
    narrow_rays: Vec<Ray<f32>>,
    min_t: f64,
}

/// What somebody says is seen: object, t and normal.
pub type Seen = Option<(u32, f64, Vector<f64>)>;

/// One way to cast a scene.
pub struct Way {
    /// What it computes with.
    pub numbers: &'static str,
    /// The set's name.
    pub kernels: &'static str,
    /// What is looked at.
    pub search: Search,
    /// What is seen along every ray.
    pub see: fn(&Stage, Search, &mut Tally) -> Vec<Seen>,
    /// CPU time of this thread for all rays, in nanoseconds for each.
    pub time: fn(&Stage, Search) -> f64,
}

/// All of them.
pub fn ways() -> Vec<Way> {
    let both = [Search::BruteForce, Search::Boxes];
    let of = |search| {
        [
            narrow::<Fastest>(search),
            narrow::<Usual>(search),
            narrow::<Steadiest>(search),
            narrow::<UsualWidened>(search),
            wide::<Chosen<Fastest>>("fastest", search),
            wide::<Plain>("usual", search),
            wide::<Chosen<Steadiest>>("steadiest", search),
            wide::<Exact>("adaptive", search),
        ]
    };
    both.into_iter().flat_map(of).collect()
}

impl Stage {
    /// Of a scene's parts and rays.
    pub fn new(world: World, rays: Vec<Ray<f64>>, min_t: f64) -> Stage {
        let objects = world.parts.iter().map(|part| part.object).collect();
        let caster = Caster::new(world);
        Stage {
            narrow: Narrow::new(caster.world.parts.iter()),
            caster,
            objects,
            narrow_rays: rays.iter().map(rounded).collect(),
            rays,
            min_t,
        }
    }
}

fn wide<M: Model>(kernels: &'static str, search: Search) -> Way {
    Way {
        numbers: M::NAME,
        kernels,
        search,
        see: |stage, search, tally| {
            let see = |ray| {
                let caster = &stage.caster;
                let found = caster.first::<M>(search, ray, stage.min_t, tally)?;
                let point = ray.origin + ray.direction * found.t;
                Some((found.part.object, found.t, found.part.shape.normal(point)))
            };
            stage.rays.iter().map(see).collect()
        },
        time: |stage, search| {
            timed(&stage.rays, |ray| {
                let caster = &stage.caster;
                caster
                    .first::<M>(search, ray, stage.min_t, &mut Tally::default())
                    .map(|found| found.t)
            })
        },
    }
}

fn narrow<K: Kernels<f32>>(search: Search) -> Way {
    Way {
        numbers: K::NUMBERS,
        kernels: K::NAME,
        search,
        see: |stage, search, _| {
            let see = |ray| {
                let near = stage.narrow.first::<K>(search, ray, stage.min_t as f32)?;
                let object = stage.objects[near.place as usize];
                Some((object, f64::from(near.t), near.normal(ray).map(f64::from)))
            };
            stage.narrow_rays.iter().map(see).collect()
        },
        time: |stage, search| {
            timed(&stage.narrow_rays, |ray| {
                let near = stage.narrow.first::<K>(search, ray, stage.min_t as f32);
                near.map(|near| near.t)
            })
        },
    }
}

#[inline(never)]
fn timed<R, T>(rays: &[R], mut first: impl FnMut(&R) -> Option<T>) -> f64 {
    let start = now();
    for ray in black_box(rays) {
        black_box(first(ray));
    }
    (now() - start).as_secs_f64() * 1e9 / rays.len() as f64
}

/// Nanoseconds for a ray by each way, which take turns: medians. Who is slow has fewer
/// turns, but three at least.
pub fn race(stage: &Stage, ways: &[Way], rounds: usize) -> Vec<f64> {
    let mut times = vec![Vec::new(); ways.len()];
    for round in 0..rounds {
        for (way, times) in ways.iter().zip(&mut times) {
            let so_far = times.iter().sum::<f64>() * stage.rays.len() as f64;
            if round < 3 || so_far < PATIENCE {
                times.push((way.time)(stage, way.search));
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
