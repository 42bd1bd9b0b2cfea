//! Computes hits more accurately than the filters do: in double-double arithmetic or, if even that
//! loses too many digits, exactly. Also tells in double-double arithmetic which of two hits is
//! nearer.

use std::cmp::Ordering;

use super::bounds::are_in_range;
use super::model::exact_hit;
use super::world::{Primitive, of_each};
use crate::double_double::DoubleDouble;
use crate::dyadic::Dyadic;
use crate::kernel::Filtered;
use crate::kernel::sphere::{ScaledRay, at_most};
use crate::number::U;
use crate::root::rounded;
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::vector::Vector;

/// t and the unit normal of a hit whose t is about `near`. The relative error of t and the normal's
/// error in radians are at most `accuracy`, which is [`FINEST`](crate::plan::FINEST) or more. The last
/// value tells whether exact arithmetic was necessary.
///
/// # Panics
/// If the ray misses the shape.
#[cold]
#[inline(never)]
pub fn refined(
    shape: &Primitive,
    ray: &Ray<f64>,
    min_t: f64,
    near: f64,
    accuracy: f64,
) -> (f64, Vector<f64>, bool) {
    // Of a short shape, `f64` rounds t once, and the normal only to unit length.
    if let Some(Some(t)) = of_each!(shape, shape => shape.short(ray, min_t)) {
        return (t, shape.flat_normal(), false);
    }
    // A larger `near` may have been cut off at the largest `f64`, and then tells no roots apart.
    let rounded = match near < 1e300 {
        true => in_double_double(shape, &ScaledRay::new(ray), near, accuracy),
        false => None,
    };
    let is_exact = rounded.is_none();
    let (t, normal) = rounded.unwrap_or_else(|| exactly(shape, ray, min_t));
    (t, normal, is_exact)
}

/// t and the unit normal of a hit, each rounded from at least a hundred bits.
fn exactly(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> (f64, Vector<f64>) {
    let root = exact_hit(shape, ray, min_t);
    let along = match shape {
        Primitive::Plane(plane) => plane.normal.map(Dyadic::of),
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners.map(|corner| corner.map(Dyadic::of));
            (b - a.clone()).cross(c - a)
        }
        Primitive::Sphere(sphere) => {
            let from_center = ray.origin.map(Dyadic::of) - sphere.center.map(Dyadic::of);
            root.point(from_center, ray.direction.map(Dyadic::of))
        }
    };
    let t = rounded(Some(root)).expect("the root is not `None`");
    (t, along.rounded_unit())
}

/// t and the unit normal in double-double arithmetic; `None` if the errors of a fraction's parts, or
/// what they contribute to the normal, may exceed an eighth of `accuracy`. Together with the
/// roundings to `f64`, of at most 9u, t and the normal are then off by at most `accuracy`, which is
/// 18u or more.
///
/// The relative error of a double-double sum is at most 3u² + 13u³, and that of a product at most 7u²
/// (Joldes, Muller & Popescu, *ACM TOMS* 44(2), 2017, algorithms 6 and 10, which are the ones used
/// here). 8u² bounds both, so the error of a dot product is at most 32u² times the sum of its terms'
/// magnitudes. In the range that is checked first, nothing
/// overflows, and underflow is far smaller than these errors.
fn in_double_double(
    shape: &Primitive,
    scaled: &ScaledRay<f64>,
    near: f64,
    accuracy: f64,
) -> Option<(f64, Vector<f64>)> {
    let (t, along) = match shape {
        Primitive::Plane(plane) => of_plane(plane, &scaled.ray, accuracy),
        Primitive::Triangle(triangle) => of_triangle(triangle, &scaled.ray, accuracy),
        Primitive::Sphere(sphere) => of_sphere(sphere, &scaled.ray, scaled.scale(near), accuracy),
    }?;
    let t = scaled.unscale(t.high);
    (1e-300..1e300)
        .contains(&t)
        .then(|| (t, along.rounded().unit()))
}

/// The accuracy with which [`nearer`] needs t: 2⁻⁷⁰.
const TO_COMPARE: f64 = 8.5e-22;

/// Which of two planes or triangles a ray meets at the smaller t; `None` if double-double arithmetic
/// leaves that open. It meets both.
///
/// The errors of a volume are at most an eighth of [`TO_COMPARE`], and the division adds a few u².
/// So the relative error of each t is below a third of [`TO_COMPARE`].
pub fn nearer(one: &Primitive, other: &Primitive, ray: &Ray<f64>) -> Option<Ordering> {
    let ScaledRay { ray, .. } = ScaledRay::new(ray);
    let t = |shape: &Primitive| match shape {
        Primitive::Plane(plane) => Some(of_plane(plane, &ray, TO_COMPARE)?.0),
        Primitive::Triangle(triangle) => Some(of_triangle(triangle, &ray, TO_COMPARE)?.0),
        Primitive::Sphere(_) => None,
    };
    let (one, other) = (t(one)?, t(other)?);
    let (apart, sizes) = ((one - other).high, one.high.abs() + other.high.abs());
    let order = apart.partial_cmp(&0.0)?;
    (apart.abs() > TO_COMPARE * sizes).then_some(order)
}

/// `p` / `q`; `None` if one of their errors may exceed an eighth of `accuracy` times its magnitude.
fn ratio([p, q]: [DoubleDouble; 2], errors: [f64; 2], accuracy: f64) -> Option<DoubleDouble> {
    let is_good = |x: DoubleDouble, error: f64| accuracy * x.high.abs() > 8.0 * error;
    (is_good(p, errors[0]) && is_good(q, errors[1])).then(|| p.over(q))
}

fn of_plane(
    plane: &Plane<f64>,
    ray: &Ray<f64>,
    accuracy: f64,
) -> Option<(DoubleDouble, Vector<DoubleDouble>)> {
    let (n, w) = (
        plane.normal.map(DoubleDouble::from),
        Vector::between(plane.point, ray.origin),
    );
    let sizes = [n.rounded().largest(), w.rounded().largest()];
    if !are_in_range(sizes) {
        return None;
    }
    let error = |size: f64| 128.0 * U * U * sizes[0] * size;
    let volumes = [n.dot(w), n.dot(ray.direction.map(DoubleDouble::from))];
    let errors = [error(sizes[1]), error(2.0)];
    Some((ratio(volumes, errors, accuracy)?, n))
}

/// n = e₁ × e₂ has components up to 2M², with an error of at most 32u² M². So the error of n·d is
/// at most 576u² M², and that of n·(a − e) at most 288u² S M².
fn of_triangle(
    triangle: &Triangle<f64>,
    ray: &Ray<f64>,
    accuracy: f64,
) -> Option<(DoubleDouble, Vector<DoubleDouble>)> {
    let [a, b, c] = triangle.corners;
    let edges = [Vector::between(b, a), Vector::between(c, a)];
    let away = Vector::between(a, ray.origin);
    let sizes = [
        edges[0]
            .rounded()
            .largest()
            .max(edges[1].rounded().largest()),
        away.rounded().largest(),
    ];
    if !are_in_range(sizes) {
        return None;
    }
    let n = edges[0].cross(edges[1]);
    let error = 1024.0 * U * U * sizes[0] * sizes[0];
    let volumes = [n.dot(away), n.dot(ray.direction.map(DoubleDouble::from))];
    let t = ratio(volumes, [error * sizes[1], error], accuracy)?;
    (accuracy * n.rounded().largest() > 8.0 * error).then_some((t, n))
}

/// With f = e − c, |f|∞ ≤ F and |d|∞ < 2, the error of h² − a c is below 8192u² (F² + r²), and that
/// of c = |f|² − r² below 128u² (F² + r²). The roots differ by far more than `near` is off, unless
/// the discriminant is too small to be good.
fn of_sphere(
    sphere: &Sphere<f64>,
    ray: &Ray<f64>,
    near: f64,
    accuracy: f64,
) -> Option<(DoubleDouble, Vector<DoubleDouble>)> {
    let f = Vector::between(ray.origin, sphere.center);
    let largest = f.rounded().largest();
    let (d, r) = (ray.direction.map(DoubleDouble::from), sphere.radius);
    if !are_in_range([largest, r]) {
        return None;
    }
    let square = DoubleDouble::product(r, r);
    let size = U * U * (largest * largest + r * r);
    let (a, h, c) = (d.dot(d), d.dot(f), f.dot(f) - square);
    let discriminant = h * h - a * c;
    // The normal multiplies an error of t by this much. The factor 2⁻³⁶ keeps the roots far apart.
    let spread = 1.0 + at_most(largest) / r;
    let is_good = discriminant.high
        > (8.0 * 8192.0 * size * spread / accuracy).max(h.high * h.high / 2f64.powi(36));
    if !(is_good && spread < 1e10 && accuracy * c.high.abs() > 8.0 * 128.0 * size * spread) {
        return None;
    }
    let root = discriminant.sqrt();
    let q = match h.high < 0.0 {
        true => root - h,
        false => -(root + h),
    };
    let roots = [c.over(q), q.over(a)];
    let [one, other] = roots.map(|t| (t.high - near).abs());
    let t = if one < other { roots[0] } else { roots[1] };
    Some((t, f + d * t))
}
