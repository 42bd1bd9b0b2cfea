use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let met: Vec<Intersection> = objects
        .iter()
        .flat_map(|shape| shape.intersect_ray(ray, min_t))
        .collect();
    let nearest_t = met.iter().map(|met| met.t).reduce(f64::min)?;
    let object = met.iter().position(|met| met.t == nearest_t)?;
    Some(Hit {
        object,
        intersection: met[object],
    })
}
