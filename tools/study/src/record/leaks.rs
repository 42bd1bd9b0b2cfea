use rayon::prelude::*;

use super::Progress;
use crate::cast::model::Exact;
use crate::cast::world::{Primitive, World};
use crate::cast::{Caster, Search, Tally};
use crate::family::mesh::{Aim, Ball};
use crate::question::Data;
use crate::random::Random;

/// Rays from inside closed meshes, cast exactly, in boxes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Leaks {
    /// Cast.
    pub rays: u64,
    /// Met no triangle.
    pub leaks: u64,
    /// Tests that were decided in exact numbers: floats of twice the digits left them open.
    pub fallbacks: u64,
}

impl Leaks {
    fn plus(self, other: Leaks) -> Leaks {
        Leaks {
            rays: self.rays + other.rays,
            leaks: self.leaks + other.leaks,
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
            let met = caster.first::<Exact>(Search::Boxes, &ray, 0.0, &mut tally);
            counted.rays += 1;
            counted.leaks += u64::from(met.is_none());
            counted.fallbacks += tally.exact;
        }
    }
    counted
}
