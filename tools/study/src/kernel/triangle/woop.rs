use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// A shear, computed once per ray, maps the ray to the z axis. Each triangle is then projected
/// to a plane, and the question is whether the origin lies inside (Woop, Benthin & Wald,
/// "Watertight Ray/Triangle Intersection", *J. Computer Graphics Techniques* 2(1), 2013).
///
/// A sheared corner is the same in all triangles that share it, and a difference of two rounded
/// products has the right sign or is 0. If it is 0, the paper recomputes it in `double`. This
/// kernel differs in two ways: fused multiply-adds recover the sign (Kahan's difference of
/// products), which works for `f64` too; and both orientations count, so x and y need not be
/// swapped. As a result, nothing leaks.
///
/// A ray exactly through a sheared vertex would hit all triangles around it. Therefore each
/// edge belongs to one triangle, as in the top-left rule of rasterizers: of two triangles that
/// share an edge, one owns it, and of all triangles around a vertex, one is hit. The rule
/// simulates a ray moved by (−1, −ε) in the sheared plane, with ε infinitely small: it passes
/// an edge s = q − p on the left if s.y > 0, or s.y = 0 and s.x < 0. All triangles see the same
/// moved ray, because sheared corners are the same in all of them and the signs of areas and
/// differences are right. So a ray leaves a closed mesh exactly once, without exact arithmetic.
/// Rounding in the shear may still pick the wrong triangle; only the adaptive kernel always
/// picks the right one.
pub struct Woop;

/// The shear of a ray.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay<F> {
    origin: Vector<F>,
    along: Axis,
    shear: [F; 3],
}

/// The axis of a direction's largest component.
#[derive(Clone, Copy, Debug)]
enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// The components in cyclic order, with this axis last.
    #[inline(always)]
    fn to_the_end<F: Real>(self, v: Vector<F>) -> [F; 3] {
        match self {
            Axis::X => [v.y, v.z, v.x],
            Axis::Y => [v.z, v.x, v.y],
            Axis::Z => [v.x, v.y, v.z],
        }
    }
}

impl<F: Real> Kernel<Triangle<F>, F> for Woop {
    const NAME: &'static str = "Woop, edges owned";
    type PreparedRay = ShearedRay<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> ShearedRay<F> {
        let d = ray.direction.map(F::abs);
        let along = match (d.z >= d.x && d.z >= d.y, d.y >= d.x) {
            (true, _) => Axis::Z,
            (false, true) => Axis::Y,
            (false, false) => Axis::X,
        };
        let [x, y, z] = along.to_the_end(ray.direction);
        ShearedRay {
            origin: ray.origin,
            along,
            shear: [x / z, y / z, F::one() / z],
        }
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<F>, ray: &ShearedRay<F>, min_t: F) -> Option<F> {
        let [sx, sy, sz] = ray.shear;
        let [a, b, c] = triangle.corners.map(|corner| {
            let [x, y, z] = ray.along.to_the_end(corner - ray.origin);
            [x - sx * z, y - sy * z, z]
        });
        let u = signed_area(c, b);
        let v = signed_area(a, c);
        let w = signed_area(b, a);
        let negative = u < F::zero() || v < F::zero() || w < F::zero();
        let positive = u > F::zero() || v > F::zero() || w > F::zero();
        if negative && positive {
            return None;
        }
        if u == F::zero() || v == F::zero() || w == F::zero() {
            let edges = [(u, c, b), (v, a, c), (w, b, a)];
            let has = |(area, p, q)| match (area == F::zero(), negative) {
                (false, _) => true,
                (true, false) => is_owned(p, q),
                (true, true) => is_owned(q, p),
            };
            if !edges.into_iter().all(has) {
                return None;
            }
        }
        let determinant = u + v + w;
        if determinant == F::zero() {
            return None;
        }
        let t = sz * (u * a[2] + v * b[2] + w * c[2]) / determinant;
        (t >= min_t).then_some(t)
    }
}

/// Whether an edge from p to q belongs to the triangle on its left.
#[inline(always)]
fn is_owned<F: Real>(p: [F; 3], q: [F; 3]) -> bool {
    q[1] > p[1] || q[1] == p[1] && q[0] < p[0]
}

/// p.x q.y − p.y q.x, always with the right sign.
#[inline(always)]
fn signed_area<F: Real>(p: [F; 3], q: [F; 3]) -> F {
    let area = p[0] * q[1] - p[1] * q[0];
    match area == F::zero() {
        false => area,
        true => {
            let product = p[1] * q[0];
            p[0].mul_add(q[1], -product) + (-p[1]).mul_add(q[0], product)
        }
    }
}
