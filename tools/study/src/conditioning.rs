//! Condition numbers: how sensitive the t of a question is to the question's own numbers.
//!
//! The componentwise relative condition number is κ = Σ |x ∂t/∂x| / |t| over all numbers x of
//! the question (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §1.6). If
//! each number is off by half an ulp, t may be off by κ/2 ulp, whatever the kernel. By the
//! implicit function theorem, with N along the normal at the hit, ∂t/∂e = −N / (N·d) and ∂t/∂d
//! = t ∂t/∂e. Moving the shape moves t the other way.

use crate::cast::world::Primitive;
use crate::oracle::Truth;
use crate::question::Question;
use crate::shape::{Plane, Sphere};
use crate::vector::{Vector, around};

fn magnitude(v: Vector<f64>) -> Vector<f64> {
    v.map(f64::abs)
}

/// κ of a true hit, to a few digits. It is infinite if the ray only touches the shape.
pub fn condition<S: Copy + Into<Primitive>>(question: &Question<S>, truth: &Truth) -> Option<f64> {
    let (e, d) = (question.ray.origin, question.ray.direction);
    let t = truth.t.as_ref()?.value;
    let hit = e + d * t;
    // A normal n, N·d, the magnitudes that the shape's points contribute per component, and the
    // contribution of its other numbers.
    let (n, nd, points, rest) = match question.shape.into() {
        Primitive::Sphere(Sphere { center, radius }) => {
            // N·d is half the distance of the roots times d·d. Computed directly, it would cancel.
            let nd = d.dot(d) * (truth.other.as_ref()?.value - t) / 2.0;
            (hit - center, nd, magnitude(center), radius * radius)
        }
        Primitive::Plane(Plane { point, normal }) => {
            let of_normal = magnitude(normal).dot(magnitude(hit - point));
            (normal, normal.dot(d), magnitude(point), of_normal)
        }
        Primitive::Triangle(triangle) => {
            let n = triangle.outward_near_one();
            // The barycentric weights of the hit add up to 1, so the corners together contribute at
            // most the largest.
            let [_, corners] = around(triangle.corners.map(|corner| [magnitude(corner); 2]))?;
            (n, n.dot(d), corners, 0.0)
        }
    };
    let place = magnitude(e) + magnitude(d * t) + points;
    Some((magnitude(n).dot(place) + rest) / (t * nd).abs())
}

/// The decade of a condition number: its power of ten, at most 20.
pub fn decade(condition: f64) -> i32 {
    condition.log10().clamp(0.0, 20.0) as i32
}
