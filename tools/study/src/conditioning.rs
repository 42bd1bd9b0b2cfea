//! Condition numbers: how sensitive the t of a question is to the question's own numbers.
//!
//! The componentwise relative condition number is κ = Σ |x ∂t/∂x| / |t| over all numbers x of
//! the question (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §1.6). If
//! each number is off by half an ulp, t may be off by κ/2 ulp, whatever the kernel. By the
//! implicit function theorem, with N along the normal at the hit, ∂t/∂e = −N / (N·d) and ∂t/∂d
//! = t ∂t/∂e. Moving the shape moves t the other way.

use crate::oracle::{HasTruth, Truth};
use crate::question::Question;
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::vector::{Vector, around};

/// A shape whose questions have a condition number.
pub trait Conditioning: HasTruth {
    /// κ of a true hit, to a few digits. It is infinite if the ray only touches the shape.
    fn condition(question: &Question<Self>, truth: &Truth) -> Option<f64>;
}

fn magnitude(v: Vector<f64>) -> Vector<f64> {
    v.map(f64::abs)
}

/// κ from the normal n, the magnitudes that the shape's points contribute per component, the
/// contribution of its other numbers, and N·d.
fn of_hit(ray: &Ray<f64>, t: f64, n: Vector<f64>, points: Vector<f64>, rest: f64, nd: f64) -> f64 {
    let place = magnitude(ray.origin) + magnitude(ray.direction * t) + points;
    (magnitude(n).dot(place) + rest) / (t * nd).abs()
}

impl Conditioning for Sphere<f64> {
    fn condition(question: &Question<Self>, truth: &Truth) -> Option<f64> {
        let Question { shape, ray, .. } = question;
        let (t, other) = (truth.t.as_ref()?.value, truth.other.as_ref()?.value);
        let d = ray.direction;
        let n = ray.origin + d * t - shape.center;
        // N·d is half the distance of the roots times d·d. Computed directly, it would cancel.
        let nd = d.dot(d) * (other - t) / 2.0;
        let r = shape.radius;
        Some(of_hit(ray, t, n, magnitude(shape.center), r * r, nd))
    }
}

impl Conditioning for Plane<f64> {
    fn condition(question: &Question<Self>, truth: &Truth) -> Option<f64> {
        let Question { shape, ray, .. } = question;
        let (t, n) = (truth.t.as_ref()?.value, shape.normal);
        let across = ray.origin + ray.direction * t - shape.point;
        let of_normal = magnitude(n).dot(magnitude(across));
        let nd = n.dot(ray.direction);
        Some(of_hit(ray, t, n, magnitude(shape.point), of_normal, nd))
    }
}

impl Conditioning for Triangle<f64> {
    fn condition(question: &Question<Self>, truth: &Truth) -> Option<f64> {
        let Question { shape, ray, .. } = question;
        let t = truth.t.as_ref()?.value;
        let n = shape.outward_near_one();
        // The barycentric weights of the hit add up to 1, so the corners together contribute at
        // most the largest.
        let [_, corners] = around(shape.corners.map(|corner| [magnitude(corner); 2]))?;
        Some(of_hit(ray, t, n, corners, 0.0, n.dot(ray.direction)))
    }
}

/// The decade of a condition number: its power of ten, at most 20.
pub fn decade(condition: f64) -> i32 {
    condition.log10().clamp(0.0, 20.0) as i32
}
