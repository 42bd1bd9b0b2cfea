//! Who takes part.

use crate::contestant::Contestant;
use crate::kernel::sphere::Scaled;
use crate::kernel::{Kernel, Tier, Widened, plane, sphere, triangle};
use crate::oracle::Known;
use crate::question::{Data, Question};
use crate::shape::{Plane, Sphere, Triangle};

/// A shape that kernels compete on.
pub trait Contested: Known {
    /// The shape's name.
    const NAME: &'static str;
    /// All kernels, on all types of numbers.
    fn contestants() -> Vec<Contestant<Self>>;
    /// What has the last word in the exact kernel, in `f64`.
    fn tier(question: &Question<Self>) -> Tier;
}

/// The name of every shape's exact kernel.
pub const EXACT: &str = "adaptive exact";

fn semi_static_or(is_filtered: bool, next: impl Fn() -> Tier) -> Tier {
    if is_filtered {
        Tier::SemiStatic
    } else {
        next()
    }
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
            in_all_numbers::<Self, sphere::Haines>(),
            in_all_numbers::<Self, sphere::Adaptive>(),
        ]
        .concat()
    }

    fn tier(question: &Question<Self>) -> Tier {
        let Question { shape, ray, min_t } = question;
        let filtered = sphere::filtered(shape, &Scaled::new(ray), *min_t);
        semi_static_or(filtered.is_some(), || Tier::Exact)
    }
}

impl Contested for Plane<f64> {
    const NAME: &'static str = "plane";

    fn contestants() -> Vec<Contestant<Self>> {
        [
            in_all_numbers::<Self, plane::Shifted>(),
            in_all_numbers::<Self, plane::Adaptive>(),
        ]
        .concat()
    }

    fn tier(question: &Question<Self>) -> Tier {
        let Question { shape, ray, min_t } = question;
        let filtered = plane::filtered(shape, ray, *min_t);
        semi_static_or(filtered.is_some(), || Tier::Exact)
    }
}

impl Contested for Triangle<f64> {
    const NAME: &'static str = "triangle";

    fn contestants() -> Vec<Contestant<Self>> {
        [
            in_all_numbers::<Self, triangle::MollerTrumbore>(),
            in_all_numbers::<Self, triangle::MollerTrumboreEpsilon>(),
            in_all_numbers::<Self, triangle::Woop>(),
            in_all_numbers::<Self, triangle::Adaptive>(),
        ]
        .concat()
    }

    fn tier(question: &Question<Self>) -> Tier {
        let Question { shape, ray, min_t } = question;
        let scaled = Scaled::new(ray);
        let filtered = triangle::filtered(shape, &scaled, *min_t);
        semi_static_or(filtered.is_some(), || {
            match triangle::twice(shape, &scaled, *min_t) {
                Some(_) => Tier::DoubleDouble,
                None => Tier::Exact,
            }
        })
    }
}
