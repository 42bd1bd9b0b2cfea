use rayon::prelude::*;

use super::Progress;
use crate::cast::model::{Exact, Model, Prepared};
use crate::cast::world::{Part, Primitive, World};
use crate::cast::{Caster, Found, Search, Tally};
use crate::family::mesh::{Aim, Ball};
use crate::kernel::Limits;
use crate::kernel::sphere::Scaled;
use crate::kernel::triangle::{Four, Met};
use crate::question::Data;
use crate::random::Random;
use crate::shape::Ray;

/// Rays from inside closed meshes, cast exactly, in boxes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Leaks {
    /// Cast.
    pub rays: u64,
    /// Met no triangle.
    pub leaks: u64,
    /// Met more than one.
    pub double_hits: u64,
    /// Tests that were decided in exact numbers: floats of twice the digits left them open.
    pub fallbacks: u64,
}

impl Leaks {
    fn plus(self, other: Leaks) -> Leaks {
        Leaks {
            rays: self.rays + other.rays,
            leaks: self.leaks + other.leaks,
            double_hits: self.double_hits + other.double_hits,
            fallbacks: self.fallbacks + other.fallbacks,
        }
    }
}

/// Rays at the edges of one mesh, and as many at its vertices.
const OF_A_MESH: u64 = 500;

/// So many rays at edges and as many at vertices.
pub fn leaks(rays: u64, seed: u64, done: &impl Progress) -> Leaks {
    let of_mesh = |mesh: u64| {
        let mut random = Random::new(seed ^ mesh.wrapping_mul(0x9e37_79b9_7f4a_7c15), "leaks");
        let counted = of_ball(&Ball::new(&mut random, Data::F64), &mut random);
        done(counted.rays);
        counted
    };
    (0..rays.div_ceil(OF_A_MESH))
        .into_par_iter()
        .map(of_mesh)
        .reduce(Leaks::default, Leaks::plus)
}

fn of_ball(ball: &Ball, random: &mut Random) -> Leaks {
    let mut world = World::default();
    for face in &ball.triangles {
        world.add(0, Primitive::Triangle(*face));
    }
    let caster = Caster::new(world);
    let mut counted = Leaks::default();
    for aim in Aim::BOTH {
        for _ in 0..OF_A_MESH {
            let (ray, mut tally) = (ball.ray(random, aim), Tally::default());
            let met = caster.first::<Every>(Search::Boxes, &ray, 0.0, &mut tally);
            counted.rays += 1;
            counted.leaks += u64::from(met.is_none());
            counted.double_hits += u64::from(tally.close_calls > 0);
            counted.fallbacks += tally.fallbacks;
        }
    }
    counted
}

/// Meets as [`Exact`] does, and looks into all boxes on the ray's way, however far: a hit
/// after the first is a close call.
struct Every;

impl Model for Every {
    const NAME: &'static str = "every hit";
    const SLACK: f64 = f64::INFINITY;
    type Ray = Prepared;

    fn prepare(ray: &Ray<f64>, world: &World) -> Prepared {
        Exact::prepare(ray, world)
    }

    fn prepare_scaled(ray: &Ray<f64>, scaled: &Scaled<f64>, min_t: f64, world: &World) -> Prepared {
        Exact::prepare_scaled(ray, scaled, min_t, world)
    }

    fn meet(shape: &Primitive, ray: &Prepared, min_t: f64, tally: &mut Tally) -> Option<f64> {
        Exact::meet(shape, ray, min_t, tally)
    }

    fn meet_part(part: &Part, ray: &Prepared, min_t: f64, tally: &mut Tally) -> Option<f64> {
        Exact::meet_part(part, ray, min_t, tally)
    }

    fn meet_four(four: &Four, limits: &Limits<f64>, ray: &Prepared, min_t: f64) -> Met {
        Exact::meet_four(four, limits, ray, min_t)
    }

    fn given(t: f64, ray: &Prepared) -> f64 {
        Exact::given(t, ray)
    }

    fn comes_first(_: &Found, _: &Found, _: &Ray<f64>, _: f64, tally: &mut Tally) -> bool {
        tally.close_calls += 1;
        false
    }
}
