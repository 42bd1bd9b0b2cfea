//! A hit worked out without any rounding but the last: what the bounds leave uncertain.

use crate::cast::model::exact;
use crate::cast::world::Primitive;
use crate::dyadic::DyadicVector;
use crate::leading::Leading;
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
        Primitive::Plane(plane) => leading(&DyadicVector::of(plane.normal)),
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners.map(DyadicVector::of);
            leading(&(&b - &a).cross(&(&c - &a)))
        }
        Primitive::Sphere(sphere) => {
            let from_center = &DyadicVector::of(ray.origin) - &DyadicVector::of(sphere.center);
            root.point(&from_center, &DyadicVector::of(ray.direction))
        }
    };
    let t = rounded(Some(root)).expect("there is a root");
    (t, unit(along))
}

fn leading(vector: &DyadicVector) -> [Leading; 3] {
    vector.0.each_ref().map(Leading::from)
}

/// Brought near 1 together, so that none overflows; what vanishes beside the largest is 0.
fn unit(along: [Leading; 3]) -> Vector<f64> {
    let largest = along.iter().filter_map(|it| it.exponent()).max();
    let near_one = along.map(|it| it.times_power_of_two(-largest.unwrap_or(0)).rounded());
    let [x, y, z] = near_one;
    Vector::new(x, y, z).unit()
}
