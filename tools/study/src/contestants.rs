//! All kernels that the study compares. A contestant is a type-erased kernel, so that kernels of
//! different types can be listed in one table.

use std::hint::black_box;

use crate::cast::world::Primitive;
use crate::kernel::{
    Adaptive, Filtered, Kernel, Tier, WidenedKernel, decided, plane, sphere, triangle,
};
use crate::number::Real;
use crate::oracle::HasTruth;
use crate::question::{Data, Question};
use crate::shape::{Plane, Ray, Shape, Sphere, Triangle};

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

/// A shape with kernels to compare.
pub trait HasKernels: HasTruth + Filtered + Into<Primitive> {
    /// All kernels, for all types of numbers.
    fn contestants() -> Vec<Contestant<Self>>;
    /// The place of the exact kernel in `f64` among all kernels, and the kernel.
    fn exact_kernel() -> (usize, Contestant<Self>) {
        let mut all = Self::contestants().into_iter().enumerate();
        let is_it = |(_, it): &(_, Contestant<Self>)| it.name == EXACT && it.data == Data::F64;
        all.find(is_it).expect("every shape has an exact kernel")
    }
    /// The tier that decides a question in the exact kernel, in `f64`.
    fn tier(Question { shape, ray, min_t }: &Question<Self>) -> Tier {
        let (scaled, ray) = <Adaptive as Kernel<Self, f64>>::prepare(ray);
        decided(shape, &scaled, &ray, *min_t).1
    }
}

/// The name of every shape's exact kernel.
pub const EXACT: &str = "adaptive exact";

/// Lists the kernels of each shape. All compute in `f64`, on `f64` and on `f32` data. Those that are
/// named here also compute in `f32`; the exact kernel, which every shape has, does not.
macro_rules! contestants {
    ($($shape:ident: $($kernel:ty),*;)*) => {$(
        impl HasKernels for $shape<f64> {
            fn contestants() -> Vec<Contestant<Self>> {
                vec![
                    $(
                        Contestant::new::<$kernel, f64>(Data::F64, "f64"),
                        Contestant::new::<WidenedKernel<$kernel>, f32>(Data::F32, "f64 on f32"),
                        Contestant::new::<$kernel, f32>(Data::F32, "f32"),
                    )*
                    Contestant::new::<Adaptive, f64>(Data::F64, "f64"),
                    Contestant::new::<WidenedKernel<Adaptive>, f32>(Data::F32, "f64 on f32"),
                ]
            }
        }
    )*};
}

contestants! {
    Sphere: sphere::Textbook, sphere::Haines;
    Plane: plane::ShiftedOrigin;
    Triangle: triangle::MollerTrumbore, triangle::MollerTrumboreEpsilon, triangle::Woop;
}
