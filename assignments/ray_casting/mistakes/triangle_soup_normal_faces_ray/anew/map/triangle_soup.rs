use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let faced = self
            .triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, min_t))
            .map(|hit| {
                let d = ray.direction;
                let normal = if hit.normal.distance_squared(d) < hit.normal.distance_squared(-d) {
                    -hit.normal
                } else {
                    hit.normal
                };
                Intersection { normal, ..hit }
            });
        faced.reduce(|a, b| if a.t <= b.t { a } else { b })
    }
}
