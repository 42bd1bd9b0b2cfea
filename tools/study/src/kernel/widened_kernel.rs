use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Plane, Ray, Sphere, Triangle};

/// A kernel that computes in `f64` on `f32` data. t is rounded once, at the end, and products
/// of two `f32` are exact.
pub struct WidenedKernel<K>(K);

macro_rules! widened {
    ($shape:ident, $wide:expr) => {
        impl<K: Kernel<$shape<f64>, f64>> Kernel<$shape<f32>, f32> for WidenedKernel<K> {
            const NAME: &'static str = K::NAME;
            type PreparedRay = K::PreparedRay;

            #[inline(always)]
            fn prepare(ray: &Ray<f32>) -> K::PreparedRay {
                K::prepare(&Ray {
                    origin: ray.origin.map(f32::wide),
                    direction: ray.direction.map(f32::wide),
                })
            }

            #[inline(always)]
            fn intersect(shape: &$shape<f32>, ray: &K::PreparedRay, min_t: f32) -> Option<f32> {
                let wide: fn(&$shape<f32>) -> $shape<f64> = $wide;
                // Rounding never takes a t ≥ min_t below min_t, because min_t is an `f32`.
                K::intersect(&wide(shape), ray, min_t.wide()).map(f32::of)
            }
        }
    };
}

widened!(Sphere, |sphere| Sphere {
    center: sphere.center.map(f32::wide),
    radius: sphere.radius.wide(),
});
widened!(Plane, |plane| Plane {
    point: plane.point.map(f32::wide),
    normal: plane.normal.map(f32::wide),
});
widened!(Triangle, |triangle| Triangle {
    corners: triangle.corners.map(|corner| corner.map(f32::wide)),
});
