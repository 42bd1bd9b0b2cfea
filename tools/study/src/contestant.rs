//! A kernel with its types forgotten, so that tables can list them.

use std::hint::black_box;

use crate::kernel::Kernel;
use crate::number::Real;
use crate::question::{Data, Question};
use crate::shape::{Ray, Shape};

/// A kernel, the numbers it computes with, and the type its data are stored in.
#[derive(Clone, Copy)]
pub struct Contestant<S: 'static> {
    /// The kernel's name.
    pub name: &'static str,
    /// `f64`, `f32`, or `f64 on f32`.
    pub numbers: &'static str,
    /// What its questions are rounded to.
    pub data: Data,
    /// Its answer to a question.
    pub answer: fn(&Question<S>) -> Option<f64>,
    /// A workload of rays and shapes: each call casts every ray at every shape once.
    pub workload: fn(&[Question<S>]) -> Box<dyn FnMut()>,
}

impl<S: Shape<With<f64> = S>> Contestant<S> {
    /// From a kernel on `F`.
    pub fn new<K, F>(data: Data, numbers: &'static str) -> Contestant<S>
    where
        F: Real,
        K: Kernel<S::With<F>, F>,
    {
        Contestant {
            name: K::NAME,
            numbers,
            data,
            answer: answer::<K, S, F>,
            workload: workload::<K, S, F>,
        }
    }
}

fn of<S: Shape, F: Real>(question: &Question<S>) -> (S::With<F>, Ray<F>, F) {
    (
        question.shape.map(F::of, F::of),
        question.ray.map(F::of, F::of),
        F::of(question.min_t),
    )
}

fn answer<K: Kernel<S::With<F>, F>, S: Shape, F: Real>(question: &Question<S>) -> Option<f64> {
    let (shape, ray, min_t) = of::<S, F>(question);
    K::intersect(&shape, &K::prepare(&ray), min_t).map(F::wide)
}

/// How many shapes each ray is tried on: about what a leaf of a tree holds, so that what
/// is worked out once for a ray counts as it does there.
pub const SHAPES_PER_RAY: usize = 8;

fn workload<K, S, F>(questions: &[Question<S>]) -> Box<dyn FnMut()>
where
    K: Kernel<S::With<F>, F>,
    S: Shape,
    F: Real,
{
    let (mut shapes, mut rays) = (Vec::new(), Vec::new());
    for (at, question) in questions.iter().enumerate() {
        let (shape, ray, min_t) = of::<S, F>(question);
        shapes.push(shape);
        if at % SHAPES_PER_RAY == 0 {
            rays.push((ray, min_t));
        }
    }
    Box::new(move || {
        black_box(cast::<K, S, F>(&shapes, &rays));
    })
}

#[inline(never)]
fn cast<K, S, F>(shapes: &[S::With<F>], rays: &[(Ray<F>, F)]) -> F
where
    K: Kernel<S::With<F>, F>,
    S: Shape,
    F: Real,
{
    let mut sum = F::ZERO;
    for (group, (ray, min_t)) in shapes.chunks(SHAPES_PER_RAY).zip(rays) {
        let prepared = K::prepare(ray);
        for shape in group {
            if let Some(t) = K::intersect(shape, &prepared, *min_t) {
                sum = sum + t;
            }
        }
    }
    sum
}
