//! A type-erased kernel, so that kernels of different types can be listed in one table.

use std::hint::black_box;

use crate::kernel::Kernel;
use crate::number::Real;
use crate::question::{Data, Question};
use crate::shape::{Ray, Shape};

/// A call casts all prepared rays at their shapes.
pub type Workload<'a> = Box<dyn FnMut() + 'a>;

/// A kernel, the numbers it computes with, and the type in which its data are stored.
#[derive(Clone, Copy)]
pub struct Contestant<S: 'static> {
    /// The kernel's name.
    pub name: &'static str,
    /// `f64`, `f32`, or `f64 on f32`.
    pub numbers: &'static str,
    /// The type that its questions are rounded to.
    pub data: Data,
    /// Its answer to a question.
    pub answer: fn(&Question<S>) -> Option<f64>,
    /// Builds a workload from questions. Rays are prepared beforehand, as they are when they
    /// reach a leaf of a tree.
    pub workload: fn(&[Question<S>]) -> Workload<'static>,
}

impl<S: Shape<Number = f64>> Contestant<S> {
    /// Wraps a kernel `K` that computes with `F`.
    pub fn new<K, F>(data: Data, numbers: &'static str) -> Contestant<S>
    where
        F: Real,
        K: Kernel<S::With<F>, F>,
    {
        Contestant {
            name: K::NAME,
            numbers,
            data,
            answer: |question| {
                let (shape, ray, min_t) = narrowed::<S, F>(question);
                K::intersect(&shape, &K::prepare(&ray), min_t).map(F::wide)
            },
            workload: |questions| {
                let prepared = |question| {
                    let (shape, ray, min_t) = narrowed::<S, F>(question);
                    (shape, K::prepare(&ray), min_t)
                };
                let pairs: Vec<_> = questions.iter().map(prepared).collect();
                Box::new(move || {
                    let pairs = black_box(&pairs).iter();
                    let hits = pairs.filter_map(|(shape, ray, t)| K::intersect(shape, ray, *t));
                    black_box(hits.fold(F::zero(), |sum, t| sum + t));
                })
            },
        }
    }
}

fn narrowed<S: Shape<Number = f64>, F: Real>(question: &Question<S>) -> (S::With<F>, Ray<F>, F) {
    (
        question.shape.map(F::of, F::of),
        question.ray.map(F::of, F::of),
        F::of(question.min_t),
    )
}
