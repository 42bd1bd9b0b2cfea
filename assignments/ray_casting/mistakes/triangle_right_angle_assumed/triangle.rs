use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let normal = t1.cross(t2).normalize();
        let slope = ray.direction.dot(normal);
        if slope == 0.0 {
            return None;
        }
        let t = (a - ray.origin).dot(normal) / slope;
        let from_a = ray.at(t) - a;
        let alpha = from_a.dot(t1) / t1.dot(t1);
        let beta = from_a.dot(t2) / t2.dot(t2);
        if alpha < 0.0 || beta < 0.0 || alpha + beta > 1.0 || t < min_t {
            return None;
        }
        Some(Intersection { t, normal })
    }
}
