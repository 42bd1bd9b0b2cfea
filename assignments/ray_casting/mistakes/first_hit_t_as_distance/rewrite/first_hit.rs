use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let speed = ray.direction.dot(ray.direction).sqrt();
    let distances: Vec<Option<f64>> = objects
        .iter()
        .map(|shape| Some(shape.intersect_ray(ray, min_t)?.t * speed))
        .collect();
    let t = distances.iter().flatten().copied().reduce(f64::min)?;
    let object = distances.iter().position(|distance| *distance == Some(t))?;
    let normal = objects[object].intersect_ray(ray, min_t)?.normal;
    Some(Hit {
        object,
        intersection: Intersection { t, normal },
    })
}
