//! Counts leaks and double hits: from inside a closed mesh, a ray should hit the surface
//! exactly once.

use crate::contestant::Contestant;
use crate::family::mesh::{Aim, Ball};
use crate::question::Question;
use crate::random::Random;
use crate::result::MeshTally;
use crate::shape::Triangle;

/// Casts rays at edges or vertices with one kernel. The rays are the same for all kernels with
/// the same type of data.
pub fn of_kernel(
    kernel: &Contestant<Triangle<f64>>,
    aim: Aim,
    rays: usize,
    seed: u64,
) -> MeshTally {
    let mut random = Random::new(seed, &format!("mesh {aim:?} {}", kernel.data.name()));
    let mut tally = MeshTally {
        kernel: kernel.name,
        numbers: kernel.numbers,
        aimed_at: if aim == Aim::Edge { "edge" } else { "vertex" },
        rays: rays as u64,
        leaks: 0,
        double_hits: 0,
    };
    for _ in 0..rays {
        let ball = Ball::new(&mut random, kernel.data);
        let ray = ball.ray(&mut random, aim);
        let question = |face: &Triangle<f64>| Question::new(*face, ray.origin, ray.direction);
        let asked = ball.triangles.iter().map(question);
        let met = asked.filter_map(|asked| (kernel.answer)(&asked)).count();
        tally.leaks += u64::from(met == 0);
        tally.double_hits += u64::from(met > 1);
    }
    tally
}
