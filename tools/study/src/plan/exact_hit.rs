//! Computes a hit exactly and rounds once. Used where the error bounds are too wide.

use crate::cast::model::exact;
use crate::cast::world::Primitive;
use crate::dyadic::DyadicVector;
use crate::root::rounded;
use crate::shape::Ray;
use crate::vector::Vector;

/// t and the unit normal of a hit, each rounded from at least a hundred bits.
///
/// # Panics
/// If the ray misses the shape.
#[cold]
#[inline(never)]
pub fn exact_hit(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> (f64, Vector<f64>) {
    let root = exact(shape, ray, min_t).expect("the exact caster found this hit");
    let along = match shape {
        Primitive::Plane(plane) => DyadicVector::of(plane.normal),
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners.map(DyadicVector::of);
            (&b - &a).cross(&(&c - &a))
        }
        Primitive::Sphere(sphere) => {
            let from_center = &DyadicVector::of(ray.origin) - &DyadicVector::of(sphere.center);
            root.point(&from_center, &DyadicVector::of(ray.direction))
        }
    };
    let t = rounded(Some(root)).expect("the root is not `None`");
    (t, along.unit())
}
