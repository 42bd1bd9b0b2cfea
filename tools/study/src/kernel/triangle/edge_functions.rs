use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Triangle};

/// On which side of each edge does the ray pass? The signed volumes d·(b × c), d·(c × a),
/// d·(a × b), corners seen from the ray's origin, have one sign if it passes inside
/// (Kensler & Shirley, "Optimizing Ray-Triangle Intersection via Automated Search", 2006,
/// give the family of such forms).
///
/// Two triangles that share an edge compute the same volume with opposite sign, to the
/// bit: a ray may hit both, but it cannot slip between. At a vertex it still can, where
/// roundings of different edges contradict each other.
pub struct EdgeFunctions;

impl<F: Real> Kernel<Triangle<F>, F> for EdgeFunctions {
    const NAME: &'static str = "edge functions";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let [a, b, c] = triangle.corners.map(|corner| corner - ray.origin);
        let u = ray.direction.dot(b.cross(c));
        let v = ray.direction.dot(c.cross(a));
        if u < F::ZERO && v > F::ZERO || u > F::ZERO && v < F::ZERO {
            return None;
        }
        let w = ray.direction.dot(a.cross(b));
        let negative = u < F::ZERO || v < F::ZERO || w < F::ZERO;
        let positive = u > F::ZERO || v > F::ZERO || w > F::ZERO;
        if negative == positive {
            return None;
        }
        let normal = (triangle.corners[1] - triangle.corners[0])
            .cross(triangle.corners[2] - triangle.corners[0]);
        let t = normal.dot(a) / normal.dot(ray.direction);
        (t >= min_t).then_some(t)
    }
}
