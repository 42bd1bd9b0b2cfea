use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let z = t1.cross(t2).normalize();
        let x = t1.normalize();
        let y = z.cross(x);
        let descent = ray.direction.dot(z);
        if descent == 0.0 {
            return None;
        }
        let start = ray.origin - a;
        let t = -start.dot(z) / descent;
        let foot = start + t * ray.direction;
        let beta = foot.dot(y) / t2.dot(y);
        let alpha = (foot.dot(x) - beta * t2.dot(x)) / t1.length();
        if alpha + beta > 1.0 || t < min_t {
            return None;
        }
        Some(Intersection { t, normal: z })
    }
}
