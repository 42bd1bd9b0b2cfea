//! The long runs: whether exact casting is ever wrong, in as many rounds as one has time
//! for. `pinhole-study record` prints results to record in `tools/RECORDS.md`.
//!
//! Every answer is judged by the oracle, in fractions; that is what takes the time, about
//! ten times as much as is judged. A tie (tangent, on an edge, t = `min_t`) has no wrong
//! answer to random and adversarial questions; closed meshes ask edges and corners apart, and
//! of a plan every pixel has one right object.

pub mod scene;

use std::ops::Range;

use rayon::prelude::*;

use crate::cast::model::Exact;
use crate::cast::rays::rays;
use crate::cast::world::{Primitive, World};
use crate::cast::{Caster, Search, Tally};
use crate::contestant::Contestant;
use crate::contestants::{EXACT, HasKernels};
use crate::family::mesh::{Aim, Ball};
use crate::family::{HasFamilies, questions};
use crate::judge::judge;
use crate::oracle::scene::sight;
use crate::plan::plan;
use crate::plans::kept;
use crate::question::{Class, Data, Question};
use crate::random::Random;
use crate::shape::{Plane, Sphere, Triangle};

/// What is asked. A round of each depends on its number and the seed alone, so that a run can
/// go on where another ended.
#[derive(Clone, Copy, Debug, PartialEq, clap::ValueEnum)]
pub enum Kind {
    /// Everyday questions of all shapes and families, to the exact kernels and the caster.
    Random,
    /// The same of hard and absurd ones.
    Adversarial,
    /// Rays at the edges and the vertices of a closed mesh, to the caster.
    Edges,
    /// A plan of a random scene, at every pixel.
    Plans,
}

/// What came of some rounds.
#[derive(Clone, Debug, Default)]
pub struct Count {
    /// Questions, rays or pixels; ties of questions left out.
    pub asked: u64,
    /// Of them, those that truly hit something, where that is not all.
    pub hits: u64,
    /// Decided exactly, or, of plans, computed exactly.
    pub exact: u64,
    /// Wrong decisions, leaks, and pixels that broke a plan.
    pub wrong: u64,
    /// The rounds that these are in.
    pub broken: Vec<u64>,
}

impl Count {
    fn plus(mut self, other: Count) -> Count {
        self.broken.extend(other.broken);
        Count {
            asked: self.asked + other.asked,
            hits: self.hits + other.hits,
            exact: self.exact + other.exact,
            wrong: self.wrong + other.wrong,
            broken: self.broken,
        }
    }
}

/// Some rounds, on all cores.
pub fn record(kind: Kind, rounds: Range<u64>, seed: u64) -> Count {
    let of_round = |round: u64| {
        let seed = seed ^ round.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let count = match kind {
            Kind::Random | Kind::Adversarial => of_shape::<Sphere<f64>>(kind, seed)
                .plus(of_shape::<Plane<f64>>(kind, seed))
                .plus(of_shape::<Triangle<f64>>(kind, seed)),
            Kind::Edges => edges(seed),
            Kind::Plans => planned(seed),
        };
        let broken = (count.wrong > 0).then_some(round).into_iter().collect();
        Count { broken, ..count }
    };
    let counts = rounds.into_par_iter().map(of_round);
    counts.reduce(Count::default, Count::plus)
}

/// Asked of one family at one exponent in a round.
const BATCH: usize = 500;

fn of_shape<S: HasFamilies + Into<Primitive>>(kind: Kind, seed: u64) -> Count {
    let kernels = judged::<S>();
    let mut count = Count::default();
    for family in S::families() {
        for exponent in (family.exponents)(Data::F64) {
            if (family.class(exponent) == Class::Everyday) != (kind == Kind::Random) {
                continue;
            }
            let asked = questions(&family, exponent, Data::F64, BATCH, seed);
            let truths: Vec<_> = asked.iter().map(S::truth).collect();
            let tallies = kernels.map(|kernel| judge(&kernel, &asked, &truths));
            count.asked += tallies[0].asked;
            count.hits += tallies[0].hits;
            let wrong = tallies.iter().map(|it| it.wrong() + it.not_finite);
            count.wrong += wrong.sum::<u64>();
        }
    }
    count
}

/// The exact kernel, and the caster around it.
fn judged<S: HasKernels + Into<Primitive>>() -> [Contestant<S>; 2] {
    let kernels = S::contestants();
    let is_it = |k: &&Contestant<S>| k.name == EXACT && k.data == Data::F64;
    let kernel = *kernels.iter().find(is_it).expect("every shape has it");
    let answer = |question: &Question<S>| {
        let mut world = World::default();
        world.add(0, question.shape.into());
        let (caster, mut tally) = (Caster::new(world), Tally::default());
        let found = caster.first::<Exact>(Search::Boxes, &question.ray, question.min_t, &mut tally);
        found.map(|found| found.t)
    };
    [kernel, Contestant { answer, ..kernel }]
}

/// From inside one mesh.
fn edges(seed: u64) -> Count {
    let mut random = Random::new(seed, "leaks");
    let ball = Ball::new(&mut random, Data::F64);
    let mut world = World::default();
    for face in &ball.triangles {
        world.add(0, Primitive::Triangle(*face));
    }
    let caster = Caster::new(world);
    let mut count = Count::default();
    for aim in Aim::BOTH {
        for _ in 0..BATCH {
            let (ray, mut tally) = (ball.ray(&mut random, aim), Tally::default());
            let met = caster.first::<Exact>(Search::Boxes, &ray, 0.0, &mut tally);
            count.asked += 1;
            count.wrong += u64::from(met.is_none());
            count.exact += tally.exact;
        }
    }
    count
}

/// The judge computes in fractions and shares no code with what casts; only the scene's numbers
/// and the camera's rays, as rounded to `f64`, are given to both.
fn planned(seed: u64) -> Count {
    let (scene, wish) = scene::drawn(seed);
    let (world, rays) = (World::of(&scene.objects), rays(&scene));
    let truth = |ray| sight(&world.parts, ray, scene.min_t);
    let truths: Vec<_> = rays.iter().map(truth).collect();
    let (_, casting) = plan(&scene, wish).expect("no wish is as small as an ulp");
    let (kept, tally) = kept(&rays, &truths, &casting, &wish);
    Count {
        asked: kept.rays,
        hits: truths.iter().filter(|truth| truth.first.is_some()).count() as u64,
        exact: tally.exact_hits,
        wrong: kept.wrong_ids + kept.violations,
        broken: Vec::new(),
    }
}
