//! Which search is cheaper: measured, and kept here. (Whether `f32` is cheaper depends on
//! more than a count, and is raced on a scene's own rays: [`super::sample`].)
//!
//! Made scenes of 1 to 512 balls or triangles that fill the same ball are cast in every
//! way. `cargo pinhole study --only crossover` measures again and prints the
//! figures below beside its own.

use crate::cast::Search;
use crate::cast::kernels::Usual;
use crate::cast::model::{Exact, Model, Plain};
use crate::cast::narrow::{Narrow, rounded};
use crate::cast::world::{Primitive, World};
use crate::cast::{Caster, Tally};
use crate::random::Random;
use crate::result::CrossoverTally;
use crate::shape::{Ray, Sphere, Triangle};
use crate::speed::now;
use crate::vector::Vector;

use super::{Kind, Numbers};

/// From how many parts on boxes are cheaper than asking every part.
pub fn boxes_from(kind: Kind, numbers: Numbers) -> usize {
    match (kind, numbers) {
        (Kind::Plane, _) => usize::MAX,
        (Kind::Sphere, Numbers::F32) => 350,
        (Kind::Sphere, Numbers::F64) => 9,
        (Kind::Sphere, Numbers::Exact) => 8,
        (Kind::Triangle, Numbers::F32) => 250,
        (Kind::Triangle, Numbers::F64) => 5,
        (Kind::Triangle, Numbers::Exact) => 6,
    }
}

/// The cheaper search for so many spheres and triangles: both take their share of what a
/// tree costs.
pub fn search(spheres: usize, triangles: usize, numbers: Numbers) -> Search {
    let share = |count: usize, kind| count as f64 / boxes_from(kind, numbers) as f64;
    match share(spheres, Kind::Sphere) + share(triangles, Kind::Triangle) >= 1.0 {
        true => Search::Boxes,
        false => Search::BruteForce,
    }
}

/// How many parts the made scenes have.
pub const COUNTS: [usize; 17] = [
    1, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 144, 192, 256, 384, 512,
];

/// Nanoseconds for a ray in made scenes, by both searches in all numbers.
pub fn measured(rounds: usize) -> Vec<CrossoverTally> {
    let mut tallies = Vec::new();
    for kind in [Kind::Sphere, Kind::Triangle] {
        for count in COUNTS {
            let (world, rays) = made(kind, count);
            let caster = Caster::new(world);
            let narrow = Narrow::new(caster.world.parts.iter());
            let narrow_rays: Vec<_> = rays.iter().map(rounded).collect();
            let mut times = vec![Vec::new(); 6];
            for _ in 0..rounds {
                for (at, search) in [Search::BruteForce, Search::Boxes].into_iter().enumerate() {
                    times[at].push(timed(&narrow_rays, |ray| {
                        narrow.first::<Usual>(search, ray, 0.0).is_some()
                    }));
                    times[2 + at].push(wide::<Plain>(&caster, search, &rays));
                    times[4 + at].push(wide::<Exact>(&caster, search, &rays));
                }
            }
            let mut medians = times.into_iter().map(|mut times| {
                times.sort_by(f64::total_cmp);
                times[times.len() / 2]
            });
            for numbers in [Numbers::F32, Numbers::F64, Numbers::Exact] {
                let mut next = || medians.next().expect("two for each");
                tallies.push(CrossoverTally {
                    shape: kind.name().into(),
                    numbers: numbers.name().into(),
                    parts: count as u64,
                    brute_force: next(),
                    boxes: next(),
                });
            }
        }
    }
    tallies
}

fn wide<M: Model>(caster: &Caster, search: Search, rays: &[Ray<f64>]) -> f64 {
    timed(rays, |ray| {
        caster
            .first::<M>(search, ray, 0.0, &mut Tally::default())
            .is_some()
    })
}

fn timed<R>(rays: &[R], mut first: impl FnMut(&R) -> bool) -> f64 {
    let start = now();
    std::hint::black_box(rays.iter().filter(|ray| first(ray)).count());
    (now() - start).as_secs_f64() * 1e9 / rays.len() as f64
}

/// Parts in a unit ball, smaller the more there are, and rays from outside at it.
fn made(kind: Kind, count: usize) -> (World, Vec<Ray<f64>>) {
    let mut random = Random::new(count as u64, kind.name());
    let size = 0.7 / (count as f64).sqrt();
    let mut world = World::default();
    for object in 0..count {
        let at = random.unit() * random.within(0.0, 1.0 - size);
        let shape = match kind {
            Kind::Triangle => Primitive::Triangle(Triangle {
                corners: [0; 3].map(|_| at + random.unit() * size),
            }),
            _ => Primitive::Sphere(Sphere {
                center: at,
                radius: size,
            }),
        };
        world.add(object, shape);
    }
    let origin = Vector::new(0.5, 1.0, 4.0);
    let ray = |_| {
        let target = random.unit() * random.within(0.0, 1.0);
        Ray {
            origin,
            direction: target - origin,
        }
    };
    (world, (0..4096).map(ray).collect())
}
