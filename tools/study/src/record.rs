//! The long runs: is exact casting ever wrong, in as many rounds as you have time for?
//! `pinhole-study record` prints results to record in `tools/RECORDS.md`.
//!
//! The oracle judges every answer with fractions, which takes about ten times as long as
//! computing it. In random and adversarial questions, a tie (tangent, on an edge, t = `min_t`)
//! has no wrong answer. Edges and corners are tested separately with closed meshes, and every
//! pixel of a plan has exactly one right object.

use std::ops::Range;

use rayon::prelude::*;

use crate::cast::world::{Primitive, World};
use crate::cast::{Tally, first_hit};
use crate::contestants::Contestant;
use crate::contestants::HasKernels;
use crate::family::{HasFamilies, questions, steps};
use crate::judge::judge;
use crate::leaks::{Aim, Ball};
use crate::plan::casting::PlannedCaster;
use crate::plans::kept;
use crate::question::{Class, Data, Question};
use crate::random::Random;
use crate::random_scene;
use crate::shape::{Plane, Sphere, Triangle};

/// What to ask. A round depends only on its number and the seed, so that a run can continue
/// where another ended.
#[derive(Clone, Copy, Debug, PartialEq, clap::ValueEnum)]
pub enum Kind {
    /// Everyday questions about all shapes, for the exact kernels and the caster.
    Random,
    /// Hard and absurd questions about all shapes, for the exact kernels and the caster.
    Adversarial,
    /// Rays aimed at the edges and the vertices of a closed mesh, for the caster.
    Edges,
    /// A plan of a random scene, judged at every pixel.
    Plans,
}

/// The result of some rounds.
#[derive(Clone, Debug, Default)]
pub struct Count {
    /// Questions, rays or pixels that were judged; ties of questions are left out.
    pub asked: u64,
    /// Those that truly hit something; 0 for closed meshes, where all do.
    pub hits: u64,
    /// For closed meshes, tests that were decided exactly; for plans, hits that were computed
    /// exactly; for questions, 0.
    pub exact: u64,
    /// Wrong decisions, leaks, and pixels that violate a plan.
    pub wrong: u64,
    /// The rounds with something wrong.
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

/// Runs some rounds, on all cores.
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

/// Questions of one family at one exponent in a round, and rays per aim at a mesh.
const BATCH: usize = 500;

fn of_shape<S: HasFamilies>(kind: Kind, seed: u64) -> Count {
    let kernels = judged::<S>();
    let mut count = Count::default();
    for (family, exponent) in steps(Data::F64) {
        if (family.class(exponent) == Class::Everyday) != (kind == Kind::Random) {
            continue;
        }
        let asked = questions(&family, exponent, Data::F64, BATCH, seed);
        let truths: Vec<_> = asked.iter().map(S::truth).collect();
        let tallies = kernels.map(|kernel| judge(&kernel, &asked, &truths).0);
        count.asked += tallies[0].asked;
        count.hits += tallies[0].hits;
        let wrong = tallies.iter().map(|it| it.wrong() + it.not_finite);
        count.wrong += wrong.sum::<u64>();
    }
    count
}

/// The exact kernel in `f64`, and the caster as a kernel.
fn judged<S: HasKernels>() -> [Contestant<S>; 2] {
    let (_, kernel) = S::exact_kernel();
    let answer = |question: &Question<S>| {
        let mut world = World::default();
        world.add(0, question.shape.into());
        let hit = first_hit(world, &question.ray, question.min_t, &mut Tally::default());
        hit.map(|(_, t)| t)
    };
    [kernel, Contestant { answer, ..kernel }]
}

/// Casts rays from inside one closed mesh.
fn edges(seed: u64) -> Count {
    let mut random = Random::new(seed, "leaks");
    let ball = Ball::new(&mut random, Data::F64);
    let mut world = World::default();
    for face in &ball.triangles {
        world.add(0, Primitive::Triangle(*face));
    }
    let mut count = Count::default();
    for aim in Aim::BOTH {
        for _ in 0..BATCH {
            let (ray, mut tally) = (ball.ray(&mut random, aim), Tally::default());
            let met = first_hit(world.clone(), &ray, 0.0, &mut tally);
            count.asked += 1;
            count.wrong += u64::from(met.is_none());
            count.exact += tally.exact;
        }
    }
    count
}

/// Casts a random scene by its plan. The judge computes with fractions and shares only its
/// input with the casters: the scene and the camera's rays, rounded to `f64`.
fn planned(seed: u64) -> Count {
    let (scene, accuracy) = random_scene::drawn(seed);
    let casting = PlannedCaster::new(&scene, accuracy).expect("an f64 can reach the accuracy");
    let truths = casting.truths();
    let (kept, tally) = kept(&casting, &truths);
    Count {
        asked: kept.rays,
        hits: truths.iter().flatten().count() as u64,
        exact: tally.exact_hits,
        wrong: kept.wrong_ids + kept.violations,
        broken: Vec::new(),
    }
}
