//! Questions meant to tell two programs apart: random ones of every kind the probes
//! know, and ones on small whole numbers, where exact ties abound and whole-number
//! arithmetic says which questions are ties.
//!
//! A tie is a question whose answer hangs on one comparison of equals: t exactly
//! `min_t`, a ray exactly tangent to a sphere or exactly through an edge of a triangle,
//! two objects at the same t. Goldens in 32-bit floats cannot judge those, and do not.

mod random;
mod whole;

use pinhole::job::Job;
use pinhole::kind::{CameraQuestion, Questions, ShapeQuestion};
use pinhole::{Kind, ShapeKind};

use pinhole_course::assignment::Task;
use random::Random;

/// Questions, and which of them are ties.
pub struct Asked {
    /// The questions.
    pub job: Job,
    /// In the job's order.
    pub is_tie: Vec<bool>,
}

/// Of each kind, random and whole.
const COUNT: usize = 100_000;

/// Questions for this task.
///
/// # Panics
/// If there are none for its shape.
pub fn ask(task: &Task) -> Asked {
    let (questions, is_tie) = match task.kind {
        Kind::ViewingRay => {
            let mut random = Random::new();
            let questions: Vec<CameraQuestion> = (0..COUNT).map(|_| random.camera()).collect();
            let is_tie = vec![false; questions.len()];
            (Questions::ViewingRay(questions), is_tie)
        }
        Kind::Intersect => {
            let (questions, is_tie) = shapes(task.shape);
            (Questions::Intersect(questions), is_tie)
        }
        Kind::FirstHit => {
            let (questions, is_tie) = both(Random::objects, whole::objects);
            (Questions::FirstHit(questions), is_tie)
        }
        Kind::Soup => {
            let (questions, is_tie) = both(Random::soup, whole::soup);
            (Questions::Soup(questions), is_tie)
        }
    };
    Asked {
        job: Job::Ask(questions),
        is_tie,
    }
}

fn shapes(shape: Option<ShapeKind>) -> (Vec<ShapeQuestion>, Vec<bool>) {
    match shape {
        Some(ShapeKind::Sphere) => both(Random::sphere, whole::sphere),
        Some(ShapeKind::Plane) => both(Random::plane, whole::plane),
        Some(ShapeKind::Triangle) => both(Random::triangle, whole::triangle),
        Some(ShapeKind::Disk) => both(Random::disk, whole::disk),
        other => panic!("nobody knows what to ask of {other:?}"),
    }
}

type AnyOf<Q> = fn(&mut Random) -> Q;
type WholeOf<Q> = fn(&mut Random) -> (Q, bool);

fn both<Q>(any: AnyOf<Q>, whole: WholeOf<Q>) -> (Vec<Q>, Vec<bool>) {
    let mut random = Random::new();
    let mut questions: Vec<(Q, bool)> = (0..COUNT).map(|_| (any(&mut random), false)).collect();
    questions.extend((0..COUNT).map(|_| whole(&mut random)));
    questions.into_iter().unzip()
}
