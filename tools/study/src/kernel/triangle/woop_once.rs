use super::woop::{Sheared, Woop};
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Triangle};

/// Woop–Benthin–Wald with an owner for each edge, as rasterizers have it (the top-left
/// rule): of two triangles that share an edge one has it, and of all around a vertex one.
///
/// The rule is that of a ray moved by (−1, −ε), ε infinitely small, in the sheared plane:
/// it then passes an edge s = q − p on the left if s.y > 0, or s.y = 0 and s.x < 0. All
/// triangles see the same moved ray, for sheared corners are the same in all of them and
/// the signs of areas and of differences are right: so a ray leaves a closed mesh once,
/// without any exact arithmetic. Which triangle that is may still be wrong by the
/// rounding of the shear; that the adaptive kernel alone decides rightly.
pub struct WoopOnce;

impl<F: Real> Kernel<Triangle<F>, F> for WoopOnce {
    const NAME: &'static str = "Woop, edges owned";
    type Prepared = Sheared<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Sheared<F> {
        Woop::prepare(ray)
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<F>, ray: &Sheared<F>, min_t: F) -> Option<F> {
        ray.met(triangle, min_t, |p, q| {
            q[1] > p[1] || q[1] == p[1] && q[0] < p[0]
        })
    }
}
