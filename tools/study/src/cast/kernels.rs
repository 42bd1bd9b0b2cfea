//! Sets of kernels to cast a scene with: one for each kind of shape.

use crate::kernel::{Kernel, Widened, plane, sphere, triangle};
use crate::number::Real;
use crate::shape::{Plane, Ray, Sphere, Triangle};

/// A kernel for each kind of shape.
pub trait Kernels<F: Real>: Send + Sync + 'static {
    /// How tables call the set.
    const NAME: &'static str;
    /// What it computes with.
    const NUMBERS: &'static str = F::NAME;
    /// For spheres.
    type Sphere: Kernel<Sphere<F>, F>;
    /// For planes.
    type Plane: Kernel<Plane<F>, F>;
    /// For triangles.
    type Triangle: Kernel<Triangle<F>, F>;
}

/// The cheapest of each kind, wherever it breaks.
pub struct Fastest;

impl<F: Real> Kernels<F> for Fastest {
    const NAME: &'static str = "fastest";
    type Sphere = sphere::Textbook;
    type Plane = plane::Plain;
    type Triangle = triangle::MollerTrumbore;
}

/// The best that cost little more: spheres that are far away, planes and triangles that
/// are far from the origin lose nothing.
pub struct Usual;

impl<F: Real> Kernels<F> for Usual {
    const NAME: &'static str = "usual";
    type Sphere = sphere::Haines;
    type Plane = plane::Shifted;
    type Triangle = triangle::MollerTrumbore;
}

/// The best that never decide exactly: any length of direction, no leak, no double hit.
pub struct Steadiest;

impl<F: Real> Kernels<F> for Steadiest {
    const NAME: &'static str = "steadiest";
    type Sphere = sphere::HainesScaled;
    type Plane = plane::Shifted;
    type Triangle = triangle::WoopOnce;
}

/// The usual set in `f64`, on shapes and rays that are stored in `f32`.
pub struct UsualWidened;

impl Kernels<f32> for UsualWidened {
    const NAME: &'static str = "usual";
    const NUMBERS: &'static str = "f64 on f32";
    type Sphere = Widened<sphere::Haines>;
    type Plane = Widened<plane::Shifted>;
    type Triangle = Widened<triangle::MollerTrumbore>;
}

/// A ray with what each kernel of a set works out of it beforehand.
pub struct Prepared<F: Real, K: Kernels<F>> {
    /// For spheres.
    pub sphere: <K::Sphere as Kernel<Sphere<F>, F>>::Prepared,
    /// For planes.
    pub plane: <K::Plane as Kernel<Plane<F>, F>>::Prepared,
    /// For triangles.
    pub triangle: <K::Triangle as Kernel<Triangle<F>, F>>::Prepared,
}

impl<F: Real, K: Kernels<F>> Prepared<F, K> {
    /// Once for a ray.
    #[inline(always)]
    pub fn new(ray: &Ray<F>) -> Prepared<F, K> {
        Prepared {
            sphere: K::Sphere::prepare(ray),
            plane: K::Plane::prepare(ray),
            triangle: K::Triangle::prepare(ray),
        }
    }
}
