//! Who takes part.

use crate::contestant::Contestant;
use crate::kernel::{Kernel, Widened, plane, sphere, triangle};
use crate::oracle::Known;
use crate::question::Data;
use crate::shape::{Plane, Sphere, Triangle};

/// A shape that kernels compete on.
pub trait Contested: Known {
    /// The shape's name.
    const NAME: &'static str;
    /// All kernels, on all types of numbers.
    fn contestants() -> Vec<Contestant<Self>>;
}

/// A kernel in `f64`, in `f32`, and in `f64` on `f32` data.
fn in_all_numbers<S, K>() -> [Contestant<S>; 3]
where
    S: Known,
    K: Kernel<S, f64> + Kernel<S::With<f32>, f32>,
    Widened<K>: Kernel<S::With<f32>, f32>,
{
    [
        Contestant::new::<K, f64>(Data::F64, "f64"),
        Contestant::new::<K, f32>(Data::F32, "f32"),
        Contestant::new::<Widened<K>, f32>(Data::F32, "f64 on f32"),
    ]
}

impl Contested for Sphere<f64> {
    const NAME: &'static str = "sphere";

    fn contestants() -> Vec<Contestant<Self>> {
        [
            in_all_numbers::<Self, sphere::Textbook>(),
            in_all_numbers::<Self, sphere::HalfB>(),
            in_all_numbers::<Self, sphere::StableQ>(),
            in_all_numbers::<Self, sphere::Fma>(),
            in_all_numbers::<Self, sphere::Haines>(),
            in_all_numbers::<Self, sphere::HainesScaled>(),
            in_all_numbers::<Self, sphere::DoubleDouble>(),
            in_all_numbers::<Self, sphere::Adaptive>(),
        ]
        .concat()
    }
}

impl Contested for Plane<f64> {
    const NAME: &'static str = "plane";

    fn contestants() -> Vec<Contestant<Self>> {
        [
            in_all_numbers::<Self, plane::Plain>(),
            in_all_numbers::<Self, plane::Shifted>(),
            in_all_numbers::<Self, plane::EpsilonCut>(),
            in_all_numbers::<Self, plane::Adaptive>(),
        ]
        .concat()
    }
}

impl Contested for Triangle<f64> {
    const NAME: &'static str = "triangle";

    fn contestants() -> Vec<Contestant<Self>> {
        [
            in_all_numbers::<Self, triangle::Cramer>(),
            in_all_numbers::<Self, triangle::MollerTrumbore>(),
            in_all_numbers::<Self, triangle::MollerTrumboreEpsilon>(),
            in_all_numbers::<Self, triangle::EdgeFunctions>(),
            in_all_numbers::<Self, triangle::Woop>(),
            in_all_numbers::<Self, triangle::WoopOnce>(),
            in_all_numbers::<Self, triangle::DoubleDouble>(),
            in_all_numbers::<Self, triangle::Adaptive>(),
        ]
        .concat()
    }
}
