//! A hit worked out without any rounding but the last: what the bounds leave uncertain.

use crate::cast::model::exact;
use crate::cast::world::Primitive;
use crate::dyadic::DyadicVector;
use crate::root::rounded;
use crate::shape::Ray;
use crate::vector::Vector;

/// t and the unit normal where a ray meets a shape, each rounded when it is known to a
/// hundred bits.
///
/// # Panics
/// If the ray misses the shape.
#[cold]
#[inline(never)]
pub fn hit(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> (f64, Vector<f64>) {
    let root = exact(shape, ray, min_t).expect("the exact caster says that it is met");
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
    let t = rounded(Some(root)).expect("there is a root");
    (t, along.unit())
}
