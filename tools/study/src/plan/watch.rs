//! The bound of one hit, from its own numbers.

use super::bounds::{Bound, OfPlane, OfSphere, OfTriangle, Rounding};
use crate::cast::world::Primitive;
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::vector::Vector;

/// Of what is found at `t`, as far as a plain cast in these numbers can be off there.
/// `is_decided` says that what is met is certain, for exact arithmetic has the last word.
pub fn bound(
    shape: &Primitive,
    ray: &Ray<f64>,
    (t, min_t): (f64, f64),
    rounding: Rounding,
    is_decided: bool,
) -> Bound {
    let bound = match shape {
        Primitive::Sphere(shape) => of_sphere(shape, ray, (t, min_t), rounding),
        Primitive::Plane(shape) => of_plane(shape, ray).bound(rounding),
        Primitive::Triangle(shape) => of_triangle(shape, ray, t, is_decided).bound(rounding),
    };
    // As near to min_t as this, it may lie before it.
    let is_beyond = is_decided || t - min_t > bound.t * t || min_t == 0.0;
    match is_beyond && t > 0.0 {
        true => bound,
        false => Bound::NONE,
    }
}

/// The length of a vector.
pub fn length(v: Vector<f64>) -> f64 {
    v.dot(v).sqrt()
}

/// Σ|aᵢ||bᵢ|.
pub fn terms(a: Vector<f64>, b: Vector<f64>) -> f64 {
    a.map(f64::abs).dot(b.map(f64::abs))
}

fn of_sphere(
    sphere: &Sphere<f64>,
    ray: &Ray<f64>,
    (t, min_t): (f64, f64),
    rounding: Rounding,
) -> Bound {
    let f = ray.origin - sphere.center;
    let direction = length(ray.direction);
    let along = ray.direction.dot(f) / direction;
    let l = f - ray.direction * (along / direction);
    let depth_square = sphere.radius * sphere.radius - l.dot(l);
    let is_far = t * direction > -along;
    let constant = (f.dot(f) - sphere.radius * sphere.radius).abs();
    let known = OfSphere {
        origin: length(ray.origin),
        center: length(sphere.center),
        away: length(f),
        radius: sphere.radius,
        depth_square,
        along: along.abs(),
        constant: (along >= 0.0 || !is_far).then_some(constant),
        length: t * direction,
    };
    let bound = known.bound(rounding);
    // The nearer root may have been missed: it lies at min_t, give or take an error.
    let near = -along - depth_square.max(0.0).sqrt();
    let error = bound.t * t * direction;
    let is_near_missed = is_far && (near - min_t * direction).abs() <= error;
    match is_near_missed {
        true => Bound::NONE,
        false => bound,
    }
}

fn of_plane(plane: &Plane<f64>, ray: &Ray<f64>) -> OfPlane {
    let (n, w) = (plane.normal, plane.point - ray.origin);
    OfPlane {
        down: n.dot(ray.direction).abs(),
        down_terms: terms(n, ray.direction),
        height: n.dot(w).abs(),
        height_terms: terms(n, w),
        far_terms: terms(n, plane.point) + terms(n, ray.origin),
    }
}

fn of_triangle(triangle: &Triangle<f64>, ray: &Ray<f64>, t: f64, is_decided: bool) -> OfTriangle {
    let [a, b, c] = triangle.corners;
    let (e1, e2, s, d) = (b - a, c - a, ray.origin - a, ray.direction);
    let normal = e1.cross(e2);
    let determinant = normal.dot(d);
    let weights = || {
        let second = -s.dot(d.cross(e2)) / determinant;
        let third = -d.dot(s.cross(e1)) / determinant;
        second.min(third).min(1.0 - second - third)
    };
    OfTriangle {
        size: e1.largest().max(e2.largest()),
        area: length(normal),
        corner: a.largest().max(b.largest()).max(c.largest()),
        away: s.largest(),
        origin: ray.origin.largest(),
        direction: d.largest(),
        direction_length: length(d),
        determinant: determinant.abs(),
        volume: normal.dot(s).abs(),
        length: t * length(d),
        margin: (!is_decided).then(weights),
    }
}
