//! A sample of a scene's rays, and what is true of them: by it a plan is confirmed, or not.

use std::hint::black_box;

use rayon::prelude::*;
use serde::Serialize;

use super::casting::{Casting, Spent};
use super::{Kind, Wish};
use crate::cast::world::World;
use crate::oracle::scene::{Compared, Sight, sight};
use crate::shape::Ray;
use crate::speed::now;

/// How many rays are judged by the oracle, which takes most of a plan's time.
const RAYS: usize = 384;

/// Of a race.
const ROUNDS: usize = 21;

/// Rays and their truths.
pub struct Sample<'a> {
    /// Spread over the picture.
    pub rays: Vec<Ray<f64>>,
    truths: Vec<Sight<'a>>,
}

/// What the oracle says of a plan.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Confirmed {
    /// Rays that were judged.
    pub rays: u64,
    /// Whose object is not the one truly seen.
    pub wrong_ids: u64,
    /// Where t or the normal is off by more than is wished, by kind of shape: spheres,
    /// planes, triangles.
    pub violations: [u64; 3],
    /// The largest relative error of t.
    pub worst_t: f64,
    /// The largest angle between a normal and the true one, in radians.
    pub worst_normal: f64,
    /// Who had the last word.
    #[serde(flatten)]
    pub spent: Spent,
}

impl<'a> Sample<'a> {
    /// Of a scene's rays. Steps by the golden ratio spread evenly over rows and columns
    /// alike, whatever their number (Weyl, *Math. Ann.* 77, 1916).
    pub fn of(world: &'a World, rays: &[Ray<f64>], min_t: f64) -> Sample<'a> {
        let count = RAYS.min(rays.len());
        let place = |at: usize| (at as f64 * 0.618_033_988_749_895).fract() * rays.len() as f64;
        let rays: Vec<_> = match count == rays.len() {
            true => rays.to_vec(),
            false => (0..count).map(|at| rays[place(at) as usize]).collect(),
        };
        let truth = |ray| sight(&world.parts, ray, min_t);
        Sample {
            truths: rays.par_iter().map(truth).collect(),
            rays,
        }
    }

    /// Nanoseconds for a ray of the sample: both take turns, and medians count.
    pub fn race(&self, castings: [&Casting; 2]) -> [f64; 2] {
        let mut times = [Vec::new(), Vec::new()];
        for _ in 0..ROUNDS {
            for (casting, times) in castings.iter().zip(&mut times) {
                let start = now();
                for ray in black_box(&self.rays) {
                    black_box(casting.see(ray, &mut Spent::default()));
                }
                times.push((now() - start).as_secs_f64() * 1e9);
            }
        }
        times.map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2] / self.rays.len() as f64
        })
    }

    /// Casts the sample as planned, and judges it.
    pub fn confirm(&self, casting: &Casting, wish: &Wish) -> Confirmed {
        confirm(&self.rays, &self.truths, casting, wish)
    }
}

/// Casts rays as planned, and judges what is seen by what is true.
pub fn confirm(rays: &[Ray<f64>], truths: &[Sight], casting: &Casting, wish: &Wish) -> Confirmed {
    let (seen, spent) = casting.film(rays);
    let mut confirmed = Confirmed {
        rays: rays.len() as u64,
        spent,
        ..Confirmed::default()
    };
    for ((ray, truth), seen) in rays.iter().zip(truths).zip(seen) {
        match truth.compared(ray, seen) {
            Compared::Alike => (),
            Compared::AnotherObject => confirmed.wrong_ids += 1,
            Compared::Off { part, t, normal } => {
                let t = if wish.depth { t } else { 0.0 };
                let normal = if wish.normal { normal } else { 0.0 };
                confirmed.worst_t = confirmed.worst_t.max(t);
                confirmed.worst_normal = confirmed.worst_normal.max(normal);
                let is_met = t <= wish.accuracy && normal <= wish.accuracy;
                confirmed.violations[Kind::of(&part.shape) as usize] += u64::from(!is_met);
            }
        }
    }
    confirmed
}
