//! Questions meant to tell two programs apart: random ones of every kind the probes
//! know, and ones on small whole numbers, where exact ties abound and whole-number
//! arithmetic says which questions are ties.
//!
//! A tie is a question whose answer hangs on one comparison of equals: t exactly
//! `min_t`, a ray exactly tangent to a sphere or exactly through an edge of a triangle,
//! two objects at the same t. Goldens in 32-bit floats cannot judge those, and do not.

mod random;
mod whole;

use pinhole::job::{CameraQuestion, Job, ShapeQuestion};

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
/// If no such task is known, as with a probe of it.
pub fn ask(task: &str) -> Asked {
    let mut random = Random::new();
    match task {
        "viewing_ray" => {
            let questions: Vec<CameraQuestion> = (0..COUNT).map(|_| random.camera()).collect();
            Asked {
                is_tie: vec![false; questions.len()],
                job: Job::ViewingRay(questions),
            }
        }
        "sphere" => shapes(Random::sphere, whole::sphere),
        "plane" => shapes(Random::plane, whole::plane),
        "triangle" => shapes(Random::triangle, whole::triangle),
        "first_hit" => {
            let (questions, is_tie) = both(Random::objects, whole::objects);
            let job = Job::FirstHit(questions);
            Asked { job, is_tie }
        }
        "triangle_soup" => {
            let (questions, is_tie) = both(Random::objects, whole::objects);
            let job = Job::TriangleSoup(questions);
            Asked { job, is_tie }
        }
        task => panic!("nobody knows what to ask of `{task}`"),
    }
}

type AnyOf<Q> = fn(&mut Random) -> Q;
type WholeOf<Q> = fn(&mut Random) -> (Q, bool);

fn shapes(any: AnyOf<ShapeQuestion>, whole: WholeOf<ShapeQuestion>) -> Asked {
    let (questions, is_tie) = both(any, whole);
    let job = Job::Intersect(questions);
    Asked { job, is_tie }
}

fn both<Q>(any: AnyOf<Q>, whole: WholeOf<Q>) -> (Vec<Q>, Vec<bool>) {
    let mut random = Random::new();
    let mut questions: Vec<(Q, bool)> = (0..COUNT).map(|_| (any(&mut random), false)).collect();
    questions.extend((0..COUNT).map(|_| whole(&mut random)));
    questions.into_iter().unzip()
}
