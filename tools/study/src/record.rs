//! The long runs: whether exact casting is ever wrong, in as many rays as one has time
//! for. `study record` prints results to record in `tools/RECORDS.md`.
//!
//! Every answer is judged by the oracle, in fractions; that is what takes the time, about
//! ten times as much as is judged. A tie (tangent, on an edge, t = `min_t`) has no wrong
//! answer here; closed meshes ask edges and corners apart.

mod cameras;
mod leaks;
mod plans;

pub use cameras::{Camera, cameras};
pub use leaks::{Leaks, leaks};
pub use plans::{Plans, plans};

use rayon::prelude::*;

use crate::cast::model::Exact;
use crate::cast::world::{Primitive, World};
use crate::cast::{Caster, Search, Tally};
use crate::contestant::Contestant;
use crate::contestants::Contested;
use crate::family::{Studied, questions};
use crate::judge::judge;
use crate::question::{Class, Data, Question};
use crate::shape::{Plane, Sphere, Triangle};

/// Questions asked, and decisions that were wrong.
#[derive(Clone, Copy, Debug, Default)]
pub struct Count {
    /// Ties left out.
    pub asked: u64,
    /// By the kernel, or by the caster in boxes.
    pub wrong: u64,
}

impl Count {
    fn plus(self, other: Count) -> Count {
        Count {
            asked: self.asked + other.asked,
            wrong: self.wrong + other.wrong,
        }
    }
}

/// How hard questions are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hardness {
    /// Everyday ones.
    Random,
    /// Hard and absurd ones.
    Adversarial,
}

/// Told how many questions or rays more are done, by any thread.
pub trait Progress: Fn(u64) + Sync {}

impl<F: Fn(u64) + Sync> Progress for F {}

/// Asked at a time, of one family at one exponent.
const BATCH: usize = 500;

/// At least so many questions of all shapes and families in `f64`, to the adaptive kernels
/// and to the exact caster.
pub fn decisions(hardness: Hardness, at_least: u64, seed: u64, done: &impl Progress) -> Count {
    let batches = batches::<Sphere<f64>>(hardness).len()
        + batches::<Plane<f64>>(hardness).len()
        + batches::<Triangle<f64>>(hardness).len();
    let rounds = at_least.div_ceil((batches * BATCH) as u64);
    of_shape::<Sphere<f64>>(hardness, rounds, seed, done)
        .plus(of_shape::<Plane<f64>>(hardness, rounds, seed, done))
        .plus(of_shape::<Triangle<f64>>(hardness, rounds, seed, done))
}

/// The families, by their place, and exponents.
fn batches<S: Studied>(hardness: Hardness) -> Vec<(usize, i32)> {
    let of_family = |(at, family): (usize, &crate::family::Family<S>)| {
        let is_everyday = |x: i32| family.class(x) == Class::Everyday;
        let is_wanted = |x: &i32| is_everyday(*x) == (hardness == Hardness::Random);
        let mut exponents = (family.exponents)(Data::F64);
        exponents.retain(is_wanted);
        exponents
            .into_iter()
            .map(move |x| (at, x))
            .collect::<Vec<_>>()
    };
    S::families()
        .iter()
        .enumerate()
        .flat_map(of_family)
        .collect()
}

fn of_shape<S: Studied + Into<Primitive>>(
    hardness: Hardness,
    rounds: u64,
    seed: u64,
    done: &impl Progress,
) -> Count {
    let kernels = judged::<S>();
    let families = S::families();
    let batches = batches::<S>(hardness);
    let of_round = |round: u64| {
        let of_batch = |(family, exponent): &(usize, i32)| {
            let seed = seed.wrapping_add(round.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let asked = questions(&families[*family], *exponent, Data::F64, BATCH, seed);
            let truths: Vec<_> = asked.iter().map(S::truth).collect();
            let tallies = kernels.iter().map(|kernel| judge(kernel, &asked, &truths));
            let tallies: Vec<_> = tallies.collect();
            done(BATCH as u64);
            Count {
                asked: tallies[0].asked,
                wrong: tallies
                    .iter()
                    .map(|tally| tally.wrong() + tally.not_finite)
                    .sum(),
            }
        };
        batches
            .iter()
            .map(of_batch)
            .fold(Count::default(), Count::plus)
    };
    (0..rounds)
        .into_par_iter()
        .map(of_round)
        .reduce(Count::default, Count::plus)
}

/// The adaptive kernel, and the caster around it.
fn judged<S: Contested + Into<Primitive>>() -> [Contestant<S>; 2] {
    let kernels = S::contestants();
    let is_it = |k: &&Contestant<S>| k.name == "adaptive exact" && k.numbers == "f64";
    let kernel = *kernels.iter().find(is_it).expect("every shape has it");
    let answer = |question: &Question<S>| {
        let mut world = World::default();
        world.add(0, question.shape.into());
        let (caster, mut tally) = (Caster::new(world), Tally::default());
        let found = caster.first::<Exact>(Search::Boxes, &question.ray, question.min_t, &mut tally);
        found.map(|found| found.t)
    };
    let caster = Contestant {
        name: "exact caster",
        answer,
        ..kernel
    };
    [kernel, caster]
}
