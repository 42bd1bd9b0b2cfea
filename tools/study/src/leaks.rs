//! Leaks and double hits: from inside a closed mesh, a ray meets the surface exactly once.

use crate::contestant::Contestant;
use crate::family::mesh::{Aim, Inside, inside};
use crate::question::Data;
use crate::random::Random;
use crate::result::MeshTally;
use crate::shape::Triangle;
use crate::theirs::{self, Theirs};

/// One kernel on rays at edges or vertices.
pub fn of_kernel(
    kernel: &Contestant<Triangle<f64>>,
    aim: Aim,
    rays: usize,
    seed: u64,
) -> MeshTally {
    let met = |inside: &Inside| {
        let faces = inside.triangles.iter();
        let answers = faces.map(|face| (kernel.answer)(&inside.question(*face)));
        Some(answers.flatten().count())
    };
    let counted = counted(rays_at(aim, kernel.data, seed).take(rays), met);
    named(kernel.name, kernel.numbers, aim, counted)
}

/// A student's triangles, if they said anything.
pub fn of(theirs: &Theirs, aim: Aim, seed: u64) -> Option<MeshTally> {
    let mut told = theirs.mesh(aim)?;
    let met = |inside: &Inside| {
        let answers = told.next(inside.triangles.len()).into_iter();
        let answers: Option<Vec<_>> = answers.collect();
        Some(answers?.into_iter().flatten().count())
    };
    let rays = rays_at(aim, theirs::DATA, seed).take(theirs::MESH_RAYS);
    let counted = counted(rays, met);
    Some(named(theirs::NAME, theirs::DATA.name(), aim, counted))
}

/// The same for everybody who is asked in these numbers.
pub fn rays_at(aim: Aim, data: Data, seed: u64) -> impl Iterator<Item = Inside> {
    let mut random = Random::new(seed, &format!("mesh {aim:?} {}", data.name()));
    std::iter::repeat_with(move || inside(&mut random, aim, data))
}

/// Rays, leaks and double hits, by how many faces each ray `met`; what has no answer does
/// not count.
fn counted(
    rays: impl Iterator<Item = Inside>,
    mut met: impl FnMut(&Inside) -> Option<usize>,
) -> [u64; 3] {
    let [mut asked, mut leaks, mut double_hits] = [0; 3];
    for count in rays.filter_map(|inside| met(&inside)) {
        asked += 1;
        leaks += u64::from(count == 0);
        double_hits += u64::from(count > 1);
    }
    [asked, leaks, double_hits]
}

fn named(kernel: &str, numbers: &str, aim: Aim, [rays, leaks, double_hits]: [u64; 3]) -> MeshTally {
    MeshTally {
        kernel: kernel.into(),
        numbers: numbers.into(),
        aimed_at: if aim == Aim::Edge { "edge" } else { "vertex" }.into(),
        rays,
        leaks,
        double_hits,
    }
}
